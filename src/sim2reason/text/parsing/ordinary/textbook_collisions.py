"""Textbook sentences about collisions, springs and charges."""

from dataclasses import replace
from itertools import product

from sim2reason.text.parsing.ordinary.lexicon import MINUS, format_amount
from sim2reason.text.parsing.ordinary.textbook import TEXTBOOK_SCENES, Facts, TextbookScene, mass_of

MIN_FORCE_RATIO = 1e4  # ratio of magnetic force to weight above which a text need not mention gravity


def _charge(facts: Facts) -> str:
    charge = facts.amount("charge", "the charge of the particle")
    negative = charge is not None and charge.digits.startswith(MINUS)
    amount = replace(charge, digits=charge.digits.lstrip(MINUS)).text if charge is not None else "?"
    mass, field = facts.value("mass", "the mass of the particle"), facts.value("field", "the strength of the field")
    speed = facts.value("speed", "the speed of the particle")
    facts.one_of("that the velocity is perpendicular to the field", "across")
    turned = facts.has("out") or facts.has("into")
    field_direction = (
        "negative" if turned and facts.one_of("the direction of the field", "out", "into") == "into" else "positive"
    )
    if facts.has("enters"):
        facts.missing.append("how far the field extends that it enters")
    force = abs(charge.value) * speed * field if charge is not None else 0.0
    if not facts.has("weightless") and charge is not None and force < MIN_FORCE_RATIO * mass * facts.g:
        facts.missing.append("that there is no gravity")
    of = "a negative charge of magnitude" if negative else "a positive charge of"
    return (
        f"A uniform magnetic field of strength {facts.number('field', '')} points in the {field_direction} z direction."
        f" At t = 0 a small bead of mass {facts.number('mass', '')} with {of} {amount} leaves the origin of the x-y"
        f" plane at speed {facts.number('speed', '')} in the positive x direction. There is no gravity."
    )


TEXTBOOK_SCENES.add(
    "charge in a magnetic field",
    TextbookScene(
        summary="A charged particle moves across a uniform magnetic field.",
        opening=(r"uniform magnetic field", r"particle|bead|ion|ball"),
        phrases=(
            r"(?:mass (?:of |is )?)?(?:m = )?<mass:mass>",
            r"(?:positive )?(?:charge (?:of |is )?)?(?:q = )?<charge:charge>(?: charge)?",
            r"(?:magnetic )?(?:field )?(?:of )?(?:strength |magnitude )?(?:of )?(?:b = )?<field:field>",
            r"(?:with )?(?:a )?(?:(?:speed|velocity) (?:of )?)?(?:v = )?<speed:speed>",
            r"(?P<across>(?:perpendicular|at right angles|normal)(?:ly)? to (?:the|a|its)(?: field| velocity)?)",
            r"(?P<across>perpendicularly)",
            r"(?:points |directed |pointing )?(?P<out>out of the (?:page|paper|plane))",
            r"(?:points |directed |pointing )?(?P<into>into the (?:page|paper|plane))",
            r"(?P<weightless>there is no gravity|(?:gravity|its weight) is negligible|(?:neglect|ignore) gravity)",
            r"(?P<enters>enters|shot into|into)",
            r"uniform|magnetic|field|moves|moving|travels|charged|small|points|directed",
        ),
        bodies=r"particle|bead|ion|ball",
        write=_charge,
    ),
)


NOUN = r"(?:cart|trolley|glider|puck|block|ball|sphere)"
NOUNS = frozenset({"cart", "block", "puck", "ball", "sphere"})  # nouns of the library for such bodies
HITS = r"(?:(?:and|then) )?(?:hits|strikes|collides with|collides head-on with|runs into|bumps into|elastically with)"
MOVING = (
    r"(?:(?:that|which) )?(?:is )?(?:initially )?(?:moving|moves|travelling|traveling|travels|rolling|sliding|slides)"
)
SPEED_PREFIX = r"at (?:a speed of )?"
AT_REST_PATTERN = r"(?:(?:that|which) )?(?:is )?(?:initially )?(?P<still>at rest|stationary)"
SECOND = r"(?:an?|another|a second)"
AGAINST = (
    r"(?:(?P<toward>towards? it|in the opposite direction|the other way)|(?P<ahead>in the same direction|ahead of it))"
)
TRACK = r"(?:track|air track|table|surface|floor|rail)"
BODIES = (rf"{NOUN} of (?:mass )?<m2:mass>", rf"<m2:mass> {NOUN}")
MOTIONS = (
    AT_REST_PATTERN,
    rf"{MOVING} {SPEED_PREFIX}<v2:speed> {AGAINST}",
    rf"{MOVING} {AGAINST} {SPEED_PREFIX}<v2:speed>",
)
STATIONARY = (
    rf"(?P<still>stationary) <m2:mass> {NOUN}",
    rf"<m2:mass> (?P<still>stationary) {NOUN}",
    rf"(?P<still>stationary) {NOUN} of (?:mass )?<m2:mass>",
)
ONE, OTHER = "the speed of the first body", "the speed of the second body"


