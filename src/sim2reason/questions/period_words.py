"""Phrases and sentences of questions for a period or a frequency."""

from dataclasses import dataclass

from sim2reason.questions.query import Query
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.fields import Magnetic
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.quantities.subjects.bodies import Bodies, TurningBodies
from sim2reason.simulation.quantities.subjects.pairs import pair
from sim2reason.simulation.quantities.subjects.paths import center_path

COUNTS = {2: "two", 3: "three"}
SPEEDS = {2: ("slower", "faster"), 3: ("slowest", "fastest")}
SIZES = {2: ("lower", "higher"), 3: ("lowest", "highest")}
PLURALS = {
    "period": "natural periods",
    "frequency": "natural frequencies",
    "angular frequency": "natural angular frequencies",
}
PER_SECOND = ", in oscillations per second"  # for natural frequencies, often mistaken for angular ones
LENGTHS = {2: ("longer", "shorter"), 3: ("longest", "shortest")}


@dataclass(frozen=True, slots=True)
class PeriodQuery(Query):
    """A query for the period of one body's motion, or of small oscillations of one, two or all bodies.

    `rank` counts modes of small oscillations by their frequency, from the slowest, of `modes` that there are. Of a
    `stable` equilibrium the text says so, since there may be others.
    """

    measure: str = "period"
    small: bool = False
    of: tuple[str, ...] = ()
    rank: int = 0
    modes: int = 1
    stable: bool = False

    @property
    def subject(self) -> str:
        """Return the name of the first body."""
        return next(iter(self.of), "")


def movers(words: Words) -> dict[str, str]:
    """Return the phrases of moving bodies and arms by name."""
    return {**words.called(Bodies()), **words.called(TurningBodies())}


def noun_of(query: PeriodQuery, words: Words) -> str:
    """Return a phrase such as *the period of small oscillations of the block about the position of equilibrium*."""
    if not query.small:
        return _noun_of_motion(query, words)
    about = f"about {_place(query)}"
    if query.modes > 1:
        speed = SPEEDS[query.modes][query.rank > 0]
        return f"the {query.measure} of the {speed} of the {COUNTS[query.modes]} normal modes of oscillation {about}"
    return f"the {query.measure} of small oscillations {_of(query, words)}"


def sentences(query: PeriodQuery, words: Words) -> tuple[str, ...]:
    """Return all sentences of the query, the most usual first."""
    if not query.small:
        others = _of_motion(query, words)
    else:
        others = _of_modes(query) if query.modes > 1 else _of_small(query, words)
    return (*_plainly(noun_of(query, words)), *others)


def _place(query: PeriodQuery) -> str:
    return f"the position of {equilibrium_called(stable=query.stable)}"


def _of(query: PeriodQuery, words: Words) -> str:
    """Return the words for the bodies and the equilibrium of small oscillations with a single mode."""
    said = [movers(words)[name] for name in query.of]
    if len(said) > 1:
        return f"of {pair(*said)} relative to each other"
    return f"of {said[0]} about {_place(query)}" if said else f"about {_place(query)}"


def equilibrium_called(*, stable: bool) -> str:
    """Return the phrase for an equilibrium position."""
    return "stable equilibrium" if stable else "equilibrium"


def _noun_of_motion(query: PeriodQuery, words: Words) -> str:
    name, said = query.of[0], movers(words)[query.of[0]]
    if attracted_by(words.mechanism, name) in words.mentions:
        return f"the orbital {query.measure} of {said}"
    if _revolves(words.mechanism, name):
        return f"the {query.measure} of revolution of {said}"
    return f"the {query.measure} of the motion of {said}"


