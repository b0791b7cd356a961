"""Turns of phrase in conditions, and the plainer words that replace them."""

import re
from collections.abc import Mapping

from sim2reason.questions.ordinary.vocabulary import GROUNDS, compiled
from sim2reason.questions.ordinary.whatif.supposed_rows import MULTIPLES
from sim2reason.questions.ordinary.whatif.turns_of_need import TURNS_OF_CONDITIONS

_S = r"@\d+@"
_ROLLING = (
    "(?:this |that |such |its |pure |the )*rolling(?: motion)?(?: without (?:any )?(?:slipping|sliding|skidding)"
    "| purely)?(?: of"
    rf" (?P<s>{_S}))?(?: (?:down|up|along|on) (?:{GROUNDS}))?"
)
_MAKES = (
    "(?:allow|allows|permit|permits|make|makes|enable|enables|ensure|ensures|keep|keeps|guarantee"
    "|guarantees|cause|sustain|sustains|maintain)"
)
_STRAINED = "(?:stretched|extended|pulled out|drawn out|lengthened)"
_PRESSED = "(?:compressed|squeezed|shortened|pushed together)"
_MORE = "(?:by )?(?:more than|beyond|over)"
_REACHED = (
    r"(?:(?: ,)? (?:but|and|yet|though|while) (?:just |only )*(?:reach|reaches|reached|attain|attains|get to"
    r"|gets to|come to|touch)(?:es)?"
    r" (?:this|that|just that|exactly that)(?: \w+)?(?: once)?)?"
)
LIMIT_CONDITIONS: Mapping[str, str] = {
    r"\b(?P<v>come to rest|come to halt|come to stop|stop|halt) (?:after|within) (?:having |it has |@\d+@ has"
    r" )?(?:sliding|rolling|moving"
    r"|travelling|going|slid|rolled|moved|travelled|gone|sliding through|covering|covered)(?: for)? (?P<n>#\d+#)": (
        r"\g<v> after \g<n>"
    ),
    rf"^(?:keep|hold|let|leave)s? (?P<s>{_S})(?: (?:at rest|still|there|stay|staying|resting))* where (?:{_S}"
    rf"|it) (?:has |have )?"
    r"(?:stops?|stopped|comes? to rest|comes? to stop)$": r"\g<s> stay at rest where it stop",
    rf"^(?P<s>{_S}|it) (?:would |to )?(?:stay|remain|lie|rest)s?(?: at rest| still)? where (?:{_S}|it) (?:has "
    rf"|have )?(?:stops?|stopped|comes? to rest"
    r"|comes? to stop)$": r"\g<s> stay at rest where it stop",
    rf"^(?P<s>{_S}) (?:to )?be (?P<m>twice|half|three times|four times) as fast(?P<r>(?: (?:at|when|as) .+)?)$": (
        r"speed of \g<s>\g<r> be \g<m> as large"
    ),
    r"^(?:its |@\d+@ 's )?(?:circle|orbit|circular path|circular orbit) (?:to )?be (?P<m>twice|half|three times"
    r"|four times) as (?:large|big|wide)$": (r"radius of path be \g<m> as large"),
    r"\b(?P<v>land|lands|hit ground|come down) (?P<n>#\d+#) (?:away )?from (?:foot of|point (?:directly "
    r"|vertically )?(?:below|under)) (?:launch(?:ing)? point"
    r"|thrower|point of (?:projection|launch|release|throw)|tower|cliff|building|starting point)$": (
        r"\g<v> \g<n> away"
    ),
    rf"^(?P<s>{_S}) (?:is |to )?not (?:to )?(?:be )?(?:drawn|pulled|hauled|dragged|lifted|moved) up(?:"
    rf" (?:{GROUNDS}))?(?: by {_S})?$": r"\g<s> not rise up",
    r"^nothing (?:starts?|begins?) to (?P<v>slide|slip|move)$": r"it not \g<v>",
    r"\brolling (?:properly|truly|genuinely|purely)\b": "rolling without slipping",
    r" (?:at some stage|at some point|in course of time|sooner or later)$": " at some time",
    r"\b(?P<v>start|begin)s? rolling (?=without)": r"\g<v> to roll ",
    r"\b(?:ends?|finish(?:es)?|winds?) up rolling\b": "finally roll",
    r" (?:rather than|instead of) (?:just )?(?:fall|tip|sink|roll|drop)(?:ing)? back(?: (?:on|onto) .+)?$": "",
    r"^(?:axle|bearing|pivot) (?:to )?(?:be )?(?:pulled|loaded|strained|stressed) (?:with|by) (?:force of"
    r" )?(?P<n>#\d+#)(?P<r>(?: .+)?)$": (r"force on axle\g<r> be \g<n>"),
    rf"^(?P<s>{_S}|system|everything|nothing|it) (?:is|are|was|were|ought|has|have)(?P<no> not)?(?: (?:meant"
    rf"|supposed|required|expected"
    r"|intended|just))? to (?=[a-z])": r"\g<s>\g<no> ",
    rf"^(?P<s>{_S}|system|everything|it) (?:would|will|should|shall|can|could|does)(?P<no> not)?(?: (?:still"
    rf"|just|always))* (?!have)(?=[a-z]+)": (r"\g<s>\g<no> "),
    rf"^(?:once|after|when|as soon as) (?:it|{_S}) (?:has |is )?(?:stopped|stops|come to rest|comes to rest|come"
    rf" to stop|at rest) ,"
    rf" (?P<s>{_S}|it) (?:(?:is|ought|has|should|must|will)(?: (?:meant|supposed|required|expected|intended))?"
    rf" )?(?:to )?(?:stay|remain|lie|rest)s?(?: (?:there|at rest|put|still|where it is))*$": r"\g<s> stay at"
    r" rest where it stop",
    rf"^(?P<s>{_S}|system|it) (?P<v>stay|remain|keep|lie|come|go|stop)s (?=[a-z])": r"\g<s> \g<v> ",
    r"(?: ,)? once (?:started|moving|in motion|set in motion|set going|under way|it moves|they move|going)$": "",
    r" ,? ?(?:and|but) (?:no|not any|not) (?:more|further|farther)(?: than that)?$": " at most",
    rf"^(?:make |keep |for |leave )?(?P<s>{_S}|system|everything|it) (?:to )?(?:(?:go|move|roll|slide|slip"
    rf"|rise)s? neither up nor down"
    r"|neither (?:go|move|roll|slide|slip)(?:s|es|ing)? up nor (?:go |move |roll |slide |goes |moves |rolls "
    r"|slides )?down"
    r"|neither (?:rise|climb|ascend|go up|move up)s? nor (?:fall|sink|descend|drop|go down|move down)s?)(?:"
    r" (?:on|along) SLOPE)?$".replace("SLOPE", GROUNDS): r"\g<s> stay at rest",
    rf"^(?P<s>{_S}) (?:to )?(?:oscillate|vibrate|swing|revolve|turn|go round|go to and fro)s? once (?:every|in"
    rf"|in every|per) (?P<n>#\d+#)$": (r"period be \g<n>"),
    r"^(?:one|each|every) (?:gyration|full gyration|oscillation|vibration|swing|cycle|round trip) (?:to"
    r" )?(?:take|last)s? (?P<n>#\d+#)$": (r"period be \g<n>"),
    r"^make (?:its |their )?(?P<q>period|frequency|amplitude|acceleration|tension|final speed|greatest"
    r" speed)(?P<of> of @\d+@)? (?:be )?"
    r"(?=(?:just )?(?:twice|half|three times|double|four times))": r"\g<q>\g<of> be ",
    rf"^(?P<s>{_S}) (?:to )?(?:be )?(?:accelerates?|accelerated|moves?|starts?)(?: off)? (?P<way>to right|to"
    rf" left|towards right|towards left)"
    rf" (?:at|with)(?: acceleration of)? (?P<n>#\d+#)$": r"\g<s> accelerate at \g<n> \g<way>",
    r"\b(?P<v>get|go|climb|rise|move|slide|reach|travel|come)s? (?:more|farther|further|higher) than (?=#)": r"\g<v> ",
    r" (?:as soon as|when|once|moment) (?:its )?(?:engine|motor|rocket) (?:fires|lights up|starts up|comes on|is"
    r" fired|fires up|is turned on)$": " at once",
    rf"\bstraight off (?={GROUNDS})": "off ",
    rf"^(?P<s>{_S}|it) (?P<no>never|not) to (?=[a-z])": r"\g<s> \g<no> ",
    r"\b(?:come|get|go|jump|bounce|spring|rebound|rise|climb)s? back (?:up )?(?:again )?to (?:height of"
    r" )?(?P<n>#\d+#)$": (r"rise to height of \g<n> after first bounce"),
    r"\bright over (?=its |edge|lower)": "over ",
    rf"^(?:same (?:[a-z]+ ){{1,3}})?(?:is |are |will |does |would )?not (?:to )?(?:compress|squeeze) (?P<s>{_S})"
    rf" (?:by )?{_MORE} (?P<n>#\d+#)$": (r"greatest compression of \g<s> be \g<n>"),
    rf"^(?:same (?:[a-z]+ ){{1,3}})?(?:is |are |will |does |would )?not (?:to )?stretch (?P<s>{_S}) (?:by"
    rf" )?{_MORE} (?P<n>#\d+#)$": (r"greatest extension of \g<s> be \g<n>"),
    rf"^(?:{_MAKES} |for )?{_ROLLING}(?: (?:to )?(?:be |is |remain |remains |become )?(?:still |at all |just"
    rf" )*(?:possible|maintained"
    r"|kept up|sustained|able to (?:occur|happen|take place)|occur|happen|take place))?$": r"\g<s> roll without"
    r" slipping",
    rf"^(?:{_S} )?(?:(?:still|just|barely|even) )*(?:be )?(?:(?:able|enough|sufficient) to )?(?:start|set|get"
    rf"|send|begin)s? (?P<t>{_S})"
    rf" (?:sliding|moving|going|climbing|travelling|on its way|off)(?P<way> up(?:wards)?)?(?P<on> (?:{GROUNDS}))?$": (
        r"\g<t> begin to move\g<way>\g<on>"
    ),
    rf"^(?P<t>{_S}) (?:to )?(?:just )?(?:be |get |gets |is )(?:drawn|pulled|hauled|dragged|carried|moved|lifted"
    rf"|raised|set moving|set going"
    rf"|towed)(?P<way> up(?:wards)?| uphill)(?P<on> (?:{GROUNDS}))?(?: by {_S})?$": (
        r"\g<t> begin to move\g<way>\g<on>"
    ),
    rf"^(?P<s>{_S}) (?:to )?(?:be |is |gets )?(?:never|not|at no time) (?:be |get |gets )?(?:ever )?{_STRAINED}"
    rf" {_MORE}"
    rf" (?P<n>#\d+#){_REACHED}$": r"greatest extension of \g<s> be \g<n>",
    rf"^(?P<s>{_S}) (?:to )?(?:be |is |gets )?(?:never|not|at no time) (?:be |get |gets )?(?:ever )?{_PRESSED} {_MORE}"
    rf" (?P<n>#\d+#){_REACHED}$": r"greatest compression of \g<s> be \g<n>",
    rf"^(?P<q>extension|compression|stretch) of (?P<s>{_S}) (?:to )?(?:is |be )?(?:just )?(?:never|not|at no time)"
    rf" (?:exceed|be more than|become more than|go beyond|get beyond)s? (?P<n>#\d+#){_REACHED}$": (
        r"greatest \g<q> of \g<s> be \g<n>"
    ),
    rf"^(?P<s>{_S}) (?:to )?stretch(?:es)? (?:by )?at most (?P<n>#\d+#)$": r"greatest extension of \g<s> be \g<n>",
}
"""By the pattern of a part of a condition without articles, plainer words with the same meaning."""


