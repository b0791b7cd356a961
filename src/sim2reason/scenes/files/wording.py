"""The wording of a problem in a scene file, so that figures can agree with the text.

text:
  wording: 1234
  symbols: [ramp.plane.angle]
  without: [start]
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, cast, get_args

from sim2reason.base.yaml_text import Plain, parse, shown
from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.template import Topic

KEYS = ("wording", "symbols", "without")
LARGEST = 2**63 - 1

TEXT: dict[str, Any] = {
    "type": "object",
    "additionalProperties": False,
    "description": "How a problem tells the scene, so that figures name things as it does and show no more.",
    "properties": {
        "wording": {"type": "integer", "minimum": 0, "description": "The seed of its wording."},
        "symbols": {
            "type": "array",
            "items": {"type": "string"},
            "description": "Addresses of numbers for which it says symbols, as of what it asks for.",
        },
        "without": {
            "type": "array",
            "items": {"enum": list(get_args(Topic))},
            "description": "Topics on which it says nothing.",
        },
    },
}
"""The JSON schema of the key ``text``."""


@dataclass(frozen=True, slots=True)
class Wording:
    """The choices that fix the text of a scene: its seed, symbols for numbers, and omitted sentences.

    `seed` selects the wording and the names; at the addresses in `symbols` the text has symbols instead of numbers, as
    for unknowns; sentences on the topics in `without` are omitted.
    """

    seed: int = 0
    symbols: tuple[str, ...] = ()
    without: tuple[Topic, ...] = ()

    @property
    def plain(self) -> dict[str, Plain]:
        """Return the mapping under the key ``text`` of a file."""
        found: dict[str, Plain] = {"wording": self.seed}
        if self.symbols:
            found["symbols"] = list[Plain](self.symbols)
        if self.without:
            found["without"] = list[Plain](self.without)
        return found


def wording_of(text: str) -> Wording | None:
    """Return the wording in a scene file; None if it has none.

    Raises:
        SceneError: the value is invalid; the message has path, problem and remedy.
    """
    data = parse(text)
    return wording_from(data["text"]) if isinstance(data, dict) and "text" in data else None


def wording_from(data: Plain) -> Wording:
    """Return the wording from the value of the key ``text``; errors as in `wording_of`."""
    if not isinstance(data, dict):
        raise SceneError("text", f"it is {shown(data)}, not a mapping", f"give it these keys: {', '.join(KEYS)}")
    for key in data:
        if key not in KEYS:
            raise SceneError(f"text.{key}", "there is no such key here", f"keys: {', '.join(KEYS)}")
    seed, topics = data.get("wording", 0), get_args(Topic)
    if not isinstance(seed, int) or isinstance(seed, bool) or not 0 <= seed <= LARGEST:
        raise SceneError("text.wording", f"it is {shown(seed)}", "give a whole number of at least 0")
    without = _words(data.get("without", []), "text.without")
    if unknown := next((word for word in without if word not in topics), ""):
        raise SceneError("text.without", f"there is no topic {unknown!r}", f"there are: {', '.join(topics)}")
    return Wording(seed, _words(data.get("symbols", []), "text.symbols"), cast("tuple[Topic, ...]", without))


def _words(data: Plain, place: str) -> tuple[str, ...]:
    if not isinstance(data, Sequence) or isinstance(data, str) or not all(isinstance(word, str) for word in data):
        raise SceneError(place, f"it is {shown(data)}, not a list of words", "give a list, perhaps an empty one")
    return tuple(cast("Sequence[str]", data))
