"""Main clauses of questions in ordinary English that ask for a value: a quantity, its subject and its axis."""

import re
from collections.abc import Iterator, Mapping
from functools import cache

from sim2reason.questions.ordinary import changes, readers
from sim2reason.questions.ordinary import value_readers as read
from sim2reason.questions.ordinary.hearing import TokenizedSentence
from sim2reason.questions.ordinary.paraphrases import paraphrased
from sim2reason.questions.ordinary.readers import (
    CLAUSED,
    FREE,
    LANDING,
    STRETCH,
    Main,
    Reader,
    only_subject_reader,
    pair_reader,
    subject_reader,
)
from sim2reason.questions.ordinary.stretches import STRETCHES
from sim2reason.questions.ordinary.vocabulary import LEVEL, SMOOTH, WORDS, pattern

FILLERS = {
    *re.split(" ", WORDS["AUX"]),
    *re.split(
        " ", "what which find determine calculate compute give how large big great strong much value magnitude size"
    ),
    *re.split(" ", "of in on that for with at then have get reach reaches attain attains acquire acquires possess"),
    *re.split(" ", "experience experiences undergo undergoes feel feels act acts acting exerted exert exerts"),
}
"""Words that say nothing beside a quantity and what has it."""
ORDER = {"initial": "initial", "GREATEST": "greatest", "LEAST": "least", "final": "final"}
PLAIN_CLAUSES: Mapping[str, str] = {
    "": "what is {quantity}{of}",
    "initial": "what is initial {quantity}{of}",
    "final": "what is final {quantity}{of}",
    "greatest": "what is greatest {quantity}{of}",
    "least": "what is least {quantity}{of}",
}
"""By what qualifies a quantity, the plain order of words."""
_QUANTITY, _SUBJECT, _ASKS = pattern("QUANTITY"), re.compile(r"@\d+@"), re.compile(r"\b(?:what|which|find|how)\b")


def plainly_ordered(question: str) -> Iterator[str]:
    """Yield the plain word order of a clause that has one quantity, at most one subject, and otherwise only fillers."""
    quantities = re.findall(rf"(?<![\w-])(?:{_QUANTITY.pattern})(?![\w-])", question)
    subjects = _SUBJECT.findall(question)
    if len(quantities) != 1 or len(set(subjects)) > 1 or _ASKS.search(question) is None:
        return
    rest = _SUBJECT.sub(" ", question.replace(quantities[0], " ", 1)).replace("'s", " ").replace(",", " ")
    frame = ""
    for template, name in ORDER.items():
        rest, count = re.subn(rf"\b{pattern(template).pattern}\b", " ", rest)
        if count and (frame or count > 1):
            return
        frame = name if count else frame
    if not set(rest.split()) - FILLERS:
        of = f" of {subjects[0]}" if subjects else ""
        yield PLAIN_CLAUSES[frame].format(quantity=quantities[0], of=of)


