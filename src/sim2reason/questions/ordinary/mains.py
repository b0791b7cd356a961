"""Main clauses of questions in ordinary English that ask for a value: a quantity, its subject and its axis."""

from collections.abc import Iterator, Mapping
from functools import cache

from sim2reason.questions.ordinary import change_readers as change
from sim2reason.questions.ordinary import force_readers as force
from sim2reason.questions.ordinary import shape_readers as shape
from sim2reason.questions.ordinary import value_readers as read
from sim2reason.questions.ordinary.hearing import TokenizedSentence
from sim2reason.questions.ordinary.loosely import plainly_ordered
from sim2reason.questions.ordinary.paraphrased_mains import paraphrased
from sim2reason.questions.ordinary.readers import (
    CLAUSED,
    FREE,
    LANDING,
    STRETCH,
    Main,
    Reader,
    of_none,
    of_one,
    of_pair,
)
from sim2reason.questions.ordinary.stretches import STRETCHES
from sim2reason.questions.ordinary.vocabulary import LEVEL, SMOOTH, pattern


def mains(question: str, heard: TokenizedSentence) -> Iterator[Main]:
    """Yield every meaning of a main clause; nothing if the clause matches no known pattern."""
    found = list(_framed(question, heard))
    plain = dict.fromkeys(plainly_ordered(question)) if not found else ()
    found = found or [main for told in plain for main in _framed(told, heard)]
    plain = dict.fromkeys(paraphrased(question)) if not found else ()
    yield from found or (main for told in plain for main in _framed(told, heard))


def _framed(question: str, heard: TokenizedSentence) -> Iterator[Main]:
    for told, reader in frames().items():
        found = pattern(told).fullmatch(question)
        if found is not None:
            yield from reader(found, heard)


@cache
def frames() -> Mapping[str, Reader]:
    """Return the readers of all main clauses, by the template of the clause."""
    return {**FRAMES, **STRETCHES}


