"""Turns of phrase about what bodies share, the circles and slides they make, and what lies between them."""

from collections.abc import Mapping

from sim2reason.questions.ordinary.vocabulary import GROUNDS

_S = r"(?P<s>@\d+@)"
_DOES = "(?:does|do|did|will)"
_TOGETHER = "(?: (?:together|taken together|combined|added together|in all|in total))?"
_LANDS = f"(?:lands|hits|strikes|touches|bounces(?: off)?|comes down|reaches|meets|impacts)(?: on)?(?: (?:{GROUNDS}))?(?: for)?"
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
    "|in|on))? (?:circular (?:path|orbit|motion|arc|track)|(?:arc of )?circle)\\. (?P<ask>ASK|what|how (?:large|great|big)"
    " is) (?:@\\d+@ 's |its |this |that )?(?:circle 's |path 's )?radius(?: of (?:it|this|that|this circle|circle|path"
    "|@\\d+@))?$": r"what is radius of path of \g<s>",
    "\\b(?:closest|nearest|least far apart|as close as they get|at their closest|at their nearest)"
    " (?:together|to each other|to one another)\\b": "nearest together",
    "\\b(?:farthest|furthest) (?:apart|from each other|from one another)\\b": "farthest apart",
}
"""Plainer words, by the pattern of a part of a question without articles that has the same meaning."""
