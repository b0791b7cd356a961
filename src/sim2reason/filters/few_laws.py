"""Drops a question that is answered by a formula which everybody knows."""

from collections.abc import Iterator

from sim2reason.filters import FILTERS, Candidate, Filter
from sim2reason.filters.parts.numbers import story
from sim2reason.solutions import Relation, Solution
from sim2reason.solutions.closed_forms import ClosedFormError, put_together
from sim2reason.solutions.closed_forms.gathering import gathered
from sim2reason.solutions.closed_forms.tidying import tidied
from sim2reason.solutions.derivation import derivation
from sim2reason.solutions.expressions import Expression, Sum, Symbol
from sim2reason.solutions.functions import Power, Root

MOST = {0: 11, 1: 11, 2: 8, 3: 6}
"""By the number of laws, the symbols in a formula, each as often as it stands there, that make no problem of it.

Set by 200 problems that readers judged: it parts those that they called trivial from nearly all others.
"""
SQUARE = 2
LARGEST = 2  # coordinates of what so few laws may answer a question about, if nothing happens on the way


class FewLaws(Filter):
    """The worked solution tells one law, or few, and they lead to a short formula: what a textbook has ready.

    As v/(g (sin θ + µ cos θ)) until a block comes to rest, (m_A + m_B) (a - g sin θ) for the force on two blocks that
    move as one, or √(v² + k d²/m) for a cart on a spring. Nothing is said where no formula is derived.
    """

    order = 9

    def reason(self, candidate: Candidate) -> str:
        """Count laws, and the symbols of the formulas put into each other."""
        found = _derivation(candidate)
        laws = number_of_laws(found) if found is not None else None
        symbols = _symbols(found) if found is not None and laws in MOST else None
        if laws is None or symbols is None or symbols > MOST[laws]:
            return ""
        return f"{_counted(laws)}, a formula of {symbols} symbols"

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """The laws of the solution."""
        found = _derivation(candidate)
        if found is not None:
            yield f"{_counted(number_of_laws(found))}, by {found.strategy}"
            yield f"symbols in the formula: {_symbols(found) or 'too many'}"


def _symbols(found: Solution) -> int | None:
    """How many symbols the formulas have that are put into each other; None if they become too long."""
    try:
        return _count(tidied(gathered(put_together(found))))
    except ClosedFormError:
        return None


def _count(held: Expression) -> int:
    return sum(1 for _ in held.symbols())


def _counted(laws: int) -> str:
    return f"{laws} law{'' if laws == 1 else 's'}"


def number_of_laws(found: Solution) -> int:
    """How many laws of physics it tells.

    A multiple or a sum of names, as v = -v_x, T = 2π/ω or e = ℓ - ℓ_0, is none, nor is a number, as a = 0 in a limiting
    case, or the size of a vector.
    """
    return sum(relation.role == "law" and not _is_bookkeeping(relation) for relation in found.relations)


def _is_bookkeeping(relation: Relation) -> bool:
    if not isinstance(relation.left, Symbol):
        return False
    match relation.right:
        case Root(Sum(terms)):
            return all(isinstance(term, Power) and term.exponent == SQUARE for term in terms)
        case Sum(terms):
            return all(map(_is_multiple, terms))
        case _:
            return _is_multiple(relation.right)


def _is_multiple(held: Expression) -> bool:
    return _count(held) <= 1


def _derivation(candidate: Candidate) -> Solution | None:
    """What leads to a formula; None where nothing is looked for, or found."""
    study, words = candidate.study, candidate.words
    if words is None or not words.symbols or study.mechanism is not study.scene.mechanism:
        return None
    if len(study.mechanism.coordinates) > LARGEST or story(study.trace, candidate.time):
        return None
    found = derivation(candidate.question.query, study, words)
    return found if found.derived else None


FILTERS.add("few laws", FewLaws())
