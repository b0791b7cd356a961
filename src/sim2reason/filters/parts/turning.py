"""Whether a law of motion and a law of turning hold together."""

from dataclasses import replace

from sim2reason.dsl.ablation import with_bodies
from sim2reason.dsl.mechanism import Mechanism, RigidBody
from sim2reason.filters import Candidate
from sim2reason.filters.parts.effects import effects_of
from sim2reason.questions.simplifications import SIMPLIFICATIONS
from sim2reason.questions.simplifications.omissions import GravityLeftOut
from sim2reason.questions.simplifications.parts.which import solid

TURNS = "weight drives it, and bodies that turn resist it by their moments of inertia"
MORE = 1.1  # times the inertia
BEARS = 5e-3  # relative: an answer that changes by more hangs on the inertia


def turns_by_weight(candidate: Candidate) -> bool:
    """Whether weight bears on the answer, and so does the inertia with which something turns about its own centre.

    Without weight, as in L = m v R of a hoop that rolls, it may be by definition that inertia bears. And with none at
    all, what slips would roll: so a little more of it tells more than nothing.
    """
    if not solid(candidate.study.mechanism):
        return False
    other = candidate.study.changed("more inertia", _harder_to_turn, candidate.until)
    if candidate.change(other) <= BEARS:
        return False
    without = effects_of(SIMPLIFICATIONS[GravityLeftOut.name], candidate)
    return any(not effect.close for effect in without)


def _harder_to_turn(mechanism: Mechanism) -> Mechanism:
    return with_bodies(mechanism, solid(mechanism), _with_more)


def _with_more(body: RigidBody) -> RigidBody:
    xx, yy, zz, xy, xz, yz = (MORE * part for part in body.inertia)
    return replace(body, inertia=(xx, yy, zz, xy, xz, yz))
