"""Check of worked solutions."""

from collections.abc import Iterator

import numpy as np

from sim2reason.errors import Sim2ReasonError
from sim2reason.questions import KINDS
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.structure import changing
from sim2reason.solutions import ProblemContext, solve
from sim2reason.testing.checks import Check, check
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import Specimen, Specimens

TRIES = 3  # questions about one scene


@check
class SolutionsCheck(Check):
    """Check that some question about an entity with constant forces has a worked solution in formulas."""

    name = "solutions"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Yield a finding if no question about scenes with constant forces has a worked solution."""
        steady = [found for found in specimens.moving if _is_pushed(found.scene.mechanism)]
        reasons = [reason for found in steady for reason in _reasons(found)]
        if steady and reasons and "" not in reasons:
            yield steady[0].finding(
                self.name,
                "constant forces lead to worked solutions by formulas",
                f"none of {len(reasons)} questions has one, such as: {reasons[0]}",
                "let build take numbers that lines tell, sines and cosines of angles among them, and products of these",
            )


def _is_pushed(mechanism: Mechanism) -> bool:
    """Return whether only constant forces act, among them some not due to strings, springs or faces."""
    return bool(mechanism.forces) and not changing(mechanism)


def _reasons(found: Specimen) -> Iterator[str]:
    """Yield the reason why each question drawn about a scene has no worked solution; empty if the question has one."""
    kind = KINDS["state"]
    for number in range(TRIES):
        query = kind.draw(found.study, found.words, found.targets, np.random.default_rng([found.seed, number]))
        answer = kind.answer(query, found.study) if query is not None else None
        if query is None or not answer:
            continue
        setting = ProblemContext(found.scene, found.words, found.description.symbols, found.study, query)
        try:
            yield solve(setting, derived=True).reason
        except Sim2ReasonError as error:
            yield str(error)
