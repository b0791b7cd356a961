"""Assignment of readings to a scene: names of axes, implied subjects, and addresses of numbers."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import product

from sim2reason.errors import TextError
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.ordinary.moment_phrases import (
    AMPLITUDE,
    DEFLECTIONS,
    ENERGIES,
    EVERYTHING,
    LATE_TIME_PATTERN,
    ONLY_LINE,
    ORBITAL,
    addresses,
    all_of,
    carried_by_light_arm,
    each_of,
    extreme_spring_moment,
    fixed_end,
    line_of,
    relaxed_again,
    velocities_equal,
)
from sim2reason.questions.ordinary.reading import Reading
from sim2reason.questions.ordinary.value_readers import ON_AXLE
from sim2reason.questions.ordinary.vocabulary import FIXED_FACE, LINE_WITH_FIXED_END, ON, RESTS
from sim2reason.questions.phrasing import moving_body_phrases
from sim2reason.questions.posing import ADDITIVE_QUANTITIES, AXLE, FRICTION_HEAT, MINUS, PLUS
from sim2reason.questions.query import quantities_named
from sim2reason.questions.structured import START, StructuredQuestion, resolve_name
from sim2reason.questions.words import ORDINALS, Words
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.quantities.subjects import Sense
from sim2reason.simulation.quantities.subjects.bodies import RIGHT, Bodies, TurningBodies, center_path, turning_axes
from sim2reason.simulation.quantities.subjects.interactions import PAIR_SEPARATOR, Pairs, members
from sim2reason.simulation.quantities.subjects.rotating_parts import SwingingLines
from sim2reason.simulation.trace import Event

EVEN = 1e-9
TURNING = "lowest point", "highest point", "stopped"
SIGNED_QUANTITIES = ("velocity", "velocity of the centre of mass")
CONTACT_QUANTITIES = ("friction force", "normal force", "energy dissipated by friction")
COLLISIONS = ("energy lost in a collision", "impulse of a collision")
_COLLISION = re.compile(
    rf"(?:(?P<number>{'|'.join(ORDINALS)}) )?(?:(?P<who>(?!the )\w+ [A-Z]|the \w+) )?collided(?P<side> before)?"
)
_DEFLECTED = re.compile(r"(?P<who>.+?)(?P<rest> deflected .+)")
_ALONG = re.compile(r"(?P<find>[a-z ]+) of (?P<of>.+) along (?P<axis>\S+) = (?P<value>.+)")
ANGULAR, MOST = ("angular velocity", "angular acceleration"), 6
PERIODS = ("period", "frequency", "angular frequency")


def resolve_readings(readings: tuple[Reading, ...], words: Words, events: Sequence[Event] = ()) -> Iterator[Reading]:
    """Yield each reading with the scene's names, once for each possible subject if the sentence names none.

    `events` are those of the motion, of which the first collision, or a later one, may be meant.
    """
    for reading in readings:
        if (reading.gone or reading.asked.when.endswith("halted")) and not _fits(reading, words):
            continue
        grounded = any(presumption == f"{ON}{FIXED_FACE}" for _, presumption in reading.present_directions)
        for of in (reading.asked.of,) if grounded else _subjects(reading.asked, words):
            question = replace(reading.asked, of=of)
            if not _of_its_kind(question, words):
                continue
            question = replace(question, along=axis_named(question.along, question, words))
            for whens in product(*(list(_hung(part, words)) for part in question.when.split(MINUS))):
                parts = (_named_by_scene(when, words, events) for when in whens)
                moment = MINUS.join(parts) or (START if reading.steady else "")
                question = replace(question, of=_pair(question, moment, words))
                yield replace(reading, asked=replace(question, when=moment or _apsis(question, words)))


def _named_by_scene(when: str, words: Words, events: Sequence[Event]) -> str:
    """Return a moment with the scene's names of pairs and axes, such as *2 s after A & B collided*."""
    late = LATE_TIME_PATTERN.match(when)
    moment = relaxed_again(when[late.end() :] if late else when, words)
    moment = _component(velocities_equal(moment, words), words)
    moment = _resolve_collision(_collided(moment, words, events), words)
    return f"{late[0] if late else ''}{extreme_spring_moment(moment, words)}"


