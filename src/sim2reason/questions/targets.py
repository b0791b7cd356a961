"""What can be asked about in a scene: quantities of their subjects, each with its words."""

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import groupby

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import State
from sim2reason.quantities import QUANTITIES, Quantity, ordered
from sim2reason.quantities.subjects import Sense
from sim2reason.questions.words import Words


@dataclass(frozen=True, slots=True)
class Target:
    """A quantity of a subject: a magnitude, or the component along a sense."""

    quantity: str
    subject: str
    sense: Sense | None = None

    @property
    def unit(self) -> str:
        """The unit of the answer."""
        return QUANTITIES[self.quantity].unit

    @property
    def signed(self) -> bool:
        """Whether a minus sign can be right."""
        return self.sense is not None

    def value(self, state: State) -> float:
        """The value at the first instant of a state."""
        found = QUANTITIES[self.quantity].evaluate(state, self.subject)[0]
        if np.ndim(found) == 0:
            return float(found) if self.signed else abs(float(found))
        if self.sense is None:
            return float(np.linalg.norm(found))
        return float(np.dot(found, self.sense.vector))


@dataclass(frozen=True, slots=True)
class Noun:
    """How a question calls a target: a noun phrase, and where English has one a question of its own.

    `how` keeps its placeholder ``{when}``.
    """

    phrase: str
    how: str = ""

    def heard(self, text: str) -> bool:
        """Whether a sentence can ask for it."""
        return self.phrase in text or (self.how != "" and self.how.partition("{when}")[0].lower() in text.lower())


Targets = Mapping[Target, Noun]


def targets(mechanism: Mechanism, words: Words) -> Targets:
    """Everything that can be asked about, with its words; what they would not tell apart is left out."""
    offered = list(_phrased(mechanism, words))
    count = Counter(noun.phrase for _, noun in offered)
    return {target: noun for target, noun in offered if count[noun.phrase] == 1}


def _phrased(mechanism: Mechanism, words: Words) -> Iterator[tuple[Target, Noun]]:
    for subject, members in groupby(ordered(), key=lambda quantity: quantity.of):
        quantities = list(members)
        for name, phrase in subject.phrases(mechanism, words.mentions).items():
            asked = [quantity for quantity in quantities if _askable(quantity, mechanism, name, words)]
            yield from _of_subject(asked, mechanism, name, phrase)


def _askable(quantity: Quantity, mechanism: Mechanism, name: str, words: Words) -> bool:
    """Whether a subject has a quantity, and the text gives all that this needs."""
    given = (quantity.of.gives(need, mechanism, name, words.said) for need in quantity.needs)
    return quantity.present(mechanism, name) and all(given)


def _of_subject(asked: list[Quantity], mechanism: Mechanism, name: str, phrase: str) -> Iterator[tuple[Target, Noun]]:
    """Magnitudes, then components along each sense, then what has a sense of its own."""
    for quantity in asked:
        if quantity.magnitude:
            ground = _ground(quantity, mechanism, name)
            how = _filled(quantity.how, quantity, phrase, ground=ground, when="{when}")
            yield Target(quantity.name, name), Noun(_filled(quantity.magnitude, quantity, phrase) + ground, how)
    signed = [quantity for quantity in asked if quantity.signed]
    senses = signed[0].of.senses(mechanism, name) if signed else []
    along = [(sense, quantity) for sense in senses for quantity in signed if quantity.sense is None]
    own = [(quantity.sense, quantity) for quantity in signed if quantity.sense is not None]
    for sense, quantity in [*along, *own]:
        component = f"{sense.axis} component of the " if sense.axis else ""
        said = _filled(quantity.signed, quantity, phrase, component=component)
        yield Target(quantity.name, name, sense), Noun(said + _ground(quantity, mechanism, name))


def _filled(template: str, quantity: Quantity, phrase: str, **others: str) -> str:
    return template.format(**{quantity.of.slot: phrase, **others})


def _ground(quantity: Quantity, mechanism: Mechanism, name: str) -> str:
    return quantity.of.ground(mechanism, name) if quantity.grounded else ""
