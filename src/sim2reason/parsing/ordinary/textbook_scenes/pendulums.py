"""A bob on a string or a rod."""

from sim2reason.parsing.ordinary.textbook_scenes import TEXTBOOK_SCENES, Facts, TextbookScene, mass_of

BOB = r"bob|ball|sphere|mass|object|particle|body|weight|stone"


def _pendulum(facts: Facts) -> str:
    held = facts.one_of("what the bob hangs on, a string or a rod", "cord", "rod")
    length = facts.number("length", "the length of the pendulum")
    hanger = "light rigid rod" if held == "rod" else "light inextensible string"
    mass = facts.or_symbol("mass", "m")
    text = f"A small ball of mass {mass} hangs from a fixed point by a {hanger} of length {length}."
    start = facts.one_of("how the bob starts", "rest", "speed")
    low = facts.one_of("the angle to the vertical at the start", "angle", "low") == "low"
    at = "the ball hangs straight down"
    if not low:
        taut = "the rod makes" if held == "rod" else "the string is taut and makes"
        at = f"{taut} an angle of {facts.number('angle', '')} with the downward vertical"
    sent = "The motion starts from rest."
    if start == "speed":
        if not low:
            facts.missing.append("in which direction the bob is sent along its arc")
        sent = f"At t = 0 the ball is set moving horizontally at speed {facts.number('speed', '')}."
        if held == "cord":
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
