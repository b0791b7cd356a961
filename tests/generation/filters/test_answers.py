"""Tests of the exact limits of answers that are kept, and of the numbers in their findings."""

from dataclasses import replace
from math import hypot, pi, sqrt, tan

import numpy as np
import pytest

from plain_scenes import atwood, ramp
from sim2reason.generation.filters import FILTERS, Candidate
from sim2reason.questions import KINDS, Moment, Query, Question, SimulatedScene, Target
from sim2reason.questions.moments.times import AtStart, AtTime
from sim2reason.scenes.dsl.scene import Scene

BLOCK, LOAD = "ramp.blocks.0", "one.system.blocks.0"
ZERO, STATED, LASTING = (
    "the answer can not be told from zero",
    "the answer is a stated number",
    "nothing changes it before",
)


def candidate(scene: Scene, moment: Moment, target: Target) -> Candidate:
    study = SimulatedScene.of(scene, np.linspace(0.0, 2.0, 41))
    query = Query(moment.kind, target, moment)
    answer, unit = KINDS[query.kind].answer(query, study), KINDS[query.kind].measured(query).unit
    assert answer is not None
    return Candidate(study, Question("numeric", query, "?", answer, unit), "a b c")


@pytest.mark.parametrize(
    ("quantity", "answer", "reason"),
    [
        ("velocity", 0.0979, ZERO),  # 1 % of the largest speed on the way, 4.9 m/s² · 2 s
        ("velocity", 0.0981, ""),
        ("velocity", 0.4761, ""),
        ("velocity", 0.4763, STATED),  # 0.5, the time in s, is within 5 % of the answer
        ("velocity", 0.5262, STATED),
        ("velocity", 0.5264, ""),
        ("velocity", 9.8, STATED),
        ("acceleration", 4.9, LASTING),
        ("acceleration", 4.909, LASTING),  # by less than 0.2 %
        ("acceleration", 4.911, ""),
        ("acceleration", 4.889, ""),
    ],
)
def test_an_answer_is_worth_asking_for_up_to_a_limit(quantity: str, answer: float, reason: str) -> None:
    found = candidate(ramp(), AtTime(0.5), Target(quantity, BLOCK))
    assert FILTERS["degenerate"].reason(replace(found, question=replace(found.question, answer=answer))) == reason


@pytest.mark.parametrize(
    ("scene", "moment", "target", "said"),
    [
        (
            ramp(),
            AtTime(0.5),
            Target("velocity", BLOCK),
            [
                "the result is 2.45; what is not beyond 0.098 can't be told from zero",
                "the nearest number of scene and question is 0.5, 0.8 of the answer away; 0.05 would be paid",
                "just after the start it is 0",
            ],
        ),
        (
            ramp(speed=2.0, friction=0.3),
            AtTime(0.2),
            Target("velocity", BLOCK),
            [
                "the result is 0.5108; what is not beyond 0.041 can't be told from zero",
                "the nearest number of scene and question is 0.2, 0.61 of the answer away; 0.05 would be paid",
                "just after the start it is 2",
            ],
        ),
        (
            atwood(),
            AtStart(),
            Target("acceleration", LOAD),
            [
                "the result is 1.96; what is not beyond 0.02 can't be told from zero",
                "the nearest number of scene and question is 9.8, 4 of the answer away; 0.05 would be paid",
            ],
        ),
    ],
)
def test_findings_say_how_far_an_answer_is_from_what_is_refused(
    scene: Scene, moment: Moment, target: Target, said: list[str]
) -> None:
    """An acceleration of 1.96 m/s² is also the largest one of all; of speeds, those at 2 s are the largest."""
    assert list(FILTERS["degenerate"].findings(candidate(scene, moment, target))) == said


@pytest.mark.parametrize(
    ("scene", "moment", "target", "elasticities"),
    [
        (ramp(), AtTime(0.5), Target("velocity", BLOCK), (1.0, pi / 6.0 / tan(pi / 6.0))),  # v = g t sin θ
        (ramp(), AtStart(), Target("normal force", BLOCK), (1.0, 1.0, pi / 6.0 * tan(pi / 6.0))),  # N = m g cos θ
        (atwood(), AtStart(), Target("acceleration", LOAD), (1.0, 2.4, 2.4)),  # 2 m₁ m₂/(m₁² − m₂²) for each mass
        (atwood(2.0, 1.9), AtStart(), Target("acceleration", LOAD), (1.0, 7.6 / 0.39, 7.6 / 0.39)),
    ],
)
def test_the_condition_number_is_the_root_of_the_sum_of_the_squares(
    scene: Scene, moment: Moment, target: Target, elasticities: tuple[float, ...]
) -> None:
    """The answer is g (m₁ − m₂)/(m₁ + m₂) for two masses, of which two nearly equal ones are refused."""
    found, size = candidate(scene, moment, target), hypot(*elasticities)
    (line,) = FILTERS["precision"].findings(found)
    assert float(line.split()[4].rstrip(";")) == pytest.approx(size, rel=0.02)
    assert bool(FILTERS["precision"].reason(found)) is (size > 20.0)
    sizes = [float(line.split(" = ")[1].split(";")[0]) for line in FILTERS["sensitivity"].findings(found)]
    assert sqrt(sum(each**2 for each in sizes)) == pytest.approx(size, rel=0.02)
