"""Misconceptions about collisions and other events."""

from collections.abc import Iterable
from dataclasses import replace
from math import inf, isfinite

from sim2reason.questions.crossing import crossings
from sim2reason.questions.moments.parts.passage import Passage
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, MisinterpretedMotion, misconception
from sim2reason.questions.simplifications.parts.asked import query_time, with_formulas
from sim2reason.questions.simplifications.parts.restitution import OneRestitution
from sim2reason.questions.study import SimulatedScene, Timed
from sim2reason.scenes.dsl.constancy import changing
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.trace import events_before


@misconception
class ElasticCollisions(OneRestitution):
    """Collisions are taken as elastic."""

    name = "elastic collisions"
    reason = "every collision is taken as elastic"
    restitution = 1.0
    common = True


@misconception
class PerfectlyInelasticCollisions(OneRestitution):
    """Collisions are taken as perfectly inelastic."""

    name = "perfectly inelastic collisions"
    reason = "every collision is taken as perfectly inelastic"
    restitution = 0.0


@misconception
class LaterRoot(MisinterpretedMotion):
    """Where an equation for the time has two roots, the later one is taken."""

    name = "later root"
    reason = "the second time at which this happens is taken for the first"
    sound_if_same = True  # then what is asked hangs on the place alone, and who takes energies never asks for the time

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if a quantity passes through a value at the moment; else none."""
        del study
        return [""] if _is_passage(query.moment) else []

    def read(self, study: SimulatedScene) -> SimulatedScene:
        """Return the same motion, in which each passage through a value counts only the second time."""
        return _Later(study.scene, study.trace)


def _is_passage(moment: object) -> bool:
    return isinstance(moment, Passage) and type(moment).time is Passage.time


class _Later(SimulatedScene):
    """A motion in which a quantity's passage through a value counts only when it occurs for the second time."""

    def time(self, moment: Timed) -> float | None:
        """Return the second time, s, at which a quantity passes its value; the first time of any other moment."""
        first = super().time(moment)
        if first is None or not (isinstance(moment, Passage) and _is_passage(moment)):
            return first
        back = crossings(self.trace, lambda state: -moment.excess(state))
        again = (
            next((time for time in side if time > first), inf) for side in (crossings(self.trace, moment.excess), back)
        )
        later = min(again)
        return later if isfinite(later) else None


@misconception
class NoCollisions(ChangedMechanism):
    """Collisions are left out, as if bodies went through each other."""

    name = "no collisions"
    reason = "collisions are left out"

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if bodies can collide; else none."""
        del query
        return [""] if study.mechanism.meetings else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism without collisions."""
        del subject
        return replace(mechanism, meetings=())


@misconception
class NoEvents(MisinterpretedMotion):
    """The motion is assumed to continue as it begins, without any events such as stops or collisions."""

    name = "no events"
    reason = "the motion is taken to go on as it begins"

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if forces are constant and an event comes earlier; else none."""
        end = query_time(query, study)
        changes = any(event.time > 0.0 for event in events_before(study.trace.events, end))
        return [""] if changes and not changing(study.mechanism) else []

    def read(self, study: SimulatedScene) -> SimulatedScene:
        """Return the motion with the accelerations and forces of the start throughout."""
        return SimulatedScene(study.scene, with_formulas(study.trace, _continued))


def _continued(t: Array, v: Array, a: Array) -> tuple[Array, Array]:
    return v * t + 0.5 * a * t * t, v + a * t
