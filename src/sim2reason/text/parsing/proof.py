"""Verification of a parse: its scene, rendered with the wordings of the parse, must reproduce the text.

Trailing zeros of decimals and SI prefixes are ignored: *1.20 km* equals *1.2 km* and *1200 m*.
"""

import re
from collections.abc import Collection, Mapping
from decimal import Decimal

import numpy as np

from sim2reason.errors import TextError
from sim2reason.scenes.dsl.entity import Part
from sim2reason.scenes.dsl.model import Parameter
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.template import Each, PartLines, Saying, Topic, topic_of
from sim2reason.scenes.dsl.units import UnitError, coherent
from sim2reason.text.parsing.matcher import NONE_GIVEN
from sim2reason.text.parsing.parse_state import ParseState
from sim2reason.text.parsing.tokens import pieces, shown
from sim2reason.text.prose.closings import Closing, closings
from sim2reason.text.prose.description import Description
from sim2reason.text.prose.phrases import letters, sentence_templates
from sim2reason.text.prose.voices import Voice, hiding, numeric, symbolic
from sim2reason.text.prose.writer import Writer

_ZEROS = re.compile(r"(?<=\d)\.0+(?![\d])|(?<=\.)(\d*[1-9])0+(?!\d)")
_MEASURED = re.compile(r"(\d+(?:\.\d+)?) ([A-Za-zµΩ²³·]+(?:/[A-Za-zµΩ²³·]+)?)")


class MissingClosingError(TextError):
    """An error for a text that omits a closing sentence that its scene needs."""

    def __init__(self, name: str) -> None:
        """Store the name of the missing closing sentence, such as *rest* for a start from rest."""
        self.name = name
        super().__init__("text", f"nothing is said of {name!r}, which matters here", "say it at the end")

    def __reduce__(self) -> tuple[type[TextError], tuple[str, str, str]]:
        """Pickle the error without the name of the closing sentence, which only the parser uses."""
        return TextError, (self.place, self.problem, self.remedy)


class ScriptedWriter(Writer):
    """A writer that repeats the wordings of a parsed text, and then takes the first wording of each sentence."""

    def __init__(
        self,
        scene: Scene,
        state: ParseState,
        given: Mapping[str, str] = NONE_GIVEN,
        order: tuple[str, ...] = (),
        without: Collection[Topic] = (),
    ) -> None:
        """Store the wordings of all sentences in the parsed text, by their indices.

        Symbols in `given` are written as symbols. Sentences on an initial state that the text omits are skipped.
        """
        super().__init__(scene, state.names, np.random.default_rng(0), _voice(given, state.unknowns), order, without)
        self._script, self._state = iter(state.script), state

    def choose(self, options: tuple[str, ...]) -> str:
        """Return the wording that the parsed text uses for the next sentence."""
        return options[min(next(self._script, 0), len(options) - 1)]

    def pass_over(self, options: tuple[str, ...]) -> None:
        """Do nothing: an omitted sentence has no wording in the parsed text."""

    def leaves_out(self, closing: Closing) -> bool:
        """Return whether to omit a closing sentence; one on the start, only if the text omits the initial motion."""
        if closing.role == "start":
            return closing.name not in self._state.closings and _of_untold_start(closing, self._state)
        return super().leaves_out(closing)

    def _say(self, saying: Saying, part: Part, address: str) -> list[str]:
        if isinstance(saying, PartLines):
            return super()._say(saying, part, address)
        if isinstance(saying, Each):
            said = bool(getattr(part, saying.field))
        else:
            told = topic_of(saying) not in self._without
            said = told and self.says_line(saying, sentence_templates(saying, part)[0], part)
        return super()._say(saying, part, address) if said else []


def _voice(given: Mapping[str, str], unknown: Collection[str]) -> Voice:
    """Return a voice with numbers, except for symbols that are defined elsewhere or unknown."""

    def said(parameter: Parameter, symbol: str) -> str:
        return (symbolic if symbol in given or parameter.path in unknown else numeric)(parameter, symbol)

    return said if given else hiding(*unknown)


def missing_closings(scene: Scene, state: ParseState) -> list[str]:
    """Return the names of the closing sentences that the text omits although every answer depends on them."""
    lacking = [closing for closing in closings(scene) if closing.name not in state.closings]
    return [closing.name for closing in lacking if not closing.topic and not _of_untold_start(closing, state)]


def _plain(sentence: str) -> str:
    """Return a sentence without trailing zeros of decimals and without SI prefixes of units."""
    return _ZEROS.sub(r"\1", _MEASURED.sub(_without_prefix, sentence))


def _without_prefix(measured: re.Match[str]) -> str:
    try:
        unit, size = coherent(measured[2])
    except UnitError:
        return measured[0]
    return f"{(Decimal(measured[1]) * size):f} {unit}"


def _of_untold_start(closing: Closing, state: ParseState) -> bool:
    """Return whether a closing sentence states the start from rest, in a text that omits the initial motion."""
    return closing.role == "start" and "start" in state.without


def prove(scene: Scene, state: ParseState, text: tuple[str, ...], given: Mapping[str, str] = NONE_GIVEN) -> None:
    """Raise TextError, with the expected sentence, unless the scene renders as this text."""
    needed: dict[str, Topic | None] = {closing.name: closing.topic for closing in closings(scene)}
    if lacking := missing_closings(scene, state):
        raise MissingClosingError(lacking[0])
    for name in state.closings:
        if name not in needed:
            raise TextError("text", f"it speaks of {name!r}, which does not matter here", "leave it out")
    left_out: set[Topic] = {topic for name, topic in needed.items() if topic and name not in state.closings}
    without = state.without | left_out
    order: tuple[str, ...] = ()
    if given:
        first = ScriptedWriter(scene, state, without=without)
        first.sentences()
        order = tuple(first.told)
    echo = ScriptedWriter(scene, state, given, order, without)
    told = Description(scene, tuple(echo.sentences()), state.names, {})
    if spare := given.keys() - {echo.symbols.get(path) for path in echo.told}:
        raise TextError("text", f"it gives ${min(spare)}$, of which it does not speak", "leave it out")
    again = pieces(told.text)
    for number, (mine, theirs) in enumerate(zip(again, text, strict=False), start=1):
        if mine != theirs and _plain(mine) != _plain(theirs):
            raise TextError(f"sentence {number}", f"{shown(theirs)} does not fit", f"say {shown(mine)}")
    if len(again) != len(text):
        count = f"it has {len(text)} sentences where the scene needs {len(again)}"
        raise TextError("text", count, "say each fact once")
    if letters(echo.introduced, scene.bodies) != dict(state.names.letters):
        raise TextError("text", "its letters are not in the order of first mention", "begin each series with its first")
