"""Rows of the tables of what main clauses ask for: forces, shapes, centres of mass, orbits and swings."""

from collections.abc import Sequence
from typing import NamedTuple

from sim2reason.questions.ordinary.vocabulary import GROUNDS


class WantedRow(NamedTuple):
    """Patterns that must all occur, in any order, and the plain main clause with the same meaning."""

    parts: Sequence[str]
    plain_clause: str
    subjects: int = 1


FORCE = (
    "how (?:hard|strongly)|(?:what|how much|how large a|how large|how great a|how big a) (?:total |resultant |net"
    " )*force"
    "|(?:total |resultant |net |whole )*(?:force|pull|load|reaction)"
)
_ACT = "load|exert|act|pull|push|press|apply|carry|bear|hold|support|take|withstand|sustain|hang"
_HOLDER = "axle|bear(?:ing)?|bracket|mount|mounting|support|suspension|hinge|pivot|(?:fixed )?axis"
_HOOK = (
    "(?:fixed )?(?:hook|ceiling|beam)|(?:its )?(?:point of suspension|suspension point|fixed point|suspension"
    "|upper end|point of support)"
)
GREATEST = "greatest|maximum|maximal|largest|highest|biggest|peak|most|at most"
_ON = "?by|on|of|from|upon|against"

FORCE_ROWS = (
    WantedRow((FORCE, GREATEST, f"?{_ACT}", _ON, _ON, "?wall|stop"), "what is greatest force of {s}", 2),
    WantedRow((FORCE, GREATEST, _HOLDER, f"?{_ACT}", "?on|by|from|of|at", "?on|by|from|of"),
        "what greatest force bears axle {s}"),
    WantedRow((FORCE, "(?:vertical )?guide", f"?{_ACT}", "?sideways|horizontal|horizontally", _ON),
        "what force of guide on {s}"),
    WantedRow((FORCE, "horizontal|sideways|horizontally", "(?:vertical )?guide", f"?{_ACT}", _ON),
        "what force of guide on {s}"),
    WantedRow((FORCE, "?net|resultant|total|whole", f"?{_ACT}", _ON, _ON, "?in total|in all|altogether|together"),
        "what force of string on pulley {s} {t}", 2),
    WantedRow((FORCE, "string|rope|cord|cable|thread", f"?{_ACT}", _ON, "?by|from|of"),
        "what force of the one string on pulley {s}"),
    WantedRow((FORCE, _HOLDER, f"?{_ACT}", "?on|by|from|of", "?on|by|from|of", "?have|in total|in all|altogether"),
        "what force bears axle {s} {t}", 2),
    WantedRow((FORCE, _HOLDER, f"?{_ACT}", "?on|by|from|of", "?have"), "what force bears axle {s}"),
    WantedRow((FORCE, "?string|rope|cord|cable|thread", f"?{_ACT}", _HOOK, _ON, _ON), "what force on hook {s}"),
    WantedRow(("how much", "pull|tug", "?on|at"), "what force does {s} exert on {t}", 2),
    WantedRow((FORCE, "support|carry|hold|bear", f"(?P<face>{GROUNDS})"), "what normal force of ground on {s}"),
    WantedRow((FORCE, "<up>", "exert|push|press|act|apply", f"(?P<face>{GROUNDS})", "?on", "?total|whole"),
        "what upward force of ground on {s}"),
    WantedRow((FORCE, "?total|whole", "exert|act|push|press|apply", "?by|from|of", f"(?P<face>{GROUNDS})",
         "?by|from|of|on"),
        "what whole force of ground on {s}"),
    WantedRow((FORCE, "act|experience|feel|exert", "?on"), "what force acts on {s}"),
    WantedRow((FORCE, "on|upon"), "what force acts on {s}"),
    WantedRow((FORCE, "press|push|bear", "?against|on|upon|onto|down on", f"?(?:its |their )?(?:{GROUNDS})"),
        "how hard does {s} press on ground"),
    WantedRow((FORCE, "exert|act|pull|push", "?by|on|of|from", ("(?:fixed )?(?:wall|stop|support"
    "|peg)"), "?by|on|of|from"),
        "what is force of {s}"),
    WantedRow((FORCE, "(?:fixed )?(?:wall|stop|peg)", "?on|from"), "what is force of {s}"),
    WantedRow((FORCE, "?pull|tug|exert|act"), "what force does {s} exert on {t}", 2),
    WantedRow((FORCE, "pull|tug|stretch"), "what is force of {s}"),
    WantedRow(("friction|{friction}", "?force", "between"), "what friction force acts between {s} and {t}", 2),
    WantedRow(("thrust(?: force)?", "?engine|motor|rocket|its engine", "?produce|provide|deliver|develop"),
        "what is thrust of {s}"),
)  # fmt: skip


