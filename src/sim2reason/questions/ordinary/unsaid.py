"""Subjects that a sentence does not name itself: those of *the system*, and what is tied to something fixed."""

from sim2reason.quantities.subjects.pulleys import Pulleys
from sim2reason.questions.ordinary.addresses import all_of
from sim2reason.questions.words import Words

AMPLITUDE = "amplitude"
SHARED = "acceleration", "speed", "velocity"  # of all bodies of a system that is connected, if they have the same


def each_of(find: str, words: Words) -> tuple[str, ...]:
    """Return all heavy bodies, for a quantity that a connected system has as a whole; none for any other."""
    return all_of(find, words) if find in SHARED and words.mechanism.lines else ()


def fixed_end(words: Words) -> tuple[str, ...]:
    """Return the only line of which one end is fixed and no pulley; none if there are several."""
    mechanism, wheels = words.mechanism, Pulleys().names(words.mechanism)
    ends = {
        line.name: [mechanism.site[site] for site in (line.through[0], line.through[-1])] for line in mechanism.lines
    }
    fixed = [
        name
        for name, sites in ends.items()
        if any(site.body is None and site.name.rpartition(".")[0] not in wheels for site in sites)
    ]
    return tuple(fixed) if len(fixed) == 1 else ()
