"""The bounce after which a body no longer rises to a stated height above the ground."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from sim2reason.quantities.height import Height
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.bounced import GROUND, Bounced, struck
from sim2reason.questions.moments.parts.distance import DistanceThreshold
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.moments.top_after_bounce import TopAfterBounce
from sim2reason.questions.spoken import round_number
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace

LOW, HIGH = 1.1, 1.6  # times the height of the top after the first bounce
MOST = 200  # bounces that are looked at


@MOMENTS.register("stayed_below")
@dataclass(frozen=True, slots=True)
class StayedBelow(DistanceThreshold):
    """The first bounce after which a body does not rise as high above the ground as a stated height."""

    label = "bounce to less than a height"
    event = True
    drawn_by_recipes = False
    verb = Verb("no longer rises as high as", "no longer rise as high as")

    @classmethod
    def found(cls, study: Study, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Return one for each body, with a height that it no longer reaches after one of its bounces."""
        drawn = ((name, cls.drawn(name, study.trace, rng)) for name in cls.candidates(words))
        moments = [cls(name, height) for name, height in drawn if height is not None]
        return [moment for moment in moments if study.time(moment) is not None]

    @classmethod
    def drawn(cls, name: str, trace: Trace, rng: np.random.Generator) -> float | None:
        """Return more than the height of the top after the first bounce; None if there is no such top."""
        top = TopAfterBounce(name).time(trace)
        if not top:
            return None
        height = float(Height.evaluate(trace.at(top), name)[0])
        return round_number(rng.uniform(LOW, HIGH) * height, LOW * height, HIGH * height)

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the phrases of the bodies that bounce off the ground."""
        return {name: said for name, said in words.called(cls.of).items() if struck(words, name) == GROUND}

    @property
    def channels(self) -> tuple[Channel, ...]:
        """Return the one channel on which the moment depends: the height above the ground."""
        return (Channel(self.name, Height.name),)

    def time(self, trace: Trace) -> float | None:
        """Return when the body bounces for the first time without rising to the height afterwards, s."""
        for number in range(1, MOST):
            top = TopAfterBounce(self.name, number).time(trace)
            if top is None:
                return None
            if float(Height.evaluate(trace.at(top), self.name)[0]) < self.value:
                return Bounced(self.name, number).time(trace)
        return None

    def does(self, words: Words) -> Verb:
        """Return the verb with the height, as in *no longer rises as high as 1.0 m*."""
        return Verb(f"{self.verb.told} {self.said(words)}", f"{self.verb.asked} {self.said(words)}")
