"""Whether a law of motion and a law of turning hold together."""

from sim2reason.filters import Candidate
from sim2reason.filters.parts.effects import effects
from sim2reason.questions.simplifications import SIMPLIFICATIONS
from sim2reason.questions.simplifications.gravity_left_out import GravityLeftOut
from sim2reason.questions.simplifications.point_mass import PointMass

TURNS = "weight drives it, and bodies that turn resist it by their moments of inertia"


def turns_by_weight(candidate: Candidate) -> bool:
    """Whether weight bears on the answer, and so does the inertia with which something turns about its own centre.

    Without weight, as in L = m v R of a hoop that rolls, it may be by definition that inertia bears.
    """
    point_mass, query, study = SIMPLIFICATIONS[PointMass.name], candidate.question.query, candidate.study
    if not [*point_mass.subjects(query, study)]:
        return False
    changed = {effect.simplification.name for effect in effects(candidate, part=False) if not effect.close}
    return {PointMass.name, GravityLeftOut.name} <= changed
