"""What main clauses ask for, in base forms, each with the plain main clause that says the same."""

from collections.abc import Sequence
from typing import NamedTuple

from sim2reason.questions.ordinary.clause_heads import HOME
from sim2reason.questions.ordinary.vocabulary import GROUNDS

S = r"@\d+@"
_FALL, _RISE, _ROLL = "(?:fall|drop|descend|sink)", "(?:rise|climb|ascend)", "roll"
_TURN = "(?:turn|rotate|spin|swing|revolve)"
_GO = "(?:move|slide|travel|go|cover|fly|recoil|advance|get|come|traverse|run|reach|ride|drift|carry|drag|pull)"
VERBS = {"fall": _FALL, "rise": _RISE, "roll": _ROLL, "turn": _TURN, "move": _GO}
MOTION = f"(?:{'|'.join(VERBS.values())})"
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
_ONCE = (
    f"(?:(?:one|a|single|full|complete|whole|each|entire) )+{_ROUND}|(?:once )?(?:around|round) once|once"
    f" (?:around|round)|year"
)
_LEVEL = f"(?:measured )?(?:horizontal|horizontally)|measured (?:along|on) (?:{GROUNDS})"
_IN_ALL = "total|altogether|in total|in all|all together|overall|all in all|as a whole"
SIZES = {
    "greatest": "greatest|maximum|maximal|largest|highest|biggest|peak|top(?= speed)|at most|most|longest|maximally",
    "least": "least|minimum|minimal|smallest|lowest|shortest|slowest",
    "initial": "initial|initially|at first|starting|at (?:very )?(?:start|beginning)",
    "final": "final|finally|eventual|ultimate|terminal|in end",
}


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
    Row((_FAST, f"?{MOTION}"), "how fast does {s} {verb}{way}"),
    Row((_FAST, f"?{MOTION}", "{size}"), "what is {size} {speed} of {s}"),
    Row(("{quantity}", f"?{MOTION}"), "what is {quantity} of {s}{way}"),
    Row(("{friction}|friction", "?force", "between|exert|act|from|of|by", f"(?P<face>{GROUNDS})",
         "?between|on|from|by"),
        "what friction of ground on {s}"),
    Row(("{normal}", "between|exert|act|from|of|by|push|press", f"(?P<face>{GROUNDS})", "?between|on|from|by"),
        "what normal force of ground on {s}"),
    Row(("moment of inertia", "(?:about|around|round) (?:its )?(?:axle|axis of rotation|hinge|pivot)"),
        "what is moment of inertia of {s} about axle"),
    Row((f"{_FAST}|speed|velocity", "relative to|with respect to|over|as seen from", f"?{MOTION}"),
        "how fast does {s} move{way} relative to {t}", 2),
    Row((_FAR, "relative to|with respect to|along|over|on|across", "?top of|surface of", MOTION),
        "how far does {s} move relative to {t}", 2),
    Row(("{quantity}", "{size}", f"?{MOTION}"), "what is {size} {quantity} of {s}"),
    Row(("{quantity}", "horizontal|horizontally", "?component", f"?{MOTION}"),
        "what is horizontal component of {quantity} of {s}"),
    Row(("{quantity}", "vertical|vertically", "?component", f"?{MOTION}"),
        "what is vertical component of {quantity} of {s}"),
    Row(("{quantity}", "x(?:-| )?(?:component|direction)?", f"?{MOTION}"),
        "what is x component of {quantity} of {s}"),
    Row(("{quantity}", "y(?:-| )?(?:component|direction)?", f"?{MOTION}"),
        "what is y component of {quantity} of {s}"),
    Row(("(?:gravitational )?potential energy", "?(?:by )?how much|by what amount", "gain|increase|rise|grow"),
        "how much potential energy does {s} gain"),
    Row(("(?:gravitational )?potential energy", "?(?:by )?how much|by what amount", "lose|loss|decrease|fall|drop"),
        "how much potential energy does {s} lose"),
    Row(("{quantity}", f"{_IN_ALL}|combined|joint|together|taken together"),
        "what is total {quantity} of {s} and {t}", 2),
    # distances
    Row((_FAR, HOME, f"?{MOTION}", "?away"), "how far is {s} from its starting point"),
    Row((_FAR, f"(?:from|of) {HOME}", MOTION, "(?P<toward><(?:up|down|to right|to left)>)"),
        "how far does {s} move {toward}"),
    Row((_FAR, HOME, "{greatest}|farthest|furthest", f"?{MOTION}", "?away"),
        "how far does {s} get from its starting point at most"),
    Row(("(?:by )?how much", f"{_FALL}|{_RISE}"), "how far does {s} {verb}{way}"),
    Row((f"{_FAST}|speed", "apart|together|(?:toward|towards|away from|relative to|from) (?:each other|one another)",
         f"?{MOTION}|approach|recede|separate"), "how fast do {s} and {t} move relative to each other", 2),
    Row((_FAR, MOTION, f"?{_IN_ALL}"), "how far does {s} {verb}{way}"),
    Row((_FAR, f"{_LEVEL}", MOTION), "how far horizontally does {s} move"),
    Row((_FAR, _LEVEL, f"(?:from|of) {HOME}", "land|hit|strike|impact"),
        "how far horizontally does {s} land"),
    Row((_FAR, "apart|between|from each other|from one another", "?(?:centre|center)s?(?: of)?", f"?{MOTION}"),
        "how far apart are {s} and {t}", 2),
    Row((_FAR, "from", "?away", f"?{MOTION}"), "how far is {s} from {t}", 2),
    Row((_FAR, "from|between", "{greatest}|farthest|furthest", "?away", f"?{MOTION}"),
        "what is greatest distance between {s} and {t}", 2),
    Row(("distance|how far", "to|from|between|of", "{least}|closest|nearest", f"?{MOTION}|approach"),
        "what is least distance between {s} and {t}", 2),
    Row(("how (?:close|near)", "to", f"{MOTION}|approach"), "what is least distance between {s} and {t}", 2),
    # heights
    Row((_HIGH, f"(?:above|over|from|off) (?:{GROUNDS})"), "how high is {s} above ground"),
    Row((_HIGH, f"(?:above|over|from|off) (?:{GROUNDS})", f"{_RISE}|{_GO}|fly|{{greatest}}",
         "?{greatest}|point"), "how high does {s} rise above ground"),
    Row((_HIGH, f"(?:above|over|from) {HOME}", f"{_RISE}|{_GO}|fly|{{greatest}}", "?{greatest}|point"),
        "how high above its starting point does {s} rise"),
    Row((_HIGH, f"{_RISE}|{_GO}|fly|{{greatest}}", "?{greatest}|point"), "how high does {s} rise"),
    # springs
    Row(("(?:by )?how (?:much|far|strongly)|compression", "compress|compression|shorten"),
        "how much is {s} compressed"),
    Row(("(?:by )?how (?:much|far|strongly)|extension", "stretch|extend|lengthen|elongate"),
        "how much is {s} stretched"),
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
         "?(?:on|along|in) which|(?:on|along)(?= )", f"?{MOTION}|describe|follow|trace",
         "?circle|path|orbit|trajectory|on|along"), "what is radius of {s}"),
    Row(("(?:at |with |in )?(?:what|which) (?:angle|direction)|angle|how steep|how steeply",
         "(?:above|over) (?:the )?horizontal", f"?{MOTION}"), "what angle {s} makes above horizontal"),
    Row(("(?:at |with |in )?(?:what|which) (?:angle|direction)|angle|how steep|how steeply",
         "(?:below|under|beneath) (?:the )?horizontal", f"?{MOTION}"), "what angle {s} makes below horizontal"),
    Row(("(?:at |with |in )?(?:what|which) angle|angle", "?make|form|enclose|between|of",
         "(?:with|to|from|and|against) (?:the )?(?:horizontal|ground)", "?velocity|direction of motion", f"?{MOTION}"),
        "what angle {s} makes with horizontal"),
    Row(("(?:through |by |at )?(?:what|which|how large an) angle|angle|by how much",
         "deflect|deviate|deflection|scatter",
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
    Row(("(?:x|y)(?:-| )(?:coordinate|position)", f"?{MOTION}"), "what is {axis} coordinate of {s}"),
)  # fmt: skip
