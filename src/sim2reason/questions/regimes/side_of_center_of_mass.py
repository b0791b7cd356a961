"""On which side of its axle an arm has its centre of mass that carries something on both."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import isclose
from typing import Self

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.vectors import inner
from sim2reason.errors import SceneError
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

SHIFTED, SAME = 1.01, 1e-9  # by what a number is multiplied to see what hangs on it; relative


@REGIMES.register("side_of_center_of_mass")
@dataclass(frozen=True, slots=True)
class SideOfCenterOfMass(Regime):
    """The first body on a light arm is on the side on which the centre of mass of all of them is, or on the other."""

    of = Bodies()
    at_start = True
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
        side = self._side(study.mechanism)
        return side > 0.0 if self.same else side < 0.0

    def _side(self, mechanism: Mechanism) -> float:
        """How far on the side of the body the centre of mass is, times the distance of the body, m²."""
        body = mechanism.body[self.name]
        return inner(load_center(mechanism, mechanism.body[body.parent or ""]), body.at)

    def regardless_of(self, study: Study, path: str) -> bool:
        """Whether a number has nothing to do with where the centre of mass is, as an angle or a speed has not."""
        value = study.scene.value(path)
        if not value:
            return False
        try:
            other = study.scene.having(path, value * SHIFTED).mechanism
        except SceneError:
            return False
        return isclose(self._side(other), self._side(study.mechanism), rel_tol=SAME)

    def clause(self, words: Words) -> str:
        """As in: the centre of mass of the bodies on the arm is on the same side of the axle as disc A."""
        where = "on the same side of the axle as" if self.same else "on the side of the axle opposite to"
        return f"the centre of mass of the bodies on the arm is {where} {words.called(self.of)[self.name]}"
