"""How numbers are spoken: as numbers, as symbols, or some of each."""

from collections.abc import Callable
from dataclasses import dataclass

from sim2reason.dsl.model import Parameter

Voice = Callable[[Parameter, str], str]
"""How a number is spoken: from the parameter and its symbol."""


def numeric(parameter: Parameter, symbol: str) -> str:
    """The number and its unit."""
    del symbol
    return parameter.measure.say(parameter.value or 0.0)


def symbolic(parameter: Parameter, symbol: str) -> str:
    """The symbol alone."""
    del parameter
    return f"${symbol}$"


def symbolic_but_zero(parameter: Parameter, symbol: str) -> str:
    """The symbol alone, but for what is zero: the text says that, since it is no number that could be another."""
    return (symbolic if parameter.value else numeric)(parameter, symbol)


@dataclass(frozen=True, slots=True)
class Hiding:
    """Numbers, but for the parameters at some addresses, which are spoken of as unknowns."""

    paths: tuple[str, ...]

    def __call__(self, parameter: Parameter, symbol: str) -> str:
        """The symbol of what is hidden, else the number."""
        return (symbolic if parameter.path in self.paths else numeric)(parameter, symbol)


def hiding(*paths: str) -> Voice:
    """Numbers, but for the parameters at some addresses, which are spoken of as unknowns."""
    return Hiding(paths)


def voice_named(voice: str, hide: tuple[str, ...] = ()) -> Voice:
    """The voice of a name: numeric or symbolic, with addresses to hide in the numeric one."""
    if voice == "symbolic":
        return symbolic
    return hiding(*hide) if hide else numeric
