"""Textbook sentences about blocks and round bodies on planes."""

from sim2reason.text.parsing.ordinary.textbook import TEXTBOOK_SCENES, Facts, TextbookScene, mass_of

BLOCK = r"block|box|crate|body|object|book|package|mass|particle|sled|skier|puck|brick|cube"
"""Nouns of the one body; a text that says *mass* or *body* besides means the same one."""
SLOPE = r"(?:inclined plane|plane(?= (?:(?:that|which) is )?inclined)|incline|ramp|slope|hill)"
FLOOR = r"(?:floor|table|tabletop|surface|plane|ground)"
STARTS = r"(?:(?:is|are) )?(?:released|let go|starts|starting|slides|sliding|slips|starts moving)"
SPEED = r"(?:an? |the )?(?:initial )?(?:speed|velocity) (?:of |is )?(?:v = )?<speed:speed>"
FRICTION = (
    (
        r"(?:the )?coefficients? of static and kinetic friction@ (?:are |of |= )?<static:plain> and <kinetic:plain>"
        r"(?: respectively)?"
    ),
    r"(?:the )?coefficient of static friction@ (?:is |of |= )?<static:plain>",
    r"(?:the )?coefficient of (?:kinetic|sliding|dynamic) friction@ (?:is |of |= )?<kinetic:plain>",
    r"(?:the )?(?:coefficient of friction|friction coefficient)@ (?:static and kinetic )?(?:is |of |= )?<mu:plain>",
    r"(?:and )?that of kinetic friction (?:is )?<kinetic:plain>",
)
MOVES = r"(?:moves|moving|slides|sliding|launched|sent|pushed|accelerat\w{1,5}|rises|released)"
CARRIED = rf"(?:{SLOPE}|{FLOOR})(?: (?:that|which|itself))?(?: is)? {MOVES}|{MOVES} (?:{SLOPE}|{FLOOR})"
BETWEEN = rf" between (?:the |it )?(?:(?:{BLOCK}) )?and (?:the )?(?:{SLOPE}|{FLOOR})"


def friction(where: str) -> tuple[str, ...]:
    """Return the patterns for coefficients of friction, with and without the names of the two bodies."""
    return tuple(each.replace("@", f"(?:{where})?") for each in FRICTION)


def surface(facts: Facts, *, static_matters: bool) -> tuple[str, str]:
    """Return the adjective of a surface (*smooth* or *rough*), and the sentence that states its friction."""
    if facts.has("smooth"):
        facts.one_of("the friction", "smooth", "mu", "kinetic", "static", "rough")
        return "smooth", ""
    facts.has("rough")
    if facts.has("mu"):
        facts.one_of("the coefficient of friction", "mu", "kinetic", "static")
        mu = facts.number("mu", "")
    elif facts.has("static") or static_matters:
        kinetic = facts.number("kinetic", "the coefficient of kinetic friction, or that the surface is frictionless")
        static = facts.number("static", "the coefficient of static friction, or that the surface is frictionless")
        return "rough", (
            f"The coefficient of static friction on this plane is {static}, that of kinetic friction {kinetic}. "
        )
    else:
        mu = facts.number("kinetic", "the coefficient of friction, or that the surface is frictionless")
    return "rough", f"The coefficient of friction (static and kinetic) on this plane is {mu}. "


def _slope(facts: Facts) -> str:
    rough, rubs = surface(facts, static_matters=True)
    angle = facts.number("angle", "the angle of the slope")
    start = facts.one_of("how the block starts, from rest or up the slope", "rest", "up")
    sent = "The motion starts from rest."
    if start == "up":
        sent = f"At t = 0 the block moves up the slope at speed {facts.number('speed', 'the speed of the block')}."
    return (
        f"A block of mass {facts.or_symbol('mass', 'm')} lies on a {rough}, fixed plane inclined at {angle} to the"
        f" horizontal. {rubs}{sent} {facts.gravity}"
    )


TEXTBOOK_SCENES.add(
    "block on a slope",
    TextbookScene(
        summary="A block slides on a fixed slope, released or sent up it.",
        opening=(SLOPE, BLOCK),
        phrases=(
            *friction(BETWEEN),
            rf"(?P<smooth>frictionless|smooth)(?=(?: and)?(?: (?:fixed|#angle\d{{1,3}}#)){{0,2}} {SLOPE})",
            rf"(?:(?:the |its )?(?:{SLOPE}|surface) )?(?:is |has )(?P<smooth>frictionless|smooth|no friction)",
            r"(?P<smooth>without (?:any )?friction|there is no friction|no friction acts|friction is negligible)",
            rf"(?P<rough>rough)(?=(?: (?:fixed|#angle\d{{1,3}}#)){{0,2}} {SLOPE})",
            r"plane(?= (?:(?:that|which) is )?inclined)",
            *mass_of(BLOCK),
            r"(?:held )?(?P<rest>at rest and (?:is )?(?:then )?(?:released|let go))",
            rf"(?:{STARTS} )?(?P<rest>from rest)",
            r"(?:starts|begins) (?P<rest>at rest)",
            r"(?:at|from|near) the (?:top|bottom|foot|base)(?: of)?",
            SPEED,
            r"<speed:speed>",
            (
                r"(?:(?:inclined|tilted|sloping|rising|makes|making) )?(?:at )?"
                r"(?:(?:an |of )?(?:angle|inclination) (?:of )?)?<angle:angle>"
                rf"(?: angle)?(?: (?:to|with|from|above) the horizontal)?(?! (?:to|with|from) the {SLOPE})"
            ),
            r"(?:launched|sent|projected|pushed|shot|kicked|slides|sliding|slips|moves|given a push)",
            r"(?P<up>up)(?: along)?",
            r"down|rests|lies|sits|placed|stationary|fixed|initial|given",
            SLOPE,
        ),
        bodies=BLOCK,
        never=CARRIED,
        place=SLOPE,
        write=_slope,
    ),
)


