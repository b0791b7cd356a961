"""The proof of a reading: its scene, told again with the wordings that were read, has this very text.

Only zeros at the end of a decimal fraction are no matter, nor are prefixes: *1.20 km* is *1.2 km* and *1200 m*.
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
from sim2reason.text.prose.phrases import letters, spoken
from sim2reason.text.prose.voices import Voice, hiding, numeric, symbolic
from sim2reason.text.prose.writer import Writer

_ZEROS = re.compile(r"(?<=\d)\.0+(?![\d])|(?<=\.)(\d*[1-9])0+(?!\d)")
_MEASURED = re.compile(r"(\d+(?:\.\d+)?) ([A-Za-zµΩ²³·]+(?:/[A-Za-zµΩ²³·]+)?)")


class UnsaidError(TextError):
    """A text that says nothing of something that matters in its scene."""

    def __init__(self, name: str) -> None:
        """Store the name of the closing that would say it."""
        self.name = name
        super().__init__("text", f"nothing is said of {name!r}, which matters here", "say it at the end")

    def __reduce__(self) -> tuple[type[TextError], tuple[str, str, str]]:
        """Pickle it as the error without the name, which only the parser looks at."""
        return TextError, (self.place, self.problem, self.remedy)


class ScriptedWriter(Writer):
    """A writer whose choices are prescribed; where they run out it takes the first wording."""

    def __init__(
        self,
        scene: Scene,
        state: ParseState,
        given: Mapping[str, str] = NONE_GIVEN,
        order: tuple[str, ...] = (),
        without: Collection[Topic] = (),
    ) -> None:
        """The script of a reading holds the choices for what is said; lines that stay unsaid take none.

        Symbols in `given` stand. What the text does not say of a start that it leaves out is passed over.
        """
        super().__init__(scene, state.names, np.random.default_rng(0), _voice(given, state.unknowns), order, without)
        self._script, self._state = iter(state.script), state

    def choose(self, options: tuple[str, ...]) -> str:
        """Return the wording that the script demands."""
        return options[min(next(self._script, 0), len(options) - 1)]

    def pass_over(self, options: tuple[str, ...]) -> None:
        """What is left out has no place in the script."""

    def leaves_out(self, closing: Closing) -> bool:
        """That on a start only where the text does: it may say of one that it does not tell that it is from rest."""
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
            said = told and self.says_line(saying, spoken(saying, part)[0], part)
        return super()._say(saying, part, address) if said else []


def _voice(given: Mapping[str, str], unknown: Collection[str]) -> Voice:
    """Numbers, but for those whose symbol has its number elsewhere, and for what is unknown."""

    def said(parameter: Parameter, symbol: str) -> str:
        return (symbolic if symbol in given or parameter.path in unknown else numeric)(parameter, symbol)

    return said if given else hiding(*unknown)


def unsaid(scene: Scene, state: ParseState) -> list[str]:
    """Return what matters in the scene, whatever is asked, and of which a reading says nothing."""
    lacking = [closing for closing in closings(scene) if closing.name not in state.closings]
    return [closing.name for closing in lacking if not closing.topic and not _of_untold_start(closing, state)]


def _plain(sentence: str) -> str:
    """Without zeros at the ends of numbers, and without prefixes of units."""
    return _ZEROS.sub(r"\1", _MEASURED.sub(_without_prefix, sentence))


def _without_prefix(measured: re.Match[str]) -> str:
    try:
        unit, size = coherent(measured[2])
    except UnitError:
        return measured[0]
    return f"{(Decimal(measured[1]) * size):f} {unit}"


def _of_untold_start(closing: Closing, state: ParseState) -> bool:
    """Return whether it is on a start that the text leaves out."""
    return closing.role == "start" and "start" in state.without


def prove(scene: Scene, state: ParseState, text: tuple[str, ...], given: Mapping[str, str] = NONE_GIVEN) -> None:
    """Return if the scene has this text; TextError names what should have been said or said otherwise."""
    needed: dict[str, Topic | None] = {closing.name: closing.topic for closing in closings(scene)}
    if lacking := unsaid(scene, state):
        raise UnsaidError(lacking[0])
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
