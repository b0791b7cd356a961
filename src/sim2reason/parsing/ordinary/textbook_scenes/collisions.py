"""Two carts, blocks or balls that collide on a straight line."""

from itertools import product

from sim2reason.parsing.ordinary.textbook_scenes import TEXTBOOK_SCENES, Facts, TextbookScene

NOUN = r"(?:cart|trolley|glider|puck|block|ball|sphere)"
NOUNS = frozenset({"cart", "block", "puck", "ball", "sphere"})  # which the library has for such bodies
HITS = r"(?:(?:and|then) )?(?:hits|strikes|collides with|collides head-on with|runs into|bumps into|elastically with)"
MOVING = (
    r"(?:(?:that|which) )?(?:is )?(?:initially )?(?:moving|moves|travelling|traveling|travels|rolling|sliding|slides)"
)
AT = r"at (?:a speed of )?"
STILL = r"(?:(?:that|which) )?(?:is )?(?:initially )?(?P<still>at rest|stationary)"
SECOND = r"(?:an?|another|a second)"
AGAINST = (
    r"(?:(?P<toward>towards? it|in the opposite direction|the other way)|(?P<ahead>in the same direction|ahead of it))"
)
TRACK = r"(?:track|air track|table|surface|floor|rail)"
BODIES = (rf"{NOUN} of (?:mass )?<m2:mass>", rf"<m2:mass> {NOUN}")
MOTIONS = (STILL, rf"{MOVING} {AT}<v2:speed> {AGAINST}", rf"{MOVING} {AGAINST} {AT}<v2:speed>")
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
    way = facts.one_of("how the second body moves", "still", "toward", "ahead")
    second = "at rest"
    if way in ("toward", "ahead"):
        second = f"moving with velocity {'−' if way == 'toward' else ''}{facts.number('v2', OTHER)}"
    if way == "ahead" and facts.value("v2", OTHER) >= facts.value("v1", ONE):
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
            rf"and {SECOND} <m2:mass> {NOUN} {MOVING} (?P<toward>(?:to the )?left) {AT}<v2:speed>",
            rf"<m1:mass> {NOUN} {MOVING} (?:(?:to the )?right )?{AT}<v1:speed>(?: to the right)?",
            rf"{NOUN} of (?:mass )?<m1:mass> {MOVING} (?:(?:to the )?right )?{AT}<v1:speed>(?: to the right)?",
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
