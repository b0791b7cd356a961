"""Paraphrases of main clauses: what is wanted decides, and every other word must have its place."""

import re
from collections.abc import Iterator, Sequence
from functools import cache
from typing import NamedTuple

from sim2reason.questions.ordinary.base_forms import based
from sim2reason.questions.ordinary.paraphrased_clauses import HOME, PLACES, WAY, way_of
from sim2reason.questions.ordinary.vocabulary import GROUNDS, PHRASES, QUANTITIES, either

_S = r"@\d+@"
_FALL, _RISE, _ROLL = "(?:fall|drop|descend|sink)", "(?:rise|climb|ascend)", "roll"
_TURN = "(?:turn|rotate|spin|swing|revolve)"
_GO = "(?:move|slide|travel|go|cover|fly|recoil|advance|get|come|traverse|run|reach|ride|drift|carry|drag|pull)"
_VERBS = {"fall": _FALL, "rise": _RISE, "roll": _ROLL, "turn": _TURN, "move": _GO}
_MOTION = f"(?:{'|'.join(_VERBS.values())})"
_FAST = "how (?:fast|quick|quickly|rapid|rapidly|swiftly)|what speed|how much speed"
_FAR = (
    "how far|(?:what|how much|how large a|how great a|total|whole|length of) (?:total |whole )?(?:distance|path)"
    "|distance|how many (?:metres|meters|m)"
)
_HIGH = "how high|(?:what|which) (?:height|altitude)|height|altitude"
_HEAT = "(?:heat|thermal energy|internal energy|mechanical energy|kinetic energy|energy|work)"
_LOST = (
    "(?:lose|loss|dissipate|dissipation|generate|produce|convert|transform|turn|develop|create|waste|consume|spend"
    "|absorb|release|do)"
)
_RUBS = "(?:friction|frictional force|force of friction|friction force|into heat|to heat)"
_FORCE = "how (?:hard|strongly)|(?:what|how much|how large a|how great a) force|force"
_ROUND = "(?:revolution|turn|oscillation|swing|round|orbit|circle|cycle|vibration|rotation|lap|loop|circuit|trip round)"
_ONCE = f"(?:(?:one|a|single|full|complete|whole|each|entire) )+{_ROUND}|(?:once )?(?:around|round) once|once (?:around|round)|year"
_LEVEL = f"(?:measured )?(?:horizontal|horizontally)|measured (?:along|on) (?:{GROUNDS})"
_IN_ALL = "total|altogether|in total|in all|all together|overall|all in all|as a whole"
_SIZES = {
    "greatest": "greatest|maximum|maximal|largest|highest|biggest|peak|top(?= speed)|at most|most|longest|maximally",
    "least": "least|minimum|minimal|smallest|lowest|shortest|slowest",
    "initial": "initial|initially|at first|starting|at (?:very )?(?:start|beginning)",
    "final": "final|finally|eventual|ultimate|terminal|in end",
}
_ASKS = re.compile(r"\b(?:what|which|find|determine|calculate|compute|give|how|obtain|work out|when)\b")
_SUPPOSES = re.compile(
    r"\b(?:would|must|should|could|need|needed|required|if|not|half|without|more|less|average|mean|next|last"
    r"|another|second|third|(?:with|for|at|such) (?:which|that))\b"
)
_LOOSE = frozenset(
    "what which find determine calculate compute give how obtain work out large big great strong much high value size "
    "magnitude amount long of in on that for at with to by it its 's the a an , during while and along reach attain "
    "achieve acquire possess get go exert act experience undergo feel provide supply have exist between as from due "
    "body thing numerical modulus strength kind sort measured occur happen arise prevail".split()
)


class Row(NamedTuple):
    """What must all be there, in any order, and the plain main clause that says the same."""

    parts: Sequence[str]
    plain: str
    subjects: int = 1


