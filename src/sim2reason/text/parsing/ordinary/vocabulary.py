"""Synonyms of the words in scene texts, and words of ordinary English without physical content."""

from collections.abc import Mapping

PHRASES: Mapping[str, str] = {
    r"\(static and kinetic\)|, static and kinetic,|coefficients? of static and (?:of )?kinetic friction"
    r"|coefficients of friction": "coefficient of friction",
    r"(?:coefficient of friction ){2}": "coefficient of friction ",
    r"\b(?:coefficient of )?(kinetic|sliding|static) friction coefficient": r"coefficient of \1 friction",
    r"\bwith(?:out| no) friction\b|\bfriction-?(?:less|free)(?:ly)?\b|\b(?:perfectly|very) smooth\b": "smooth",
    r"\bsmooth(?: and|,)? (?:light|massless)? ?pulley": "pulley",
    r"\b(?:light|massless)(?: and|,)? smooth pulley": "pulley",
    r"\b(?:take|use|let|here|where|with)? ?(?:the )?"
    r"(?:free-fall acceleration|acceleration (?:of free fall|due to gravity))(?: is)?(?: g)?\b"
    r"|\b(?:take|use|let|here|where|with) g\b": "gravity",
    r"\b[µμ] ?= ?": "coefficient of friction ",
    r"\b[a-zθ] ?= ?": "",
    r"\bbetween the \w+ and the (?:plane|floor|ground|table|surface|incline|ramp|slope|track)\b"
    r"|^ ?on this plane,? (?=the coef)|(?<=friction) on this plane| on this plane(?= is #| ?\.?$)": "",
    r"[;,]? ?(?:and|it|which)? ?(?:can|is free to) roll (?:straight up or down the slope"
    r"|along the plane in a straight line)": "",
    r"\borigin of the x-y plane": "origin",
    r"\bpositive charge": "charge",
    r"\b(?:neglect|ignore|disregard) (?:any |all )?air (?:resistance|drag)"
    r"|\bair (?:resistance|drag) (?:is|can be|may be) (?:negligible|neglected|ignored)"
    r"|\bthere is no air (?:resistance|drag)|\bwithout air resistance": "airless",
    r"\bwith (?:(?:the|all|its|both) )*strings? taut": "",
    r"\b(?:the )?(?:motion|system|everything|all|bodies|masses) (?:starts?|begins?|is released|are released|is let go"
    r"|are let go)(?: from rest)?|\b(?:is|are) (?:then )?(?:released|let go)(?: from rest)?"
    r"|\b(?:starts?|begins?) (?:moving |to move )?from rest|\bat rest at first|\binitially at rest"
    r"|\ball is at rest": "rest",
    r"\b(?:to|with) the horizontal\b": "",
    r"\b(?:every|all|each|the) collisions? (?:is|are)|\bcollisions are": "collision",
    r"\b(?:perfectly|completely) elastic": "elastic",
    r"\bnatural length|\bunstretched length|\brelaxed length|\brest length": "natural",
    r"\b(?:spring|force) constant|\bstiffness": "",
    r"\bsmall\b|\bvery\b|\bsimple\b": "",
    r"\bslides? (?=on\b)": "",
    r"\bgiven (?:a|an|the) (?:initial )?(?:speed|velocity)": "launched",
    r"\b(?:pendulum consists of|(?:consists of|consisting of) pendulum)": "",
    r"\bat (?:the|one) (?:lower )?end of": "",
    r"\b(?:from|at|to) a (?:fixed )?(?:point|support|ceiling)(?= (?:a|by|on|with|via)\b)|\bto a fixed point(?=\.)": "",
    r"\b(?:is )?taut and\b": "",
    r"\bdownward vertical\b": "vertical",
    r"\bthe (?:top|edge|roof) of a (?:(?:cliff|building|tower|roof),? (?:of height )?)?(#\d+#)"
    r"(?:[ -](?:high|tall))?(?: (?:cliff|building|tower|roof))?\b"
    r"|\b(?:a point |a height of )?([#$]\d+[#$]) above (?:the )?(?:level |horizontal )?ground": r"highup \1\2",
    r"\b(?:a point on )?(?:the )?level ground": "ground",
    r"\balong the (?:plane|track|floor|ground|table|surface|incline|slope)\b": "",
    r"\b(up|down) the (?:plane|incline|slope|ramp)\b": r"\1",
    r"\bsolar mass(?:es)?\b": "Msun",
}
"""By a pattern of lower-case text, what stands for it before words are looked at, in this order."""

SYNONYMS: Mapping[str, str] = {
    "block": "crate parcel",
    "plane": "floor ground table tabletop surface incline ramp slope track",
    "horizontal": "level horizontally",
    "string": "rope cord thread",
    "ball": "bob bead stone particle",
    "cart": "trolley glider",
    "slab": "plank board",
    "rocket": "probe",
    "planet": "comet",
    "wedge": "prism",
    "cylinder": "roller",
    "hoop": "ring",
    "pipe": "tube",
    "launch": "launched thrown projected fired kicked set moving move moves sent leaves starts slides travels started",
    "up": "upward upwards uphill",
    "down": "downward downwards downhill",
    "joins": "connects connected joined attached ties tied connecting joining runs attaches",
    "passes": "passing led leads",
    "stretched": "extended",
    "away": "apart",
    "rolls": "rolling roll",
}
"""By a word, others that mean it in the text of a scene."""

FILLERS: frozenset[str] = frozenset(
    """a an the they them both of is are was were be being been by in into on onto upon at t with and that which who
    whose it its this these those there here initially first begin beginning moment start as then so has have having
    had given gives for to from between against under mass masses speed velocity angle angles makes making make
    inclined inclines incline's light massless inextensible ideal thin uniform fixed stationary straight rigid rests
    resting lies lie lying sits sitting stands standing placed put kept can may each one hangs hanging hang freely
    suspended dangles held initial strength radius height m g k v e mu we consider suppose called labelled""".split()  # noqa: SIM905 - a table of words
)
"""Words that tell nothing which the numbers, their units and the other words of a sentence do not tell."""

NOUNS: frozenset[str] = frozenset(
    "block ball sphere cart slab puck wedge planet rocket cylinder hoop pipe rod disc bead box carriage".split()  # noqa: SIM905
)
ORDERED: frozenset[str] = NOUNS | frozenset("right left up down above below x y forward backward".split())  # noqa: SIM905
"""Words of which the order matters, as that of letters does: which body is meant, and which way."""
SURFACES: frozenset[str] = frozenset({"plane", "wedge", "face", "side"})
TEXTURES: frozenset[str] = frozenset({"smooth", "rough"})
