"""Tests of the verification that rejects solutions whose data don't lead to the answer."""

import json
from dataclasses import replace
from importlib import import_module

import pytest

from plain_scenes import atwood
from sim2reason.questions import Query, Target
from sim2reason.questions.moments.times import BurnedOut
from sim2reason.scenes.bodies.space import LevelGround, Rocket
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.space import RocketEntity
from sim2reason.solutions import Relation, Solution, Step, solve
from sim2reason.solutions.algebra.expressions import Number, Symbol
from sim2reason.solutions.checking import recompute
from sim2reason.solutions.data import as_data
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.solution import Role
from sim2reason.solutions.verification import RECOMPUTATION_FAILED, verification_fault, verify_solution
from worked import asked, settings_of

TENSION = "What is the tension in the string just after release?"


def setting() -> ProblemContext:
    return asked(atwood(), TENSION)


def test_a_solution_that_leads_to_the_answer_is_shown() -> None:
    found = solve(setting())
    assert found.answer is not None
    assert verify_solution(found, setting()) is found
    again = recompute(as_data(found))
    assert again.answer == pytest.approx(found.answer, rel=1e-12)
    assert again.values["T"] == pytest.approx(found.values["T"], rel=1e-12)


def changed(found: Solution, kind: str, relations: tuple[Relation, ...]) -> Solution:
    steps = [replace(step, relations=relations) if step.kind == kind else step for step in found.steps]
    return replace(found, steps=tuple(steps))


def test_what_is_refused_says_why() -> None:
    found = solve(setting())
    for spoiled in (
        changed(found, "newton", found.relations[:1]),
        changed(found, "givens", ()),
        changed(found, "givens", tuple(replace(r, right=Number(2.0)) for r in found.relations if r.role == "given")),
    ):
        refused = verify_solution(spoiled, setting())
        assert refused.answer is None
        assert refused.strategy == found.strategy
        assert refused.reason.startswith(RECOMPUTATION_FAILED)


@pytest.mark.parametrize("role", ["result", "derived", "verified", "trial", "condition"])
def test_a_number_that_is_only_asserted_is_no_solution(role: Role) -> None:
    held = setting()
    assert held.answer is not None
    bare = Step(0, "answer", "", (Relation(Symbol("X"), Number(held.answer), role),), ("X",), ())
    refused = verify_solution(Solution("claims", (bare,), {"X": held.answer}, "X", held.answer), held)
    assert refused.answer is None
    assert refused.reason.startswith(RECOMPUTATION_FAILED)


@pytest.mark.parametrize("name", ["Z_hidden", "T"])
def test_an_invented_given_is_no_solution(name: str) -> None:
    """A given number that neither the text nor the question contains is rejected, whatever its name."""
    held = setting()
    data = as_data(solve(held))
    goal = data["goal"]
    for step in data["steps"]:
        step["relations"] = []
    data["givens"][name] = held.answer
    data["steps"][-1]["relations"] = [{"role": "law", "left": goal, "right": name, "unit": ""}] if name != goal else []
    assert f"{name} = {held.answer:g} is not given by the text" in verification_fault(data, held)


@pytest.mark.parametrize("problem", ["pendulum-hard-reverse-301914-0", "rolling-easy-reverse-301921-0"])
def test_what_a_question_leaves_unknown_is_not_given(problem: str) -> None:
    """The unknown is an angle in one problem and the time of a given result in the other."""
    (held,) = settings_of(problem)
    data = as_data(solve(held))
    assert not verification_fault(data, held)
    data["givens"][data["goal"]] = data["answer"] / data["scale"]
    assert "is not given by the text" in verification_fault(data, held)


def test_a_wrong_sign_is_refused_where_the_answer_is_the_same() -> None:
    """The planted sign changes the burning time from u/g - m/µ to u/g + m/µ, and u t - g t²/2 is equal at both."""
    rocket = RocketEntity(
        rocket=Rocket(mass=700.0, dry=300.0), place=LevelGround(), exhaust=0.6, rate=9.0
    )  # which waits until it lifts off
    scene = Scene(entities=(Named(name="e", entity=rocket),))
    held = asked(scene, Query("event", Target("displacement", "e.rocket"), BurnedOut("e.rocket")))
    data = as_data(solve(held))
    assert not verification_fault(data, held)
    relations = (relation for step in data["steps"] for relation in step["relations"])
    lasts = next(relation for relation in relations if relation["left"] == r"t_{\text{up}}")
    lasts["right"] = json.loads(json.dumps(lasts["right"]).replace('["*", -1.0, "m_1"]', '"m_1"'))
    assert recompute(data).answer == pytest.approx(held.answer, rel=1e-9)
    assert r"t_{\text{up}} is" in verification_fault(data, held)


def test_a_result_of_an_earlier_part_is_given_by_its_name() -> None:
    held = setting()
    data = as_data(solve(held))
    data["givens"] |= {"L": 1.5}
    assert "L = 1.5 is not given by the text" in verification_fault(data, held)
    assert "L = 1.5 is not given by the text" in verification_fault(data, held, {"K": 1.5})
    assert "L is 2 in the question, not 1.5" in verification_fault(data, held, {"L": 2.0})
    assert not verification_fault(data, held, {"L": 1.5})


def test_what_is_refused_lets_the_next_strategy_try(monkeypatch: pytest.MonkeyPatch) -> None:
    held, right = setting(), solve(setting())

    def refuse(found: Solution, of: ProblemContext) -> Solution:
        return (
            Solution(found.strategy, reason=RECOMPUTATION_FAILED)
            if found.strategy == right.strategy
            else verify_solution(found, of)
        )

    monkeypatch.setattr(import_module("sim2reason.solutions.solve"), "verify_solution", refuse)
    other = solve(held)
    assert other.strategy != right.strategy
    assert other.answer is not None or f"{right.strategy}: {RECOMPUTATION_FAILED}" in other.reason
    assert solve(held, derived=True).strategy == right.strategy  # what only leads to formulas is not looked at


def test_a_count_is_whole_in_its_box_and_numbers_have_three_figures() -> None:
    def boxed(answer: float, **rest: object) -> str:
        return Solution("", values={"x": answer}, goal="x", answer=answer, **rest).text  # type: ignore[arg-type]

    assert boxed(3.0, whole=True).endswith(r"$x = \boxed{3}$.")
    assert boxed(170358.0).endswith(r"$x \approx \boxed{1.70 \times 10^{5}}$.")
    assert boxed(1234.5).endswith(r"\boxed{1.23 \times 10^{3}}$.")
    assert boxed(999.6).endswith(r"\boxed{1.00 \times 10^{3}}$.")
    assert boxed(123.45).endswith(r"\boxed{123}$.")
    assert boxed(0.00012345).endswith(r"\boxed{1.23 \times 10^{-4}}$.")
