"""Main clauses that ask for a total or an extreme over an interval of the motion, or for a period."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import replace

from sim2reason.questions.ordinary import readers
from sim2reason.questions.ordinary.hearing import TokenizedSentence
from sim2reason.questions.ordinary.moment_phrases import AFTER, ONLY_LINE, When, read_directions
from sim2reason.questions.ordinary.readers import (
    FREE,
    STRETCH,
    Main,
    Reader,
    implied_moment_reader,
    only_subject_reader,
    pair_reader,
    subject_reader,
    token_subjects,
)
from sim2reason.questions.ordinary.vocabulary import (
    CARRIED_AT_REST,
    FALLS,
    QUANTITIES,
    RISING,
    SMALL_OSCILLATIONS,
    matching_entry,
    pattern,
)

NAMES = {"velocity": "speed", "angular velocity": "angular speed", "force": "rod force"}
"""What functionals call a quantity otherwise."""
PULLS = "rod force", "tension", "spring force", "rod pull"


def _extreme(size: str) -> Reader:
    """Return a reader for the greatest or least value of a quantity over a stretch of the motion."""

    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        name = matching_entry(QUANTITIES, found.groupdict()["q"])
        name = NAMES.get(name, name)
        if name in ("rod force", "tension"):
            yield from (
                Main(f"{size} {force}", heard.subject(found.groupdict().get("s")), needs=STRETCH) for force in PULLS
            )
            return
        for of in token_subjects(heard, found.groupdict().get("s")):
            if name == "height" and size == "greatest":
                yield from _gets(found, heard)
                continue
            if name == "distance":
                continue
            yield Main(f"{size} {name}", of, needs=STRETCH)
            if turn := readers.EXTREMES.get(f"{size} {name}"):
                yield Main(f"{size} {name}", of, needs=FREE, when=When(f"{of} {turn}", AFTER), rank=1)

    return read


def _pairs(size: str) -> Reader:
    """Return a reader for a pair's greatest or least distance, or for another quantity's extreme of one subject."""

    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        name = matching_entry(QUANTITIES, found.groupdict()["q"])
        if name != "distance":
            yield from _extreme(size)(found, heard)
            return
        apsis = "farthest" if size == "greatest" else "closest"
        for main in pair_reader("distance", needs=FREE)(found, heard):
            yield replace(main, find=f"{size} distance", needs=STRETCH, rank=2 * main.rank)
            yield replace(main, when=When(f"{main.of} {apsis}".strip()), rank=2 * main.rank + 1)

    return read


def _rise(of: str) -> Iterator[Main]:
    """Yield the greatest height of a body above its start, up to the highest point or the stop of the body."""
    for rank, when in enumerate(("highest point", "stopped"), start=1):
        yield Main("greatest height", of, needs=FREE, ways=((of, "up"),), when=When(f"{of} {when}"), rank=rank)


def _highest(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the height of a body above the ground at the highest point or, failing that, where the body stops."""
    for of in token_subjects(sentence, match.groupdict().get("s")):
        yield Main("height above the ground", of, needs=FREE, when=When(f"{of} highest point"))
        yield Main("height above the ground", of, needs=FREE, when=When(f"{of} stopped"), rank=1)


