"""A charged particle in a uniform magnetic field."""

from dataclasses import replace

from sim2reason.parsing.ordinary.amounts import MINUS
from sim2reason.parsing.ordinary.stories import STORIES, Story, Told

STRONG = 1e4  # times the weight of a particle that the magnetic force on it is, where gravity needs no word
G = 9.8  # m/s²


def _charge(told: Told) -> str:
    charge = told.amount("charge", "the charge of the particle")
    negative = charge is not None and charge.digits.startswith(MINUS)
    amount = replace(charge, digits=charge.digits.lstrip(MINUS)).text if charge is not None else "?"
    mass, field = told.value("mass", "the mass of the particle"), told.value("field", "the strength of the field")
    speed = told.value("speed", "the speed of the particle")
    told.one_of("that the velocity is perpendicular to the field", "across")
    turned = told.has("out") or told.has("into")
    way = "negative" if turned and told.one_of("the direction of the field", "out", "into") == "into" else "positive"
    if told.has("enters"):
        told.missing.append("how far the field extends that it enters")
    force = abs(charge.value) * speed * field if charge is not None else 0.0
    if not told.has("weightless") and charge is not None and force < STRONG * mass * G:
        told.missing.append("that there is no gravity")
    of = "a negative charge of magnitude" if negative else "a positive charge of"
    return (
        f"A uniform magnetic field of strength {told.number('field', '')} points in the {way} z direction. At t = 0 a"
        f" small bead of mass {told.number('mass', '')} with {of} {amount} leaves the origin of the x-y plane at speed"
        f" {told.number('speed', '')} in the positive x direction. There is no gravity."
    )


STORIES.add(
    "charge in a magnetic field",
    Story(
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
        tell=_charge,
    ),
)
