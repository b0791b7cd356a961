"""Shared base of the moments of bodies in electric and magnetic fields."""

import math
from abc import abstractmethod
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from sim2reason.questions.moments.parts.passage import Passage
from sim2reason.questions.moments.parts.verbs import when_phrases
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.fields import Magnetic, Push, Resistance
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.vectors import inner
from sim2reason.simulation.quantities.subjects.bodies import AXES, Bodies
from sim2reason.simulation.trace import Trace

SLIGHT = 0.02  # of a velocity or an acceleration: a smaller component is none


class ActingFields(NamedTuple):
    """The fields that act on a body in a plane."""

    electric: tuple[Push, ...]
    magnetic: tuple[Magnetic, ...]
    medium: tuple[Resistance, ...]

    @property
    def turning(self) -> bool:
        """Return whether they turn the velocity or reverse it, in a way that short formulas give."""
        return bool(self.magnetic) or all(law.profile.uniform or _drives_back(law) for law in self.electric)

    @property
    def uniform(self) -> bool:
        """Return whether all fields are uniform and constant, and there is no medium."""
        return not self.medium and all(law.profile.uniform for law in (*self.electric, *self.magnetic))


def _drives_back(law: Push) -> bool:
    """Return whether the force of a field is a restoring one, towards the position where the force is zero."""
    return law.profile.steady and law.profile.slope * inner(law.profile.axis, law.direction) < 0.0


def acting_on(mechanism: Mechanism, name: str) -> ActingFields | None:
    """Return the fields that alone act on a body with axes x and y; None if anything else does, or a field ends."""
    own = mechanism.body[name].coordinates
    alone = not (mechanism.lines or mechanism.meetings or mechanism.attractions or mechanism.burns or mechanism.faces)
    level = all(inner(mechanism.gravity, c.axis) == 0.0 for c in own)
    if not alone or len(own) != 2 or any(c.label not in AXES for c in own) or not level:
        return None
    forces = [force for force in mechanism.forces if force.body == name]
    if any(force.region is not None for force in forces):
        return None
    laws = [force.law for force in forces]
    electric = tuple(law for law in laws if isinstance(law, Push))
    magnetic = tuple(law for law in laws if isinstance(law, Magnetic))
    medium = tuple(law for law in laws if isinstance(law, Resistance))
    return ActingFields(electric, magnetic, medium) if electric or magnetic else None


@dataclass(frozen=True, slots=True)
class FieldPassage(Passage):
    """The first time that something happens to a body on which fields alone act."""

    of = Bodies()

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the phrases of bodies in fields in which it may happen."""
        called, mechanism = words.called(cls.of).items(), words.mechanism
        return {name: said for name, said in called if (acts := acting_on(mechanism, name)) and cls.suits(acts)}

    def time(self, trace: Trace) -> float | None:
        """Return when it first happens, s; None where other fields act, or one of the text is left out."""
        acts = acting_on(trace.mechanism, self.name)
        return Passage.time(self, trace) if acts is not None and self.suits(acts) else None

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return phrases such as *when the bead first has its initial velocity again*."""
        first = f"{self.subject(words)} first {self.does(words).told}"
        return when_phrases(first)

    @classmethod
    @abstractmethod
    def suits(cls, acts: ActingFields) -> bool:
        """Return whether it may be asked about in these fields."""


def begins(state: State, name: str) -> tuple[Array, Array]:
    """Return the initial velocity, m/s, and acceleration, m/s², of a body in fields, (3,) each."""
    mechanism = state.mechanism
    body = mechanism.body[name]
    velocity = sum((c.speed * np.array(c.axis) for c in body.coordinates), np.zeros(3))
    vx, vy, vz = velocity.tolist()
    x, y, z = np.array(state.began.center(name).place, dtype=float).tolist()
    laws = [force.law for force in mechanism.forces if force.body == name]
    pushes = [np.array(law.force((x, y, z), (vx, vy, vz), 0.0, math), dtype=float) for law in laws]
    return velocity, sum(pushes, np.zeros(3)) / body.mass
