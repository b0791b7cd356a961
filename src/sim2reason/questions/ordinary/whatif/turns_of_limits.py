"""Turns of phrase in questions for a limiting number, such as *what mass must B exceed*, in plainer words."""

from collections.abc import Mapping

from sim2reason.questions.ordinary.vocabulary import GROUNDS
from sim2reason.questions.ordinary.whatif.numbers import NUMBERS

_S = r"@\d+@"
_NOUNS = "|".join(kind.nouns for name, kind in NUMBERS.items() if name != "motion at start")
_N = (
    rf"(?P<n>(?:{_S} 's |its )?(?:{_NOUNS})(?: (?:of|on|for) (?:{_S}|{GROUNDS})| between {_S} and (?:its"
    rf" )?(?:{_S}|{GROUNDS}))?)"
)
_AUX = "(?:would|must|should|could|will|does|do|are|can|has|might|may|did|is|needs)"
_HAVE = "(?:have to |need to |has to |needs to |to )?"
_NEXT = r"(?=for |so that |so as |so |if |to |in order |before |that |, )"
_VALUE = "(?:(?:least|minimum|smallest|lowest|limiting|critical|threshold) )?(?:value|limit|figure|amount)"
_TOPS = (
    "(?:exceed|surpass|be above|lie above|be greater than|be larger than|be more than|be higher than|rise"
    " above|be over)"
)
_STAYS = (
    "(?:not exceed|never exceed|not surpass|not be above|not be greater than|not be larger than|not be more than"
    "|stay below|be below|be less than|be smaller than|remain below|lie below|not rise above|not be higher than)"
)
_LIMIT = "(?:critical|limiting|threshold|borderline)"
_OWNER = (
    rf"(?:hand 's pull|pull of hand|blow|gas(?:es)?|exhaust(?: gas(?:es)?)?|engine|hand|pull|motor|field|{GROUNDS})"
)
_SET = (
    "(?:set going|set sliding|set rolling|set spinning|kicked off|propelled|driven|shoved|sent|flung|hurled"
    "|tossed|pushed off)"
)
_EXTRA = "(?:extra|additional|further|more)"
LIMIT_TURNS: Mapping[str, str] = {
    rf"\bbe at least (?P<v>multiplied|increased|raised) {_NEXT}": r"be \g<v> ",
    rf"\bbe (?P<v>multiplied|increased|raised) at least {_NEXT}": r"be \g<v> ",
    r"(?P<e>\b(?:round|top|circle)\b.*?) (?:with|keeping) (?:string|rope|cord|@\d+@) (?:always |still |staying "
    r"|remaining "
    r"|being )?(?:taut|tight)(?: (?:throughout|all (?:the )?(?:time|way)|all along|everywhere))?$": r"\g<e>",
    r"\b(?P<v>launched|started|set off|set moving|thrown|sent off|set in motion) downwards?(?: along (?:its )?arc)?"
    r"(?: from (?:this|that|its(?: initial)?) position)? (?=so that|for|in order|to |if )": r"\g<v> ",
    r"\b(?P<q>constant (?:speed|velocity)) (?:once|after (?:being|having been)) (?:started|moving|in motion"
    r"|set moving|set in motion|set going)$": r"\g<q>",
    rf"^what (?P<z>least |minimum |smallest )?{_N} (?:would|will|could|can) (?:just )?(?:prevent|stop|keep)"
    rf" (?P<s>{_S}) "
    r"(?:from )?(?:starting )?(?:to )?(?P<v>move|slide|slip|moving|sliding|slipping)(?: at all)?$": (
        r"what is least \g<n> for which \g<s> not move"
    ),
    rf"^what {_N} {_AUX} it take (?:at start )?to (?:send|get|bring|push|drive|throw|carry) (?P<s>{_S}) ": (
        r"what \g<n> would \g<s> need to move "
    ),
    rf"\b(?P<b>blow|kick|push|hammer) (?P<h>have to |need to )?send off (?P<s>{_S}) ": r"\g<b> \g<h>send \g<s> ",
    rf"\b(?P<c>coefficient of friction|friction coefficient) (?:on|at|of|for) (?:its |{_S} 's )?top(?: surface)?"
    rf"(?= (?:for|with|at) which (?P<s>{_S}) (?:.*\b)?(?:slip|slide|move)(?: (?:on|over|along|relative to))"
    rf" (?P<t>{_S})$)": (r"\g<c> between \g<s> and \g<t>"),
    r"\. \((?:assume|suppose)(?: that)? @\d+@ (?:is |be )?(?:still |always )*(?:heavy|light|large|small|great) enough"
    r" (?:that|so that|for) [^#]+\)?$": "",
    r"^by how much (?:does|do) (?P<n>.+?) (?:have|need) to be (?=\w+(?:ed|ered|er) )": r"by how much must \g<n> be ",
    r"\b(?P<r>(?:stay|remain)s? (?:at rest|still|where (?:it is|they are))) after (?:it|they|system|everything"
    r"|@\d+@) (?:is"
    r"|are|has been|have been|has|have) (?:let go|released|set free)": r"\g<r>",
    r" just (?=to (?:keep|hold|make|let|set|get|move|pull|lift|prevent|stop|start|bring|cause)\b)": " ",
    r"^(?P<p>from|at|under|with|for) which (?=(?:[a-z]+ ){1,3}(?:would|must|should|does|is) )": r"\g<p> what ",
    rf"(?P<s>{_S}) (?P<h>have to |need to )?(?:set off|set out) {_NEXT}": r"\g<s> \g<h>start ",
    rf"^from (?:what|which) {_N} (?:on|onwards|upwards) ,? ?(?={_AUX} )": r"for what least \g<n> ",
    rf"^what length (?P<a>{_AUX}) (?P<s>{_S}) {_HAVE}(?:have|be given|be put at) (?:at start|initially) {_NEXT}": (
        r"what initial length \g<a> \g<s> need "
    ),
    rf"^by (?:what|which) factor {_AUX} (?P<s>{_S}) {_HAVE}be (?:lengthened|made longer|extended) {_NEXT}": (
        r"by what factor must length of \g<s> be increased "
    ),
    rf"^how (?:fast|quickly) (?P<a>{_AUX}) (?P<b>blow|kick|push|hammer) {_HAVE}make (?P<s>{_S}) (?:move|go"
    rf"|travel|start|slide)(?: off)? {_NEXT}": (r"how fast \g<a> \g<b> have to send \g<s> "),
    rf"^how much (?:of its )?mass {_AUX} {_HAVE}be (?:taken away|removed|taken off|taken)(?: from| off| away"
    rf" from)? (?P<s>{_S}) {_NEXT}": (r"by how much must mass of \g<s> be reduced "),
    r" with (?:this|that|same|given) (?:engine|motor|string|pull|force|hand)$": "",
    rf"^how many times (?:stronger|more intense) (?={_AUX} )": "how many times larger ",
    rf"^if (?P<s>{_S}) (?:is|are|was|were) to make {_S} over (?P<t>top|highest point) , (?P<r>.+)$": (
        r"\g<r> for \g<s> to go over \g<t>"
    ),
    rf"^(?P<h>(?:with |at |by )?(?:what|how) [a-z ]*?)(?P<a>{_AUX}) (?P<s>{_S}) (?P<b>at (?:least|most)) (?=be "
    rf"|have |start|move|need)": (r"\g<b> \g<h>\g<a> \g<s> "),
    r"\b(?P<q>speed|velocity) at (?:its |very )?(?:bottom|lowest point) (?=(?:with|for|at) which .*\bround\b)": (
        r"\g<q> "
    ),
    rf"^what is escape (?:speed|velocity) (?:of (?P<s>{_S})(?: (?:at|from) (?:its )?(?:initial|starting|present)"
    rf" (?:position|distance|point|place))?"
    rf"|(?:at|from) (?P<s2>{_S}) 's (?:initial|starting|present) (?:position|distance|point|place))(?: from {_S})?$": (
        r"what least speed must \g<s>\g<s2> have to escape"
    ),
    r"\b(?P<q>speed|velocity) (?:given|imparted) by (?:blow|kick) (?=be|is|have)": r"\g<q> ",
    rf"^(?P<h>(?:with |at )?(?:what|which|how) .+? (?:have to |need to )?be) {_SET}(?P<c>(?: (?:up|down|off"
    rf"|along)(?: (?:{GROUNDS}))?)?)"
    rf"(?: (?:at|from) (?:its |very )?(?:bottom|lowest point)(?=.*(?:circle|round|over|top)))? {_NEXT}": (
        r"\g<h> launched\g<c> "
    ),
    rf"^(?:what|which) {_VALUE} {_AUX} {_N} (?:need to |have to |needs to |need )?(?:have|take|take on|assume|be)"
    rf"(?P<b> at (?:least|most))? {_NEXT}": r"what \g<n> is needed\g<b> ",
    rf"^(?:what|how large|how great|how big|how high) {_AUX} {_N} (?P<b>at (?:least|most)) {_HAVE}(?:be|amount"
    rf" to|equal|come to) {_NEXT}": (r"what \g<n> is needed \g<b> "),
    rf"^(?:what|how large|how great|how big|how high) {_AUX} {_N} {_HAVE}(?:amount to|come to)(?P<b> at (?:least"
    rf"|most))? {_NEXT}": (r"what \g<n> is needed\g<b> "),
    rf"^(?:what|which) {_N} {_AUX} (?P<b>at (?:least|most) )?{_HAVE}be (?:present|available|at work|there) {_NEXT}": (
        r"what \g<n> is needed \g<b>"
    ),
    rf"^what {_AUX} {_N} {_HAVE}{_TOPS}(?: at start)? {_NEXT}": r"what least \g<n> is needed ",
    rf"^what {_AUX} {_N} {_HAVE}{_STAYS}(?: at start)? {_NEXT}": r"what greatest \g<n> is needed ",
    rf"^(?:what|which) (?P<q>{_NOUNS}) {_AUX} {_OWNER} {_HAVE}{_TOPS} {_NEXT}": r"what least \g<q> is needed ",
    rf"^(?:what|which) (?P<q>{_NOUNS}) {_AUX} {_OWNER} {_HAVE}{_STAYS} {_NEXT}": r"what greatest \g<q> is needed ",
    rf"^(?:what|which) (?P<z>least |greatest |minimum |smallest )?(?P<q>{_NOUNS}) {_AUX} {_HAVE}be (?:given"
    rf"|imparted|lent) to (?P<s>{_S}) {_NEXT}": (r"what \g<z>\g<q> would \g<s> need "),
    rf"\b(?:what|how much) (?P<a>must|would|should|may|can|could) (?P<s>{_S}) (?:have to )?weigh(?: in (?:kg"
    rf"|kilograms))?"
    rf"(?P<b> at (?:least|most))? {_NEXT}": r"what mass \g<a> \g<s> have\g<b> ",
    rf"^how much mass (?P<a>must|would|should|may|can|could) (?P<s>{_S}) have": r"what mass \g<a> \g<s> have",
    rf"^how (?:small|large|great|big|little) (?:may|can|could|might) {_N} (?:become|get|be|be made) (?:before"
    rf"|until) (?P<s>{_S})"
    r" (?:no longer|not any more|ceases? to|stops?) (?P<c>.+)$": r"what \g<n> is needed for \g<s> to \g<c>",
    rf"^how (?P<how>small|large|great|big|little) (?:may|can|could|might) {_N} (?:become|get|be|be made)"
    rf" (?:before|until) (?P<c>.+)$": (r"what \g<n> is needed for \g<c>"),
    rf"^by what mass {_AUX} (?P<s>{_S}) {_HAVE}be (?:loaded|weighted|increased) {_NEXT}": r"by how much must"
    r" mass of \g<s> be greater ",
    rf"^what {_EXTRA} (?:load|mass) (?:on|for|in|of) (?P<s>{_S}) (?:would|must|will) (?:make|let|cause|give) ": (
        r"by how much must mass of \g<s> be greater for "
    ),
    rf"^(?:what|how much) (?:(?:is )?(?:least|smallest|minimum) )?{_EXTRA} (?P<q>{_NOUNS}) (?:that )?(?:{_AUX}"
    rf" (?P<s>{_S})|(?P<s2>{_S}) {_AUX}) (?:need|have|require)"
    rf"(?: to have)?(?: at start| initially)? {_NEXT}": r"by how much must \g<q> of \g<s>\g<s2> be greater ",
    rf"^(?:what|which) (?:is )?(?:least|smallest|minimum) force (?:that|with which hand|of hand that)"
    rf" (?:can |could |would |will )?(?P<c>(?:lift|raise|hoist|move|drag|start)s? {_S})$": (
        r"how hard must hand pull at least to \g<c>"
    ),
    r"\b(?:this |same )?(?:engine|hand|motor) (?:could|can|would)(?: just| still)? (?=lift|pull|haul|move|raise"
    r"|keep|hold|drag)": "would ",
    rf"^how fast (?P<a>{_AUX}) (?:exhaust )?gas(?:es)? {_HAVE}(?:leave|stream out|flow out|be blown out|shoot"
    rf" out|come out|rush out)"
    rf"(?: of (?:engine|nozzle|{_S}))? {_NEXT}": r"what exhaust speed is needed ",
    rf"^with (?P<w>what (?:fraction|share|part|percentage) of (?:its )?(?:vertical |normal )?(?:speed|velocity))"
    rf" (?P<a>{_AUX}) (?P<s>{_S})"
    rf" {_HAVE}(?:rebound|bounce|come off|jump up|leave ground)(?: off ground| from ground)? {_NEXT}": (
        r"\g<w> \g<a> \g<s> keep "
    ),
    rf"^(?:what|which) {_VALUE} {_AUX} {_N} {_HAVE}{_TOPS} {_NEXT}": r"what least \g<n> is needed ",
    rf"^(?:what|which) {_VALUE} {_AUX} {_N} {_HAVE}{_STAYS} {_NEXT}": r"what greatest \g<n> is needed ",
    rf"^(?:what|which) (?P<q>{_NOUNS}) {_AUX} (?P<s>{_S}) {_HAVE}{_TOPS} {_NEXT}": (
        r"what least \g<q> must \g<s> have "
    ),
    rf"^(?:what|which) (?P<q>{_NOUNS}) {_AUX} (?P<s>{_S}) {_HAVE}{_STAYS} {_NEXT}": (
        r"what greatest \g<q> must \g<s> have "
    ),
    rf"^(?:above|beyond|over|past) (?:what|which) (?:{_VALUE} )?(?:of )?{_N} ,? ?(?={_AUX} )": (
        r"for what least \g<n> "
    ),
    rf"^(?:below|under|up to) (?:what|which) (?:{_VALUE} )?(?:of )?{_N} ,? ?(?={_AUX} )": r"for what greatest \g<n> ",
    rf"^(?P<ask>.+?) ,? (?P<b>at (?:the )?(?:very )?(?:least|most)) , (?={_AUX} )": r"\g<ask> \g<b> ",
    rf" , (?P<b>at (?:very )?(?:least|most)) , {_NEXT}": r" \g<b> ",
    r" , (?P<b>at (?:very )?(?:least|most)) , ": r" \g<b> ",
    rf"(?: ,)? (?:with |and |for )?(?:(?:{_S} 's|its) )?(?:{_NOUNS}) (?:(?:stay|staying|remain|remaining|kept"
    rf"|held|left) )?"
    r"(?:as given|as stated|as before|as it is|as in text|as above)(?: ,)?": "",
    rf"\b(?P<f>for|with) (?P<l>least|greatest) {_LIMIT} ": r"\g<f> \g<l> ",
    r"\b(?P<a>would|will|could|can|must|should) (?:(?:still|just|barely|yet|even) )*be able to (?=[a-z])": r"\g<a> ",
    rf"\b(?P<a>would|must|should|does|did) (?P<b>blow|kick|push|hammer) (?P<h>have to |need to )?(?:give|impart"
    rf"|lend) to (?={_S})": (r"\g<a> \g<b> \g<h>give "),
    rf"\bvalue (?:of|for) (?={_NOUNS})": "",
    r"\b(?:cuts?|brings?) down\b": "lower",
}
"""By the pattern of a part of a question without articles, plainer words with the same meaning."""
