"""Words and amounts of ordinary English: synonyms, words without physical content, numbers with units."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal
from functools import lru_cache
from math import isfinite

from sim2reason.scenes.dsl.units import Unit, UnitError, parse_unit

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


MINUS = "\N{MINUS SIGN}"
KINDS: Mapping[str, str] = {
    "mass": "kg",
    "length": "m",
    "speed": "m/s",
    "angle": "°",
    "accel": "m/s²",
    "stiffness": "N/m",
    "rate": "kg/s",
    "charge": "C",
    "field": "T",
    "time": "s",
    "force": "N",
}
PLAIN, INFINITE = "plain", "infinite"  # kinds of numbers without a unit, and of those too great for a float
SPELLED: Mapping[str, str] = {
    r"solar masse?s?": "Msun",
    r"astronomical units?": "au",
    r"(?:kilometers|kilometres) (?:per|an) hour|kph|kmph": "km/h",
    r"degrees?|deg": "°",
}
SIGNIFICANT_DIGITS = 12  # significant digits of a converted number
LEAST_PLAIN, MOST_PLAIN = 1e-6, 1e9  # smaller and greater numbers are written with powers of ten
MAX_UNIT_WORDS = 5  # of a unit, as in "metres per second per second"
_NUMBER = re.compile(
    rf"(?<![\w.#])([-{MINUS}]?\d{{1,30}}(?:\.\d{{1,30}})?)(?:[eE]([-+{MINUS}]?\d{{1,3}})"
    rf"|\s?[x×*]\s?10\^?([-{MINUS}]?\d{{1,3}}|[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]{{1,4}}))?(?![\d.]\d|[A-Za-z]\d)"
)
_UNIT = re.compile(r"[ -]?([^\s,;()]{1,30}(?: [^\s,;()]{1,30}){0,4})")
_RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


@dataclass(frozen=True, slots=True)
class Amount:
    """A value of a physical quantity, such as a mass or a length, in the SI unit of that quantity."""

    kind: str
    digits: str

    @property
    def value(self) -> float:
        """Return the number in the SI unit of its kind."""
        return float(self.digits.replace(MINUS, "-").replace(" × 10^", "e"))

    def value_in(self, unit: str) -> float:
        """Return the number in another unit of its kind; in the SI unit if `unit` is empty."""
        factor = parse_unit(KINDS[self.kind]).factor_to(parse_unit(unit)) if unit else 1.0
        assert factor is not None
        return self.value * factor

    @property
    def text(self) -> str:
        """Return the number with its unit, as the library writes it."""
        unit = KINDS.get(self.kind, "")
        return f"{self.digits}{'' if unit == '°' else ' '}{unit}".rstrip()


def extract_amounts(text: str) -> tuple[str, tuple[Amount, ...]]:
    """Replace the numbers of a text by placeholders such as `#mass0#`; return the text and the numbers in order."""
    for pattern, short in SPELLED.items():
        text = re.sub(rf"(?<=[\s-])(?:{pattern})\b", short, text)
    amounts: list[Amount] = []
    parts: list[str] = []
    at = 0
    for number in _NUMBER.finditer(text):
        if number.start() < at:
            continue
        unit, after = _unit(text, number.end())
        amount = _amount(number, unit)
        parts += [text[at : number.start()], f" #{amount.kind}{len(amounts)}# "]
        amounts.append(amount)
        at = after
    return "".join((*parts, text[at:])), tuple(amounts)


def format_amount(value: float) -> str:
    """Format a number as in the library's texts, with at most twelve significant digits."""
    if value and not LEAST_PLAIN <= abs(value) < MOST_PLAIN:
        digits, power = f"{value:.{SIGNIFICANT_DIGITS - 1}e}".split("e")
        digits = digits.rstrip("0").rstrip(".")
        return f"{digits} × 10^{int(power)}".replace("-", MINUS)
    return f"{Decimal(f'{value:.{SIGNIFICANT_DIGITS}g}'):f}".replace("-", MINUS)


def _amount(number: re.Match[str], unit: str) -> Amount:
    power = (number[2] or number[3] or "0").replace(MINUS, "-").translate(_RAISED)
    digits = number[1].replace(MINUS, "-")
    kind, factor = _kind(unit) if unit else (PLAIN, 1.0)
    if factor == 1.0 and int(power) == 0:
        return Amount(kind, digits.replace("-", MINUS))
    value = float(f"{digits}e{int(power)}") * factor
    return Amount(kind, format_amount(value)) if isfinite(value) else Amount(INFINITE, "")


def _unit(text: str, at: int) -> tuple[str, int]:
    """Return the unit at an index of a text (may be empty), and the index after it."""
    ahead = _UNIT.match(text, at)
    words = ahead[1].split(" ") if ahead else []
    for count in range(min(len(words), MAX_UNIT_WORDS), 0, -1):
        joined = " ".join(words[:count])
        if count > 1 and not re.search(r"/|\bper\b|⁻|\^-|[a-z]-\d", joined):
            continue  # no product of units with a word that follows by chance
        for unit in dict.fromkeys((joined.rstrip(".:"), joined.partition("-")[0])):
            if unit and _kind(unit)[0] != PLAIN and ahead is not None:
                return unit, ahead.start(1) + len(unit)
    return "", at


@lru_cache(maxsize=512)
def _kind(unit: str) -> tuple[str, float]:
    """Return the physical quantity of a unit, such as mass, and its factor to SI; `PLAIN` and 1 for other words."""
    parsed_unit = _known(unit)
    for kind, usual in KINDS.items() if parsed_unit is not None else ():
        factor = parsed_unit.factor_to(parse_unit(usual)) if parsed_unit is not None else None
        if factor is not None:
            return kind, float(f"{factor:.15g}")
    return PLAIN, 1.0


def _known(unit: str) -> Unit | None:
    try:
        return parse_unit(re.sub(r"(?<=[a-z])-(?=\d)", "^-", unit))
    except (UnitError, ArithmeticError):
        return None
