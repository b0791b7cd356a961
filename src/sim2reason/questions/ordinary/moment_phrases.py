"""Moments in questions, the splitting of a sentence at them, and moments given by multiples."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

from sim2reason.errors import TextError
from sim2reason.questions.following import FollowedMotion, SimulatedAnswer
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.functionals.aggregates import Extreme
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.times import WholeMotion
from sim2reason.questions.ordinary.vocabulary import DIRECTION_WORDS, DOWN, MOTIONS, ROLL, ROLLING, UP, matching_entry
from sim2reason.questions.posing import PosedQuestion, pose_question
from sim2reason.questions.query import Query, quantities_named
from sim2reason.questions.structured import START, StructuredQuestion
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.fields import Resistance
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import Elastic
from sim2reason.simulation.quantities.subjects.bodies import DIRECTION_TOL, Bodies, ancestor_chain
from sim2reason.simulation.quantities.subjects.interactions import PAIR_SEPARATOR, STRETCHED, Springs
from sim2reason.simulation.quantities.subjects.rotating_parts import Pulleys, SwingingLines

EVERYTHING = "everything"  # all subjects of a quantity together


def addresses(words: Words) -> Mapping[str, str]:
    """Return the names of bodies by the phrases that denote only one body; for a pulley, the name of its carrier."""
    mechanism, by_phrase = words.mechanism, dict[str, str]()
    phrases = list(words.mentions.values())
    for address, said in words.mentions.items():
        carriers = {site.body for site in mechanism.site.values() if site.name.startswith(f"{address}.")}
        name = address if address in mechanism.body else next(iter(carriers)) if len(carriers) == 1 else None
        if name is not None and phrases.count(said) == 1:
            by_phrase[said] = name
    return by_phrase


def addressed(question: StructuredQuestion, words: Words) -> StructuredQuestion:
    """Return a question with addresses in place of phrases that denote one body."""
    of, when = question.of, question.when
    for said, name in addresses(words).items():
        of = name if of == said else of
        when = re.sub(rf"(?<!\S){re.escape(said)}(?= )", name, when)
        if name not in words.subject_phrases(Bodies()):
            when = re.sub(rf"(?<!\S){re.escape(name)} moved (?=[\d.])", f"displacement of {name} = ", when)
    return replace(question, of=of, when=when)


def seen_from(question: StructuredQuestion, words: Words) -> StructuredQuestion:
    """Return a question for the relative speed of two bodies that never meet as one for their relative velocity."""
    names = [addresses(words).get(said, said) for said in question.of.split(" & ")]
    if question.find != "relative speed" or len(names) != 2 or not set(names) <= words.mechanism.body.keys():
        return question
    return replace(question, find="relative velocity", of=PAIR_SEPARATOR.join(names))


def all_of(find: str, words: Words) -> tuple[str, ...]:
    """Return the names of all heavy bodies, or of all springs, that have a quantity."""
    quantity, mechanism = quantities_named(words.mechanism).get(find), words.mechanism
    if quantity is None:
        return ()
    light = {name for name, body in mechanism.body.items() if body.mass == 0.0}
    return tuple(name for name in quantity.subjects(mechanism) if name not in light)


BEFORE, AFTER, THEN, DURING = "before", "after", "then", "during"
_SIDES: Mapping[str, str] = {
    BEFORE: "just before|immediately before|right before|shortly before|before|prior to",
    AFTER: "just after|immediately after|right after|directly after|shortly after|after|following|by|as result"
    " of|because of|due to|as consequence of",
    THEN: "at instant of|at moment of|at time of"
    "|at moment when|at instant when|at moment at which|at instant at which|at moment|at instant|at time when"
    "|moment|instant|by time|by time that|as soon as|when|once|as|until|till|right at|just as|right when|at|in|over|for"
    "|from release until|at end of|up to|up until|up to moment when|up to instant when|until moment when"
    "|up to point where|from start until|from release to moment when|at point where|whenever|at which",
    DURING: "during|while|on",
}
ONLY_LINE = "itself"  # the axis of a component along the only line on which a body can move
CONNECTORS: Mapping[str, str] = {said: side for side, row in _SIDES.items() for said in row.split("|")}
"""By what a clause begins with: on which side of what it names it asks."""
_CONNECTED = re.compile(rf"(?:^|(?<= ))(?:{'|'.join(sorted(CONNECTORS, key=len, reverse=True))})(?= )")
_BESIDE = re.compile(
    r"(?:(?<= over)|(?<= on)|(?<= in)|(?<= by)) @\d+@ #\d+# (?:after|later)\b"
    r"|(?:(?<= over)|(?<= on)) @\d+@ (?:in|within|during|after|by|until|before|when|once) "
)
_LASTING = re.compile(r"[^,]*\b(?:roll|slip|slid|skid|together|bounced off|collided|collision|been hit|been struck)")
"""What is so from the moment on that a clause with *once* names."""
_ENDED = re.compile(
    r" @\d+@ (?:has|have) (?:finally come to (?:rest|stop|standstill)|come to (?:rest|stop|standstill) for good)\b"
)
_GOING_ON = re.compile(r" (?:@\d+@|they|both) (?:is|are) (?:still )?(?:sliding|moving|slipping|in motion)$")
_DELAY = re.compile(r"(?:^|(?<= ))#\d+# (?=after )")


@dataclass(frozen=True, slots=True)
class When:
    """A moment by name, the side of the moment, and the presumed directions of bodies until then.

    `told` is empty for the whole motion. `ways` has the subject and *up*, *down*, … of each presumption. A moment of a
    higher `rank` counts only where the scene has none of a lower rank.
    """

    told: str
    side: str = THEN
    ways: tuple[tuple[str, str], ...] = ()
    rank: int = 0


def split(text: str) -> Iterator[tuple[str, str, str]]:
    """Yield every split of a sentence into a question, a clause and the clause's side, the whole sentence first."""
    yield text, "", ""
    for ending in (" initially", " at first"):
        if text.endswith(ending):
            yield text.removesuffix(ending), "start", THEN
    for match in _DELAY.finditer(text):
        if match.start() > 0:
            yield text[: match.start()].strip(" ,"), text[match.start() :].strip(), THEN
        elif " , " in text:
            clause, _, question = text.partition(" , ")
            yield question.strip(), clause.strip(), THEN
    for match in _CONNECTED.finditer(text):
        if _BESIDE.match(text, match.end()) or (match[0] == "on" and text[: match.start()].endswith(" done ")):
            continue  # *sliding over the box 2 s after release*: no time of the box; *the work done on B*
        side = AFTER if match[0] == "once" and _LASTING.match(text, match.end()) else CONNECTORS[match[0]]
        side = AFTER if match[0] in ("when", "once") and _ENDED.match(text, match.end()) else side
        side = DURING if match[0] == "once" and _GOING_ON.match(text, match.end()) else side
        if match.start() > 0:
            yield text[: match.start()].strip().rstrip(" ,"), text[match.end() :].strip(), side
        elif " , " in text:
            clause, _, question = text[match.end() :].partition(" , ")
            yield question.strip(), clause.strip(), side


