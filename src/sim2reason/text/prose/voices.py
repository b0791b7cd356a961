"""Voices of a text: how numbers are written, as digits or symbols, and how bodies are named."""

from abc import ABC, abstractmethod
from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass
from typing import Any, Literal

from sim2reason.base.records import cached_property
from sim2reason.errors import SceneError, UnknownNameError
from sim2reason.scenes.dsl.model import Parameter, parameters
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.template import Word, slots
from sim2reason.text.prose.phrases import Names, introductions, join, join_body_names, symbols

Voice = Callable[[Parameter, str], str]
"""How a number is spoken: from the parameter and its symbol."""
VoiceName = Literal["numeric", "symbolic"]


def numeric(parameter: Parameter, symbol: str) -> str:
    """Return the number with its unit."""
    del symbol
    return parameter.measure.say(parameter.value or 0.0)


def symbolic(parameter: Parameter, symbol: str) -> str:
    """Return only the symbol."""
    del parameter
    return f"${symbol}$"


def symbolic_but_zero(parameter: Parameter, symbol: str) -> str:
    """Return only the symbol, except for zero, which the text states as a number."""
    return (symbolic if parameter.value else numeric)(parameter, symbol)


@dataclass(frozen=True, slots=True)
class SymbolicAt:
    """A voice that writes numbers, except symbols for the parameters at the given addresses."""

    paths: tuple[str, ...]

    def __call__(self, parameter: Parameter, symbol: str) -> str:
        """Return the symbol of a hidden parameter, else the number."""
        return (symbolic if parameter.path in self.paths else numeric)(parameter, symbol)


VOICES: Mapping[str, Voice] = {"numeric": numeric, "symbolic": symbolic}


def symbolic_at(*paths: str) -> Voice:
    """Return a voice that writes numbers, except symbols for the parameters at the given addresses."""
    return SymbolicAt(paths)


def voice_of(given: Iterable[Parameter], voice: Voice | VoiceName, hide: Collection[str] = ()) -> Voice:
    """Return a voice from its name, with hidden addresses; SceneError if no number is stated at one of them."""
    if hide:
        known = [parameter.path for parameter in given if not parameter.hidden and parameter.value is not None]
        for address in hide:
            if address not in known:
                raise SceneError(f"--hide {address}", "no such number is told", f"there are: {', '.join(known)}")
    if callable(voice):
        return symbolic_at(*hide) if hide else voice
    if voice not in VOICES:
        raise UnknownNameError(f"no such voice: {voice!r}; there are: {', '.join(VOICES)}")
    return symbolic_at(*hide) if hide and voice == "numeric" else VOICES[voice]


