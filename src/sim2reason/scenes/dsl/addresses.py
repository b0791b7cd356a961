"""What stands at an address of a value, as in ``stones.1.mass``, and the same value with something else there."""

from collections.abc import Mapping
from typing import Any, TypeVar

from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.model import Model

NOTHING, LOOK = "there is no such thing in the scene", "list the scene's parameters"
V = TypeVar("V")


def lookup(value: Any, path: str) -> Any:
    """Return what stands at an address below a value; SceneError names the first step that leads nowhere."""
    walked: list[str] = []
    for step in path.split("."):
        walked.append(step)
        try:
            value = _members(value)[step]
        except KeyError:
            raise SceneError(".".join(walked), NOTHING, LOOK) from None
    return value


def _members(value: Any) -> dict[str, Any]:
    """Return all that a value holds, by the next step of an address."""
    if isinstance(value, tuple):
        return {str(index): member for index, member in enumerate(value)}  # type: ignore[reportUnknownArgumentType]
    return {name: getattr(value, name) for name in type(value).model_fields} if isinstance(value, Model) else {}


def changed(value: V, news: Mapping[str, object]) -> V:
    """Return the same value with others at some addresses, validated once; None in a tuple takes a member out."""
    here, below = dict[str, object](), dict[str, dict[str, object]]()
    for path, new in news.items():
        step, _, rest = path.partition(".")
        if rest:
            below.setdefault(step, {})[rest] = new
        else:
            here[step] = new
    held = _members(value)
    if unknown := {*here, *below} - held.keys():
        raise SceneError(min(unknown), NOTHING, LOOK)
    held |= {step: changed(held[step], some) for step, some in below.items()} | here
    if isinstance(value, tuple):
        return tuple(member for member in held.values() if member is not None)  # type: ignore[return-value]
    return type(value)(**held)  # type: ignore[return-value]