def _of_motion(query: PeriodQuery, words: Words) -> tuple[str, ...]:
    mechanism, name, measure = words.mechanism, query.of[0], query.measure
    said, path = movers(words)[name], center_path(mechanism, name)
    center = attracted_by(mechanism, name)
    if center in words.mentions:
        return _of_orbit(measure, said, words.mentions[center])
    if _revolves(mechanism, name):
        return _of_revolution(measure, said)
    if not (path.straight or (words.released and path.swings)):
        again = (f"how long does it take until the motion of {said} repeats itself?",) if measure == "period" else ()
        return (f"with what {measure} does the motion of {said} repeat itself?", *again)
    does = "oscillate" if path.straight else "rock to and fro" if name in mechanism.contacts else "swing to and fro"
    first, _, rest = does.partition(" ")
    verb = f"{first}s {rest}".rstrip()
    takes = (f"how long does {said} take for one complete oscillation?",) if measure == "period" else ()
    return (
        f"with what {measure} does {said} {does}?",
        f"determine the {measure} with which {said} {verb}.",
        *takes,
    )


def _of_orbit(measure: str, said: str, center: str) -> tuple[str, ...]:
    return (
        f"with what {measure} does {said} go round {center}?",
        f"determine the {measure} of the motion of {said} about {center}.",
        f"what is the {measure} with which {said} goes round {center}?",
    )


def _of_revolution(measure: str, said: str) -> tuple[str, ...]:
    takes = (f"how long does one revolution of {said} take?",) if measure == "period" else ()
    return (f"with what {measure} does {said} go round its circle?", *takes)


def _revolves(mechanism: Mechanism, name: str) -> bool:
    """Return whether only a uniform magnetic field acts on a body in its plane, so that its path is a circle."""
    forces = [force for force in mechanism.forces if force.body == name]
    alone = len(forces) == 1 and forces[0].region is None and not (mechanism.lines or mechanism.attractions)
    law = forces[0].law if alone else None
    return isinstance(law, Magnetic) and law.profile.uniform and not center_path(mechanism, name).rises


def _plainly(noun: str) -> tuple[str, ...]:
    return (f"what is {noun}?", f"find {noun}.", f"determine {noun}.", f"calculate {noun}.")


def _of_small(query: PeriodQuery, words: Words) -> tuple[str, ...]:
    said, measure, place = [movers(words)[name] for name in query.of], query.measure, _place(query)
    own = place.replace("the", "its", 1)
    if len(said) == 1:
        told = (
            f"disturbed slightly from {own}, with what {measure} does {said[0]} oscillate?",
            f"with what {measure} does {said[0]} oscillate if slightly disturbed from {own}?",
        )
    elif said:
        told = (
            f"with what {measure} do {pair(*said)} vibrate against each other when the amplitude is small?",
            f"with what {measure} would {pair(*said)} oscillate relative to each other after a slight disturbance?",
        )
    else:
        told = (
            f"if all is at rest in {place} and is slightly disturbed, what is the {measure} of the oscillations?",
            f"with what {measure} does everything oscillate if it is slightly disturbed from {place}?",
        )
    takes = (f"how long does one small oscillation {_of(query, words)} take?",) if measure == "period" else ()
    return (*told, *takes)


def _of_modes(query: PeriodQuery) -> tuple[str, ...]:
    """Return the sentences for one of several modes of oscillation, named by the order of their periods."""
    count, last, place = query.modes, query.rank > 0, _place(query)
    plural, unit = PLURALS[query.measure], PER_SECOND if query.measure == "frequency" else ""
    which = (LENGTHS if query.measure == "period" else SIZES)[count][last]
    return (
        f"oscillations about {place} have {COUNTS[count]} {plural}{unit}; what is the {which} of them?",
        f"of the {COUNTS[count]} {plural} of oscillations about {place}, find the {which}{unit}.",
    )


def attracted_by(mechanism: Mechanism, name: str) -> str:
    """Return the name of the fixed body that another one orbits; empty if there is none."""
    for pull in mechanism.attractions:
        for one, other in ((pull.a, pull.b), (pull.b, pull.a)):
            if one == name and not center_path(mechanism, other).ways:
                return other
    return ""
