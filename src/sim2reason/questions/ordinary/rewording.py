"""Turns of phrase, also about how a motion begins and goes on, and their plainer equivalents."""

from collections.abc import Mapping

from sim2reason.questions.ordinary.clause_heads import HOME
from sim2reason.questions.ordinary.turns_of_amount import AMOUNT_TURNS
from sim2reason.questions.ordinary.turns_of_bodies import BODY_TURNS, PLACE_TURNS
from sim2reason.questions.ordinary.turns_of_motion import MOTION_TURNS
from sim2reason.questions.ordinary.turns_of_order import ORDER_TURNS
from sim2reason.questions.ordinary.turns_of_phrase import LATER_TURNS, PHRASE_REWORDINGS
from sim2reason.questions.ordinary.vocabulary import GROUNDS, pattern

_S = r"(?P<s>@\d+@)"
_DOES = "(?:does|do|did|will|is|are|has|have|had)"
_TIMED = (
    "(?:when|(?:at|after) what (?:time|moment|instant)|after how (?:long|many seconds|much time)|how long(?: is it)?"
    "(?: until| before)?|how soon)(?: after START)?(?: until| before)?"
)
_GOING = "(?:moving|turning|rolling|sliding|spinning|rotating|swinging|rising|falling|travelling|flying|climbing)"
_LET_GO = "(?:released|let go|set free|launched|thrown|set moving|set going|set in motion|freed|let loose)"
_MOVES = (
    "(?:move|fly|go|slide|travel|run|glide|roll|rebound|bounce|come|shoot|start|set)s?(?: (?:off|away|on|out|forward))?"
)
_STRUCK = "(?:hit|struck|knocked|pushed|collided with)"
_PASSIVE = f"(?:being|having been|(?:it|@0@) (?:has been|have been|is|was)|been) {_STRUCK}(?: by (?:@1@|it))?"
_BURNS = "(?:running|burning|firing|working|operating|on|at work|lit)"
_VANISH = "(?:becomes?|is|reaches|reach|falls? to|drops? to|equals?|vanish(?:es)?|be|gets?|get to)"
_AXIS = "(?P<axis>x|y)(?:-| )?(?:component)?"
_NO_RISE = "(?:fail|fails|failed)(?: for first time)? to (?:rise|reach|get|bounce|climb|jump|come|go)(?: up)?"
_HITS = (
    f"(?:lands?|hits?|strikes?|touch(?:es)?|bounces?|comes? down|reach(?:es)?|meets?)(?: (?:on |off )?(?:{GROUNDS}))?"
)

