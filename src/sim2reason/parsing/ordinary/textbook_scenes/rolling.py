"""A round body that rolls down a slope."""

from sim2reason.parsing.ordinary.textbook_scenes import TEXTBOOK_SCENES, Facts, TextbookScene, mass_of
from sim2reason.parsing.ordinary.textbook_scenes.slopes import SLOPE

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
