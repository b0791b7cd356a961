"""Textbook sentences about throws, rockets and orbits."""

from math import pi, sqrt

from sim2reason.text.parsing.ordinary.lexicon import format_amount
from sim2reason.text.parsing.ordinary.textbook import TEXTBOOK_SCENES, Facts, TextbookScene, mass_of


def _orbit(facts: Facts) -> str:
    star = facts.value("mass", "the mass of the star", "Msun")
    away = facts.value("away", "how far the planet is from the star", "au")
    kind = facts.one_of("how the planet moves, on a circle or with what velocity", "circle", "across")
    speed = 2.0 * pi * sqrt(star / away)
    if kind == "across":
        speed = facts.value("speed", "the speed of the planet", "au/yr")
    return (
        f"A star of mass {format_amount(star)} Msun is fixed at the origin of the x-y plane; "
        "the units are the astronomical"
        " unit (au), the year (yr) and the solar mass (Msun), in which G = 4π² au³/(Msun yr²). At t = 0 a planet is at"
        f" the point ({format_amount(away)} au, 0 au) and has the velocity (0 au/yr, {format_amount(speed)} au/yr). "
        "The planet is"
        " attracted by the star alone."
    )


TEXTBOOK_SCENES.add(
    "planet round a star",
    TextbookScene(
        summary="A planet moves round a star, on a circle or from where it moves across the line to the star.",
        opening=(r"star|sun", r"planet|comet"),
        phrases=(
            r"(?:fixed )?(?:star|sun) (?:of |with )?(?:a )?(?:mass (?:of )?)?<mass:mass>",
            r"<mass:mass> (?:star|sun)",
            r"(?P<circle>circular orbit|circle) (?:of |with )?(?:a )?(?:radius (?:of )?)?<away:length>",
            r"(?P<circle>circular orbit|circle)",
            r"(?:radius (?:of )?|distance (?:of )?)?<away:length>(?: away)?(?: from (?:the|its) (?:star|sun)| away)?",
            (
                r"(?:speed (?:of )?)?<speed:speed> (?P<across>(?:perpendicular|at right angles) to the line"
                r"(?: (?:to|joining it to|from it to) the (?:star|sun))?)"
            ),
            r"moves|moving|orbits|goes|round|around|orbit|planet|comet|star|sun",
        ),
        never=r"(?:star|sun) (?:(?:that|which) )?(?:moves|moving|orbits|goes)",
        write=_orbit,
    ),
)


FUEL = r"(?:fuel|propellant)"
GAS = r"(?:exhaust )?(?:gas|gases|exhaust|fuel|it|them)"


def _rocket(facts: Facts) -> str:
    mass = facts.value("mass", "the mass of the rocket with its fuel")
    if facts.one_of("how much of the mass is fuel", "fuel", "dry") == "fuel":
        dry = f"{format_amount(mass - facts.value('fuel', ''))} kg"
    else:
        dry = facts.number("dry", "") if facts.has("dry") else "?"
    setting = facts.one_of("where the rocket is, in deep space or on level ground", "space", "ground")
    stands = "is at rest in deep space, far from all other bodies"
    if setting == "ground":
        stands = "stands upright on level ground in a uniform gravitational field, without air"
    facts.has("rest")
    rate = facts.number("rate", "the rate at which it burns fuel")
    exhaust = facts.number("exhaust", "the speed of the exhaust")
    return (
        f"A rocket of mass {facts.number('mass', '')} ({dry} without its fuel) {stands}. At t = 0 the engine starts: it"
        f" burns fuel at a rate of {rate} and ejects the gas backwards at speed {exhaust} relative to the rocket until"
        f" no fuel is left.{f' {facts.gravity}' if setting == 'ground' else ''}"
    )


TEXTBOOK_SCENES.add(
    "rocket",
    TextbookScene(
        summary="A rocket burns its fuel, in deep space or straight up from the ground.",
        opening=(r"rocket", rf"burns?|ejects?|expels?|{FUEL}|exhaust"),
        phrases=(
            rf"<fuel:mass> of (?:it|which|this|that)(?: is)? {FUEL}",
            rf"of which <fuel:mass> is {FUEL}",
            rf"including <fuel:mass> of {FUEL}",
            rf"<dry:mass> (?:when empty|without (?:its |the )?{FUEL})",
            r"(?:dry|empty) mass (?:of |is )?<dry:mass>",
            r"(?:(?:initial|total) )?(?:mass (?:of |is )?)?<mass:mass>",
            rf"(?:burns|burning) (?:{FUEL} )?(?:at )?(?:a |the )?(?:constant )?(?:rate of )?<rate:rate>(?: of {FUEL})?",
            rf"(?:{FUEL} )?(?:rate of )?<rate:rate>",
            r"(?:relative )?exhaust (?:speed|velocity) (?:of |is )?<exhaust:speed>(?: relative to it)?",
            (
                rf"(?:ejects|ejecting|expels|expelling)(?: the)? {GAS}(?: backwards)? at (?:a )?(?:speed (?:of )?)?"
                rf"<exhaust:speed>(?: relative to (?:the rocket|itself))?"
            ),
            r"(?P<space>in (?:deep|empty|free|outer) space)(?: far from (?:all|any) (?:other )?bod(?:y|ies))?",
            r"(?P<space>far from (?:all|any) (?:other )?bod(?:y|ies))",
            (
                r"(?:takes off |lifts off |launched |starts |stands )?(?:vertically |upright |straight up )?"
                r"(?P<ground>(?:from|on) (?:the )?(?:level )?ground)"
            ),
            r"(?:initially )?(?:starts |starting )?(?P<rest>(?:from|at) rest)",
            rf"rocket|until (?:all )?(?:the |no )?{FUEL} (?:is gone|is used up|is left|runs out)|floats",
        ),
        write=_rocket,
    ),
)


