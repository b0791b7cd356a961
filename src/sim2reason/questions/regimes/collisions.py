"""Which collisions there are, and in which order."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from typing import Self

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.template import COUNT_WORDS
from sim2reason.prose.phrases import join
from sim2reason.quantities.subjects.pairs import AND, Pairs
from sim2reason.questions.moments.bounced import GROUND, WALL, struck
from sim2reason.questions.regimes import REGIMES, Regime
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words

MOST = 3  # collisions that a clause lists
ORDERS = 100  # of so many: where more are possible, shorter lists are looked at alone


@REGIMES.register("collisions")
@dataclass(frozen=True, slots=True)
class CollideInTurn(Regime):
    """Some collisions come before the moment that is asked about, in this order, and no other does."""

    of = Pairs()
    stage = 2

    order: tuple[tuple[str, ...], ...]  # the bodies of each; one body alone meets what is fixed

    @classmethod
    def possible(cls, study: Study, words: Words) -> Sequence[Self]:
        """All short lists of those for which the text has words."""
        met = [names for names in _meetings(study.mechanism) if _said(names, words)]
        lengths = [n for n in range(MOST + 1) if len(met) ** n <= ORDERS] if met else []
        return [cls("", order) for n in lengths for order in product(met, repeat=n)]

    def holds(self, study: Study, until: float) -> bool:
        """Whether just these come there."""
        came = [subjects for kind, subjects in study.trace.story(until) if kind == "collision"]
        return [*map(set, came)] == [*map(set, self.order)]

    def always_told(self, study: Study) -> bool:
        """Where more than two may meet, or two have met: symbols of places and velocities do not say who meets whom."""
        return len(_meetings(study.mechanism)) > 1 or any(len(names) > 1 for names in self.order)

    def clause(self, words: Words) -> str:
        """As in: the only collision before then is between balls A and B; it follows the question."""
        said = [_said(names, words) for names in self.order]
        if not said:
            return "there is no collision before then"
        if len(said) == 1:
            lone = words.called(Pairs()).get(AND.join(self.order[0])) if len(_meetings(words.mechanism)) == 1 else None
            return f"{lone} have collided by then" if lone else f"the only collision before then is {said[0]}"
        if len(set(said)) == 1:
            return f"there are exactly {COUNT_WORDS[len(said)]} collisions before then, each {said[0]}"
        return f"the only collisions before then are, in this order, {join(said)}"


def _meetings(mechanism: Mechanism) -> list[tuple[str, ...]]:
    """Who can meet whom, or what is fixed."""
    return list(dict.fromkeys(meeting.names for meeting in mechanism.meetings))


def _said(names: Sequence[str], words: Words) -> str:
    """Between whom a collision is; empty where the text has none, or none that tells it from another one."""
    if len(names) > 1:
        found = words.called(Pairs()).get(AND.join(names), "")
        return found and f"between {found}"
    (name,) = names
    what = struck(words, name)
    return f"between {words.mentions[name]} and {what}" if what in (GROUND, WALL) else ""
