"""Readers of main clauses that ask for a value or a force: each yields all possible meanings of its clause."""

import re
from collections.abc import Iterator
from dataclasses import replace

from sim2reason.questions.ordinary.hearing import TokenizedSentence
from sim2reason.questions.ordinary.moment_phrases import AFTER, EVERYTHING, LONG, When, ways_of
from sim2reason.questions.ordinary.readers import (
    CLAUSED,
    FREE,
    LANDING,
    STRETCH,
    Main,
    Reader,
    each,
    of_pair,
)
from sim2reason.questions.ordinary.vocabulary import (
    ALOFT,
    COMPRESSED,
    DOWN,
    FIELDS_ALONE,
    FIXED_END,
    FIXED_FACE,
    FREE_AXLE,
    GROUNDS,
    LASTS,
    LIGHT,
    MOTIONS,
    ON,
    ONE_LINE,
    ONE_WAY,
    QUANTITIES,
    RESTS,
    ROUND,
    SIDEWAYS,
    SLOWER,
    SMOOTH,
    SOLE,
    UP,
    WAYS,
    matching_entry,
)
from sim2reason.questions.posing import PLUS, SUMMED

ABOVE = "height above the start"
_COMES_DOWN = re.compile(rf"\b(?:come|comes|came|go|goes|gone|went) (?:straight )?down(?! (?:along )?(?:{GROUNDS}|@))")
SINKING = frozenset(
    re.split(" ", "drop drops dropped descend descends descended sink sunk sank descending sinking dropping")
)
FORCES = "tension", "rod force", "rod pull", "spring force"  # that *force* may mean for a string, rod or spring


