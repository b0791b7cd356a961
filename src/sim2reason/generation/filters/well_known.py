"""Filters for textbook problems: few laws, one line, or few symbols, and the size of formulas."""

from collections.abc import Iterator

from sim2reason.generation.filters import FILTERS, Candidate, Filter
from sim2reason.generation.filters.misconceptions import TURNS, turns_by_weight
from sim2reason.generation.filters.products import find_product
from sim2reason.generation.filters.sensitivity import MAX_IDLE_SHARE, minimum_relevant
from sim2reason.generation.filters.sums import find_sum
from sim2reason.scenes.dsl.structure import changing
from sim2reason.solutions import Solution
from sim2reason.solutions.algebra.expressions import Expression, Product, Sum, Symbol
from sim2reason.solutions.algebra.functions import Call, Root
from sim2reason.solutions.closed_forms import ClosedFormError, combined_formula
from sim2reason.solutions.closed_forms.gathering import factor_terms, parted, symbols_in
from sim2reason.solutions.derivation import derivation, is_derived
from sim2reason.solutions.difficulty import count_laws, is_vector

SQUARE_EXPONENT = 2
LENGTH = Symbol("length")


def size(expression: Expression) -> int:
    """Return the number of symbols in a formula, with repetitions; a given initial vector counts as one symbol.

    The magnitude of a given vector counts as one symbol, and so does a repeated root, such as √(k/m) in A ω sin ωt.
    """
    shortest = parted(factor_terms(_substitute_lengths(expression), symbols_in))
    return symbols_in(shortest) - sum(symbols_in(root) - 1 for root in _again(shortest, set()))


def has_logarithm(expression: Expression) -> bool:
    """Return whether a formula contains a logarithm, as from an integral."""
    return (isinstance(expression, Call) and expression.function == "ln") or any(map(has_logarithm, expression.parts))


def _again(expression: Expression, seen: set[Expression]) -> Iterator[Expression]:
    """Yield each root, such as √(k/m), that occurs in the formula a second time; roots inside these are omitted."""
    if isinstance(expression, Root) and expression in seen:
        yield expression
        return
    for part in expression.parts:
        yield from _again(part, seen)
    if isinstance(expression, Root):
        seen.add(expression)


def _substitute_lengths(expression: Expression) -> Expression:
    if is_vector(expression) and all(_is_given(part) for term in expression.parts[0].parts for part in term.parts):
        return LENGTH
    return (
        expression.built_of([_substitute_lengths(part) for part in expression.parts])
        if expression.parts
        else expression
    )


def _is_given(component: Expression) -> bool:
    """Return whether a vector component is a stated number, or the difference of two."""
    match component:
        case Sum(terms):
            return all(map(_is_given, terms))
        case Product(factors):
            return symbols_in(component) == 1 and len(factors) <= SQUARE_EXPONENT
        case _:
            return isinstance(component, Symbol)


FEW_LAWS = "few laws"
MOST = {0: 11, 1: 11, 2: 8, 3: 7, 4: 7}
"""By the number of laws, the symbols in a formula, each as often as it stands there, that make no problem of it.

Set by 460 problems that readers judged: it parts those that they called trivial from nearly all others.
"""
TEXTBOOK = {"easy": 3, "medium": 2, "hard": 0}
"""By how many symbols fewer that is where two laws or more are used.

An easy problem may be one that a textbook has, if it takes two laws.
"""
STEADY = {**MOST, 2: 9, 3: 8, 4: 10}
"""The same where accelerations are constant: two blocks on one string, and how far they come by a time."""
MAX_KNOWN_SYMBOLS = 4  # symbols in a formula known by heart together with moments of inertia
MAX_COORDINATES = 2  # coordinates of scenes to which the limit on laws applies, if no event occurs