class Terms(ABC):
    """Writer of names and numbers: it introduces each body at first mention, and writes numbers in one voice."""

    def __init__(self, scene: Scene, names: Names, voice: Voice, order: tuple[str, ...] = ()) -> None:
        """Prepare a text without introduced bodies; equal symbols get indices in the order of addresses in `order`."""
        self.scene, self.names, self._voice, self._order = scene, names, voice, order
        self.introduced: dict[str, None] = {}
        self.told: dict[str, None] = {}  # the addresses of numbers

    @abstractmethod
    def choose(self, options: tuple[str, ...]) -> str:
        """Return one of several wordings."""

    @cached_property
    def parameters(self) -> dict[str, Parameter]:
        """Return all declared numbers by address, including those of bodies on strings."""
        parameters_by_path = {parameter.path: parameter for parameter in self.scene.parameters}
        for address, body in self.scene.bodies.items():
            parameters_by_path.update({parameter.path: parameter for parameter in parameters(body, address)})
        return parameters_by_path

    @cached_property
    def symbols(self) -> dict[str, str]:
        """Return the symbols by address of all numbers that the text states, or only those of the hidden numbers."""
        first = [self.parameters[path] for path in self._order]
        every = {p.path: p for p in (*first, *self.parameters.values())}.values()
        stated = [p for p in every if not p.hidden and p.value is not None and not self._by_word(p.path)]
        if isinstance(self._voice, SymbolicAt):
            stated = [p for p in stated if p.path in self._voice.paths]
        if self._voice is not symbolic:  # else zeros are told by their symbols
            stated = _zeros_last(stated)
        return symbols(stated, self.scene.bodies, self.names)

    def word(self, word: Word, value: Any, render: Callable[[str], str]) -> str:
        """Return the word that a text uses for a value, such as *smooth* for zero friction."""
        return render(word.text(value))

    def at(self, address: str, *, start: bool = False) -> str:
        """Return the text of the value at an address: a number, a word, a body or a list of bodies."""
        if address in self.parameters:
            return self.number(address)
        owner, _, name = address.rpartition(".")
        if owner in self.scene.bodies and name in self.scene.bodies[owner].words:
            body = self.scene.bodies[owner]
            word = body.words[name]
            return self.word(word, getattr(body, word.parameter), lambda inner: self._write_body_slot(inner, owner))
        if address in self.scene.bodies:
            return self.introduce(address, start=start)
        members = [body_address for body_address in self.scene.bodies if body_address.rpartition(".")[0] == address]
        return self._list(members, start=start)

    def number(self, address: str) -> str:
        """Return a number as this text writes it: numerals with a unit, or a symbol."""
        parameter = self.parameters[address]
        self.told[address] = None
        return self._voice(parameter, self.symbols.get(address, parameter.measure.symbol))

    def _by_word(self, path: str) -> bool:
        owner, _, name = path.rpartition(".")
        body = self.scene.bodies.get(owner)
        return body is not None and body.is_stated_by_word(name)

    def introduce(self, address: str, *, start: bool) -> str:
        """Return the name of a body; at its first mention, its introduction with its numbers."""
        body = self.scene.bodies[address]
        if address in self.introduced:
            return self.names.mention(address, body, full=start)
        again = any(self.names.noun(self.scene.bodies[known]) == self.names.noun(body) for known in self.introduced)
        self.introduced[address] = None
        letter = self.names.letters.get(address, "")
        return self._write_body_slot(
            self.choose(body.named if letter else introductions(type(body), again=again)), address
        )

    def _write_body_slot(self, template: str, address: str) -> str:
        body = self.scene.bodies[address]
        text = ""
        for slot in slots(template):
            if slot.kind == "text":
                text += slot.text
            elif slot.path == "letter":
                text += self.names.letters.get(address, "")
            elif slot.path == "noun":
                text += self.names.noun(body)
            else:
                choice = getattr(body, slot.path, None)
                text += choice if isinstance(choice, str) else self.at(f"{address}.{slot.path}")
        return text

    def _list(self, members: list[str], *, start: bool) -> str:
        if len(members) == 1:
            return self.introduce(members[0], start=start)
        noun = self.names.noun(first := self.scene.bodies[members[0]])
        letters = [self.names.letters.get(address, "") for address in members]
        if members[0] in self.introduced:
            return join_body_names(noun, letters, full=start)
        self.introduced.update(dict.fromkeys(members))
        alike = {self._write_body_slot(first.alike, address) for address in members}
        if first.alike and len(alike) == 1:
            return f"{join_body_names(noun, letters, full=True)} {alike.pop()}"
        return f"{noun}s " + join([self._write_body_slot(first.listed, address) for address in members])


def _zeros_last(said: list[Parameter]) -> list[Parameter]:
    """Return the parameters with zero positions last, so that nonzero ones get the lowest indices.

    Zeros are stated as zeros and need no index. The coordinates of one position share an index, so a position with a
    single zero keeps its place in the order.
    """
    kinds = {(p.path.rpartition(".")[0], p.measure.name) for p in said if p.value}
    return sorted(said, key=lambda p: (p.path.rpartition(".")[0], p.measure.name) not in kinds)
