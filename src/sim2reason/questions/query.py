"""Queries, the language-independent form of questions, and the targets that a scene offers."""

import re
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import groupby

import numpy as np

from sim2reason.errors import TextError
from sim2reason.questions.moments import Moment
from sim2reason.questions.structured import StructuredQuestion, resolve_name, sense_named
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array, State, row_lengths
from sim2reason.scenes.dsl.vectors import Vector
from sim2reason.simulation.quantities import QUANTITIES, Quantity, ordered
from sim2reason.simulation.quantities.subjects import Sense
from sim2reason.simulation.quantities.subjects.bodies import (
    Bodies,
    TurningBodies,
    ancestor_chain,
    center_path,
    turning_axes,
)

OWN_PATH, OWN_AXLE = "its path", "its axle"
"""Directions that the text need not name: of the line along which a body moves, of the axle about which it turns."""
_SIZE = re.compile(r"the (?:magnitude of the )?([a-z ]+) (?:of|in) \{")  # as in: the speed of {body}


@dataclass(frozen=True, slots=True)
class Target:
    """A quantity of a subject: a magnitude, or the component along a direction."""

    quantity: str
    subject: str
    sense: Sense | None = None
    share: float = field(default=1.0, compare=False)  # how often it is drawn, compared with others of its quantity

    @property
    def unit(self) -> str:
        """Return the unit of the quantity."""
        return QUANTITIES[self.quantity].unit

    @property
    def signed(self) -> bool:
        """Return whether the value may be negative."""
        return self.sense is not None

    def value(self, state: State) -> float:
        """Return the value at the first instant of a state, in SI units."""
        return float(self.values(state)[0])

    def values(self, state: State) -> Array:
        """Return the values at all instants of a state, in SI units, (n,)."""
        found = QUANTITIES[self.quantity].evaluate(state, self.subject)
        if found.ndim == 1:
            return found if self.signed else np.abs(found)
        return row_lengths(found) if self.sense is None else found @ np.array(self.direction(state.mechanism))

    def direction(self, mechanism: Mechanism) -> Vector:
        """Return the direction of the component in this mechanism, whose slopes may differ from the original one."""
        assert self.sense is not None
        quantity = QUANTITIES[self.quantity]
        if quantity.sense is not None:
            return self.sense.vector
        named = (self.sense.positive, self.sense.axis)
        here = quantity.of.senses(mechanism, self.subject)
        return next((sense.vector for sense in here if (sense.positive, sense.axis) == named), self.sense.vector)


@dataclass(frozen=True, slots=True)
class Noun:
    """The words for a target: a noun phrase and, for some, a question, a clause and a statement.

    `how` keeps its placeholder ``{when}``, and `states` keeps ``{value}``. A `timeless` target is asked for without a
    moment; a target with a phrase `interval_phrase` an interval is asked for from the start to the moment.
    """

    phrase: str
    how: str = ""
    indirect: str = ""
    timeless: bool = False
    interval_phrase: str = ""
    states: str = ""

    def occurs_in(self, text: str) -> bool:
        """Return whether a sentence may ask for the target."""
        if self.phrase in text or any(words and words in text for words in (self.indirect, self.interval_phrase)):
            return True
        subject, _, rest = self.states.partition("{value}")
        if subject and subject in text and rest in text:
            return True
        return self.how != "" and self.how.partition("{when}")[0].lower() in text.lower()


Targets = Mapping[Target, Noun]
OF_RIGID_BODY = "angular velocity", "angular acceleration"  # have one value for all that is rigidly joined


@lru_cache(maxsize=4)
def quantities_named(mechanism: Mechanism) -> Mapping[str, Quantity]:
    """Return the quantities that a mechanism has, by name and by the phrase for their magnitude, such as *speed*."""
    here = {name: quantity for name, quantity in QUANTITIES.items() if quantity.subjects(mechanism)}
    called = {match[1]: quantity for quantity in here.values() if (match := _SIZE.match(quantity.magnitude))}
    return called | here


def target_named(question: StructuredQuestion, words: Words) -> Target:
    """Return the quantity, the subject and the direction that a structured question asks for.

    TextError for a quantity, a subject or a direction that the scene does not have.
    """
    mechanism = words.mechanism
    quantity = quantities_named(mechanism)[question.find]
    called = words.subject_phrases(quantity.of)
    names = {name: called.get(name, name) for name in quantity.subjects(mechanism)}
    mentioned = {name: phrase for name, phrase in names.items() if name in called}
    if not question.of and quantity.name in OF_RIGID_BODY and len({_moving(mechanism, name) for name in names}) == 1:
        names = dict([next(iter(names.items()))])
    name = resolve_name("of", question.of, names if question.of or len(mentioned) != 1 else mentioned)
    if not _told(quantity, name, words):
        needed = ", ".join(quantity.needs)
        raise TextError(
            "find", f"the text does not give the {needed} that {quantity.name} needs", "ask for another one"
        )
    if quantity.sense is not None or not question.along:
        return Target(quantity.name, name, quantity.sense)
    senses = quantity.of.senses(mechanism, name)
    if question.along in (OWN_PATH, OWN_AXLE):
        senses = _own_line(question.along, quantity, mechanism, name)
    if not (quantity.vector or quantity.along) or not senses:
        raise TextError("along", f"{quantity.name} has no components here", "leave it out")
    return Target(quantity.name, name, sense_named("along", question.along, senses))


