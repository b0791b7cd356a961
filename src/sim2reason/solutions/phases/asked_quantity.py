"""The quantity asked about, from the last state of a motion."""

from dataclasses import replace

from sim2reason.questions.kinds.parts.stretch_kind import StretchQuery
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.goals import GOALS, VectorName, finish
from sim2reason.solutions.phases.end_state import EndState
from sim2reason.solutions.phases.equations import PhaseEquations
from sim2reason.solutions.phases.extremes import quantity_of
from sim2reason.solutions.phases.values import formula_of
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.writing.steps import Book, UnsolvedError
from sim2reason.solutions.writing.unit_latex import METRES


def write_quantity(setting: Setting, book: Book, end: PhaseEquations) -> Symbol:
    """Write how the quantity asked about follows from the last state; return its symbol.

    Raises:
        UnsolvedError: the question asks for no quantity, or it has no formula.
    """
    query, target, state = setting.query, setting.target, EndState(setting, book, end)
    if query.kind == "extremum" and isinstance(query, StretchQuery):
        if query.functional == "greatest height":
            height = end.displacement(query.name)[2].factored()
            return finish(state, height, VectorName("h", METRES, "height"), "", "the height above the starting point")
        target = replace(target, quantity=quantity_of(query.functional)) if target is not None else None
    if target is None:
        raise UnsolvedError("the question asks for no quantity")
    if target.quantity in GOALS:
        return GOALS[target.quantity].write(target, state)
    formula, noun = formula_of(end, target), VectorName.of(target.quantity)
    return finish(state, formula, noun, "", f"the {target.quantity}")
