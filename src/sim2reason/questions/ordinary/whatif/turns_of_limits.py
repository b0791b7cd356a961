"""Turns of phrase in questions for a limiting number, such as *what mass must B exceed*, in plainer words."""

from collections.abc import Mapping

from sim2reason.questions.ordinary.vocabulary import GROUNDS
from sim2reason.questions.ordinary.whatif.numbers import NUMBERS

_S = r"@\d+@"
_NOUNS = "|".join(kind.nouns for name, kind in NUMBERS.items() if name != "motion at start")
_N = (
    rf"(?P<n>(?:{_S} 's |its )?(?:{_NOUNS})(?: (?:of|on|for) (?:{_S}|{GROUNDS})| between {_S} and (?:its )?(?:{_S}|{GROUNDS}))?)"
)
_AUX = "(?:would|must|should|could|will|does|do|are|can|has|might|may|did|is|needs)"
_HAVE = "(?:have to |need to |has to |needs to |to )?"
_NEXT = r"(?=for |so that |so as |so |if |to |in order |before |that |, )"
_VALUE = "(?:(?:least|minimum|smallest|lowest|limiting|critical|threshold) )?(?:value|limit|figure|amount)"
_TOPS = "(?:exceed|surpass|be above|lie above|be greater than|be larger than|be more than|be higher than|rise above|be over)"
_STAYS = (
    "(?:not exceed|never exceed|not surpass|not be above|not be greater than|not be larger than|not be more than"
    "|stay below|be below|be less than|be smaller than|remain below|lie below|not rise above|not be higher than)"
)
_LIMIT = "(?:critical|limiting|threshold|borderline)"
_ROLLING = (
    "(?:this |that |such |its |pure |the )*rolling(?: motion)?(?: without (?:any )?(?:slipping|sliding|skidding)| purely)?(?: of"
    rf" (?P<s>{_S}))?(?: (?:down|up|along|on) (?:{GROUNDS}))?"
)
_MAKES = "(?:allow|allows|permit|permits|make|makes|enable|enables|ensure|ensures|keep|keeps|guarantee|guarantees|cause|sustain|sustains|maintain)"
_STRAINED = "(?:stretched|extended|pulled out|drawn out|lengthened)"
_PRESSED = "(?:compressed|squeezed|shortened|pushed together)"
_MORE = "(?:by )?(?:more than|beyond|over)"
_REACHED = (
    r"(?:(?: ,)? (?:but|and|yet|though|while) (?:just |only )*(?:reach|reaches|reached|attain|attains|get to|gets to|come to|touch)(?:es)?"
    r" (?:this|that|just that|exactly that)(?: \w+)?(?: once)?)?"
)
_OWNER = rf"(?:hand 's pull|pull of hand|blow|gas(?:es)?|exhaust(?: gas(?:es)?)?|engine|hand|pull|motor|field|{GROUNDS})"
_SET = "(?:set going|set sliding|set rolling|set spinning|kicked off|propelled|driven|shoved|sent|flung|hurled|tossed|pushed off)"
_BREAK = "(?:break|snap|tear|give way|rip)"
_EXTRA = "(?:extra|additional|further|more)"
LIMIT_TURNS: Mapping[str, str] = {
    r" just (?=to (?:keep|hold|make|let|set|get|move|pull|lift|prevent|stop|start|bring|cause)\b)": " ",
    rf"\b(?:two|both) (?:parts|sides|halves|sections|strands|ends|portions) of (?={_S})": "",
    r"\bweight in (?:kg|kilograms)\b": "mass",
    rf"^from (?:what|which) {_N} (?:on|onwards|upwards) ,? ?(?={_AUX} )": r"for what least \g<n> ",
    rf"^what length (?P<a>{_AUX}) (?P<s>{_S}) (?:have to )?(?:have|be given|be put at) (?:at start|initially) {_NEXT}": (
        r"what initial length \g<a> \g<s> need "
    ),
    rf"^by (?:what|which) factor {_AUX} (?P<s>{_S}) {_HAVE}be (?:lengthened|made longer|extended) {_NEXT}": (
        r"by what factor must length of \g<s> be increased "
    ),
    rf"^how (?:fast|quickly) (?P<a>{_AUX}) (?P<b>blow|kick|push|hammer) {_HAVE}make (?P<s>{_S}) (?:move|go|travel|start|slide)(?: off)? {_NEXT}": (
        r"how fast \g<a> \g<b> have to send \g<s> "
    ),
    rf"^how much (?:of its )?mass {_AUX} {_HAVE}be (?:taken away|removed|taken off|taken)(?: from| off| away from)? (?P<s>{_S}) {_NEXT}": (
        r"by how much must mass of \g<s> be reduced "
    ),
    r" with (?:this|that|same|given) (?:engine|motor|string|pull|force|hand)$": "",
    rf"^how many times (?:stronger|more intense) (?={_AUX} )": "how many times larger ",
    rf"^(?P<h>(?:with |at |by )?(?:what|how) [a-z ]*?)(?P<a>{_AUX}) (?P<s>{_S}) (?P<b>at (?:least|most)) (?=be |have |start|move|need)": (
        r"\g<b> \g<h>\g<a> \g<s> "
    ),
    rf"^if (?P<s>{_S}) (?:is|are|was|were) to make {_S} over (?P<t>top|highest point) , (?P<r>.+)$": (
        r"\g<r> for \g<s> to go over \g<t>"
    ),
    r"\b(?P<q>speed|velocity) at (?:its |very )?(?:bottom|lowest point) (?=(?:with|for|at) which .*\bround\b)": r"\g<q> ",
    rf"^what is escape (?:speed|velocity) (?:of (?P<s>{_S})(?: (?:at|from) (?:its )?(?:initial|starting|present) (?:position|distance|point|place))?"
    rf"|(?:at|from) (?P<s2>{_S}) 's (?:initial|starting|present) (?:position|distance|point|place))(?: from {_S})?$": (
        r"what least speed must \g<s>\g<s2> have to escape"
    ),
    r"\b(?P<q>speed|velocity) (?:given|imparted) by (?:blow|kick) (?=be|is|have)": r"\g<q> ",
    rf"^(?P<h>(?:with |at )?(?:what|which|how) .+? (?:have to |need to )?be) {_SET}(?P<c>(?: (?:up|down|off|along)(?: (?:{GROUNDS}))?)?)"
    rf"(?: (?:at|from) (?:its |very )?(?:bottom|lowest point)(?=.*(?:circle|round|over|top)))? {_NEXT}": r"\g<h> launched\g<c> ",
    rf"^(?:what|which) {_VALUE} {_AUX} {_N} (?:need to |have to |needs to |need )?(?:have|take|take on|assume|be)"
    rf"(?P<b> at (?:least|most))? {_NEXT}": r"what \g<n> is needed\g<b> ",
    rf"^(?:what|how large|how great|how big|how high) {_AUX} {_N} (?P<b>at (?:least|most)) {_HAVE}(?:be|amount to|equal|come to) {_NEXT}": (
        r"what \g<n> is needed \g<b> "
    ),
    rf"^(?:what|how large|how great|how big|how high) {_AUX} {_N} {_HAVE}(?:amount to|come to)(?P<b> at (?:least|most))? {_NEXT}": (
        r"what \g<n> is needed\g<b> "
    ),
    rf"^(?:what|which) {_N} {_AUX} (?P<b>at (?:least|most) )?{_HAVE}be (?:present|available|at work|there){_NEXT}".replace("there)", "there) ")
    : r"what \g<n> is needed \g<b>",
    rf"^what {_AUX} {_N} {_HAVE}{_TOPS}(?: at start)? {_NEXT}": r"what least \g<n> is needed ",
    rf"^what {_AUX} {_N} {_HAVE}{_STAYS}(?: at start)? {_NEXT}": r"what greatest \g<n> is needed ",
    rf"^(?:what|which) (?P<q>{_NOUNS}) {_AUX} {_OWNER} {_HAVE}{_TOPS} {_NEXT}": r"what least \g<q> is needed ",
    rf"^(?:what|which) (?P<q>{_NOUNS}) {_AUX} {_OWNER} {_HAVE}{_STAYS} {_NEXT}": r"what greatest \g<q> is needed ",
    rf"^(?:what|which) (?P<z>least |greatest |minimum |smallest )?(?P<q>{_NOUNS}) {_AUX} {_HAVE}be (?:given|imparted|lent) to (?P<s>{_S}) {_NEXT}": (
        r"what \g<z>\g<q> would \g<s> need "
    ),
    rf"\b(?:what|how much) (?P<a>must|would|should|may|can|could) (?P<s>{_S}) (?:have to )?weigh(?: in (?:kg|kilograms))?"
    rf"(?P<b> at (?:least|most))? {_NEXT}": r"what mass \g<a> \g<s> have\g<b> ",
    rf"^how much mass (?P<a>must|would|should|may|can|could) (?P<s>{_S}) have": r"what mass \g<a> \g<s> have",
    rf"^how (?:small|large|great|big|little) (?:may|can|could|might) {_N} (?:become|get|be|be made) (?:before|until) (?P<s>{_S})"
    r" (?:no longer|not any more|ceases? to|stops?) (?P<c>.+)$": r"what \g<n> is needed for \g<s> to \g<c>",
    rf"^how (?P<how>small|large|great|big|little) (?:may|can|could|might) {_N} (?:become|get|be|be made) (?:before|until) (?P<c>.+)$": (
        r"what \g<n> is needed for \g<c>"
    ),
    rf"^by what mass {_AUX} (?P<s>{_S}) {_HAVE}be (?:loaded|weighted|increased) {_NEXT}": r"by how much must mass of \g<s> be greater ",
    rf"^what {_EXTRA} (?:load|mass) (?:on|for|in|of) (?P<s>{_S}) (?:would|must|will) (?:make|let|cause|give) ": (
        r"by how much must mass of \g<s> be greater for "
    ),
    rf"^(?:what|how much) (?:(?:is )?(?:least|smallest|minimum) )?{_EXTRA} (?P<q>{_NOUNS}) (?:that )?(?:{_AUX} (?P<s>{_S})|(?P<s2>{_S}) {_AUX}) (?:need|have|require)"
    rf"(?: to have)?(?: at start| initially)? {_NEXT}": r"by how much must \g<q> of \g<s>\g<s2> be greater ",
    rf"\b(?:this |same )?(?:engine|hand|motor) (?:could|can|would)(?: just| still)? (?=lift|pull|haul|move|raise|keep|hold|drag)": "would ",
    rf"^how fast (?P<a>{_AUX}) (?:exhaust )?gas(?:es)? {_HAVE}(?:leave|stream out|flow out|be blown out|shoot out|come out|rush out)"
    rf"(?: of (?:engine|nozzle|{_S}))? {_NEXT}": r"what exhaust speed is needed ",
    rf"^with (?P<w>what (?:fraction|share|part|percentage) of (?:its )?(?:vertical |normal )?(?:speed|velocity)) (?P<a>{_AUX}) (?P<s>{_S})"
    rf" {_HAVE}(?:rebound|bounce|come off|jump up|leave ground)(?: off ground| from ground)? {_NEXT}": r"\g<w> \g<a> \g<s> keep ",
    rf"^(?:what|which) {_VALUE} {_AUX} {_N} {_HAVE}{_TOPS} {_NEXT}": r"what least \g<n> is needed ",
    rf"^(?:what|which) {_VALUE} {_AUX} {_N} {_HAVE}{_STAYS} {_NEXT}": r"what greatest \g<n> is needed ",
    rf"^(?:what|which) (?P<q>{_NOUNS}) {_AUX} (?P<s>{_S}) {_HAVE}{_TOPS} {_NEXT}": (
        r"what least \g<q> must \g<s> have "
    ),
    rf"^(?:what|which) (?P<q>{_NOUNS}) {_AUX} (?P<s>{_S}) {_HAVE}{_STAYS} {_NEXT}": (
        r"what greatest \g<q> must \g<s> have "
    ),
    rf"^(?:above|beyond|over|past) (?:what|which) (?:{_VALUE} )?(?:of )?{_N} ,? ?(?={_AUX} )": r"for what least \g<n> ",
    rf"^(?:below|under|up to) (?:what|which) (?:{_VALUE} )?(?:of )?{_N} ,? ?(?={_AUX} )": r"for what greatest \g<n> ",
    rf"^(?P<ask>.+?) ,? (?P<b>at (?:the )?(?:very )?(?:least|most)) , (?={_AUX} )": r"\g<ask> \g<b> ",
    rf" , (?P<b>at (?:very )?(?:least|most)) , {_NEXT}": r" \g<b> ",
    rf" , (?P<b>at (?:very )?(?:least|most)) , ": r" \g<b> ",
    rf"(?: ,)? (?:with |and |for )?(?:(?:{_S} 's|its) )?(?:{_NOUNS}) (?:(?:stay|staying|remain|remaining|kept|held|left) )?"
    r"(?:as given|as stated|as before|as it is|as in text|as above)(?: ,)?": "",
    rf"\b(?P<f>for|with) (?P<l>least|greatest) {_LIMIT} ": r"\g<f> \g<l> ",
    r"\b(?P<a>would|will|could|can|must|should) (?:(?:still|just|barely|yet|even) )*be able to (?=[a-z])": r"\g<a> ",
    rf"\b(?P<a>would|must|should|does|did) (?P<b>blow|kick|push|hammer) (?P<h>have to |need to )?(?:give|impart|lend) to (?={_S})": (
        r"\g<a> \g<b> \g<h>give "
    ),
    rf"\bvalue (?:of|for) (?={_NOUNS})": "",
    rf"\b(?:cuts?|brings?) down\b": "lower",
}
"""By the pattern of a part of a question without articles, plainer words with the same meaning."""
LIMIT_CONDITIONS: Mapping[str, str] = {
    r"\b(?P<v>come to rest|come to halt|come to stop|stop|halt) (?:after|within) (?:having |it has |@\d+@ has )?(?:sliding|rolling|moving"
    r"|travelling|going|slid|rolled|moved|travelled|gone|sliding through|covering|covered)(?: for)? (?P<n>#\d+#)": r"\g<v> after \g<n>",
    rf"^(?:keep|hold|let|leave)s? (?P<s>{_S})(?: (?:at rest|still|there|stay|staying|resting))* where (?:{_S}|it) (?:has |have )?"
    r"(?:stops?|stopped|comes? to rest|comes? to stop)$": r"\g<s> stay at rest where it stop",
    rf"^(?P<s>{_S}|it) (?:would |to )?(?:stay|remain|lie|rest)s?(?: at rest| still)? where (?:{_S}|it) (?:has |have )?(?:stops?|stopped|comes? to rest"
    r"|comes? to stop)$": r"\g<s> stay at rest where it stop",
    rf"^(?P<s>{_S}) (?:to )?be (?P<m>twice|half|three times|four times) as fast(?P<r>(?: (?:at|when|as) .+)?)$": (
        r"speed of \g<s>\g<r> be \g<m> as large"
    ),
    r"^(?:its |@\d+@ 's )?(?:circle|orbit|circular path|circular orbit) (?:to )?be (?P<m>twice|half|three times|four times) as (?:large|big|wide)$": (
        r"radius of path be \g<m> as large"
    ),
    r"\b(?P<v>land|lands|hit ground|come down) (?P<n>#\d+#) (?:away )?from (?:foot of|point (?:directly |vertically )?(?:below|under)) (?:launch(?:ing)? point"
    r"|thrower|point of (?:projection|launch|release|throw)|tower|cliff|building|starting point)$": r"\g<v> \g<n> away",
    rf"^(?P<s>{_S}) (?:is |to )?not (?:to )?(?:be )?(?:drawn|pulled|hauled|dragged|lifted|moved) up(?: (?:{GROUNDS}))?(?: by {_S})?$": r"\g<s> not rise up",
    r"^nothing (?:starts?|begins?) to (?P<v>slide|slip|move)$": r"it not \g<v>",
    r"\brolling (?:properly|truly|genuinely|purely)\b": "rolling without slipping",
    r" (?:at some stage|at some point|in course of time|sooner or later)$": " at some time",
    r"\b(?P<v>start|begin)s? rolling (?=without)": r"\g<v> to roll ",
    r"\b(?:ends?|finish(?:es)?|winds?) up rolling\b": "finally roll",
    r" (?:rather than|instead of) (?:just )?(?:fall|tip|sink|roll|drop)(?:ing)? back(?: (?:on|onto) .+)?$": "",
    r"^(?:axle|bearing|pivot) (?:to )?(?:be )?(?:pulled|loaded|strained|stressed) (?:with|by) (?:force of )?(?P<n>#\d+#)(?P<r>(?: .+)?)$": (
        r"force on axle\g<r> be \g<n>"
    ),
    rf"^(?P<s>{_S}|system|everything|nothing|it) (?:is|are|was|were|ought|has|have)(?P<no> not)?(?: (?:meant|supposed|required|expected"
    r"|intended|just))? to (?=[a-z])": r"\g<s>\g<no> ",
    rf"^(?P<s>{_S}|system|everything|it) (?:would|will|should|shall|can|could|does)(?P<no> not)?(?: (?:still|just|always))* (?!have)(?=[a-z]+)": (
        r"\g<s>\g<no> "
    ),
    rf"^(?:once|after|when|as soon as) (?:it|{_S}) (?:has |is )?(?:stopped|stops|come to rest|comes to rest|come to stop|at rest) ,"
    rf" (?P<s>{_S}|it) (?:(?:is|ought|has|should|must|will)(?: (?:meant|supposed|required|expected|intended))? )?(?:to )?(?:stay|remain|lie|rest)s?(?: (?:there|at rest|put|still|where it is))*$": r"\g<s> stay at rest where it stop",
    rf"^(?P<s>{_S}|system|it) (?P<v>stay|remain|keep|lie|come|go|stop)s (?=[a-z])": r"\g<s> \g<v> ",
    r"(?: ,)? once (?:started|moving|in motion|set in motion|set going|under way|it moves|they move|going)$": "",
    r" ,? ?(?:and|but) (?:no|not any|not) (?:more|further|farther)(?: than that)?$": " at most",
    rf"^(?:make |keep |for |leave )?(?P<s>{_S}|system|everything|it) (?:to )?(?:(?:go|move|roll|slide|slip|rise)s? neither up nor down"
    r"|neither (?:go|move|roll|slide|slip)(?:s|es|ing)? up nor (?:go |move |roll |slide |goes |moves |rolls |slides )?down"
    r"|neither (?:rise|climb|ascend|go up|move up)s? nor (?:fall|sink|descend|drop|go down|move down)s?)(?: (?:on|along) SLOPE)?$".replace(
        "SLOPE", GROUNDS
    ): r"\g<s> stay at rest",
    rf"^(?P<s>{_S}) (?:to )?(?:oscillate|vibrate|swing|revolve|turn|go round|go to and fro)s? once (?:every|in|in every|per) (?P<n>#\d+#)$": (
        r"period be \g<n>"
    ),
    r"^(?:one|each|every) (?:gyration|full gyration|oscillation|vibration|swing|cycle|round trip) (?:to )?(?:take|last)s? (?P<n>#\d+#)$": (
        r"period be \g<n>"
    ),
    r"^make (?:its |their )?(?P<q>period|frequency|amplitude|acceleration|tension|final speed|greatest speed)(?P<of> of @\d+@)? (?:be )?"
    r"(?=(?:just )?(?:twice|half|three times|double|four times))": r"\g<q>\g<of> be ",
    rf"^(?P<s>{_S}) (?:to )?(?:be )?(?:accelerates?|accelerated|moves?|starts?)(?: off)? (?P<way>to right|to left|towards right|towards left)"
    rf" (?:at|with)(?: acceleration of)? (?P<n>#\d+#)$": r"\g<s> accelerate at \g<n> \g<way>",
    rf"\b(?P<v>get|go|climb|rise|move|slide|reach|travel|come)s? (?:more|farther|further|higher) than (?=#)": r"\g<v> ",
    r" (?:as soon as|when|once|moment) (?:its )?(?:engine|motor|rocket) (?:fires|lights up|starts up|comes on|is fired|fires up|is turned on)$": " at once",
    rf"\bstraight off (?={GROUNDS})": "off ",
    rf"^(?P<s>{_S}|it) (?P<no>never|not) to (?=[a-z])": r"\g<s> \g<no> ",
    r"\b(?:come|get|go|jump|bounce|spring|rebound|rise|climb)s? back (?:up )?(?:again )?to (?:height of )?(?P<n>#\d+#)$": (
        r"rise to height of \g<n> after first bounce"
    ),
    r"\bright over (?=its |edge|lower)": "over ",
    rf"^(?:same (?:[a-z]+ ){{1,3}})?(?:is |are |will |does |would )?not (?:to )?(?:compress|squeeze) (?P<s>{_S}) (?:by )?{_MORE} (?P<n>#\d+#)$": (
        r"greatest compression of \g<s> be \g<n>"
    ),
    rf"^(?:same (?:[a-z]+ ){{1,3}})?(?:is |are |will |does |would )?not (?:to )?stretch (?P<s>{_S}) (?:by )?{_MORE} (?P<n>#\d+#)$": (
        r"greatest extension of \g<s> be \g<n>"
    ),
    rf"^(?:{_MAKES} |for )?{_ROLLING}(?: (?:to )?(?:be |is |remain |remains |become )?(?:still |at all |just )*(?:possible|maintained"
    r"|kept up|sustained|able to (?:occur|happen|take place)|occur|happen|take place))?$": r"\g<s> roll without slipping",
    rf"^(?:{_S} )?(?:(?:still|just|barely|even) )*(?:be )?(?:(?:able|enough|sufficient) to )?(?:start|set|get|send|begin)s? (?P<t>{_S})"
    rf" (?:sliding|moving|going|climbing|travelling|on its way|off)(?P<way> up(?:wards)?)?(?P<on> (?:{GROUNDS}))?$": (
        r"\g<t> begin to move\g<way>\g<on>"
    ),
    rf"^(?P<t>{_S}) (?:to )?(?:just )?(?:be |get |gets |is )(?:drawn|pulled|hauled|dragged|carried|moved|lifted|raised|set moving|set going"
    rf"|towed)(?P<way> up(?:wards)?| uphill)(?P<on> (?:{GROUNDS}))?(?: by {_S})?$": r"\g<t> begin to move\g<way>\g<on>",
    rf"^(?P<s>{_S}) (?:to )?(?:be |is |gets )?(?:never|not|at no time) (?:be |get |gets )?(?:ever )?{_STRAINED} {_MORE}"
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