def read_directions(match: re.Match[str], who: str) -> tuple[tuple[str, str], ...]:
    """Return the directions in which a subject moves, as given by the matched verb and adjacent words."""
    groups = match.groupdict()
    verb = matching_entry(MOTIONS, groups["motion"], " ") if groups.get("motion") else ""
    verb_directions = {UP: ("up",), DOWN: ("down",), ROLL: (ROLLING,)}.get(verb, ())
    beside = matching_entry(DIRECTION_WORDS, groups["way"]) if groups.get("way") else ""
    return tuple((who, direction) for direction in dict.fromkeys((*verb_directions, *((beside,) if beside else ()))))


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


def velocities_equal(moment: str, words: Words) -> str:
    """Return the moment when two bodies on a line have the same velocity, by addresses; any other moment unchanged."""
    match = _EQUAL.fullmatch(moment)
    if match is None:
        return moment
    by_phrase = {said: name for name, said in words.subject_phrases(Bodies()).items()}
    names = [by_phrase.get(match[key], "") for key in ("one", "other")]
    if not all(names):
        return moment
    senses = [Bodies().senses(words.mechanism, name) for name in names]
    if senses[0] != senses[1] or len(senses[0]) != 1:
        return moment
    return f"relative velocity of {PAIR_SEPARATOR.join(names)} along {senses[0][0].positive} = 0 m/s"


