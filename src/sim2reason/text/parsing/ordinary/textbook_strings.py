"""Textbook sentences about pendulums and bodies on strings."""

from sim2reason.text.parsing.ordinary.textbook import TEXTBOOK_SCENES, Facts, TextbookScene, mass_of
from sim2reason.text.parsing.ordinary.textbook_slopes import FLOOR, SLOPE, friction, surface

BOB = r"bob|ball|sphere|mass|object|particle|body|weight|stone"


def _pendulum(facts: Facts) -> str:
    suspension = facts.one_of("what the bob hangs on, a string or a rod", "cord", "rod")
    length = facts.number("length", "the length of the pendulum")
    hanger = "light rigid rod" if suspension == "rod" else "light inextensible string"
    mass = facts.or_symbol("mass", "m")
    text = f"A small ball of mass {mass} hangs from a fixed point by a {hanger} of length {length}."
    start = facts.one_of("how the bob starts", "rest", "speed")
    low = facts.one_of("the angle to the vertical at the start", "angle", "low") == "low"
    at = "the ball hangs straight down"
    if not low:
        taut = "the rod makes" if suspension == "rod" else "the string is taut and makes"
        at = f"{taut} an angle of {facts.number('angle', '')} with the downward vertical"
    sent = "The motion starts from rest."
    if start == "speed":
        if not low:
            facts.missing.append("in which direction the bob is sent along its arc")
        sent = f"At t = 0 the ball is set moving horizontally at speed {facts.number('speed', '')}."
        if suspension == "cord":
            sent += " Whenever the string becomes taut again, the velocity along it is lost."
    elif low:
        facts.missing.append("an angle at which the pendulum is released")
    return f"{text} Initially {at}. {sent} {facts.gravity}"


TEXTBOOK_SCENES.add(
    "pendulum",
    TextbookScene(
        summary="A bob on a string or a rod swings.",
        opening=(r"string|cord|thread|rod|pendulum", rf"{BOB}|pendulum"),
        phrases=(
            *mass_of(BOB),
            r"(?P<keep>simple pendulum of length #length\d{1,3}#) and mass <mass:mass>",
            r"(?:length (?:of |is )?)?<length:length>(?: long)?",
            (
                r"(?:light|massless|inextensible|thin|ideal|weightless|rigid)(?= (?:and )?(?:\w{3,14} |\| ){0,2}"
                r"(?:string|cord|thread|rod))"
            ),
            r"(?P<cord>string|cord|thread) is (?:light|massless|inextensible)",
            r"(?P<rod>rod) is (?:light|massless|rigid)",
            r"(?P<cord>string|cord|thread|simple pendulum)",
            r"(?P<rod>rod)",
            (
                r"(?:makes |making |through |drawn aside |pulled aside |displaced )?(?:at |by |to )?"
                r"(?:an angle (?:of )?)?<angle:angle>(?: angle)?(?: (?:to|from|with) the (?:downward )?vertical)"
            ),
            r"(?:hangs|hanging) (?P<low>straight down|vertically|at rest)",
            r"(?P<low>at (?:its|the) lowest point)",
            r"(?:(?:held|pulled aside|drawn aside|pulled|drawn|starts|released|let go|swings) )?(?P<rest>from rest)",
            r"(?P<rest>(?:held )?at rest and (?:then )?(?:released|let go))",
            r"(?:given )?(?:an? )?(?:initial )?horizontal (?:speed|velocity) (?:of )?<speed:speed>",
            r"(?:suddenly )?(?:given|struck|set moving|launched) horizontally at <speed:speed>",
            r"hangs|hanging|suspended|attached|fixed point|ceiling|end|consists|held|tied|small|pendulum",
            r"(?:pulled|drawn) aside",
        ),
        bodies=BOB,
        write=_pendulum,
    ),
)


ONE = r"(?:block|mass|weight|body|object|load|box|bucket|crate)"
SEVERAL = r"(?:blocks|masses|weights|bodies|objects|loads)"
TOGETHER = r"everything|system|they|both|blocks|masses|bodies|weights|objects"
STRING = (
    r"(?:light|massless|inextensible|thin|ideal|weightless)(?= (?:and )?(?:\w{3,14} )?(?:string|rope|cord))",
    r"string|rope|cord",
    r"(?:(?:that|which) )?(?:passes|passing|hung|hangs|runs|running|slung|goes|going|draped|strung) over|over",
    (
        r"(?:light|massless|frictionless|smooth|fixed|ideal|small|weightless)"
        r"(?= (?:and )?(?:(?:light|massless|frictionless|smooth|fixed|ideal|small) )?pulley)"
    ),
    (
        r"(?:the )?pulley is (?:light|massless|frictionless|smooth|ideal)"
        r"(?: and (?:light|massless|frictionless|smooth))?"
    ),
    r"pulley",
    (
        rf"(?:(?:{TOGETHER}) )?(?:is |are )?(?:held )?(?:initially )?(?:at rest and )?(?:then )?"
        r"(?:released|let go|starts?|start moving|starts moving) (?P<rest>from rest)"
    ),
    rf"(?:(?:{TOGETHER}) )?(?:is |are )?(?:held |initially )?(?P<rest>at rest and (?:then )?(?:released|let go))",
)
TIED = r"(?:connected|attached|joined|tied|linked|fastened)"
HANGS = r"(?:hangs|hanging|hung|suspended)(?: freely| vertically)?(?: (?:over|off) the (?:edge|side))?"
HANGING = (
    rf"(?:freely |vertically )?hanging <b:mass> {ONE}",
    rf"(?:freely |vertically )?hanging {ONE} (?:of |with )?(?:a )?(?:mass )?(?:of )?<b:mass>",
    rf"<b:mass> (?:freely |vertically )?hanging {ONE}",
    rf"<b:mass> {ONE} (?:that |which )?(?:is )?{HANGS}",
    rf"{ONE} of (?:mass )?<b:mass> (?:that |which )?(?:is )?{HANGS}",
)
RELEASE_SENTENCE = (
    "Everything is released from rest with the string taut. There is no friction at the pulley, and every string is"
)
BODIES = (rf"an? <a:mass> {ONE}", rf"{ONE} of (?:mass )?<a:mass>", rf"{ONE} <a:mass>")
START = "how the blocks start"