def _floor(facts: Facts) -> str:
    rough, rubs = surface(facts, static_matters=False)
    if facts.has("stops") and rough == "smooth":
        facts.missing.append("what stops the block on a smooth surface")
    speed = facts.number("speed", "the initial speed of the block")
    return (
        f"A block of mass {facts.or_symbol('mass', 'm')} lies on a {rough}, fixed horizontal plane. {rubs}"
        f"At t = 0 the block moves to the right along the plane at speed {speed}. {facts.gravity}"
    )


TEXTBOOK_SCENES.add(
    "block on a floor",
    TextbookScene(
        summary="A block slides on a level floor, until friction stops it if there is any.",
        opening=(FLOOR, BLOCK),
        phrases=(
            *friction(BETWEEN),
            rf"(?P<smooth>frictionless|smooth)(?=(?: and)?(?: (?:horizontal|level|flat))? {FLOOR})",
            rf"(?P<rough>rough)(?=(?: and)?(?: (?:horizontal|level|flat))? {FLOOR})",
            *mass_of(BLOCK),
            SPEED,
            r"(?:until it )?(?:finally |eventually )?(?P<stops>stops|comes to rest|slides to rest)",
            r"<speed:speed>",
            rf"(?:horizontal|level|flat)(?: and (?:rough|smooth))?(?= {FLOOR})",
            r"(?:launched|sent|projected|pushed|shot|kicked|slides|sliding|moves|starts)",
            rf"(?:{BLOCK}|it)(?: is)?(?: initially)? moving",
            r"to the right|along|across|over|rests|lies|sits|placed|initially|given",
            FLOOR,
        ),
        bodies=BLOCK,
        never=CARRIED,
        place=FLOOR,
        write=_floor,
    ),
)


SHAPES = r"sphere|ball|cylinder|disc|disk|hoop|ring|shell|tube|pipe"
ROUND = {
    "ball": "A uniform solid sphere",
    "cylinder": "A uniform solid cylinder",
    "hoop": "A thin hoop",
    "shell": "A thin spherical shell",
    "pipe": "A thin-walled tube",
}


def _rolls(facts: Facts) -> str:
    shape = facts.one_of("the shape of the body", *ROUND)
    facts.one_of("that it rolls without slipping", "grips")
    facts.one_of("how it starts, from rest", "rest")
    angle = facts.number("angle", "the angle of the slope")
    return (
        f"{ROUND.get(shape, '')} of radius {facts.or_symbol('radius', 'R')} and mass {facts.or_symbol('mass', 'm')} is"
        f" placed on a stationary plane inclined at {angle} to the horizontal and can roll straight up or down the"
        f" slope. It rolls without slipping. The motion starts from rest. {facts.gravity}"
    )


TEXTBOOK_SCENES.add(
    "rolling body",
    TextbookScene(
        summary="A sphere, cylinder, hoop or shell rolls down a slope.",
        opening=(r"rolls?|rolling", SLOPE),
        phrases=(
            r"plane(?= (?:(?:that|which) is )?inclined)",
            *mass_of(SHAPES),
            rf"(?P<keep>(?:{SHAPES}) of radius #length\d{{1,3}}#) and mass <mass:mass>",
            r"(?:radius (?:of |is )?)?<radius:length>(?: radius| in radius)?",
            r"(?:uniform )?solid (?:uniform )?(?P<keep_ball>sphere|ball)",
            r"(?:uniform )?solid (?:uniform )?(?P<keep_cylinder>cylinder|disc|disk)",
            r"(?:thin )?(?P<keep_hoop>hoop|ring)",
            r"(?:thin |hollow )?spherical (?P<keep_shell>shell)",
            r"(?:thin-walled|thin) (?:hollow )?(?P<keep_pipe>tube|pipe|cylinder)",
            r"(?:(?:rolls|roll|rolling) )?(?P<grips>without (?:slipping|sliding))",
            r"(?:(?:released|starts|starting|rolls|let go) )?(?P<rest>from rest)",
            (
                r"(?:inclined |making )?(?:at )?(?:an angle (?:of )?)?<angle:angle>(?: angle)?"
                r"(?: (?:to|with|above) the horizontal)?"
            ),
            r"(?:and )?(?:rolls|rolling|roll)(?: straight)?(?: down)?",
            r"down|at the top of|from the top of|placed|fixed|rough",
            SLOPE,
        ),
        bodies=SHAPES,
        place=SLOPE,
        write=_rolls,
    ),
)