def read_main_clause(question: str, sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield every meaning of a main clause; nothing if the clause matches no known pattern."""
    meanings = list(_read_frames(question, sentence))
    plain = dict.fromkeys(plainly_ordered(question)) if not meanings else ()
    meanings = meanings or [main for paraphrase in plain for main in _read_frames(paraphrase, sentence)]
    plain = dict.fromkeys(paraphrased(question)) if not meanings else ()
    yield from meanings or (main for paraphrase in plain for main in _read_frames(paraphrase, sentence))


def _read_frames(question: str, sentence: TokenizedSentence) -> Iterator[Main]:
    for template, reader in main_clause_readers().items():
        match = pattern(template).fullmatch(question)
        if match is not None:
            yield from reader(match, sentence)


@cache
def main_clause_readers() -> Mapping[str, Reader]:
    """Return the readers of all main clauses, by the template of the clause."""
    return {**MAIN_CLAUSE_FRAMES, **STRETCHES}


MAIN_CLAUSE_FRAMES: Mapping[str, Reader] = {
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
    "(?:ASK|what) [SIZE ]force [that ]~{s} ~(?:exerts|exert) on {t}": read.read_line_force,
    "(?:ASK|what) [SIZE ]force (?:of|in|exerted by) {s}[ on {t}]": read.read_line_force,
    "ASK [SIZE ](?:distance|separation) between {s}[ and {t}]": pair_reader("distance"),
    "ASK relative (?:speed|velocity)(?: of| between) {s}[ and {t}]": pair_reader("relative speed"),
    "(?:ASK|what) initial [SIZE ]{q=QUANTITY}[ (?:of|in) {s}]": read.read_initial_value,
    "(?:ASK|what) [SIZE ]initial {q=QUANTITY}[ (?:of|in) {s}]": read.read_initial_value,
    "ASK {s} 's initial {q=QUANTITY}": read.read_initial_value,
    "what is shortest length of {s}": read.length_at("most compressed"),
    "what is longest length of {s}": read.length_at("most stretched"),
    "ASK [SIZE ]{s} force": subject_reader(*read.FORCES),
    "(?:with what force|how hard) ~(?:SURFACE|{t}) PRESSES on {s}": read.read_normal_force,
    "(?:with what force|how hard) ~{s} PRESSES (?:on|against|down on) (?:SURFACE|{t})": read.read_push_force,
    "(?:ASK|what) [SIZE ]force [that |with which ]~{s} PRESSES (?:on|against) (?:SURFACE|{t})": read.read_push_force,
    "(?:ASK|what) [SIZE ]force [that |with which ]~(?:SURFACE|{t}) PRESSES on {s}": read.read_normal_force,
    "(?:ASK|what) (?:force|pull) [that |with which ]~{s} (?:pull|pulls|pulling) on {t}": read.read_line_force,
    "(?:with what force|how hard) ~{s} (?:pull|pulls) on {t}": read.read_line_force,
    "(?:by )?how much [gravitational ]potential energy ~{s} (?P<verb>gain|gained|lose|lost)": read.potential,
    "by how much ~{s} 's [gravitational ]potential energy (?P<verb>increase|increased|rise|decrease|decreased|fall)": (
        read.potential
    ),
    "ASK (?P<verb>gain|increase|loss|decrease) (?:in|of) [gravitational ]potential energy[ of {s}]": read.potential,
    "how fast ~{s} ~(?:accelerate|accelerates|accelerating|speed up|speeding up)[ {way=WAY}| ALONG_IT]": (
        read.accelerates
    ),
    "(?:with|at) what acceleration ~{s} (?:accelerate|speed up)[ {way=WAY}| ALONG_IT]": read.accelerates,
    "what [SIZE ]acceleration ~{s} (?:undergo|experience|undergoes|experiences)": subject_reader("acceleration"),
    "ASK [final ]common (?:speed|velocity) of {s}": read.read_common_speed,
    "ASK common {q=QUANTITY} of {s}": read.quantity,
    "ASK equilibrium {q=QUANTITY} of {s}": read.read_equilibrium_value,
    "ASK angle (?:of|between|that) {s} (?:with|and|makes with) [downward ]vertical": subject_reader("deflection"),
    "what angle ~{s} ~(?:make|makes) with [downward ]vertical": subject_reader("deflection"),
    "what friction of ground on {s}": read.surface_force_reader("friction force"),
    "what normal force of ground on {s}": read.surface_force_reader("normal force"),
    "what is moment of inertia of {s} about axle": subject_reader("moment of inertia about the axle"),
    "how fast does {s} move[ {way=WAY}] relative to {t}": readers.relative_quantity_reader("speed"),
    "how far does {s} move relative to {t}": readers.far_on,
    "what angle {s} makes (?P<side>with|above|below) horizontal": read.read_velocity_angle,
    "what angle {s} is deflected through": subject_reader("angle of deflection"),
    "how much (?P<fuel>left|burnt) fuel[ {s}]": read.fuel,
    "(?:ASK|what) [SIZE ]friction[ force| force that] ~[acts |act |acting |exists ]between {s}[ and {t}]": (
        only_subject_reader("friction force")
    ),
    "(?:at |from |to )?what (?:height|altitude)[ above SURFACE][ ~[{s}]]": read.read_height,
    "how much (?:energy|elastic energy|elastic potential energy) ~{s} (?:store|contain|hold|have)": subject_reader(
        "spring energy"
    ),
    "how far does {s} move in one oscillation": subject_reader("distance travelled", needs=FREE),
    "where is {s} on its line": readers.on_line,
    "(?:through|by) what angle ~{s} ~MOTION": subject_reader("angle rolled", "angle turned"),
    "ASK angle through which {s} ~MOTION": subject_reader("angle rolled", "angle turned"),
    "(?:ASK|what) GREATEST distance [that ]~{s} ~{motion=MOTION}[ {way=WAY}| ALONG_IT]": read.read_displacement,
    "ASK distance [that ](?:covered|travelled|traveled|moved) by {s}[ {way=WAY}]": read.read_displacement,
    "ASK distance [that ]~{s} ~{motion=MOTION}[ {way=WAY}]": read.read_displacement,
    "(?:ASK|what) final {q=QUANTITY}[ of {s}]": read.read_final_value,
    "ASK {s} 's final {q=QUANTITY}": read.read_final_value,
    "how high[ above SURFACE] ~[{s}][ above SURFACE]": read.read_height,
    "ASK [SIZE ]height of {s}[ above SURFACE]": read.read_height,
    "how fast ~{s}[ ~{motion=MOTION}][ {way=WAY}| ALONG_IT]": read.read_speed,
    "how fast ~{s}[ and {t}] ~MOTION relative to each other": pair_reader("relative speed"),
    "how fast ~{s}[ and {t}] near or part": read.read_approach_speed,
    "how far ~{s}[ and {t}] apart": pair_reader("distance"),
    "how far apart ~(?:centres of )?{s}[ and {t}]": pair_reader("distance"),
    "how far ~{s} ~(?:{motion=MOTION}|get|gets|got)[ {way=WAY}| ALONG_IT]": read.read_displacement,
    "how far {s}": read.far_flown,
    "ASK stopping distance(?: of {s}|)": read.far_stopped,
    "ASK {s} 's stopping distance": read.far_stopped,
    "what {way=HORIZONTAL} distance ~{s} ~{motion=MOTION}": read.read_displacement,
    "ASK {way=HORIZONTAL} distance [that ]~{s} ~{motion=MOTION}": read.read_displacement,
    "ASK {way=HORIZONTAL} distance (?:covered|travelled|traveled|moved) by {s}": read.read_displacement,
    "how far (?:{way=WAY}|ALONG_IT) ~{s} ~{motion=MOTION}": read.read_displacement,
    "(?:what distance|how much distance) ~{s} ~{motion=MOTION}[ ALONG_IT]": read.read_displacement,
    "how far from origin ~{s}": subject_reader("distance from the origin"),
    "how far ~{s}[ away] from origin": subject_reader("distance from the origin"),
    "how far from HOME ~{s}": subject_reader("displacement"),
    "how far ~{s} from HOME": subject_reader("displacement"),
    "how far from {t} ~{s}": pair_reader("distance"),
    "how far ~{s}[ away] from {t}": pair_reader("distance"),
    "how long ~{s}": subject_reader("spring length"),
    "how (?:large|strong|big|great) ~[SIZE ]{q=QUANTITY}[ (?:of|in|on|for|acting on|exerted on) {s}]": read.quantity,
    "how much (?:energy ~stored|elastic energy ~stored|energy ~there) in {s}": changes.read_stored_energy,
    "how much kinetic energy ~{s}[ have| has]": subject_reader("kinetic energy"),
    "ASK energy stored in {s}": changes.read_stored_energy,
    "(?:by how much|how much|how far) ~{s} (?:stretched|extended|compressed)": subject_reader("extension"),
    "how much {q=QUANTITY} ~[{s} ](?P<verb>gain|lose|change)": changes.read_change,
    "how far (?P<side>up|down) is {s}": read.far_off,
    "what whole force of ground on {s}": read.surface_force_reader("normal force", SMOOTH),
    "what force acts on {s}": read.read_field_force,
    "how many times does {s} reverse": subject_reader("number of reversals", needs=CLAUSED),
    "how much mechanical energy ~(?:lost|lose)": changes.lost_in_impact,
    "what angle {s} hits at": subject_reader("angle with the horizontal", needs=LANDING),
    "ASK moment of inertia about [its ]axle": read.all_about_axle,
    "what is power of hand": only_subject_reader("power of a hand"),
    "how far altogether ~{s} move[ {way=WAY}]": read.far_in_all,
    "how far vertically (?P<side>below|above) its start is {s}": read.far_vertically,
    "what upward force of ground on {s}": read.surface_force_reader("normal force", LEVEL),
    "what is period of {s} about {t}": read.read_orbital_period,
    "how many turns does {s} make": subject_reader("revolutions made", needs=CLAUSED),
    "(?:ASK|what) {q=QUANTITY} (?:of|in) {s} ,? ?(?:taking|counting|reckoning|with|if) (?P<way>upwards?|right|to"
    " right) "
    "(?:direction )?~(?:counted |taken )?as positive": read.read_signed_component,
    "how much mechanical energy ~{s} lose": changes.lost_in_impact,
    "what force of guide on[ {s}]": subject_reader("force of the guide"),
    "what force of string on pulley {s} {t}": read.on_pulley,
    "what force of its string on pulley {s}": read.read_force_on_passed_pulley,
    "what force of the one string on pulley {s}": read.on_free_pulley,
    "what force bears axle[ {s}][ {t}]": read.on_axle,
    "what greatest force bears axle[ {s}]": subject_reader("greatest axle force", needs=STRETCH),
    "how near to far end does {s} get[ {t}]": readers.far_end("most compressed"),
    "how far from far end does {s} get[ {t}]": readers.far_end("most stretched"),
    "how far from far end is {s}[ {t}]": readers.far_end(),
    "what force on hook[ {s}]": read.on_hook,
    "how fast does mass centre move[ {s}]": readers.mass_center,
    "what is amplitude[ of {s}]": readers.amplitude,
    "what is inertia of {s} about its axis": readers.own_axis,
    "what is centre of mass offset of {s}": subject_reader("centre of mass offset"),
    "how far is {s} from axle": subject_reader("distance from the axle"),
    "how far is {s} from (?P<axis>x|y) axis": readers.from_axis,
    "how far (?P<most>at most )?(?P<side>above|below|left|right) of (?P<axis>x|y) axis is {s}": readers.beside_axis,
    "what is speed of {s} relative to {t}": readers.relative_quantity_reader("speed"),
    "what is acceleration of {s} relative to {t}": readers.acceleration_on,
    "how far does {s} move along {t}": readers.far_on,
    "how fast does {s} go down": readers.read_downward_velocity,
    "how much energy is lost to drag[ by {s}]": subject_reader("energy lost to drag", needs=STRETCH),
    "how much work does spring {s} do on {t}": readers.work_of_spring,
    "how long is {s} moving": readers.read_motion_time,
    "how far vertically is {s}": subject_reader(read.ABOVE, needs=STRETCH),
    "how much momentum does {s} exchange": changes.read_exchanged_momentum,
    "what is power of gravity on {s}": subject_reader("power of gravity"),
    "how fast does length of {s} change": subject_reader("rate of change of length"),
    "how much does length of {s} change": subject_reader("length", needs=CLAUSED),
    "what is stiffness of {s}": subject_reader("stiffness"),
    "TIME": read.read_duration,
}
"""By what a main clause is like: what reads it."""
