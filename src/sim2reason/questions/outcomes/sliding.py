"""Outcomes for bodies at rest: sliding, slipping and tipping over."""

from dataclasses import dataclass
from math import isfinite

import numpy as np

from sim2reason.questions.moments.occurrence import can_roll, slip_velocity
from sim2reason.questions.outcomes import (
    OUTCOMES,
    Onset,
    PossibleOutcome,
    Swinging,
    is_steady_release,
    rest_speed_noise,
)
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import ZERO, Mechanism
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.simulation.quantities.subjects.bodies import Bodies
from sim2reason.simulation.quantities.subjects.interactions import Contacts
from sim2reason.simulation.trace import Trace


@OUTCOMES.register("slides")
@dataclass(frozen=True, slots=True)
class Slides(Onset):
    """The outcome that a body slips on the face on which it is at rest."""

    of = Contacts()

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the bodies on rough faces that do not roll, with their phrases."""
        if not is_steady_release(words):
            return {}
        contacts = words.mechanism.contacts
        called = words.subject_phrases(cls.of).items()
        return {n: phrase for n, phrase in called if contacts[n].friction > 0.0 and not can_roll(words, n)}

    def happens(self, trace: Trace) -> bool:
        """Return whether the body moves on its face."""
        return self.excess(trace) > 0.0

    def excess(self, trace: Trace) -> float:
        """Return the greatest speed of slip, m/s, less rounding noise."""
        return float(np.abs(slip_velocity(trace.state, self.name)).max()) - rest_speed_noise(trace)

    def does(self, words: Words) -> tuple[str, ...]:
        """Return the verb phrase, such as *block A slips on the plane*."""
        return tuple(f"{self.subject(words)} {verb}" for verb in self._verbs(words, "slips", "begins to slip"))

    def does_not(self, words: Words) -> tuple[str, ...]:
        """Return the negated statement, such as *block A does not slip on the plane*."""
        subject = self.subject(words)
        rests = () if words.mechanism.body[self.name].parent is not None else (f"{subject} stays at rest",)
        return (*rests, *(f"{subject} {verb}" for verb in self._verbs(words, "does not slip")))

    def _verbs(self, words: Words, *verbs: str) -> tuple[str, ...]:
        surface = words.fills(self.of, self.name)["surface"]
        return tuple(f"{verb} on {surface}" for verb in verbs)


ZERO_SPEED = 1e-9  # m/s


@OUTCOMES.register("slips_rolling")
@dataclass(frozen=True, slots=True)
class SlipsRolling(PossibleOutcome):
    """The outcome that a body that could roll slips on its face."""

    of = Contacts()

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the bodies that may roll on faces with finite friction, with their phrases."""
        mechanism = words.mechanism
        return {
            name: phrase
            for name, phrase in words.subject_phrases(cls.of).items()
            if can_roll(words, name)
            and mechanism.contacts[name].friction > 0.0
            and isfinite(mechanism.contacts[name].friction)
            and mechanism.body[name].center == ZERO
            and abs(_slip_at_start(mechanism, name)) <= ZERO_SPEED
        }

    def duration(self, scene: Scene) -> float:
        """Return the scene's usual simulation time, s."""
        return scene.horizon

    def happens(self, trace: Trace) -> bool:
        """Return whether the body ever slips."""
        return self.excess(trace) > 0.0

    def excess(self, trace: Trace) -> float:
        """Return the greatest speed of slip, m/s, less rounding noise."""
        return float(np.abs(slip_velocity(trace.state, self.name)).max()) - rest_speed_noise(trace)

    def does(self, words: Words) -> tuple[str, ...]:
        """Return the verb phrase, such as *the cylinder slips*."""
        subject = self.subject(words)
        return (f"{subject} slips", f"{subject} slips as it rolls")

    def does_not(self, words: Words) -> tuple[str, ...]:
        """Return the negated statement, such as *the cylinder rolls without slipping*."""
        subject = self.subject(words)
        return (f"{subject} rolls without slipping", f"{subject} does not slip")


def _slip_at_start(mechanism: Mechanism, name: str) -> float:
    """Return the velocity with which a body slips on its face at t = 0, m/s."""
    speeds = {coordinate.name: coordinate.speed for coordinate in mechanism.coordinates}
    return sum(factor * speeds[coordinate] for coordinate, factor in mechanism.contacts[name].slip)


CONTACT_HEIGHT_TOL = 1e-9  # m: largest height above the plane of an edge in contact with it


@OUTCOMES.register("tips_over")
@dataclass(frozen=True, slots=True)
class TipsOver(Swinging):
    """The outcome that a body set turning about an edge lands on its next face; never drawn by recipes."""

    of = Bodies()
    drawn_by_recipes = False

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the bodies that stand on edges and are set moving, by name."""
        mechanism = words.mechanism
        standing = {mechanism.site[foot.site].body for foot in mechanism.feet if not words.released}
        return {name: phrase for name, phrase in words.subject_phrases(cls.of).items() if name in standing}

    def happens(self, trace: Trace) -> bool | None:
        """Return whether the first edge to land is one that did not stand on the plane at the start."""
        first = next((event for event in trace.events if event.kind in ("land", "leave")), None)
        if first is None or first.kind == "leave":  # so fast that its edge leaves the plane: it does not fall back
            return None if first is None else True
        landed = first.subjects[0]
        foot = next(foot for foot in trace.mechanism.feet if foot.name == landed)
        began = trace.at(0.0)
        position = began.vector(began.frames.site(foot.site).place)[0]
        return float(np.dot(foot.normal, position)) - foot.height > CONTACT_HEIGHT_TOL

    def excess(self, trace: Trace) -> float:
        """Return the square of the least angular speed until the first edge lands, rad²/s²."""
        landed = next((event.time for event in trace.events if event.kind == "land"), float(trace.state.times[-1]))
        hinges = [n for n, c in enumerate(trace.mechanism.coordinates) if c.kind == "hinge" and c.body == self.name]
        scan = trace.until(float(np.nextafter(landed, 0.0))).scan
        return float(np.square(scan.v[:, hinges].sum(axis=1)).min())

    def does(self, words: Words) -> tuple[str, ...]:
        """Return the clause *the prism tips over*."""
        return (f"{self.subject(words)} tips over its edge",)

    def does_not(self, words: Words) -> tuple[str, ...]:
        """Return the clause *the prism does not tip over*."""
        return (f"{self.subject(words)} does not tip over its edge",)
