"""Collisions are taken as elastic."""

from sim2reason.questions.simplifications import simplification
from sim2reason.questions.simplifications.parts.restitution import OneRestitution


@simplification
class ElasticCollisions(OneRestitution):
    """Collisions are taken as elastic."""

    name = "elastic collisions"
    reason = "every collision is taken as elastic"
    restitution = 1.0
    common = True