def _subjects(question: StructuredQuestion, words: Words) -> tuple[str, ...]:
    """Return the possible subjects of a question; none if the named one cannot have the quantity."""
    if not question.of:
        return _unsaid(question, words) or ("",)
    if question.of == EVERYTHING:
        return _together(question.find, words) or each_of(question.find, words)
    if question.of == LINE_WITH_FIXED_END:
        return fixed_end(words)
    if question.find in ENERGIES and (carried := carried_by_light_arm(question.of, question.find, words)):
        return (PLUS.join(carried),)
    return (line_of(question.of, words),) if question.find in DEFLECTIONS else _named(question, words)


def _named(question: StructuredQuestion, words: Words) -> tuple[str, ...]:
    """Return the named subject or its pair; none if it has no orbit, or if its contact force is ambiguous."""
    quantity = QUANTITIES.get(question.find)
    if quantity is not None and quantity.of.name == "pair" and " & " not in question.of:
        if question.find in ORBITAL and question.of not in words.subject_phrases(Bodies()).values():
            return ()  # what is fixed has no orbit
        return (_resolve_collision(f"{question.of} closest", words).removesuffix(" closest"),)
    return () if question.find in CONTACT_QUANTITIES and _carries(question.of, words) else (question.of,)


def _together(find: str, words: Words) -> tuple[str, ...]:
    """Return all subjects of an additive quantity, joined into one; none for other quantities."""
    every = rubbing(words) if find == FRICTION_HEAT else all_of(find, words) if find in ADDITIVE_QUANTITIES else ()
    axles = {turning_axes(words.mechanism, name)[0][0] for name in every if find == AXLE}
    return (PLUS.join(every),) if every and len(axles) < 2 else ()


def _unsaid(question: StructuredQuestion, words: Words) -> tuple[str, ...]:
    """Return the possible subjects for a sentence that names none; empty if the quantity itself implies the subject."""
    quantity = QUANTITIES.get(question.find)
    if quantity is not None and question.find in ANGULAR:
        return ("", *quantity.subjects(words.mechanism)[:MOST])
    if question.find in PERIODS or question.find == AMPLITUDE:
        return tuple(moving_body_phrases(words))
    if question.find == ON_AXLE:
        return tuple(quantity.subjects(words.mechanism)[:1]) if quantity is not None else ()
    if question.find == FRICTION_HEAT:
        every = rubbing(words)
        return every if len(every) == 1 else ()  # of several, it is the sum
    if quantity is not None and question.find == "friction force" and words.mechanism.contacts:
        return tuple(name for name in words.subject_phrases(quantity.of) if quantity.present(words.mechanism, name))
    return ()


def rubbing(words: Words) -> tuple[str, ...]:
    """Return the names of all bodies that may slip on a rough face."""
    functional = FUNCTIONALS[FRICTION_HEAT]
    return tuple(name for name in functional.of.names(words.mechanism) if functional.present(words, name))


def _hung(moment: str, words: Words) -> Iterator[str]:
    """Yield texts of a moment: an arm's turning point as that of each body, a swinging line's without a subject."""
    bodies = dict.fromkeys(words.subject_phrases(Bodies()).values())
    arms = [phrase for phrase in words.subject_phrases(TurningBodies()).values() if phrase not in bodies]
    lines = [phrase for phrase in words.subject_phrases(SwingingLines()).values() if phrase not in bodies]
    who = next((phrase for phrase in lines if moment.startswith(f"{phrase} ")), "")
    point, arm = (
        moment.removeprefix(f"{who} "),
        next((phrase for phrase in arms if moment.startswith(f"{phrase} ")), ""),
    )
    deflected = _DEFLECTED.fullmatch(moment)
    if deflected is not None:
        moment = f"{line_of(deflected['who'], words)}{deflected['rest']}"
    turned = moment.removeprefix(f"{arm} ").removesuffix(" before")
    if arm and turned in TURNING:
        yield from (moment.replace(arm, phrase, 1) for phrase in bodies)
    else:
        yield point if who and point in TURNING else moment


