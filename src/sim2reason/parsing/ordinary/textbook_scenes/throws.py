"""A ball that is thrown or dropped."""

from sim2reason.parsing.ordinary.textbook_scenes import TEXTBOOK_SCENES, Facts, TextbookScene, mass_of

BALL = r"ball|stone|rock|projectile|cannonball|bullet|pebble|object|particle|body|arrow|coin|marble"
HIGH = r"(?:cliff|building|tower|bridge|roof|balcony|window|table|platform|wall|house)"
THROWN = r"(?:thrown|launched|projected|fired|shot|kicked|hit|tossed|hurled)"
FROM = r"(?:from|off) (?:(?:the )?(?:top|edge|roof) of )?(?:an? |the )?(?:vertical )?"
GROUND = r"(?:the )?(?:level |flat |horizontal )?ground(?: level)?"

ABOVE = rf"above (?:{GROUND}|(?:the )?(?:water|sea))"


def _way(facts: Facts) -> str:
    way = facts.one_of("the direction of the throw", "level", "up", "down", "above", "below", "raised")
    if way in ("above", "below", "raised"):
        angle = facts.number("angle", "the angle of the throw")
        if way == "raised" and not facts.has("ground"):
            facts.missing.append("the direction of the throw, above or below the horizontal")
        return f"at an angle of {angle} {'below' if way == 'below' else 'above'} the horizontal"
    return {"level": "horizontally", "down": "straight down"}.get(way, "straight up")


def _throw(facts: Facts) -> str:
    mass = facts.or_symbol("mass", "m")
    place = "a point on level ground"
    if facts.one_of("the height from which it starts", "ground", "height") == "height":
        place = f"a point {facts.number('height', '')} above level ground"
    axes = "Let the x axis point forward and the y axis straight up. Air resistance is negligible."
    if facts.has("drop"):
        facts.one_of("how it starts", "drop", "speed", "level", "up", "down", "above", "below", "raised")
        return f"A small ball of mass {mass} is held at {place}. {axes} The motion starts from rest. {facts.gravity}"
    way = _way(facts)
    speed = facts.number("speed", "the speed of the throw")
    return f"At t = 0 a small ball of mass {mass} is thrown from {place} at speed {speed} {way}. {axes} {facts.gravity}"


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