ROWS = (
    Row((r"how (?:fast|quickly|rapidly|strongly|hard|much)|(?:at )?(?:what|which) rate|rate at which",
         "accelerate|speed up|gain speed|pick up speed"), "how fast does {s} accelerate{way}"),
    Row((r"how (?:fast|quickly|rapidly|strongly|hard|much)|(?:at )?(?:what|which) rate|rate at which",
         "decelerate|slow(?: down)?|brake|lose speed"), "what is deceleration of {s}"),
    Row((_FAST, f"?{_MOTION}"), "how fast does {s} {verb}{way}"),
    Row((_FAST, f"?{_MOTION}", "{size}"), "what is {size} {speed} of {s}"),
    Row(("{quantity}", f"?{_MOTION}"), "what is {quantity} of {s}{way}"),
    Row(("{friction}|friction", "?force", f"between|exert|act|from|of|by", f"(?P<face>{GROUNDS})", "?between|on|from|by"),
        "what friction of ground on {s}"),
    Row(("{normal}", f"between|exert|act|from|of|by|push|press", f"(?P<face>{GROUNDS})", "?between|on|from|by"),
        "what normal force of ground on {s}"),
    Row(("moment of inertia", "(?:about|around|round) (?:its )?(?:axle|axis of rotation|hinge|pivot)"),
        "what is moment of inertia of {s} about axle"),
    Row((f"{_FAST}|speed|velocity", "relative to|with respect to|over|as seen from", f"?{_MOTION}"),
        "how fast does {s} move{way} relative to {t}", 2),
    Row((_FAR, "relative to|with respect to|along|over|on|across", "?top of|surface of", _MOTION),
        "how far does {s} move relative to {t}", 2),
    Row(("{quantity}", "{size}", f"?{_MOTION}"), "what is {size} {quantity} of {s}"),
    Row(("{quantity}", "horizontal|horizontally", "?component", f"?{_MOTION}"),
        "what is horizontal component of {quantity} of {s}"),
    Row(("{quantity}", "vertical|vertically", "?component", f"?{_MOTION}"),
        "what is vertical component of {quantity} of {s}"),
    Row(("{quantity}", "x(?:-| )?(?:component|direction)?", f"?{_MOTION}"),
        "what is x component of {quantity} of {s}"),
    Row(("{quantity}", "y(?:-| )?(?:component|direction)?", f"?{_MOTION}"),
        "what is y component of {quantity} of {s}"),
    Row(("(?:gravitational )?potential energy", "?(?:by )?how much|by what amount", "gain|increase|rise|grow"),
        "how much potential energy does {s} gain"),
    Row(("(?:gravitational )?potential energy", "?(?:by )?how much|by what amount", "lose|loss|decrease|fall|drop"),
        "how much potential energy does {s} lose"),
    Row(("{quantity}", f"{_IN_ALL}|combined|joint|together|taken together"),
        "what is total {quantity} of {s} and {t}", 2),
    # distances
    Row((_FAR, HOME, f"?{_MOTION}", "?away"), "how far is {s} from its starting point"),
    Row((_FAR, f"(?:from|of) {HOME}", _MOTION, "(?P<toward><(?:up|down|to right|to left)>)"),
        "how far does {s} move {toward}"),
    Row((_FAR, HOME, "{greatest}|farthest|furthest", f"?{_MOTION}", "?away"),
        "how far does {s} get from its starting point at most"),
    Row(("(?:by )?how much", f"{_FALL}|{_RISE}"), "how far does {s} {verb}{way}"),
    Row((f"{_FAST}|speed", "apart|together|(?:toward|towards|away from|relative to|from) (?:each other|one another)",
         f"?{_MOTION}|approach|recede|separate"), "how fast do {s} and {t} move relative to each other", 2),
    Row((_FAR, _MOTION, f"?{_IN_ALL}"), "how far does {s} {verb}{way}"),
    Row((_FAR, f"{_LEVEL}", _MOTION), "how far horizontally does {s} move"),
    Row((_FAR, _LEVEL, f"(?:from|of) {HOME}", "land|hit|strike|impact"),
        "how far horizontally does {s} land"),
    Row((_FAR, "apart|between|from each other|from one another", "?(?:centre|center)s?(?: of)?", f"?{_MOTION}"),
        "how far apart are {s} and {t}", 2),
    Row((_FAR, "from", f"?away", f"?{_MOTION}"), "how far is {s} from {t}", 2),
    Row((_FAR, "from|between", "{greatest}|farthest|furthest", f"?away", f"?{_MOTION}"),
        "what is greatest distance between {s} and {t}", 2),
    Row(("distance|how far", "to|from|between|of", "{least}|closest|nearest", f"?{_MOTION}|approach"),
        "what is least distance between {s} and {t}", 2),
    Row(("how (?:close|near)", "to", f"{_MOTION}|approach"), "what is least distance between {s} and {t}", 2),
    # heights
    Row((_HIGH, f"(?:above|over|from|off) (?:{GROUNDS})"), "how high is {s} above ground"),
    Row((_HIGH, f"(?:above|over|from|off) (?:{GROUNDS})", f"{_RISE}|{_GO}|fly|{{greatest}}",
         "?{greatest}|point"), "how high does {s} rise above ground"),
    Row((_HIGH, f"(?:above|over|from) {HOME}", f"{_RISE}|{_GO}|fly|{{greatest}}", "?{greatest}|point"),
        "how high above its starting point does {s} rise"),
    Row((_HIGH, f"{_RISE}|{_GO}|fly|{{greatest}}", "?{greatest}|point"), "how high does {s} rise"),
    # springs
    Row(("(?:by )?how (?:much|far|strongly)|compression", "compress|compression|shorten"), "how much is {s} compressed"),
    Row(("(?:by )?how (?:much|far|strongly)|extension", "stretch|extend|lengthen|elongate"), "how much is {s} stretched"),
    Row(("(?:by )?how (?:much|far|strongly)|compression", "compress|compression|shorten", "{greatest}"),
        "how much is {s} compressed at most"),
    Row(("(?:by )?how (?:much|far|strongly)|extension", "stretch|extend|lengthen|elongate", "{greatest}"),
        "how much is {s} stretched at most"),
    Row(("how long|(?:total |whole )?length",), "how long is {s}"),
    Row(("how (?:long|short)|length", "{least}|at least"), "what is shortest length of {s}"),
    Row(("how long|length", "{greatest}"), "what is longest length of {s}"),
    Row(("(?:elastic |potential |spring |stored )*energy", "?store|stored|contain|hold|in spring"),
        "how much energy is stored in {s}"),
    # energies and impulses
    Row((_HEAT, _LOST, f"(?:by|to|through|against|due to|because of|in|between|into|of)? ?{_RUBS}",
         "?friction|into heat|between|force of friction", f"?{_IN_ALL}"), "how much energy is lost to friction"),
    Row((r"(?:kinetic |mechanical )?energy", "lose|loss|dissipate|convert into heat|turn into heat"),
        "how much kinetic energy is lost"),
    Row(("impulse", "give|receive|transfer|deliver|impart|get|exchange|exert|act", "?to|on|from"),
        "what impulse does {s} give {t}", 2),
    Row(("impulse", "?give|receive|transfer|deliver|impart|get|exchange|exert|act|pass",
         "?each other|one another|other", "?each"), "what impulse does {s} give"),
    Row(("impulse", "?give|receive|transfer|deliver|impart|get|exchange|exert|act|pass", "?to|on|from"),
        "what impulse does {s} give {t}", 2),
    # forces
    Row((_FORCE, "press|push|bear"), "how hard does {s} press on ground"),
    Row((_FORCE, "?pull|tug|exert|act"), "what force does {s} exert on {t}", 2),
    Row((_FORCE, "pull|tug|stretch"), "what is force of {s}"),
    Row(("friction|{friction}", "?force", "between"), "what friction force acts between {s} and {t}", 2),
    Row(("thrust(?: force)?", "?engine|motor|rocket|its engine"), "what is thrust of {s}"),
    # angles, periods and counts
    Row(("radius", "?of (?:circle|circular path|path|orbit|trajectory|curvature|circular orbit|curve)",
         "?(?:on|along|in) which|(?:on|along)(?= )", f"?{_MOTION}|describe|follow|trace", "?circle|path|orbit|trajectory|on|along"), "what is radius of {s}"),
    Row(("(?:at |with |in )?(?:what|which) (?:angle|direction)|angle|how steep|how steeply",
         "(?:above|over) (?:the )?horizontal", f"?{_MOTION}"), "what angle {s} makes above horizontal"),
    Row(("(?:at |with |in )?(?:what|which) (?:angle|direction)|angle|how steep|how steeply",
         "(?:below|under|beneath) (?:the )?horizontal", f"?{_MOTION}"), "what angle {s} makes below horizontal"),
    Row(("(?:at |with |in )?(?:what|which) angle|angle", "?make|form|enclose|between|of",
         "(?:with|to|from|and|against) (?:the )?(?:horizontal|ground)", "?velocity|direction of motion", f"?{_MOTION}"),
        "what angle {s} makes with horizontal"),
    Row(("(?:through |by |at )?(?:what|which|how large an) angle|angle|by how much", "deflect|deviate|deflection|scatter",
         "?direction of motion|velocity|path|from its (?:initial|original) direction"),
        "what angle {s} is deflected through"),
    Row(("how much|mass|what mass|amount", "fuel", "left|leave|remain|remaining|unburnt"), "how much left fuel {s}"),
    Row(("how much|mass|what mass|amount", "fuel", "burn|use|consume|spend", "?up"), "how much burnt fuel {s}"),
    Row(("angle", "(?:make|form|with|between|and|to|from)*", "(?:downward )?vertical"),
        "what angle does {s} make with vertical"),
    Row(("angle", "{greatest}", "(?:make|form|with|between|and|to|from)*", "(?:downward )?vertical"),
        "what is greatest angle of {s} with vertical"),
    Row(("(?:through |by )?(?:what|how large a|how big a)? ?angle", _TURN), "through what angle does {s} turn"),
    Row(("period(?: of revolution| of oscillation| of rotation)?", f"?{'{motion}'}", "?of"),
        "what is period of {s}"),
    Row(("(?:how long|how much time|time|how many (?:seconds|years))",
         "?(?:(?:need|take|require|last|complete|make|go|go through|perform|execute|travel|move)(?: to)? ?)+", _ONCE),
        "what is period of {s}"),
    Row(("frequency", f"?{'{motion}'}"), "what is frequency of {s}"),
    Row(("how many times|how often", "bounce|rebound|hit|strike|land"), "how many times does {s} bounce"),
    Row(("how many (?:collision|impact)s?|number of collisions?", "?there|take place|happen|occur|undergo"),
        "how many collisions take place"),
    Row(("(?:x|y)(?:-| )(?:coordinate|position)", f"?{_MOTION}"), "what is {axis} coordinate of {s}"),
)  # fmt: skip


