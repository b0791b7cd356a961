"""Subjects that a sentence means but does not name, such as all bodies by *the system*."""

import re

from sim2reason.dsl.frames import start
from sim2reason.dsl.mechanism import Elastic
from sim2reason.quantities.subjects.axles import Pulleys
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.lines import STRETCHED, Springs
from sim2reason.quantities.subjects.pairs import AND
from sim2reason.quantities.subjects.paths import EVEN
from sim2reason.quantities.subjects.rods import SwingingLines
from sim2reason.questions.ordinary.addresses import all_of
from sim2reason.questions.ordinary.whens import ONLY_LINE
from sim2reason.questions.words import Words

AMPLITUDE = "amplitude"
_EQUAL = re.compile(rf"relative velocity of (?P<one>.+) & (?P<other>.+) along {ONLY_LINE} = 0 m/s")
_NEAREST = re.compile(r"(?P<one>\S+) & (?P<other>\S+) (?P<how>closest|farthest)")
ENERGIES = "kinetic energy", "rotational kinetic energy"
ORBITAL = "eccentricity", "semi-major axis"
DEFLECTIONS = "deflection", "greatest deflection", "least deflection"
SHARED = "acceleration", "speed", "velocity"  # of all bodies of a system that is connected, if they have the same


def each_of(find: str, words: Words) -> tuple[str, ...]:
    """Return all bodies with a mass, for a quantity that connected bodies share, such as their speed; else none."""
    return all_of(find, words) if find in SHARED and words.mechanism.lines else ()


def velocities_equal(told: str, words: Words) -> str:
    """Return the moment when two bodies on a line have the same velocity, by addresses; any other moment unchanged."""
    found = _EQUAL.fullmatch(told)
    if found is None:
        return told
    by_phrase = {said: name for name, said in words.called(Bodies()).items()}
    names = [by_phrase.get(found[key], "") for key in ("one", "other")]
    if not all(names):
        return told
    senses = [Bodies().senses(words.mechanism, name) for name in names]
    if senses[0] != senses[1] or len(senses[0]) != 1:
        return told
    return f"relative velocity of {AND.join(names)} along {senses[0][0].positive} = 0 m/s"


def relaxed_again(told: str, words: Words) -> str:
    """Return the moment when a spring that is relaxed at first is so again; any other moment unchanged."""
    who, parted, _ = told.rpartition(" natural length")
    springs = words.called(Springs())
    names = [name for name, said in springs.items() if said == who] or list(Springs().names(words.mechanism))
    if not parted or len(names) != 1:
        return told
    line = words.mechanism.line[names[0]]
    assert isinstance(line.law, Elastic)
    strained = abs(float(start(words.mechanism).length(line)) - line.law.length) > EVEN or line.wheels
    return told if strained else f"extension of {names[0]} along {STRETCHED} = 0 m"


def strained(told: str, words: Words) -> str:
    """Return the moment when the spring between two bodies is shortest, for when they are closest, or vice versa."""
    found = _NEAREST.fullmatch(told)
    ends = {found["one"], found["other"]} if found is not None else set[str]()
    for name in Springs().names(words.mechanism) if found is not None else ():
        line = words.mechanism.line[name]
        tied = {words.mechanism.site[site].body for site in (line.through[0], line.through[-1])}
        if tied == ends and not line.wheels:
            return f"{name} {'most compressed' if found and found['how'] == 'closest' else 'most stretched'}"
    return told


def line_of(said: str, words: Words) -> str:
    """Return the phrase for the only swinging line, for that of the body at its end or of its rod; else the same."""
    lines = words.called(SwingingLines())
    if said in lines.values() or len(lines) != 1:
        return said
    (name,) = lines
    of_line = f"{name.rpartition('.')[0]}."  # the pendulum, or the arm, to which the line belongs
    if not any(phrase == said and address.startswith(of_line) for address, phrase in words.mentions.items()):
        return said
    return next(iter(lines.values()))


def is_light_arm(said: str, words: Words) -> bool:
    """Return whether a phrase means a body without mass on an axle, such as a light arm that carries a ball."""
    bodies = [body for body in words.mechanism.bodies if words.mentions.get(body.name) == said]
    return any(body.mass == 0.0 and any(c.kind == "hinge" for c in body.coordinates) for body in bodies)


def fixed_end(words: Words) -> tuple[str, ...]:
    """Return the name of the only string or spring with an end fixed in place; none if there are several."""
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
