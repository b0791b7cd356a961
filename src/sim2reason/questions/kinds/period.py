"""Questions for the period or frequency of a periodic motion or of small oscillations."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations
from math import inf, pi

import numpy as np

from sim2reason.questions.kinds import Kind, Measured, kind
from sim2reason.questions.phrasing import COUNTS, PeriodQuery, attracted_by, moving_body_phrases, noun_of, sentences
from sim2reason.questions.query import Noun, Query, Targets
from sim2reason.questions.recurrence import Repetition
from sim2reason.questions.structured import EQUILIBRIUM, StructuredQuestion, resolve_name
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Elastic, Mechanism
from sim2reason.simulation.certify import Certificate
from sim2reason.simulation.equilibrium import equilibrium, steady, unique_equilibrium
from sim2reason.simulation.oscillation import Oscillations, agree_at_rest, mode_disagreement, oscillations
from sim2reason.simulation.quantities.subjects.bodies import TurningBodies, is_pulley_wheel
from sim2reason.simulation.quantities.subjects.interactions import pair
from sim2reason.simulation.trace import Channel

MEASURES = {
    "period": Measured("period", "s", least=1e-2),
    "frequency": Measured("frequency", "Hz", least=1e-2),
    "angular frequency": Measured("angular frequency", "rad/s", least=1e-2),
}
PENDULUM = "equivalent pendulum length"
PEOPLE = {PENDULUM: Measured("length of a simple pendulum of the same period", "m", least=1e-3)}
"""Measures that recipes never ask for: the length of the simple pendulum whose small swings have the same period."""
MEASURE_WEIGHTS = (0.6, 0.25, 0.15)
EVEN = 0.5
MAX_MODES = 3  # modes: with more, no frequency can be found on paper
MIN_MODE_SEPARATION = 0.05  # relative: least difference between distinguishable modes
BEYOND, WITHIN = 0.06, 1e-3  # relative: the period of small oscillations differs from, or equals, that of a large one


@kind
class PeriodKind(Kind):
    """The kind that asks for the period of a periodic motion, or of small oscillations about equilibrium."""

    name = "period"
    share = 0.35  # as often as a velocity, where it exists
    awaited = True

    def of_motion(self, query: Query) -> bool:
        """Return whether the answer depends on the initial motion: true unless small oscillations are asked about."""
        assert isinstance(query, PeriodQuery)
        return not query.small

    def draw(self, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Return a query for the period of the motion or of small oscillations; the latter only if the two differ."""
        del targets
        motion = self._repeating(study, words, rng)
        if motion is not None and _period_discrepancy(study.mechanism, self.time(motion, study) or 0.0) <= WITHIN:
            return motion
        small = self._small(study, words, rng)
        return motion if small is None or (motion is not None and rng.random() < EVEN) else small

    def _small(self, study: SimulatedScene, words: Words, rng: np.random.Generator) -> PeriodQuery | None:
        """Return a query for small oscillations about a stable equilibrium with few modes; None without one.

        `doubt` refuses them where there is another one: to look for that takes longer than all else here.
        """
        mechanism = study.mechanism
        if _is_simple_pendulum(mechanism):
            return None  # two numbers of the text, and a formula that everybody knows
        modes, rest = _modes(mechanism), equilibrium(mechanism)
        if modes is None or rest is None or len(modes.frequencies) > MAX_MODES:
            return None
        of, count = _oscillating(words, free=rest.free > 0), len(modes.frequencies)
        gaps = np.diff(modes.frequencies) / modes.frequencies[1:]
        plain = rest.linear or count == 1 or len(mechanism.lines) <= count
        if of is None or not plain or (count > 1 and float(gaps.min()) < MIN_MODE_SEPARATION):
            return None
        rank = int(rng.integers(2)) * (count - 1)
        stable = not rest.linear and len(of) < 2  # of two against each other no place is told
        small = PeriodQuery(self.name, None, None, _measure(words, rng), small=True, stable=stable)
        return replace(small, of=of, rank=rank, modes=count)

    def _repeating(self, study: SimulatedScene, words: Words, rng: np.random.Generator) -> PeriodQuery | None:
        """Return a query for a periodic motion whose period is not nearly that of small oscillations; else None."""
        names = list(moving_body_phrases(words)) if steady(study.mechanism) else []
        heavy = [name for name in names if study.mechanism.body[name].mass]
        names = heavy if len(heavy) == 1 else names
        rng.shuffle(names)
        for name in names:
            time = study.time(Repetition(name))
            if time is None or WITHIN < _period_discrepancy(study.mechanism, time) < BEYOND:
                continue
            measure = "period" if attracted_by(words.mechanism, name) else _measure(words, rng, 2)
            return PeriodQuery(self.name, None, None, measure, of=(name,))
        return None

    def answer(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the period or frequency of the motion or, from the mechanism alone, of small oscillations."""
        assert isinstance(query, PeriodQuery)
        if query.small:
            modes = _modes(study.mechanism)
            if modes is None or len(modes.frequencies) != query.modes:
                return None
            period = 2.0 * pi / float(modes.frequencies[query.rank])
        else:
            result = self.time(query, study)
            if result is None:
                return None
            period = result
        length = float(np.linalg.norm(study.mechanism.gravity)) * (period / (2.0 * pi)) ** 2
        result = {"period": period, "frequency": 1.0 / period, "angular frequency": 2.0 * pi / period}
        return {**result, PENDULUM: length or None}[query.measure]

    def time(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the end of the first period, s; zero for small oscillations, which do not depend on the motion."""
        assert isinstance(query, PeriodQuery)
        return 0.0 if query.small else study.time(Repetition(query.of[0]))

    def late_answer(self, query: Query) -> float | None:
        """Return inf for a period, the limit near motions that take forever, as to the top of a pendulum's circle."""
        assert isinstance(query, PeriodQuery)
        if query.small:
            return None
        return inf if query.measure == "period" else 0.0

    def channels(self, query: Query) -> tuple[Channel, ...]:
        """Return the channels of the moving body's displacement and velocity; none for small oscillations."""
        assert isinstance(query, PeriodQuery)
        return () if query.small else (Channel(query.of[0], "displacement"), Channel(query.of[0], "velocity"))

    def doubt(self, query: Query, study: SimulatedScene, certificate: Certificate | None) -> str:
        """Return why small oscillations are not certified: another equilibrium, or a different period in one engine."""
        assert isinstance(query, PeriodQuery)
        if not query.small:
            return Kind.doubt(self, query, study, certificate)
        modes, rest = _modes(study.mechanism), unique_equilibrium(study.mechanism)
        if rest is None or modes is None:
            return "there is no oscillation, or another equilibrium"
        return mode_disagreement(rest, modes, query.rank)

    def measured(self, query: Query) -> Measured:
        """Return the unit and least value of the period, frequency, angular frequency or length asked for."""
        assert isinstance(query, PeriodQuery)
        return {**MEASURES, **PEOPLE}[query.measure]

    def indifferent(self, query: Query, study: SimulatedScene, other: SimulatedScene) -> bool:
        """Return whether the scenes differ only in the initial motion and in numbers that shift the equilibrium."""
        del query
        return agree_at_rest(study.mechanism, other.mechanism, ("inertia", "stiffness"))

    def shapes(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return sentences such as *find the period of small oscillations of the block about its equilibrium*."""
        del noun
        assert isinstance(query, PeriodQuery)
        return sentences(query, words) if query.measure in MEASURES else ()

    def noun_phrases(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return noun phrases such as *the period of small oscillations of the block about its equilibrium*."""
        del noun
        assert isinstance(query, PeriodQuery)
        return (noun_of(query, words),)

    def finds(self, words: Words) -> tuple[str, ...]:
        """Return the names of the measures: period, frequency, angular frequency, and a length where there is g."""
        return (*MEASURES, *(PEOPLE if any(words.mechanism.gravity) else ()))

    def posed(self, asked: StructuredQuestion, study: SimulatedScene, words: Words) -> Query | None:
        """Return the query for the period of the motion, or of the slowest small oscillation about equilibrium."""
        if asked.when == EQUILIBRIUM:
            modes = _modes(study.mechanism)
            count = len(modes.frequencies) if modes is not None else 1
            return PeriodQuery(self.name, None, None, asked.find, small=True, modes=count, of=self._of(asked, words))
        return PeriodQuery(
            self.name, None, None, asked.find, of=(resolve_name("of", asked.of, moving_body_phrases(words)),)
        )

    @staticmethod
    def _of(asked: StructuredQuestion, words: Words) -> tuple[str, ...]:
        return (resolve_name("of", asked.of, moving_body_phrases(words)),) if asked.of else ()

    def parsed(self, text: str, study: SimulatedScene, words: Words, targets: Targets) -> Iterator[Query]:
        """Yield a query for every measure and mode of every body that a sentence names."""
        del study, targets
        if not any(word in text for word in ("period", "frequenc", "scillation", "revolution", "repeat")):
            return
        called = moving_body_phrases(words)
        named = [name for name, phrase in called.items() if phrase in text]
        pairs = [two for two in combinations(called, 2) if pair(called[two[0]], called[two[1]]) in text]
        groups: list[tuple[str, ...]] = [(), *((name,) for name in named), *pairs]
        for measure in MEASURES:
            yield from (PeriodQuery(self.name, None, None, measure, of=(name,)) for name in named)
            for stable in (False, True):
                small = PeriodQuery(self.name, None, None, measure, small=True, stable=stable)
                yield from (replace(small, of=of) for of in groups)
                yield from (replace(small, rank=rank, modes=n) for n in COUNTS for rank in (0, n - 1))


def _modes(mechanism: Mechanism) -> Oscillations | None:
    rest = equilibrium(mechanism)
    modes = oscillations(rest) if rest is not None else None
    return modes if modes is not None and len(modes.frequencies) else None


def _measure(words: Words, rng: np.random.Generator, count: int = 3) -> str:
    """Return *period*, *frequency* or another measure at random, by weight; always *period* if times are in years."""
    names, shares = list(MEASURES)[:count], np.array(MEASURE_WEIGHTS[:count])
    return str(rng.choice(names, p=shares / shares.sum())) if words.units.time == "s" else "period"


def _oscillating(words: Words, *, free: bool) -> tuple[str, ...] | None:
    """Return the bodies to which small oscillations are attributed: one, two or, as empty, all; None if unclear."""
    mechanism = words.mechanism
    heavy = tuple(n for n in moving_body_phrases(words) if mechanism.body[n].mass and not is_pulley_wheel(mechanism, n))
    if free:
        return heavy if len(heavy) == 2 else None
    if len(heavy) == 1:
        return heavy
    arms = tuple(n for n in words.subject_phrases(TurningBodies()) if mechanism.body[n].mass == 0.0)
    return arms if len(arms) == len(mechanism.coordinates) == 1 else ()


def _is_simple_pendulum(mechanism: Mechanism) -> bool:
    heavy = [body for body in mechanism.bodies if body.mass > 0.0]
    springs = any(isinstance(line.law, Elastic) for line in mechanism.lines)
    return len(heavy) == 1 and not (any(heavy[0].inertia) or springs or mechanism.forces or mechanism.faces)


def _period_discrepancy(mechanism: Mechanism, period: float) -> float:
    """Return the relative difference of a period from that of small oscillations; 1 unless these have a single mode."""
    modes = _modes(mechanism)
    if modes is None or len(modes.frequencies) != 1:
        return 1.0
    return abs(period * float(modes.frequencies[0]) / (2.0 * pi) - 1.0)
