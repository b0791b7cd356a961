"""Collisions are taken as perfectly inelastic."""

from sim2reason.questions.simplifications import simplification
from sim2reason.questions.simplifications.parts.restitution import OneRestitution


@simplification
class PerfectlyInelasticCollisions(OneRestitution):
    """Collisions are taken as perfectly inelastic."""

    name = "perfectly inelastic collisions"
    reason = "every collision is taken as perfectly inelastic"
    restitution = 0.0
