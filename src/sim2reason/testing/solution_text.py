"""Reading of worked solutions from their text alone, with the parser that grades answers, and faults in it."""

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import reduce
from itertools import pairwise

from sim2reason.grading import arithmetic
from sim2reason.grading.arithmetic import Node
from sim2reason.grading.parser import parse
from sim2reason.grading.score import Outcome, Refused
from sim2reason.grading.tokens import Token, canonical, tokenize
from sim2reason.scenes.dsl.units import parse_unit
from sim2reason.solutions.writing.notation import DEGREES, unit_of
from sim2reason.testing.solution_verification import LabelSum, label_sums

FORMULA = re.compile(r"\$((?:(?!\\boxed)[^$])*=(?:(?!\\boxed)[^$])*)\$")
MAX_BRACE_DEPTH = 12  # nested braces
BRACED = reduce(lambda inside, _: rf"(?:[^{{}}$]|\{{{inside}\}})*", range(MAX_BRACE_DEPTH), "[^{}$]*")
ANSWER = re.compile(
    r"\$(?P<goal>[^$=]*?)(?: = (?P<number>[^$=]*?))? (?P<sign>\\approx|=) "
    rf"\\boxed\{{(?P<boxed>{BRACED})\}}(?P<unit>[^$]*)\$"
)
BOX = r"\boxed{"
BOXED_RTOL = 6e-3  # relative rounding error of three digits
ROUNDED_RTOL = 6e-5  # relative rounding error of five digits, at most
DERIVATIVE_RSTEP = 1e-6  # relative, of a derivative
PROBLEM = re.compile(
    r"(?:Let (?=\$[^$]*\$ be )|Along with them"
    r"|(?:The equations? of motion(?: of mode \d)? (?:is|are)|Initially|The phase begins with) (?=\$))"
    r"(?:[^$.]|\.(?!\s)|\$[^$]*\$)*\.(?=\s|$)|Numerical integration until (?:[^$]|\$[^$]*\$)*?,? gives"
)
"""What states an initial-value problem: formulas that hold throughout a phase, not for numbers that the text gives."""
SIGNS = ("plus", "minus", "dash")


@dataclass(frozen=True, slots=True)
class Equality:
    """An equation in the text of a solution: both sides as text and as functions of the symbols."""

    text: str
    sides: tuple[Node, Node]
    terms: tuple[Node, ...]  # by whose size they are compared
    symbols: frozenset[str]
    close: float = ROUNDED_RTOL

    def excess(self, values: Mapping[str, float]) -> float | None:
        """Return the left minus the right side of the equation; None where a side has no value."""
        left, right = (arithmetic.value(side, values) for side in self.sides)
        return None if left is None or right is None else left - right

    def sizes(self, values: Mapping[str, float]) -> float:
        """Return the sum of the magnitudes of all terms of both sides."""
        term_values = (arithmetic.value(term, values) for term in self.terms)
        return sum(abs(size) for size in term_values if size is not None)

    def rounding(self, values: Mapping[str, float], excess: float) -> float:
        """Return by how much left minus right side may differ from zero if all numbers are rounded."""
        sizes = [self.sizes(values)]
        for name in self.symbols:
            moved = self.excess({**values, name: values[name] * (1.0 + DERIVATIVE_RSTEP)})
            sizes.append(abs(moved - excess) / DERIVATIVE_RSTEP if moved is not None else 0.0)
        return sum(sizes)

    def holds(self, values: Mapping[str, float]) -> bool:
        """Return whether both sides agree within the rounding of five digits."""
        excess = self.excess(values)
        return excess is not None and abs(excess) <= self.close * self.rounding(values, excess)


@dataclass(frozen=True, slots=True)
class ReadText:
    """The result of reading a solution's text: equations, formulas that do not parse, and values of symbols.

    `values` are the stated numbers, and those that follow for quantities that cancel, such as tensions.
    """

    equalities: tuple[Equality, ...]
    unread: tuple[str, ...]
    values: Mapping[str, float]
    sums: tuple[LabelSum, ...] = ()

    @property
    def broken(self) -> list[str]:
        """Return the equations that do not hold for the values in the text, or contain symbols without a value."""
        wrong = [e.text for e in self.equalities if e.symbols - self.values.keys() or not e.holds(self.values)]
        return wrong + [label_sum.text for label_sum in self.sums if not label_sum.holds(self.values)]