def relaxed_again(moment: str, words: Words) -> str:
    """Return the moment when a spring that is relaxed at first is relaxed again; any other moment unchanged."""
    who, parted, _ = moment.rpartition(" natural length")
    springs = words.subject_phrases(Springs())
    names = [name for name, said in springs.items() if said == who] or list(Springs().names(words.mechanism))
    if not parted or len(names) != 1:
        return moment
    line = words.mechanism.line[names[0]]
    assert isinstance(line.law, Elastic)
    strained = abs(float(initial_frames(words.mechanism).length(line)) - line.law.length) > DIRECTION_TOL or line.wheels
    return moment if strained else f"extension of {names[0]} along {STRETCHED} = 0 m"


def extreme_spring_moment(moment: str, words: Words) -> str:
    """Return the moment when a spring is shortest or longest if its ends are closest or farthest; else `moment`."""
    match = _NEAREST.fullmatch(moment)
    ends = {match["one"], match["other"]} if match is not None else set[str]()
    for name in Springs().names(words.mechanism) if match is not None else ():
        line = words.mechanism.line[name]
        tied = {words.mechanism.site[site].body for site in (line.through[0], line.through[-1])}
        if tied == ends and not line.wheels:
            return f"{name} {'most compressed' if match and match['how'] == 'closest' else 'most stretched'}"
    return moment


def line_of(said: str, words: Words) -> str:
    """Return the phrase for the only swinging line in place of that for its body or its rod; any other unchanged."""
    lines = words.subject_phrases(SwingingLines())
    if said in lines.values() or len(lines) != 1:
        return said
    (name,) = lines
    of_line = f"{name.rpartition('.')[0]}."  # the pendulum, or the arm, to which the line belongs
    if not any(phrase == said and address.startswith(of_line) for address, phrase in words.mentions.items()):
        return said
    return next(iter(lines.values()))


def carried_by_light_arm(said: str, find: str, words: Words) -> tuple[str, ...]:
    """Return the bodies that have a quantity and are carried by a light arm; none if the phrase means no such arm."""
    mechanism = words.mechanism
    arms = {
        body.name
        for body in mechanism.bodies
        if words.mentions.get(body.name) == said and body.mass == 0.0 and not any(body.inertia)
    }
    turning = {name for name in arms if any(c.kind == "hinge" for c in mechanism.body[name].coordinates)}
    carriers = {name: {body.name for body in ancestor_chain(mechanism, name)[1:]} for name in all_of(find, words)}
    return tuple(name for name, above in carriers.items() if above & turning)


def fixed_end(words: Words) -> tuple[str, ...]:
    """Return the name of the only string or spring with an end fixed in place; none if there are several."""
    mechanism, wheels = words.mechanism, Pulleys().names(words.mechanism)
    ends = {line.name: (line.through[0], line.through[-1]) for line in mechanism.lines}
    fixed = [
        name
        for name, sites in ends.items()
        if any(mechanism.site[site].body is None and site.rpartition(".")[0] not in wheels for site in sites)
    ]
    return tuple(fixed) if len(fixed) == 1 else ()


TIMES, GREATEST, AT_BURNOUT = " times that at start", " times the greatest", " times that at burnout"
_MULTIPLE = re.compile(
    rf"(?P<find>[a-z ]+?)(?: of (?P<of>.+))? = (?P<factor>[\d.]+)(?P<ref>{TIMES}|{GREATEST}|{AT_BURNOUT})"
)
SPEEDS = {"velocity": "speed", "angular velocity": "angular speed"}  # names of greatest values
LONG, PAST = "after a long time", " after "
LATE_TIME_PATTERN = re.compile(rf"(?P<late>[\d.e-]+) (?P<unit>\S+){PAST}")
_LATER = re.compile(rf"{LATE_TIME_PATTERN.pattern}(?P<event>.*collided)")
STEADY_EXTREME_RTOL = 0.3  # relative: extremes that differ by more do not belong to a steady oscillation
DOUBLINGS, SETTLED = 10, 1e-7  # doublings of the duration, and the relative change below which a value is constant


