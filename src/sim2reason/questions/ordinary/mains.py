"""Main clauses of questions in ordinary English that ask for a value: a quantity, its subject and its axis."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cache

from sim2reason.questions.ordinary.hearing import Heard
from sim2reason.questions.ordinary.loosely import plainly_ordered
from sim2reason.questions.ordinary.paraphrased_mains import paraphrased
from sim2reason.questions.ordinary.readers import (
    CLAUSED,
    FREE,
    LANDING,
    MOMENT,
    STRETCH,
    Main,
    Reader,
    each,
    of_none,
    of_one,
    of_pair,
)
from sim2reason.questions.ordinary.stretches import STRETCHES
from sim2reason.questions.ordinary.vocabulary import (
    ALOFT,
    COMPRESSED,
    FIXED_FACE,
    LASTS,
    MOTIONS,
    ON,
    ONE_WAY,
    ORIGIN,
    QUANTITIES,
    RESTS,
    SLOWER,
    SOLE,
    WAYS,
    meant,
    pattern,
)
from sim2reason.questions.ordinary.whens import AFTER, When, ways_of
from sim2reason.questions.posing import PLUS, SUMMED

FORCES = "tension", "rod force", "rod pull", "spring force"  # of what lies along a line


def mains(question: str, heard: Heard) -> Iterator[Main]:
    """Yield every meaning of a main clause; nothing if the clause matches no known frame."""
    found = list(_framed(question, heard))
    plain = dict.fromkeys(plainly_ordered(question)) if not found else ()
    found = found or [main for told in plain for main in _framed(told, heard)]
    plain = dict.fromkeys(paraphrased(question)) if not found else ()
    yield from found or (main for told in plain for main in _framed(told, heard))


def _framed(question: str, heard: Heard) -> Iterator[Main]:
    for told, reader in frames().items():
        found = pattern(told).fullmatch(question)
        if found is not None:
            yield from reader(found, heard)


@cache
def frames() -> Mapping[str, Reader]:
    """Return the readers of all main clauses, by the template of the clause."""
    return {**FRAMES, **STRETCHES}


def _quantity(found: re.Match[str], heard: Heard) -> Iterator[Main]:
    """Yield the quantity that a main clause names by a noun, for each subject."""
    groups = found.groupdict()
    name = meant(QUANTITIES, groups["q"])
    axis = meant(WAYS, groups["way"]) if groups.get("way") else groups.get("axis") or ""
    along = axis if axis in AXES else ""
    if name in SUMMED and re.search(r"\b(?:total|combined)\b", found[0]) and len(each(heard, groups.get("s"))) > 1:
        yield Main(name, PLUS.join(each(heard, groups.get("s"))))
        return
    for of in each(heard, groups.get("s")):
        ways = ways_of(found, of) if not along else ()
        yield from _named(name, of, along, ways)


FIELDS = "magnetic force", "electric force", "gravitational force"  # net forces, where nothing else acts
AXES = ("horizontal", "vertical", "x", "y")


def _named(name: str, of: str, along: str, ways: tuple[tuple[str, str], ...]) -> Iterator[Main]:
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


def _fast(found: re.Match[str], heard: Heard) -> Iterator[Main]:
    groups = found.groupdict()
    turns = groups.get("motion") and meant(MOTIONS, groups["motion"], " ") == "turn"
    for of in each(heard, groups["s"]):
        way = meant(WAYS, groups["way"]) if groups.get("way") else ""
        find, along = "angular velocity" if turns else "speed", way if way in AXES else ""
        told = ways_of(found, of)
        sideways = ((of, ONE_WAY),) if any(axis in ("up", "down") for _, axis in told) else ()
        yield Main(find, of, along, ways=() if along else (*told, *sideways))


def _far_flown(found: re.Match[str], heard: Heard) -> Iterator[Main]:
    """Yield the horizontal displacement of a body at its landing."""
    yield from (Main("displacement", of, "horizontal", needs=LANDING) for of in each(heard, found["s"]))


def _far_stopped(found: re.Match[str], heard: Heard) -> Iterator[Main]:
    """Yield the displacement of a body when the body comes to rest for good."""
    for of in each(heard, found["s"]):
        yield Main("displacement", of, needs=FREE, ways=((of, RESTS),), when=When(f"{of} stopped", AFTER))


def _balanced(found: re.Match[str], heard: Heard) -> Iterator[Main]:
    """Yield the value of a quantity in equilibrium, where every body would stay at rest."""
    yield from (replace(main, needs=FREE, when=When("equilibrium")) for main in _quantity(found, heard))


def _initial(found: re.Match[str], heard: Heard) -> Iterator[Main]:
    """Yield the initial value of a quantity, just after the start."""
    yield from (replace(main, needs=FREE, when=When("at start")) for main in _quantity(found, heard))


def _final(found: re.Match[str], heard: Heard) -> Iterator[Main]:
    """Yield the final value of a quantity, after each event that may be the last to change that quantity."""
    for main in _quantity(found, heard):
        for when in ("burned out", "stopped slipping", "collided", "last collision"):
            last = ((main.of, LASTS),)
            yield replace(main, needs=FREE, ways=(*main.ways, *last), when=When(when, AFTER))


def _common(found: re.Match[str], heard: Heard) -> Iterator[Main]:
    """Yield the common speed of bodies that move together, at a named moment or after slipping has stopped."""
    for of in each(heard, found["s"]):
        yield Main("speed", of, needs=CLAUSED)
        yield Main("speed", of, needs=FREE, when=When("stopped slipping", AFTER))


def _coordinate(found: re.Match[str], heard: Heard) -> Iterator[Main]:
    """Yield a body's coordinate along an axis: the displacement, presuming that the body starts at the origin."""
    for of in each(heard, found["s"]):
        yield Main("displacement", of, found["axis"], needs=MOMENT, ways=((of, f"{ORIGIN} {found['axis']}"),))