def read(text: str, known: Mapping[str, float] | None = None) -> ReadText:
    """Return all equalities of a text; a symbol has the first number it is equated with.

    For a symbolic problem, `known` contains the values of its symbols.
    """
    text = PROBLEM.sub("", text)
    equalities: list[Equality] = []
    unread: list[str] = []
    known = {canonical(name): value for name, value in (known or {}).items()}
    values = dict(known)
    chains = [match[1] for match in FORMULA.finditer(text)]
    table = _table(chains)
    for chain in chains:
        try:
            sides = [_side(part, table) for part in chain.split("=")]
        except Refused as refused:
            unread.append(f"{chain}: {refused}")
            continue
        name, last = _name(chain, table), sides[-1]
        if name and name not in values and not last[2] and (number := arithmetic.value(last[0], {})) is not None:
            values[name] = number
        for one, other in pairwise(sides):
            both = (one[0], other[0])
            equalities.append(Equality(chain, both, (*one[1], *other[1]), one[2] | other[2]))
    _follow(equalities, values)
    endings = [*ANSWER.finditer(text)]
    unread += [text.rpartition("\n")[2]] if text.count(BOX) > len(endings) else []
    for match in endings:
        try:
            equalities += [*_ending(match, table)]
        except Refused as refused:
            unread.append(f"{match[0]}: {refused}")
    given = text.partition("\n")[0] if text.startswith("Given") else ""
    given_names = [*known, *(name for chain in FORMULA.findall(given) if (name := _name(chain, table)))]
    sums = label_sums(text, lambda formula: _excess(formula, table), given_names, sorted(values))
    return ReadText(tuple(equalities), tuple(unread), values, tuple(sums))


def _ending(match: re.Match[str], table: frozenset[str]) -> Iterator[Equality]:
    """Yield the equation in the line with the boxed answer: a symbol with a three-digit number or a formula.

    In other units than the rest, the number is stated in both.
    """
    boxed = match["boxed"] + (match["unit"] if match["unit"] == DEGREES else "")
    sides = [_side(part, table) for part in (match["goal"], match["number"], boxed) if part is not None]
    close = BOXED_RTOL if match["sign"] != "=" else ROUNDED_RTOL
    for one, other in pairwise(sides):
        both, names = (one[0], other[0]), one[2] | other[2]
        if other is sides[-1] and match["number"] is not None:
            factor = parse_unit(unit_of(match["number"])).factor_to(parse_unit(unit_of(match["unit"])))
            both = arithmetic.product([(one[0], False), (arithmetic.constant(factor or 0.0), False)]), other[0]
        yield Equality(match[0], both, (both[1], *other[1]), names, close if other is sides[-1] else ROUNDED_RTOL)


def _excess(formula: str, table: frozenset[str]) -> Callable[[Mapping[str, float]], float | None] | None:
    """Return left minus right side of an equation as a function of its symbols; None if it does not parse."""
    try:
        left, right, *_ = [_side(part, table) for part in formula.split("=")]
    except Refused:
        return None
    equality = Equality(formula, (left[0], right[0]), (), left[2] | right[2])
    return lambda values: equality.excess(values) if equality.symbols <= values.keys() else None


def _follow(equalities: list[Equality], values: dict[str, float]) -> None:
    """Compute symbols without stated numbers from equations that are linear in them and have no other unknown.

    Among several such equalities, the one with the smallest magnification of rounding errors is used.
    """
    for _ in equalities:
        candidates = [each for equality in equalities if (each := _solved(equality, values)) is not None]
        if not candidates:
            return
        _, name, value = min(candidates)
        values[name] = value


def _solved(equality: Equality, values: Mapping[str, float]) -> tuple[float, str, float] | None:
    """Return the error magnification, name and value of an equation's only unknown; None if it is not linear."""
    missing = [*(equality.symbols - values.keys())]
    if len(missing) != 1:
        return None
    name = missing[0]
    excesses = [equality.excess({**values, name: x}) for x in (0.0, 1.0, 2.0)]
    if None in excesses:
        return None
    zero, one, two = (float(x or 0.0) for x in excesses)
    if one == zero or abs(two - 2.0 * one + zero) > 1e-6 * abs(one - zero):
        return None
    value = -zero / (one - zero)
    sizes = equality.rounding({**values, name: value}, 0.0)
    return sizes / abs(one - zero) / abs(value) if value else sizes, name, value


