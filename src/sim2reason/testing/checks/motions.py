"""Checks of motions: both engines agree, and energy and momentum are conserved."""

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from sim2reason.errors import SimulationError, UnsupportedError
from sim2reason.scenes.dsl.mechanism import Force, Inextensible, Mechanism, X, Y, Z
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.vectors import Vector, inner
from sim2reason.simulation.trace import Trace
from sim2reason.testing.checks import Check, check
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import Specimen, Specimens
from sim2reason.testing.transformations import (
    acting,
    edges,
    external_force,
    integrals,
    intervals,
    kinetic,
    momentum,
    movable,
    powers,
)

MAX_REFUSED_FRACTION = 0.1  # fraction of scenes that may be refused with a reason; at least one scene


@check
class AgreementCheck(Check):
    """Check that both engines compute the same motion for nine of ten scenes, and refuse others with a reason."""

    name = "agreement"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Yield every refused scene if there are too many."""
        reasons = [(specimen, reason(specimen)) for specimen in specimens.members]
        refused = [(specimen, why) for specimen, why in reasons if why]
        if len(refused) > max(1.0, MAX_REFUSED_FRACTION * len(reasons)):
            for specimen, why in refused:
                yield specimen.finding(
                    self.name,
                    f"both engines agree on at least {1.0 - MAX_REFUSED_FRACTION:.0%} of the scenes",
                    f"they do not on {len(refused)} of {len(reasons)}; here: {why}",
                    "see what is singular or too stiff there, and bound the ranges that lead to it",
                )


def reason(specimen: Specimen) -> str:
    """Return why a motion is not certified to its end; empty if it is."""
    try:
        trace, certificate = specimen.certified
    except (SimulationError, UnsupportedError) as error:
        return str(error)
    return certificate.reason if trace.cut == "certificate" or certificate.stable_until < specimen.end else ""


ENERGY_RTOL = 1e-8  # of the largest energy that is there or exchanged


@check
class EnergyCheck(Check):
    """Check that kinetic energy changes by the work of all forces, impacts create none, and potentials fit forces."""

    name = "energy"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Check the intervals between events, except with rocket engines, which change masses."""
        for specimen in specimens.moving:
            mechanism = specimen.study.mechanism
            if not mechanism.burns:
                yield from self._works(specimen)
                yield from self._impacts(specimen)
            for force in mechanism.forces:
                yield from self._potential(specimen, force)

    def _works(self, found: Specimen) -> Iterator[Finding]:
        trace = found.study.trace
        for start, stop in intervals(trace, found.end):
            works, sizes = integrals(trace, start, stop, _powers, _energy_floor(trace.mechanism))
            parts = dict(zip(powers(trace.sample(edges(start, stop))), map(float, works), strict=True))
            before, after = kinetic(trace.sample(edges(start, stop)))
            work = sum(parts.values())
            scale = max(before, after, float(sizes.max(initial=0.0)), _energy_floor(trace.mechanism))
            if np.isfinite(work) and abs(after - before - work) > ENERGY_RTOL * scale:
                gained = f"from {start:.4g} to {stop:.4g} s it grows by {after - before:.9g} J"
                breakdown = ", ".join(f"{part:.6g} J by {name}" for name, part in parts.items() if part)
                yield found.finding(
                    self.name,
                    "the kinetic energy grows by the work of all that acts",
                    f"{gained}, the work is {work:.9g} J ({breakdown})",
                    "see that each law tells truly whether it is constant, and depends on nothing but its arguments",
                )
                return

    def _impacts(self, found: Specimen) -> Iterator[Finding]:
        """Yield findings for events that create energy, or lose some in elastic collisions."""
        trace = found.study.trace
        stretches = intervals(trace, found.end)
        laws = [line.law for line in trace.mechanism.lines]
        driven = any(isinstance(law, Inextensible) and law.reel != 0.0 for law in laws)  # a winch works as it jerks
        for (_, time), (after, _) in pairwise(stretches):
            old, new = kinetic(_around(trace, time, after))
            kinds = {event.kind for event in trace.events if time <= event.time <= after}
            kept = kinds == {"collision"} and all(hit.restitution == 1.0 for hit in trace.mechanism.meetings)
            scale = ENERGY_RTOL * max(old, new, _energy_floor(trace.mechanism))
            if (new - old > scale and not driven) or (kept and old - new > scale):
                what = ", ".join(sorted(kinds))
                yield found.finding(
                    self.name,
                    "an impact makes no energy, and an elastic one loses none",
                    f"the kinetic energy goes from {old:.9g} to {new:.9g} J at {time:.6g} s ({what})",
                    "see what meets or jerks there",
                )
                return

    def _potential(self, found: Specimen, force: Force) -> Iterator[Finding]:
        """Yield a finding where the decrease of a force's potential differs from the work of the force."""
        trace = found.study.trace
        for start, stop in intervals(trace, found.end) if force.region is None else ():
            ends = trace.sample(edges(start, stop))
            potential = force.law.potential(ends.frames.center(force.body).place, np)
            if potential is None:
                return
            first, last = ends.vector((potential, 0.0, 0.0))[:, 0]
            work, size = _work(trace, force, start, stop)
            if abs(first - last - work) > ENERGY_RTOL * max(
                abs(first), abs(last), size, _energy_floor(trace.mechanism)
            ):
                yield found.finding(
                    self.name,
                    f"the potential of {force.name} falls by the work of the force",
                    f"it falls by {first - last:.9g} J, the work is {work:.9g} J",
                    "let the law's potential be −∫F·dr, or None if there is none",
                )
                return


