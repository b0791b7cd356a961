"""Tests that the second engine confirms equilibria and small oscillations, and rejects wrong ones."""

from dataclasses import replace

import pytest

from motions import light_rod, spring_block, string_pendulum
from resting import RESTFUL, rests
from sim2reason.simulation.equilibrium import Equilibrium, equilibrium
from sim2reason.simulation.oscillation import (
    Oscillations,
    equilibrium_disagreement,
    mode_disagreement,
    oscillations,
)
from states import altered


def _found(made: object) -> tuple[Equilibrium, Oscillations]:
    rest = equilibrium(made)  # type: ignore[arg-type]
    assert rest is not None
    modes = oscillations(rest)
    assert modes is not None
    return rest, modes


@pytest.mark.parametrize("made", [light_rod, spring_block, string_pendulum])
def test_it_agrees_with_what_is_right_alone(made: type) -> None:
    """A period off by 1 % or by a factor of three is rejected, as are a wrong force and a wrong position."""
    rest, modes = _found(made().mechanism)
    assert equilibrium_disagreement(rest) == ""
    assert mode_disagreement(rest, modes, 0) == ""
    for factor in (0.99, 1.01, 1.0 / 3.0, 3.0):
        assert mode_disagreement(rest, replace(modes, frequencies=factor * modes.frequencies), 0)
    state = rest.state
    for name, tension in state.constraint_tension.items():
        wrong = altered(state, constraint_tension={**state.constraint_tension, name: tension + 0.01})
        assert "tension" in equilibrium_disagreement(replace(rest, state=wrong))
    assert equilibrium_disagreement(replace(rest, state=altered(state, q=state.q + 0.01)))


@pytest.mark.parametrize("recipe", RESTFUL)
def test_both_engines_agree_on_random_scenes(recipe: str) -> None:
    """The engines agree on equilibria with all their forces, and on every normal mode."""
    seen = 0
    for rest in rests(recipe):
        seen += 1
        assert equilibrium_disagreement(rest) == ""
        modes = oscillations(rest)
        for number in range(len(modes.frequencies) if modes is not None else 0):
            assert modes is not None
            assert mode_disagreement(rest, modes, number) == ""
    assert seen
