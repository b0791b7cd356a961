"""Tests of conserved energy and momentum in random mechanisms without friction, motors or inelastic impacts."""

import numpy as np
from hypothesis import given, reject, settings
from hypothesis import strategies as st

from random_mechanisms import pulleys, rough, table, wedges
from sim2reason.errors import SimulationError
from sim2reason.simulation.engines.exact import Motion, motion
from sim2reason.simulation.quantities import QUANTITIES

seeds = st.integers(0, 2**32 - 1)
CLOSE = 1e-8


def energies(found: Motion, end: float) -> tuple[np.ndarray, np.ndarray]:
    """Return total energies, and total kinetic energies for scale."""
    state = found.state(np.linspace(0.0, end, 40))
    kinetic, potential = (
        sum(QUANTITIES[name].evaluate(state, body) for body in state.mechanism.body)
        for name in ("kinetic energy", "potential energy")
    )
    return kinetic + potential, kinetic


def assert_energy_is_kept(found: Motion, floor: float) -> None:
    jerk = next((event.time for event in found.events if event.kind == "taut"), found.end)
    total, kinetic = energies(found, min(found.end, jerk) * (1.0 - 1e-9))
    assert np.ptp(total) <= CLOSE * max(kinetic.max(), floor)


@settings(max_examples=150)
@given(seed=seeds)
def test_energy_of_pulleys(seed: int) -> None:
    assert_energy_is_kept(motion(pulleys(seed).finish(), 1.0), 1.0)


@settings(max_examples=150)
@given(seed=seeds)
def test_energy_and_momentum_of_wedges(seed: int) -> None:
    found = motion(wedges(seed).finish(), 1.0)
    assert_energy_is_kept(found, 1.0)
    state = found.state(np.linspace(0.0, found.end, 20))
    along = sum(QUANTITIES["momentum"].evaluate(state, body)[:, 0] for body in state.mechanism.body)
    assert np.ptp(along) <= CLOSE * max(1.0, np.abs(along).max())


@settings(max_examples=150)
@given(seed=seeds)
def test_energy_of_elastic_discs(seed: int) -> None:
    assert_energy_is_kept(motion(table(seed, 1.0).finish(), 3.0), 1e-3)


@settings(max_examples=150)
@given(seed=seeds)
def test_momentum_of_discs(seed: int) -> None:
    found = motion(table(seed).finish(), 3.0)
    state = found.state(np.linspace(0.0, found.end, 40))
    momenta = sum(QUANTITIES["momentum"].evaluate(state, body) for body in state.mechanism.body)
    assert np.ptp(momenta, axis=0).max() <= CLOSE * max(1.0, np.abs(momenta).max())
    _, kinetic = energies(found, found.end)
    assert (np.diff(kinetic) <= CLOSE * kinetic.max()).all()  # no impact makes energy


def moved(seed: int) -> Motion:
    """Return the motion of a random rough mechanism; reject the rare one without consistent friction forces."""
    try:
        return motion(rough(seed).finish(), 1.0)
    except SimulationError as error:
        if "friction may be too strong" not in str(error):
            raise
        reject()


@settings(max_examples=300)
@given(seed=seeds)
def test_friction_and_jerks_only_take_energy(seed: int) -> None:
    found = moved(seed)
    total, kinetic = energies(found, found.end)
    assert (np.diff(total) <= CLOSE * max(1.0, kinetic.max())).all()


@settings(max_examples=300)
@given(seed=seeds)
def test_forces_stay_within_their_laws(seed: int) -> None:
    """Tension and normal force are never negative, |f| ≤ µN, and f opposes sliding."""
    found = moved(seed)
    index = {coordinate.name: number for number, coordinate in enumerate(found.mechanism.coordinates)}
    for segment in found.segments:
        assert all(not force < 0.0 for force in (*segment.tension, *segment.normal))
        for contact, force, normal in zip(
            found.mechanism.contacts.values(), segment.friction, segment.normal, strict=True
        ):
            assert not abs(force) > contact.friction * normal * (1.0 + CLOSE) + CLOSE
            assert not force * segment.v[index[contact.slip[0][0]]] > CLOSE
