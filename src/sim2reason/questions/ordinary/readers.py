"""Meanings of main clauses, and readers of those about shapes, springs, and sums over an interval."""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

from sim2reason.questions.ordinary.hearing import ALL_WORD, TokenizedSentence
from sim2reason.questions.ordinary.moment_phrases import AFTER, AMPLITUDE, EVERYTHING, When, read_directions
from sim2reason.questions.ordinary.vocabulary import (
    BESIDE,
    CARRIED_BY_PREFIX,
    CENTERED,
    CENTRAL,
    DOWN,
    DRAWN,
    FARTHEST,
    HELD,
    LIES,
    LINE_WITH_FIXED_END,
    MOTIONS,
    MUTUAL,
    ON,
    ONE_LINE,
    ONLY,
    OVER,
    RESTS,
    SIDEWAYS,
    UP,
)

GAIN, LOSS, JUMP, CHANGE = CHANGES = "gain", "loss", "loss in an impact", "change"
"""What a clause beside a main clause ends: a quantity's change since the start, or over what happens then."""
FREE, STRETCH, MOMENT, CLAUSED, LANDING = "free", "stretch", "moment", "claused", "landing"
"""What a clause beside a main clause tells, for which see `Main`."""


@dataclass(frozen=True, slots=True)
class Main:
    """A meaning of a main clause: quantity, subject, axis, presumed directions and implied moment.

    `needs` says whether the clause asks for a value at a moment, which is steady where no moment is named; for a
    quantity over a stretch of the motion, up to a moment or the whole motion; for a quantity *free* of moments; or for
    a value only beside a clause, or only beside the clause of a landing, or for one of the `CHANGES`. A meaning of a
    higher `rank` counts only where the scene has none of a lower rank.
    """

    find: str
    of: str = ""
    along: str = ""
    needs: str = MOMENT
    ways: tuple[tuple[str, str], ...] = ()
    when: When | None = None
    rank: int = 0


Reader = Callable[[re.Match[str], TokenizedSentence], Iterator[Main]]


def token_subjects(sentence: TokenizedSentence, token: str | None) -> tuple[str, ...]:
    """Return the subjects of a token: a single subject, or all members of a joint phrase."""
    subject = sentence.subject(token)
    return (
        tuple(subject.removeprefix(f"{ALL_WORD} ").split(" & ")) if subject.startswith(f"{ALL_WORD} ") else (subject,)
    )


def subject_reader(*finds: str, needs: str = MOMENT) -> Reader:
    """Return a reader for one or several quantities of the subject that a main clause names."""

    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        for of in token_subjects(heard, found.groupdict().get("s")):
            yield from (Main(find, of, needs=needs) for find in finds)

    return read


def only_subject_reader(*finds: str, needs: str = MOMENT) -> Reader:
    """Return a reader for quantities of the only subject in the scene that has them, whatever subject is named."""

    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        del found, heard
        yield from (Main(find, needs=needs) for find in finds)

    return read


def pair_reader(*finds: str, needs: str = MOMENT) -> Reader:
    """Return a reader for quantities of the pair that a main clause names or, if it names none, of the only pair."""

    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        groups = found.groupdict()
        named = [subject for key in "st" if groups.get(key) for subject in token_subjects(heard, groups[key])]
        if len(named) == 2 and named[0] == named[1]:
            return
        pair = " & ".join(named) if len(named) == 2 else ""
        yield from (
            Main(find, of, needs=needs, rank=rank)
            for rank, of in enumerate(dict.fromkeys((pair, "")))
            for find in finds
        )

    return read


def implied_moment_reader(find: str, *whens: str, needs: str = FREE) -> Reader:
    """Return a reader for a quantity that implies its moment, as the time in the air implies the landing."""

    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        who = heard.subject(found.groupdict().get("s"))
        for rank, when in enumerate(whens):
            moment = When(when.format(s=who).strip())
            yield Main(find, "" if find == "time" else who, needs=needs, when=moment, rank=rank)

    return read


_UPRIGHT = re.compile(rf"\b(?:{'|'.join(f'{MOTIONS[DOWN]} {MOTIONS[UP]}'.split())}|up|down)\b")
MASS_CENTER = "velocity of the centre of mass"


