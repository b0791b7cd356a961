"""Clauses of questions in ordinary English that name a moment, each with its reader."""

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace

from sim2reason.questions.ordinary.hearing import ALL, Heard
from sim2reason.questions.ordinary.paraphrased_clauses import paraphrased
from sim2reason.questions.ordinary.vocabulary import (
    CARRIED_AT_REST,
    COMPRESSED,
    ON,
    ORIGIN,
    QUANTITIES,
    RELAXED,
    RESTS,
    STRAIGHT,
    STRETCHED,
    meant,
    pattern,
)
from sim2reason.questions.ordinary.whens import AFTER, BEFORE, DURING, ONLY_LINE, THEN, When, ways_of

UP_WAY, DOWN_WAY = "up", "down"
LAST = 10  # the rank of what is meant only where all else is not there
Reader = Callable[[re.Match[str], Heard, str, str], Iterator[When]]
"""From what matched, the sentence, the subject of the question, and the side, to all moments that may be meant."""


def whens(clause: str, heard: Heard, subject: str, side: str) -> Iterator[When]:
    """Yield every moment that a clause may mean, for any subject of the sentence if the clause names no subject."""
    found = list(_of_tables(clause, heard, subject, side))
    plain = dict.fromkeys(paraphrased(clause)) if not found else ()
    yield from found or (when for told in plain for when in _of_tables(told, heard, subject, side))


def _of_tables(clause: str, heard: Heard, subject: str, side: str) -> Iterator[When]:
    for told, reader in CLAUSES.items():
        found = pattern(told).fullmatch(clause)
        if found is None:
            continue
        named = found.groupdict().get("s") is not None
        subjects = dict.fromkeys((subject, *(() if named else (*heard.subjects, ""))))
        for rank, who in enumerate(subjects):
            yield from (replace(when, rank=when.rank + rank) for when in reader(found, heard, who, side))


def _who(found: re.Match[str], heard: Heard, subject: str) -> str:
    return heard.subject(found.groupdict().get("s")) or subject


def simply(name: str, side: str = "") -> Reader:
    """Return a reader for a named moment of one subject, such as *stopped*."""

    def read(found: re.Match[str], heard: Heard, subject: str, asked: str) -> Iterator[When]:
        groups = found.groupdict()
        number = groups.get("number") or ""
        who = _who(found, heard, subject)
        yield When(" ".join(filter(None, (number, who, name))), side or asked)
        if name == "stopped":  # what rides on something comes to rest where that is at rest, too
            told = f"velocity of {who} along {ONLY_LINE} = 0 m/s"
            yield When(told, side or asked, ((who, CARRIED_AT_REST),), rank=LAST)

    return read


def _turned_back(name: str, way: str) -> Reader:
    """Return a reader for the highest or lowest point of a path or, on a straight path, for the stop of the body."""

    def read(found: re.Match[str], heard: Heard, subject: str, asked: str) -> Iterator[When]:
        who = _who(found, heard, subject)
        yield When(f"{who} {name}", asked)
        yield When(f"{who} stopped", asked, ((who, way),), rank=LAST)

    return read


def _alone(name: str) -> Reader:
    """Return a reader for a moment that a scene has only one of, whatever subject is named."""

    def read(found: re.Match[str], heard: Heard, subject: str, asked: str) -> Iterator[When]:
        del found, heard, subject
        yield When(name, asked)

    return read


def _jump(*names: str) -> Reader:
    """Return a reader for an event at which velocities jump: just before the event, just after the event, or both."""

    def read(found: re.Match[str], heard: Heard, subject: str, asked: str) -> Iterator[When]:
        who, groups = _who(found, heard, subject), found.groupdict()
        number = groups.get("number") or ""
        for name in names:
            both = who.removeprefix(f"{ALL} ") if who.startswith(f"{ALL} ") and who.count(" & ") == 1 else ""
            its = name != "collided" or groups.get("s") or re.match(r"its |@\d+@ 's ", found[0])
            of = both if name == "collided" and both else who if its and not who.startswith(f"{ALL} ") else ""
            told = " ".join(filter(None, (number, of, name)))
            for side in (BEFORE, AFTER) if asked in (THEN, DURING) else (asked,):
                yield When(f"{told} before" if side == BEFORE else told, side)

    return read