COURSE_TURNS: Mapping[str, str] = {
    "^(?P<b>(?!.*@1@).*?)@0@ 's (?=(?:own )?(?:starting|initial|original|first|launch) (?:point|position|place|level"
    "|height)\\b)": r"\g<b>its ",
    "\\babove (?:its |@0@ 's )?(?:own )?(?:starting|initial|original|launch) (?:level|height)\\b": (
        "above its starting point"
    ),
    "\\b(?:very )?first (?=collision|impact|bounce|landing)": "first ",
    "\\b(?:far|opposite) side\\b(?! of)": "other side",
    "\\b(?:fuel supply|supply of fuel|stock of fuel)\\b": "fuel",
    "^(?P<b>(?!.*@1@).*?)@0@ 's (?=(?:release|launch|throw|ignition|departure)\\b)": r"\g<b>",
    # how it begins
    f"^(?:with|at) what (?P<q>acceleration|speed|velocity) (?:does|do|will) {_S} (?:first )?(?:lift off|take off|lift"
    f"|rise|leave|come off)(?: from)? (?:{GROUNDS})(?: at first)?$": r"what is \g<q> of \g<s> at lift-off",
    "^how (?:much )?(?:later than|long after) (?:moment of )?START (?=(?:does|do|did|is|are|will|has|have) )": "when ",
    f"^(?P<ask>{_TIMED}) (?:does|do|did|will) (?P<n>(?:ORDINAL|last) )?(?P<w>impact|bounce|landing|rebound|collision)"
    "(?: of (?P<s>@\\d+@)(?: with ground)?)? (?:take place|happen|occur|come|follow)$": (r"how long until \g<n>\g<w>"),
    f"^(?:when|at what (?:time|moment|instant)) ,? ?(?:after|following|counted from|from) (?:its |their )?START ,? ?"
    f"(?={_DOES} )": "when ",
    f"\\b(?P<s>@\\d+@|everything|system|they|all) (?:has|have) been (?P<v>{_LET_GO})\\b": r"\g<s> is \g<v>",
    f"\\b(?P<v>(?:start|set|move|go|glide|slide)s? off) ?,? (?:when|once|as|after|as soon as|at moment when"
    f"|immediately after|just after) (?:START|(?:system|everything|@\\d+@|it|they) is {_LET_GO})$": r"\g<v>",
    "^(?:starting|beginning|counting|timed|timing|measuring|reckoning|clocked) (?:from|at|with) (?:moment of"
    " |instant of )?START ,? ?(?=\\w)": "",
    "^ASK time (?:that |which )?(?:passes|elapses|goes by|passing|elapsing|passed) (?:after|from|since|between)"
    " (?:moment of )?START (?:until|till|before|to|and) ": "how long until ",
    "(?P<n>#\\d+#) after (?P<s>@\\d+@) (?:sets|starts|goes|moves) (?:out|off)\\b": r"\g<n> after start",
    "\\b(?P<v>rest|stops?|halt|stand) again ,? ?(?=(?:on|at) (?:left|right|other|far|opposite))": r"\g<v> ",
    # how it goes on
    f"\\b(?:go|goes|keep|keeps|carry|carries|continue|continues) (?:on )?(?={_GOING}\\b)": "",
    f"^(?P<ask>(?:how far|what distance|through what distance|how high) {_DOES} @\\d+@ (?:\\w+ )?(?:\\w+ )?)(?:while|as"
    f" long as|during time that) (?:(?:its |@0@ 's )?(?:engine|engines|motor|fuel)) (?:is|are) (?:still )?{_BURNS}$": (
        r"\g<ask>until burnout"
    ),
    "\\b(?:engine|motor|fuel tank|tank|@\\d+@) (?:runs?|is|has run) dry\\b": "fuel runs out",
    "^(?P<q>(?:ASK|what|with what|at what|how (?:large|great|big|strong|hard)) .*?(?:QUANTITY|accelerate).*?) ?,?"
    " (?:as long as|so long as|while|during time that|provided that) (?:@\\d+@|strings?|both strings|all strings"
    "|both|they) (?:is|are|remains?|stays?|keeps?) (?:all |both |still )*(?:taut|tight|tense)$": r"\g<q>",
    "\\b(?:in|during|within|over) (?:same )?(?:time|interval|period) (?:in which|during which|while|that it takes)"
    " (?=@)": "by time ",
    "\\b(?:hand|force|pull|pulling force) (?:has |have |had )?(?:pulled|dragged|moved|drawn|hauled|displaced|towed)"
    " (?P<s>@\\d+@) (?=#|through|by|along|up|down)": r"\g<s> has moved ",
    # after an impact
    f"(?P<s>@0@) (?P<v>{_MOVES}) ?(?P<just>just |immediately |right |directly )?(?:after|when|once|as result of)"
    f" {_PASSIVE}$": r"\g<s> move just after @0@ 's first collision",
    f"^how much (?P<q>(?:kinetic )?energy|momentum) {_DOES} (?P<s>@0@) (?:hand(?: over)?|pass(?: on)?|transfer|give"
    f"|impart|yield|communicate|transmit) to (?P<t>@1@) (?P<in>in|by|during|through) (?P<what>(?:their |this )?"
    f"(?:ORDINAL )?(?:collision|impact))$": r"how much \g<q> does \g<t> gain \g<in> \g<what>",
    "\\b(?:points|places|spots) of (?:first two|first and second) (?P<w>impacts?|bounces?|landings?)\\b|\\bfirst two"
    " (?:points|places|spots) (?:of impact|of landing|where @0@ (?:lands|bounces|hits ground))\\b|\\bfirst two"
    " (?:impact|landing|bounce) (?:points|places|spots|marks)\\b": "first and second bounce",
    f"^how high (?P<does>does|will|do) {_S} (?P<v>rise|swing|climb|get|go|come|swing up)(?: up)? on (?:the )?other side"
    " above (?P<low>(?:its |@0@ 's )?lowest (?:point|position))$": r"how high above \g<low> \g<does> \g<s> rise",
    "^(?:with|at) what relative (?P<q>speed|velocity) (?:do|does|will) (?P<s>@\\d+@|they) (?:separate|part|fly apart"
    "|move apart|recede|approach|approach each other|move towards? each other|collide|meet)(?= |$)": (
        r"what is relative \g<q> of \g<s>"
    ),
    f"^(?:through|by) what angle {_DOES} (?:{_S} 's (?:path|course|direction(?: of motion| of travel)?|motion|velocity"
    "|trajectory)|(?:path|course|direction of motion|velocity) of (?P<t>@\\d+@)) (?:bent|turned|deflected|changed"
    "|rotated|diverted)(?: (?:in|by|through|during) (?:(?:its|their) )?(?P<what>collision|impact))$": (
        r"through what angle is \g<s>\g<t> deflected in collision"
    ),
    "^(?:ASK|what is) (?:SIZE )?change (?:of|in) (?:momentum of (?P<s>@\\d+@)|(?P<t>@\\d+@) 's momentum)(?= in| during"
    "| when| at| by|$)": r"how much momentum does \g<s>\g<t> exchange",
    # how long something becomes
    "^how long (?:does|do|will) (?P<s>@\\d+@) (?:become|get|grow)(?: to be)? at (?:most|its longest|longest)$": (
        r"what is longest length of \g<s>"
    ),
    "^how (?:long|short) (?:does|do|will) (?P<s>@\\d+@) (?:become|get|grow)(?: to be)? at (?:least|its shortest"
    "|shortest)$": r"what is shortest length of \g<s>",
    f"^(?:for )?how long (?:is|does|will|has) {_S} (?:be |stay |remain |been )?away(?: from {HOME})? ?,? ?(?:all told"
    "|in all|altogether|in total)?$": r"how long until \g<s> returns",
    " ?,? (?:all told|taken all together|taken altogether|all in all)(?=$| when| until| before| after| by)": " in all",
    # rounds
    "\\b(?:for |to make |to complete |to go on )?(?:one |single |each |every )+(?:full |whole |complete |entire )?(?:"
    "trip|journey|tour|lap|circuit|loop|passage|turn)(?: all(?: the)? way)? (?:about|around|round) @\\d+@": (
        "to complete one round"
    ),
    # what is again as it was, and what passes a value
    f"^(?P<ask>{_TIMED}) {_DOES} (?:{_AXIS} (?:of )?(?:velocity|speed) of {_S}|(?P<t>@\\d+@) 's (?P<other>x|y)(?:-"
    f"| )?(?:component of )?(?:velocity|speed)(?: component)?) (?:first )?(?:{_VANISH})(?: (?:zero|nothing))?"
    "(?: again)?(?: for first time)?$": r"when does \g<s>\g<t> stop moving in \g<axis>\g<other> direction",
    f"^(?P<ask>{_TIMED}) (?P<is>is|are|does|do|will) {_S} for first time (?=\\w)": r"\g<ask> \g<is> \g<s> ",
    f"^(?P<ask>{_TIMED}) (?:does|do|will) {_S} (?:first )?(?:pass|reach|get to|arrive at|go through|cross|come to)"
    "(?: through)? (?:point|place|position|spot) (?:where|at which) (?P<c>@\\d+@ .+)$": r"how long until \g<c>",
    "\\bneither (?:compressed|shortened) nor (?:stretched|extended|lengthened)\\b": "relaxed",
    f"^(?P<ask>how far|at what distance) ,? ?(?:measured |counted |reckoned )?(?P<w>horizontally|(?:along|on|over)"
    f" (?:{GROUNDS})) (?:from|away from) (?P<home>{HOME}|where (?:it|@0@) (?:was|is) \\w+|thrower) ,?"
    f" (?:does|will|is) (?P<s>@0@) {_HITS} (?:for )?(?P<n>ORDINAL) time$": (
        r"how far horizontally does \g<s> move when \g<s> lands for \g<n> time"
    ),
    f"^(?:after )?how many (?P<b>bounces|landings|impacts|hits|rebounds) (?:does|will) {_S} {_NO_RISE}"
    f" (?:as high as |to (?:a )?(?:height of )?|to )?(?P<n>#\\d+#)(?: (?:above|over|off) (?:{GROUNDS}))?$": (
        r"how many times does \g<s> bounce until \g<s> stays below \g<n>"
    ),
    f"^how far(?: away| off)? (?P<does>does|will|do) {_S} (?P<v>land|hit (?:{GROUNDS})|come down|strike (?:{GROUNDS})"
    f"|reach (?:{GROUNDS})) ?,? (?:measured |counted )?horizontally(?: from (?:{HOME}|thrower))?$": (
        r"how far horizontally \g<does> \g<s> land"
    ),
    "^how far (?:up )?(?=above (?:level )?(?:ground|floor)\\b)": "how high ",
    "^what is (?:farthest|furthest) (?P<p>point|place|position) (?P<s>@\\d+@) (?:gets|reaches|goes)"
    " from (?P<t>@\\d+@|far end|fixed point)$": r"how far from \g<t> does \g<s> get at most",
    "^(?:what is|find|determine) (?:farthest|furthest|most)(?: that)? (?P<s>@\\d+@) (?:gets|goes|moves|swings"
    "|strays)(?: away)? from (?P<t>far end|fixed point|@\\d+@|its starting point)$": (
        r"how far from \g<t> does \g<s> get at most"
    ),
    f"\\bradius of curvature of {_S} 's (?:path|trajectory|orbit|track)\\b": r"radius of curvature of \g<s>",
    f"^(?:at what|how great a|what) horizontal distance (?:away )?from (?:{HOME}|thrower|point of \\w+) (?:is|does)"
    f" {_S} (?:at its )?(?:highest(?: point)?|top)$": (
        r"how far horizontally does \g<s> move when \g<s> is at highest point"
    ),
    f"^(?:ASK|what) (?:is )?range of {_S} (?:up to|until|to|as far as) (?:its |@\\d+@ 's )?first (?:bounce|impact"
    "|landing)$": r"what is range of \g<s>",
    f"^what (?P<q>speed|velocity|angular velocity|angular speed) (?:does|will|do) {_S} (?:end up|finish|end|finish up)"
    " with$": r"what is final \g<q> of \g<s>",
    f"^how (?:often|many times) (?:per|a|in (?:one|a|each)|every|each) second (?:does|do|will) {_S} (?:go|move|run"
    "|swing|travel|slide|oscillate) (?:back and forth|to and fro|forth and back|there and back)$": (
        r"what is frequency of \g<s>"
    ),
    "\\b(?:in|at|through) (?:middle|centre|center|midpoint|mid-point) of (?:its |@\\d+@ 's )?(?:oscillations?"
    "|vibrations?)\\b": "at its equilibrium position",
    f"^(?:at|to) what (?:height|level) above (?:start|{HOME}) (?P<does>does|will) {_S} (?:turn (?:back|round|around)"
    "|stop|come to rest|reverse)$": r"how high above its starting point \g<does> \g<s> rise",
    "\\b(?P<v>dropped|fallen|sunk|descended|risen|climbed) (?:below|above) (?:its |@0@ 's )?"
    "(?:starting|initial|original) (?:height|level|position|point)\\b": r"\g<v>",
    "^how many (?:au|m|metres|meters|km|kilometres|cm|astronomical units) (?=(?:away )?from|apart|above)": "how far ",
    "^(?:with|at) what amplitude (?:does|do|will) (?P<s>@\\d+@) (?:oscillate|vibrate|swing|move)$": (
        r"what is amplitude of \g<s>"
    ),
    f"\\b(?:its |@0@ 's )?(?:next )?edge (?:lands|hits|strikes|touches)(?: (?:on )?(?:{GROUNDS}))? for (?P<n>ORDINAL)"
    " time\\b": r"\g<n> edge lands",
    # where it is
    "^where is (?P<s>@\\d+@) (?P<when>(?:when|at|after|just|as) .+?) ?(?::|;|,|\\.) (?P<q>how far .+)$": (
        r"\g<q> is \g<s> \g<when>"
    ),
    " ?,? (?:relative to|with respect to) (?:rail|track|floor|ground|table|laboratory|lab|earth) ,"
    " (?=(?:is|does|are|do|was|will) )": " ",
}
"""Plainer words, by the pattern of a part of a question without articles that has the same meaning."""