def _high(found: re.Match[str], heard: Heard) -> Iterator[Main]:
    for of in each(heard, found["s"]):
        yield Main("height above the ground", of, needs=CLAUSED, ways=((of, ALOFT),))


def _far(found: re.Match[str], heard: Heard) -> Iterator[Main]:
    """Yield the displacement of a body and, unless an axis is named, the distance travelled, which must be equal."""
    groups = found.groupdict()
    way = meant(WAYS, groups["way"]) if groups.get("way") else ""
    for of in each(heard, groups["s"]):
        if way in AXES:
            yield Main("displacement", of, way, needs=STRETCH)
        else:
            yield Main("displacement", of, needs=STRETCH, ways=ways_of(found, of))
            yield Main("distance travelled", of, needs=STRETCH, ways=ways_of(found, of))


def _time(found: re.Match[str], heard: Heard) -> Iterator[Main]:
    del found, heard
    yield Main("time", needs=STRETCH)


def _accelerates(found: re.Match[str], heard: Heard) -> Iterator[Main]:
    """Yield the acceleration of a body that speeds up."""
    yield from (Main("acceleration", of, ways=ways_of(found, of)) for of in each(heard, found["s"]))


def _presses(found: re.Match[str], heard: Heard) -> Iterator[Main]:
    """Yield the normal force between a body and the face on which the body lies."""
    face = heard.subject(found["t"])
    for of in each(heard, found["s"]):
        yield Main("normal force", of, ways=((of, f"{ON}{face}"),) if face else ())


def _length_at(turn: str) -> Reader:
    """Return a reader for the length of a spring where the spring is compressed, or stretched, most."""

    def read(found: re.Match[str], heard: Heard) -> Iterator[Main]:
        for of in each(heard, found["s"]):
            yield Main("spring length", of, needs=FREE, when=When(f"{of} {turn}"))

    return read


def _along(found: re.Match[str], heard: Heard) -> Iterator[Main]:
    """Yield the force in a string, rod or spring, which it exerts on a body at its end; none on a pulley between."""
    if "pulley" not in heard.subject(found.groupdict().get("t")):
        yield from (Main(force, heard.subject(found["s"])) for force in FORCES)


def _steep(found: re.Match[str], heard: Heard) -> Iterator[Main]:
    """Yield the angle of a velocity with the horizontal, presuming that the body goes up or down as told."""
    ways = {"above": "up", "below": "down"}
    way = ((heard.subject(found["s"]), ways[found["side"]]),) if found["side"] in ways else ()
    yield Main("angle with the horizontal", heard.subject(found["s"]), needs=CLAUSED, ways=way)


def _fuel(found: re.Match[str], heard: Heard) -> Iterator[Main]:
    """Yield the mass of the fuel that is left or has been burnt."""
    yield Main(f"fuel {found['fuel']}", heard.subject(found["s"]))


def _of_ground(find: str) -> Reader:
    """Return a reader for a force of the fixed surface on a body, even on one that carries others."""

    def read(found: re.Match[str], heard: Heard) -> Iterator[Main]:
        yield from (Main(find, of, ways=((of, f"{ON}{FIXED_FACE}"),)) for of in each(heard, found["s"]))

    return read


def _relatively(name: str) -> Reader:
    """Return a reader for a quantity of a body relative to what carries the body."""

    def read(found: re.Match[str], heard: Heard) -> Iterator[Main]:
        of, on = heard.subject(found["s"]), heard.subject(found["t"])
        ways = ((of, f"{ON}{on}"), *ways_of(found, of))
        yield Main(f"{name} relative to its carrier", of, needs=CLAUSED, ways=ways)

    return read


