"""Turns of phrase about marks, coordinates, sides and heights, with plainer equivalents."""

from collections.abc import Mapping

from sim2reason.questions.ordinary.clause_heads import HOME
from sim2reason.questions.ordinary.vocabulary import GROUNDS

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