def _powers(state: State) -> Array:
    return np.array(list(powers(state).values()))


def _around(trace: Trace, before: float, after: float) -> State:
    return trace.sample(np.array([edges(0.0, before)[1], after]))


def _work(trace: Trace, force: Force, start: float, stop: float) -> tuple[float, float]:
    """Return the work of an applied force, and the integral of its absolute power, J."""

    def power(state: State) -> Array:
        velocity = state.vector(state.frames.center(force.body).velocity)
        return np.einsum("ij,ij->i", acting(state, force), velocity)[None, :]

    work_integrals = integrals(trace, start, stop, power, _energy_floor(trace.mechanism))
    return float(work_integrals.values[0]), float(work_integrals.sizes[0])


def _energy_floor(mechanism: Mechanism) -> float:
    """Return an energy that is negligible for a mechanism: that of its heaviest body at 0.1 m/s, J."""
    return 5e-3 * max((body.mass for body in mechanism.bodies if body.coordinates), default=1.0)


@check
class MomentumCheck(Check):
    """Check that momentum changes by the impulse of external forces, and impacts of free bodies conserve it."""

    name = "momentum"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Check every direction in which a body slides, except with edge contacts, engines or welds."""
        for specimen in specimens.moving:
            mechanism = specimen.study.mechanism
            if not (mechanism.feet or mechanism.burns or any(hit.sticks for hit in mechanism.meetings)):
                yield from self._impulses(specimen)
                yield from self._impacts(specimen)

    def _impulses(self, found: Specimen) -> Iterator[Finding]:
        trace = found.study.trace
        ways = list(movable(trace.mechanism))

        def pushing(state: State) -> Array:
            return np.array([external_force(state, coordinate) for coordinate in ways])

        for start, stop in intervals(trace, found.end) if ways else ():
            pushes, sizes = integrals(trace, start, stop, pushing, _momentum_floor(trace.mechanism))
            ends = trace.sample(edges(start, stop))
            for coordinate, impulse, size in zip(ways, map(float, pushes), map(float, sizes), strict=True):
                before, after = momentum(ends, coordinate)
                scale = max(abs(before), abs(after), size, _momentum_floor(trace.mechanism))
                if np.isfinite(impulse) and abs(after - before - impulse) > ENERGY_RTOL * scale:
                    gained = f"from {start:.4g} to {stop:.4g} s it grows by {after - before:.9g} kg m/s"
                    yield found.finding(
                        self.name,
                        f"the momentum of {coordinate.body} and what it carries grows by the impulse of what acts",
                        f"{gained}, the impulse is {impulse:.9g} N s",
                        "see that each law tells truly whether it is constant, and depends on its arguments alone",
                    )
                    return

    def _impacts(self, found: Specimen) -> Iterator[Finding]:
        trace = found.study.trace
        free = free_directions(trace.mechanism)
        for (_, time), (after, _) in pairwise(intervals(trace, found.end)) if free else ():
            state = trace.sample(np.array([edges(0.0, time)[1], after]))
            for direction in free:
                ways = [c for c in movable(trace.mechanism) if abs(inner(c.axis, direction)) > 1.0 - 1e-12]
                parts = [momentum(state, coordinate) * inner(coordinate.axis, direction) for coordinate in ways]
                old, new = np.sum(parts, axis=0)
                if abs(new - old) > ENERGY_RTOL * max(float(np.abs(parts).max()), _momentum_floor(trace.mechanism)):
                    yield found.finding(
                        self.name,
                        "an impact between free bodies leaves the sum of their momenta as it is",
                        f"at {time:.6g} s it goes from {old:.9g} to {new:.9g} kg m/s",
                        "see what meets there",
                    )
                    return


def free_directions(mechanism: Mechanism) -> list[Vector]:
    """Return the directions in which all bodies can move and no fixed object exerts an impulse."""
    roots = [body for body in mechanism.bodies if body.parent is None]
    anchored = any(mechanism.site[site].body is None for line in mechanism.lines for site in line.through)
    rough = any(face.friction > 0.0 for face in mechanism.faces)
    if anchored or rough or any(hit.a is None for hit in mechanism.meetings):
        return []
    own = {body.name: [c for c in movable(mechanism) if c.body == body.name] for body in roots}
    return [
        axis
        for axis in (X, Y, Z)
        if all(any(abs(inner(c.axis, axis)) > 1.0 - 1e-12 for c in own[body.name]) for body in roots)
    ]


def _momentum_floor(mechanism: Mechanism) -> float:
    """Return a momentum that is negligible for a mechanism: of its heaviest body, or 1 kg, at 0.1 m/s, kg m/s."""
    return 0.1 * (max((body.mass for body in mechanism.bodies if body.coordinates), default=0.0) or 1.0)
