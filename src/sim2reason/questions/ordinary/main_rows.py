"""Patterns of main clauses, in base forms, each with an equivalent plain main clause."""

from sim2reason.questions.ordinary.clause_heads import HOME
from sim2reason.questions.ordinary.vocabulary import GROUNDS
from sim2reason.questions.ordinary.wanted_row import FORCE_ROWS, SHAPE_ROWS, WantedRow

_FALL, _RISE, _ROLL = "(?:fall|drop|descend|sink|lower)", "(?:rise|climb|ascend|lift|raise)", "roll"
_TURN = "(?:turn|rotate|spin|swing|revolve)(?: round| around)?"
_GO = (
    "(?:move|slide|travel|go|cover|fly|recoil|advance|get|come|traverse|run|reach|ride|drift|carry|drag|pull"
    "|shift|displace|progress|proceed)"
)
VERBS = {"fall": _FALL, "rise": _RISE, "roll": _ROLL, "turn": _TURN, "move": _GO}
MOTION = f"(?:{'|'.join(VERBS.values())})"
_FAST = "how (?:fast|quick|quickly|rapid|rapidly|swiftly)|what speed|how much speed"
_FAR = (
    "how far|(?:what|how much|how large a|how great a|length of) (?:distance|path)"
    "|distance|how many (?:metres|meters|m)"
)
_HIGH = "how high|(?:what|which) (?:height|altitude)|height|altitude"
_HEAT = "(?:heat|thermal energy|internal energy|mechanical energy|kinetic energy|energy|work)"
_LOST = (
    "(?:lose|loss|dissipate|dissipation|generate|produce|convert|transform|turn|develop|create|waste|consume|spend"
    "|absorb|release|do|disappear|vanish)"
)
_RUBS = "(?:friction|frictional force|force of friction|friction force|into heat|to heat)"
_ROUND = "(?:revolution|turn|oscillation|swing|round|orbit|circle|cycle|vibration|rotation|lap|loop|circuit|trip round)"
_ONCE = (
    f"(?:(?:one|a|single|full|complete|whole|each|entire) )+{_ROUND}|(?:once )?(?:around|round) once|once"
    f" (?:around|round)|year"
)
_LEVEL = f"(?:measured )?(?:horizontal|horizontally)|measured (?:along|on) (?:{GROUNDS})"
_IN_ALL = "total|whole|overall length|altogether|in total|in all|all together|overall|all in all|as a whole"
ALL_COLLISIONS = "how many collisions take place"  # the clause for collisions of all bodies, which names no body
SIZES = {
    "greatest": "greatest|maximum|maximal|largest|highest|biggest|peak|at most|most|maximally",
    "least": "least|minimum|minimal|smallest|lowest",
    "initial": "initial|initially|at first|starting|at (?:very )?(?:start|beginning)|(?:start|set|go|move) off"
    "|(?:begin|start)(?: to)? (?:move|motion|turn|rotate|slide|roll|fall|drop|rise|swing|spin|descend)|(?:begin"
    "|start) its motion",
    "final": "final|finally|eventual|eventually|ultimate|ultimately|terminal|limiting|in end|in long run",
}