_LIFTS = "(?:pull|haul|drag|draw|lift|bring|move|raise|hoist|tow|send|drive|push|carry)"
_LIFTING = "(?:pulling|hauling|dragging|drawing|lifting|bringing|moving|raising|hoisting|towing)"
_UP = rf"(?P<way>up|upwards|uphill|down|downwards|downhill)(?P<on> (?:{GROUNDS}))?"
_STEADY = r"(?: (?:at|with) constant (?:speed|velocity)| steadily| uniformly| at steady speed| without acceleration)"
_MOST = "(?:at most|at greatest|no more than|not more than|up to|at maximum)"
_GOES = "(?:go|move|rise|climb|accelerate|slide|descend|fall|sink|travel|be (?:pulled|drawn|hauled|accelerated))"
_SQUEEZED = "(?:squeezed|compressed|pushed together|pressed together|shortened)"
_STRETCHED = "(?:stretched|extended|pulled out|drawn out|lengthened)"
CONDITION_REWORDINGS: Mapping[str, str] = {
    rf"^(?:{_S} (?:would |could |can |will |to )?)?(?:be able to )?{_LIFTS} (?P<t>{_S}) {_UP}{_STEADY}$": (
        r"\g<t> move \g<way>\g<on> with constant speed"
    ),
    rf"^(?:{_S} (?:would |could |can |will |to )?)?(?:be able to )?(?:lift|raise|hoist)s? (?P<t>{_S}){_STEADY}$": (
        r"\g<t> move up with constant speed"
    ),
    rf"^(?:{_S} (?:would |could |can |will |to )?)?(?:lift|raise|hoist)s? (?P<t>{_S}) with acceleration of ": (
        r"\g<t> rise with acceleration of "
    ),
    rf"^(?P<t>{_S}) (?:to )?(?:be )?(?:pulled|drawn|hauled|dragged|move|moves) {_UP}{_STEADY}$": (
        r"\g<t> move \g<way>\g<on> with constant speed"
    ),
    rf"^(?:{_S} (?:would |could |can |will |to )?)?(?:be able to )?{_LIFTS}s? (?P<t>{_S}) (?:up|upwards|uphill)"
    rf"(?: (?:{GROUNDS}))?$": r"\g<t> rise up",
    rf"^(?:{_S} (?:would |could |will |to )?)?(?:(?:not|can not|cannot) {_LIFTS}|without {_LIFTING}) (?P<t>{_S})"
    rf" (?:up|upwards|uphill)(?: (?:{GROUNDS}))?$": r"\g<t> not rise up",
    rf"^(?P<t>{_S}) (?:would )?(?:just )?fail to be (?:pulled|hauled|dragged|lifted|drawn|moved) (?:up|upwards|uphill)"
    rf"(?: (?:{GROUNDS}))?$": r"\g<t> not rise up",
    rf"^(?:lift|raise) (?P<t>{_S})(?P<rest>(?: (?:at once|straight away|immediately|right away))?)$": (
        r"\g<t> rise\g<rest>"
    ),
    rf"^(?:{_S} )?(?:lift-off|liftoff|take-off|takeoff)(?P<rest> .+)?$": r"it lift off\g<rest>",
    rf"(?P<t>{_S}) (?P<verb>sink|descend|rise|move|go down|go up|fall|climb|slide) (?:by )?(?:{_MOST} )?(?P<n>#\d+#)"
    r"(?: at most)?$": r"\g<t> \g<verb> \g<n>",
    rf"(?P<t>{_S}) (?:sink|descend|go down|fall) (?P<n>#\d+#)$": r"\g<t> go down \g<n>",
    r"^(?:oscillations?|vibrations?|motion|system) (?:to )?(?:have|has) (?P<q>period|frequency|amplitude) of ": (
        r"\g<q> be "
    ),
    rf"^(?P<t>{_S}) (?:to )?(?:rise|climb|ascend|go up) (?P<n>#\d+#) vertically$": (
        r"greatest height of \g<t> be \g<n>"
    ),
    r"^(?:rise|climb|ascend|go up) (?P<n>#\d+#) vertically$": r"its greatest height be \g<n>",
    rf"^(?P<t>{_S}) (?:to )?{_GOES}(?P<w> (?:up|down|uphill|downhill|upwards|downwards))?(?: (?:{GROUNDS}))?"
    r" (?:with|at)"
    rf" (?P<m>{'|'.join(MULTIPLES)}) (?:of )?(?:its |@\d+@ 's )?(?:(?:present|actual|original) )?"
    r"(?P<q>acceleration|speed)(?: (?:(?:that )?(?:it|@\d+@) (?:has|had)(?: (?:now|at present|in scene))?|as now|of now"
    r"|(?:as )?(?:it is )?now))?$": r"\g<q> of \g<t>\g<w> be \g<m> what it is now",
    rf"^leave (?P<t>{_S}) (?:for good|for ever|forever|altogether)$": r"escape from \g<t>",
    rf"^(?:bring |make )?(?P<t>{_S}) (?:to |come to )?(?:rest|halt|stop|stops) (?:after|within) (?:(?:{_S}|it)"
    rf" has |having )?"
    r"(?:sliding|rolling|slid|rolled|moving|moved|travelling|travelled|going|gone) (?P<n>#\d+#)$": (
        r"\g<t> move \g<n> before \g<t> stops"
    ),
    rf"^(?P<t>{_S}) (?:to )?(?:get|go|rise|climb|gain) (?P<n>#\d+#) (?:higher|in height)$": (
        r"greatest height of \g<t> be \g<n>"
    ),
    r"^(?:get|go|rise|climb|gain) (?P<n>#\d+#) (?:higher|in height)$": r"its greatest height be \g<n>",
    rf"(?P<t>{_S}) (?:to )?be (?:lifted|raised|pulled up|drawn up|hauled up|hoisted) with acceleration of ": (
        r"\g<t> rise with acceleration of "
    ),
    r"(?P<i>initial )?(?P<way>upward|downward) acceleration of (?P<n>#\d+#)": r"\g<i>acceleration of \g<n> \g<way>s",
    r"^(?:flight|motion through air) (?:to )?(?:take|last)s? ": "time of flight be ",
    rf"^not (?:to )?be (?:pulled|hauled|dragged|drawn|lifted) (?:up|upwards|uphill)(?: (?:{GROUNDS}))?$": "not rise up",
    "^(?:equilibrium|balance)$": "system be in equilibrium",
    rf"^(?:move|start) (?P<t>{_S})$": r"\g<t> begin to move",
    rf"^(?:keep|prevent|stop|hold|keeps|prevents|stops|holds) (?P<t>{_S}(?: and {_S})?) from (?P<verb>[a-z]+ing)\b": (
        r"\g<t> not \g<verb>"
    ),
    rf"^without (?P<t>{_S}) (?P<verb>[a-z]+ing)\b": r"\g<t> not \g<verb>",
    rf"^(?:(?:take|carry|send|bring|get|let|raise|make)s? )?(?P<t>{_S}) (?:up )?to (?:greatest |maximum )?height of ": (
        r"\g<t> rise to height of "
    ),
    rf"^(?:carry|carried|take|taken|send|sent|bring|brought)s? (?P<t>{_S}) (?P<n>#\d+#) (?=up|down|along|away)": (
        r"\g<t> move \g<n> "
    ),
    rf"(?P<s>{_S}) (?:to )?(?:be |is |gets |get )?{_SQUEEZED} (?:by )?{_MOST} (?:by )?(?P<n>#\d+#)$": (
        r"greatest compression of \g<s> be \g<n>"
    ),
    rf"(?P<s>{_S}) (?:to )?(?:be |is |gets |get )?{_SQUEEZED} by (?P<n>#\d+#) (?:at most|at maximum)$": (
        r"greatest compression of \g<s> be \g<n>"
    ),
    rf"(?P<s>{_S}) (?:to )?(?:be |is |gets |get )?{_STRETCHED} (?:by )?{_MOST} (?:by )?(?P<n>#\d+#)$": (
        r"greatest extension of \g<s> be \g<n>"
    ),
    rf"(?P<s>{_S}) (?:to )?(?:be |is |gets |get )?{_STRETCHED} by (?P<n>#\d+#) (?:at most|at maximum)$": (
        r"greatest extension of \g<s> be \g<n>"
    ),
    rf"(?P<s>{_S}) (?:to )?(?:be )?(?:stretch|stretched|pulled out) to (?:greatest )?length of (?:at most )?"
    rf"(?P<n>#\d+#)(?: at most)?$": r"greatest length of \g<s> be \g<n>",
    rf"^(?:give|gives|given) (?P<s>{_S}) 's (?:path|circle|orbit) radius of ": "radius of path be ",
    rf"^(?:its|{_S} 's) (?:path|circle|orbit) (?:to )?(?:have|has) radius of ": "radius of path be ",
    r"^make (?P<q>period|frequency|amplitude|radius of (?:its |@\d+@ 's )?(?:path|circle)) (?:be )?(?=#)": r"\g<q> be ",
    rf"(?P<t>{_S}) (?:to )?(?:take|lift) off with (?:initial )?acceleration of ": r"\g<t> have initial"
    r" acceleration of ",
    r"^radius of (?:its |@\d+@ 's )?(?:path|circle|orbit)(?: of @\d+@)? (?:to )?(?:be|is|equal|equals) ": (
        "radius of path be "
    ),
    r"^(?:one|each|single) (?:revolution|turn|circuit|round|full turn|full circle|loop)(?: of @\d+@)? (?:to"
    r" )?(?:take|last)s?"
    r" ": "period be ",
    rf"(?P<s>{_S}) (?:to )?be under tension of ": r"tension in \g<s> be ",
    r"^(?P<x>first collision|second collision|collision|impact) (?:to )?(?:dissipate|convert|turn into heat)s?"
    r" (?P<n>#\d+#)$": (r"energy lost in \g<x> be \g<n>"),
    r"^(?:give|gives) (?=(?:amplitude|period|tension|acceleration|total energy)\b.* #\d+#)": "",
}
"""By the pattern of a part of a condition without articles, plainer words with the same meaning."""


def plainer_condition(condition: str) -> str:
    """Return a condition in plainer words."""
    condition = re.sub(
        r"^(?:made|make|makes|cause[sd]?|let|lets|allow(?:ed|s)?|enable[sd]?) (?=@|(?:first |second )?collision"
        r"|flight)",
        "",
        condition,
    )
    for template, plain in (*LIMIT_CONDITIONS.items(), *TURNS_OF_CONDITIONS.items(), *CONDITION_REWORDINGS.items()):
        condition = compiled(template).sub(plain, condition)
    return condition
