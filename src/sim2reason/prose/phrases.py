"""Small turns of phrase, and what the paths of templates lead to."""

from collections.abc import Iterable
from typing import Any, cast

from sim2reason.dsl.addresses import lookup
from sim2reason.dsl.body import Body
from sim2reason.dsl.model import Model
from sim2reason.dsl.template import Saying, Wordings, wordings

_ENDS = {"first": 0, "last": -1}


BODIES = "bodies"
"""The plural of several that are not all of one kind."""


def alike(members: tuple[object, ...]) -> bool:
    """Whether all are of one kind."""
    return len({type(member) for member in members}) == 1


def paragraphs(sentences: Iterable[str]) -> str:
    """Sentences as one paragraph; a table stands on lines of its own."""
    return " ".join(sentences).replace(" \n\n", "\n\n").replace("\n\n ", "\n\n").strip()


def join(items: list[str], last: str = " and ") -> str:
    """A, B and C."""
    return items[0] if len(items) == 1 else ", ".join(items[:-1]) + last + items[-1]


def another(text: str) -> str:
    """An introduction of a second of its kind."""
    for article in ("a ", "an "):
        if text.startswith(article):
            return "another " + text[len(article) :]
    return text


def introductions(kind: type[Body], *, again: bool) -> tuple[str, ...]:
    """The templates that introduce a body without a letter, for the first time or `again`."""
    return (kind.again or tuple(map(another, kind.lone))) if again else kind.lone


def canonical(part: Model, path: str) -> str:
    """`first` and `last` as indices; before a word of a member only `first`."""
    steps = path.replace(".first.", ".0.").split(".")
    if steps[-1] in ("first", "last"):
        members = lookup(part, ".".join(steps[:-1]))
        steps[-1] = "0" if steps[-1] == "first" else str(len(members) - 1)
    return ".".join(steps)


def spoken(saying: Saying, part: Any) -> tuple[str, ...]:
    """Return the templates for a sentence about a part, which may depend on the presence of an optional number."""
    given = isinstance(saying, Wordings) and saying.given
    return wordings(saying, given=bool(given) and resolved(part, str(given)) is not None)


def resolved(part: Any, path: str) -> Any:
    """What a slot speaks of; a word of a body stands for the body itself."""
    held: Any = part
    for step in path.split("."):
        if held is None:
            return None
        if isinstance(held, tuple):
            held = cast("tuple[Any, ...]", held)[_ENDS[step] if step in _ENDS else int(step)]
        elif isinstance(held, Body) and step in held.words:
            return held
        else:
            held = getattr(held, step)
    return held