def _collision(facts: Facts) -> str:
    nouns = facts.nouns(NOUN)
    noun = nouns[0] if nouns[0] in NOUNS else "cart"
    if len(nouns) > 1:
        facts.missing.append("bodies of one kind")
    if noun == "block":
        facts.one_of("that the surface is frictionless", "smooth")
    facts.has("smooth")
    motion = facts.one_of("how the second body moves", "still", "toward", "ahead")
    second = "at rest"
    if motion in ("toward", "ahead"):
        second = f"moving with velocity {'−' if motion == 'toward' else ''}{facts.number('v2', OTHER)}"
    if motion == "ahead" and facts.value("v2", OTHER) >= facts.value("v1", ONE):
        facts.missing.append("a first body that is faster than the second")
    result = facts.one_of("what the collision is like, elastic or not", "stick", "elastic", "e")
    ends = {"stick": "All collisions are perfectly inelastic.", "elastic": "Every collision is elastic."}
    end = ends.get(result) or f"The coefficient of restitution of every collision is {facts.number('e', '')}."
    first = facts.number("m1", "the mass of the first body"), facts.number("v1", ONE)
    return (
        f"Two small {noun}s, named in order of increasing x, move along a straight smooth horizontal track; x is"
        f" measured along it, to the right. At t = 0 {noun} A of mass {first[0]} is moving with velocity {first[1]} at"
        f" x = 0 m. At t = 0 {noun} B of mass {facts.number('m2', 'the mass of the second body')} is {second} at x ="
        f" {facts.number('gap', 'how far apart the bodies are at first')}. {end}"
    )


TEXTBOOK_SCENES.add(
    "collision on a line",
    TextbookScene(
        summary="Two bodies collide on a straight level track.",
        opening=(rf"{HITS}|collide|approach", NOUN),
        phrases=(
            r"collides (?P<keep_elastic>elastically)(?= with)",
            rf"two (?:{NOUN})s|approach(?:ing)? each other|move towards? each other",
            *(rf"{HITS} {SECOND} {body} {motion}" for body, motion in product(BODIES, MOTIONS)),
            *(rf"{HITS} {SECOND} {body}" for body in STATIONARY),
            rf"and {SECOND} <m2:mass> {NOUN} {MOVING} (?P<toward>(?:to the )?left) {SPEED_PREFIX}<v2:speed>",
            rf"<m1:mass> {NOUN} {MOVING} (?:(?:to the )?right )?{SPEED_PREFIX}<v1:speed>(?: to the right)?",
            (
                rf"{NOUN} of (?:mass )?<m1:mass> {MOVING} (?:(?:to the )?right )?{SPEED_PREFIX}<v1:speed>"
                r"(?: to the right)?"
            ),
            (
                rf"(?:(?:{NOUN}s|they|bodies) )?(?:are )?(?:initially |at first )?<gap:length>"
                r" (?:apart|away|ahead|in front of it)"
                r"(?: initially| at first)?"
            ),
            r"(?:they |and )?(?P<stick>stick together|couple together|sticks? to it|couple)(?: after the collision)?",
            r"(?:(?:the )?collision is )?(?P<stick>perfectly inelastic(?:ally)?|completely inelastic(?:ally)?)",
            r"(?:(?:the )?collision is )?(?:perfectly )?(?P<elastic>elastic(?:ally)?)(?: collision)?",
            r"(?:the )?coefficient of restitution (?:is |of )?<e:plain>",
            rf"(?P<smooth>frictionless|smooth)(?=(?: (?:horizontal|level|straight|straight horizontal))? {TRACK})",
            rf"(?:horizontal|level|straight)|along|{TRACK}|they|collide|same straight line|head-on",
        ),
        write=_collision,
    ),
)