def in_numbers(structured: StructuredQuestion, motion: FollowedMotion, words: Words) -> StructuredQuestion:
    """Return a question whose relative moment, such as *when its speed has doubled*, is replaced by a value or time.

    Raises:
        TextError: there is no such quantity, or it is zero at the start, or never settles down, or nothing collides.
    """
    if structured.when == LONG:
        return _settled(structured, motion, words)
    later = _LATER.fullmatch(structured.when)
    if later is not None:
        return _later(structured, later, motion, words)
    match = _MULTIPLE.fullmatch(structured.when)
    if match is None:
        return structured
    find, of = match["find"], f" of {match['of']}" if match["of"] else ""
    if match["ref"] == GREATEST:
        initial = _greatest(StructuredQuestion(f"greatest {SPEEDS.get(find, find)}", match["of"] or ""), motion, words)
    else:
        when = "burned out" if match["ref"] == AT_BURNOUT else START
        initial = pose_question(StructuredQuestion(find, match["of"] or "", when), motion, words)
    value = initial.simulate_answer(motion).answer
    if not value:
        raise TextError("when", f"the {find} is zero at the start, or never greatest", "give a value")
    moment = f"{find}{of} = {float(match['factor']) * value:.15g} {initial.unit(words)}"
    return replace(structured, when=moment)


def _greatest(structured: StructuredQuestion, motion: FollowedMotion, words: Words) -> PosedQuestion:
    """Return the question for a greatest value in a periodic motion only, as other motions have no clear maximum."""
    posed = pose_question(structured, motion, words)
    moment = posed.query.moment
    assert isinstance(moment, WholeMotion)
    return replace(posed, query=replace(posed.query, moment=replace(moment, ends=False)))


def _settled(structured: StructuredQuestion, motion: FollowedMotion, words: Words) -> StructuredQuestion:
    """Return a question at a time so late that the answer, an extreme or a limit in a medium, is constant."""
    resisted = any(isinstance(force.law, Resistance) for force in words.mechanism.forces)
    if structured.find == "time" or not (resisted or structured.find.startswith(("greatest", "least"))):
        raise TextError("when", "nothing settles down here", "name a moment")
    until, unit, before = motion.study.scene.horizon, words.mechanism.units.time, list[float]()
    for _ in range(DOUBLINGS):
        timed = replace(structured, when=f"at {until:.15g} {unit}")
        question = pose_question(timed, motion, words)
        followed = question.simulate_answer(motion)
        answer = followed.answer
        if answer is None:
            break
        before.append(answer)
        size = SETTLED * max(map(abs, before))
        same = len(before) > 2 and all(abs(each - answer) <= size for each in before[-3:])
        if same and (resisted or _nothing_greater(question.query, followed)):
            return timed
        until *= 2.0
    raise TextError("when", "it never settles down", "name a moment")


def _nothing_greater(query: Query, followed: SimulatedAnswer) -> bool:
    """Return whether an extreme recurs in the second half of the motion, or is far from all values there.

    Where many periods mix, the extremes of the second half of the motion come near to those of the first half, and
    greater ones may follow at any time.
    """
    trace, answer = followed.study.trace, followed.answer
    extreme = FUNCTIONALS[query.functional] if isinstance(query, StretchQuery) else None
    if not isinstance(extreme, Extreme) or not isinstance(query, StretchQuery) or answer is None:
        return False
    end = trace.stable_until
    late = extreme.extreme_between(trace, query.name, 0.5 * end, end)
    if late is None:
        return False
    again, size = abs(late - answer) <= SETTLED * abs(answer), max(abs(late), abs(answer))
    return again or abs(late - answer) > STEADY_EXTREME_RTOL * size


def _later(
    structured: StructuredQuestion, match: re.Match[str], motion: FollowedMotion, words: Words
) -> StructuredQuestion:
    """Return a question with a time counted from the start, for one counted from a collision."""
    began = pose_question(StructuredQuestion("time", "", match["event"]), motion, words)
    answer = began.simulate_answer(motion).answer
    if answer is None or began.unit(words) != match["unit"] or structured.find == "time":
        raise TextError("when", "there is no such collision", "name a moment")
    return replace(structured, when=f"at {answer + float(match['late']):.15g} {match['unit']}")
