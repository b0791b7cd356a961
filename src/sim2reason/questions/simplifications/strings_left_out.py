"""Strings are left out."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.ablation import NEARLY_NOTHING, with_bodies, with_lines
from sim2reason.dsl.mechanism import ConstantTension, Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.study import Study


@simplification
class StringsLeftOut(ChangedMechanism):
    """Each body is taken to move as if it were alone, without the strings between them."""

    name = "strings left out"
    reason = "each body is taken to move as if no string held it"
    sound_if_same = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where there are strings."""
        del query
        return [""] if study.mechanism.strings else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With strings that pull at nothing; what has no mass has next to none, so that it can fall."""
        del subject
        light = [body.name for body in mechanism.bodies if not body.mass and body.coordinates]
        mass = NEARLY_NOTHING * sum(body.mass for body in mechanism.bodies)
        movable = with_bodies(mechanism, light, lambda body: replace(body, mass=mass))
        strings = (line.name for line in mechanism.strings if line.circle is None)
        return with_lines(movable, strings, lambda line: replace(line, law=ConstantTension(0.0)))
