"""Questions for quantities at the start, at a stated time and at an event, and for the time of an event."""

from collections.abc import Iterator

import numpy as np

from sim2reason.questions.choices import (
    draw_target,
    has_formula_of_time,
    is_constant,
    is_large_enough,
    is_worth_asking_at,
    only_falls,
)
from sim2reason.questions.kinds import Kind, Measured, ValueKind, draw_moment, kind, moments_by_cause
from sim2reason.questions.moments import Happening, Moment
from sim2reason.questions.moments.reached import moment_of
from sim2reason.questions.moments.times import AllAlong, AtStart
from sim2reason.questions.query import Noun, Query, Targets
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Elastic, Mechanism
from sim2reason.scenes.dsl.structure import changing
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.trace import Channel


@kind
class EventKind(ValueKind):
    """The kind that asks for a quantity at an event, such as a collision or a stop."""

    name = "event"
    share = 0.3

    def draw(self, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Return a query for a random quantity at a random event that does not reveal the value; None without one."""
        moment = draw_moment(self.moments(), study, words, rng)
        return self.at(moment, study, words, targets, rng) if moment is not None else None

    def at(
        self, moment: Moment, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator
    ) -> Query | None:
        """Return a query for a quantity that varies near the moment and is not stated; None if there is none."""
        del words
        if moment.kind != self.name:
            return None
        offered = [
            target for target in targets if Channel(target.subject, target.quantity) not in moment.revealed_channels
        ]
        if moment.own:
            offered = [target for target in offered if target.subject in moment.subjects] or offered
        target = draw_target(offered, rng, is_worth_asking_at(study, moment))
        return Query(self.name, target, moment) if target is not None else None


MAX_POINT_FORCES = 2  # greatest number of forces besides weight that act on a single point mass


@kind
class StartKind(ValueKind):
    """The kind that asks for an acceleration or a force at t = 0⁺."""

    name = "start"
    share = 0.25
    timeless = True

    def draw(self, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Return a query for a nonzero quantity at the start, or for a constant one; None if there is none.

        None if the text gives irrelevant data, such as fuel or a speed that no equation contains, or if the answer
        follows from Newton's second law in one line.
        """
        mechanism, trace = study.mechanism, study.trace
        if not draw_moment(self.moments(), study, words, rng) or mechanism.burns:
            return None
        if _one_line(mechanism) or _speeds_idle(mechanism):
            return None
        here, immediate = trace.at(0.0), [t for t in targets if QUANTITIES[t.quantity].immediate]
        target = draw_target(immediate, rng, lambda target: is_large_enough(target.value(here), target, study))
        if target is None:
            return None
        return Query(self.name, target, AllAlong() if is_constant(target, trace) else AtStart())

    def at(
        self, moment: Moment, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator
    ) -> Query | None:
        """Return a query for a random quantity at the start; None if the moment is not the start."""
        return self.draw(study, words, targets, rng) if moment.kind == self.name else None


def _one_line(mechanism: Mechanism) -> bool:
    """Return whether only weight acts, or at most two forces act on a single point mass."""
    massive = [body for body in mechanism.bodies if body.mass and not (body.parent is None and not body.coordinates)]
    alone = len(massive) == 1 and not any(massive[0].inertia) and not mechanism.contacts
    acting = (*mechanism.lines, *mechanism.forces, *mechanism.attractions)
    return only_falls(mechanism) or (alone and len(acting) <= MAX_POINT_FORCES)


def _speeds_idle(mechanism: Mechanism) -> bool:
    """Return whether something moves at the start, while forces depend at most on positions."""
    if not any(coordinate.speed for coordinate in mechanism.coordinates):
        return False
    return _free(mechanism) or not changing(mechanism)


def _free(mechanism: Mechanism) -> bool:
    """Return whether there are no guides or friction, and only undamped springs and attractions act besides weight."""
    led = mechanism.constraints or mechanism.contacts or mechanism.forces or mechanism.feet
    elastic = (line.law for line in mechanism.lines if isinstance(line.law, Elastic))
    return not led and all(c.kind == "slide" for c in mechanism.coordinates) and not any(law.damping for law in elastic)


@kind
class StateKind(ValueKind):
    """The kind that asks for a quantity at a stated time."""

    name = "state"
    share = 0.06  # at most 30 % of all that passes the filters

    def draw(self, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Return a query at a random time away from events for a quantity that has changed by then; None without one.

        None where no short formula gives the motion as a function of time.
        """
        if not has_formula_of_time(study.mechanism):
            return None
        moment = draw_moment(self.moments(), study, words, rng)
        return self.at(moment, study, words, targets, rng) if moment is not None else None

    def at(
        self, moment: Moment, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator
    ) -> Query | None:
        """Return a query for a quantity that differs from its initial value at the moment; None if there is none."""
        del words
        target = draw_target(targets, rng, is_worth_asking_at(study, moment)) if moment.kind == self.name else None
        return Query(self.name, target, moment) if target is not None else None


@kind
class TimeToEventKind(Kind):
    """The kind that asks for the time from the start to the first occurrence of an event."""

    name = "time_to_event"
    share = 0.18

    def draw(self, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Return a query for the time of a random event of the motion; None if there is none."""
        del targets

        def wanted(moment: Happening) -> bool:
            return moment.clause(words) is not None and not moment.is_plain(study)

        moment = draw_moment(_event_classes(), study, words, rng, wanted)
        return Query(self.name, None, moment) if moment is not None else None

    def at(
        self, moment: Moment, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator
    ) -> Query | None:
        """Return the query for the time of the given moment; None if the time is not worth asking for."""
        del targets, rng
        worth_asking = isinstance(moment, Happening) and moment.clause(words) is not None and not moment.is_plain(study)
        return Query(self.name, None, moment) if worth_asking else None

    def answer(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the time of the event, s; None if it does not occur."""
        return self.time(query, study)

    def measured(self, query: Query) -> Measured:
        """Return the unit of a time, s, and the least answer, 0.01 s."""
        del query
        return Measured("time", "s", least=1e-2)

    def shapes(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return sentences such as *how long after release is B first 0.50 m from its starting point?*."""
        del noun
        assert isinstance(query.moment, Happening)
        clause, since = query.moment.clause(words), words.since
        if clause is None:
            return ()
        takes = f"how long does {clause.subject} take {clause.takes}, counted from {since}?"
        return (
            takes if clause.takes else f"how long after {since} {clause.question}?",
            f"how much time passes from {since} until {clause.statement}?",
            f"find the time from {since} until {clause.statement}.",
            f"what is the time from {since} until {clause.statement}?",
            f"determine how long after {since} {clause.statement}.",
        )

    def noun_phrases(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return noun phrases for the answer, such as *the time from release until B first stops*."""
        del noun
        assert isinstance(query.moment, Happening)
        clause = query.moment.clause(words)
        return (f"the time from {words.since} until {clause.statement}",) if clause is not None else ()

    def statements(self, query: Query, words: Words, noun: Noun | None, value: str) -> tuple[str, ...]:
        """Return statements of the result, such as *B first stops 1.2 s after release*."""
        assert isinstance(query.moment, Happening)
        clause, since = query.moment.clause(words), words.since
        if clause is None:
            return ()
        takes = f"{clause.subject} takes {value} {clause.takes}, counted from {since}"
        natural = takes if clause.takes else f"{clause.statement} {value} after {since}"
        return (natural, *super().statements(query, words, noun, value))

    def condition_phrases(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return no noun phrases if `statements` has a sentence, which reads better than *the time until …*."""
        return () if self.statements(query, words, noun, "") else self.noun_phrases(query, words, noun)

    def finds(self, words: Words) -> tuple[str, ...]:
        """Return the name *time*."""
        del words
        return ("time",)

    def posed(self, asked: StructuredQuestion, study: SimulatedScene, words: Words) -> Query | None:
        """Return the query for the time of a moment, or of a quantity's first reaching a stated value."""
        del study
        return Query(self.name, None, moment_of(asked, words))

    def parsed(self, text: str, study: SimulatedScene, words: Words, targets: Targets) -> Iterator[Query]:
        """Yield a query for every event that a sentence names."""
        del targets
        for cls in _event_classes():
            yield from (Query(self.name, None, moment) for moment in cls.parsed(text, study.trace, words))


def _event_classes() -> list[type[Happening]]:
    return [cls for cls in moments_by_cause() if issubclass(cls, Happening)]
