"""Replacement of turns of phrase in conditions, such as *to pull A up*, by plainer words that the tables have."""

import re
from collections.abc import Mapping

from sim2reason.questions.ordinary.vocabulary import GROUNDS, compiled
from sim2reason.questions.ordinary.whatif.conditions_of_limits import LIMIT_CONDITIONS
from sim2reason.questions.ordinary.whatif.supposed_rows import MULTIPLES
from sim2reason.questions.ordinary.whatif.turns_of_need import TURNS_OF_CONDITIONS

_S = r"@\d+@"
_LIFTS = "(?:pull|haul|drag|draw|lift|bring|move|raise|hoist|tow|send|drive|push|carry)"
_LIFTING = "(?:pulling|hauling|dragging|drawing|lifting|bringing|moving|raising|hoisting|towing)"
_UP = rf"(?P<way>up|upwards|uphill|down|downwards|downhill)(?P<on> (?:{GROUNDS}))?"
_STEADY = r"(?: (?:at|with) constant (?:speed|velocity)| steadily| uniformly| at steady speed| without acceleration)"
_MOST = "(?:at most|at greatest|no more than|not more than|up to|at maximum)"
_GOES = "(?:go|move|rise|climb|accelerate|slide|descend|fall|sink|travel|be (?:pulled|drawn|hauled|accelerated))"
_SQUEEZED = "(?:squeezed|compressed|pushed together|pressed together|shortened)"
_STRETCHED = "(?:stretched|extended|pulled out|drawn out|lengthened)"
CONDITIONS: Mapping[str, str] = {
    rf"^(?:{_S} (?:would |could |can |will |to )?)?(?:be able to )?{_LIFTS} (?P<t>{_S}) {_UP}{_STEADY}$": (
        r"\g<t> move \g<way>\g<on> with constant speed"
    ),
    rf"^(?P<t>{_S}) (?:to )?(?:be )?(?:pulled|drawn|hauled|dragged|move|moves) {_UP}{_STEADY}$": (
        r"\g<t> move \g<way>\g<on> with constant speed"
    ),
    rf"^(?:{_S} (?:would |could |can |will |to )?)?(?:be able to )?{_LIFTS}s? (?P<t>{_S}) (?:up|upwards|uphill)"
    rf"(?: (?:{GROUNDS}))?$": r"\g<t> rise up",
    rf"^(?:{_S} (?:would |could |will |to )?)?(?:(?:not|can not|cannot) {_LIFTS}|without {_LIFTING}) (?P<t>{_S})"
    rf" (?:up|upwards|uphill)(?: (?:{GROUNDS}))?$": r"\g<t> not rise up",
    rf"^(?P<t>{_S}) (?:would )?(?:just )?fail to be (?:pulled|hauled|dragged|lifted|drawn|moved) (?:up|upwards|uphill)"
    rf"(?: (?:{GROUNDS}))?$": r"\g<t> not rise up",
    rf"^(?:lift|raise) (?P<t>{_S})(?P<rest>(?: (?:at once|straight away|immediately|right away))?)$": (
        r"\g<t> rise\g<rest>"
    ),
    rf"^(?:{_S} )?(?:lift-off|liftoff|take-off|takeoff)(?P<rest> .+)?$": r"it lift off\g<rest>",
    rf"(?P<t>{_S}) (?P<verb>sink|descend|rise|move|go down|go up|fall|climb|slide) (?:by )?(?:{_MOST} )?(?P<n>#\d+#)"
    r"(?: at most)?$": r"\g<t> \g<verb> \g<n>",
    rf"(?P<t>{_S}) (?:sink|descend|go down|fall) (?P<n>#\d+#)$": r"\g<t> go down \g<n>",
    r"^(?:oscillations?|vibrations?|motion|system) (?:to )?(?:have|has) (?P<q>period|frequency|amplitude) of ": (
        r"\g<q> be "
    ),
    rf"^(?P<t>{_S}) (?:to )?(?:rise|climb|ascend|go up) (?P<n>#\d+#) vertically$": (
        r"greatest height of \g<t> be \g<n>"
    ),
    r"^(?:rise|climb|ascend|go up) (?P<n>#\d+#) vertically$": r"its greatest height be \g<n>",
    rf"^(?P<t>{_S}) (?:to )?{_GOES}(?P<w> (?:up|down|uphill|downhill|upwards|downwards))?(?: (?:{GROUNDS}))?"
    r" (?:with|at)"
    rf" (?P<m>{'|'.join(MULTIPLES)}) (?:of )?(?:its |@\d+@ 's )?(?:(?:present|actual|original) )?"
    r"(?P<q>acceleration|speed)(?: (?:(?:that )?(?:it|@\d+@) (?:has|had)(?: (?:now|at present|in scene))?|as now|of now"
    r"|(?:as )?(?:it is )?now))?$": r"\g<q> of \g<t>\g<w> be \g<m> what it is now",
    rf"^leave (?P<t>{_S}) (?:for good|for ever|forever|altogether)$": r"escape from \g<t>",
    rf"^(?:bring |make )?(?P<t>{_S}) (?:to |come to )?(?:rest|halt|stop|stops) (?:after|within) (?:(?:{_S}|it)"
    rf" has |having )?"
    r"(?:sliding|rolling|slid|rolled|moving|moved|travelling|travelled|going|gone) (?P<n>#\d+#)$": (
        r"\g<t> move \g<n> before \g<t> stops"
    ),
    rf"^(?P<t>{_S}) (?:to )?(?:get|go|rise|climb|gain) (?P<n>#\d+#) (?:higher|in height)$": (
        r"greatest height of \g<t> be \g<n>"
    ),
    r"^(?:get|go|rise|climb|gain) (?P<n>#\d+#) (?:higher|in height)$": r"its greatest height be \g<n>",
    rf"(?P<t>{_S}) (?:to )?be (?:lifted|raised|pulled up|drawn up|hauled up|hoisted) with acceleration of ": (
        r"\g<t> rise with acceleration of "
    ),
    r"(?P<i>initial )?(?P<way>upward|downward) acceleration of (?P<n>#\d+#)": r"\g<i>acceleration of \g<n> \g<way>s",
    r"^(?:flight|motion through air) (?:to )?(?:take|last)s? ": "time of flight be ",
    rf"^not (?:to )?be (?:pulled|hauled|dragged|drawn|lifted) (?:up|upwards|uphill)(?: (?:{GROUNDS}))?$": "not rise up",
    "^(?:equilibrium|balance)$": "system be in equilibrium",
    rf"^(?:move|start) (?P<t>{_S})$": r"\g<t> begin to move",
    rf"^(?:keep|prevent|stop|hold|keeps|prevents|stops|holds) (?P<t>{_S}(?: and {_S})?) from (?P<verb>[a-z]+ing)\b": (
        r"\g<t> not \g<verb>"
    ),
    rf"^without (?P<t>{_S}) (?P<verb>[a-z]+ing)\b": r"\g<t> not \g<verb>",
    rf"^(?:(?:take|carry|send|bring|get|let|raise|make)s? )?(?P<t>{_S}) (?:up )?to (?:greatest |maximum )?height of ": (
        r"\g<t> rise to height of "
    ),
    rf"^(?:carry|carried|take|taken|send|sent|bring|brought)s? (?P<t>{_S}) (?P<n>#\d+#) (?=up|down|along|away)": (
        r"\g<t> move \g<n> "
    ),
    rf"(?P<s>{_S}) (?:to )?(?:be |is |gets |get )?{_SQUEEZED} (?:by )?{_MOST} (?:by )?(?P<n>#\d+#)$": (
        r"greatest compression of \g<s> be \g<n>"
    ),
    rf"(?P<s>{_S}) (?:to )?(?:be |is |gets |get )?{_SQUEEZED} by (?P<n>#\d+#) (?:at most|at maximum)$": (
        r"greatest compression of \g<s> be \g<n>"
    ),
    rf"(?P<s>{_S}) (?:to )?(?:be |is |gets |get )?{_STRETCHED} (?:by )?{_MOST} (?:by )?(?P<n>#\d+#)$": (
        r"greatest extension of \g<s> be \g<n>"
    ),
    rf"(?P<s>{_S}) (?:to )?(?:be |is |gets |get )?{_STRETCHED} by (?P<n>#\d+#) (?:at most|at maximum)$": (
        r"greatest extension of \g<s> be \g<n>"
    ),
    rf"(?P<s>{_S}) (?:to )?(?:be )?(?:stretch|stretched|pulled out) to (?:greatest )?length of (?:at most )?"
    rf"(?P<n>#\d+#)(?: at most)?$": r"greatest length of \g<s> be \g<n>",
    rf"^(?:give|gives|given) (?P<s>{_S}) 's (?:path|circle|orbit) radius of ": "radius of path be ",
    rf"^(?:its|{_S} 's) (?:path|circle|orbit) (?:to )?(?:have|has) radius of ": "radius of path be ",
    r"^make (?P<q>period|frequency|amplitude|radius of (?:its |@\d+@ 's )?(?:path|circle)) (?:be )?(?=#)": r"\g<q> be ",
    rf"(?P<t>{_S}) (?:to )?(?:take|lift) off with (?:initial )?acceleration of ": r"\g<t> have initial"
    r" acceleration of ",
    r"^radius of (?:its |@\d+@ 's )?(?:path|circle|orbit)(?: of @\d+@)? (?:to )?(?:be|is|equal|equals) ": (
        "radius of path be "
    ),
    r"^(?:one|each|single) (?:revolution|turn|circuit|round|full turn|full circle|loop)(?: of @\d+@)? (?:to"
    r" )?(?:take|last)s?"
    r" ": "period be ",
    rf"(?P<s>{_S}) (?:to )?be under tension of ": r"tension in \g<s> be ",
    r"^(?P<x>first collision|second collision|collision|impact) (?:to )?(?:dissipate|convert|turn into heat)s?"
    r" (?P<n>#\d+#)$": (r"energy lost in \g<x> be \g<n>"),
    r"^(?:give|gives) (?=(?:amplitude|period|tension|acceleration|total energy)\b.* #\d+#)": "",
}
"""By the pattern of a part of a condition without articles, plainer words with the same meaning."""


def plainer_condition(said: str) -> str:
    """Return a condition in plainer words."""
    said = re.sub(
        r"^(?:made|make|makes|cause[sd]?|let|lets|allow(?:ed|s)?|enable[sd]?) (?=@|(?:first |second )?collision"
        r"|flight)",
        "",
        said,
    )
    for told, plain in (*LIMIT_CONDITIONS.items(), *TURNS_OF_CONDITIONS.items(), *CONDITIONS.items()):
        said = compiled(told).sub(plain, said)
    return said