def mass_center(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the velocity of the centre of mass of all bodies, if the sentence names all together, or none."""
    who = sentence.subject(match["s"])
    if not who or who == EVERYTHING or who.startswith(f"{ALL_WORD} "):
        yield Main(MASS_CENTER, ways=((who, ALL_WORD),) if who.startswith(f"{ALL_WORD} ") else ())


def amplitude(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the amplitude of an oscillation: in metres for a body on a line, as an angle for a swinging one."""
    for of in token_subjects(sentence, match["s"]):
        yield Main(AMPLITUDE, of, needs=FREE)
        yield Main("greatest deflection", of, needs=FREE)


def own_axis(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the moment of inertia of a body about its own axis, or about its centre of mass if that is on the axis."""
    of = sentence.subject(match["s"])
    yield Main("moment of inertia about the axis", of)
    yield Main("moment of inertia", of, ways=((of, CENTERED),))


def from_axis(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the distance of a body from an axis of coordinates, which is its other coordinate."""
    other = "y" if match["axis"] == "x" else "x"
    for of in token_subjects(sentence, match["s"]):
        yield Main(f"{other} coordinate", of, needs=CLAUSED)


def on_line(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the coordinate of a body on the only line on which the body moves, if that line is an axis of the text."""
    yield from (
        Main("x coordinate", of, needs=CLAUSED, ways=((of, ONE_LINE),)) for of in token_subjects(sentence, match["s"])
    )


SIDES = {"above": ("x", "+"), "below": ("x", "-"), "right": ("y", "+"), "left": ("y", "-")}


def beside_axis(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the distance of a body from an axis of coordinates on a named side, by default where it is farthest."""
    axis, sign = SIDES[match["side"]]
    other = "y" if axis == "x" else "x"
    if match["axis"] != axis:
        return
    for of in token_subjects(sentence, match["s"]):
        beside = (of, f"{BESIDE}{sign}{other}")
        if match["most"]:
            turn = When(f"velocity of {of} along {other} = 0 m/s", ways=(beside, (of, f"{FARTHEST}{sign}{other}")))
            yield Main(f"{other} coordinate", of, needs=FREE, when=turn)
        else:
            yield Main(f"{other} coordinate", of, needs=CLAUSED, ways=(beside,))


def acceleration_on(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the acceleration of a body relative to the body that carries it."""
    of, on = sentence.subject(match["s"]), sentence.subject(match["t"])
    yield Main("acceleration relative to its carrier", of, needs=MOMENT, ways=((of, f"{ON}{on}"),))


def relative_quantity_reader(name: str) -> Reader:
    """Return a reader for a quantity of a body relative to the body that carries it."""

    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        of, on = heard.subject(found["s"]), heard.subject(found["t"])
        ways = ((of, f"{ON}{on}"), *read_directions(found, of))
        yield Main(f"{name} relative to its carrier", of, needs=CLAUSED, ways=ways)
        if on and on != of and not read_directions(found, of) and not _UPRIGHT.search(heard.text):
            yield Main("relative speed", f"{of} & {on}", needs=CLAUSED, ways=((of, f"{CARRIED_BY_PREFIX}{on}"),))

    return read


def far_on(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the distance that a body slides on its carrier, up to a moment or until it stops slipping."""
    of, on = sentence.subject(match["s"]), sentence.subject(match["t"])
    along = ((of, LIES),) if re.search(r"\b(?:along|over|across)\b", sentence.text) is not None else ()
    main = Main("displacement relative to its carrier", of, needs=CLAUSED, ways=((of, f"{ON}{on}"), *along))
    yield main
    yield replace(main, needs=FREE, when=When(f"{of} stopped slipping", AFTER))


def read_downward_velocity(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the vertical velocity of a body that also moves sideways, presuming that it moves down."""
    for of in token_subjects(sentence, match["s"]):
        yield Main("velocity", of, "vertical", needs=CLAUSED, ways=((of, "down"), (of, SIDEWAYS)))


def read_motion_time(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the time for which a body moves, until it comes to rest for good."""
    of = sentence.subject(match["s"])
    yield Main("time", needs=FREE, when=When(f"{of} halted"))
    yield Main("time", needs=FREE, when=When(f"{of} stopped", ways=((of, RESTS),)), rank=1)


def work_of_spring(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the work of a spring, as the first subject, on a body, as the second one."""
    yield from spring_work(match["s"], match["t"], sentence)


def spring_work(spring: str, on: str, sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the work of a spring with one fixed end on the body at the other: the energy that the spring loses."""
    of, other = sentence.subject(spring), sentence.subject(on)
    yield Main("spring energy", of, needs=LOSS, ways=((other or of, f"{HELD}{of}"),))


def far_end(turn: str = "") -> Reader:
    """Return a reader for the distance of a body from the fixed end of its spring, which is the spring's length.

    At a `turn`, its extreme length is the same each time if nothing but the spring acts.
    """

    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        subjects = [heard.subject(found[key]) for key in "st" if found[key]]
        springs = [of for of in subjects if "spring" in of]
        bodies = [of for of in subjects if of not in springs]
        if len(bodies) == 1:
            of = springs[0] if springs else LINE_WITH_FIXED_END
            main = Main("spring length", of, ways=((bodies[0], f"{HELD}{of}"),))
            alone = (*main.ways, ("", CENTRAL))
            when = When(" ".join((*springs, turn)))
            yield replace(main, needs=FREE, ways=alone, when=when) if turn else main

    return read


FRICTION_HEAT = "energy dissipated by friction"
_CLAUSE = re.compile(r" (?:when|until|till|before|by time|by moment|after|once|as soon as|while|in first|during) ")
EXTREMES = {"greatest compression": "most compressed", "greatest extension": "most stretched"}
"""By the name of a spring's greatest strain, the moment at which the spring has it, where a motion never recurs."""


def read_friction_heat(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the energy dissipated by friction, up to a named moment or until nothing slips any more."""
    del match
    if "@" not in _CLAUSE.split(sentence.text, maxsplit=1)[0]:
        yield Main(FRICTION_HEAT, EVERYTHING, needs=STRETCH)
    yield Main(FRICTION_HEAT, needs=STRETCH)
    yield Main("energy lost in a collision", needs=JUMP)
    yield Main("kinetic energy", needs=JUMP)
    for rank, when in enumerate(("stopped slipping", "stopped"), start=1):
        yield Main(FRICTION_HEAT, needs=FREE, ways=(("", OVER),), when=When(when, AFTER), rank=rank)


def heat_between(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the energy dissipated by friction between a body and its carrier, named in either order."""
    subjects = [sentence.subject(match[key]) for key in "st"]
    for of, on in (subjects, subjects[::-1]):
        main = Main(FRICTION_HEAT, of, ways=((of, f"{ON}{on}"),))
        yield replace(main, needs=STRETCH)
        yield replace(main, needs=FREE, when=When(f"{of} stopped slipping", AFTER), rank=1)


def in_collision(*finds: str) -> Reader:
    """Return a reader for quantities of a named collision or, where none is named, of the motion's only collision."""

    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        groups = found.groupdict()
        both = " & ".join(heard.subject(groups[key]) for key in "st" if groups.get(key))
        for find in finds:
            if " & " in both and not both.startswith(ALL_WORD):
                yield Main(find, needs=FREE, when=When(f"{both} collided", AFTER))
            yield Main(find, needs=STRETCH)
            yield Main(find, needs=FREE, ways=(("", ONLY),), when=When("collided", AFTER), rank=1)

    return read


def extreme_strain_reader(name: str) -> Reader:
    """Return a reader for a spring's greatest extension or compression, over the whole motion or up to that extreme."""

    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        for of in token_subjects(heard, found["s"]):
            yield Main(name, of, needs=STRETCH)
            yield Main(name, of, needs=FREE, when=When(f"{of} {EXTREMES[name]}", AFTER), rank=1)

    return read


def read_hand_work(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the work of the hand, presuming that it pulls a named body."""
    for of in token_subjects(sentence, match["s"]):
        yield Main("work of a hand", needs=STRETCH, ways=((of, DRAWN),))


def work_on(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the work of a string on the body that it pulls, or of a spring on the body at its free end."""
    yield from (Main("work of a tension", of, needs=STRETCH) for of in token_subjects(sentence, match["s"]))
    yield from spring_work(match["t"], match["s"], sentence)


def count_between(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the number of all collisions, if the sentence names all bodies together and there is no wall."""
    who = sentence.subject(match["s"])
    if who.startswith(f"{ALL_WORD} "):
        yield from (replace(main, of="", ways=((who, ALL_WORD), ("", MUTUAL))) for main in count(match, sentence))


def count(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the number of all collisions, or of those up to a moment."""
    yield from implied_moment_reader("number of collisions", "last collision")(match, sentence)
    yield Main("number of collisions", needs=CLAUSED)
