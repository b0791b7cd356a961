"""Further turns of phrase in questions for a number, with equivalents that the module `frames` matches."""

from collections.abc import Mapping

from sim2reason.questions.ordinary.vocabulary import GROUNDS

_S = r"@\d+@"
_AUX = "(?:would|must|should|could|will|does|can|has|might|may|did)"
_HAVE = "(?:have to |need to |has to |needs to )?"
_BE = "(?:be needed|be required|be|needed|required|necessary|have to be|need to be|has to be)"
_NEXT = "(?=for |so that |so as |so |if |to |in order |before |that )"
_NOW = "(?:initial|starting|present|original|same|first)"
_ROUND = r"(?=.*\b(?:round|over top|past top|full circle|complete circle|vertical circle|over highest point)\b)"
_CIRCLE = r"(?=.*\b(?:circle|circular)\b)"
_SENT = "(?:sent off|launched|started|thrown|set moving|set off|projected|set in motion|released)"
_BOUNCE = "(?:bounces?|lands?|rebounds?|hits?(?: ground)?|strikes?(?: ground)?|impacts?|landings?)"
_LOADED = "(?:loaded onto|loaded on|added to|put on|put onto|placed on|placed onto|attached to|fixed to|piled on)"
NEED_REWORDINGS: Mapping[str, str] = {
    r"^how [a-z]+ would [^,]+ (?:have to )?be , that is ,? (?=(?:with |for |at )?what )": "",
    rf"\b(?P<b>at (?:very )?least|at most) (?P<be>{_BE}) {_NEXT}": r"\g<be> \g<b> ",
    rf"\b(?P<v>have to (?:begin|start|be [a-z]+|pull|move|go)) at very least {_NEXT}": r"\g<v> at least ",
    rf"\bwould (?P<s>{_S}) have (?P<v>need|require)e?d\b": r"would \g<s> \g<v>",
    r"\bso as not to ": "to not ",
    rf"\b(?P<l>{_SENT}|start) (?:at|from) (?:its |circle 's )?(?:bottom|lowest point|lowest position) {_ROUND}": (
        r"\g<l> "
    ),
    r"\bright over (?=top|highest point)": "over ",
    rf"^for (?P<s>{_S}|system|everything) (?:ever |just )?to (?P<c>[^,]+) , (?P<rest>(?:with|at|from|under|what|which"
    r"|how|by) .+)$": r"\g<rest> for \g<s> to \g<c>",
    rf"\bfrom (?:which|what) angle (?P<a>{_AUX}) (?:one|we|you) {_HAVE}(?:let (?P<s>{_S}) go"
    rf"|release (?P<t>{_S}))(?= )": (r"from what angle \g<a> \g<s>\g<t> have to be released"),
    rf"^how small (?:could|can|may) (?P<n>[^,]+?) be without (?P<s>{_S}) (?P<v>\w+ing)\b": (
        r"what is least \g<n> for which \g<s> not \g<v>"
    ),
    r"\bhave to (?:grow|rise|increase|go up) (?=for |to |so )": "have to be increased ",
    rf"\bmake (?:it|{_S}) over (?=top|highest point)": "go over ",
    r"\bsent up (?=to |for |so )": "sent off ",
    r"(?<=have to be) at beginning (?=to |for )": " ",
    rf"\bin circle (?:whose|with) radius (?:equal to |equals |is |of )?(?:@\d+@ 's |its )?{_NOW} distance"
    r"(?: from @\d+@)?(?= |$)": "in circle",
    rf"\bin circle at (?:@\d+@ 's |its )?{_NOW} distance(?: from @\d+@)?(?= |$)": "in circle",
    r"\b(?:round|around|about) this (?=@)": "round ",
    rf" ,? ?(?:at right angles|perpendicular|perpendicularly) to (?:line (?:joining|from|between) @\d+@ (?:to|and|with)"
    rf" @\d+@|radius) ,?{_CIRCLE}": "",
    rf" at (?:@\d+@ 's |its |this |that )*{_NOW} distance(?: from @\d+@)?(?= ){_CIRCLE}": "",
    r" (?:here|on this (?:slope|plane|incline))$": "",
    rf"^what coefficient of friction {_AUX} (?:{GROUNDS}) (?:need|have to have|need to have)(?= )": (
        "what coefficient of friction is needed"
    ),
    r"(?<=have to be) at start (?=to |for )": " ",
    rf"\brate at which (?:engine|it|@\d+@) {_AUX} {_HAVE}(?:burn|consume|use) (?:its )?fuel (?=for |so |to |if )": (
        "burn rate that is needed "
    ),
    rf"^how fast {_AUX} (?:exhaust )?gas(?:es)? {_HAVE}be(?: moving)?(?P<b> at least)? {_NEXT}": (
        r"what exhaust speed is needed\g<b> "
    ),
    r"\bhow many times as strong (?=would|must|should)": "how many times as large ",
    rf"\b(?:through|by) what angle (?P<a>{_AUX}) (?P<s>{_S}) {_HAVE}be (?:drawn|pulled|swung|moved|displaced)"
    r" (?:aside|to (?:one )?side|out|to right|sideways)(?: before it is released| and released)?": (
        r"from what angle \g<a> \g<s> have to be released"
    ),
    r"\bso as (?=to )": "",
    rf"\bwhat speed relative to {_S} (?=would |must |should |does |is )": "what speed ",
    rf"\b(?P<how>how [a-z]+ |what (?:[a-z]+ )+?)(?P<a>{_AUX}) (?P<n>[^,]+?) (?P<be>have to be|be) if (?:(?:same|its"
    rf" same) [a-z ]+?|it|{_S}) were to ": r"\g<how>\g<a> \g<n> \g<be> to ",
    rf"\bwhat (?P<x>(?:[a-z]+ )*?)height above (?:{GROUNDS}|it|level ground) (?={_AUX} )": r"what \g<x>height ",
    rf"\bwhat (?:fraction|share|part|percentage) of (?:its )?(?:vertical |normal )?(?:speed|velocity) (?P<a>{_AUX})"
    rf" (?P<s>{_S}) {_HAVE}(?:keep|retain|be left with|rebound with)(?P<b> at (?:least|most))?"
    rf"(?: (?:when|each time|whenever|as) (?:it|{_S}) {_BOUNCE}"
    rf"| (?:at|in|on|after) (?:its |each |every |first )?{_BOUNCE}| in bouncing)?(?= )": (
        r"what coefficient of restitution \g<a> \g<s> need\g<b>"
    ),
    rf"\b(?P<l>{_SENT}) (?:(?:downwards?|upwards?|up) )?along (?:its|@\d+@ 's) (?:arc|path|circle) ?,? ?{_ROUND}": (
        r"\g<l> "
    ),
    rf"\bwhat (?:additional |extra |further )?mass (?P<a>{_AUX}) {_HAVE}be {_LOADED} (?P<s>{_S}) ": (
        r"by how much \g<a> mass of \g<s> be greater "
    ),
    r"\b(?:rate of burning|rate of consumption of) (?:its )?(?:fuel|propellant)\b": "burn rate",
    r"\b(?P<n>fuel consumption|consumption of fuel|fuel consumed|fuel burnt) per second\b": "burn rate",
    r"\bpull (?:from|by|exerted by) hand\b": "pull",
    rf"\bwhich hand (?:could|would|can|must|should|has to|would have to|might) (?:just )?(?:have to )?(?:pull"
    rf" (?:so as )?(?:to|for) )?(?=(?:keep|hold|prevent|stop|pull|draw|make|let|move|{_S}) )": "which ",
    rf" with (?:speed|velocity) (?:{_S}|it) (?:has|had)(?: (?:at start|now|initially|already|at first))?(?= |$)": "",
    rf"\bhow (?P<how>hard|strongly) (?P<a>{_AUX}) hand (?:have to )?pull ,? ?(?:if|in case) ": (
        r"how \g<how> \g<a> hand have to pull for "
    ),
}
"""By the pattern of a part of a question without articles, plainer words with the same meaning."""
_TO = "(?:to )?"
_MEAN = "(?:describe|go|move|travel|fly|run|circle|be carried)"
_ONCE = "(?:once|when|after|where|as soon as)"
_STOPPED = (
    rf"(?: {_ONCE} (?:it|{_S}) (?:has )?(?:stopped|stops|come to rest|comes to rest|come to stop)(?: moving| sliding)?"
    r"| after (?:it has )?(?:stopping|stopped|coming to rest|having stopped|having come to rest))"
)
_AFTER_IT = (
    r"(?: ,)? (?:after|by|in|following) (?:its |their |this |first |head-on )?(?:impact|collision|blow|meeting)(?: with"
    rf" {_S}| between {_S}| of {_S})?"
)
_STANDING = "(?:standing still|at rest|stationary|still|motionless|standing|without motion)"
HALTS = "be halted by collision"
TURNS_OF_CONDITIONS: Mapping[str, str] = {
    rf"^(?P<s>{_S}) {_TO}(?:be )?(?:left |remain |stay |come to be |be brought )?{_STANDING}{_AFTER_IT}$": (
        rf"\g<s> {HALTS}"
    ),
    rf"^(?P<s>{_S}) {_TO}(?:come to rest|stop|come to stop|be stopped|be brought to rest|stop dead)(?: dead)?"
    rf"{_AFTER_IT}$": rf"\g<s> {HALTS}",
    rf"^(?:collision|impact|meeting)(?: of {_S}| with {_S})? {_TO}(?:leave|leaves|bring|brings|stop|stops)"
    rf" (?P<s>{_S})(?: {_STANDING}| to rest| dead)?$": rf"\g<s> {HALTS}",
    r"\b(?:just |barely |only )?manages? to (?=[a-z])": "",
    r"(?P<n>#\d+#) ahead\b": r"\g<n> away",
    r"\bland for first time (?=#)": "land ",
    rf"^(?:{_S} )?{_TO}compress (?P<t>{_S}) (?:by )?(?:at most )?(?:by )?(?P<n>#\d+#)(?: at most| at maximum)?$": (
        r"greatest compression of \g<t> be \g<n>"
    ),
    r"^(?P<x>(?:@\d+@ )?(?:to )?(?:rise|climb|jump|bounce|come up|get)(?: up| back)* (?:to )?(?:only )?"
    r"(?:height of )?#\d+#) again$": r"\g<x> after first bounce",
    rf"^(?P<s>system|everything|all|they|it|{_S}) ?,? once (?:moving|sliding|started|in motion|it moves|they move)"
    rf"(?P<way> up| down)?(?: (?:{GROUNDS}))? ?,? (?:to )?(?:keep|keep on moving at|move on at|go on at|continue at)"
    r" (?:constant|steady|its|same)(?: constant)? (?:velocity|speed)(?: constant)?$": (
        r"\g<s> move\g<way> with constant speed"
    ),
    rf"^(?P<s>{_S}) {_TO}(?P<v>stay|remain|lie)(?: at rest| still| put)?(?: there)?{_STOPPED}$": (
        r"\g<s> stay at rest where it stop"
    ),
    rf"^(?:{_S} )?{_TO}{_MEAN}(?: (?:round|around|in|on|along|over))* (?:circle|circular path|path|circular orbit"
    rf"|orbit) of radius (?:of )?(?P<n>#\d+#)$": r"radius of path be \g<n>",
    rf"^(?P<s>{_S}) {_TO}(?:move|slide|go|accelerate|start|travel)(?: off)? (?P<way>up|down)(?:wards)?"
    rf"(?: (?P<on>{GROUNDS}))? (?:with|at) (?:acceleration of )?(?P<n>#\d+#)$": r"\g<s> accelerate \g<way> at \g<n>",
    rf"^(?P<s>system|everything|all|they|it|{_S}) {_TO}(?P<v>move|go|slide) (?P<how>(?:with|at) constant (?:velocity"
    rf"|speed)) (?P<way>up|down)(?:wards)?(?: (?:{GROUNDS}))?$": r"\g<s> \g<v> \g<way> \g<how>",
    rf"^(?P<s>{_S}) {_TO}(?:rise|climb)(?: exactly| just)? (?P<n>#\d+#) (?P<way>along|up) (?P<on>{GROUNDS})$": (
        r"\g<s> move \g<n> up \g<on>"
    ),
    rf"^(?:bring|leave|put) (?P<s>{_S}) (?:{_STANDING}|to rest|to standstill){_AFTER_IT}$": rf"\g<s> {HALTS}",
    rf"^(?P<s>{_S}) (?:to )?not (?:to )?(?:slide|slip|move|come|go) (?:back|down)(?: down| again)*{_STOPPED}$": (
        r"\g<s> stay at rest where it stop"
    ),
    r"^(?:its |@\d+@ 's )?slipping (?:to )?(?:come to end|end|stop|cease)(?: (?:at some time|ever|some time|"
    r"eventually|sooner or later))?$": "it stop slipping",
    rf"^(?P<s>{_S}) {_TO}(?:end up|finish up|finally be|be in end)(?: moving| travelling| going)? (?:at|with)"
    r"(?: speed of)? (?P<n>#\d+#)$": r"\g<s> reach final speed of \g<n>",
    r" after first one$": " after first bounce",
    rf"^{_S} tension (?=at |in )": "tension ",
    rf"^(?:get|lift|raise|bring) (?P<s>{_S}) off (?:{GROUNDS})(?P<rest>.*)$": r"\g<s> lift off\g<rest>",
    r"\b(?:come|get|go|jump) (?:back )?up (?:again )?to (?=#)": "rise to ",
    rf"(?<=#) (?:before|until) (?:it|{_S}) (?:first )?lands$": "",
    rf"^limit (?P<q>compression|extension|stretch|length) of (?P<t>{_S}) to (?:at most )?(?P<n>#\d+#)$": (
        r"greatest \g<q> of \g<t> be \g<n>"
    ),
    r" before turning back$": " before it turns back",
    rf"^(?P<s>{_S}) {_TO}(?:need|take)s? (?P<n>#\d+#) for (?:one|each|every|full|one full) (?:revolution|turn|round"
    r"|circle)$": r"period be \g<n>",
    rf"^keep (?P<s>{_S}) at (?:its|{_S} 's) initial (?P<a>angle|inclination)": r"\g<s> keep its initial \g<a>",
    rf"^(?:its|{_S} 's) (?:orbit|path) {_TO}be circle(?: through (?:its |@\d+@ 's )?(?:initial|starting) (?:position"
    r"|point))?$": "orbit be circular",
    r"\b(?:first )?(?:hits?|strikes?|reach(?:es)?) (?:level )?ground(?: for first time)?"
    r" (?=#\d+# (?:away|from))": "land ",
    r"^(?:give|gives|given) (?:oscillations?|motion|vibrations?) (?=(?:amplitude|period|frequency) of )": "give ",
    r"^same (?:[a-z]+ ){1,3}to (?=(?:compress|stretch|squeeze) @)": "",
    r"\bgo round its circle once in (?=#)": "go round once in ",
    rf"^(?P<s>{_S}) {_TO}swing (?:out )?(?:up )?to (?:angle of )?(?P<n>#\d+#)$": (
        r"\g<s> swing out to \g<n> from vertical"
    ),
    rf"^(?:{_S}|string) (?:to )?pulls? (?P<at>at bottom |at lowest point )?(?:on {_S} )?"
    r"(?P<b>at bottom |at lowest point )?with (?:force of )?(?P<n>#\d+#)$": r"tension \g<at>\g<b>be \g<n>",
    rf"^(?P<s>{_S}) {_TO}(?:swing|go|get) right over (?P<t>top|highest point)$": r"\g<s> go over \g<t>",
}
"""By the pattern of a part of a condition without articles, plainer words with the same meaning."""