def _resolve_collision(moment: str, words: Words) -> str:
    """Return a moment with two bodies, or one of them, replaced by the name of the pair; any other moment unchanged."""
    match = re.match(r"(?:(.+?) & )?(.+?) (collided.*|closest|farthest|orbited.*)", moment)
    if match is None or (match[1] is None and match[3].startswith("collided")):
        return moment
    named = {phrase for phrase in match.groups()[:2] if phrase}
    pairs = [
        name for name in words.subject_phrases(Pairs()) if named <= {words.mentions.get(m, m) for m in members(name)}
    ]
    if not pairs and len(named) == 2:
        by_phrase = {phrase: name for name, phrase in words.subject_phrases(Bodies()).items()}
        if named <= by_phrase.keys():
            return f"{PAIR_SEPARATOR.join(by_phrase[phrase] for phrase in sorted(named))} {match[3]}"
    return f"{pairs[0]} {match[3]}" if len(pairs) == 1 else moment


def _of_its_kind(question: StructuredQuestion, words: Words) -> bool:
    """Return whether the named subject, if any, has the quantity asked for."""
    quantity = quantities_named(words.mechanism).get(question.find)
    if quantity is None or question.of not in words.mentions.values() or quantity.of.name == TurningBodies.name:
        return True  # a light rod turns as what hangs on it
    return question.of in words.subject_phrases(quantity.of).values() or addresses(words).get(
        question.of
    ) in quantity.subjects(words.mechanism)


def _fits(reading: Reading, words: Words) -> bool:
    """Return False if a reading presumes that bodies stay at rest, but there is no friction to bring them to rest."""
    rests = reading.asked.when.endswith("halted") or any(presumption == RESTS for _, presumption in reading.gone)
    mechanism = words.mechanism
    rubs = any(face.friction > 0.0 for face in mechanism.faces) or any(c.friction for c in mechanism.contacts.values())
    return rubs or not rests


def _apsis(question: StructuredQuestion, words: Words) -> str:
    """Return *A & B farthest* or *A & B closest* for an extreme distance in one of several orbits; else empty."""
    pulled = {PAIR_SEPARATOR.join((pull.a, pull.b)) for pull in words.mechanism.attractions}
    apsides = {"greatest distance": "farthest", "least distance": "closest"}
    return (
        f"{question.of} {apsides[question.find]}"
        if len(pulled) > 1 and question.find in apsides and question.of in pulled
        else ""
    )


def _pair(question: StructuredQuestion, moment: str, words: Words) -> str:
    """Return the subject of a question, or the name of the pair that two bodies or their collision form."""
    if " & " in question.of:
        return _resolve_collision(f"{question.of} closest", words).removesuffix(" closest")
    if question.find in COLLISIONS and (not question.of or question.of in words.mentions.values()):
        only = list(words.subject_phrases(Pairs())) if moment.endswith("collided") else []
        return _pair_of(moment) or (only[0] if len(only) == 1 else question.of)
    return question.of


def _pair_of(moment: str) -> str:
    """Return the name of the pair of bodies that collide at a moment; empty if the moment names none."""
    match = re.match(r"(?:\w+ )?(\S+ & \S+) collided", moment)
    return match[1] if match is not None else ""


def _collided(moment: str, words: Words, events: Sequence[Event]) -> str:
    """Return an unnamed collision, or that of one body, as the named collision with the same number in the motion."""
    match = _COLLISION.fullmatch(moment)
    if match is None:
        return moment
    if len(words.subject_phrases(Pairs())) < 2:
        return f"{match['number'] or ''} collided{match['side'] or ''}".strip()
    who = {name for name, phrase in words.subject_phrases(Bodies()).items() if phrase == match["who"]}
    if (match["who"] and not who) or not (match["who"] or match["number"]):
        return moment  # *the collision*, of several
    met = [frozenset(event.subjects) for event in events if event.kind == "collision" and who <= {*event.subjects}]
    number = ORDINALS.index(match["number"]) if match["number"] else 0
    if number >= len(met) or any(len(names) != 2 for names in met[: number + 1]):
        return moment
    name = next(name for name in Pairs().names(words.mechanism) if frozenset(members(name)) == met[number])
    count = ORDINALS[met[:number].count(met[number])]
    return f"{count} {name} collided{match['side'] or ''}"


