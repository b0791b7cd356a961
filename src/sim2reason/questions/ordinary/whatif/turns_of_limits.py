"""Turns of phrase in questions for a limiting number, such as *what mass must B exceed*, in plainer words."""

from collections.abc import Mapping

from sim2reason.questions.ordinary.vocabulary import GROUNDS
from sim2reason.questions.ordinary.whatif.numbers import NUMBERS

_S = r"@\d+@"
_NOUNS = "|".join(kind.nouns for name, kind in NUMBERS.items() if name != "motion at start")
_N = (
    rf"(?P<n>(?:{_S} 's |its )?(?:{_NOUNS})(?: (?:of|on|for) (?:{_S}|{GROUNDS})| between {_S} and (?:its )?(?:{_S}|{GROUNDS}))?)"
)
_AUX = "(?:would|must|should|could|will|does|can|has|might|may|did|is|needs)"
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
LIMIT_TURNS: Mapping[str, str] = {
    rf"^(?:what|which) {_VALUE} {_AUX} {_N} {_HAVE}{_TOPS} {_NEXT}": r"what least \g<n> is needed ",
    rf"^(?:what|which) {_VALUE} {_AUX} {_N} {_HAVE}{_STAYS} {_NEXT}": r"what greatest \g<n> is needed ",
    rf"^(?:what|which) (?P<q>{_NOUNS}) {_AUX} (?P<s>{_S}) {_HAVE}{_TOPS} {_NEXT}": (
        r"what least \g<q> of \g<s> is needed "
    ),
    rf"^(?:what|which) (?P<q>{_NOUNS}) {_AUX} (?P<s>{_S}) {_HAVE}{_STAYS} {_NEXT}": (
        r"what greatest \g<q> of \g<s> is needed "
    ),
    rf"^(?:above|beyond|over|past|from) (?:what|which) (?:{_VALUE} )?(?:of )?{_N} ,? ?(?={_AUX} )": r"for what least \g<n> ",
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
    rf"^(?:{_MAKES} |for )?{_ROLLING}(?: (?:to )?(?:be |is |remain |remains |become )?(?:still |at all |just )*(?:possible|maintained"
    r"|kept up|sustained|able to (?:occur|happen|take place)|occur|happen|take place))?$": r"\g<s> roll without slipping",
    rf"^(?:{_S} )?(?:(?:still|just|barely|even) )*(?:be )?(?:(?:able|enough|sufficient) to )?(?:start|set|get|send|begin)s? (?P<t>{_S})"
    rf" (?:sliding|moving|going|climbing|travelling|on its way|off)(?P<way> up(?:wards)?)?(?P<on> (?:{GROUNDS}))?$": (
        r"\g<t> begin to move\g<way>\g<on>"
    ),
    rf"^(?P<t>{_S}) (?:to )?(?:just )?(?:be |get |gets |is )(?:drawn|pulled|hauled|dragged|carried|moved|lifted|raised|set moving|set going"
    rf"|towed)(?P<way> up(?:wards)?| uphill)(?P<on> (?:{GROUNDS}))?$": r"\g<t> begin to move\g<way>\g<on>",
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
