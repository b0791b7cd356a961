"""A block on a spring, level or hanging."""

from sim2reason.parsing.ordinary.amounts import shown
from sim2reason.parsing.ordinary.textbook_scenes import TEXTBOOK_SCENES, Facts, TextbookScene, mass_of

BLOCK = r"block|mass|box|body|object|cart|glider|weight|ball"
FLOOR = r"(?:floor|table|tabletop|surface|track|air track)"
STIFF = (
    r"(?:(?:a )?(?:spring )?(?:stiffness|spring constant|force constant|constant) (?:of |is )?)?(?:k = )?<k:stiffness>",
)
REST = (
    r"(?:and )?(?:then )?(?:held )?(?P<rest>at rest and (?:then )?(?:released|let go))",
    r"(?:(?:released|let go|starts) )?(?P<rest>from rest)",
    r"(?:and )?(?:then )?(?P<rest>released|let go)",
)
EQUILIBRIUM = r"(?:its |the )?(?:equilibrium|relaxed|rest|natural)(?: position| length)?"


def _level(facts: Facts) -> str:
    facts.one_of("that the surface is frictionless", "smooth")
    facts.one_of("how the block starts", "rest")
    way = facts.one_of("whether the spring is stretched or compressed", "out", "inwards")
    strain = "compressed" if way == "inwards" else "stretched"
    return (
        f"A block of mass {facts.number('mass', 'the mass of the block')} stands on a straight smooth horizontal track."
        f" A light spring of stiffness {facts.number('k', 'the stiffness of the spring')} runs from a fixed wall on the"
        f" left to the block. At the start the spring is {strain} by {facts.number('by', 'by how much')}."
        " The motion starts from rest."
    )


TEXTBOOK_SCENES.add(
    "block on a level spring",
    TextbookScene(
        summary="A block on a smooth table swings on a spring.",
        opening=(r"spring", r"attached|connected|joined|tied|fixed", FLOOR),
        phrases=(
            *STIFF,
            *mass_of(BLOCK),
            rf"(?P<smooth>frictionless|smooth)(?=(?: and)?(?: (?:horizontal|level|fixed))? {FLOOR})",
            (
                rf"(?P<out>pulled|stretched|pulled aside|drawn) (?:out |away )?(?:by )?<by:length>"
                rf"(?: (?:from|past|beyond)"
                rf" {EQUILIBRIUM}| away| out)?(?! from)"
            ),
            rf"(?P<inwards>compressed|pushed|pushed in) (?:by )?<by:length>(?: (?:from) {EQUILIBRIUM})?(?! from)",
            *REST,
            r"(?:light|massless|ideal)(?= spring)",
            r"horizontal|level|attached|connected|joined|fixed|tied|rests|lies|sits|wall|(?:(?:one|other|free) )?end",
            rf"spring|{FLOOR}",
        ),
        bodies=BLOCK,
        write=_level,
    ),
)


def _hanging(facts: Facts) -> str:
    facts.one_of("how the block starts", "rest")
    mass, stiffness = facts.value("mass", "the mass of the block"), facts.value("k", "the stiffness of the spring")
    length = facts.value("natural", "the natural length of the spring")
    start = facts.one_of("how long the spring is at the start", "long", "below", "unstretched", "out")
    at = length
    if start == "long":
        at = facts.value("long", "")
    elif start == "out":
        at = length + facts.value("out", "")
    elif start == "below":
        at = length + mass * facts.g / stiffness + facts.value("below", "")
    said = facts.number("mass", ""), facts.number("k", ""), facts.number("natural", "")
    return (
        f"A block of mass {said[0]} hangs from the ceiling by a light spring of stiffness {said[1]} and natural length"
        f" {said[2]}. Initially the spring has a length of {shown(at)} m. The motion starts from rest. {facts.gravity}"
    )


HANGS = r"(?:hangs|hanging|hung|suspended)"
TEXTBOOK_SCENES.add(
    "block on a hanging spring",
    TextbookScene(
        summary="A block hangs on a spring and swings up and down.",
        opening=(r"spring", rf"{HANGS}|vertical"),
        phrases=(
            *STIFF,
            *mass_of(BLOCK),
            r"(?:natural|unstretched|relaxed) length (?:of |is )?<natural:length>",
            (
                r"(?:pulled|drawn|displaced) (?:down|downwards?) (?:by )?<below:length>"
                r"(?: (?:from|below) (?:its |the )?equilibrium(?: position)?)"
            ),
            r"<below:length> below (?:its |the )?equilibrium(?: position)?",
            r"(?:spring )?stretched by <out:length>",
            r"(?:spring )?(?:has |with )?(?:an? )?(?:initial )?length (?:of )?<long:length>",
            r"(?:spring )?(?:is )?(?P<unstretched>unstretched|relaxed|at its natural length)",
            *REST,
            r"(?:light|massless|ideal|vertical|vertical light)(?= spring)",
            rf"{HANGS}|attached|ceiling|vertically|end|lower|held|fixed",
            r"spring",
        ),
        bodies=BLOCK,
        write=_hanging,
    ),
)