GAINS = "gain", "gained", "increase", "increased", "rise"


def _potential(found: re.Match[str], heard: Heard) -> Iterator[Main]:
    """Yield the change of a body's potential energy, presuming that the body goes up for a gain and down for a loss."""
    way = "up" if found["verb"] in GAINS else "down"
    for of in each(heard, found["s"]):
        yield Main("potential energy", of, needs=CLAUSED, ways=((of, way),))


FRAMES: Mapping[str, Reader] = {
    "ASK [total |combined ][SIZE ]{q=QUANTITY}[ (?:of|in|on|for|acting on|exerted on|act on) {s}]": _quantity,
    "ASK [total ][SIZE ]{q=QUANTITY} (?:of|in|on) {s} {way=WAY}": _quantity,
    "ASK [SIZE ]{s} 's [total ]{q=QUANTITY}": _quantity,
    "(?:ASK|what|with what|at what) [SIZE ]{q=QUANTITY} [that ]~{s}[ ~HAVE| ~moving| ~{motion=MOTION}]"
    "[ {way=WAY}]": _quantity,
    "ASK (?P<axis>horizontal|vertical|x|y)[ component of|-component of] [velocity|displacement]": _quantity,
    "what (?P<axis>horizontal|vertical) {q=QUANTITY} ~{s}[ ~HAVE]": _quantity,
    "ASK (?P<axis>horizontal|vertical|x|y)(?: component of|-component of|) {s} 's {q=QUANTITY}": _quantity,
    "ASK (?P<axis>horizontal|vertical|x|y)(?: component of|-component of|) {q=QUANTITY} of {s}": _quantity,
    "(?:ASK|what) [SIZE ]{q=QUANTITY} [that ]~[SURFACE ]~(?:exerts|exert|acts|acting|exerted|act) on {s}"
    "[ by SURFACE]": _quantity,
    "(?:ASK|what) {q=QUANTITY} [that ][SURFACE ]~[slows|slow|stops|brakes] {s}[ down]": _quantity,
    "(?:ASK|what) [SIZE ]force [that ]~{s} ~(?:exerts|exert) on {t}": _along,
    "(?:ASK|what) [SIZE ]force (?:of|in|exerted by) {s}[ on {t}]": _along,
    "ASK [SIZE ](?:distance|separation) between {s}[ and {t}]": of_pair("distance"),
    "ASK relative (?:speed|velocity)(?: of| between) {s}[ and {t}]": of_pair("relative speed"),
    "(?:ASK|what) initial [SIZE ]{q=QUANTITY}[ (?:of|in) {s}]": _initial,
    "(?:ASK|what) [SIZE ]initial {q=QUANTITY}[ (?:of|in) {s}]": _initial,
    "ASK {s} 's initial {q=QUANTITY}": _initial,
    "what is shortest length of {s}": _length_at("most compressed"),
    "what is longest length of {s}": _length_at("most stretched"),
    "ASK [SIZE ]{s} force": of_one(*FORCES),
    "(?:with what force|how hard) ~(?:SURFACE|{t}) PRESSES on {s}": _presses,
    "(?:with what force|how hard) ~{s} PRESSES (?:on|against|down on) (?:SURFACE|{t})": _presses,
    "(?:ASK|what) [SIZE ]force [that |with which ]~{s} PRESSES (?:on|against) (?:SURFACE|{t})": _presses,
    "(?:ASK|what) [SIZE ]force [that |with which ]~(?:SURFACE|{t}) PRESSES on {s}": _presses,
    "(?:ASK|what) (?:force|pull) [that |with which ]~{s} (?:pull|pulls|pulling) on {t}": _along,
    "(?:with what force|how hard) ~{s} (?:pull|pulls) on {t}": _along,
    "(?:by )?how much [gravitational ]potential energy ~{s} (?P<verb>gain|gained|lose|lost)": _potential,
    "by how much ~{s} 's [gravitational ]potential energy (?P<verb>increase|increased|rise|decrease|decreased|fall)": (
        _potential
    ),
    "ASK (?P<verb>gain|increase|loss|decrease) (?:in|of) [gravitational ]potential energy[ of {s}]": _potential,
    "how fast ~{s} ~(?:accelerate|accelerates|accelerating|speed up|speeding up)[ {way=WAY}| ALONG_IT]": _accelerates,
    "(?:with|at) what acceleration ~{s} (?:accelerate|speed up)[ {way=WAY}| ALONG_IT]": _accelerates,
    "what [SIZE ]acceleration ~{s} (?:undergo|experience|undergoes|experiences)": of_one("acceleration"),
    "ASK [final ]common (?:speed|velocity) of {s}": _common,
    "ASK common {q=QUANTITY} of {s}": _quantity,
    "ASK equilibrium {q=QUANTITY} of {s}": _balanced,
    "ASK angle (?:of|between|that) {s} (?:with|and|makes with) [downward ]vertical": of_one("deflection"),
    "what angle ~{s} ~(?:make|makes) with [downward ]vertical": of_one("deflection"),
    "what friction of ground on {s}": _of_ground("friction force"),
    "what normal force of ground on {s}": _of_ground("normal force"),
    "what is moment of inertia of {s} about axle": of_one("moment of inertia about the axle"),
    "how fast does {s} move[ {way=WAY}] relative to {t}": _relatively("speed"),
    "how far does {s} move relative to {t}": _relatively("displacement"),
    "what angle {s} makes (?P<side>with|above|below) horizontal": _steep,
    "what angle {s} is deflected through": of_one("angle of deflection"),
    "how much (?P<fuel>left|burnt) fuel[ {s}]": _fuel,
    "(?:ASK|what) [SIZE ]friction[ force| force that] ~[acts |act |acting |exists ]between {s}[ and {t}]": of_none(
        "friction force"
    ),
    "(?:at |from |to )?what (?:height|altitude)[ above SURFACE] ~[{s}]": _high,
    "how much (?:energy|elastic energy|elastic potential energy) ~{s} (?:store|contain|hold|have)": of_one(
        "spring energy"
    ),
    "ASK (?P<axis>x|y)(?: |-)coordinate of {s}": _coordinate,
    "ASK {s} 's (?P<axis>x|y)(?: |-)coordinate": _coordinate,
    "(?:through|by) what angle ~{s} ~MOTION": of_one("angle rolled", "angle turned"),
    "ASK angle through which {s} ~MOTION": of_one("angle rolled", "angle turned"),
    "(?:ASK|what) GREATEST distance [that ]~{s} ~{motion=MOTION}[ {way=WAY}| ALONG_IT]": _far,
    "ASK distance [that ](?:covered|travelled|traveled|moved) by {s}[ {way=WAY}]": _far,
    "ASK distance [that ]~{s} ~{motion=MOTION}[ {way=WAY}]": _far,
    "(?:ASK|what) final {q=QUANTITY}[ of {s}]": _final,
    "ASK {s} 's final {q=QUANTITY}": _final,
    "how high[ above SURFACE] ~[{s}][ above SURFACE]": _high,
    "ASK [SIZE ]height of {s}[ above SURFACE]": _high,
    "how fast ~{s}[ ~{motion=MOTION}][ {way=WAY}| ALONG_IT]": _fast,
    "how fast ~{s}[ and {t}] ~MOTION relative to each other": of_pair("relative speed"),
    "how far ~{s}[ and {t}] apart": of_pair("distance"),
    "how far apart ~(?:centres of )?{s}[ and {t}]": of_pair("distance"),
    "how far ~{s} ~(?:{motion=MOTION}|get|gets|got)[ {way=WAY}| ALONG_IT]": _far,
    "how far {s}": _far_flown,
    "ASK stopping distance(?: of {s}|)": _far_stopped,
    "ASK {s} 's stopping distance": _far_stopped,
    "what {way=HORIZONTAL} distance ~{s} ~{motion=MOTION}": _far,
    "ASK {way=HORIZONTAL} distance [that ]~{s} ~{motion=MOTION}": _far,
    "ASK {way=HORIZONTAL} distance (?:covered|travelled|traveled|moved) by {s}": _far,
    "how far (?:{way=WAY}|ALONG_IT) ~{s} ~{motion=MOTION}": _far,
    "(?:what distance|how much distance) ~{s} ~{motion=MOTION}[ ALONG_IT]": _far,
    "how far from HOME ~{s}": of_one("displacement"),
    "how far ~{s} from HOME": of_one("displacement"),
    "how far from {t} ~{s}": of_pair("distance"),
    "how far ~{s}[ away] from {t}": of_pair("distance"),
    "how long ~{s}": of_one("spring length"),
    "how (?:large|strong|big|great) ~[SIZE ]{q=QUANTITY}[ (?:of|in|on|for|acting on|exerted on) {s}]": _quantity,
    "how much (?:energy ~stored|elastic energy ~stored|energy ~there) in {s}": of_one("spring energy"),
    "how much kinetic energy ~{s}[ have| has]": of_one("kinetic energy"),
    "ASK energy stored in {s}": of_one("spring energy"),
    "(?:by how much|how much|how far) ~{s} (?:stretched|extended|compressed)": of_one("extension"),
    "TIME": _time,
}
"""By what a main clause is like: what reads it."""