def quantity(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the quantity that a main clause names by a noun, for each subject."""
    groups = found.groupdict()
    name = matching_entry(QUANTITIES, groups["q"])
    axis = matching_entry(WAYS, groups["way"]) if groups.get("way") else groups.get("axis") or ""
    along = axis if axis in AXES else ""
    if name in SUMMED and re.search(r"\b(?:total|combined)\b", found[0]) and len(each(heard, groups.get("s"))) > 1:
        yield Main(name, PLUS.join(each(heard, groups.get("s"))))
        return
    for of in each(heard, groups.get("s")):
        if name == "force" and re.search(rf"\b{GROUNDS} (?:exert|act)", found[0]) is not None:
            yield Main("normal force", of, ways=((of, f"{ON}{FIXED_FACE}"), (of, SMOOTH)))
        if name == "force" and re.search(r"\b(?:on|acts?|acting|exerted) ", found[0]) is not None:
            yield Main("net force", of, ways=((of, FIELDS_ALONE),))
        ways = ways_of(found, of) if not along else ()
        yield from named(name, of, along, ways)


FIELDS = ("gravitational force",)  # a net force, where nothing else acts
AXES = ("horizontal", "vertical", "x", "y")


def named(name: str, of: str, along: str, ways: tuple[tuple[str, str], ...]) -> Iterator[Main]:
    """Yield every quantity that a noun such as *tension* or *deceleration* may mean, with its presumptions."""
    if name == "force":
        yield from (Main(force, of) for force in FORCES)
    elif name == "tension":
        yield from (Main(force, of, along, ways=ways) for force in ("tension", "rod force", "rod pull"))
    elif name == "deceleration":
        yield Main("acceleration", of, along, ways=((of, SLOWER), *ways))
    elif name == "compression":
        yield Main("extension", of, ways=((of, COMPRESSED),))
    elif name == "thrust":
        yield Main(name, of, needs=CLAUSED)
        yield Main(name, of, needs=FREE, when=When("at start"))
    elif name in FIELDS:
        yield Main("net force", of, along, ways=((of, f"{SOLE}{name}"), *ways))
    elif name == "length":
        yield Main("spring length", of)
    elif name not in ("height", "distance"):
        yield Main(name, of, along, ways=ways)


def fast(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the speed of a body, or how fast it turns."""
    groups = found.groupdict()
    turns = groups.get("motion") and matching_entry(MOTIONS, groups["motion"], " ") == "turn"
    for of in each(heard, groups["s"]):
        way = matching_entry(WAYS, groups["way"]) if groups.get("way") else ""
        find, along = "angular velocity" if turns else "speed", way if way in AXES else ""
        told = ways_of(found, of)
        sideways = ((of, ONE_WAY),) if any(axis in ("up", "down") for _, axis in told) else ()
        yield Main(find, of, along, ways=() if along else (*told, *sideways))
        if groups.get("motion") in SINKING:
            yield Main(find, of, "vertical", ways=((of, "down"), (of, SIDEWAYS)))


def far_flown(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the horizontal displacement of a body at its landing."""
    yield from (Main("displacement", of, "horizontal", needs=LANDING) for of in each(heard, found["s"]))


def far_stopped(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the displacement of a body when the body comes to rest for good."""
    for of in each(heard, found["s"]):
        yield Main("displacement", of, needs=FREE, ways=((of, RESTS),), when=When(f"{of} stopped", AFTER))


def balanced(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the value of a quantity in equilibrium, where every body would stay at rest."""
    yield from (replace(main, needs=FREE, when=When("equilibrium")) for main in quantity(found, heard))


def initial(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the initial value of a quantity, just after the start."""
    yield from (replace(main, needs=FREE, when=When("at start")) for main in quantity(found, heard))


def final(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the final value of a quantity, after each event that may be the last to change that quantity."""
    for main in quantity(found, heard):
        for when in ("burned out", "stopped slipping", "collided", "last collision"):
            last = ((main.of, LASTS),)
            yield replace(main, needs=FREE, ways=(*main.ways, *last), when=When(when, AFTER))
        yield replace(main, needs=FREE, when=When(LONG, AFTER))


def common(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the common speed of bodies that move together, at a named moment or after slipping has stopped."""
    for of in each(heard, found["s"]):
        yield Main("speed", of, needs=CLAUSED)
        yield Main("speed", of, needs=FREE, when=When("stopped slipping", AFTER))


def high(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the height of a body above the ground."""
    for of in each(heard, found["s"]):
        yield Main("height above the ground", of, needs=CLAUSED, ways=((of, ALOFT),))


def far(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the displacement of a body and, unless an axis is named, the distance travelled; the two must be equal."""
    groups = found.groupdict()
    way = matching_entry(WAYS, groups["way"]) if groups.get("way") else ""
    for of in each(heard, groups["s"]):
        if way in AXES:
            yield Main("displacement", of, way, needs=STRETCH)
        else:
            upright = groups.get("motion") and matching_entry(MOTIONS, groups["motion"], " ") in (UP, DOWN)
            comes = way == "down" and _COMES_DOWN.search(heard.text) is not None
            ways = (*ways_of(found, of), *(((of, ONE_WAY),) if upright or comes else ()))
            yield Main("displacement", of, needs=STRETCH, ways=ways)
            yield Main("distance travelled", of, needs=STRETCH, ways=ways)
            if comes or groups.get("motion") in SINKING:
                yield Main(ABOVE, of, needs=STRETCH, ways=((of, "down"), (of, SIDEWAYS)))


def far_in_all(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the distance that a body travels, there and back."""
    for of in each(heard, found["s"]):
        yield Main("distance travelled", of, needs=STRETCH, ways=ways_of(found, of))


def of_fields(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the net force on a body, presuming that nothing but fields acts on it."""
    yield from (Main("net force", of, ways=((of, FIELDS_ALONE),)) for of in each(heard, found["s"]))


def all_about_axle(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the moment of inertia of everything that turns about the only axle."""
    del found, heard
    yield Main("moment of inertia about the axle", EVERYTHING)


def nears(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the relative speed of two bodies, presuming that each moves along a line."""
    both = [said for key in "st" for said in each(heard, found[key]) if said]
    for main in of_pair("relative speed")(found, heard):
        yield replace(main, ways=tuple((who, ONE_LINE) for who in both))


def far_off(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the displacement of a body, presuming that it is above its start, or below it."""
    yield from (Main("displacement", of, needs=STRETCH, ways=((of, found["side"]),)) for of in each(heard, found["s"]))


def far_vertically(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the height of a body above its start, or its depth below it, presuming that it is on that side."""
    for of in each(heard, found["s"]):
        yield Main(ABOVE, of, needs=STRETCH, ways=((of, "down" if found["side"] == "below" else "up"),))


def signed(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the component of a quantity along the direction that a sentence counts as positive."""
    along = "up" if found["way"].startswith("up") else "right"
    yield from (Main(matching_entry(QUANTITIES, found["q"]), of, along) for of in each(heard, found["s"]))


def of_orbit(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the period of a body, presuming that the body that it orbits attracts it."""
    yield Main(
        "period",
        heard.subject(found["s"]),
        needs=FREE,
        ways=((heard.subject(found["s"]), f"{ROUND}{heard.subject(found['t'])}"),),
    )


def time(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the time of a moment, or between two moments, as the value asked for."""
    del found, heard
    yield Main("time", needs=STRETCH)


def accelerates(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the acceleration of a body that speeds up."""
    yield from (Main("acceleration", of, ways=ways_of(found, of)) for of in each(heard, found["s"]))


def presses(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the normal force between a body and the face on which the body lies; none on a pulley."""
    face = heard.subject(found["t"])
    for of in each(heard, found["s"]) if "pulley" not in f"{face} {heard.subject(found['s'])}" else ():
        yield Main("normal force", of, ways=((of, f"{ON}{face}"),) if face else ())


def length_at(turn: str) -> Reader:
    """Return a reader for the length of a spring where the spring is compressed, or stretched, most."""

    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        for of in each(heard, found["s"]):
            yield Main("spring length", of, needs=FREE, when=When(f"{of} {turn}"))

    return read


def along(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the force in a string, rod or spring on a body at its end; none on a pulley in between."""
    if "pulley" not in heard.subject(found.groupdict().get("t")):
        yield from (Main(force, heard.subject(found["s"])) for force in FORCES)


def steep(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the angle of a velocity with the horizontal, presuming the stated vertical direction."""
    ways = {"above": "up", "below": "down"}
    way = ((heard.subject(found["s"]), ways[found["side"]]),) if found["side"] in ways else ()
    yield Main("angle with the horizontal", heard.subject(found["s"]), needs=CLAUSED, ways=way)


def fuel(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the mass of the fuel that is left or has been burnt."""
    yield Main(f"fuel {found['fuel']}", heard.subject(found["s"]))


def of_ground(find: str, *ways: str) -> Reader:
    """Return a reader for a force of the fixed surface on a body, even on one that carries others."""

    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        for of in each(heard, found["s"]):
            yield Main(find, of, ways=((of, f"{ON}{FIXED_FACE}"), *((of, way) for way in ways)))

    return read


GAINS = "gain", "gained", "increase", "increased", "rise"


def potential(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the change of a body's potential energy, presuming that the body goes up for a gain and down for a loss."""
    way = "up" if found["verb"] in GAINS else "down"
    for of in each(heard, found["s"]):
        yield Main("potential energy", of, needs=CLAUSED, ways=((of, way),))


def pushes(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the normal force of a body on a face, or the force of a spring on the object at its end."""
    yield from presses(found, heard)
    yield from (Main("spring force", of) for of in each(heard, found["s"]))


ON_PULLEY, ON_AXLE, OF_AXLE = "force on a pulley", "force on the axle", "axle force"


def _named(found: re.Match[str], heard: TokenizedSentence) -> list[str]:
    return [heard.subject(found[key]) for key in "st" if found[key]]


def _beside_string(said: list[str]) -> list[str]:
    """Return the one of two subjects that is not a string; none if neither or both are strings."""
    others = [of for of in said if "string" not in of]
    return others if len(said) == 2 and len(others) == 1 else []


def on_pulley(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the force of a string on a pulley, whichever of the two is named first."""
    yield from (Main(ON_PULLEY, of) for of in _beside_string(_named(found, heard)))


def on_that_pulley(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the force on a pulley of the string that passes over it."""
    yield Main(ON_PULLEY, heard.subject(found["s"]))


def on_free_pulley(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the force of the only string on a pulley, presuming that no string is tied to the axle."""
    of = heard.subject(found["s"])
    yield Main(ON_PULLEY, of, ways=((of, FREE_AXLE),))


def on_axle(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the force on the axle of a light pulley or of an arm, by default of the only one in the scene."""
    said = _named(found, heard)
    for of in (_beside_string(said) if len(said) == 2 else said) or ([] if said else [""]):
        yield Main(ON_PULLEY, of, ways=((of, LIGHT),))
        yield Main(OF_AXLE, of)  # of the same size, with a worked solution
        yield Main(ON_AXLE, of)


def on_hook(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the force in a named string, rod or spring, or else in the only one with a fixed end."""
    yield from (Main(force, heard.subject(found["s"]) or FIXED_END) for force in FORCES)