def _before_landing(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the greatest height of a body above the ground before it lands, presuming that it rises first."""
    for main in _highest(match, sentence):
        yield replace(main, ways=((main.of, "up"),))


def _range(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the horizontal displacement of a body at its landing or, failing that, at its first bounce."""
    for of in token_subjects(sentence, match.groupdict().get("s")):
        yield Main("displacement", of, "horizontal", FREE, when=When(f"{of} landed".strip()))
        yield Main("displacement", of, "horizontal", FREE, when=When(f"{of} bounced".strip()), rank=1)


def _gets(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the greatest height of a body above its start and, at a lower priority, above the ground."""
    yield from _above_start(match, sentence)
    yield from (replace(main, rank=main.rank + 1) for main in _highest(match, sentence))


def _above_start(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the greatest height of a body above its start, presuming that the body rises."""
    for of in token_subjects(sentence, match.groupdict().get("s")):
        yield Main("greatest height", of, needs=STRETCH, ways=(("", RISING),))
        yield from _rise(of)


def _keeps_on(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the time for which a body moves in one direction, until it turns back."""
    for of in token_subjects(sentence, match["s"]):
        if ways := read_directions(match, of):
            yield Main("time", needs=FREE, ways=ways, when=When(f"{of} stopped", AFTER))
            carried = (*ways, (of, CARRIED_AT_REST))
            still = When(f"velocity of {of} along {ONLY_LINE} = 0 m/s", AFTER)
            yield Main("time", needs=FREE, ways=carried, when=still, rank=1)


def _apsis(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the distance of two bodies at the nearest or farthest point of an orbit, such as the perihelion."""
    del sentence
    near = pattern("NEAREST").fullmatch(match["apsis"]) is not None
    yield Main(f"{'least' if near else 'greatest'} distance", needs=STRETCH)


def _only_pair_reader(*finds: str) -> Reader:
    """Return a reader for quantities of the scene's only pair of bodies, over a stretch of the motion."""
    return pair_reader(*finds, needs=STRETCH)


def _fall(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the time until a body lands, presuming that it never rises."""
    for main in implied_moment_reader("time", "{s} landed", "{s} bounced")(match, sentence):
        yield replace(main, ways=((sentence.subject(match["s"]), FALLS),))


def _period(name: str) -> Reader:
    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        ways = (("", SMALL_OSCILLATIONS),) if re.search(r"\bsmall\b", found[0]) else ()
        for of in token_subjects(heard, found.groupdict().get("s")):
            yield Main(name, of, needs=FREE, ways=ways)

    return read


STRETCHES: Mapping[str, Reader] = {
    # extremes
    "(?:ASK|what) [SIZE ]GREATEST {q=QUANTITY}[ (?:of|in|on) {s}]": _pairs("greatest"),
    "(?:ASK|what) [SIZE ]GREATEST {q=QUANTITY} [that ]~{s} ATTAINS": (_pairs("greatest")),
    "(?:ASK|what) [SIZE ]GREATEST {q=QUANTITY} [is ](?:reached|attained|achieved)[ by {s}]": _pairs("greatest"),
    "ASK {s} 's GREATEST {q=QUANTITY}": _pairs("greatest"),
    "(?:ASK|what) [SIZE ]LEAST {q=QUANTITY}[ (?:of|in|on) {s}]": _pairs("least"),
    "ASK GREATEST {q=QUANTITY} between {s}[ and {t}]": _pairs("greatest"),
    "ASK {s} 's GREATEST distance from {t}": _only_pair_reader("greatest distance"),
    "ASK {s} 's LEAST distance from {t}": _only_pair_reader("least distance"),
    "ASK GREATEST distance of {s} from {t}": _only_pair_reader("greatest distance"),
    "ASK LEAST distance of {s} from {t}": _only_pair_reader("least distance"),
    "[to ](?:what|which) height ~{s} (?:rise|reach|get|climb)": _gets,
    "[to ](?:what|which) height ~{s} (?:rise|reach|get|climb) above its starting point": _above_start,
    "ASK LEAST {q=QUANTITY} between {s}[ and {t}]": _pairs("least"),
    "how far from {t} ~{s} at its (?:farthest|furthest)": _only_pair_reader("greatest distance"),
    "how close to {t} ~{s} at its (?:closest|nearest)": _only_pair_reader("least distance"),
    "how far ~{s} (?:get|gets|go|goes|move|travel|swing) from HOME[ at most]": subject_reader(
        "greatest displacement", needs=STRETCH
    ),
    "how far at most ~{s} (?:get|gets|go|goes|move|travel|swing) from HOME": subject_reader(
        "greatest displacement", needs=STRETCH
    ),
    "ASK {s} 's GREATEST (?:distance|displacement)[ from HOME]": subject_reader("greatest displacement", needs=STRETCH),
    "(?:ASK|what) GREATEST (?:distance|displacement) of {s} from HOME": subject_reader(
        "greatest displacement", needs=STRETCH
    ),
    "(?:ASK|what) GREATEST distance [that ]~{s} ~(?:get|gets|move|moves|go|goes|reach|reaches) from HOME": (
        subject_reader("greatest displacement", needs=STRETCH)
    ),
    "ASK (?P<apsis>(?:NEAREST|FARTHEST)) distance[ of {s}|]": _apsis,
    "ASK {s} 's (?P<apsis>(?:NEAREST|FARTHEST)) distance": _apsis,
    # energy
    "how much HEAT ~LOST[ by friction| to friction| through friction][ IN_ALL]": readers.read_friction_heat,
    "how much work ~{s} ~DONE against friction": readers.read_friction_heat,
    "ASK work DONE[ by {s}] against friction": readers.read_friction_heat,
    "how much work ~DONE against friction": readers.read_friction_heat,
    "how much HEAT ~{s} ~(?:lose|loses|lost|dissipate|dissipates) (?:to|by|through|because of|due to) friction": (
        readers.read_friction_heat
    ),
    "how much HEAT ~friction (?:produced?|generated?|dissipated?|produces|develop)[ IN_ALL]": (
        readers.read_friction_heat
    ),
    "ASK HEAT LOST[ by friction| to friction| through friction]": readers.read_friction_heat,
    "how much work ~(?:hand|pull|pulling force) ~DONE": only_subject_reader("work of a hand", needs=STRETCH),
    "how much work ~(?:hand|pull|pulling force) ~DONE (?:on|upon) {s}": readers.read_hand_work,
    "(?:ASK|what) work [that ]~(?:done by hand|of hand|hand ~DONE) (?:on|upon) {s}": readers.read_hand_work,
    "(?:ASK|what) work (?:done by hand|done by pull|of hand)": only_subject_reader("work of a hand", needs=STRETCH),
    "how much work ~(?:field|electric field|electric force) ~DONE[ on {s}]": subject_reader(
        "work of an electric field", needs=STRETCH
    ),
    "(?:ASK|what) work done on {s} by (?:field|electric field|electric force)": subject_reader(
        "work of an electric field", needs=STRETCH
    ),
    "ASK work done by (?:field|electric field|electric force)[ on {s}]": subject_reader(
        "work of an electric field", needs=STRETCH
    ),
    "how much work ~{t} ~DONE on {s}": readers.work_on,
    "what impulse is exchanged": readers.in_collision("impulse of a collision"),
    "how much energy is lost in all collisions": implied_moment_reader("energy lost in collisions", "last collision"),
    # collisions
    "how much [kinetic ]energy ~(?:lost|dissipated)": readers.in_collision("energy lost in a collision"),
    "ASK (?:loss of kinetic energy|kinetic energy lost|energy lost)": readers.in_collision(
        "energy lost in a collision"
    ),
    "(?:ASK|what) impulse ~{s} (?:give|gives|receive|receives|get|gets|exert|exerts)[ [to|on ]{t}]": (
        readers.in_collision("impulse of a collision")
    ),
    "(?:ASK|what) [SIZE ]impulse [that ]~{s}[ and {t}] (?:exert|give|exchange)[ on| to] each other": (
        readers.in_collision("impulse of a collision")
    ),
    "how much momentum ~(?:SURFACE|wall) (?:transfer|give|impart)[ to] {s}": subject_reader(
        "impulse of an impact", needs=STRETCH
    ),
    "(?:ASK|what) [SIZE ]impulse (?:on|exerted on|given to) {s}": readers.in_collision("impulse of a collision"),
    "(?:ASK|what) impulse ~(?:SURFACE|wall) (?:give|gives|exert|exerts)[ to| on] {s}": subject_reader(
        "impulse of an impact", needs=STRETCH
    ),
    "how many collisions ~(?:there|take place|happen|occur)[ in total| in all| altogether]": readers.count,
    "how much heat arises between {s} and {t}": readers.heat_between,
    "how many collisions between {s}": readers.count_between,
    "how much ~{s} compressed at most": readers.extreme_strain_reader("greatest compression"),
    "how much ~{s} (?:stretched|extended) at most": readers.extreme_strain_reader("greatest extension"),
    "how close ~{s} (?:come|get|comes|gets) to {t}": _only_pair_reader("least distance"),
    "(?:ASK|what) GREATEST angle (?:between |of |[that ]~){s} (?:and|with|~makes? with) [downward ]vertical": (
        subject_reader("greatest deflection", needs=STRETCH)
    ),
    "(?:ASK|what) LEAST angle (?:between |of |[that ]~){s} (?:and|with|~makes? with) [downward ]vertical": (
        subject_reader("least deflection", needs=STRETCH)
    ),
    "how long ~(?:one|a|one full|one complete|full) ROUND take": _period("period"),
    "how many times ~{s} BOUNCES": subject_reader("number of bounces", needs=STRETCH),
    "how often ~{s} BOUNCES": subject_reader("number of bounces", needs=STRETCH),
    # heights
    "how high ~{s} (?:rise|get|go|fly|climb|rises|gets) above SURFACE": _highest,
    "how high above SURFACE ~{s} (?:rise|get|go|fly|climb|rises|gets)": _highest,
    "how high ~{s} (?:rise|get|go|fly|climb|rises|gets)": _gets,
    "(?:to )?(?:how high|what height) above SURFACE ~{s} (?:rise|get|go|fly|climb|rises|gets) (?:before|until)"
    " (?:it|@\\d+@)"
    " [first ]LANDS[ FIRST_TIME]": _before_landing,
    "(?:ASK|what) GREATEST height above SURFACE [that ]~[of |reached by ]{s}[ ATTAINS] (?:before|until) (?:it|@\\d+@)"
    " [first ]LANDS[ FIRST_TIME]": _before_landing,
    "what area ~{s} and {t} sweep": _only_pair_reader("area swept"),
    # times and periods
    "(?:ASK|what) GREATEST height(?: of {s}| reached| attained|) above SURFACE": _highest,
    "(?:ASK|what) GREATEST height above SURFACE [that ]~(?:of |reached by |){s}[ ~reaches| ~reach]": _highest,
    "(?:ASK|what) GREATEST height above HOME [that ]~{s} ATTAINS": _above_start,
    "ASK GREATEST height of {s} above HOME": _above_start,
    "how long ~{s} [keep |continue to |keep on ]{motion=MOTION} {way=WAY}": _keeps_on,
    "how high above its starting point ~{s} (?:rise|get|go|rises|gets)": _above_start,
    "how far ~{s} (?:rise|ascend|rises|ascends)": _above_start,
    "ASK [horizontal ]range of {s}": _range,
    "ASK {s} 's [horizontal ]range": _range,
    "ASK [horizontal ]range[ of (?:throw|flight|shot|projectile|motion|trajectory)]": _range,
    "how far[ horizontally] from [BASE ](?:thrower|cliff|tower|building|wall|table) ~{s} LANDS": _range,
    "how far horizontally[ from HOME] ~{s} LANDS": _range,
    "how far from BASE HOME ~{s} LANDS": _range,
    "(?:with|at) what period ~{s} OSCILLATES": _period("period"),
    "(?:with|at) what frequency ~{s} OSCILLATES": _period("frequency"),
    "[for ]how long ~(?:engine|{s}[ 's engine]) (?:burn|run|fire|work|operate)": implied_moment_reader(
        "time", "burned out"
    ),
    "[for ]how long ~{s} ~[stay |remain ]in (?:air|flight)": implied_moment_reader("time", "{s} landed", "{s} bounced"),
    "how long ~{s} (?:take|need) to fall": _fall,
    "how long ~fuel (?:last|lasts)": implied_moment_reader("time", "burned out"),
    "how long ~{s} burn": implied_moment_reader("time", "burned out"),
    "how long ~{s} (?:slide|slip|skid)[ on {t}| ALONG_IT]": implied_moment_reader(
        "time", "{s} stopped slipping", "{s} stopped"
    ),
    "ASK (?:time of flight|flight time)[ of {s}]": implied_moment_reader("time", "{s} landed", "{s} bounced"),
    "ASK PERIOD of {s}[ 's ITS_MOTION]": _period("period"),
    "ASK PERIOD[ of [its ]ITS_MOTION[ of {s}]]": _period("period"),
    "ASK {s} 's PERIOD[ of (?:revolution|oscillation|rotation)]": _period("period"),
    "ASK frequency of {s}[ 's ITS_MOTION]": _period("frequency"),
    "ASK frequency[ of [its ]ITS_MOTION[ of {s}]]": _period("frequency"),
    "ASK angular frequency of {s}[ 's ITS_MOTION]": _period("angular frequency"),
    "ASK angular frequency[ of [its ]ITS_MOTION[ of {s}]]": _period("angular frequency"),
    "(?:with|at) what angular frequency ~{s} OSCILLATES": _period("angular frequency"),
    "(?:TIME|how long) ~[for ]{s} [to |has |have ](?:completed|made|COMPLETES) (?:one|full|one full) ROUND": _period(
        "period"
    ),
    "how long ~{s} (?:take|need) to (?:go round once|make one revolution|complete one revolution|complete one orbit"
    "|complete one round|go once around|go around once)": _period("period"),
    "how many (?:revolutions|oscillations|swings) per second ~{s} (?:make|complete)": _period("frequency"),
}
"""By what a main clause is like: what reads it. See `mains` for those that ask for a value."""
