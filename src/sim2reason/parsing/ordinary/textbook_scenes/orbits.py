"""A planet round a star."""

from math import pi, sqrt

from sim2reason.parsing.ordinary.amounts import shown
from sim2reason.parsing.ordinary.textbook_scenes import TEXTBOOK_SCENES, Facts, TextbookScene


def _orbit(facts: Facts) -> str:
    star = facts.value("mass", "the mass of the star", "Msun")
    away = facts.value("away", "how far the planet is from the star", "au")
    kind = facts.one_of("how the planet moves, on a circle or with what velocity", "circle", "across")
    speed = 2.0 * pi * sqrt(star / away)
    if kind == "across":
        speed = facts.value("speed", "the speed of the planet", "au/yr")
    return (
        f"A star of mass {shown(star)} Msun is fixed at the origin of the x-y plane; the units are the astronomical"
        " unit (au), the year (yr) and the solar mass (Msun), in which G = 4π² au³/(Msun yr²). At t = 0 a planet is at"
        f" the point ({shown(away)} au, 0 au) and has the velocity (0 au/yr, {shown(speed)} au/yr). The planet is"
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
