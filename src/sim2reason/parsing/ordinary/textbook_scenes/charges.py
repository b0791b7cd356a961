"""A charged particle in a uniform magnetic field."""

from dataclasses import replace

from sim2reason.parsing.ordinary.amounts import MINUS
from sim2reason.parsing.ordinary.textbook_scenes import TEXTBOOK_SCENES, Facts, TextbookScene

STRONG = 1e4  # times the weight of a particle that the magnetic force on it is, where gravity needs no word


def _charge(facts: Facts) -> str:
    charge = facts.amount("charge", "the charge of the particle")
    negative = charge is not None and charge.digits.startswith(MINUS)
    amount = replace(charge, digits=charge.digits.lstrip(MINUS)).text if charge is not None else "?"
    mass, field = facts.value("mass", "the mass of the particle"), facts.value("field", "the strength of the field")
    speed = facts.value("speed", "the speed of the particle")
    facts.one_of("that the velocity is perpendicular to the field", "across")
    turned = facts.has("out") or facts.has("into")
    way = "negative" if turned and facts.one_of("the direction of the field", "out", "into") == "into" else "positive"
    if facts.has("enters"):
        facts.missing.append("how far the field extends that it enters")
    force = abs(charge.value) * speed * field if charge is not None else 0.0
    if not facts.has("weightless") and charge is not None and force < STRONG * mass * facts.g:
        facts.missing.append("that there is no gravity")
    of = "a negative charge of magnitude" if negative else "a positive charge of"
    return (
        f"A uniform magnetic field of strength {facts.number('field', '')} points in the {way} z direction. At t = 0 a"
        f" small bead of mass {facts.number('mass', '')} with {of} {amount} leaves the origin of the x-y plane at speed"
        f" {facts.number('speed', '')} in the positive x direction. There is no gravity."
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
