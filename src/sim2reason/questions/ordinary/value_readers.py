"""Readers of main clauses that ask for a value or a force: each yields all possible meanings of its clause."""

import re
from collections.abc import Iterator
from dataclasses import replace

from sim2reason.questions.ordinary.hearing import TokenizedSentence
from sim2reason.questions.ordinary.moment_phrases import AFTER, EVERYTHING, LONG, When, read_directions
from sim2reason.questions.ordinary.readers import (
    CLAUSED,
    FREE,
    LANDING,
    STRETCH,
    Main,
    Reader,
    pair_reader,
    token_subjects,
)
from sim2reason.questions.ordinary.vocabulary import (
    ABOVE_GROUND,
    COMPRESSED,
    DIRECTION_WORDS,
    DOWN,
    FIELDS_ALONE,
    FIXED_FACE,
    FREE_AXLE,
    GROUNDS,
    LASTS,
    LIGHT,
    LINE_WITH_FIXED_END,
    MOTIONS,
    ON,
    ONE_LINE,
    ONE_WAY,
    ONLY_FORCE_PREFIX,
    QUANTITIES,
    RESTS,
    ROUND,
    SIDEWAYS,
    SLOWER,
    SMOOTH,
    UP,
    matching_entry,
)
from sim2reason.questions.posing import ADDITIVE_QUANTITIES, PLUS

ABOVE = "height above the start"
_COMES_DOWN = re.compile(rf"\b(?:come|comes|came|go|goes|gone|went) (?:straight )?down(?! (?:along )?(?:{GROUNDS}|@))")
SINKING = frozenset(
    re.split(" ", "drop drops dropped descend descends descended sink sunk sank descending sinking dropping")
)
FORCES = "tension", "rod force", "rod pull", "spring force"  # that *force* may mean for a string, rod or spring


