"""Tests of the balances of energy, momentum and angular momentum in random mechanisms with events.

Between two events the energy changes by the work of friction, damping, hands, winches and fields, the momentum by the
impulse of all external forces, the angular momentum of particles by that of the torques; no event adds energy.
"""

import numpy as np
import pytest

from balances import Moment, account, spans
from curved_mechanisms import FAMILIES
from sim2reason.errors import Sim2ReasonError
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.engines.exact import Motion, motion

CLOSE = 1e-8
SEEDS = 6
FREE = ("nets", "bobs", "chains", "balls", "fields", "planets")  # of these every force from outside is known
PARTICLES = ("nets", "balls", "fields", "planets")
SPEEDLESS = frozenset({"turn", "enter", "exit", "burn-out"})


def motions(family: str) -> list[Motion]:
    found: list[Motion] = []
    for seed in range(SEEDS):
        mechanism = FAMILIES[family](seed)
        if not mechanism.burns:  # the mass that a rocket loses takes energy and momentum along
            try:
                found.append(motion(mechanism, 2.0))
            except Sim2ReasonError:
                continue
    return found


@pytest.mark.parametrize("family", FAMILIES)
def test_every_joule_and_every_newton_second_has_an_origin(family: str) -> None:
    checked = 0
    for number, found in enumerate(motions(family)):
        for start, end in spans(found):
            errors = account(found, start, end)
            assert errors.energy <= CLOSE, (number, start, end, errors)
            if family in FREE:
                assert errors.momentum <= CLOSE, (number, start, end, errors)
            if family in PARTICLES:
                assert errors.angular <= CLOSE, (number, start, end, errors)
            checked += 1
    assert checked >= SEEDS // 2


@pytest.mark.parametrize("family", FAMILIES)
def test_no_event_adds_energy(family: str) -> None:
    for number, found in enumerate(motions(family)):
        times = np.array([segment.start for segment in found.segments[1:]])
        if len(times) and not _switched(found.mechanism):
            before, after = (Moment(found.state(times + shift)) for shift in (-1e-12, 1e-12))
            gain = after.kinetic() + after.potential() - before.kinetic() - before.potential()
            assert gain.max() <= CLOSE * max(1.0, float(before.kinetic().max())), (family, number)


def _switched(mechanism: Mechanism) -> bool:
    """Return whether any force acts within a region only, so that its potential begins or ends at a border."""
    return any(force.region is not None for force in mechanism.forces)
