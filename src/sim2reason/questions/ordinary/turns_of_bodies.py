"""Turns of phrase about pairs of bodies, circles, marks, sides and heights, with plainer equivalents."""

from collections.abc import Mapping

from sim2reason.questions.ordinary.clause_heads import HOME
from sim2reason.questions.ordinary.vocabulary import GROUNDS

_S = r"(?P<s>@\d+@)"
_DOES = "(?:does|do|did|will)"
_TOGETHER = "(?: (?:together|taken together|combined|added together|in all|in total))?"
_LANDS = (
    "(?:lands|hits|strikes|touches|bounces(?: off)?|comes down|reaches|meets|impacts)(?: on)?"
    f"(?: (?:{GROUNDS}))?(?: for)?"
)
_SLIDE = "(?:slide|run|trip|pass|swing|journey|slip|roll|stretch|passage|sweep|stroke|move)"

BODY_TURNS: Mapping[str, str] = {
    # the origin of the axes
    f"\\bdistance (?:of|between) {_S} (?:from|and|to) origin(?: of (?:axes|coordinates|x-y plane))?\\b": (
        r"distance from origin of \g<s>"
    ),
    "\\borigin of (?:axes|coordinates|x-y plane|coordinate system)\\b": "origin",
    f"\\b{_S} 's distance (?:from|to) origin\\b": r"distance from origin of \g<s>",
    f"^how (?:close|near) (?:to origin {_DOES} {_S} (?:come|get|pass|approach)|{_DOES} (?P<t>@\\d+@) (?:come|get|pass"
    "|approach) to origin)(?: at (?:its )?(?:closest|nearest))?": r"what is least distance from origin of \g<s>\g<t>",
    f"^how far(?: away)? from origin {_DOES} {_S} (?:get|go|come|move|travel|stray)(?: at (?:most|its farthest))?$": (
        r"what is greatest distance from origin of \g<s>"
    ),
    # values, ways and moments
    f"^(?P<ask>ASK) (?P<most>GREATEST|LEAST) value (?:(?:that|which) )?(?:{_S} 's (?P<q>QUANTITY)|(?P<r>QUANTITY) of"
    " (?P<t>@\\d+@)) (?:takes|has|reaches|attains|assumes)(?: on)?(?= |$)": (
        r"\g<ask> \g<most> \g<q>\g<r> of \g<s>\g<t>"
    ),
    "\\b(?P<most>GREATEST|LEAST) value of (?P<q>QUANTITY) of (?=@)": r"\g<most> \g<q> of ",
    "\\b(?P<q>acceleration|speed|velocity) of axle of (?=@\\d+@(?:$| ,| when| while| at| after| just| in))": (
        r"\g<q> of "
    ),
    f"^where(?: (?:on|along|at) (?:{GROUNDS}|x axis))? (?:does|do|will|is) (?P<when>{_S} .+)\\. (?:give|find|state"
    "|calculate|determine|quote) (?:its |@\\d+@ 's )?(?P<axis>x|y)(?: (?:coordinate|position|value))?(?: there)?$": (
        r"what is \g<axis> coordinate of \g<s> when \g<when>"
    ),
    f"^(?:at|in) (?:what|which) (?P<axis>x|y)(?: (?:coordinate|position|value))? (?:does|do|is|are) {_S} ?(?:lie |stand"
    " |be |located |situated )*(?P<when>(?:when|at|after|once|as|just) .+)$": (
        r"what is \g<axis> coordinate of \g<s> \g<when>"
    ),
    "\\b(?:by|in|through) (?:colliding|their collision|hitting each other)$": "in collision",
    f"^(?:what|how (?:large|great|big) an?|ASK) friction(?: force)? (?:(?:that|which) )?(?:keeps|prevents|stops"
    "|hinders)"
    f" {_S} (?:from )?(?:slipping|sliding|skidding)(?P<rest>$| .+)": r"what is friction force on \g<s>\g<rest>",
    "^how long does (?:swing|movement|motion|trip|journey|way|passage) from one (?:side|end|turning point|extreme) to"
    " (?:other|opposite)(?: (?:side|end|one))? take$": "how long until it stops on other side",
    f"^how far (?P<does>{_DOES}) {_S} (?P<v>descend|sink|fall|go down|drop|rise|climb|go up|move up|move down) at"
    r" most$": r"how far \g<does> \g<s> \g<v> before \g<s> stops",
    "^what is (?P<size>longest|shortest) (?:that )?(?P<s>@\\d+@) (?:gets|becomes|is|grows|ever gets|ever becomes)$": (
        r"what is \g<size> length of \g<s>"
    ),
    f"^(?:does|do|will) (?P<c>{_S} .+)\\. if (?:so|yes) ,? ?(?P<ask>when|after how long|after what time|at what"
    " time)(?: (?:does|is|will) (?:this|that|it) (?:happen|occur|so))?$": r"how long until \g<c>",
    " ,? if (?:it|@\\d+@|they) (?:moves?|slides?|accelerates?) at all$": "",
    "\\b(?:rise or fall|fall or rise|go up or down|climb or sink|sink or rise|rise or sink)\\b": "move",
    "^(?P<a>how far(?: away)? |how far (?:is|does|will) @\\d+@ (?:\\w+ )?(?:away )?|at what distance |ASK (?:\\w+"
    f" )?distance (?:of @\\d+@ )?)from (?:fixed )?(?:stop|wall|nail|hook|post|peg)(?: at (?:foot|bottom) of"
    f" (?:{GROUNDS}))?\\b": r"\g<a>from far end",
    f"^how far to (?P<way>left|right) {_DOES} {_S} (?:get|go|move|travel|swing|come|run)(?: at most)?$": (
        r"how far does \g<s> move to \g<way> before \g<s> stops"
    ),
    "\\b(?P<n>next|following) edge has (?:struck|hit|landed|come down)\\b": r"\g<n> edge lands",
    "(?P<b>^.*\\b(?:does|do|is) @\\d+@ .*?) ?,? (?:once|when|after|as soon as) (?:everything|system|all|bodies)"
    " (?:is|are) (?:let go|released|set free)(?: from rest)?$": r"\g<b> at start",
    "\\bstart to move at start$": "start to move",
    "^how much (?:kinetic |mechanical )?energy do @0@ lose (?P<in>in|by|during|through) (?P<w>(?:their |this )?"
    "(?:collision|impact))$": r"how much kinetic energy is lost \g<in> \g<w>",
    f"^how far (?P<does>{_DOES}) {_S} (?P<v>travel|move|go|slide|run) (?:during|in|within|over) (?:one|single|each)"
    " (?:full |whole )?(?:oscillation|period|vibration|cycle)$": r"how far does \g<s> move in one oscillation",
    # what bodies share
    f"^(?:ASK|(?:with |at )?(?:what|which)) (?:is )?(?P<q>speed|velocity) ,? ?(?:(?:that|which) )?(?:{_DOES} )?{_S}"
    " (?:then )?(?:have in common|share)(?= |$)": r"what is common speed of \g<s>",
    f"\\b(?P<q>speed|velocity) (?:common to|shared by) (?:both )?{_S}": r"common \g<q> of \g<s>",
    f"(?: ,)? (?:at|on|over|by|along) (?:(?:both|all|two) (?:of )?)+(?:(?:rubbing|contact|sliding|touching|rough) )*"
    f"(?:surfaces|faces|contacts|interfaces|contact surfaces){_TOGETHER}(?: ,)?(?= |$)": " in all",
    f"\\b(?:points|places|spots|positions)(?: on (?:{GROUNDS}))? (?:where|at which) @0@ (?:first )?{_LANDS} first"
    " (?:time )?and (?:for )?second time\\b": "first and second bounce",
    f"\\b(?:on|during|in|throughout) (?:its |@\\d+@ 's )?first {_SLIDE} (?P<way>up|down|uphill|downhill)(?:wards)?"
    f"(?: (?:{GROUNDS}))?\\b": r"on its way \g<way>",
    "^how short (?P<is>is|was) (?=@)": r"how long \g<is> ",
    f"{_S} (?:acting |running |stretched )?between (?:them|both of them|these two|both)(?= |$)": r"\g<s>",
    f"^{_S} (?:moves|travels|flies|goes|runs|circulates|describes|follows|traces out|traces|performs)(?: (?:round|along"
    "|in|on))? (?:circular (?:path|orbit|motion|arc|track)|(?:arc of )?circle)\\. (?P<ask>ASK|what|how (?:large"
    "|great|big) is) (?:@\\d+@ 's |its |this |that )?(?:circle 's |path 's )?radius(?: of (?:it|this|that"
    "|this circle|circle|path|@\\d+@))?$": r"what is radius of path of \g<s>",
    "\\b(?:closest|nearest|least far apart|as close as they get|at their closest|at their nearest)"
    " (?:together|to each other|to one another)\\b": "nearest together",
    "\\b(?:farthest|furthest) (?:apart|from each other|from one another)\\b": "farthest apart",
}
"""Plainer words, by the pattern of a part of a question without articles that has the same meaning."""