ROWS = (
    WantedRow((r"how (?:fast|quickly|rapidly|strongly|hard|much)|(?:at )?(?:what|which) rate|rate at which",
         "accelerate|speed up|gain speed|pick up speed"), "how fast does {s} accelerate{way}"),
    WantedRow((r"how (?:fast|quickly|rapidly|strongly|hard|much)|(?:at )?(?:what|which) rate|rate at which",
         "decelerate|slow(?: down)?|brake|lose speed"), "what is deceleration of {s}"),
    WantedRow((_FAST, f"?{MOTION}"), "how fast does {s} {verb}{way}"),
    WantedRow((_FAST, f"?{MOTION}", "{size}"), "what is {size} {speed} of {s}"),
    WantedRow(("{quantity}", f"?{MOTION}"), "what is {quantity} of {s}{way}"),
    WantedRow(("{friction}|friction", "?force", "between|exert|act|from|of|by", f"(?P<face>{GROUNDS})",
         "?between|on|from|by"),
        "what friction of ground on {s}"),
    WantedRow(("{normal}", "between|exert|act|from|of|by|push|press", f"(?P<face>{GROUNDS})", "?between|on|from|by"),
        "what normal force of ground on {s}"),
    WantedRow(("moment of inertia",
         "(?:about|around|round|with respect to|relative to) (?:its )?(?:axle|axis of rotation|hinge|pivot)"),
        "what is moment of inertia of {s} about axle"),
    WantedRow((f"{_FAST}|speed|velocity", "relative to|with respect to|over|as seen from", f"?{MOTION}"),
        "how fast does {s} move{way} relative to {t}", 2),
    WantedRow((f"{_FAR}|(?:by )?how much", "relative to|with respect to|along|over|on|across", "?top of|surface of",
         f"{MOTION}|slip|skid"),
        "how far does {s} move relative to {t}", 2),
    WantedRow(("{quantity}", "{size}", f"?{MOTION}"), "what is {size} {quantity} of {s}"),
    WantedRow(("{quantity}", "horizontal|horizontally", "?component", f"?{MOTION}"),
        "what is horizontal component of {quantity} of {s}"),
    WantedRow(("{quantity}", "vertical|vertically", "?component", f"?{MOTION}"),
        "what is vertical component of {quantity} of {s}"),
    WantedRow(("{quantity}", "x(?:-| )?(?:component|direction)?", f"?{MOTION}"),
        "what is x component of {quantity} of {s}"),
    WantedRow(("{quantity}", "y(?:-| )?(?:component|direction)?", f"?{MOTION}"),
        "what is y component of {quantity} of {s}"),
    WantedRow(("(?:gravitational )?potential energy", "?(?:by )?how much|by what amount", "gain|increase|rise|grow"),
        "how much potential energy does {s} gain"),
    WantedRow(("(?:gravitational )?potential energy", "?(?:by )?how much|by what amount",
         "lose|loss|decrease|fall|drop"),
        "how much potential energy does {s} lose"),
    WantedRow(("{quantity}", f"{_IN_ALL}|combined|joint|together|taken together"),
        "what is total {quantity} of {s} and {t}", 2),
    WantedRow(("{quantity}", "?by how much|how much|(?:what|how large|how great) change|change", ("gain|increase"
    "|rise|grow|pick up|acquire|put on")),
        "how much {quantity} does {s} gain"),
    WantedRow(("{quantity}", "?by how much|how much", "lose|loss|decrease|fall|drop|diminish"),
        "how much {quantity} does {s} lose"),
    WantedRow(("{quantity}", "?by how much|how much", "change"), "how much {quantity} does {s} change"),
    # distances
    WantedRow((_FAR, HOME, f"?{MOTION}", "?away"), "how far is {s} from its starting point"),
    WantedRow((_FAR, f"(?:from|of) {HOME}", MOTION, "(?P<toward><(?:up|down|to right|to left)>)"),
        "how far does {s} move {toward}"),
    WantedRow((_FAR, _LEVEL, f"(?:from|of) {HOME}", f"?{MOTION}"), "how far horizontally does {s} move"),
    WantedRow((f"{_FAR}|displacement", HOME, "{greatest}|farthest|furthest", f"?{MOTION}", "?away"),
        "how far does {s} get from its starting point at most"),
    WantedRow(("(?:by )?how much", f"{_FALL}|{_RISE}|move|shift|advance|slide|recoil"), "how far does {s} {verb}{way}"),
    WantedRow((f"{_FAST}|speed", "relative to (?:each other|one another)", f"?{MOTION}"),
        "how fast do {s} and {t} move relative to each other", 2),
    WantedRow((f"{_FAST}|speed", "apart|together|(?:(?:toward|towards|away from|from) )?(?:each other|one another)",
         f"?{MOTION}|approach|recede|separate"), "how fast do {s} and {t} near or part", 2),
    WantedRow((_FAR, MOTION), "how far does {s} {verb}{way}"),
    WantedRow((f"{_FAR}|path", MOTION, _IN_ALL), "how far altogether does {s} move{way}"),
    WantedRow((_FAR, "(?P<side>below|beneath|under|above) HOME".replace("HOME", HOME), (f"(?:measured )?along"
    f" (?:{GROUNDS})"),
         f"?{MOTION}"), "how far {side} is {s}"),
    WantedRow((_FAR, "(?P<side>below|beneath|under|above) HOME".replace("HOME", HOME), f"?{MOTION}"),
        "how far vertically {side} its start is {s}"),
    WantedRow((_FAR, f"{_LEVEL}", MOTION), "how far horizontally does {s} move"),
    WantedRow((_FAR, _LEVEL, f"(?:from|of) {HOME}", "land|hit|strike|impact"),
        "how far horizontally does {s} land"),
    WantedRow((_FAR, "apart|between|from each other|from one another", "?(?:centre|center)s?(?: of)?", f"?{MOTION}"),
        "how far apart are {s} and {t}", 2),
    WantedRow(("(?:how (?:large|great) a )?distance|separation", "separate|lie between|lie|divide", "?between|from"),
        "how far is {s} from {t}", 2),
    WantedRow((_FAR, "from", "?away", f"?{MOTION}"), "how far is {s} from {t}", 2),
    WantedRow((_FAR, "from", "?away", "get|go|come|stray|recede"), "what is greatest distance between {s} and {t}", 2),
    WantedRow((_FAR, "from|between", "{greatest}|farthest|furthest", "?away", f"?{MOTION}"),
        "what is greatest distance between {s} and {t}", 2),
    WantedRow(("distance|how far", "to|from|between|of", "{least}|closest|nearest", f"?{MOTION}|approach"),
        "what is least distance between {s} and {t}", 2),
    WantedRow(("how (?:close|near)", "to", f"{MOTION}|approach"), "what is least distance between {s} and {t}", 2),
    # heights
    WantedRow((_HIGH, f"(?:above|over|from|off) (?:{GROUNDS})"), "how high is {s} above ground"),
    WantedRow((_HIGH, f"(?:above|over|from|off) (?:{GROUNDS})", "{greatest}", f"?{_RISE}|{_GO}|fly",
         "?point"), "how high does {s} rise above ground"),
    WantedRow((_HIGH, f"(?:above|over|from|off) (?:{GROUNDS})", f"{_RISE}|{_GO}|fly", "?point"),
        "how high does {s} rise above ground"),
    WantedRow((_HIGH, f"(?:above|over|from) {HOME}", "?{greatest}", f"{_RISE}|{_GO}|fly", "?point"),
        "how high above its starting point does {s} rise"),
    WantedRow((_HIGH, f"(?:above|over|from) {HOME}", "{greatest}", f"?{_RISE}|{_GO}|fly", "?point"),
        "how high above its starting point does {s} rise"),
    WantedRow((_HIGH, "?{greatest}", f"{_RISE}|{_GO}|fly", "?point"), "how high does {s} rise"),
    WantedRow((_HIGH, "{greatest}", f"?{_RISE}|{_GO}|fly", "?point"), "how high does {s} rise"),
    # springs
    WantedRow(("(?:by )?how (?:much|far|strongly)|by what (?:length|amount|distance)|compression",
         "compress|compression|shorten"),
        "how much is {s} compressed"),
    WantedRow(("(?:by )?how (?:much|far|strongly)|by what (?:length|amount|distance)|extension",
         "stretch|extend|lengthen|elongate|deform"),
        "how much is {s} stretched"),
    WantedRow(("(?:by )?how (?:much|far|strongly)|compression", "compress|compression|shorten", "{greatest}"),
        "how much is {s} compressed at most"),
    WantedRow(("(?:by )?how (?:much|far|strongly)|extension", "stretch|extend|lengthen|elongate", "{greatest}"),
        "how much is {s} stretched at most"),
    WantedRow(("how long|(?:total |whole )?length",), "how long is {s}"),
    WantedRow(("how (?:long|short)|length", "{least}|at least|shortest"), "what is shortest length of {s}"),
    WantedRow(("(?:to )?what", "{greatest}|longest", "length", "?get",
         "?stretch|extend"), "what is longest length of {s}"),
    WantedRow(("(?:to )?what", "{least}|shortest", "length",
         "?compress|shorten|get"), "what is shortest length of {s}"),
    WantedRow(("how short", "?get|become"), "what is shortest length of {s}"),
    WantedRow(("how long|length", "{greatest}|longest"), "what is longest length of {s}"),
    WantedRow(("(?:elastic |potential |spring |stored )*energy", "?store|stored|contain|hold|in spring",
         "?together|in all|altogether|in total"),
        "how much energy is stored in {s}"),
    # energies and impulses
    WantedRow((_HEAT, _LOST, f"(?:by|to|through|against|due to|because of|in|between|into|of)? ?{_RUBS}",
         "?friction|into heat|between|force of friction", f"?{_IN_ALL}"), "how much energy is lost to friction"),
    WantedRow(("(?:mechanical |kinetic )?energy", "lose|loss|dissipate", ("(?:in|by|during|through) (?:all (?:of"
        " )?)?collisions"),
         "?altogether|in all|in total|(?:taken |take )?together"), "how much energy is lost in all collisions"),
    WantedRow(("(?:mechanical )?energy", "?by how much|how much", "lose|loss|dissipate"),
        "how much mechanical energy does {s} lose"),
    WantedRow(("heat|thermal energy|internal energy", ("generate|produce|develop|create|dissipate|lose|release"
    "|arise|appear"),
         "?between|by|in|through", f"?{_IN_ALL}"), "how much energy is lost to friction"),
    WantedRow((r"(?:kinetic |mechanical )?energy", "take|remove|drain|withdraw|eat|rob", "?from|away|out", "friction",
         f"?{_IN_ALL}"), "how much energy is lost to friction"),
    WantedRow((r"(?:kinetic |mechanical )?energy",
         "lose|loss|dissipate|disappear|vanish|convert into heat|turn into heat"),
        "how much kinetic energy is lost"),
    WantedRow(("impulse", "give|receive|transfer|deliver|impart|get|exchange|exert|act", "?to|on|from"),
        "what impulse does {s} give {t}", 2),
    WantedRow(("impulse", "?give|receive|transfer|deliver|impart|get|exchange|exert|act|pass",
         "?each other|one another|other", "?each"), "what impulse does {s} give"),
    WantedRow(("impulse", "?give|receive|transfer|deliver|impart|get|exchange|exert|act|pass", "?to|on|from"),
        "what impulse does {s} give {t}", 2),
    WantedRow(("momentum", "transfer|transmit|hand over|pass on|give|impart|go over|pass", "(?:from|to)(?= @)",
         "(?:to|from)(?= @)"),
        "what impulse does {s} give {t}", 2),
    *FORCE_ROWS,
    *SHAPE_ROWS,
    # angles, periods and counts
    WantedRow(("radius", "?of (?:circle|circular path|path|orbit|trajectory|curvature|circular orbit|curve)",
         "?(?:on|along|in) which|(?:on|along)(?= )", f"?{MOTION}|describe|follow|trace",
         "?circle|path|orbit|trajectory|on|along"), "what is radius of {s}"),
    WantedRow(("(?:at |with |in )?(?:what|which) (?:angle|direction)|angle|how steep|how steeply",
         "(?:above|over) (?:the )?horizontal", f"?{MOTION}"), "what angle {s} makes above horizontal"),
    WantedRow(("(?:at |with |in )?(?:what|which) (?:angle|direction)|angle|how steep|how steeply",
         "(?:below|under|beneath) (?:the )?horizontal", f"?{MOTION}"), "what angle {s} makes below horizontal"),
    WantedRow(("(?:at |with |in )?(?:what|which) angle|angle", "?make|form|enclose|between|of",
         "(?:with|to|from|and|against) (?:the )?(?:horizontal|ground)", "?velocity|direction of motion", f"?{MOTION}"),
        "what angle {s} makes with horizontal"),
    WantedRow(("(?:through |by |at )?(?:what|which|how large an) angle|angle|by how much",
         "deflect|deviate|deflection|scatter",
         "?direction of motion|velocity|path|from its (?:initial|original) direction"),
        "what angle {s} is deflected through"),
    WantedRow(("how (?:much|many kg)|mass|what mass|amount", "fuel", "left|leave|remain|remaining|unburnt"),
        "how much left fuel {s}"),
    WantedRow(("how (?:much|many kg)|mass|what mass|amount", "fuel", "burn|use|consume|spend", "?up",
         "?(?:by )?engine"),
        "how much burnt fuel {s}"),
    WantedRow(("angle", "(?:make|form|with|between|and|to|from)*", "(?:downward )?vertical"),
        "what angle does {s} make with vertical"),
    WantedRow(("angle", "{greatest}", "(?:make|form|with|between|and|to|from)*", "(?:downward )?vertical"),
        "what is greatest angle of {s} with vertical"),
    WantedRow(("angle", "{least}|nearest|closest", "(?:make|form|with|between|and|to|from)*", "(?:downward )?vertical",
        "?reach|attain|make|come|get|swing"), "what is least angle of {s} with vertical"),
    WantedRow(("(?:at )?(?:what|which) angle|how steep|how steeply", ("?(?:with|to|from|and|against) (?:the"
    " )?(?:horizontal|ground)"), f"?{MOTION}|fly"),
        "what angle {s} hits at"),
    WantedRow(("power|rate", "(?:of |by )?(?:gravity|weight|gravitational force|its weight)",
         "?deliver|supply|do work|provide|develop|expend|work|transfer", "?energy|to|on"), "what is power of"
         " gravity on {s}"),
    WantedRow(("power|rate", "hand", "deliver|supply|do work|provide|develop|expend|work|transfer", "?energy"),
        "what is power of hand"),
    WantedRow(("angle", "{greatest}", "reach|attain|make|swing|get|deflect|turn to|rise to|deviate"),
        "what is greatest angle of {s} with vertical"),
    WantedRow(("(?:through |by )?(?:what|how large a|how big a)? ?angle", _TURN, f"?from {HOME}"),
        "through what angle does {s} turn"),
    WantedRow(("period(?: of revolution| of oscillation| of rotation)?", f"?{'{motion}'}", "?of"),
        "what is period of {s}"),
    WantedRow(("(?:how long|how much time|time|how many (?:seconds|years))",
         "?(?:(?:need|take|require|last|complete|make|go|go through|perform|execute|travel|move)(?: to)? ?)+", _ONCE),
        "what is period of {s}"),
    WantedRow(("(?:how long|how much time|how many (?:seconds|years))", "need|take|require", f"(?:to )?{_GO}",
         "round|around", "once|(?:one|single) time"),
        "what is period of {s} about {t}", 2),
    WantedRow(("(?:at )?(?:what|which) rate|rate at which", _TURN), "how fast does {s} turn"),
    WantedRow(("(?:how many times|how often)",
         ("(?:change|reverse) (?:its )?(?:direction|sense|way|motion)(?: of (?:motion|travel))?|reverse|turn"
         " (?:back|round|around)")),
        "how many times does {s} reverse"),
    WantedRow(("(?:through )?(?:how many|number of) (?:full |complete |whole )?(?:revolution|turn|rotation)s?",
         "?make|complete|perform|do|turn|through|go|undergo|spin|roll|execute"), "how many turns does {s} make"),
    WantedRow(("how many times|how often", "(?:turn|rotate|revolve|spin)(?! (?:back|round|around))"),
        "how many turns does {s} make"),
    WantedRow(("frequency", f"?{'{motion}'}"), "what is frequency of {s}"),
    WantedRow(("how many times|how often", f"bounce|rebound|hit|strike|land|(?:touch|meet|reach) (?:{GROUNDS})"),
        "how many times does {s} bounce"),
    WantedRow(("how many (?:collision|impact)s?|number of (?:collision|impact)s?",
         "between|among|of|do|have with each other",
         "?there|take place|happen|occur|undergo|have|suffer", f"?{_IN_ALL}"), "how many collisions between {s}"),
    WantedRow(("how (?:many times|often)",
         "collide|meet|(?:hit|run into|bump into|strike|touch) (?:each other|one another)",
         "?(?:with|against|into) (?:each other|one another)", f"?{_IN_ALL}"), "how many collisions between {s}"),
    WantedRow(("how many (?:collision|impact)s?|number of (?:collision|impact)s?", "?there|take place|happen|occur",
         _IN_ALL), ALL_COLLISIONS),
    WantedRow(("how many (?:collision|impact)s?|number of collisions?", "?there|take place|happen|occur|undergo"),
        ALL_COLLISIONS),
    WantedRow(("(?:x|y)(?:-| )(?:coordinate|position|value)", f"?{MOTION}"), "what is {axis} coordinate of {s}"),
    WantedRow(("{size}", "(?:x|y)(?:-| )(?:coordinate|position|value)|value of (?P<line>x|y)",
        f"?{MOTION}|reach", "?ever|at any time"), "what is {size} {axis}{line} coordinate of {s}"),
    WantedRow(("where|(?:(?:at |in |on )?(?:what|which) )?(?:point|position|place|spot)",
        f"?(?:of|on|along|in) (?:{GROUNDS})", f"?{MOTION}|lie|find"), "where is {s} on its line"),
)  # fmt: skip
