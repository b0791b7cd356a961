"""A rocket that burns its fuel."""

from sim2reason.parsing.ordinary.amounts import shown
from sim2reason.parsing.ordinary.textbook_scenes import TEXTBOOK_SCENES, Facts, TextbookScene

FUEL = r"(?:fuel|propellant)"
GAS = r"(?:exhaust )?(?:gas|gases|exhaust|fuel|it|them)"


def _rocket(facts: Facts) -> str:
    mass = facts.value("mass", "the mass of the rocket with its fuel")
    if facts.one_of("how much of the mass is fuel", "fuel", "dry") == "fuel":
        dry = f"{shown(mass - facts.value('fuel', ''))} kg"
    else:
        dry = facts.number("dry", "") if facts.has("dry") else "?"
    place = facts.one_of("where the rocket is, in deep space or on level ground", "space", "ground")
    stands = "is at rest in deep space, far from all other bodies"
    if place == "ground":
        stands = "stands upright on level ground in a uniform gravitational field, without air"
    facts.has("rest")
    rate = facts.number("rate", "the rate at which it burns fuel")
    exhaust = facts.number("exhaust", "the speed of the exhaust")
    return (
        f"A rocket of mass {facts.number('mass', '')} ({dry} without its fuel) {stands}. At t = 0 the engine starts: it"
        f" burns fuel at a rate of {rate} and ejects the gas backwards at speed {exhaust} relative to the rocket until"
        f" no fuel is left.{f' {facts.gravity}' if place == 'ground' else ''}"
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