_ROUND = (
    "(?:swing|oscillation|vibration|cycle|round|revolution|turn|rotation|loop|lap|circuit|orbit|period)(?: to and fro"
    "| there and back| back and forth)?"
)
_ONE = f"(?:(?:one|a|single|full|complete|whole|each|entire|every) )+{_ROUND}"
_CENTER = "(?:centre|center) of (?:mass|gravity)"
_FAST = "how (?:fast|quick|quickly)|(?:what|which|how large) (?:speed|velocity)|speed|velocity"

_FAR_END = "(?:from|to|of|between|and) far end(?: of)?"
SHAPE_ROWS = (
    WantedRow(("(?:by )?how much|by what", "height|altitude", "change|alter|vary", "?of"), "how far vertically is {s}"),
    WantedRow((_FAST, "(?:approach|near|recede from|part from|move away from) (?:each other|one another)"),
        "how fast do {s} and {t} near or part", 2),
    WantedRow(("heat|thermal energy|internal energy|energy", ("generate|produce|develop|create|dissipate|lose|release"
    "|arise|appear|set free"), "?by friction|to friction|in form of heat|as heat", "between"),
        "how much heat arises between {s} and {t}", 2),
    WantedRow(("how (?:close|near)", _FAR_END, "?get|come|approach|pass", "?at (?:closest|nearest)"),
        "how near to far end does {s} get {t}", 2),
    WantedRow(("distance|how far", _FAR_END, "?between", "{least}|closest|nearest", "?be|lie|get|come"),
        "how near to far end does {s} get {t}", 2),
    WantedRow(("distance|how far", _FAR_END, "?between|of", "{greatest}|farthest|furthest", "?be|lie|get|come|go"),
        "how far from far end does {s} get {t}", 2),
    WantedRow(("distance|how far", _FAR_END, "?between|of", "?be|lie|away"), "how far from far end is {s} {t}", 2),
    WantedRow(("friction|frictional force", "?force", "on|upon"), "what is friction force on {s}"),
    WantedRow(("amplitude", "?(?:of )?{motion}"), "what is amplitude of {s}"),
    WantedRow(("how eccentric|how elongated|how flat", "?orbit|path|ellipse"), "what is eccentricity of {s}"),
    WantedRow((_FAST, _CENTER, "?(?:of )?(?:both|two|whole|entire system|pair)", "?move|travel|go|drift|slide|advance"),
        "how fast does mass centre move {s}"),
    WantedRow(("how far|what distance|distance", f"{_CENTER}", (r"(?:from|off|to|and|away from|between)(?: @\d+@ 's)?"
        r" (?:its )?(?:geometrical"
    " |geometric |own )?(?:axis|centre|center|middle|axis of symmetry|rolling axis)"), "?lie|be|away|between"),
        "what is centre of mass offset of {s}"),
    WantedRow(("how far|what distance|distance", ("(?:from|off|to) (?:its )?(?:own )?(?:axis|centre|center)(?: of"
                                                 " symmetry)?"),
         f"(?:its )?{_CENTER}", "?lie|away"), "what is centre of mass offset of {s}"),
    WantedRow(("how far|what distance|distance", f"?{_CENTER}", ("(?:from|to|off|and|of|between)(?: its| @\\d+@ 's)?"
        " (?:axle|hinge|pivot)(?: of @\\d+@)?"), "?lie|be|away|between"), "how far is {s} from axle"),
    WantedRow(("moment of inertia", ("(?:about|around|round|with respect to|relative to) (?:its )?(?:own )?(?:axis"
                                     "|central"
    " axis|axis of symmetry|symmetry axis|centre|center|geometrical? axis)")), "what is inertia of {s} about its axis"),
    WantedRow(("how long|how much time|time|how many (?:seconds|years)|duration", f"(?:for |of |to )?{_ONE}",
         "?last|take|need|require|complete|make", "?{motion}"), "what is period of {s}"),
    WantedRow(("period|time of oscillation|period of oscillation", "?(?:of )?(?:small )?(?:swing|swinging|to and fro)+",
         "?motion|movement|back and forth"), "what is period of {s}"),
    WantedRow(("(?:how far|distance|what distance)", "from (?P<line>x|y)[- ]axis", "?away"), "how far is {s} from"
        " {line} axis"),
    WantedRow((_FAST, "relative to|with respect to|as seen from|over|past", "?move|slide|go|travel|roll|drift|slip"),
        "what is speed of {s} relative to {t}", 2),
    WantedRow(("acceleration|how (?:fast|quickly) accelerate|(?:with|at) what acceleration", ("relative to|with"
    " respect to|as"
        " seen"
    " from|over|along"), "?move|slide|go|travel|fall|rise", "?<(?:down|up)>"),
        "what is acceleration of {s} relative to {t}", 2),
    WantedRow(("how (?:fast|quick|quickly)|(?:at )?what (?:rate|speed)|speed", ("(?:descend|sink|drop|go <down>|lose"
        " height)")),
        "how fast does {s} go down"),
    WantedRow((("(?:through |by )?(?:how far|how much|(?:what|how great an?|how large an?) (?:vertical )?(?:distance"
               "|height"
    "|drop|depth)|by how much|vertical distance)"), "?vertical|vertically", ("(?P<fall>fall|drop|descend|sink|go <down>"
        "|move"
    " <down>|come <down>|lower)"), "?vertically"), "how far vertically below its start is {s}"),
    WantedRow((("through (?:what|how great a|how large a) (?:vertical )?(?:height|distance)|(?:what|how great a)"
               " (?:vertical"
    " )?height"), "rise|climb|ascend|go <up>|lift|raise", "?vertically"), "how far vertically above its start is {s}"),
    WantedRow(("(?:through )?(?:what|how great a|how large a) vertical (?:distance|height)|how far vertically", ("move"
        "|travel|go")),
        "how far vertically is {s}"),
    WantedRow(("common (?:speed|velocity)", "move|go|travel|continue|run", "?on|further|off|along"), "what is common"
        " speed of {s}"),
    WantedRow(("(?:by )?how much|what|change|find|how large", "momentum", ("change|gain|receive|lose|get|take over"
        "|pick up|give up"
    "|pass on|acquire")), "how much momentum does {s} exchange"),
    WantedRow(("how far", "vertically higher", "?lie"), "how far vertically above its start is {s}"),
    WantedRow(("how far", "vertically lower", "?lie"), "how far vertically below its start is {s}"),
    WantedRow(("impulse", f"(?:(?:{GROUNDS})|wall)", "?give|exert|impart|receive|transfer|get|act", "?to|on|from|by"),
        "what impulse does ground give {s}"),
    WantedRow(("impulse", "exchange|transfer|occur", "?between"), "what impulse is exchanged"),
    WantedRow(("work", "?done|perform", "by (?:hand|pull|pulling force)"), "how much work does hand do"),
    WantedRow(("(?:by )?how much", "height", "?above GROUNDS|of", "increase|grow|rise|gain"),
        "how far vertically above its start is {s}"),
    WantedRow(("(?:by )?how much", "height", "?above GROUNDS|of", "decrease|diminish|fall|drop|lose"),
        "how far vertically below its start is {s}"),
    WantedRow(("(?:through |by )?(?:what|which|how large an) angle|angle", "turn|change|swing|bend|rotate",
         ("(?:from )?(?:its )?(?:original |initial |first |old )?(?:direction|direction of motion|direction of travel"
         "|velocity)"),
         "?from its (?:original|initial) direction"), "what angle {s} is deflected through"),
    WantedRow(("angle", "(?:velocity|direction of motion|path)", ("(?:make|form|enclose)? ?(?:with|to|and|from)"
        " horizontal")),
        "what angle {s} makes with horizontal"),
    WantedRow(("(?:mechanical |kinetic )?energy|heat", "lose|loss|dissipate|give", ("(?:to|by|through|in|against)"
        " (?:resist(?:ing"
    "|ance)? (?:medium|of medium)|resistance(?: of medium)?|resisting medium|medium|drag|air|air resistance|drag"
    " force)")),
        "how much energy is lost to drag by {s}"),
    WantedRow(("how (?:large|great|big|much)|what|find", "work", "?done|perform", "?on|by"), "how much work does"
        " spring {s} do on {t}", 2),
    WantedRow(("how long|how much time|(?:for )?how many seconds", "in motion|on move|move|slide", ("?altogether|in"
        " all")),
        "how long is {s} moving"),
    WantedRow(("how (?:large|big|great)", "{greatest}", "(?P<line>x|y)[- ]coordinate", "?become|get|grow|be"),
        "what is greatest {line} coordinate of {s}"),
    WantedRow(("how (?:fast|quickly)|(?:at )?what rate", "length", "change|grow|increase|decrease|shrink"),
        "how fast does length of {s} change"),
    WantedRow(("(?:by )?how much|by what", "length", "change"), "how much does length of {s} change"),
    WantedRow(("what|how large", "stiffness|spring constant|force constant", "?have"), "what is stiffness of {s}"),
)  # fmt: skip
