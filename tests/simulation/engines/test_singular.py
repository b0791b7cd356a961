"""Tests that both engines raise their own error, not an arithmetic one, for singular motions."""

from collections.abc import Callable

import numpy as np
import pytest

from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.fields import Central
from sim2reason.scenes.dsl.mechanism import Mechanism, X
from sim2reason.simulation.engines.exact import engine
from sim2reason.simulation.trace import ENGINES

TIMES = np.linspace(0.0, 1.0, 11)


def _fixed_bodies_at_one_place() -> Mechanism:
    builder = Builder()
    room = builder.room()
    star, other = room.body("star", 1.0), room.body("other", 1.0)
    room.body("planet", 1.0, at=(1.0, 0.0, 0.0)).slide(X)
    other.attract(star, 1.0)
    return builder.finish()


def _carried_and_carrier_at_one_place() -> Mechanism:
    builder = Builder()
    cart = builder.room().body("cart", 1.0).slide(X)
    cart.attract(cart.body("rider", 1.0), 1.0)
    return builder.finish()


def _fixed_body_at_a_centre_of_force() -> Mechanism:
    builder = Builder()
    room = builder.room()
    room.body("stone", 1.0).force("C", Central((0.0, 0.0, 0.0), 1.0))
    room.body("block", 1.0).slide(X)
    return builder.finish()


def _rocket_that_burns_all_of_itself() -> Mechanism:
    builder = Builder()
    builder.room().body("rocket", 1.0).slide(X, 1.0).burn(1.0, 1.0, 1.0, X)
    return builder.finish()


SINGULAR = (
    _fixed_bodies_at_one_place,
    _carried_and_carrier_at_one_place,
    _fixed_body_at_a_centre_of_force,
    _rocket_that_burns_all_of_itself,
)


@pytest.mark.filterwarnings("ignore:.*encountered in:RuntimeWarning")
@pytest.mark.parametrize("name", ["exact", "mujoco"])
@pytest.mark.parametrize("made", SINGULAR)
def test_it_is_refused(made: Callable[[], Mechanism], name: str) -> None:
    with pytest.raises(SimulationError):
        ENGINES[name](made(), TIMES)


def test_what_cannot_be_set_up_is_singular_from_the_start(monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(*_: object) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr(engine.Settling, "__init__", fails)
    with pytest.raises(SimulationError, match="singular from the start"):
        ENGINES["exact"](_fixed_bodies_at_one_place(), TIMES)
