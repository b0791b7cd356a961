"""Symbols for the forces that the equations of a phase determine; a force keeps its symbol in all phases."""

from sim2reason.simulation.engines.exact.motion import Segment
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.phases.equations import LETTERS
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.writing.steps import Book


class ForceSymbols:
    """The symbols given so far, by what exerts the force, with their descriptions."""

    def __init__(self, setting: Setting, book: Book) -> None:
        """Start without any."""
        self._setting, self._book = setting, book
        self._symbols: dict[str, Symbol] = {}
        self._untold: list[str] = []

    def of(self, segment: Segment) -> dict[str, Symbol]:
        """Return the symbols of the forces in a segment, by ``row``, ``normal`` or ``friction`` and their number."""
        found: dict[str, Symbol] = {}
        kinds, acting = segment.kinds, segment.found.mode.acting
        several = sum(kind.kind not in LETTERS for kind in kinds) > 1
        for n, kind in enumerate(kinds):
            if acting[n]:
                mark = str(n + 1) if kind.kind not in LETTERS and several else ""
                found[f"row{n}"] = self._symbol(kind.kind, kind.name, LETTERS.get(kind.kind, "T"), mark)
        faces = self._setting.mechanism.faces
        rough = [n for n, face in enumerate(faces) if face.friction > 0.0]
        for face, side in zip(rough, segment.found.mode.rubbing, strict=True):
            letter, of = ("N", "normal") if side else ("f", "friction")
            subject = faces[face].subject
            found[f"{of}{face}"] = self._symbol(of, subject, letter, self._setting.mark(subject))
        return found

    def introductions(self) -> list[str]:
        """Return descriptions of the symbols that no sentence has introduced yet."""
        found, self._untold = self._untold, []
        return found

    def _symbol(self, kind: str, name: str, letter: str, mark: str) -> Symbol:
        key = f"{kind} {name}"
        if key not in self._symbols:
            symbol = self._symbols[key] = self._book.fresh(letter, mark)
            self._untold.append(f"${symbol.name}$ {self._described(kind, name)}")
        return self._symbols[key]

    def _described(self, kind: str, name: str) -> str:
        setting = self._setting
        if kind in ("normal", "friction"):
            force = "the normal force on" if kind == "normal" else "the static friction on"
            return f"{force} {setting.called(name)}"
        if kind == "foot":
            return "the force with which the plane presses on the edge"
        if kind == "hold":
            return "the static friction at the edge"
        if kind == "stuck":
            return f"the force between {' and '.join(setting.called(part) for part in name.split(' and '))}"
        return (
            f"the force in {setting.lines.get(name, 'the rod')}"
            if kind != "string"
            else f"the tension in {setting.lines[name]}"
        )