REWORDINGS: Mapping[str, str] = {
    "\\b(?:been|being|already) ": "",
    "^for how long ": "how long ",
    "^(?:after|within|over) what distance (?:does|do|will|is|are) (?P<s>@\\d+@) (?=\\w)": (
        r"how far does \g<s> move before \g<s> "
    ),
    "^(?:please|now|then),? ": "",
    "^(?:can|could|would) (?:you|we|one) ": "",
    "^(?:tell me|say|state|show|i want to know|i would like to know|we want to know|please find) (?=what|how|when)": "",
    "^(?:state|evaluate|estimate|deduce|get|write down|report|tell me|name) ": "find ",
    "^what (?:magnitude|size|value) (?:has|does) (?P<of>@\\d+@ 's QUANTITY|QUANTITY of @\\d+@) ?(?:have)?": (
        r"what is \g<of>"
    ),
    "(?<=\\bhow )(?:quickly|rapidly|swiftly)\\b": "fast",
    "(?<=\\bhow )(?:soon|long|much time|many (?:seconds|years)) after (?:@0@ 's |its |their )?(?:START|it) "
    "(?=is |are |do |does |will |has |have |did )": "long until ",
    "(?<=@ )(?:first|itself) (?!#|second|time|AUX)(?=[a-z])": "",
    "\\bupon ": "on ",
    "\\brelative to (?:ground|floor|table|laboratory|lab|rail|track|earth)\\b ?": "",
    "\\bfor one (?:full|complete|whole) ROUND(?: (?:about|around|round) @\\d+@)?": "to complete one round",
    "\\b(?:one|single) (?:full|complete|whole) (?P<round>ROUND)(?: (?:about|around|round) @\\d+@)?": r"one \g<round>",
    "(?<=\\bdoes )(?P<s>@\\d+@) (?:happen to|manage to|actually) ": r"\g<s> ",
    "^ASK (?:SIZE )?(?P<q>QUANTITY) (?:with|at) which ": r"with what \g<q> ",
    "^ASK rate (?:at|with) which (?=@)": "with what acceleration ",
    "^(?:with|at) what rate (?=(?:do|does|is|are|will) @\\d+@ (?:accelerat|speed|los))": "with what acceleration ",
    "\\b(?:at|by) (?:moment|instant|point|time)(?: in time)? (?:that|where|in which|at which|when) ": "at moment when ",
    "^(?:for )?how (?:many seconds|many years|much time) (?=(?:do|does|did|is|will) (?:@|engine|fuel))": "how long ",
    "^what (?P<q>QUANTITY) (?:does|do|will) (?P<s>@\\d+@) (?:finally|eventually|ultimately) (?:HAVE)$": (
        r"what is final \g<q> of \g<s>"
    ),
    "\\bby end of (?=first #)": "after ",
    "(?<= )next (?=cross)": "",
    "^(?P<when>when (?:do|does|will|is) @\\d+@) next ": r"\g<when> ",
    "(?<= )(?P<n>#\\d+#) (?:later|afterwards|after that|on)$": r"\g<n> after start",
    "\\b(?:leave|leaves|rebound from|bounce off|come off|rebound|rebounds|fly off)(?: SURFACE)? (?:just "
    "|immediately )?after (?:its |their"
    " )?(?P<number>ORDINAL) "
    "(?:bounce|impact|landing|rebound)": r"move just after \g<number> bounce",
    "(?P<s>@0@) (?P<verb>hit|hits|strike|strikes|touch|touches|meet|meets|reach|reaches|land on|lands on) @0@": (
        r"\g<s> \g<verb> ground"
    ),
    "^how long is (?P<s>@\\d+@) (?:MOTION )?on (?:its )?way (?P<way>up|down)$": r"how long does \g<s> keep moving"
    r" \g<way>",
    "^how many years (?=pass|elapse|go by)": "how many seconds ",
    "^how many seconds (?:go by) (?=before|until)": "how many seconds pass ",
    "\\b(?:leave|leaves|rebound from|rebounds from|bounce off|bounces off|fly off|come off) SURFACE after "
    "(?:hitting|striking|touching|landing on|bouncing off) (?:@0@|it|SURFACE) for (?P<number>ORDINAL) time": (
        r"move just after \g<number> bounce"
    ),
    "\\b(?:at end of|throughout|within|during) (?=first #)": "in ",
}
"""By what a part of a question is like, on text without articles: what says the same."""


_ALL_REWORDINGS: Mapping[str, str] = {
    **BODY_TURNS,
    **ORDER_TURNS,
    **COURSE_TURNS,
    **AMOUNT_TURNS,
    **PLACE_TURNS,
    **MOTION_TURNS,
    **PHRASE_REWORDINGS,
    **REWORDINGS,
    **LATER_TURNS,
}


def reword_question(text: str) -> str:
    """Return a question with its turns of phrase replaced by plainer equivalents."""
    for template, plain in _ALL_REWORDINGS.items():
        text = pattern(template).sub(plain, text)
    return text.strip()