def _table(chains: list[str]) -> frozenset[str]:
    """Return the symbols of the text; e is one of them if it is equated with something."""
    symbols: set[str] = {"e"} if any(chain.strip().startswith("e =") for chain in chains) else set()
    for side in (side for chain in chains for side in chain.split("=")):
        try:
            symbols |= {token.text for token in tokenize(side, None, primes=True) if token.kind == "symbol"}
        except Refused:
            continue
    return frozenset(symbols)


def _side(text: str, table: frozenset[str]) -> tuple[Node, tuple[Node, ...], frozenset[str]]:
    """Return the value of a side without its unit, its terms, and its symbols."""
    tokens = tokenize(text.strip(), table)
    upright = next((n for n, token in enumerate(tokens) if token.kind == "word" and token.upright), len(tokens))
    if upright < len(tokens) and tokens[upright - 1].kind == "open":
        upright -= 1
    used = tokens[:upright]
    node, taken, refusal = parse(used, unit_follows=False)
    if taken < len(used):
        raise refusal or Refused(Outcome.UNREADABLE, f"{text!r} is not all a value")
    terms = tuple(parse(part, unit_follows=False)[0] for part in _terms(used))
    return node, terms, frozenset(token.text for token in used if token.kind == "symbol")


def _terms(tokens: list[Token]) -> Iterator[list[Token]]:
    """Yield the tokens between plus and minus signs outside brackets and bars."""
    depth, in_bars, part = 0, False, list[Token]()
    for token in tokens:
        depth += (token.kind == "open") - (token.kind == "close")
        in_bars ^= depth == 0 and token.kind == "bar"
        if depth == 0 and not in_bars and token.kind in SIGNS:
            if part:
                yield part
            part = []
        else:
            part.append(token)
    if part:
        yield part


def _name(chain: str, table: frozenset[str]) -> str:
    """Return the symbol that an equation equates with its other sides; empty if no side is a single symbol."""
    tokens = tokenize(chain.partition("=")[0].strip(), table)
    return tokens[0].text if len(tokens) == 1 and tokens[0].kind == "symbol" else ""


PART = re.compile(r"^\((?P<label>[a-h])\) ", re.MULTILINE)
RECALL = re.compile(r"^From part \((?P<label>[a-h])\), (?P<results>.*)\.$", re.MULTILINE)
LABELLED_PATTERN = re.compile(r"(?<![^\s])(\(\d+\))(?: [A-Z][^$()]*)? \$([^$]+)\$")


def part_faults(text: str) -> list[str]:
    """Return the faults in the text of all parts, in words.

    A name that a part recalls must occur in the quoted part, with the same number; every equality of the whole text
    must hold with the first number of each name; a label must denote one equation.
    """
    body = text.partition("\n\nAnswers: ")[0]
    pieces = PART.split(body)[1:]
    parts = dict(zip(pieces[::2], pieces[1::2], strict=True))
    faults = [fault for part in parts.values() for fault in _recalls(part, parts)]
    parsed = read("\n\n".join(parts.values()))
    faults += [f"does not hold: {broken}" for broken in parsed.broken]
    faults += [f"cannot be read: {unread}" for unread in parsed.unread]
    equations: dict[str, str] = {}
    for label, formula in LABELLED_PATTERN.findall(body):
        if equations.setdefault(label, formula) != formula:
            faults.append(f"{label} stands for two equations")
    return faults


def _recalls(part: str, parts: dict[str, str]) -> list[str]:
    """Return faults of names that a part quotes from another part."""
    faults: list[str] = []
    for recall in RECALL.finditer(part):
        source = parts.get(recall["label"], "")
        source_numbers = _numbers(RECALL.sub("", source))
        for name, number in _numbers(recall["results"]).items():
            if source_numbers.get(name) != number:
                faults.append(f"part ({recall['label']}) does not say {name} = {number}")
    return faults


def _numbers(text: str) -> dict[str, str]:
    """Return the names equated with numbers in a text, each with its last number as written."""
    numbers: dict[str, str] = {}
    for match in FORMULA.finditer(text):
        name, _, number = match[1].partition("=")
        try:
            numbers[canonical(name.strip())] = number.rpartition("=")[2].strip()
        except ValueError:
            continue
    return numbers
