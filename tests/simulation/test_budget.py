"""Tests of the limit on a simulation's work, counted in operations, in both engines."""

import numpy as np
import pytest

from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import Mechanism, X, Z
from sim2reason.simulation.engines.exact.flow import Flow
from sim2reason.simulation.engines.exact.formulas import VariableEquations
from sim2reason.simulation.engines.exact.settling import Settling
from sim2reason.simulation.engines.mujoco import model
from sim2reason.simulation.trace import DEFAULT_STEP_RTOL, ENGINES, Budget


def singing() -> Mechanism:
    """Build a grain of 1 mg on a spring of 1e6 N/m, which oscillates at 160 kHz."""
    builder = Builder()
    room = builder.room().site("wall", (-1.0, 0.0, 0.0))
    room.body("grain", 1e-6).slide(X).site("hook")
    room.spring("spring", "wall", "hook", stiffness=1e6, length=1.001)
    return builder.finish()


def test_a_budget_ends_with_what_it_had() -> None:
    purse = Budget(2_000_000)
    purse.spend(2_000_000)
    with pytest.raises(SimulationError, match="more than 2 million operations; simulate a shorter time"):
        purse.spend(1)


def test_work_is_counted_alike_each_time() -> None:
    """The count is independent of the clock: the same motion costs the same."""
    spent: list[int] = []
    for _ in range(2):
        run = Settling(singing(), 1e-4, DEFAULT_STEP_RTOL)
        flow = Flow(
            VariableEquations(run.system),
            run.instant(),
            run.phase,
            run.balance(run.instant(), set(), ()),
            DEFAULT_STEP_RTOL,
        )
        flow.advance(1e-4, 1e-4)
        spent.append(run.system.budget.all - run.system.budget.left)
    assert spent[0] == spent[1] > 0


def test_each_event_costs_something_for_each_coordinate(monkeypatch: pytest.MonkeyPatch) -> None:
    """Between its hundred bounces, a ball without loss has a motion in closed form, which costs nearly nothing."""
    builder = Builder()
    room = builder.room()
    ball = room.body("ball", 0.3, at=(0.0, 0.0, 0.15)).slide(Z)
    room.collide(room.body("floor"), ball, 0.1, 1.0)
    times = np.linspace(0.0, 20.0, 3)
    monkeypatch.setattr(Budget.__init__, "__defaults__", (1_500_000,))
    assert sum(event.kind == "collision" for event in ENGINES["exact"](builder.finish(), times).events) == 99
    monkeypatch.setattr(Budget.__init__, "__defaults__", (900_000,))
    with pytest.raises(SimulationError, match="million operations"):
        ENGINES["exact"](builder.finish(), times)


@pytest.mark.parametrize("name", ["exact", "mujoco"])
def test_what_swings_too_fast_is_refused(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Budget.__init__, "__defaults__", (1_000_000,))
    monkeypatch.setattr(model, "OPERATIONS", 1_000_000)
    with pytest.raises(SimulationError, match="million operations"):
        ENGINES[name](singing(), np.linspace(0.0, 2.0, 11))