def _atwood(facts: Facts) -> str:
    facts.one_of(START, "rest")
    one, other = facts.number("a", "the mass of one block"), facts.number("b", "the mass of the other block")
    return (
        f"A light string is tied to block A of mass {one}; it runs straight up, passes over a light fixed pulley and"
        f" runs straight down to block B of mass {other}. {RELEASE_SENTENCE} long enough. {facts.gravity}"
    )


TEXTBOOK_SCENES.add(
    "atwood machine",
    TextbookScene(
        summary="Two blocks hang on either side of a pulley.",
        opening=(
            r"pulley",
            r"over",
            rf"{SEVERAL}|{ONE}",
            r"hangs?|hung|suspended|hanging|connected|attached|joined|tied|ends",
        ),
        phrases=(
            rf"(?:two )?{SEVERAL} (?:of )?(?:mass(?:es)? )?(?:of )?<a:mass> and <b:mass>",
            rf"(?:two )?{SEVERAL} <a:mass> and <b:mass>",
            rf"<a:mass> {ONE} and (?:an? )?<b:mass> {ONE}",
            rf"{ONE} of (?:mass )?<a:mass> and (?:an? )?(?:{ONE} of (?:mass )?|another of (?:mass )?)<b:mass>",
            r"(?:from |to |at |by )?(?:the |its )?(?:two |opposite |both )?ends(?: of)?",
            *STRING,
            rf"{TIED}(?: together)?|hang|hung|hanging|suspended|vertically",
        ),
        write=_atwood,
    ),
)


def _table(facts: Facts) -> str:
    facts.one_of(START, "rest")
    rough, rubs = surface(facts, static_matters=True)
    one = facts.number("a", "the mass of the block on the table")
    other = facts.number("b", "the mass of the hanging block")
    return (
        f"Block A of mass {one} lies on a {rough}, fixed horizontal plane. {rubs}A light string tied to block A runs to"
        f" the right along the plane, passes over a light fixed pulley and runs straight down to block B ({other})."
        f" {RELEASE_SENTENCE} long enough. {facts.gravity}"
    )


def _incline(facts: Facts) -> str:
    facts.one_of(START, "rest")
    rough, rubs = surface(facts, static_matters=True)
    angle = facts.number("angle", "the angle of the slope")
    one = facts.number("a", "the mass of the block on the slope")
    other = facts.number("b", "the mass of the hanging block")
    return (
        f"Block A of mass {one} lies on a {rough}, fixed plane inclined at {angle} to the horizontal. {rubs}A light"
        " string tied to block A runs up the slope, passes over a light fixed pulley and runs straight down to block B"
        f" ({other}). {RELEASE_SENTENCE} long enough. {facts.gravity}"
    )


def _on(place: str, more: str) -> tuple[str, ...]:
    """Return the patterns for a block that lies on a surface named by the regular expression `place`."""
    between = rf" between (?:the |it )?(?:(?:block|mass|box|crate) )?and (?:the )?{place}"
    adjectives = r"(?: and)?(?: (?:horizontal|level|fixed|flat|#angle\d{1,3}#)){0,2}"
    return (
        *friction(between),
        rf"(?P<smooth>frictionless|smooth)(?={adjectives} {place})",
        rf"(?P<rough>rough)(?={adjectives} {place})",
        rf"(?:the )?{place} is (?:(?P<smooth>frictionless|smooth)|(?P<rough>rough))",
        *HANGING,
        *BODIES,
        *STRING,
        more,
        rf"{TIED}|runs from it|rests|lies|sits|placed|horizontal|level|pulled",
        rf"(?:at )?(?:the |its )?(?:edge|end|top) of (?:the )?{place}|at (?:the|its) (?:edge|top)",
        place,
        rf"(?:the )?{ONE}(?= \|| (?:is|rests|lies) )",
    )


TEXTBOOK_SCENES.add(
    "block on a table and hanging block",
    TextbookScene(
        summary="A hanging block pulls another along a table.",
        opening=(r"pulley", FLOOR, r"hang(?:s|ing)|hung|suspended"),
        phrases=_on(FLOOR, r"flat"),
        write=_table,
    ),
)
TEXTBOOK_SCENES.add(
    "block on a slope and hanging block",
    TextbookScene(
        summary="A block on a slope is joined to a hanging one.",
        opening=(r"pulley", SLOPE, r"hang(?:s|ing)|hung|suspended"),
        phrases=_on(
            SLOPE, r"(?:inclined )?(?:at )?(?:an angle (?:of )?)?<angle:angle>(?: (?:to|with) the horizontal)?"
        ),
        write=_incline,
    ),
)