def _component(moment: str, words: Words) -> str:
    """Return a moment such as *velocity of A along vertical = 2 m/s* with the scene's name in place of *vertical*."""
    match = _ALONG.fullmatch(moment)
    if match is None:
        return moment
    question = StructuredQuestion(match["find"], match["of"])
    if match["axis"] == "vertical" and (line := _on_slope(question, match["value"], words)):
        return line
    if match["axis"] != ONLY_LINE:
        return f"{match['find']} of {match['of']} along {axis_named(match['axis'], question, words)} = {match['value']}"
    names = [name for name, phrase in words.subject_phrases(Bodies()).items() if match["of"] in (name, phrase)]
    senses = [sense for name in names for sense in Bodies().senses(words.mechanism, name)]
    straight = all(center_path(words.mechanism, name).straight for name in names)
    line = senses[0].positive if len(senses) == 1 and straight else match["axis"]
    return f"{match['find']} of {match['of']} along {line} = {match['value']}"


def _on_slope(question: StructuredQuestion, value: str, words: Words) -> str:
    """Return a vertical displacement of a body on one sloping line as the displacement along it; else empty."""
    name = addresses(words).get(question.of, question.of)
    if question.find != "displacement" or name not in words.mechanism.body:
        return ""
    senses, (number, _, unit) = Bodies().senses(words.mechanism, name), value.partition(" ")
    path = center_path(words.mechanism, name)
    if not path.straight or len(senses) != 1 or not EVEN < abs(senses[0].vector[2]) < 1.0 - EVEN:
        return ""
    return (
        f"displacement of {question.of} along {senses[0].positive} = {float(number) / senses[0].vector[2]:.15g} {unit}"
    )


def _carries(of: str, words: Words) -> bool:
    """Return whether another body rides on a named body, which makes a contact force of the latter ambiguous."""
    named = [name for name, phrase in words.subject_phrases(Bodies()).items() if of in (name, phrase)]
    return any(words.mechanism.body[name].parent in named for name in words.mechanism.contacts)


def axis_named(axis: str, question: StructuredQuestion, words: Words) -> str:
    """Return the scene's name for the vertical or the only horizontal axis; any other axis is returned unchanged.

    A velocity on a track along which places are counted has a sign: without an axis, the axis is that to the right.
    """
    quantity = quantities_named(words.mechanism).get(question.find)
    if quantity is None or axis not in (
        "horizontal",
        "vertical",
        *(("",) if question.find in SIGNED_QUANTITIES else ()),
    ):
        return axis
    called = words.subject_phrases(quantity.of)
    names = {name: called.get(name, name) for name in quantity.subjects(words.mechanism)}
    try:
        senses = quantity.of.senses(words.mechanism, resolve_name("of", question.of, names))
    except TextError:
        return axis
    if not axis:
        return RIGHT if [sense.positive for sense in senses] == [RIGHT] else ""
    if axis == "horizontal" and not senses and _level(question.of, words):
        return ""
    along = [sense for sense in senses if _upright(sense) == (axis == "vertical")]
    return (along[0].axis or along[0].positive) if len(along) == 1 else axis


def _level(of: str, words: Words) -> bool:
    """Return whether a body can move horizontally only."""
    named = [name for name, phrase in words.subject_phrases(Bodies()).items() if of in (name, phrase)]
    return bool(named) and not center_path(words.mechanism, named[0]).rises


def _upright(sense: Sense) -> bool:
    return abs(sense.vector[2]) > 1.0 - EVEN
