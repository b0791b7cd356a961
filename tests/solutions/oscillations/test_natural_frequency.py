"""Tests of the statement which of two normal modes has a given frequency, including inverse problems."""

from dataclasses import replace

import pytest

from plain_scenes import row
from sim2reason.questions import StatedResult
from sim2reason.questions.phrasing import PeriodQuery
from sim2reason.solutions import STRATEGIES, Solution, solve_with
from sim2reason.testing.solution_verification import faults
from worked import asked

MASSES, SPRINGS = (3.9, 2.8), (142.0, 139.0)


def solved(rank: int, unknown: str = "") -> Solution:
    scene = row(MASSES, SPRINGS, "right", strain=0.1)
    query = PeriodQuery("period", None, None, "angular frequency", small=True, of=(), rank=rank, modes=2)
    setting = asked(scene, query)
    if unknown:
        path = next(p.path for p in scene.parameters if p.path.endswith(unknown))
        assert setting.answer is not None
        stated = StatedResult(repr(setting.answer), "rad/s")
        setting = replace(setting, unknown=path, stated=stated)
    found = solve_with(STRATEGIES["normal modes"], setting)
    assert found.answer is not None, found.reason
    assert setting.answer is not None
    assert not faults(found, setting.answer), found.text
    return found


@pytest.mark.parametrize(("rank", "which", "size"), [(0, "slower", "smaller"), (1, "faster", "greater")])
def test_the_mode_is_named_with_its_root(rank: int, which: str, size: str) -> None:
    text = solved(rank).text
    assert f"The {size} root" in text
    assert f"the {which} mode has the {size} one" in text


@pytest.mark.parametrize(("rank", "which"), [(0, "slower"), (1, "faster")])
def test_a_mass_is_found_from_the_linear_equation_and_the_other_root_is_told(rank: int, which: str) -> None:
    """The equation is linear in the mass; the other frequency shows which mode has the given one."""
    found = solved(rank, "carts.0.mass")
    assert found.answer == pytest.approx(MASSES[0], rel=1e-6)
    assert r"\sqrt{\left(" not in found.text
    assert r"4\," not in found.text
    assert f"is that of the {which} mode." in found.text
    product = SPRINGS[0] * SPRINGS[1] / (MASSES[0] * MASSES[1])
    (other,) = (float(r.right.value(found.values).real) for r in found.relations if r.role == "verified")
    assert other == pytest.approx(product / found.values[rf"\lambda_{rank + 1}"], rel=1e-6)