def _meet(found: re.Match[str], heard: Heard, subject: str, asked: str) -> Iterator[When]:
    """Yield the collision of two named bodies: just before the impact, just after the impact, or both."""
    del subject
    both = f"{heard.subject(found['s'])} & {heard.subject(found['t'])}"
    for side in (BEFORE, AFTER) if asked in (THEN, DURING) else (asked,):
        yield When(f"{both} collided{' before' if side == BEFORE else ''}", side)


def _met(found: re.Match[str], heard: Heard, subject: str, asked: str) -> Iterator[When]:
    """Yield the collision of the question's subject with a named body."""
    if subject and subject != heard.subject(found["t"]) and not subject.startswith(f"{ALL} "):
        both = f"{subject} & {heard.subject(found['t'])}"
        for side in (BEFORE, AFTER) if asked in (THEN, DURING) else (asked,):
            yield When(f"{both} collided{' before' if side == BEFORE else ''}", side)


def _landed(found: re.Match[str], heard: Heard, subject: str, side: str) -> Iterator[When]:
    """Yield the landing and the bounce of a body, just before the impact unless the question asks for just after."""
    who = _who(found, heard, subject)
    number = found.groupdict().get("number") or ""
    if side != AFTER and number in ("", "first"):
        yield When(f"{who} landed", BEFORE)
    yield When(" ".join(filter(None, (number, who, "bounced", "" if side == AFTER else "before"))), side)


def _joined(found: re.Match[str], heard: Heard, subject: str, asked: str) -> Iterator[When]:
    """Yield the moment from which bodies move together, as nothing slips any more."""
    del found, heard, subject
    yield When("stopped slipping", BEFORE if asked == BEFORE else AFTER)


def _rather(reader: Reader) -> Reader:
    """Return a reader for the moments of another reader, tried only after all other meanings of a clause."""

    def read(found: re.Match[str], heard: Heard, subject: str, asked: str) -> Iterator[When]:
        yield from (replace(when, rank=when.rank + LAST) for when in reader(found, heard, subject, asked))

    return read