BALL = r"ball|stone|rock|projectile|cannonball|bullet|pebble|object|particle|body|arrow|coin|marble"
HIGH = r"(?:cliff|building|tower|bridge|roof|balcony|window|table|platform|wall|house)"
THROWN = r"(?:thrown|launched|projected|fired|shot|kicked|hit|tossed|hurled)"
FROM = r"(?:from|off) (?:(?:the )?(?:top|edge|roof) of )?(?:an? |the )?(?:vertical )?"
GROUND = r"(?:the )?(?:level |flat |horizontal )?ground(?: level)?"

ABOVE = rf"above (?:{GROUND}|(?:the )?(?:water|sea))"


def _way(facts: Facts) -> str:
    heading = facts.one_of("the direction of the throw", "level", "up", "down", "above", "below", "raised")
    if heading in ("above", "below", "raised"):
        angle = facts.number("angle", "the angle of the throw")
        if heading == "raised" and not facts.has("ground"):
            facts.missing.append("the direction of the throw, above or below the horizontal")
        return f"at an angle of {angle} {'below' if heading == 'below' else 'above'} the horizontal"
    return {"level": "horizontally", "down": "straight down"}.get(heading, "straight up")


def _throw(facts: Facts) -> str:
    mass = facts.or_symbol("mass", "m")
    start = "a point on level ground"
    if facts.one_of("the height from which it starts", "ground", "height") == "height":
        start = f"a point {facts.number('height', '')} above level ground"
    axes = "Let the x axis point forward and the y axis straight up. Air resistance is negligible."
    if facts.has("drop"):
        facts.one_of("how it starts", "drop", "speed", "level", "up", "down", "above", "below", "raised")
        return f"A small ball of mass {mass} is held at {start}. {axes} The motion starts from rest. {facts.gravity}"
    heading = _way(facts)
    speed = facts.number("speed", "the speed of the throw")
    thrown = f"At t = 0 a small ball of mass {mass} is thrown from {start} at speed {speed} {heading}."
    return f"{thrown} {axes} {facts.gravity}"


TEXTBOOK_SCENES.add(
    "throw",
    TextbookScene(
        summary="A ball is thrown, or let fall.",
        opening=(BALL, rf"{THROWN}|dropped|falls|fall|released from rest|throws|drops"),
        phrases=(
            *mass_of(BALL),
            r"(?:with )?(?:an? |the )?(?:initial )?(?P<level>horizontal) (?:speed|velocity) (?:of |is )?<speed:speed>",
            r"(?:with )?(?:an? |the )?(?:initial |muzzle |launch )?(?:speed|velocity) (?:of |is )?<speed:speed>",
            r"(?:at )?<speed:speed>",
            rf"{FROM}<height:length>(?: (?:high|tall))? {HIGH}",
            rf"{FROM}{HIGH} (?:of (?:a )?height (?:of )?|that is )?<height:length>(?: (?:high|tall|{ABOVE}))?",
            rf"(?:from )?(?:a |the )?height (?:of )?<height:length>(?: above {GROUND})?",
            rf"<height:length> {ABOVE}",
            rf"(?P<ground>(?:from|on|over) {GROUND})",
            r"(?:(?:from|off) )?(?:the )?(?:top|edge|roof)(?: of)?(?= (?:an? |the |\|))",
            rf"{FROM}{HIGH}",
            r"(?P<level>horizontally)",
            r"(?P<up>(?:straight|vertically) (?:up|upwards?))",
            r"(?P<down>(?:straight|vertically) (?:down|downwards?))",
            r"(?:an angle (?:of )?)?<angle:angle>(?: angle)? (?P<above>above (?:the )?horizontal)",
            r"(?:an angle (?:of )?)?<angle:angle>(?: angle)? (?P<below>below (?:the )?horizontal)",
            r"(?:an angle (?:of )?)?<angle:angle>(?: angle)? (?P<raised>(?:to|with) the horizontal)",
            r"(?P<drop>(?:dropped|released|falls|let fall|let go)(?: from rest)?(?! with))",
            r"(?P<drop>from rest)",
            rf"{THROWN}(?: into the air)?",
            r"(?:small|initially|high|golf|tennis|cricket)",
        ),
        bodies=BALL,
        write=_throw,
    ),
)