class FewLaws(Filter):
    """Filter for questions whose worked solution needs few laws and leads to a short formula.

    Examples are v/(g (sin θ + µ cos θ)) until a block comes to rest, F/(m_A + m_B) + g sin θ for two blocks that move
    as one, √(v² + k d²/m) for a cart on a spring, and the range of a thrown ball. Questions without a derived formula
    pass, and so do integrals, recognised by a logarithm, unless the integral is the only law.

    Bodies that roll or swing by their weight pass, as for `one line`, since force and torque laws are combined there;
    only formulas known by heart, such as ⅓ m g sin θ of a cylinder, are rejected. Derivations with more than laws, such
    as a derivative, pass as well.
    """

    order = 3

    def ready(self, candidate: Candidate) -> bool:
        """Return whether the derivation is already cached, as it is in the symbolic mode."""
        return is_derived(candidate.question.query, candidate.study)

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if the worked solution needs few laws and its formula contains few symbols."""
        solution = None if candidate.easy else _derivation(candidate)
        if solution is None:
            return ""
        laws = count_laws(solution)
        most = (MOST if changing(candidate.study.mechanism) else STEADY).get(laws, -1)
        most -= TEXTBOOK[candidate.difficulty] if laws > 1 else 0
        symbols = _symbols(solution) if most > 0 else None
        if symbols is None or symbols > most or (symbols > MAX_KNOWN_SYMBOLS and turns_by_weight(candidate)):
            return ""
        return f"{_counted(laws)}, a formula of {symbols} symbols"

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield report lines: the number of laws and the strategy of the worked solution, and its formula's size."""
        solution = _derivation(candidate)
        if solution is not None:
            yield f"{_counted(count_laws(solution))}, by {solution.strategy}"
            yield f"symbols in the formula: {_symbols(solution) or 'too many, or an integral'}"
            if turns_by_weight(candidate):
                yield TURNS


def _symbols(solution: Solution) -> int | None:
    """Return the number of symbols in the formula of the answer; None if the formula is too long.

    None also for integrals, except where the integral is the only law, as in u ln(m_0/m_1).
    """
    try:
        expression = combined_formula(solution)
    except ClosedFormError:
        return None
    return None if count_laws(solution) > 1 and has_logarithm(expression) else size(expression)


def _counted(laws: int) -> str:
    return f"{laws} law{'' if laws == 1 else 's'}"


def _derivation(candidate: Candidate) -> Solution | None:
    """Return a worked solution as formulas; None if there is none, or the limit on laws does not apply to the scene."""
    study, words = candidate.study, candidate.words
    if candidate.kind.beyond_laws or words is None or not words.symbols or study.mechanism is not study.scene.mechanism:
        return None
    if len(study.mechanism.coordinates) > MAX_COORDINATES or study.trace.story(candidate.time):
        return None
    solution = derivation(candidate.question.query, study, words)
    return solution if solution.derived else None


FILTERS.add(FEW_LAWS, FewLaws())


class FewSymbols(Filter):
    """Filter for formulas with fewer numbers of bodies than must affect a numeric answer.

    The numbers of the world, such as g, do not count. Formulas that lack too many of the symbols are rejected too:
    where a spring passes its natural length, nothing depends on its stiffness.
    """

    order = 1

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if the formula has too few symbols, or too many symbols of the text are unused."""
        formula = candidate.question.formula
        if formula is None:
            return ""
        wanted, total = minimum_relevant(candidate), len(formula.symbols)
        if len(formula.within) < wanted:
            return f"{len(formula.within)} symbols of {wanted}"
        return (
            f"idle symbols: {len(formula.without)} of {total}" if len(formula.without) > MAX_IDLE_SHARE * total else ""
        )

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield report lines: how many of the text's symbols occur in the formula, and how many do not."""
        formula = candidate.question.formula
        if formula is not None:
            required = minimum_relevant(candidate)
            yield f"{len(formula.within)} symbols of bodies and of the question; {required} must be there"
            missing = f"{len(formula.without)} of all {len(formula.symbols)} symbols are missing"
            yield f"{missing}; up to {MAX_IDLE_SHARE:.0%} may be"


FILTERS.add("few symbols", FewSymbols())


class OneLine(Filter):
    """Filter for answers that are a product of few stated numbers, or a sum of two, as F/(m + M) or √(v² + 2 g h).

    Results of well-known formulas are rejected as well: a period, a free fall, a weight on a slope. Bodies that roll or
    swing by their weight pass, as for `few laws`, since force and torque laws are combined there, whatever the result
    is, such as the friction ½ m g sin θ on a rolling pipe.
    """

    order = 9

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if the answer equals a simple product or sum of stated numbers."""
        if candidate.easy or candidate.kind.measured(candidate.question.query).whole:
            return ""
        line = find_product(candidate) or find_sum(candidate)
        return "" if line and turns_by_weight(candidate) else line

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield a report line with the product or sum that equals the answer, if any."""
        yield (
            find_product(candidate)
            or find_sum(candidate)
            or "the answer is no product of stated numbers, nor a sum of two"
        )
        if turns_by_weight(candidate):
            yield TURNS


FILTERS.add("one line", OneLine())
