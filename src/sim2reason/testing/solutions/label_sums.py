"""Verification of sums of labelled equations, as in *(1) + 2·(4)*, from the text alone.

If all equations hold, so does any sum of them. Therefore unknowns are displaced in all directions that preserve the
equations in no sum: inextensible strings, light pulleys, normal forces.
"""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from sim2reason.scenes.dsl.state import Array

TERM = r"(?:(?:\$[^$]*\$|[^\s$()·]+)·)?\(\w+\)"
WITH = r"(?:, with [^:$]*)?"  # names the equations that were substituted
SUM = re.compile(rf"(?<!\S)(?P<sum>[-−]?{TERM}(?: [+−-] {TERM})+){WITH}: (?:\(\w+\) )?\$(?P<out>[^$]*=[^$]*)\$")
PART = re.compile(r"(?P<sign>[+−-]?) ?(?:(?P<weight>\$[^$]*\$|[^\s$()·]+)·)?\((?P<label>\w+)\)")
LABEL = re.compile(r"(?<!\S)\((?P<label>\w+)\) (?:[^$().]*: )?\$(?P<formula>[^$]*=[^$]*)\$")
LIGHT = "is light"  # marks a balance of forces without acceleration
STEP, LOOSE = 1e-6, 3e-4  # relative: step of a derivative; error of a coefficient from five digits

Excess = Callable[[Mapping[str, float]], float | None]


@dataclass(frozen=True, slots=True)
class LabelSum:
    """A stated sum of labelled equations, as *(1) + 2·(4)*, with its result; equations as left minus right side."""

    text: str
    out: Excess
    parts: tuple[tuple[Excess, Excess], ...]  # weights, which may hold symbols, and equations
    held: tuple[Excess, ...]  # what goes on holding
    moved: tuple[str, ...]

    def holds(self, values: Mapping[str, float]) -> bool:
        """Return whether the sum of the equations and its stated result depend equally on all unknowns."""
        names = [name for name in self.moved if name in values]
        rows = [row for excess in self.held if (row := _gradient(excess, values, names)) is not None and row.any()]
        free = _free(rows, len(names))
        out = _gradient(self.out, values, names)
        terms = [_gradient(excess, values, names) for _, excess in self.parts]
        if out is None or any(term is None for term in terms):
            return True
        weights = [weight(values) for weight, _ in self.parts]
        if any(weight is None for weight in weights):
            return False
        pairs = zip(weights, terms, strict=True)
        known = [weight * term for weight, term in pairs if weight is not None and term is not None]
        off = (np.sum(known, axis=0) - out) @ free
        size = max(float(np.abs(row).max(initial=0.0)) for row in (*known, out))
        return bool(np.abs(off).max(initial=0.0) <= LOOSE * size)


def label_sums(
    text: str, read: Callable[[str], Excess | None], givens: Sequence[str], names: Sequence[str]
) -> list[LabelSum]:
    """Return all sums of equations in a text; `read` parses an equation as a function of its symbols."""
    labelled = {match["label"]: match["formula"] for match in LABEL.finditer(text)}
    sums = list(SUM.finditer(text))
    apart = [match["formula"] for match in LABEL.finditer(text) if LIGHT in match[0]]
    outs = {match["out"] for match in sums}
    rows = {*labelled.values(), *outs}
    moved = tuple(name for name in names if name not in givens)
    found: list[LabelSum] = []
    for match in sums:
        plain = re.findall(r"\$([^$]*=[^$]*)\$", text[: match.start()])  # what follows is free to move with it
        told = [f.rpartition("=")[0] if f.count("=") == 2 and _number(f) else f for f in plain]  # a law and its result
        laws = [f for f in told if f not in rows and f.count("=") == 1 and not _number(f)]
        held = tuple(excess for formula in dict.fromkeys((*apart, *laws)) if (excess := read(formula)) is not None)
        out = read(match["out"])
        parts = [_part(part, labelled, read) for part in PART.finditer(match["sum"])]
        if out is not None and all(part is not None for part in parts):
            kept = tuple(part for part in parts if part is not None)
            found.append(LabelSum(match[0], out, kept, held, moved))
    return found


def _number(formula: str) -> bool:
    """Return whether a formula assigns a number to a symbol: a result, not a law."""
    last = formula.rpartition("=")[2].strip()
    return re.fullmatch(r"-?[\d.]+(?: \\times 10\^\{-?\d+\})?(?:\\ \\text.*|\^\\circ)?", last) is not None


def _part(
    part: re.Match[str], labelled: Mapping[str, str], read: Callable[[str], Excess | None]
) -> tuple[Excess, Excess] | None:
    sign = 1.0 if part["sign"] in ("", "+") else -1.0
    formula = labelled.get(part["label"])
    excess = read(formula) if formula is not None else None
    weight = read(f"{part['weight'].strip('$')} = 0") if part["weight"] else None
    if excess is None or (part["weight"] and weight is None):
        return None

    def signed(values: Mapping[str, float]) -> float | None:
        size = weight(values) if weight is not None else 1.0
        return None if size is None else sign * size

    return signed, excess


def _gradient(excess: Excess, values: Mapping[str, float], names: Sequence[str]) -> Array | None:
    here, found = excess(values), list[float]()
    for name in names:
        step = STEP * max(1.0, abs(values[name]))
        there = excess({**values, name: values[name] + step})
        if here is None or there is None:
            return None
        found.append((there - here) / step)
    return np.array(found)


def _free(rows: Sequence[Array], size: int) -> Array:
    """Return the directions in the space of the unknowns, as columns, along which all rows of gradients are zero."""
    if not rows:
        return np.eye(size)
    _, spread, ways = np.linalg.svd(np.array([row / np.abs(row).max() for row in rows]))
    rank = int((spread > LOOSE * spread.max(initial=0.0)).sum())
    return ways[rank:].T
