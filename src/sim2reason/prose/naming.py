"""What bodies are called in a text, and which symbol stands for which number."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from sim2reason.dsl.body import Body
from sim2reason.dsl.model import Parameter
from sim2reason.prose.phrases import join


@dataclass(frozen=True)
class Names:
    """The letter of each body (empty for a lone one) and the noun that each class goes by in this text."""

    letters: Mapping[str, str] = field(default_factory=dict[str, str])
    nouns: Mapping[type[Body], str] = field(default_factory=dict[type[Body], str])

    def noun(self, body: Body) -> str:
        """The everyday word for a body in this text."""
        return self.nouns.get(type(body), body.nouns[0])

    def mention(self, address: str, body: Body, *, full: bool = True) -> str:
        """How a body that was introduced is spoken of: *the block*, *block A*, or *A* where `full` is off."""
        return called(self.noun(body), self.letters.get(address, ""), full=full)


def called(noun: str, letter: str, *, full: bool) -> str:
    """A body by its noun and its letter, if it has one; a digit alone would pass for a number."""
    if not letter:
        return f"the {noun}"
    return f"{noun} {letter}" if full or letter[0].isdigit() else letter


def listed(noun: str, letters: list[str], *, full: bool) -> str:
    """Several bodies of one noun by their letters: *blocks A and B*, or *A and B* where `full` is off."""
    plural = f"{noun}s " if full or letters[0][:1].isdigit() else ""
    return plural + join(letters)


def letters(order: Iterable[str], bodies: Mapping[str, Body]) -> dict[str, str]:
    """Letters by address, in the order of first mention; a lone body of its series has none.

    Classes with the same series share it, as if there had never been groups.
    """
    series: dict[str, list[str]] = {}
    for address in order:
        if bodies[address].letters:
            series.setdefault(bodies[address].letters, []).append(address)
    found: dict[str, str] = {}
    for alphabet, members in series.items():
        if len(members) > 1:
            found.update({address: letter_at(alphabet, index) for index, address in enumerate(members)})
    return found


def letter_at(alphabet: str, index: int) -> str:
    """The letter at a place of a series; after its end the series begins again with a digit."""
    turn, place = divmod(index, len(alphabet))
    return alphabet[place] + (str(turn + 1) if turn else "")


def symbols(parameters: Iterable[Parameter], bodies: Mapping[str, Body], names: Names) -> dict[str, str]:
    """A LaTeX symbol for every parameter: m_A where the body has a letter, else m, else m with the noun."""
    wanted: dict[str, list[str]] = {}
    for parameter in parameters:
        owner, _, name = parameter.path.rpartition(".")
        body = bodies.get(owner)
        base = (body.symbols.get(name) if body else None) or parameter.measure.symbol
        letter = names.letters.get(owner, "")
        wanted.setdefault(_subscript(base, letter), []).append(parameter.path)
    found: dict[str, str] = {}
    for symbol, paths in wanted.items():
        for number, path in enumerate(paths, start=1):
            found[path] = symbol if len(paths) == 1 else _subscript(symbol, str(number))
    return found


def _subscript(base: str, mark: str) -> str:
    if not mark:
        return base
    stem, _, inner = base.partition("_")
    inner = inner.strip("{}")
    joined = inner + ("," if inner else "") + mark
    return f"{stem}_{joined}" if len(joined) == 1 else f"{stem}_{{{joined}}}"
