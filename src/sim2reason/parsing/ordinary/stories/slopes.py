"""A block alone on a fixed plane: a slope or a level floor."""

from sim2reason.parsing.ordinary.stories import STORIES, Story, Told

BLOCK = r"block|box|crate|body|object|book|package|mass|particle"
SLOPE = r"(?:inclined plane|incline|ramp|slope|hill)"
FLOOR = r"(?:floor|table|tabletop|surface|plane|ground)"
MASS = r"(?:mass )?(?:of |is )?(?:m = )?<mass:mass>"
STARTS = r"(?:(?:is|are) )?(?:released|let go|starts|slides|slips|starts moving|held and released|placed and released)"
SPEED = r"(?:an? |the )?(?:initial )?(?:speed|velocity) (?:of |is )?(?:v = )?<speed:speed>"
FRICTION = (
    r"(?:the )?coefficients? of static and kinetic friction (?:are |of |= )?<static:plain> and <kinetic:plain>"
    r"(?: respectively)?",
    r"(?:the )?coefficient of static friction (?:is |of |= )?<static:plain>",
    r"(?:the )?coefficient of (?:kinetic|sliding|dynamic) friction (?:is |of |= )?<kinetic:plain>",
    r"(?:the )?(?:coefficient of friction|friction coefficient) (?:static and kinetic )?(?:is |of |= )?<mu:plain>",
    r"(?:and )?that of kinetic friction (?:is )?<kinetic:plain>",
)
BETWEEN = rf" between (?:the |it )?(?:(?:{BLOCK}) )?and (?:the )?(?:{SLOPE}|{FLOOR})"


def friction(where: str) -> tuple[str, ...]:
    """Return the patterns of coefficients of friction, with and without the two bodies between which it acts."""
    return (*(each.replace(" friction ", f" friction(?:{where})? ", 1) for each in FRICTION),)


def surface(told: Told, *, static_matters: bool) -> tuple[str, str]:
    """Return the library's word for a surface, and the sentence on its friction."""
    if told.has("smooth"):
        told.one_of("the friction", "smooth", "mu", "kinetic", "static", "rough")
        return "smooth", ""
    told.has("rough")
    if told.has("mu"):
        told.one_of("the coefficient of friction", "mu", "kinetic", "static")
        mu = told.number("mu", "")
    elif told.has("static") or static_matters:
        kinetic = told.number("kinetic", "the coefficient of kinetic friction, or that the surface is frictionless")
        static = told.number("static", "the coefficient of static friction, or that the surface is frictionless")
        return "rough", (
            f"The coefficient of static friction on this plane is {static}, that of kinetic friction {kinetic}. "
        )
    else:
        mu = told.number("kinetic", "the coefficient of friction, or that the surface is frictionless")
    return "rough", f"The coefficient of friction (static and kinetic) on this plane is {mu}. "


def _slope(told: Told) -> str:
    rough, rubs = surface(told, static_matters=True)
    angle = told.number("angle", "the angle of the slope")
    start = told.one_of("how the block starts, from rest or with what speed", "rest", "up")
    sent = "The motion starts from rest."
    if start == "up":
        sent = f"At t = 0 the block moves up the slope at speed {told.number('speed', 'the speed of the block')}."
    return (
        f"A block of mass {told.or_symbol('mass', 'm')} lies on a {rough}, fixed plane inclined at {angle} to the"
        f" horizontal. {rubs}{sent} {told.gravity}"
    )


STORIES.add(
    "block on a slope",
    Story(
        summary="A block slides on a fixed slope, released or sent up it.",
        opening=(SLOPE, BLOCK),
        phrases=(
            *friction(BETWEEN),
            rf"(?P<smooth>(?:frictionless|smooth))(?: and)?(?: fixed)?(?= (?:<angle:angle> )?{SLOPE})",
            rf"(?P<smooth>frictionless|smooth|without friction)(?= (?:and )?fixed {SLOPE})",
            rf"(?:the )?(?:{SLOPE}|{FLOOR}) (?:is|has) (?P<smooth>frictionless|smooth|no friction)",
            r"(?P<smooth>without (?:any )?friction|there is no friction|no friction acts|friction is negligible)",
            rf"(?P<rough>rough)(?= (?:fixed )?(?:<angle:angle> )?{SLOPE})",
            MASS,
            r"(?:at rest )?(?:and )?(?:then )?(?:(?:is )?(?:released|let go)) (?P<rest>from rest)",
            rf"(?:{STARTS} )?(?P<rest>from rest)",
            r"(?:held )?(?P<rest>at rest and (?:then )?(?:released|let go))",
            rf"(?:and )?(?:slides|slips|moves) (?:down|downwards)(?: the)?(?: {SLOPE})?",
            rf"(?:at|from|near) the top(?: of)?",
            rf"(?:is )?(?:launched|sent|projected|pushed|shot|kicked|given a push|slides|moves|thrown) (?P<up>up)"
            rf"(?: along)?(?= (?:the |an? )?)",
            rf"(?:is )?(?:launched|projected) (?:from|at) (?:the )?(?:bottom|foot|base)(?: of)?",
            rf"(?:from|at) the (?:bottom|foot|base)(?: of)?",
            rf"(?P<up>up) (?=(?:the|an?) )",
            SPEED,
            r"<speed:speed>",
            rf"(?:inclined |tilted |sloping |rising |makes |making )?(?:at )?(?:an angle (?:of )?)?<angle:angle>"
            rf"(?: angle)?(?: (?:to|with|from|above) the horizontal)?",
            r"(?:rests|lies|sits|is placed|placed|stationary|fixed|slides|initial(?:ly)?|moving)",
            SLOPE,
        ),
        bodies=BLOCK,
        tell=_slope,
    ),
)


def _floor(told: Told) -> str:
    rough, rubs = surface(told, static_matters=False)
    told.has("stops")
    speed = told.number("speed", "the initial speed of the block")
    return (
        f"A block of mass {told.or_symbol('mass', 'm')} lies on a {rough}, fixed horizontal plane. {rubs}"
        f"At t = 0 the block moves to the right along the plane at speed {speed}. {told.gravity}"
    )


STORIES.add(
    "block on a floor",
    Story(
        summary="A block slides on a level floor, until friction stops it if there is any.",
        opening=(FLOOR, BLOCK),
        phrases=(
            *friction(BETWEEN),
            rf"(?P<smooth>frictionless|smooth)(?= (?:and )?(?:(?:horizontal|level|flat) )?{FLOOR})",
            rf"(?P<rough>rough)(?= (?:and )?(?:(?:horizontal|level|flat) )?{FLOOR})",
            MASS,
            SPEED,
            r"(?P<stops>until it (?:stops|comes to rest))",
            r"(?:and )?(?:finally |eventually )?(?P<stops>(?:stops|comes to rest))",
            r"(?:is )?(?:launched|sent|projected|pushed|shot|given|slides|sliding|moves|moving|starts|starts moving)"
            r"(?: to the right)?(?: along| across| over| on)?",
            r"<speed:speed>(?: to the right)?",
            rf"(?:horizontal |level |flat )(?={FLOOR})",
            rf"(?:rests|lies|sits|is placed|fixed|across|along)",
            FLOOR,
        ),
        bodies=BLOCK,
        tell=_floor,
    ),
)
