"""Turns of phrase about amounts, signs, units and numbers of events, with plainer equivalents."""

from collections.abc import Mapping

from sim2reason.questions.ordinary.vocabulary import GROUNDS

_DOES = "(?:does|do|did|will|is|are|has|have|had|must|can)"
_UNITS = (
    "(?:kilometres|kilometers|km|centimetres|centimeters|cm|millimetres|mm|metres|meters|m|kilograms|kg|newtons|n"
    "|joules|j"
    "|seconds|s|years|minutes|degrees|radians|m/s|km/s|rad/s|metres per second|watts|w|astronomical units|au)"
)
_MOMENT = "(?:when|by time|by moment|at|after|before|until|just|as|once|during|in first|while)"
_RISE = "(?:rise|rises|reach|reaches|get|gets|bounce|bounces|jump|jumps|go|goes|come|comes|climb|climbs|fly|flies)"
_NO_MORE = f"(?:(?:does|will|can) )?(?:no longer|not|never) {_RISE}(?: up)?(?: (?:again|any more))?"
_AS_HIGH = "(?:as high as|(?:to )?(?:a )?height of|above|over|higher than|more than|to)"
_HITS = f"(?:bounce|bounces|bounced|hit|hits|strike|struck|touch|touched|landed|land)(?: (?:on |off )?(?:{GROUNDS}))?"
_RIGHT = "(?:rightwards?|right|to right|direction to right|motion to right|velocities to right|positive x direction)"
_UPWARD = "(?:upwards?|up|upward direction|motion upwards?)"
_EDGE = "(?:(?:next|following|new|front|neighbouring|adjacent|lower|that|this|leading) )?(?:edge|face)"
_LANDS = (
    f"(?:strikes?|hits?|lands?(?: on)?|touches|touch|reaches|meets|comes down(?: on)?|falls? on|comes to lie on)"
    f"(?: (?:{GROUNDS}))?"
)

