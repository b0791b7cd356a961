"""Turns of phrase and their plainer equivalents, which replace them before a question is read."""

from collections.abc import Mapping

from sim2reason.questions.ordinary.turns_of_amount import AMOUNT_TURNS
from sim2reason.questions.ordinary.turns_of_bodies import BODY_TURNS
from sim2reason.questions.ordinary.turns_of_course import COURSE_TURNS
from sim2reason.questions.ordinary.turns_of_motion import MOTION_TURNS
from sim2reason.questions.ordinary.turns_of_order import ORDER_TURNS
from sim2reason.questions.ordinary.turns_of_phrase import LATER_TURNS, TURNS
from sim2reason.questions.ordinary.turns_of_place import PLACE_TURNS
from sim2reason.questions.ordinary.vocabulary import pattern

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


_ALL: Mapping[str, str] = {
    **BODY_TURNS,
    **ORDER_TURNS,
    **COURSE_TURNS,
    **AMOUNT_TURNS,
    **PLACE_TURNS,
    **MOTION_TURNS,
    **TURNS,
    **REWORDINGS,
    **LATER_TURNS,
}


def reworded(text: str) -> str:
    """Return a question with its turns of phrase replaced by plainer equivalents."""
    for told, plain in _ALL.items():
        text = pattern(told).sub(plain, text)
    return text.strip()
