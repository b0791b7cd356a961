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
    LATE,
    ONLY_LINE,
    ORBITAL,
    addresses,
    all_of,
    carried_by_light_arm,
    each_of,
    fixed_end,
    line_of,
    relaxed_again,
    strained,
    velocities_equal,
)
from sim2reason.questions.ordinary.reading import Reading
from sim2reason.questions.ordinary.value_readers import ON_AXLE
from sim2reason.questions.ordinary.vocabulary import FIXED_END, FIXED_FACE, ON, RESTS
from sim2reason.questions.phrasing import movers
from sim2reason.questions.posing import AXLE, HEAT, MINUS, PLUS, SUMMED
from sim2reason.questions.query import quantities_named
from sim2reason.questions.structured import START, StructuredQuestion, resolved
from sim2reason.questions.words import ORDINALS, Words
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.quantities.subjects import Sense
from sim2reason.simulation.quantities.subjects.bodies import RIGHT, Bodies, TurningBodies, center_path, turning_axes
from sim2reason.simulation.quantities.subjects.interactions import PAIR_SEPARATOR, Pairs, members
from sim2reason.simulation.quantities.subjects.rotating_parts import SwingingLines
from sim2reason.simulation.trace import Event

EVEN = 1e-9
TURNING = "lowest point", "highest point", "stopped"
SIGNED = ("velocity", "velocity of the centre of mass")
BETWEEN = ("friction force", "normal force", "energy dissipated by friction")
COLLISIONS = ("energy lost in a collision", "impulse of a collision")
_COLLISION = re.compile(
    rf"(?:(?P<number>{'|'.join(ORDINALS)}) )?(?:(?P<who>(?!the )\w+ [A-Z]|the \w+) )?collided(?P<side> before)?"
)
_DEFLECTED = re.compile(r"(?P<who>.+?)(?P<rest> deflected .+)")
_ALONG = re.compile(r"(?P<find>[a-z ]+) of (?P<of>.+) along (?P<axis>\S+) = (?P<value>.+)")
ANGULAR, MOST = ("angular velocity", "angular acceleration"), 6
PERIODS = ("period", "frequency", "angular frequency")


def placed(found: tuple[Reading, ...], words: Words, events: Sequence[Event] = ()) -> Iterator[Reading]:
    """Yield each reading with the scene's names, once for each possible subject if the sentence names none.

    `events` are those of the motion, of which the first collision, or a later one, may be meant.
    """
    for reading in found:
        if (reading.gone or reading.asked.when.endswith("halted")) and not _fits(reading, words):
            continue
        grounded = any(way == f"{ON}{FIXED_FACE}" for _, way in reading.moving)
        for of in (reading.asked.of,) if grounded else _subjects(reading.asked, words):
            asked = replace(reading.asked, of=of)
            if not _of_its_kind(asked, words):
                continue
            asked = replace(asked, along=axis_named(asked.along, asked, words))
            for whens in product(*(list(_hung(part, words)) for part in asked.when.split(MINUS))):
                parts = (_named_by_scene(when, words, events) for when in whens)
                told = MINUS.join(parts) or (START if reading.steady else "")
                asked = replace(asked, of=_pair(asked, told, words))
                yield replace(reading, asked=replace(asked, when=told or _apsis(asked, words)))


def _named_by_scene(when: str, words: Words, events: Sequence[Event]) -> str:
    """Return a moment with the scene's names of pairs and axes, such as *2 s after A & B collided*."""
    late = LATE.match(when)
    told = relaxed_again(when[late.end() :] if late else when, words)
    told = _component(velocities_equal(told, words), words)
    return f"{late[0] if late else ''}{strained(_met(_collided(told, words, events), words), words)}"


def _subjects(asked: StructuredQuestion, words: Words) -> tuple[str, ...]:
    """Return the possible subjects of a question; none if the named one cannot have the quantity."""
    if not asked.of:
        return _unsaid(asked, words) or ("",)
    if asked.of == EVERYTHING:
        return _together(asked.find, words) or each_of(asked.find, words)
    if asked.of == FIXED_END:
        return fixed_end(words)
    if asked.find in ENERGIES and (carried := carried_by_light_arm(asked.of, asked.find, words)):
        return (PLUS.join(carried),)
    return (line_of(asked.of, words),) if asked.find in DEFLECTIONS else _named(asked, words)


def _named(asked: StructuredQuestion, words: Words) -> tuple[str, ...]:
    """Return the named subject or its pair; none if it has no orbit, or if its contact force is ambiguous."""
    quantity = QUANTITIES.get(asked.find)
    if quantity is not None and quantity.of.name == "pair" and " & " not in asked.of:
        if asked.find in ORBITAL and asked.of not in words.called(Bodies()).values():
            return ()  # what is fixed has no orbit
        return (_met(f"{asked.of} closest", words).removesuffix(" closest"),)
    return () if asked.find in BETWEEN and _carries(asked.of, words) else (asked.of,)


