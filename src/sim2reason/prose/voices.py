"""How numbers are spoken: as numbers, as symbols, or some of each."""

from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass
from typing import Literal

from sim2reason.dsl.model import Parameter
from sim2reason.errors import SceneError, UnknownNameError

Voice = Callable[[Parameter, str], str]
"""How a number is spoken: from the parameter and its symbol."""
VoiceName = Literal["numeric", "symbolic"]


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


VOICES: Mapping[str, Voice] = {"numeric": numeric, "symbolic": symbolic}


def hiding(*paths: str) -> Voice:
    """Numbers, but for the parameters at some addresses, which are spoken of as unknowns."""
    return Hiding(paths)


def voice_of(given: Iterable[Parameter], voice: Voice | VoiceName, hide: Collection[str] = ()) -> Voice:
    """A voice that may be given by its name, with addresses to hide; SceneError if at one of them no number is told."""
    if hide:
        known = [parameter.path for parameter in given if not parameter.hidden and parameter.value is not None]
        for address in hide:
            if address not in known:
                raise SceneError(f"--hide {address}", "no such number is told", f"there are: {', '.join(known)}")
    if callable(voice):
        return hiding(*hide) if hide else voice
    if voice not in VOICES:
        raise UnknownNameError(f"no such voice: {voice!r}; there are: {', '.join(VOICES)}")
    return hiding(*hide) if hide and voice == "numeric" else VOICES[voice]
