"""Questions for the limit of an answer as one mass becomes far larger, or far smaller, than all others."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise, product

import numpy as np

from sim2reason.questions.kinds import KINDS, Measured, kind
from sim2reason.questions.kinds.nested import (
    NestedKind,
    NestedQuery,
    inner_of,
    usable_answer,
    variant_certification_gap,
    without_target_and_moment,
)
from sim2reason.questions.query import Noun, Query, Targets
from sim2reason.questions.study import SimulatedScene, change_directions
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.structure import changing
from sim2reason.simulation.certify import Certificate

MASS_RATIO = 10.0
TIMES = tuple(3e2 * MASS_RATIO**turn for turn in range(3))
"""Of the largest mass, or parts of the smallest: where the answer is looked at. No mass may be a million kilograms."""
WITNESS_MASS_FACTOR = 1e3  # factor on the mass for the second engine
MIN_RELATIVE_CHANGE = 0.1  # relative: least difference between the limit and the answer with the actual mass
MAX_FINAL_CHANGE = 1e-2  # relative: largest change of the answer between the last two masses
WITNESS_RTOL = 0.02  # relative: largest distance from the limit in the second engine
MASS = "kg"


@dataclass(frozen=True, slots=True)
class LimitQuery(NestedQuery):
    """A query for the limit of another query's answer as the mass at an address grows without bound, or vanishes."""

    large: bool = True

    def others(self, study: SimulatedScene) -> list[SimulatedScene | None]:
        """Return the motions in which the mass is far larger, or far smaller, than all others."""
        return self.extremes(study)

    def extremes(self, study: SimulatedScene, times: Sequence[float] = TIMES) -> list[SimulatedScene | None]:
        """Return motions whose mass is the scene's greatest mass times growing factors, or the least one over these."""
        masses = [float(p.value) for p in study.scene.parameters if p.measure.unit == MASS and p.value]
        end = max(masses) if self.large else min(masses)
        return [study.with_same_change({self.path: end * by if self.large else end / by}) for by in times]


@kind
class LimitKind(NestedKind):
    """The kind that asks for the limit of an answer as one mass becomes far larger, or far smaller, than all others."""

    name = "limit"
    share = 0.06
    beyond_laws = True
    inner = ("start", "event", "time_to_event")

    def draw(self, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Return a random query; None if forces vary, as oscillations beside a huge mass are slow to integrate."""
        return None if changing(study.mechanism) else super().draw(study, words, targets, rng)

    def _draw_number_paths(self, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Iterable[str]:
        """Return the addresses of the masses in random order, if there are several."""
        masses = {p.path for p in study.scene.parameters if p.measure.unit == MASS and p.value}
        return [path for path in super()._draw_number_paths(study, words, rng) if path in masses and len(masses) > 1]

    def _compose_query(self, inner: Query, path: str, study: SimulatedScene, rng: np.random.Generator) -> Query | None:
        """Return a query with a nonzero limit that the answer approaches monotonically; None if there is none."""
        del rng
        query = LimitQuery(self.name, inner.target, inner.moment, without_target_and_moment(inner), path)
        smallest = KINDS[inner.kind].measured(inner).least
        for large in (True, False):  # without a mass most problems are others that are simpler
            query = replace(query, large=large)
            limit, here, (last,) = _limit(query, study), usable_answer(inner, study), query.extremes(study, TIMES[-1:])
            if limit is None or here is None or last is None or limit <= smallest:
                continue
            if abs(limit / here - 1.0) > MIN_RELATIVE_CHANGE and _event_course(inner, study) == _event_course(
                inner, last
            ):
                return query
        return None

    def answer(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the limit, extrapolated from motions with masses that differ by powers of ten."""
        assert isinstance(query, LimitQuery)
        return _limit(query, study)

    def time(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the time, s, by which the answer is determined in the actual motion and with the extreme mass."""
        assert isinstance(query, LimitQuery)
        inner = query.inner
        kind = KINDS[inner.kind]
        times = [
            kind.time(inner, simulated) if simulated is not None else None
            for simulated in (study, *query.extremes(study))
        ]
        known = [time for time in times if time is not None]
        return max(known) if len(known) == len(times) else None

    def doubt(self, query: Query, study: SimulatedScene, certificate: Certificate | None) -> str:
        """Return why a motion with an answer close to the limit is not certified; empty if it is."""
        assert isinstance(query, LimitQuery)
        inner, (near,) = query.inner, query.extremes(study, (WITNESS_MASS_FACTOR,))
        reason = KINDS[inner.kind].doubt(inner, study, certificate)
        limit, close = _limit(query, study), usable_answer(inner, near)
        if reason or limit is None or close is None or near is None:
            return reason or "there is no limit"
        if abs(close / limit - 1.0) > WITNESS_RTOL:
            return "the limit is approached too slowly to be seen"
        return variant_certification_gap(inner, near)

    def indifferent(self, query: Query, study: SimulatedScene, other: SimulatedScene) -> bool:
        """Return True: to find which numbers do not matter in the limit is the point of the question."""
        del query, study, other
        return True

    def measured(self, query: Query) -> Measured:
        """Return the unit and least value of the limit, which are those of the inner question's answer."""
        inner = inner_of(query)
        inner_measure = KINDS[inner.kind].measured(inner)
        return Measured("limit", inner_measure.unit, inner_measure.least)

    def shapes(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return sentences such as *what does the acceleration of A approach as the mass of B grows ever larger?*."""
        assert isinstance(query, LimitQuery)
        number = words.named.get(query.path)
        if number is None:
            return ()
        larger, grows, far = (
            ("larger and larger", "grows without bound", "far greater than")
            if query.large
            else ("smaller and smaller", "tends to zero", "negligible compared with")
        )
        forms = (
            f"what value does {{}} approach, if {number} is made {larger} and all else stays the same?",
            f"find the limit of {{}} as {number} {grows}.",
            f"determine what {{}} would be, if {number} were {far} all other masses.",
        )
        return tuple(form.format(name) for form, name in product(forms, self.names(query, words, noun)))

    def parsed(self, text: str, study: SimulatedScene, words: Words, targets: Targets) -> Iterator[Query]:
        """Yield a query for every limit of a quantity and mass that a sentence names."""
        numbers = [path for path, number in words.named.items() if f"{number} " in text]
        if not numbers or not any(phrase in text for phrase in ("approach", "limit", "all other masses")):
            return
        for inner in self.inner_parsed(text, study, words, targets):
            for path, large in product(numbers, (True, False)):
                yield LimitQuery(self.name, inner.target, inner.moment, without_target_and_moment(inner), path, large)


def _limit(query: LimitQuery, study: SimulatedScene) -> float | None:
    """Return the limit, extrapolated by a parabola in the inverse mass, or in the mass."""
    answers = [usable_answer(query.inner, other, loosely=True) for other in query.extremes(study)]
    known = [answer for answer in answers if answer is not None]
    if len(known) < len(TIMES) or abs(known[-1] - known[-2]) > MAX_FINAL_CHANGE * abs(known[-1]):
        return None
    lines = [far + (far - near) / (MASS_RATIO - 1.0) for near, far in pairwise(known)]
    return lines[1] + (lines[1] - lines[0]) / (MASS_RATIO**2 - 1.0)


def _event_course(inner: Query, study: SimulatedScene) -> tuple[object, ...]:
    """Return the course of events until the answer is known, and the directions of moving coordinates."""
    time = KINDS[inner.kind].time(inner, study) or 0.0
    return study.trace.story(time), change_directions(study, time)
