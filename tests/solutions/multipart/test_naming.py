"""Tests of the use of one name per quantity in all parts of a problem, and of the check for that."""

from collections.abc import Mapping
from dataclasses import replace

import pytest

from sim2reason.solutions.algebra.expressions import Expression, Number, Symbol
from sim2reason.solutions.multipart import naming_fault, unify_names
from sim2reason.solutions.multipart.recall import RECALLED_STEP_KIND, recall_results
from sim2reason.solutions.solution import Relation, Solution, Step

MASS = Symbol("m")
S = r"\ \text{s}"


def part(
    given: Mapping[str, float],
    found: Mapping[str, tuple[Expression, str]],
    words: str = "",
    stated: tuple[str, ...] = (),
) -> Solution:
    """Return a solution in which each name has a unit and a formula in terms of the names before it."""
    values: dict[str, float] = {**given}
    steps = [
        Step(
            0,
            "givens",
            f"Given: {' and '.join(f'${name} = {value:g}$' for name, value in given.items())}.",
            tuple(Relation(Symbol(name), Number(value), "given") for name, value in given.items()),
            (),
            (),
        )
    ]
    if words:
        steps.append(Step(1, "names", words, (), (), ()))
    source: dict[str, int] = {}
    for name, (formula, unit) in found.items():
        values[name] = float(formula.value(values).real)
        relation = Relation(Symbol(name), formula, "law", unit)
        needs = tuple(sorted({source[held] for held in formula.symbols() if held in source}))
        source[name] = len(steps)
        steps.append(Step(len(steps), "found", f"So {relation.latex(values[name])}.", (relation,), (name,), needs))
    goal = [*found][-1]
    return Solution("", tuple(steps), values, goal, values[goal], [*found.values()][-1][1], stated=stated)


def told(*parts: Solution, whole: bool = True) -> list[Solution]:
    """Return the parts with unified names, each of which recalls the results of earlier parts."""
    earlier: list[tuple[str, Solution]] = []
    for label, held in zip("abcd", unify_names(parts, {"m"}), strict=False):
        earlier.append((label, recall_results(held, earlier, whole=whole)))
    return [held for _, held in earlier]


COLLIDING = part({"m": 4.0}, {"t": (MASS * 0.5, S), "J": (MASS * Symbol("t"), "")})
LATER = part(
    {"m": 4.0, "t": 7.0},
    {"t_1": (MASS * 0.5, S), "t_2": (Symbol("t") - Symbol("t_1"), S), "d": (MASS * Symbol("t_2"), "")},
    stated=("t",),
)


@pytest.mark.parametrize("whole", [False, True])
def test_a_stated_instant_keeps_its_name_and_a_time_that_is_found_has_one_in_all_parts(whole: bool) -> None:
    first, second = told(COLLIDING, LATER, whole=whole)
    assert first.values["t_1"] == 2.0
    assert "t" not in first.values
    assert (second.values["t"], second.values["t_1"], second.values["t_2"]) == (7.0, 2.0, 5.0)
    assert ("From part (a), $t_1 = 2.0000" in second.text) == whole
    assert naming_fault([first, second]) == ""


def test_parts_as_they_were_written_are_refused() -> None:
    assert naming_fault([COLLIDING, LATER]) == "t has one value in part (a) and another in part (b)"


def test_the_sum_keeps_the_letter_and_a_term_the_number_that_it_has_there() -> None:
    J, N = Symbol("J"), r"\ \text{N s}"
    first = part({"m": 4.0}, {"J": (MASS * 3.0, N)})
    both = part({"m": 4.0}, {"J_1": (MASS * 5.0, N), "J_2": (MASS * 3.0, N), "J": (Symbol("J_1") + Symbol("J_2"), N)})
    one, two = told(first, both, whole=False)
    assert (one.goal, two.goal) == ("J_2", J.name)
    assert "From part (a), $J_2 = 12.000" in two.text


def test_what_is_called_by_another_letter_is_not_taken_for_the_same() -> None:
    """Equal values don't identify a compression with a displacement, nor quantities of two different bodies."""
    first = part({"m": 4.0}, {"a_A": (MASS * 0.5, S)})
    second = part({"m": 4.0}, {"a_B": (MASS / 2.0, S), "e": (MASS * 0.5, S), "v": (Symbol("a_B") + Symbol("e"), S)})
    assert "From part" not in told(first, second)[1].text


def test_what_is_introduced_in_the_same_words_has_the_same_name() -> None:
    words = "Accelerations: ${}$ of blocks A and B downward; ${}$ of block C upward."
    first = part({"m": 4.0}, {"a_A": (MASS * 0.5, S), "a_C": (MASS * 3.0, S)}, words.format("a_A", "a_C"))
    second = part({"m": 4.0}, {"a_B": (MASS / 2.0, S), "v": (Symbol("a_B") * 7.0, "")}, words.format("a_B", "a_C"))
    assert naming_fault([first, second]) == "a_A of part (a) is called a_B in part (b)"
    assert "a_B" not in told(first, second)[1].values


def test_tensions_of_different_strings_have_different_names() -> None:
    words = "Tension: $T$ in the string between block {} and block C."
    first = part({"m": 4.0}, {"T": (MASS * 0.5, S)}, words.format("A"))
    second = part({"m": 4.0}, {"T": (MASS / 2.0, S), "W": (Symbol("T") * 7.0, "")}, words.format("B"))
    assert "T is" in naming_fault([first, second])
    found = told(first, second)
    assert naming_fault(found) == ""
    assert "T" not in found[1].values


def test_a_name_that_the_named_part_has_not_is_refused() -> None:
    first, second = told(COLLIDING, LATER)
    recalled = next(step for step in second.steps if step.kind == RECALLED_STEP_KIND)
    assert recalled.gives == ("t_1",)
    other = replace(recalled, text=recalled.text.replace("t_1", "t_3"), gives=("t_3",))
    planted = replace(second, steps=tuple(other if step is recalled else step for step in second.steps))
    assert naming_fault([first, planted]) == "part (b) takes t_3 from part (a), which has no t_3"
    elsewhere = replace(recalled, text=recalled.text.replace("(a)", "(c)"))
    planted = replace(second, steps=tuple(elsewhere if step is recalled else step for step in second.steps))
    assert naming_fault([first, planted]) == "part (b) takes t_1 from part (c), which has no t_1"


def test_a_recalled_name_with_another_value_is_refused() -> None:
    first, second = told(COLLIDING, LATER)
    planted = replace(second, values={**second.values, "t_1": 2.5})
    assert naming_fault([first, planted]) == "part (b) takes t_1 from part (a), where it has another value"


def test_of_several_results_in_a_row_only_those_that_are_new_are_told() -> None:
    first = part({"m": 4.0}, {"x": (MASS * 0.5, S)})
    second = part({"m": 4.0}, {"x": (MASS * 0.5, S), "y": (MASS * 3.0, S), "z": (Symbol("x") + Symbol("y"), S)})
    *_, x, y, z = second.steps
    row = replace(
        x,
        text=f"The displacements are {x.relations[0].latex(2.0)} and {y.relations[0].latex(12.0)}.",
        relations=(*x.relations, *y.relations),
        gives=("x", "y"),
    )
    end = replace(z, id=2, needs=(1,))
    _, found = told(first, replace(second, steps=(second.steps[0], row, end)))
    assert "From part (a), $x = 2.0000" in found.text
    assert f"\n\nThe displacement is {y.relations[0].latex(12.0)}.\n\n" in found.text