def _together(find: str, words: Words) -> tuple[str, ...]:
    """Return all subjects of an additive quantity, joined into one; none for other quantities."""
    every = rubbing(words) if find == HEAT else all_of(find, words) if find in SUMMED else ()
    axles = {turning_axes(words.mechanism, name)[0][0] for name in every if find == AXLE}
    return (PLUS.join(every),) if every and len(axles) < 2 else ()


def _unsaid(asked: StructuredQuestion, words: Words) -> tuple[str, ...]:
    """Return the possible subjects for a sentence that names none; empty if the quantity itself implies the subject."""
    quantity = QUANTITIES.get(asked.find)
    if quantity is not None and asked.find in ANGULAR:
        return ("", *quantity.subjects(words.mechanism)[:MOST])
    if asked.find in PERIODS or asked.find == AMPLITUDE:
        return tuple(movers(words))
    if asked.find == ON_AXLE:
        return tuple(quantity.subjects(words.mechanism)[:1]) if quantity is not None else ()
    if asked.find == HEAT:
        every = rubbing(words)
        return every if len(every) == 1 else ()  # of several, it is the sum
    if quantity is not None and asked.find == "friction force" and words.mechanism.contacts:
        return tuple(name for name in words.called(quantity.of) if quantity.present(words.mechanism, name))
    return ()


def rubbing(words: Words) -> tuple[str, ...]:
    """Return the names of all bodies that may slip on a rough face."""
    functional = FUNCTIONALS[HEAT]
    return tuple(name for name in functional.of.names(words.mechanism) if functional.present(words, name))


def _hung(told: str, words: Words) -> Iterator[str]:
    """Yield texts of a moment: an arm's turning point as that of each body, a swinging line's without a subject."""
    bodies = dict.fromkeys(words.called(Bodies()).values())
    arms = [said for said in words.called(TurningBodies()).values() if said not in bodies]
    lines = [said for said in words.called(SwingingLines()).values() if said not in bodies]
    who = next((said for said in lines if told.startswith(f"{said} ")), "")
    point, arm = told.removeprefix(f"{who} "), next((said for said in arms if told.startswith(f"{said} ")), "")
    deflected = _DEFLECTED.fullmatch(told)
    if deflected is not None:
        told = f"{line_of(deflected['who'], words)}{deflected['rest']}"
    turned = told.removeprefix(f"{arm} ").removesuffix(" before")
    if arm and turned in TURNING:
        yield from (told.replace(arm, said, 1) for said in bodies)
    else:
        yield point if who and point in TURNING else told


def _met(told: str, words: Words) -> str:
    """Return a moment with two bodies, or one of them, replaced by the name of the pair; any other moment unchanged."""
    found = re.match(r"(?:(.+?) & )?(.+?) (collided.*|closest|farthest|orbited.*)", told)
    if found is None or (found[1] is None and found[3].startswith("collided")):
        return told
    named = {said for said in found.groups()[:2] if said}
    pairs = [name for name in words.called(Pairs()) if named <= {words.mentions.get(m, m) for m in members(name)}]
    if not pairs and len(named) == 2:
        by_phrase = {said: name for name, said in words.called(Bodies()).items()}
        if named <= by_phrase.keys():
            return f"{PAIR_SEPARATOR.join(by_phrase[said] for said in sorted(named))} {found[3]}"
    return f"{pairs[0]} {found[3]}" if len(pairs) == 1 else told


def _of_its_kind(asked: StructuredQuestion, words: Words) -> bool:
    """Return whether the named subject, if any, has the quantity asked for."""
    quantity = quantities_named(words.mechanism).get(asked.find)
    if quantity is None or asked.of not in words.mentions.values() or quantity.of.name == TurningBodies.name:
        return True  # a light rod turns as what hangs on it
    return asked.of in words.called(quantity.of).values() or addresses(words).get(asked.of) in quantity.subjects(
        words.mechanism
    )


def _fits(reading: Reading, words: Words) -> bool:
    """Return False if a reading presumes that bodies stay at rest, but there is no friction to bring them to rest."""
    rests = reading.asked.when.endswith("halted") or any(way == RESTS for _, way in reading.gone)
    mechanism = words.mechanism
    rubs = any(face.friction > 0.0 for face in mechanism.faces) or any(c.friction for c in mechanism.contacts.values())
    return rubs or not rests


def _apsis(asked: StructuredQuestion, words: Words) -> str:
    """Return *A & B farthest* or *A & B closest* for an extreme distance in one of several orbits; else empty."""
    pulled = {PAIR_SEPARATOR.join((pull.a, pull.b)) for pull in words.mechanism.attractions}
    apsides = {"greatest distance": "farthest", "least distance": "closest"}
    return (
        f"{asked.of} {apsides[asked.find]}" if len(pulled) > 1 and asked.find in apsides and asked.of in pulled else ""
    )


