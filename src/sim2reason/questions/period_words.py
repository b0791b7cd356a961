"""How questions ask for a period or a frequency."""

from dataclasses import dataclass

from sim2reason.dsl.fields import Magnetic
from sim2reason.dsl.mechanism import Mechanism
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.pairs import pair
from sim2reason.quantities.subjects.paths import center_path
from sim2reason.quantities.subjects.turners import TurningBodies
from sim2reason.questions.query import Query
from sim2reason.questions.words import Words
from sim2reason.simulation.rest.equilibrium import equilibrium

COUNTS = {2: "two", 3: "three"}
SPEEDS = {2: ("slower", "faster"), 3: ("slowest", "fastest")}
SIZES = {2: ("lower", "higher"), 3: ("lowest", "highest")}
LENGTHS = {2: ("longer", "shorter"), 3: ("longest", "shortest")}


@dataclass(frozen=True, slots=True)
class PeriodQuery(Query):
    """The period of the motion of one body, or of small oscillations, of one body, of two against each other, of all.

    `rank` counts modes of small oscillations by their frequency, from the slowest, of `modes` that there are.
    """

    measure: str = "period"
    small: bool = False
    of: tuple[str, ...] = ()
    rank: int = 0
    modes: int = 1

    @property
    def subject(self) -> str:
        """The first body that it speaks of."""
        return next(iter(self.of), "")


def movers(words: Words) -> dict[str, str]:
    """What moves and is spoken of: bodies, and arms that turn."""
    return {**words.called(Bodies()), **words.called(TurningBodies())}


def sentences(query: PeriodQuery, words: Words) -> tuple[str, ...]:
    """All that ask for it, the most usual first."""
    if not query.small:
        return _of_motion(query, words)
    place = f"the position of {rest_called(words.mechanism)}"
    return _of_modes(query, place) if query.modes > 1 else _of_small(query, words, place)


def rest_called(mechanism: Mechanism) -> str:
    """How a text calls the equilibrium: the stable one where loads are such that there may be others, too."""
    rest = equilibrium(mechanism)
    return "equilibrium" if rest is None or rest.linear else "stable equilibrium"


def _of_motion(query: PeriodQuery, words: Words) -> tuple[str, ...]:
    mechanism, name, measure = words.mechanism, query.of[0], query.measure
    said, path = movers(words)[name], center_path(mechanism, name)
    center = attracted_by(mechanism, name)
    if center in words.mentions:
        return _of_orbit(measure, said, words.mentions[center])
    if _revolves(mechanism, name):
        return _of_revolution(measure, said)
    plain = _plainly(f"the {measure} of the motion of {said}")
    if not (path.straight or (words.released and path.swings)):
        again = (f"how long does it take until the motion of {said} repeats itself?",) if measure == "period" else ()
        return (*plain, f"with what {measure} does the motion of {said} repeat itself?", *again)
    does = "oscillate" if path.straight else "rock to and fro" if name in mechanism.contacts else "swing to and fro"
    first, _, rest = does.partition(" ")
    verb = f"{first}s {rest}".rstrip()
    takes = (f"how long does {said} take for one complete oscillation?",) if measure == "period" else ()
    return (
        *plain,
        f"with what {measure} does {said} {does}?",
        f"determine the {measure} with which {said} {verb}.",
        *takes,
    )


def _of_orbit(measure: str, said: str, center: str) -> tuple[str, ...]:
    return (
        *_plainly(f"the orbital {measure} of {said}"),
        f"with what {measure} does {said} go round {center}?",
        f"determine the {measure} of the motion of {said} about {center}.",
        f"what is the {measure} with which {said} goes round {center}?",
    )


def _of_revolution(measure: str, said: str) -> tuple[str, ...]:
    takes = f"how long does one revolution of {said} take?" if measure == "period" else ""
    plain = (f"with what {measure} does {said} go round its circle?", takes)
    return tuple(shape for shape in (*_plainly(f"the {measure} of revolution of {said}"), *plain) if shape)


def _revolves(mechanism: Mechanism, name: str) -> bool:
    """Whether nothing but a uniform magnetic field acts on a body in its plane, so that it goes round in a circle."""
    forces = [force for force in mechanism.forces if force.body == name]
    alone = len(forces) == 1 and forces[0].region is None and not (mechanism.lines or mechanism.attractions)
    law = forces[0].law if alone else None
    return isinstance(law, Magnetic) and law.profile.uniform and not center_path(mechanism, name).rises


def _plainly(noun: str) -> tuple[str, ...]:
    return (f"what is {noun}?", f"find {noun}.", f"determine {noun}.", f"calculate {noun}.")


def _of_small(query: PeriodQuery, words: Words, place: str) -> tuple[str, ...]:
    said, measure = [movers(words)[name] for name in query.of], query.measure
    own = place.replace("the", "its", 1)
    if len(said) == 1:
        of = f"of {said[0]} about {place}"
        told = (
            f"disturbed slightly from {own}, with what {measure} does {said[0]} oscillate?",
            f"with what {measure} does {said[0]} oscillate if slightly disturbed from {own}?",
        )
    elif said:
        of = f"of {pair(*said)} relative to each other"
        told = (
            f"with what {measure} do {pair(*said)} vibrate against each other when the amplitude is small?",
            f"with what {measure} would {pair(*said)} oscillate relative to each other after a slight disturbance?",
        )
    else:
        of = f"about {place}"
        told = (
            f"if all is at rest in {place} and is slightly disturbed, what is the {measure} of the oscillations?",
            f"with what {measure} does everything oscillate if it is slightly disturbed from {place}?",
        )
    takes = (f"how long does one small oscillation {of} take?",) if measure == "period" else ()
    return (*_plainly(f"the {measure} of small oscillations {of}"), *told, *takes)


def _of_modes(query: PeriodQuery, place: str) -> tuple[str, ...]:
    """Of several modes; the slowest has the longest period."""
    count, last = query.modes, query.rank > 0
    plural = {"period": "natural periods"}.get(query.measure, f"natural {query.measure[:-1]}ies")
    which = (LENGTHS if query.measure == "period" else SIZES)[count][last]
    mode = f"the {SPEEDS[count][last]} of the {COUNTS[count]} normal modes of oscillation about {place}"
    return (
        *_plainly(f"the {query.measure} of {mode}"),
        f"oscillations about {place} have {COUNTS[count]} {plural}; what is the {which} of them?",
        f"of the {COUNTS[count]} {plural} of oscillations about {place}, find the {which}.",
    )


def attracted_by(mechanism: Mechanism, name: str) -> str:
    """The fixed body about which another one goes, drawn by it; empty if there is none."""
    for pull in mechanism.attractions:
        for one, other in ((pull.a, pull.b), (pull.b, pull.a)):
            if one == name and not center_path(mechanism, other).ways:
                return other
    return ""