def quantity(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the quantity that a main clause names by a noun, for each subject."""
    groups = match.groupdict()
    name = matching_entry(QUANTITIES, groups["q"])
    axis = matching_entry(DIRECTION_WORDS, groups["way"]) if groups.get("way") else groups.get("axis") or ""
    along = axis if axis in AXES else ""
    subjects = token_subjects(sentence, groups.get("s"))
    if name in ADDITIVE_QUANTITIES and re.search(r"\b(?:total|combined)\b", match[0]) and len(subjects) > 1:
        yield Main(name, PLUS.join(subjects))
        return
    for of in subjects:
        if name == "force" and re.search(rf"\b{GROUNDS} (?:exert|act)", match[0]) is not None:
            yield Main("normal force", of, ways=((of, f"{ON}{FIXED_FACE}"), (of, SMOOTH)))
        if name == "force" and re.search(r"\b(?:on|acts?|acting|exerted) ", match[0]) is not None:
            yield Main("net force", of, ways=((of, FIELDS_ALONE),))
        ways = read_directions(match, of) if not along else ()
        yield from quantities_by_noun(name, of, along, ways)


FIELDS = ("gravitational force",)  # a net force, where nothing else acts
AXES = ("horizontal", "vertical", "x", "y")


def quantities_by_noun(name: str, of: str, along: str, ways: tuple[tuple[str, str], ...]) -> Iterator[Main]:
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
        yield Main("net force", of, along, ways=((of, f"{ONLY_FORCE_PREFIX}{name}"), *ways))
    elif name == "length":
        yield Main("spring length", of)
    elif name not in ("height", "distance"):
        yield Main(name, of, along, ways=ways)


def read_speed(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the speed of a body, or how fast it turns."""
    groups = match.groupdict()
    turns = groups.get("motion") and matching_entry(MOTIONS, groups["motion"], " ") == "turn"
    for of in token_subjects(sentence, groups["s"]):
        direction = matching_entry(DIRECTION_WORDS, groups["way"]) if groups.get("way") else ""
        find, along = "angular velocity" if turns else "speed", direction if direction in AXES else ""
        presumptions = read_directions(match, of)
        sideways = ((of, ONE_WAY),) if any(axis in ("up", "down") for _, axis in presumptions) else ()
        yield Main(find, of, along, ways=() if along else (*presumptions, *sideways))
        if groups.get("motion") in SINKING:
            yield Main(find, of, "vertical", ways=((of, "down"), (of, SIDEWAYS)))


def far_flown(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the horizontal displacement of a body at its landing."""
    yield from (Main("displacement", of, "horizontal", needs=LANDING) for of in token_subjects(sentence, match["s"]))


def far_stopped(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the displacement of a body when the body comes to rest for good."""
    for of in token_subjects(sentence, match["s"]):
        yield Main("displacement", of, needs=FREE, ways=((of, RESTS),), when=When(f"{of} stopped", AFTER))


def read_equilibrium_value(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the value of a quantity in equilibrium, where every body would stay at rest."""
    yield from (replace(main, needs=FREE, when=When("equilibrium")) for main in quantity(match, sentence))


def read_initial_value(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the initial value of a quantity, just after the start."""
    yield from (replace(main, needs=FREE, when=When("at start")) for main in quantity(match, sentence))


def read_final_value(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the final value of a quantity, after each event that may be the last to change that quantity."""
    for main in quantity(match, sentence):
        for when in ("burned out", "stopped slipping", "collided", "last collision"):
            last = ((main.of, LASTS),)
            yield replace(main, needs=FREE, ways=(*main.ways, *last), when=When(when, AFTER))
        yield replace(main, needs=FREE, when=When(LONG, AFTER))


def read_common_speed(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the common speed of bodies that move together, at a named moment or after slipping has stopped."""
    for of in token_subjects(sentence, match["s"]):
        yield Main("speed", of, needs=CLAUSED)
        yield Main("speed", of, needs=FREE, when=When("stopped slipping", AFTER))


def read_height(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the height of a body above the ground."""
    for of in token_subjects(sentence, match["s"]):
        yield Main("height above the ground", of, needs=CLAUSED, ways=((of, ABOVE_GROUND),))


def read_displacement(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the displacement of a body and, unless an axis is named, the distance travelled; the two must be equal."""
    groups = match.groupdict()
    direction = matching_entry(DIRECTION_WORDS, groups["way"]) if groups.get("way") else ""
    for of in token_subjects(sentence, groups["s"]):
        if direction in AXES:
            yield Main("displacement", of, direction, needs=STRETCH)
        else:
            upright = groups.get("motion") and matching_entry(MOTIONS, groups["motion"], " ") in (UP, DOWN)
            comes = direction == "down" and _COMES_DOWN.search(sentence.text) is not None
            ways = (*read_directions(match, of), *(((of, ONE_WAY),) if upright or comes else ()))
            yield Main("displacement", of, needs=STRETCH, ways=ways)
            yield Main("distance travelled", of, needs=STRETCH, ways=ways)
            if comes or groups.get("motion") in SINKING:
                yield Main(ABOVE, of, needs=STRETCH, ways=((of, "down"), (of, SIDEWAYS)))


def far_in_all(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the distance that a body travels, there and back."""
    for of in token_subjects(sentence, match["s"]):
        yield Main("distance travelled", of, needs=STRETCH, ways=read_directions(match, of))


def read_field_force(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the net force on a body, presuming that nothing but fields acts on it."""
    yield from (Main("net force", of, ways=((of, FIELDS_ALONE),)) for of in token_subjects(sentence, match["s"]))


def all_about_axle(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the moment of inertia of everything that turns about the only axle."""
    del match, sentence
    yield Main("moment of inertia about the axle", EVERYTHING)


def read_approach_speed(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the relative speed of two bodies, presuming that each moves along a line."""
    both = [subject for key in "st" for subject in token_subjects(sentence, match[key]) if subject]
    for main in pair_reader("relative speed")(match, sentence):
        yield replace(main, ways=tuple((who, ONE_LINE) for who in both))


def far_off(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the displacement of a body, presuming that it is above its start, or below it."""
    for of in token_subjects(sentence, match["s"]):
        yield Main("displacement", of, needs=STRETCH, ways=((of, match["side"]),))


def far_vertically(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the height of a body above its start, or its depth below it, presuming that it is on that side."""
    for of in token_subjects(sentence, match["s"]):
        yield Main(ABOVE, of, needs=STRETCH, ways=((of, "down" if match["side"] == "below" else "up"),))


def read_signed_component(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the component of a quantity along the direction that a sentence counts as positive."""
    along = "up" if match["way"].startswith("up") else "right"
    yield from (Main(matching_entry(QUANTITIES, match["q"]), of, along) for of in token_subjects(sentence, match["s"]))


def read_orbital_period(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the period of a body, presuming that the body that it orbits attracts it."""
    of = sentence.subject(match["s"])
    yield Main("period", of, needs=FREE, ways=((of, f"{ROUND}{sentence.subject(match['t'])}"),))


def read_duration(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the time of a moment, or between two moments, as the value asked for."""
    del match, sentence
    yield Main("time", needs=STRETCH)


def accelerates(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the acceleration of a body that speeds up."""
    for of in token_subjects(sentence, match["s"]):
        yield Main("acceleration", of, ways=read_directions(match, of))


def read_normal_force(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the normal force between a body and the face on which the body lies; none on a pulley."""
    face = sentence.subject(match["t"])
    for of in token_subjects(sentence, match["s"]) if "pulley" not in f"{face} {sentence.subject(match['s'])}" else ():
        yield Main("normal force", of, ways=((of, f"{ON}{face}"),) if face else ())


def length_at(turn: str) -> Reader:
    """Return a reader for the length of a spring where the spring is compressed, or stretched, most."""

    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        for of in token_subjects(heard, found["s"]):
            yield Main("spring length", of, needs=FREE, when=When(f"{of} {turn}"))

    return read


def read_line_force(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the force in a string, rod or spring on a body at its end; none on a pulley in between."""
    if "pulley" not in sentence.subject(match.groupdict().get("t")):
        yield from (Main(force, sentence.subject(match["s"])) for force in FORCES)


def read_velocity_angle(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the angle of a velocity with the horizontal, presuming the stated vertical direction."""
    ways = {"above": "up", "below": "down"}
    presumptions = ((sentence.subject(match["s"]), ways[match["side"]]),) if match["side"] in ways else ()
    yield Main("angle with the horizontal", sentence.subject(match["s"]), needs=CLAUSED, ways=presumptions)


def fuel(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the mass of the fuel that is left or has been burnt."""
    yield Main(f"fuel {match['fuel']}", sentence.subject(match["s"]))


def surface_force_reader(find: str, *ways: str) -> Reader:
    """Return a reader for a force of the fixed surface on a body, even on one that carries others."""

    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        for of in token_subjects(heard, found["s"]):
            yield Main(find, of, ways=((of, f"{ON}{FIXED_FACE}"), *((of, presumption) for presumption in ways)))

    return read


GAINS = "gain", "gained", "increase", "increased", "rise"


def potential(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the change of a body's potential energy, presuming that the body goes up for a gain and down for a loss."""
    direction = "up" if match["verb"] in GAINS else "down"
    for of in token_subjects(sentence, match["s"]):
        yield Main("potential energy", of, needs=CLAUSED, ways=((of, direction),))


def read_push_force(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the normal force of a body on a face, or the force of a spring on the object at its end."""
    yield from read_normal_force(match, sentence)
    yield from (Main("spring force", of) for of in token_subjects(sentence, match["s"]))


ON_PULLEY, ON_AXLE, OF_AXLE = "force on a pulley", "force on the axle", "axle force"


def _named(match: re.Match[str], sentence: TokenizedSentence) -> list[str]:
    return [sentence.subject(match[key]) for key in "st" if match[key]]


def _beside_string(subjects: list[str]) -> list[str]:
    """Return the one of two subjects that is not a string; none if neither or both are strings."""
    others = [of for of in subjects if "string" not in of]
    return others if len(subjects) == 2 and len(others) == 1 else []


def on_pulley(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the force of a string on a pulley, whichever of the two is named first."""
    yield from (Main(ON_PULLEY, of) for of in _beside_string(_named(match, sentence)))


def read_force_on_passed_pulley(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the force on a pulley of the string that passes over it."""
    yield Main(ON_PULLEY, sentence.subject(match["s"]))


def on_free_pulley(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the force of the only string on a pulley, presuming that no string is tied to the axle."""
    of = sentence.subject(match["s"])
    yield Main(ON_PULLEY, of, ways=((of, FREE_AXLE),))


def on_axle(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the force on the axle of a light pulley or of an arm, by default of the only one in the scene."""
    subjects = _named(match, sentence)
    for of in (_beside_string(subjects) if len(subjects) == 2 else subjects) or ([] if subjects else [""]):
        yield Main(ON_PULLEY, of, ways=((of, LIGHT),))
        yield Main(OF_AXLE, of)  # of the same size, with a worked solution
        yield Main(ON_AXLE, of)


def on_hook(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the force in a named string, rod or spring, or else in the only one with a fixed end."""
    yield from (Main(force, sentence.subject(match["s"]) or LINE_WITH_FIXED_END) for force in FORCES)
