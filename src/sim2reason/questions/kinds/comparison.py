"""Questions for the ratio or difference of an answer if a number is multiplied by two, three or one half."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import product
from math import log

import numpy as np

from sim2reason.errors import TextError
from sim2reason.questions.accuracy import CLEAR_ERROR_FACTOR, TOLERANCE
from sim2reason.questions.kinds import KINDS, Measured, kind
from sim2reason.questions.kinds.nested import (
    NestedKind,
    NestedQuery,
    inner_of,
    usable_answer,
    variant_certification_gap,
    without_target_and_moment,
)
from sim2reason.questions.query import Noun, Query, Targets, targets
from sim2reason.questions.structured import CHANGE, StructuredQuestion, one_of, parse_amount, resolve_name
from sim2reason.questions.study import SimulatedScene, change_directions
from sim2reason.questions.unknown import is_usual
from sim2reason.questions.words import Words
from sim2reason.simulation.certify import Certificate

GERUNDS: Mapping[float, str] = {2.0: "doubling", 0.5: "halving", 3.0: "tripling"}
FACTOR_WEIGHTS = (0.6, 0.25, 0.15)
RATIO = "the ratio of the new value to the original value of"
RATIO_SHARE = 0.85  # of comparisons: the share that asks for a ratio, not a difference
MIN_RELATIVE_CHANGE = 0.1  # relative: least change of the answer
SIMPLE_POWERS = (-2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0)
"""Of the factor of a number: what somebody guesses by mere proportionality must not be the answer."""


@dataclass(frozen=True, slots=True)
class ComparisonQuery(NestedQuery):
    """A query for the change of another query's answer if one number of the scene is multiplied by a factor.

    It is the ratio of the new answer to the original one, or how much larger the greater of them is.
    """

    factor: float = 2.0
    ratio: bool = True
    grows: bool = True

    def others(self, study: SimulatedScene) -> list[SimulatedScene | None]:
        """Return a list of one motion, that with the changed number; its element is None if there is no such motion."""
        return [self.changed(study)]

    def changed(self, study: SimulatedScene) -> SimulatedScene | None:
        """Return the motion with the number multiplied by the factor; None if there is none."""
        return study.with_same_change({self.path: self.factor * float(study.scene.value(self.path))})


@kind
class ComparisonKind(NestedKind):
    """The kind that asks for the ratio or difference of an answer if a number is doubled, halved or tripled."""

    name = "comparison"
    share = 0.04

    def _compose_query(self, inner: Query, path: str, study: SimulatedScene, rng: np.random.Generator) -> Query | None:
        """Return a comparison whose answer no simple proportionality gives, with equal courses of events; else None."""
        factor = list(GERUNDS)[int(rng.choice(len(FACTOR_WEIGHTS), p=FACTOR_WEIGHTS))]
        query = ComparisonQuery(self.name, inner.target, inner.moment, without_target_and_moment(inner), path, factor)
        query = replace(query, ratio=bool(rng.random() < RATIO_SHARE))
        if not is_usual(study.scene, path, factor * float(study.scene.value(path))):
            return None
        other = query.changed(study)
        before, after = usable_answer(inner, study), usable_answer(inner, other)
        if other is None or before is None or after is None or min(before, after) <= _least(inner):
            return None
        if _is_guessed(after / before, factor) or _event_course(inner, study) != _event_course(inner, other):
            return None
        return replace(query, grows=query.ratio or after > before)

    def answer(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the ratio of the new answer to the original one, or their difference."""
        return _comparison_answer(query, study, loosely=False)

    def loose_answer(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the ratio or difference, computed also from answers that no question asks for."""
        return _comparison_answer(query, study, loosely=True)

    def time(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the time, s, by which both answers are determined; None if one never is."""
        assert isinstance(query, ComparisonQuery)
        other, inner = query.changed(study), query.inner
        times = [
            KINDS[inner.kind].time(inner, simulated) if simulated is not None else None for simulated in (study, other)
        ]
        known = [time for time in times if time is not None]
        return max(known) if len(known) == len(times) else None

    def doubt(self, query: Query, study: SimulatedScene, certificate: Certificate | None) -> str:
        """Return why the answer before or after the change of the number is not certified; empty if both are."""
        assert isinstance(query, ComparisonQuery)
        inner = query.inner
        reason = KINDS[inner.kind].doubt(inner, study, certificate)
        other = query.changed(study)
        if reason or other is None:
            return reason or "there is no motion with the other value"
        return variant_certification_gap(inner, other)

    def measured(self, query: Query) -> Measured:
        """Return the unit and least value of a ratio, or of a difference in the unit of the compared answers."""
        assert isinstance(query, ComparisonQuery)
        if query.ratio:
            return Measured("ratio", "", least=1e-2)
        inner_measure = KINDS[query.inner.kind].measured(query.inner)
        return Measured("difference", inner_measure.unit, inner_measure.least)

    def shapes(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return sentences such as *by what factor would doubling the mass of A multiply the speed of B?*."""
        assert isinstance(query, ComparisonQuery)
        number = words.named.get(query.path)
        if number is None or query.factor not in GERUNDS:
            return ()
        forms = _ratio_forms(query, number) if query.ratio else _difference_forms(query, number)
        return tuple(form.format(name) for form, name in product(forms, self.names(query, words, noun)))

    def former_sentences(self, query: Query, words: Words) -> tuple[str, ...]:
        """Return sentences such as *what would be the ratio of the new value to the original value of …*."""
        assert isinstance(query, ComparisonQuery)
        number = words.named.get(query.path)
        if number is None or not query.ratio or query.factor not in GERUNDS:
            return ()
        noun = targets(words)[query.target] if query.target is not None else None
        changed = f"{number} were {_factor_participle(query.factor)}"
        return tuple(f"what would be {RATIO} {name}, if {changed}?" for name in self.names(query, words, noun))

    def noun_phrases(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return noun phrases such as *the factor by which doubling the mass of A would multiply the speed of B*."""
        assert isinstance(query, ComparisonQuery)
        number = words.named.get(query.path)
        if number is None or not query.ratio or query.factor not in GERUNDS:
            return ()
        names = self.names(query, words, noun)
        return tuple(f"the factor by which {GERUNDS[query.factor]} {number} would multiply {name}" for name in names)

    def statements(self, query: Query, words: Words, noun: Noun | None, value: str) -> tuple[str, ...]:
        """Return statements such as *doubling the mass of A would multiply the speed of B by 1.4*."""
        assert isinstance(query, ComparisonQuery)
        number = words.named.get(query.path)
        if number is None or not query.ratio or query.factor not in GERUNDS:
            return ()
        changing = f"{GERUNDS[query.factor]} {number}"
        return tuple(f"{changing} would multiply {name} by {value}" for name in self.names(query, words, noun))

    def parsed(self, text: str, study: SimulatedScene, words: Words, targets: Targets) -> Iterator[Query]:
        """Yield a query for every change of a number that a sentence names, with every inner question."""
        changes = [
            (path, factor, ratio, grows)
            for path, number in words.named.items()
            for factor, gerund in GERUNDS.items()
            if f"{gerund} {number}" in text or f"{number} were {_factor_participle(factor)}" in text
            for ratio, grows in ((True, True), (False, True), (False, False))
        ]
        if not changes:
            return
        for inner in self.inner_parsed(text, study, words, targets):
            for path, factor, ratio, grows in changes:
                yield ComparisonQuery(
                    self.name, inner.target, inner.moment, without_target_and_moment(inner), path, factor, ratio, grows
                )


def build_comparison(
    inner: Query, question: StructuredQuestion, study: SimulatedScene, words: Words
) -> ComparisonQuery:
    """Return the query for an answer's change with a number, as in *ramp.speed = 5 m/s* or *ramp.speed × 2*.

    TextError if the change names no number of the scene, or has no value for the number.
    """
    change = CHANGE.fullmatch(question.change)
    if change is None:
        raise TextError("change", f"{question.change!r} changes nothing", "say how, such as: ramp.speed = 5 m/s")
    parameters = {p.path: p for p in study.scene.parameters if p.value}
    path = resolve_name("change", change["number"], {path: words.named.get(path, path) for path in parameters})
    factor = parse_amount("change", change["value"], parameters[path].measure.unit if change["sign"] == "=" else "")
    factor /= float(parameters[path].value or 0.0) if change["sign"] == "=" else 1.0
    ratio = one_of("compare", question.compare or "ratio", ("ratio", "difference")) == "ratio"
    return ComparisonQuery(
        "comparison", inner.target, inner.moment, without_target_and_moment(inner), path, factor, ratio
    )


def _ratio_forms(query: ComparisonQuery, number: str) -> tuple[str, ...]:
    """Return the sentences for a ratio, with a placeholder for the compared answer."""
    changing, changed = f"{GERUNDS[query.factor]} {number}", f"{number} were {_factor_participle(query.factor)}"
    ratio = f"{RATIO} {{}}"
    return (
        f"by what factor would {changing}, and nothing else, multiply {{}}?",
        f"determine the factor by which {changing} would multiply {{}}.",
        f"by what factor would {{}} change if {changed}, all else being the same?",
        f"suppose {changed} and all else were unchanged: find {ratio}.",
    )


def _difference_forms(query: ComparisonQuery, number: str) -> tuple[str, ...]:
    """Return the sentences for a difference, with a placeholder for the compared answer."""
    changing, changed = f"{GERUNDS[query.factor]} {number}", f"{number} were {_factor_participle(query.factor)}"
    verb, change = ("increase", "increase") if query.grows else ("reduce", "decrease")
    return (
        f"by how much would {changing}, and nothing else, {verb} {{}}?",
        f"determine by how much {changing} would {verb} {{}}.",
        f"suppose {changed} and all else were unchanged: find the resulting {change} in {{}}.",
        f"what {change} in {{}} would result from {changing}?",
    )


def _factor_participle(factor: float) -> str:
    """Return the participle of a factor, such as *doubled*."""
    return f"{GERUNDS[factor].removesuffix('ing')}ed"


def _comparison_answer(query: Query, study: SimulatedScene, *, loosely: bool) -> float | None:
    assert isinstance(query, ComparisonQuery)
    inner = inner_of(query)
    before = usable_answer(inner, study, loosely=loosely)
    after = usable_answer(inner, query.changed(study), loosely=loosely) if before is not None else None
    if before is None or after is None:
        return None
    if query.ratio:
        return after / before if before else None
    return after - before if query.grows else before - after


def _least(inner: Query) -> float:
    return KINDS[inner.kind].measured(inner).least


def _event_course(inner: Query, study: SimulatedScene) -> tuple[object, ...]:
    """Return the course of events until the answer is known, and the direction of each coordinate's change."""
    time = KINDS[inner.kind].time(inner, study) or 0.0
    return study.trace.story(time), change_directions(study, time)


def _is_guessed(ratio: float, factor: float) -> bool:
    """Return whether a ratio is nearly 1 or nearly a simple power of the factor, so that it is easily guessed."""
    near = any(abs(factor**power / ratio - 1.0) <= CLEAR_ERROR_FACTOR * TOLERANCE for power in SIMPLE_POWERS)
    return near or abs(log(ratio)) < MIN_RELATIVE_CHANGE