@cache
def _part(told: str) -> re.Pattern[str]:
    for name, row in _SIZES.items():
        told = told.replace(f"{{{name}}}", f"(?:{row})")
    told = told.replace("{size}", "|".join(f"(?P<{name}>{row})" for name, row in _SIZES.items()))
    told = told.replace("{quantity}", f"(?P<quantity>{_quantities()})").replace("{motion}", _motions())
    for name in ("friction", "normal"):
        told = told.replace(f"{{{name}}}", either(QUANTITIES[f"{name} force"].split("|")))
    return re.compile(rf"(?<![\w@#-])(?:{told.replace('SURFACE', GROUNDS)})(?![\w@#-])")


@cache
def _quantities() -> str:
    said = [name for row in QUANTITIES.values() for name in row.split("|")]
    plain = {name for name in said if name not in ("distance", "height", "altitude", "separation", "length", "mass")}
    return "|".join(sorted({*plain, "mass"}, key=len, reverse=True))


@cache
def _motions() -> str:
    return either(PHRASES["ITS_MOTION"].split("|"))


def paraphrased(question: str) -> Iterator[str]:
    """Yield plain main clauses that say what a main clause says, if every word of the clause has its place."""
    supposes = re.sub(r"radius of .*?(?:on|along|in) which", "", question)
    if _ASKS.search(question) is None or _SUPPOSES.search(supposes) is not None:
        return
    if re.search(r"\b(?:does|do|did|will) @\d+@ (?:get )?(?:stretch|compress|extend|shorten|lengthen)", question):
        return  # a change of the length, maybe not counted from the natural length
    text = " ".join(WAY.sub(lambda found: f" <{way_of(found['way'])}> ", _singular(question)).split())
    text = based(text)
    for row in ROWS:
        yield from _filled(row, text)


