"""Where the height of a body is greatest or least."""

from dataclasses import dataclass

from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.paths import center_path
from sim2reason.questions.moments.parts.peak import Peak
from sim2reason.questions.words import Words


@dataclass(frozen=True, slots=True)
class TurningPoint(Peak):
    """Where the height of a body is greatest or least."""

    of = Bodies()
    hangs_on = "velocity"

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
