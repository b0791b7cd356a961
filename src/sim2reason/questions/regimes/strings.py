"""Assumptions about taut strings."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf
from typing import Self

import numpy as np

from sim2reason.questions.regimes import REGIMES, Regime
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import ConstantTension, Elastic, Mechanism
from sim2reason.simulation.quantities.subjects.interactions import Strings

ZERO_TENSION = 1e-9  # N


def is_driven(mechanism: Mechanism) -> bool:
    """Return whether a spring or a hand drives the mechanism."""
    return any(isinstance(line.law, Elastic | ConstantTension) for line in mechanism.lines)


@REGIMES.register("taut")
@dataclass(frozen=True, slots=True)
class StaysTaut(Regime):
    """The assumption that a string stays taut."""

    of = Strings()
    unseen = True

    @classmethod
    def possible(cls, study: SimulatedScene, words: Words) -> Sequence[Self]:
        """Return one regime for each string that the text can name."""
        del study
        return [cls(name) for name in words.subject_phrases(cls.of)]

    def holds(self, study: SimulatedScene, until: float) -> bool:
        """Return whether the string pulls throughout; True if its tension is undetermined."""
        scan = study.trace.scan
        return not bool((scan.tension[self.name][scan.times <= until] <= ZERO_TENSION).any())

    def never_holds(self, study: SimulatedScene) -> bool:
        """Return whether the string does not pull at the start."""
        return bool(study.trace.at(0.0).tension[self.name][0] <= ZERO_TENSION)

    def margin(self, study: SimulatedScene, until: float) -> float | None:
        """Return the least tension as a relative acceleration of the string's ends, in units of g; None if unknown."""
        scan, mechanism = study.trace.scan, study.mechanism
        through = mechanism.line[self.name].through
        bodies = (mechanism.site[site].body for site in (through[0], through[-1]))
        masses = [mechanism.body[name].mass for name in bodies if name is not None]
        ease = sum(1.0 / mass for mass in masses if mass) or 1.0
        tensions = scan.tension[self.name][scan.times <= until]
        if np.isnan(tensions).any():
            return None
        return ease * float(tensions.min()) / (float(np.linalg.norm(mechanism.gravity)) or 1.0)

    def must_be_stated(self, study: SimulatedScene) -> bool:
        """Return True if the text mentions slackness, or the string is alone beside a spring or a hand.

        Springs and hands may drive one end faster than the load at the other can follow.
        """
        owner = self.name.partition(".")[0]
        slackens = any(named.entity.slackens for named in study.scene.entities if named.name == owner)
        return slackens or (is_driven(study.mechanism) and len(study.mechanism.strings) == 1)

    def may_remove_answer(self, study: SimulatedScene) -> bool:
        """Return whether the string goes slack."""
        return not self.holds(study, inf)

    def clause(self, words: Words) -> str:
        """Return the clause, such as *the string stays taut*."""
        return f"{words.subject_phrases(self.of)[self.name]} stays taut"


@REGIMES.register("all_taut")
@dataclass(frozen=True, slots=True)
class AllStayTaut(Regime):
    """The assumption that all of several strings stay taut."""

    of = Strings()

    @classmethod
    def possible(cls, study: SimulatedScene, words: Words) -> Sequence[Self]:
        """Return the only regime of this class if there are several strings, not merely the parts of a single one."""
        del words
        return [cls("")] if len({line.name.partition("/")[0] for line in study.mechanism.strings}) > 1 else []

    def holds(self, study: SimulatedScene, until: float) -> bool:
        """Return whether every string has tension throughout."""
        return all(StaysTaut(line.name).holds(study, until) for line in study.mechanism.strings)

    def never_holds(self, study: SimulatedScene) -> bool:
        """Return whether some string does not pull at the start."""
        return any(StaysTaut(line.name).never_holds(study) for line in study.mechanism.strings)

    def must_be_stated(self, study: SimulatedScene) -> bool:
        """Return True if a spring or a hand may pull one end faster than loads can follow."""
        return is_driven(study.mechanism)

    def may_remove_answer(self, study: SimulatedScene) -> bool:
        """Return whether any string goes slack."""
        return not self.holds(study, inf)

    def clause(self, words: Words) -> str:
        """Return the clause, such as *all strings stay taut*."""
        del words
        return "all strings stay taut"
