"""On which side of its axle an arm has its centre of mass that carries something on both."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

from sim2reason.dsl.vectors import inner
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.swinging_lines import (
    carries_on_both_sides,
    is_light_rod,
    load_center,
    welded_to,
)
from sim2reason.questions.regimes import REGIMES, Regime
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words


@REGIMES.register("side_of_center_of_mass")
@dataclass(frozen=True, slots=True)
class SideOfCenterOfMass(Regime):
    """The first body on a light arm is on the side on which the centre of mass of all of them is, or on the other."""

    of = Bodies()
    stage = 0

    same: bool

    @classmethod
    def possible(cls, study: Study, words: Words) -> Sequence[Self]:
        """Of arms that carry something on both sides of the axle."""
        mechanism, named = study.mechanism, words.called(cls.of)
        rods = [body.name for body in mechanism.bodies if is_light_rod(body)]
        firsts = [welded_to(mechanism, rod)[0].name for rod in rods if carries_on_both_sides(mechanism, rod)]
        return [cls(name, same) for name in firsts if name in named for same in (True, False)]

    def holds(self, study: Study, until: float) -> bool:
        """Whether it is so in another motion."""
        del until
        body = study.mechanism.body[self.name]
        side = inner(load_center(study.mechanism, study.mechanism.body[body.parent or ""]), body.at)
        return side > 0.0 if self.same else side < 0.0

    def clause(self, words: Words) -> str:
        """As in: the centre of mass of all that turns is on the same side of the axle as disc A."""
        where = "on the same side of the axle as" if self.same else "on the side of the axle opposite to"
        return f"the centre of mass of all that turns is {where} {words.called(self.of)[self.name]}"