BLOCK = r"block|mass|box|body|object|cart|glider|weight|ball"
FLOOR = r"(?:floor|table|tabletop|surface|track|air track)"
STIFF = (
    r"(?:(?:a )?(?:spring )?(?:stiffness|spring constant|force constant|constant) (?:of |is )?)?(?:k = )?<k:stiffness>",
)
REST = (
    r"(?:and )?(?:then )?(?:held )?(?P<rest>at rest and (?:then )?(?:released|let go))",
    r"(?:(?:released|let go|starts) )?(?P<rest>from rest)",
    r"(?:and )?(?:then )?(?P<rest>released|let go)",
)
EQUILIBRIUM = r"(?:its |the )?(?:equilibrium|relaxed|rest|natural)(?: position| length)?"


def _level(facts: Facts) -> str:
    facts.one_of("that the surface is frictionless", "smooth")
    facts.one_of("how the block starts", "rest")
    sense = facts.one_of("whether the spring is stretched or compressed", "out", "inwards")
    strain = "compressed" if sense == "inwards" else "stretched"
    return (
        f"A block of mass {facts.number('mass', 'the mass of the block')} stands on a straight smooth horizontal track."
        f" A light spring of stiffness {facts.number('k', 'the stiffness of the spring')} runs from a fixed wall on the"
        f" left to the block. At the start the spring is {strain} by {facts.number('by', 'by how much')}."
        " The motion starts from rest."
    )


TEXTBOOK_SCENES.add(
    "block on a level spring",
    TextbookScene(
        summary="A block on a smooth table swings on a spring.",
        opening=(r"spring", r"attached|connected|joined|tied|fixed", FLOOR),
        phrases=(
            *STIFF,
            *mass_of(BLOCK),
            rf"(?P<smooth>frictionless|smooth)(?=(?: and)?(?: (?:horizontal|level|fixed))? {FLOOR})",
            (
                rf"(?P<out>pulled|stretched|pulled aside|drawn) (?:out |away )?(?:by )?<by:length>"
                rf"(?: (?:from|past|beyond)"
                rf" {EQUILIBRIUM}| away| out)?(?! from)"
            ),
            rf"(?P<inwards>compressed|pushed|pushed in) (?:by )?<by:length>(?: (?:from) {EQUILIBRIUM})?(?! from)",
            *REST,
            r"(?:light|massless|ideal)(?= spring)",
            r"horizontal|level|attached|connected|joined|fixed|tied|rests|lies|sits|wall|(?:(?:one|other|free) )?end",
            rf"spring|{FLOOR}",
        ),
        bodies=BLOCK,
        write=_level,
    ),
)


def _hanging(facts: Facts) -> str:
    facts.one_of("how the block starts", "rest")
    mass, stiffness = facts.value("mass", "the mass of the block"), facts.value("k", "the stiffness of the spring")
    length = facts.value("natural", "the natural length of the spring")
    start = facts.one_of("how long the spring is at the start", "long", "below", "unstretched", "out")
    at = length
    if start == "long":
        at = facts.value("long", "")
    elif start == "out":
        at = length + facts.value("out", "")
    elif start == "below":
        at = length + mass * facts.g / stiffness + facts.value("below", "")
    numbers = facts.number("mass", ""), facts.number("k", ""), facts.number("natural", "")
    return (
        f"A block of mass {numbers[0]} hangs from the ceiling by a light spring of stiffness {numbers[1]} and natural"
        f" length {numbers[2]}. Initially the spring has a length of {format_amount(at)} m. "
        f"The motion starts from rest. {facts.gravity}"
    )


HANGS = r"(?:hangs|hanging|hung|suspended)"
TEXTBOOK_SCENES.add(
    "block on a hanging spring",
    TextbookScene(
        summary="A block hangs on a spring and swings up and down.",
        opening=(r"spring", rf"{HANGS}|vertical"),
        phrases=(
            *STIFF,
            *mass_of(BLOCK),
            r"(?:natural|unstretched|relaxed) length (?:of |is )?<natural:length>",
            (
                r"(?:pulled|drawn|displaced) (?:down|downwards?) (?:by )?<below:length>"
                r"(?: (?:from|below) (?:its |the )?equilibrium(?: position)?)"
            ),
            r"<below:length> below (?:its |the )?equilibrium(?: position)?",
            r"(?:spring )?stretched by <out:length>",
            r"(?:spring )?(?:has |with )?(?:an? )?(?:initial )?length (?:of )?<long:length>",
            r"(?:spring )?(?:is )?(?P<unstretched>unstretched|relaxed|at its natural length)",
            *REST,
            r"(?:light|massless|ideal|vertical|vertical light)(?= spring)",
            rf"{HANGS}|attached|ceiling|vertically|end|lower|held|fixed",
            r"spring",
        ),
        bodies=BLOCK,
        write=_hanging,
    ),
)