FRAMES: Mapping[str, Reader] = {
    "ASK [total |combined ][SIZE ]{q=QUANTITY}[ (?:of|in|on|for|acting on|exerted on|act on) {s}]": read.quantity,
    "ASK [total ][SIZE ]{q=QUANTITY} (?:of|in|on) {s} {way=WAY}": read.quantity,
    "ASK [SIZE ]{s} 's [total ]{q=QUANTITY}": read.quantity,
    "(?:ASK|what|with what|at what) [SIZE ]{q=QUANTITY} [that ]~{s}[ ~HAVE| ~moving| ~{motion=MOTION}]"
    "[ {way=WAY}]": read.quantity,
    "ASK (?P<axis>horizontal|vertical|x|y)(?: component of|-component of|) {q=QUANTITY}": read.quantity,
    "what (?P<axis>horizontal|vertical) {q=QUANTITY} ~{s}[ ~HAVE]": read.quantity,
    "ASK (?P<axis>horizontal|vertical|x|y)(?: component of|-component of|) {s} 's {q=QUANTITY}": read.quantity,
    "ASK (?P<axis>horizontal|vertical|x|y)(?: component of|-component of|) {q=QUANTITY} of {s}": read.quantity,
    "(?:ASK|what) [SIZE ]{q=QUANTITY} [that ]~[SURFACE ]~(?:exerts|exert|acts|acting|exerted|act) on {s}"
    "[ by SURFACE]": read.quantity,
    "(?:ASK|what) {q=QUANTITY} [that ][SURFACE ]~[slows|slow|stops|brakes] {s}[ down]": read.quantity,
    "(?:ASK|what) [SIZE ]force [that ]~{s} ~(?:exerts|exert) on {t}": read.along,
    "(?:ASK|what) [SIZE ]force (?:of|in|exerted by) {s}[ on {t}]": read.along,
    "ASK [SIZE ](?:distance|separation) between {s}[ and {t}]": of_pair("distance"),
    "ASK relative (?:speed|velocity)(?: of| between) {s}[ and {t}]": of_pair("relative speed"),
    "(?:ASK|what) initial [SIZE ]{q=QUANTITY}[ (?:of|in) {s}]": read.initial,
    "(?:ASK|what) [SIZE ]initial {q=QUANTITY}[ (?:of|in) {s}]": read.initial,
    "ASK {s} 's initial {q=QUANTITY}": read.initial,
    "what is shortest length of {s}": read.length_at("most compressed"),
    "what is longest length of {s}": read.length_at("most stretched"),
    "ASK [SIZE ]{s} force": of_one(*read.FORCES),
    "(?:with what force|how hard) ~(?:SURFACE|{t}) PRESSES on {s}": read.presses,
    "(?:with what force|how hard) ~{s} PRESSES (?:on|against|down on) (?:SURFACE|{t})": read.pushes,
    "(?:ASK|what) [SIZE ]force [that |with which ]~{s} PRESSES (?:on|against) (?:SURFACE|{t})": read.pushes,
    "(?:ASK|what) [SIZE ]force [that |with which ]~(?:SURFACE|{t}) PRESSES on {s}": read.presses,
    "(?:ASK|what) (?:force|pull) [that |with which ]~{s} (?:pull|pulls|pulling) on {t}": read.along,
    "(?:with what force|how hard) ~{s} (?:pull|pulls) on {t}": read.along,
    "(?:by )?how much [gravitational ]potential energy ~{s} (?P<verb>gain|gained|lose|lost)": read.potential,
    "by how much ~{s} 's [gravitational ]potential energy (?P<verb>increase|increased|rise|decrease|decreased|fall)": (
        read.potential
    ),
    "ASK (?P<verb>gain|increase|loss|decrease) (?:in|of) [gravitational ]potential energy[ of {s}]": read.potential,
    "how fast ~{s} ~(?:accelerate|accelerates|accelerating|speed up|speeding up)[ {way=WAY}| ALONG_IT]": (
        read.accelerates
    ),
    "(?:with|at) what acceleration ~{s} (?:accelerate|speed up)[ {way=WAY}| ALONG_IT]": read.accelerates,
    "what [SIZE ]acceleration ~{s} (?:undergo|experience|undergoes|experiences)": of_one("acceleration"),
    "ASK [final ]common (?:speed|velocity) of {s}": read.common,
    "ASK common {q=QUANTITY} of {s}": read.quantity,
    "ASK equilibrium {q=QUANTITY} of {s}": read.balanced,
    "ASK angle (?:of|between|that) {s} (?:with|and|makes with) [downward ]vertical": of_one("deflection"),
    "what angle ~{s} ~(?:make|makes) with [downward ]vertical": of_one("deflection"),
    "what friction of ground on {s}": read.of_ground("friction force"),
    "what normal force of ground on {s}": read.of_ground("normal force"),
    "what is moment of inertia of {s} about axle": of_one("moment of inertia about the axle"),
    "how fast does {s} move[ {way=WAY}] relative to {t}": shape.relatively("speed"),
    "how far does {s} move relative to {t}": shape.far_on,
    "what angle {s} makes (?P<side>with|above|below) horizontal": read.steep,
    "what angle {s} is deflected through": of_one("angle of deflection"),
    "how much (?P<fuel>left|burnt) fuel[ {s}]": read.fuel,
    "(?:ASK|what) [SIZE ]friction[ force| force that] ~[acts |act |acting |exists ]between {s}[ and {t}]": of_none(
        "friction force"
    ),
    "(?:at |from |to )?what (?:height|altitude)[ above SURFACE][ ~[{s}]]": read.high,
    "how much (?:energy|elastic energy|elastic potential energy) ~{s} (?:store|contain|hold|have)": of_one(
        "spring energy"
    ),
    "how far does {s} move in one oscillation": of_one("distance travelled", needs=FREE),
    "where is {s} on its line": shape.on_line,
    "(?:through|by) what angle ~{s} ~MOTION": of_one("angle rolled", "angle turned"),
    "ASK angle through which {s} ~MOTION": of_one("angle rolled", "angle turned"),
    "(?:ASK|what) GREATEST distance [that ]~{s} ~{motion=MOTION}[ {way=WAY}| ALONG_IT]": read.far,
    "ASK distance [that ](?:covered|travelled|traveled|moved) by {s}[ {way=WAY}]": read.far,
    "ASK distance [that ]~{s} ~{motion=MOTION}[ {way=WAY}]": read.far,
    "(?:ASK|what) final {q=QUANTITY}[ of {s}]": read.final,
    "ASK {s} 's final {q=QUANTITY}": read.final,
    "how high[ above SURFACE] ~[{s}][ above SURFACE]": read.high,
    "ASK [SIZE ]height of {s}[ above SURFACE]": read.high,
    "how fast ~{s}[ ~{motion=MOTION}][ {way=WAY}| ALONG_IT]": read.fast,
    "how fast ~{s}[ and {t}] ~MOTION relative to each other": of_pair("relative speed"),
    "how fast ~{s}[ and {t}] near or part": read.nears,
    "how far ~{s}[ and {t}] apart": of_pair("distance"),
    "how far apart ~(?:centres of )?{s}[ and {t}]": of_pair("distance"),
    "how far ~{s} ~(?:{motion=MOTION}|get|gets|got)[ {way=WAY}| ALONG_IT]": read.far,
    "how far {s}": read.far_flown,
    "ASK stopping distance(?: of {s}|)": read.far_stopped,
    "ASK {s} 's stopping distance": read.far_stopped,
    "what {way=HORIZONTAL} distance ~{s} ~{motion=MOTION}": read.far,
    "ASK {way=HORIZONTAL} distance [that ]~{s} ~{motion=MOTION}": read.far,
    "ASK {way=HORIZONTAL} distance (?:covered|travelled|traveled|moved) by {s}": read.far,
    "how far (?:{way=WAY}|ALONG_IT) ~{s} ~{motion=MOTION}": read.far,
    "(?:what distance|how much distance) ~{s} ~{motion=MOTION}[ ALONG_IT]": read.far,
    "how far from origin ~{s}": of_one("distance from the origin"),
    "how far ~{s}[ away] from origin": of_one("distance from the origin"),
    "how far from HOME ~{s}": of_one("displacement"),
    "how far ~{s} from HOME": of_one("displacement"),
    "how far from {t} ~{s}": of_pair("distance"),
    "how far ~{s}[ away] from {t}": of_pair("distance"),
    "how long ~{s}": of_one("spring length"),
    "how (?:large|strong|big|great) ~[SIZE ]{q=QUANTITY}[ (?:of|in|on|for|acting on|exerted on) {s}]": read.quantity,
    "how much (?:energy ~stored|elastic energy ~stored|energy ~there) in {s}": change.stored,
    "how much kinetic energy ~{s}[ have| has]": of_one("kinetic energy"),
    "ASK energy stored in {s}": change.stored,
    "(?:by how much|how much|how far) ~{s} (?:stretched|extended|compressed)": of_one("extension"),
    "how much {q=QUANTITY} ~[{s} ](?P<verb>gain|lose|change)": change.changed,
    "how far (?P<side>up|down) is {s}": read.far_off,
    "what whole force of ground on {s}": read.of_ground("normal force", SMOOTH),
    "what force acts on {s}": read.of_fields,
    "how many times does {s} reverse": of_one("number of reversals", needs=CLAUSED),
    "how much mechanical energy ~(?:lost|lose)": change.lost_in_impact,
    "what angle {s} hits at": of_one("angle with the horizontal", needs=LANDING),
    "ASK moment of inertia about [its ]axle": read.all_about_axle,
    "what is power of hand": of_none("power of a hand"),
    "how far altogether ~{s} move[ {way=WAY}]": read.far_in_all,
    "how far vertically (?P<side>below|above) its start is {s}": read.far_vertically,
    "what upward force of ground on {s}": read.of_ground("normal force", LEVEL),
    "what is period of {s} about {t}": read.of_orbit,
    "how many turns does {s} make": of_one("revolutions made", needs=CLAUSED),
    "(?:ASK|what) {q=QUANTITY} (?:of|in) {s} ,? ?(?:taking|counting|reckoning|with|if) (?P<way>upwards?|right|to"
    " right) "
    "(?:direction )?~(?:counted |taken )?as positive": read.signed,
    "how much mechanical energy ~{s} lose": change.lost_in_impact,
    "what force of guide on[ {s}]": of_one("force of the guide"),
    "what force of string on pulley {s} {t}": force.on_pulley,
    "what force of its string on pulley {s}": force.on_that_pulley,
    "what force of the one string on pulley {s}": force.on_free_pulley,
    "what force bears axle[ {s}][ {t}]": force.on_axle,
    "what greatest force bears axle[ {s}]": of_one("greatest axle force", needs=STRETCH),
    "how near to far end does {s} get[ {t}]": shape.far_end("most compressed"),
    "how far from far end does {s} get[ {t}]": shape.far_end("most stretched"),
    "how far from far end is {s}[ {t}]": shape.far_end(),
    "what force on hook[ {s}]": force.on_hook,
    "how fast does mass centre move[ {s}]": shape.mass_center,
    "what is amplitude[ of {s}]": shape.amplitude,
    "what is inertia of {s} about its axis": shape.own_axis,
    "what is centre of mass offset of {s}": of_one("centre of mass offset"),
    "how far is {s} from axle": of_one("distance from the axle"),
    "how far is {s} from (?P<axis>x|y) axis": shape.from_axis,
    "how far (?P<most>at most )?(?P<side>above|below|left|right) of (?P<axis>x|y) axis is {s}": shape.beside_axis,
    "what is speed of {s} relative to {t}": shape.relatively("speed"),
    "what is acceleration of {s} relative to {t}": shape.acceleration_on,
    "how far does {s} move along {t}": shape.far_on,
    "how fast does {s} go down": shape.down,
    "how much energy is lost to drag[ by {s}]": of_one("energy lost to drag", needs=STRETCH),
    "how much work does spring {s} do on {t}": shape.work_of_spring,
    "how long is {s} moving": shape.moving,
    "how far vertically is {s}": of_one(read.ABOVE, needs=STRETCH),
    "how much momentum does {s} exchange": change.exchanged,
    "what is power of gravity on {s}": of_one("power of gravity"),
    "how fast does length of {s} change": of_one("rate of change of length"),
    "how much does length of {s} change": of_one("length", needs=CLAUSED),
    "what is stiffness of {s}": of_one("stiffness"),
    "TIME": read.time,
}
"""By what a main clause is like: what reads it."""