def _moved(found: re.Match[str], heard: Heard, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a body has moved a given distance, or the given time if the number is a time."""
    who, number = _who(found, heard, subject), heard.number(found["n"])
    ways = ways_of(found, who)
    if _is_time(number):
        yield When(f"at {number}", side, ways)
    else:
        yield When(f"{who} moved {number}", side, ways)
        yield When(f"{who} away {number}", side, (*ways, (who, STRAIGHT)), rank=LAST)
        for sign in ("-" if way == DOWN_WAY else "" for _, way in ways if way in (UP_WAY, DOWN_WAY)):
            yield When(f"displacement of {who} along vertical = {sign}{number}", side, ways, rank=LAST)


def _relatively(found: re.Match[str], heard: Heard, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a body has gone a distance along what carries it."""
    who = heard.subject(found["s"]) or subject
    told = f"displacement relative to its carrier of {who} = {heard.number(found['n'])}"
    yield When(told, side, ((who, f"{ON}{heard.subject(found['t'])}"),) if found["t"] else ())


def _returned(found: re.Match[str], heard: Heard, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a body on a straight line is back where it started."""
    who = _who(found, heard, subject)
    yield When(f"displacement of {who} along {ONLY_LINE} = 0 m", side)


def _stops_going(found: re.Match[str], heard: Heard, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a body that goes one way comes to rest."""
    for when in simply("stopped")(found, heard, subject, side):
        yield replace(when, ways=(*when.ways, *ways_of(found, _who(found, heard, subject))))


def _for_good(found: re.Match[str], heard: Heard, subject: str, side: str) -> Iterator[When]:
    """Yield the moment from which a body stays at rest: its last stop or, where there is but one, that."""
    who = _who(found, heard, subject)
    yield When(f"{who} halted", side)
    yield When(f"{who} stopped", side, ((who, RESTS),), rank=1)


def _has_component(found: re.Match[str], heard: Heard, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a component of a velocity has a value, downwards if the body falls."""
    who, sign = _who(found, heard, subject), "-" if found["sense"] in ("falls", "down") else ""
    yield When(f"velocity of {who} along {found['axis']} = {sign}{heard.number(found['n'])}", side)


def _at_place(found: re.Match[str], heard: Heard, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a coordinate of a body that starts at the origin has a value."""
    who, axis = _who(found, heard, subject), found["axis"]
    value = f"{'-' if found['sign'] else ''}{heard.number(found['n'])}"
    yield When(f"displacement of {who} along {axis} = {value}", side, ((who, f"{ORIGIN} {axis}"),))


def _quantity_is(found: re.Match[str], heard: Heard, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a quantity named by a noun has a value."""
    name, who = meant(QUANTITIES, found["q"]), _who(found, heard, subject)
    if name not in ("height", "distance", "length", "force", "compression", "deceleration"):
        yield When(f"{name} of {who} = {heard.number(found['n'])}", side)
    elif name == "height":
        yield When(f"height above the ground of {who} = {heard.number(found['n'])}", side)


def _at(found: re.Match[str], heard: Heard, subject: str, side: str) -> Iterator[When]:
    del subject
    number = heard.number(found["n"])
    if _is_time(number):
        yield When(f"at {number}", THEN if side == AFTER else side)


def _second(found: re.Match[str], heard: Heard, subject: str, side: str) -> Iterator[When]:
    del found, heard, subject
    yield When("at 1 s", side)


def _has_speed(found: re.Match[str], heard: Heard, subject: str, side: str) -> Iterator[When]:
    yield When(f"velocity of {_who(found, heard, subject)} = {heard.number(found['n'])}", side)


def _angle(found: re.Match[str], heard: Heard, subject: str, side: str) -> Iterator[When]:
    yield When(f"{_who(found, heard, subject)} deflected {heard.number(found['n'])}", side)


def _turned(found: re.Match[str], heard: Heard, subject: str, side: str) -> Iterator[When]:
    yield When(f"{_who(found, heard, subject)} turned through {heard.number(found['n'])}", side)


def _level(found: re.Match[str], heard: Heard, subject: str, side: str) -> Iterator[When]:
    yield When(f"{_who(found, heard, subject)} deflected 90 deg", side)


def _begun(found: re.Match[str], heard: Heard, subject: str, side: str) -> Iterator[When]:
    del found, heard, subject
    if side != BEFORE:
        yield When("at start")


def _apart(found: re.Match[str], heard: Heard, subject: str, side: str) -> Iterator[When]:
    del subject
    if not _is_time(heard.number(found["n"])):
        yield When(f"distance = {heard.number(found['n'])}", side)


def _balanced(found: re.Match[str], heard: Heard, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a body on one spring is at equilibrium, or at a given distance from equilibrium."""
    del subject
    number = found.groupdict().get("n")
    told = f"extension = {heard.number(number)}" if number else "natural length"
    yield When(told, side, (("", RELAXED),))


def _strained(found: re.Match[str], heard: Heard, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a spring is stretched or compressed by a given length."""
    who = _who(found, heard, subject)
    way = COMPRESSED if found["strain"] == "compressed" else STRETCHED
    yield When(f"extension of {who} = {heard.number(found['n'])}", side, ((who, way),))


def _long(found: re.Match[str], heard: Heard, subject: str, side: str) -> Iterator[When]:
    yield When(f"spring length of {_who(found, heard, subject)} = {heard.number(found['n'])}", side)


def _apsis(name: str) -> Reader:
    """Return a reader for the moment when two bodies are farthest apart or closest together: the two that are named, or the body of which the question is asked and its only partner."""

    def read(found: re.Match[str], heard: Heard, subject: str, asked: str) -> Iterator[When]:
        named = [heard.subject(found.groupdict().get(key)) for key in "st"]
        both = " & ".join(said for said in named if said)
        for rank, who in enumerate(dict.fromkeys((both or subject, subject, ""))):
            yield When(f"{who} {name}".strip(), asked, rank=rank)

    return read


def _is_time(number: str) -> bool:
    return number.partition(" ")[2] in ("s", "yr")


def _natural(found: re.Match[str], heard: Heard, subject: str, side: str) -> Iterator[When]:
    yield When(f"{_who(found, heard, subject)} natural length", side)


CLAUSES: Mapping[str, Reader] = {
    "{s} moves {n} relative to (?:{t}|carrier)": _relatively,
    "meets {t}": _met,
    "[{s} ]returns": _returned,
    "[{s} ]stops going {way=WAY}": _stops_going,
    "[{s} ]finally stops": _for_good,
    "[{s} ](?P<sense>falls|rises) with (?P<axis>vertical|horizontal) speed of {n}": _has_component,
    "[{s} ]at (?P<axis>x|y) = (?P<sign>-?){n}": _at_place,
    "{q=QUANTITY} of {s} equals {n}": _quantity_is,
    "{q=QUANTITY} equals {n}": _quantity_is,
    "[t = |time t = |time ]{n}[ START]": _at,
    "{n} after START": _at,
    "{n}[ have passed| has passed| have elapsed]": _at,
    "first {n}[ after START| of motion]": _at,
    "first second[ after START| of motion]": _second,
    "[very ]START[ of motion]": _begun,
    "[{s} ]~{motion=MOTION} [first |distance of ]{n}[ {way=WAY}| ALONG_IT]": _moved,
    "[{s} ]~{motion=MOTION}[ {way=WAY}| ALONG_IT] [by |through |distance of ]{n}": _moved,
    "first {n}[ {way=WAY}| ALONG_IT| of its path]": _moved,
    "{s} has first {motion=MOTION} {n}": _moved,
    "[{s} ]~[first ][momentarily ]STOPS[ AGAIN][ FIRST_TIME][ for instant]": simply("stopped"),
    "[{s} ]~[first ]LANDS[ FIRST_TIME]": _landed,
    "[{s} ]~LANDS for {number=ORDINAL} time": _landed,
    "[its |@0@ 's |{s} 's ]{number=ORDINAL} (?:bounce|impact|landing|rebound)": _jump("bounced"),
    "[{s} ]~[first ]BOUNCES[ FIRST_TIME]": _jump("bounced"),
    "[{s} ]~BOUNCES for {number=ORDINAL} time": _jump("bounced"),
    "[(?:{s}|they) ]~[first ]COLLIDE[ FIRST_TIME]": _jump("collided"),
    "{number=ORDINAL} collision": _jump("collided"),
    "{s} 's {number=ORDINAL} collision": _jump("collided"),
    "{s} ~(?:hit|struck) by {t}[ FIRST_TIME]": _meet,
    "[pure ]rolling (?:sets in|begins|starts)": simply("stopped slipping"),
    "{number=ORDINAL} collision (?:take|takes|took) place": _jump("collided"),
    "{number=ORDINAL} collision (?:happen|happens|occur|occurs)": _jump("collided"),
    "(?:their|its) {number=ORDINAL} collision": _jump("collided"),
    "{s} ~HITS wall[ FIRST_TIME]": _jump("bounced"),
    "[{s} ]~[PASSES ][its |@0@ 's ]FARTHEST[ from {t}| of its PATH][ FIRST_TIME]": _apsis("farthest"),
    "[{s} ]~[PASSES ][its |@0@ 's ]NEAREST[ to {t}| of its PATH][ FIRST_TIME]": _apsis("closest"),
    "{s} ~(?:most strongly|most|fully) compressed": simply("most compressed"),
    "{s} ~(?:most strongly|most|fully) (?:stretched|extended)": simply("most stretched"),
    "{s} ~PASSES [its ]GREATEST compression": simply("most compressed"),
    "{s} ~PASSES [its ]GREATEST extension": simply("most stretched"),
    "all collisions[ ~over]": _alone("last collision"),
    "[its ]impact": _rather(_landed),
    "last collision": _alone("last collision"),
    "{s} ~HITS {t}[ FIRST_TIME]": _meet,
    "{s} and {t} ~COLLIDE[ FIRST_TIME]": _meet,
    "(?:collision|impact) (?:of|between) {s} and {t}": _meet,
    "[{s} ]~[PASSES ][its |{t} 's ]TOP[ of [its ]PATH][ FIRST_TIME]": _turned_back("highest point", "up"),
    "[{s} ]~[PASSES ][its |{t} 's ]BOTTOM[ of [its ]PATH][ FIRST_TIME]": _turned_back("lowest point", "down"),
    "[{s} ]~(?:passes through|passing through|pass through|MOTION to|MOTION down to) vertical": simply("lowest point"),
    "{s} ~(?:vertical|hangs vertically|hangs straight down|hanging vertically)": simply("lowest point"),
    "[in |at ][its ]vertical position": simply("lowest point"),
    "[{s} ]~(?:starts|begins|start|begin) [to ]MOTION (?:again|back)[ WAY]": simply("stopped"),
    "{s} ~(?:makes|make|at) [angle of ]{n}(?: with| to| from) [downward ]vertical": _angle,
    "{s} ~horizontal": _level,
    "[{s} ]~{motion=MOTION} (?:through|by) [angle of ]{n}[ from START| from its starting position]": _turned,
    "[{s} ]~(?:reach|reaches|reached|has|attains) (?:speed|velocity) of {n}": _has_speed,
    "[{s} ]~(?:reach|reaches|reached) {n}": _has_speed,
    "{s} ~MOTION (?:at|with) [speed of ]{n}": _has_speed,
    "{s} 's (?:speed|velocity) (?:~|BECOMES ){n}": _has_speed,
    "(?:speed|velocity) of {s} (?:~|BECOMES ){n}": _has_speed,
    "[{s} 's |its ]BURNOUT": _alone("burned out"),
    "{s} RUNS_OUT": _alone("burned out"),
    "[{s} ][first ]ROLLS[ on {t}]": simply("stopped slipping"),
    "(?:slipping|sliding|skidding) (?:stops|ends|ceases|is over)": simply("stopped slipping"),
    "(?:{s}|they) ~(?:move|moves|moving) together": _joined,
    "{s} NATURAL[ AGAIN][ FIRST_TIME]": _natural,
    "[{s} ]~(?:reach |reaches )?[point |at point ](?:farthest|furthest)[ away][ from {t}]": _apsis("farthest"),
    "[{s} ]~(?:reach |reaches )?[point |at point ](?:closest|nearest)[ to {t}]": _apsis("closest"),
    "[its |{s} 's ](?:farthest|furthest)[ from {t}]": _apsis("farthest"),
    "[its |{s} 's ](?:closest|nearest)[ to {t}]": _apsis("closest"),
    "{s} closest to {t}": _apsis("closest"),
    "{s} farthest from {t}": _apsis("farthest"),
    "{s} ~{n}[ away] from {t}": _apart,
    "{s} ~{strain=STRAINED} by {n}": _strained,
    "{s} ~{n} long": _long,
    "[{s} ]~[PASSES ][its ]equilibrium position[ FIRST_TIME]": _balanced,
    "{s} ~{n} from [its ]equilibrium position": _balanced,
    "{s} (?:goes|go) slack": simply("went slack"),
    "{s} (?:becomes|become|goes|gets) taut[ AGAIN]": simply("went taut"),
    "{s} (?:leaves|leave|loses contact with|lifts off) (?:{t}|SURFACE)": simply("left face"),
    "{s} (?:enters|enter) (?:field|region)": simply("entered region"),
    "{s} (?:leaves|leave|exits) (?:field|region)": simply("left region"),
    "{s} (?:begins|starts|begin|start) to (?:slip|slide)": simply("began to slip"),
}
"""By what a clause is like: what reads its moments."""