def _moving(mechanism: Mechanism, name: str) -> str:
    """Return the name of the body to which a body is rigidly joined, and which can move in the room or on another."""
    bodies = ancestor_chain(mechanism, name)
    return next((body.name for body in bodies if body.coordinates), bodies[-1].name)


def _own_line(along: str, quantity: Quantity, mechanism: Mechanism, name: str) -> list[Sense]:
    """Return the direction of the only line of a body's motion, or of its axle; none if it is not unique."""
    if along == OWN_AXLE and quantity.of.name == TurningBodies.name:
        axes = turning_axes(mechanism, name)
        return [Sense(OWN_AXLE, axes[0][1])] if len(axes) == 1 else []
    path = center_path(mechanism, name) if along == OWN_PATH and quantity.of.name == Bodies.name else None
    return [Sense(OWN_PATH, path.ways[0])] if path is not None and path.straight and len(path.ways) == 1 else []


@lru_cache(maxsize=4)
def targets(words: Words) -> Targets:
    """Return all targets that can be asked for, with their words; ambiguous ones are left out."""
    offered = list(_phrased(words))
    count = Counter(noun.phrase for _, noun in offered)
    return {target: noun for target, noun in offered if count[noun.phrase] == 1}


def _phrased(words: Words) -> Iterator[tuple[Target, Noun]]:
    for subject, members in groupby(ordered(), key=lambda quantity: quantity.of):
        quantities = [quantity for quantity in members if quantity.magnitude or quantity.signed]
        for name in words.subject_phrases(subject):
            yield from _of_subject(
                [quantity for quantity in quantities if _askable(quantity, name, words)], name, words
            )


def _askable(quantity: Quantity, name: str, words: Words) -> bool:
    """Return whether a subject has a quantity, and the text gives all numbers that it needs."""
    return quantity.present(words.mechanism, name) and _told(quantity, name, words)


def _told(quantity: Quantity, name: str, words: Words) -> bool:
    return all(quantity.of.gives(need, words.mechanism, name, words.stated_paths) for need in quantity.needs)


def _of_subject(quantities: list[Quantity], name: str, words: Words) -> Iterator[tuple[Target, Noun]]:
    """Yield targets of one subject: magnitudes, then components along the text's axes, then fixed directions.

    If a stated positive sense would reveal the direction, the magnitude is asked for instead.
    """
    if not quantities:
        return
    filler = _Filler(name, words)
    for quantity in quantities:
        if quantity.magnitude:
            templates = quantity.size_phrases(words.mechanism, name)
            size, how, indirect, states = (filler.of(quantity, phrase) for phrase in templates)
            noun = Noun(size, how, indirect, quantity.timeless, filler.of(quantity, quantity.over), states)
            yield Target(quantity.name, name, share=quantity.share(None, words.mechanism, name)), noun
    signed = [quantity for quantity in quantities if quantity.signed]
    senses = signed[0].of.senses(words.mechanism, name) if signed else []
    along = [(sense, q) for sense in senses for q in signed if q.sense is None and (sense.fixed or not q.magnitude)]
    own = [(quantity.sense, quantity) for quantity in signed if quantity.sense is not None]
    for sense, quantity in [*along, *own]:
        component = f"{sense.axis} component of the " if sense.axis else ""
        how = "" if quantity.magnitude else filler.of(quantity, quantity.how)
        template = quantity.signed_along(sense, words.mechanism, name)
        share = quantity.share(sense, words.mechanism, name)
        yield Target(quantity.name, name, sense, share), Noun(filler.of(quantity, template, component), how)


class _Filler:
    """A filler of the placeholders in templates for quantities of one subject."""

    def __init__(self, name: str, words: Words) -> None:
        self._name, self._words = name, words

    def of(self, quantity: Quantity, template: str, component: str = "") -> str:
        """Return a template with all placeholders except the moment filled in."""
        if not template:
            return ""
        subject, words = quantity.of, self._words
        phrase = words.subject_phrases(subject)[self._name]
        if quantity.center:
            phrase = subject.point(words.mechanism, self._name, phrase)
        fills = words.fills(subject, self._name)
        return template.format(**{subject.slot: phrase}, **fills, component=component, when="{when}", value="{value}")


@dataclass(frozen=True, slots=True)
class Query:
    """What a question asks: its kind, its target and its moment; some kinds have no target or moment."""

    kind: str
    target: Target | None = None
    moment: Moment | None = None

    @property
    def hides(self) -> str:
        """Return the address of the number that the text must leave open; by default empty."""
        return ""

    @property
    def subjects(self) -> tuple[str, ...]:
        """Return the names of all subjects of the query; by default one."""
        return (self.subject,)

    @property
    def subject(self) -> str:
        """Return the subject of the target, or else the first subject of the moment."""
        if self.target is not None:
            return self.target.subject
        return next(iter(self.moment.subjects), "") if self.moment is not None else ""