AMOUNT_TURNS: Mapping[str, str] = {
    "(?<!^how long is @\\d@)(?<!stay)(?<!remain)(?<!set)(?<!put) (?:during|in|over|throughout)(?: its| @0@ 's|)"
    " (?:(?:subsequent|whole|entire|ensuing|resulting) )?"
    "(?:motion|oscillation|flight|slide|run|journey)(?: that follows)?$": "",
    "\\blinear (?=(?:acceleration|speed|velocity|momentum)\\b)": "",
    "\\b(?:common|joint) (?P<c>cent(?:re|er) of (?:mass|gravity))": r"\g<c>",
    "\\bcompressed (?:the )?most\\b(?! of)": "most compressed",
    "\\bstretched (?:the )?most\\b(?! of)": "most stretched",
    f" ?,? (?:expressed |measured )?in {_UNITS}(?= {_MOMENT}\\b)": "",
    "^by how many (?:j|joules) (?=has|does|is|will|did)": "by how much ",
    " ?,? (?:in|at)(?: very)? end(?: ,)? (?=when|after|once)": " ",
    "^(?P<ask>ASK|what) (?P<q>LEAST) length [that ]~(?P<s>@\\d+@) (?:has|have|reaches|attains|gets|takes)$": (
        r"what is shortest length of \g<s>"
    ),
    "^(?P<ask>ASK|what) (?P<q>GREATEST) length [that ]~(?P<s>@\\d+@) (?:has|have|reaches|attains|gets|takes)$": (
        r"what is longest length of \g<s>"
    ),
    "^ASK (?P<q>GREATEST) length of (?=@)": "what is longest length of ",
    "^how long does (?:hand|pull) take to (?:pull|drag|move|draw|haul|shift|raise|lift) (?P<s>@\\d+@) (?=#|through"
    "|by)": (r"how long does \g<s> take to move "),
    "^how (?P<long>long|much time) does it take (?:hand )?to (?:pull|drag|move|draw|haul|shift|raise|lift|hoist)"
    " (?P<s>@\\d+@) (?:up )?(?=#|through|by)": r"how \g<long> does \g<s> take to move ",
    "(?<=^how much work )(?P<does>does|has|did|will) (?P<who>hand|pull) (?P<do>do|done) (?:in|by|on|for|when|while)"
    " (?:pulling|dragging|moving|drawing|hauling|shifting|raising|lifting|hoisting) (?P<s>@\\d+@) (?:up )?"
    "(?:by |through )?(?=#)": r"\g<does> \g<who> \g<do> while \g<s> moves ",
    "^by how much (?:has|does|did|will) friction (?:reduced?|lowered|lower|diminish|diminished|decreased?)"
    " (?:mechanical|total) energy\\b": "how much energy is lost to friction",
    "^(?P<s>@\\d+@) (?:\\w+ )*?(?:to|at|in|into) (?:point|place|spot) (?:where|at which) (?:it|@\\d+@)"
    " (?P<clause>(?:\\w+ ?)+)\\. how far is (?:this|that) (?:point|place|spot) from (?P<home>HOME)$": (
        r"how far is \g<s> from \g<home> when \g<s> \g<clause>"
    ),
    "^(?:ASK|what) GREATEST angle (?:[that ]~(?P<s>@\\d+@) ~makes? with|of (?P<t>@\\d+@) with|between"
    " (?P<u>@\\d+@) and)"
    " [downward ]vertical on (?:other|far|opposite) side$": (
        r"what angle does \g<s>\g<t>\g<u> make with vertical when \g<s>\g<t>\g<u> comes to rest on other side"
    ),
    "^how much time (?:passes|elapses|goes by|passed) after START (?:until|till|before|to moment when) ": (
        "how much time passes until "
    ),
    "(?P<s>@\\d+@) (?P<is>[first |again ][is |are ]MOTION) (?P<way>up|down)(?:wards?|hill)?[ SURFACE] (?:at|with) "
    "[speed of ](?P<n>#\\d+#)$": (r"\g<s> \g<is> at \g<n> on its way \g<way>"),
    "(?P<ask>(?:GREATEST|LEAST) QUANTITY (?:of|in|that|which)? ?@\\d+@(?: (?:has|reaches|attains|gets))?)"
    " (?:anywhere |at any"
    " (?:point|time|place) )?(?:on|in|during|along) (?:its |@\\d+@ 's )?(?:way|orbit|path|trajectory|whole motion"
    "|motion|flight"
    "|circuit|round)$": r"\g<ask>",
    "\\b(?:pick|picks|gain|gains) (?:up )?speed\\b(?! of)": "accelerate",
    "^(?:at|for|with) (?:what|which) (?P<q>QUANTITY) (?:of|in) (?P<t>@\\d+@) (?P<is>is|are) (?P<s>@\\d+@)"
    " (?P<rest>\\w+)$": (r"what is \g<q> of \g<t> when \g<s> \g<is> \g<rest>"),
    "\\b(?:between|from) START (?:and|to|until) (?:moment|instant|time)(?: (?:when|at which|in which))? ": "until ",
    "\\bdo (?=engines\\b)": "does ",
    "\\b(?P<e>engine|motor)s\\b": r"\g<e>",
    "(?P<is>^(?:by )?how (?:much|far|strongly) )(?:does|do) (?P<s>@\\d+@) (?:get|become) (?P<how>compressed"
    "|stretched)": (r"\g<is>is \g<s> \g<how>"),
    "\\b(?:turn|turns|turned) (?:back|round|around) in (?P<axis>x|y)(?:-| )direction": r"stops moving in \g<axis>"
    " direction",
    "^(?:with|at) (?:what|which) (?:steady|constant|uniform|terminal|final) (?P<q>speed|velocity) (?P<does>does"
    "|will) (?P<s>@\\d+@)"
    " (?:drift|move|travel|fly|go|fall|sink)(?: on)? (?:in end|finally|eventually|after long time|in long run"
    "|ultimately)$": (r"what is \g<q> of \g<s> after long time"),
    "^(?:with|at) (?:what|which) tension (?:does|do|is) (?P<s>@\\d+@) (?:hold|support|carry|pull|holding"
    "|supporting) (?:on |at )?"
    "(?P<t>@\\d+@)": r"what is tension in \g<s>",
    "^at (?:what|which) rate (?:does|do|is) angular (?P<q>velocity|speed) of (?P<s>@\\d+@) (?:grow|increase|rise"
    "|change|growing"
    "|increasing|rising|changing)(?P<at> (?:at first|initially|at (?:beginning|start|outset)))?$": (
        r"what is angular acceleration of \g<s>\g<at>"
    ),
    "^(?P<ask>through what angle (?:does|will) @\\d+@) (?:swing|move|turn) (?:out )?(?:to|toward|towards) (?:one "
    "|left |right )?side\\b": (r"\g<ask> turn"),
    "(?: ,)? (?:while|as long as) hand (?:keeps(?: on)?|goes on|continues|is)(?: to)? (?:pulling|pull)$": "",
    "\\b(?P<w>once|before|until|till) (?P<s>@\\d+@) (?:rolls|is rolling)(?: purely)?$": (
        r"\g<w> \g<s> rolls without slipping"
    ),
    "^how far (?P<does>does|will|did) (?P<s>@\\d+@) (?:skid|slip)$": (
        r"how far \g<does> \g<s> move before \g<s> rolls without slipping"
    ),
    "\\bfirst two (?=landing|bounce|impact|collision)": "first and second ",
    "^(?:what|how large an|how great an|which) area (?:does|will|is) line (?:from|between|joining|connecting)"
    " (?P<s>@\\d+@)"
    " (?:to|and|with) (?P<t>@\\d+@) (?:sweep|sweeps|swept)(?: out| over)?(?= |$)": r"what area does \g<s> and"
    r" \g<t> sweep",
    "^how high (?P<aux>has|have|had|is) (?P<s>@\\d+@) (?:risen|raised|lifted|climbed|gone up|moved up)(?= when|"
    " after| by| at| once)": (r"how far vertically above its start is \g<s>"),
    "(?P<q>angular (?:acceleration|velocity|speed) of @\\d+@) (?:about|around|round) (?:its )?(?:own )?(?:axis"
    "|centre|center|axle)"
    "(?: of mass)?\\b": r"\g<q>",
    "(?P<q>(?:force of friction|friction force|frictional force)) (?:required|needed|necessary) for (?:pure )?rolling"
    "(?: without slipping)?$": r"\g<q>",
    "^what is (?:farthest|furthest|greatest distance) (?:that )?(?P<s>@\\d+@) ~(?:gets|goes|moves|travels|reaches"
    "|swings)(?: away)?"
    " from (?P<t>@\\d+@|far end|HOME)": r"how far from \g<t> does \g<s> get at most",
    "\\b(?P<take>take|need|require) (?:on|for|in) (?:its )?way (?:up|down) to (?=lowest|highest|bottom|top)": (
        r"\g<take> to reach "
    ),
    "\\bradius of (?P<s>@\\d+@) 's (?:circular )?(?:path|circle|orbit|trajectory|track)\\b": r"radius of path of \g<s>",
    "^how long is (?P<s>@\\d+@) 's (?:whole |total |entire |complete )*(?:path|track|trajectory|way) (?P<end>until"
    "|till|before) ": (r"how far altogether does \g<s> move \g<end> "),
    "^how much (?P<q>(?:kinetic |elastic )?energy) (?:remains|is left|is still there|is there still)(?= after|"
    " when| at| once)": (r"what is \g<q>"),
    "\\benergy (?:left|remaining|still stored|that remains|that is left) in (?=@)": "energy stored in ",
    "\\b(?:total|resultant|net|overall|actual) (?=speed\\b)": "",
    "\\bbefore any (?:of )?collisions?\\b": "before first collision",
    "^how far (?:does|will) (?P<s>@\\d+@) (?:swing|move|oscillate|go|vibrate)(?: out)? to (?:each|either) side$": (
        r"what is amplitude of \g<s>"
    ),
    "(?<! of )(?P<s>@\\d+@) ~(?:(?:at |)|reaches |gets to |arrives at |passes )(?:its )?(?:point|position|place"
    "|moment) of"
    " (?P<most>GREATEST)"
    " (?P<what>compression|extension)": r"\g<most> \g<what>",
    "^how much momentum (?P<does>does|did|will) (?P<s>@\\d+@) (?:pass on|give|transfer|hand over|impart|pass|lose)"
    " to (?=@)": (r"what impulse \g<does> \g<s> give "),
    # signs
    f"\\. (?:take|count|regard|consider|let|reckon) {_RIGHT} (?:as|be|to be|count as) positive$": "",
    f"\\. (?:take|count|regard|consider|let|reckon) {_UPWARD} (?:as|be|to be|count as) positive$": (
        " , taking upwards as positive"
    ),
    # periods
    "\\b(?P<p>period|frequency|angular frequency) (?:with|at|of|in) which (?P<s>@\\d+@) (?:oscillates?|vibrates?"
    "|swings?|moves?"
    "|turns?|revolves?|goes round|go round)(?: to and fro| back and forth)?": r"\g<p> of \g<s>",
    # parts of a string
    "(?P<t>\\b(?:tension|force) (?:of|in) @\\d+@)(?: ,)? (?:(?:that|which) is )?(?:just |directly |right"
    " )?(?:above|over|below"
    "|beside|next to) @\\d+@(?=$| ,| when| while| at| just| after)": r"\g<t>",
    # numbers of bounces
    f"^(?:after )?how (?:many times|often) (?:{_DOES} )?(?P<s>@\\d+@) (?:have (?:to )?)?(?:{_HITS}) (?:until|till"
    f"|before|so that)"
    f" (?:@\\d+@|it) {_NO_MORE} {_AS_HIGH} (?P<n>#\\d+#)(?: (?:above|over|off) (?:{GROUNDS}))?$": (
        r"how many times does \g<s> bounce until \g<s> stays below \g<n>"
    ),
    f"^after how many (?:bounces|landings|impacts|hits|rebounds) {_DOES} (?P<s>@\\d+@) (?:no longer|not|never) {_RISE}"
    f"(?: up)?(?: (?:again|any more))? {_AS_HIGH} (?P<n>#\\d+#)(?: (?:above|over|off) (?:{GROUNDS}))?(?: any more|"
    f" again)?$": (r"how many times does \g<s> bounce until \g<s> stays below \g<n>"),
    f"^after how many (?:bounces|landings|impacts|hits|rebounds) {_DOES} (?P<s>@\\d+@) (?:always |finally"
    f" )?(?:stay|remain)"
    f" (?:below|under|lower than) (?P<n>#\\d+#)(?: (?:above|over|off) (?:{GROUNDS}))?$": (
        r"how many times does \g<s> bounce until \g<s> stays below \g<n>"
    ),
    f"^(?:after )?how many (?:bounces|landings|impacts|hits|rebounds) (?:{_DOES} (?:it )?(?:take|need|there)|are"
    f" there|are"
    f" needed) (?:until|till|before) (?P<s>@\\d+@) {_NO_MORE} {_AS_HIGH} (?P<n>#\\d+#)(?: (?:above|over|off)"
    f" (?:{GROUNDS}))?$": (r"how many times does \g<s> bounce until \g<s> stays below \g<n>"),
    # edges that land
    f"\\b(?:its |@\\d+@ 's )?(?:(?P<number>ORDINAL) )?{_EDGE} {_LANDS}(?: for first time)?(?= ,|$)": r"\g<number>"
    " edge lands",
    f"\\b(?P<s>@\\d+@) (?:first )?(?:lands|falls|comes down|drops) on (?:its )?{_EDGE}(?= ,|$)": "edge lands",
    f"\\b(?:impact|landing) of (?:its )?(?:(?P<number>ORDINAL) )?{_EDGE}(?: (?:on|with|against) (?:{GROUNDS}))?(?="
    f" ,|$)": (r"\g<number> edge lands"),
    # collisions of all
    f"^how much (?:kinetic |mechanical )?energy {_DOES} (?:@\\d+@ )?(?:lose|lost|dissipate|dissipated)(?: (?:in"
    f" all|in total"
    f"|altogether|together))? (?:when|once|after|by time|by moment|by time that|until) (?:all|every one of) (?:of )?"
    f"(?:their )?collisions (?:are|is|have been|have taken place|have happened|is)? ?(?:over|finished|done)?$": (
        "how much energy is lost in all collisions"
    ),
    "\\b(?:any )?two of @\\d+@ (?:touch|collide|meet|hit each other|come into contact)(?: for first time)?$": (
        "first collision takes place"
    ),
    "\\bboth (?P<go>move|moving|have|travel) (?=(?:with|at) (?:same|common|equal) |same )": r"they \g<go> ",
    "\\bneither (?:stretched|extended) nor (?:compressed|shortened)\\b": "relaxed",
    "\\bat (?:moments|instants|times|points) (?P<w>when|where|at which|in which)\\b": "at moment when",
}
"""Plainer words, by the pattern of a part of a question without articles that has the same meaning."""