def _pair(asked: StructuredQuestion, told: str, words: Words) -> str:
    """Return the subject of a question, or the name of the pair that two bodies or their collision form."""
    if " & " in asked.of:
        return _met(f"{asked.of} closest", words).removesuffix(" closest")
    if asked.find in COLLISIONS and (not asked.of or asked.of in words.mentions.values()):
        only = list(words.called(Pairs())) if told.endswith("collided") else []
        return _pair_of(told) or (only[0] if len(only) == 1 else asked.of)
    return asked.of


def _pair_of(told: str) -> str:
    """Return the name of the pair of bodies that collide at a moment; empty if the moment names none."""
    found = re.match(r"(?:\w+ )?(\S+ & \S+) collided", told)
    return found[1] if found is not None else ""


def _collided(told: str, words: Words, events: Sequence[Event]) -> str:
    """Return an unnamed collision, or that of one body, as the named collision with the same number in the motion."""
    found = _COLLISION.fullmatch(told)
    if found is None:
        return told
    if len(words.called(Pairs())) < 2:
        return f"{found['number'] or ''} collided{found['side'] or ''}".strip()
    who = {name for name, said in words.called(Bodies()).items() if said == found["who"]}
    if (found["who"] and not who) or not (found["who"] or found["number"]):
        return told  # *the collision*, of several
    met = [frozenset(event.subjects) for event in events if event.kind == "collision" and who <= {*event.subjects}]
    number = ORDINALS.index(found["number"]) if found["number"] else 0
    if number >= len(met) or any(len(names) != 2 for names in met[: number + 1]):
        return told
    name = next(name for name in Pairs().names(words.mechanism) if frozenset(members(name)) == met[number])
    count = ORDINALS[met[:number].count(met[number])]
    return f"{count} {name} collided{found['side'] or ''}"


def _component(told: str, words: Words) -> str:
    """Return a moment such as *velocity of A along vertical = 2 m/s* with the scene's name in place of *vertical*."""
    found = _ALONG.fullmatch(told)
    if found is None:
        return told
    asked = StructuredQuestion(found["find"], found["of"])
    if found["axis"] == "vertical" and (line := _on_slope(asked, found["value"], words)):
        return line
    if found["axis"] != ONLY_LINE:
        return f"{found['find']} of {found['of']} along {axis_named(found['axis'], asked, words)} = {found['value']}"
    names = [name for name, said in words.called(Bodies()).items() if found["of"] in (name, said)]
    senses = [sense for name in names for sense in Bodies().senses(words.mechanism, name)]
    straight = all(center_path(words.mechanism, name).straight for name in names)
    line = senses[0].positive if len(senses) == 1 and straight else found["axis"]
    return f"{found['find']} of {found['of']} along {line} = {found['value']}"


def _on_slope(asked: StructuredQuestion, value: str, words: Words) -> str:
    """Return a vertical displacement of a body on one sloping line as the displacement along it; else empty."""
    found = addresses(words).get(asked.of, asked.of)
    if asked.find != "displacement" or found not in words.mechanism.body:
        return ""
    senses, (number, _, unit) = Bodies().senses(words.mechanism, found), value.partition(" ")
    path = center_path(words.mechanism, found)
    if not path.straight or len(senses) != 1 or not EVEN < abs(senses[0].vector[2]) < 1.0 - EVEN:
        return ""
    return f"displacement of {asked.of} along {senses[0].positive} = {float(number) / senses[0].vector[2]:.15g} {unit}"


def _carries(of: str, words: Words) -> bool:
    """Return whether another body rides on a named body, which makes a contact force of the latter ambiguous."""
    named = [name for name, said in words.called(Bodies()).items() if of in (name, said)]
    return any(words.mechanism.body[name].parent in named for name in words.mechanism.contacts)


def axis_named(said: str, asked: StructuredQuestion, words: Words) -> str:
    """Return the scene's name for the vertical or the only horizontal axis; any other axis is returned unchanged.

    A velocity on a track along which places are counted has a sign: without an axis, the axis is that to the right.
    """
    quantity = quantities_named(words.mechanism).get(asked.find)
    if quantity is None or said not in ("horizontal", "vertical", *(("",) if asked.find in SIGNED else ())):
        return said
    called = words.called(quantity.of)
    names = {name: called.get(name, name) for name in quantity.subjects(words.mechanism)}
    try:
        senses = quantity.of.senses(words.mechanism, resolved("of", asked.of, names))
    except TextError:
        return said
    if not said:
        return RIGHT if [sense.positive for sense in senses] == [RIGHT] else ""
    if said == "horizontal" and not senses and _level(asked.of, words):
        return ""
    along = [sense for sense in senses if _upright(sense) == (said == "vertical")]
    return (along[0].axis or along[0].positive) if len(along) == 1 else said


def _level(of: str, words: Words) -> bool:
    """Return whether a body can move horizontally only."""
    named = [name for name, said in words.called(Bodies()).items() if of in (name, said)]
    return bool(named) and not center_path(words.mechanism, named[0]).rises


def _upright(sense: Sense) -> bool:
    return abs(sense.vector[2]) > 1.0 - EVEN
