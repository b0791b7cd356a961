"""Where the height of a body is greatest or least."""

from dataclasses import dataclass
from typing import ClassVar

from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.paths import center_path
from sim2reason.questions.moments.parts.peak import Peak
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.words import Words


@dataclass(frozen=True, slots=True)
class TurningPoint(Peak):
    """Where the height of a body is greatest or least.

    Class data:
        local_verb: what it does there if collisions with other bodies may take it higher, or deeper, later.
    """

    of = Bodies()
    hangs_on = "velocity"
    local_verb: ClassVar[Verb]

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """What flies or swings: on a slope, or on a string straight up, no text speaks of a highest point."""
        mechanism, found = words.mechanism, dict[str, str]()
        tied = {mechanism.site[site].body for line in mechanism.lines for site in line.through}
        for name, said in words.called(cls.of).items():
            path = center_path(mechanism, name)
            led = name in mechanism.contacts or (path.straight and name in tied)
            if any(mechanism.gravity) and path.rises and not led:
                found[name] = cls.of.point(mechanism, name, said)
        return found

    def does(self, words: Words) -> Verb:
        """As in: reaches the highest point of its path, and as in: stops rising."""
        met = [meeting.names for meeting in words.mechanism.meetings if self.name in meeting.names]
        return self.local_verb if any(len(names) > 1 for names in met) else self.verb