_PASSES = "(?:pass|passes|passed|passing|reach|reaches|reached|cross|crosses|crossed|get to|gets to|arrives at|is at)"
_GO = "(?:pass|passes|go|goes|move|moves|slide|slides|roll|rolls|run|runs|come|comes)"
_MARK = (
    "(?:(?:painted |chalk )?(?:mark|line|point|flag|post|peg|sign|spot|place)(?: (?:painted|drawn|made|lying"
    "|situated|placed"
    "|that (?:is|lies)|which (?:is|lies)))?)"
)
_WAY = "(?:uphill|downhill|upwards?|downwards?|up|down|to right|to left|horizontally)"
_THROWN = f"(?:{HOME}|point of (?:throw|throwing|projection|launch|release)|thrower|launch point)"
_MEET = (
    "(?:meet|collide|touch|hit each other|come together|run into each other|come to rest|stop|turn back|turn round)s?"
)
_TELL = "(?:give|find|state|calculate|determine|what is|quote)"
_PLACE = "(?:of (?:it|this|that|that point|this point|that place|place|meeting point|point|collision))"
_LOWEST = "(?:its |@\\d+@ 's )?(?:lowest (?:point|position|place)|bottom)(?: of (?:its )?(?:path|swing|circle|arc))?"

PLACE_TURNS: Mapping[str, str] = {
    # marks on the way
    f"\\b(?:{_PASSES}|{_GO} (?:past|by|over|through|across)) {_MARK} (?P<n>#\\d+#) (?:farther |further )?"
    f"(?P<way>{_WAY})(?: (?:along )?(?:{GROUNDS}))? (?:away )?(?:from|of) {HOME}": r"move \g<n> \g<way>",
    f"\\b(?:{_PASSES}|{_GO} (?:past|by|over|through|across)) {_MARK} (?P<n>#\\d+#) (?:away )?(?:from|of) {HOME}": (
        r"move \g<n>"
    ),
    f"(?P<way>\\bon (?:its |@\\d+@ 's )?way down)(?: ,)? (?:and )?before (?:it|@\\d+@) (?:(?:has|have) )?(?:first"
    f" )?(?:hit|hits"
    f"|touched|touches|reached|reaches|struck|strikes|lands|landed(?: on)?)(?: (?:{GROUNDS}))?": r"\g<way>",
    "\\bon (?:its |@\\d+@ 's )?(?:way|path|journey) back (?P<way>up|down)\\b": r"on its way \g<way>",
    "\\bon (?:its |@\\d+@ 's )?first way (?P<way>up|down)\\b": r"on its way \g<way>",
    # coordinates
    "\\b(?P<axis>[xy])-coordinate\\b": r"\g<axis> coordinate",
    f"^where(?: (?:on|along|at) (?:{GROUNDS}|x axis))? (?:do|does|will) (?P<s>@\\d+@) (?P<verb>{_MEET})(?P<first>"
    f" for first"
    f" time)?\\. {_TELL} (?:(?:its|their|the) )?(?P<axis>x|y)(?:-| )?(?:coordinate|position|value)?(?: {_PLACE})?$": (
        r"what is \g<axis> coordinate of \g<s> when \g<s> \g<verb>\g<first>"
    ),
    "^(?:at|in|with) (?:what|which) (?:value of )?(?:(?:place|position|point) )?(?P<axis>x|y)(?:(?:-| )"
    "(?:coordinate|position|value))? (?:do|does|will) (?P<when>(?P<s>@\\d+@) .+)$": (
        r"what is \g<axis> coordinate of \g<s> when \g<when>"
    ),
    f"^{_TELL} (?P<axis>x|y)(?:-| )(?:coordinate|position|value) (?:of (?:point|place|spot|position) )?(?:where"
    f"|at which) (?P<when>(?P<s>@\\d+@) .+)$": r"what is \g<axis> coordinate of \g<s> when \g<when>",
    f"^(?:(?:at|in) (?:what|which) (?:point|position|place|spot)|where)(?: (?:on|along|of|at) (?:{GROUNDS}|x axis))?"
    " (?:do|does|will) (?P<when>(?P<s>@\\d+@) .+)$": r"where is \g<s> on track when \g<when>",
    f"^{_TELL} (?:position|point|place) (?:of collision|where|at which) (?P<when>(?P<s>@\\d+@) .+)$": (
        r"where is \g<s> on track when \g<when>"
    ),
    "(?P<s>@\\d+@) 's (?P<axis>x|y) coordinate (?:is|becomes|gets|reaches) (?:its )?(?P<most>GREATEST|LEAST)"
    "(?: value)?\\b": (r"\g<s> has its \g<most> \g<axis> coordinate"),
    # how far to a side of an axis
    "^how far (?:to )?(?P<side>above|below|left|right|beyond)(?: of)? (?P<axis>x|y)(?:-| )axis (?:does|will)"
    " (?P<s>@\\d+@)"
    " (?:get|go|come|move|travel|reach|swing|fly|climb|sink|rise)(?: (?:at most|at its (?:farthest|furthest)))?(?:"
    " (?:before"
    "|until) (?:it|@\\d+@) (?:turns? (?:back|round|around)(?: (?:up|down|again|to left|to right))?))?$": (
        r"how far at most \g<side> of \g<axis> axis is \g<s>"
    ),
    "^what is (?P<most>GREATEST) distance (?:of (?P<s>@\\d+@) )?(?P<side>above|below|to left of|to right of)"
    " (?P<axis>x|y)"
    "(?:-| )axis(?: (?:that )?(?P<t>@\\d+@) (?:gets|reaches|has|attains))?$": (
        r"how far at most \g<side> of \g<axis> axis is \g<s>\g<t>"
    ),
    "^how far (?:to )?(?P<side>above|below|left|right)(?: of)? (?P<axis>x|y)(?:-| )axis (?:is|was) (?P<s>@\\d+@)": (
        r"how far \g<side> of \g<axis> axis is \g<s>"
    ),
    # ahead of where it was thrown
    f"^(?P<ask>how far|at what distance) (?:forward|ahead|in front) (?:of|from) {_THROWN} (?=(?:does|will) )": (
        r"\g<ask> horizontally from point of throw "
    ),
    # below what carries it
    "(?P<s>@\\d+@) (?P<verb>is|passes|swings|moves|gets|comes|hangs|lies) (?:through )?(?:(?:vertically|directly"
    "|straight"
    "|exactly|right) )*(?:below|under|underneath|beneath) (?:axle of )?(?P<t>@\\d+@)": r"\g<s> is under \g<t>",
    # heights above the lowest point
    f"^(?:to )?(?:what|which) height above {_LOWEST} (?P<does>does|will) (?P<s>@\\d+@) (?:climb|swing|rise|get|go|come)"
    f"(?: (?:up|out))?(?: (?:on|to) (?:far|other|opposite) side)?$": (
        r"how high above its lowest point \g<does> \g<s> rise"
    ),
    f"^how high above {_LOWEST} (?P<does>does|will) (?P<s>@\\d+@) (?:climb|swing|rise|get|go|come)(?: (?:up|out))?"
    f" (?:on|to) (?:far|other|opposite) side$": r"how high above its lowest point \g<does> \g<s> rise",
    "^how much (?P<than>higher|lower) (?:up )?(?:than (?:(?:it|@\\d+@) (?:is|was) )?(?:at|in|before|from)?"
    f" ?(?:very )?(?:START|first|beginning|{HOME})) (?=is @|are @|does @|has @)": r"how far vertically \g<than> ",
    "\\bfixed (?:end|point) of (?=@\\d+@)": "far end of ",
}
"""Plainer words, by the pattern of a part of a question without articles that has the same meaning."""