def _singular(text: str) -> str:
    """Return a text with its quantities in the singular."""
    return re.sub(r"\b(tension|acceleration|speed|velocitie|force|momentum|distance)s\b(?! up)", _one, text)


def _one(found: re.Match[str]) -> str:
    return found[1].replace("velocitie", "velocity")


def _filled(row: Row, text: str) -> Iterator[str]:
    """Yield a row's plain clause, filled in; nothing unless a text has all parts of the row, and only loose words."""
    rest, groups = text, dict[str, str]()
    for told in row.parts:
        found = _part(told.removeprefix("?")).search(rest)
        if found is None and told.startswith("?"):
            continue
        if found is None:
            return
        groups |= {name: said for name, said in found.groupdict().items() if said}
        groups["verb"] = next(
            (verb for verb, forms in _VERBS.items() if re.fullmatch(forms, found[0])), groups.get("verb", "")
        )
        groups["axis"] = found[0][0] if re.match("[xy][- ]", found[0]) else groups.get("axis", "")
        rest = f"{rest[: found.start()]} {rest[found.end() :]}"
    ways = re.findall(r"<(.+?)>", rest)
    rest = PLACES.sub(" ", re.sub(r"<.+?>", " ", rest))
    subjects = list(dict.fromkeys(re.findall(_S, rest)))
    if (
        set(re.sub(_S, " ", rest).split()) - _LOOSE
        or len(ways) > ("{way}" in row.plain)
        or len(subjects) > row.subjects
    ):
        return
    if row.subjects == 2 and not subjects:
        return
    size = next((name for name in _SIZES if groups.get(name)), "")
    verb = groups.get("verb") or "move"
    one, other = (*subjects, "", "")[:2]
    told = row.plain.format(
        s=one,
        t=other,
        way=f" {ways[0]}" if ways else "",
        verb=verb,
        size=size,
        axis=groups.get("axis", ""),
        quantity=groups.get("quantity", ""),
        toward=groups.get("toward", "").strip("<>"),
        speed="angular speed" if verb == "turn" else "speed",
    )
    yield re.sub(r" (?:of|in)(?= ?$)| and(?= ?$)|(?<=give) $", "", " ".join(told.split()))
