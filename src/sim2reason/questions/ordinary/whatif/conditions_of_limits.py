"""Turns of phrase in conditions that a limiting number is to meet, such as *never stretched by more*, made plain."""

from collections.abc import Mapping

from sim2reason.questions.ordinary.vocabulary import GROUNDS

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
