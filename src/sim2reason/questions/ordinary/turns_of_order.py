"""Turns of phrase in an unusual order of words, and asides that do not change what a question asks for."""

import re
from collections.abc import Mapping

from sim2reason.questions.ordinary.clause_heads import HOME
from sim2reason.questions.ordinary.vocabulary import GROUNDS, pattern

_DOES = "(?:does|do|did|will|is|are|has|have|had)"
_ENGINE = "(?:(?:its |@\\d+@ 's )?(?:engine|engines|motor|motors))"
_RUBBING = "(?:rubbing|friction|sliding|slipping|grinding)"
_MAKES = "(?:generate|produce|create|develop|cause|set free|release|give|dissipate|turn into heat)d?"
_HEAT = "(?:heat|thermal energy|mechanical energy|energy)"
_ASKED = "(?:after how (?:many seconds|many years|long|much time)|after what time|at what (?:time|moment|instant)|when)"
_PASSES = "(?:passes|goes|moves|swings|flies|comes|gets|returns|arrives|falls|rises|sweeps)"
_WITH_PARTS = (
    "(?:(?:of )?(?:translation(?:al)?|rotation(?:al)?) and (?:of )?(?:translation(?:al)?|rotation(?:al)?)"
    "(?: parts| energy| motion| energies)?(?: (?:taken |added |counted )?(?:together|included|in all|combined))?"
    "|(?:both )?(?:rotation|rotational energy|rotational part|that of rotation|energy of rotation"
    "|translation and rotation|both parts)(?: being| both)? (?:included|counted|taken into account|counted in))"
)
_LETS_GO = "(?:let go|released|set free)"
_TIPS = "(?:tip|topple|roll|rock|turn|fall|tilt)(?: over)?"

ORDER_TURNS: Mapping[str, str] = {
    # asides within a question
    f" ,? {_WITH_PARTS} ,?(?= )| \\({_WITH_PARTS}\\)": "",
    f" ,? {_WITH_PARTS}$": "",
    "(?P<ask>^how high .+?) ,? (?:measured |counted )?vertically(?: measured)?$": r"\g<ask>",
    # the way of a body inside a clause
    "\\b(?P<w>when|as|once|where|at moment when|at which) ,? ?(?P<way>on (?:its |@\\d+@ 's )?(?:way|path|journey)"
    " (?:back )?(?:up|down)) ,? (?P<c>[(?:is|does|will|has) ]@\\d+@ (?:(?! , )(?!\\. ).)+)": r"\g<w> \g<c> \g<way>",
    "^(?P<ask>how far|at what distance|what distance) (?:forwards?|ahead)(?= (?:does|has|is|will|did|had) )": (
        r"\g<ask> horizontally"
    ),
    "^(?P<ask>how far) (?P<way>to right|to left) (?P<does>does|has|will|did|is) {s} (?P<v>\\w+)(?= |$)": (
        r"\g<ask> \g<does> \g<s> \g<v> \g<way>"
    ),
    # the question last
    f"^(?P<p>(?:through|past|at|over) [^@,]+?(?: (?:to|from|of) @\\d+@)?) ,? ?(?P<s>@\\d+@) (?P<v>{_PASSES}) (?P<r>.*?)"
    f" ?,? (?P<q>{_ASKED})(?: after START)?$".replace("[^@,]+?", "(?:[a-z]+ )*?\\w+").replace("[a-z]", "\\w"): (
        r"how long until \g<s> \g<v> \g<p> \g<r>"
    ),
    f"^(?P<c>(?!what |which |how |find |with |at |in |when |after |suppose |if |for )@\\d+@ (?:(?!\\. ).)+?) ,? ?"
    f"(?P<q>{_ASKED})(?: after START)?$": r"how long until \g<c>",
    # engines and fuel
    f"\\b(?:start|starting|ignition|switching on|lighting|firing|start-up) of {_ENGINE}": "start",
    f"\\b{_ENGINE} (?:has |have |had |is )?(?:been )?(?:running|burning|firing|working|operating|on|in operation"
    f"|alight|lit|burnt"
    f"|run|worked|fired) (?:for )?(?=#)": "t = ",
    "\\b(?:keep|keeps|go on|goes on|continue|continues)(?: on)?(?: to)? (?:running|burning|firing|working|run|burn"
    "|work|fire)$": "burn",
    "\\bfuel (?P<is>is|remains|are) (?:still |there |left |then )*(?:in|inside|aboard|on board)(?: (?:of )?(?:its "
    "|@\\d+@"
    " 's )?(?:fuel )?(?:tank|tanks))?\\b": "fuel is left",
    "\\bengine 's (?:push|force)\\b|\\b(?:push|force) of (?:its )?engine\\b": "thrust",
    # heat
    f"^how much {_HEAT} {_DOES} {_RUBBING} (?:of|between) {{s}} (?:on|against|over|along|and|with|upon) (?:top of )?"
    f"{{t}} {_MAKES}": r"how much heat arises between \g<s> and \g<t>",
    f"^how much {_HEAT} {_DOES} {_MAKES} (?:by|through|because of|due to|in) {_RUBBING} (?:of|between) {{s}}"
    " (?:on|against|over|along|and|with|upon) (?:top of )?{t}": r"how much heat arises between \g<s> and \g<t>",
    "\\b(?:set free|liberated|caused|given off|evolved|brought about)(?= (?:by|through|due to|because of|in)"
    " friction)": ("produced"),
    "\\b(?:by|through|due to|because of|from) rubbing\\b": "by friction",
    "\\b(?P<e>energy) (?:goes missing|goes lost|gets lost|is destroyed|goes astray|is used up|is given up)\\b": (
        r"\g<e> is lost"
    ),
    # moments
    "\\b(?:up to|until|till) (?:moment|instant|time|point)(?: of time)? (?:when|at which|where|in which)\\b": "until",
    "(?<=to )speed up to (?=#)": "reach ",
    "(?<!to )(?<!@ )\\b(?P<q>speed|velocity|kinetic energy|acceleration|tension)(?P<of>(?: of @\\d+@)?(?: (?:is"
    "|has|are))?)"
    " (?:come |gone |sunk |fallen )?(?:down|up) to (?=#)": r"\g<q>\g<of> ",
    "^(?P<ask>ASK_TIME|when|after what time|at what time|how soon) (?P<is>is|are) {s} again (?P<x>(?:(?! for first).)+)"
    "(?P<f> for first time)?$".replace("ASK_TIME", _ASKED): r"\g<ask> \g<is> \g<s> \g<x> again\g<f>",
    f"\\bat (?:its )?(?:{HOME}) again\\b": "back at its starting point",
    "\\b(?:reaches|reach|gets to|is at|arrives at) (?:its |@\\d+@ 's )?(?:extreme|outermost|end|turning)"
    " (?:position|point|deflection)(?= on (?:left|right|other))": "comes to rest",
    "{s} (?:is |gets |lies )?(?:at its )?(?:farthest|furthest)(?: position| point)? to (?P<w>right|left)\\b": (
        r"\g<s> stops on \g<w>"
    ),
    "\\b(?P<x>closest|nearest) (?:together|to each other|to one another)\\b": r"\g<x>",
    "\\b(?P<x>farthest|furthest) (?:apart|from each other|from one another)\\b": r"\g<x>",
    "(?P<m>(?:by |through )?#\\d+#) from (?:its |@\\d+@ 's |their )?(?:own )?(?:starting|initial|original|launch"
    "|release)"
    " (?:level|height)\\b": r"\g<m> from its starting point",
    "\\bslip(?:s|ped)? (?=(?:by |through )?#)": "move ",
    f"^(?P<take>how (?:long|much time) {_DOES} {{s}} (?:take|need) )(?:to )?{_TIPS} (?:from (?:one|its first"
    f"|first) face"
    " (?:on )?(?:to|onto) (?:its )?(?:next|second|following|other)(?: face| one)?|(?:on)?to (?:its )?next face)"
    "(?: for)?(?: first time)?$": "how long until edge lands",
    "^how long does (?:its |@\\d+@ 's )?first (?:tipping|tip|step|rocking|topple)(?: over)? (?:take|last)$": (
        "how long until edge lands"
    ),
    "^how long does (?:its |@\\d+@ 's )?second (?:tipping|tip|step|rocking|topple)(?: over)? (?:take|last)$": (
        "how much time passes between first landing and second landing"
    ),
    "\\bhangs? (?:straight|vertically|vertical) down(?:wards?)?\\b": "is vertical",
    "\\bwhere (?:blow|kick|push) (?:was|is|has been) (?:given|struck)\\b": "its starting point",
    "\\bfuel to be (?=used|burnt|burned|exhausted|consumed|spent)": "fuel is ",
    "\\b(?P<n>ORDINAL) (?P<w>collision|impact) (?:of|between) {s}(?! and| with| (?:hits"
    "|strikes))": r"\g<s> 's \g<n> \g<w>",
    f"^(?P<a>(?:how long|how much time|when|{_ASKED}) (?:(?!\\. ).)*?)(?:climb|rise|get|ascend|go up|fly|lift"
    f"|go)s? (?:up )?to"
    " (?:height|altitude) of (?=#)": r"\g<a>reach height of ",
    # speeds and accelerations
    "^(?:with|at) what acceleration is {s} (?:slowed|braked|retarded|decelerated)(?: down)?": (
        r"what is deceleration of \g<s>"
    ),
    "^(?:at what rate|how quickly|how fast) does {s} (?:turn|spin|rotate|roll) (?:faster(?: and faster)?|more"
    " quickly)": r"what is angular acceleration of \g<s>",
    f"^how does {{s}} accelerate(?: (?:along|on|over) (?:{GROUNDS}))?(?= |$)": r"what is acceleration of \g<s>",
    "\\btop (?=speed\\b|velocity\\b)": "greatest ",
    "\\bspeed (?P<d>does|will) {s} have left\\b": r"speed \g<d> \g<s> have",
    "\\b(?:descend or rise|rise or descend|rise or fall|fall or rise|move up or down|go up or down|ascend or"
    " descend)\\b": ("move"),
    "\\bcomponent of (?:{s} 's (?P<q>QUANTITY)|(?P<r>QUANTITY) of {t}) (?:along|in|parallel to)(?: direction of)?"
    " (?:positive )?(?P<a>x|y)(?:[- ](?:axis|direction))?(?= |$)".replace("[- ]", "(?:-| )"): (
        r"\g<a> component of \g<q>\g<r> of \g<s>\g<t>"
    ),
    "^(?P<ask>with what (?:speed|velocity)|how fast) (?P<d>does|will) {s} (?:move|go|fly|travel|slide|glide|shoot"
    "|rebound|recoil|come|emerge)(?: away| off| out| back)? (?:from|of|out of|after) (?:this |their |its )?"
    "(?P<w>collision|impact)": r"\g<ask> \g<d> \g<s> move just after \g<w>",
    "^by what angle (?=(?:does|do|is|has|did) (?:collision|impact))": "through what angle ",
    "^(?P<x>after (?:very |sufficiently )?long time|eventually|finally|in long run|in end) ,? ?{s} (?P<v>\\w+)"
    " (?P<w>(?:with|at) (?:steady|constant|uniform|terminal) (?P<q>speed|velocity))\\. (?:how (?:large|great|big|high)"
    " is|what is|find|determine|calculate) (?:SIZE )?(?:this|that|its) (?:speed|velocity)$": (
        r"what is \g<q> of \g<s> after long time"
    ),
    "\\b(?:begins?|starts?) to roll purely\\b": "rolls without slipping",
    # lengths and heights
    f"^what length of (?:{GROUNDS}|its path|path|way) (?={_DOES} )": "what distance ",
    "^(?:up )?to what (?:GREATEST )?length (?:does|is|will) {s} (?:get |be )?(?:stretched|extended|lengthened|drawn out"
    "|pulled out|stretch|extend)(?: at most)?$": r"what is longest length of \g<s>",
    "^(?:down )?to what (?:LEAST )?length (?:does|is|will) {s} (?:get |be )?(?:compressed|squeezed|shortened|pressed"
    "|shrink|pushed together)(?: at most)?$": r"what is shortest length of \g<s>",
    "^(?:ASK|what) (?:shortest|LEAST) length [that |to which ]{s} (?:takes on|assumes|shrinks|is compressed|attains"
    "|reaches)(?: to)?$": r"what is shortest length of \g<s>",
    "^(?:ASK|what) (?:longest|GREATEST) length [that |to which ]{s} (?:takes on|assumes|is stretched|attains"
    "|reaches)(?: to)?$": r"what is longest length of \g<s>",
    "^how much (?P<x>higher|lower) (?P<is>is|was|does|has) {s}(?P<lie> lie| be| stand| risen)? than (?:it (?:is|was|has"
    f" been) )?(?:at|in|before|from) (?:very )?(?:START|first|beginning|{HOME})": (
        r"how far vertically \g<x> \g<is> \g<s>\g<lie>"
    ),
    "\\bstretching of (?=@)": "extension of ",
    "(?<!angle of )\\belevation (?=above|of @)": "height ",
    f"^how far from (?P<home>{HOME}) (?P<d>does|will) {{s}} (?:get|go|stray|wander|recede|swing)(?: away| off)?"
    f"(?: at most| at its farthest)?(?: (?:in|during|over) (?:whole )?(?:course of )?(?:its |@\\d+@ 's )?(?:whole"
    f" )?motion)?$": r"how far does \g<s> get from \g<home> at most",
    f"\\b(?P<w>impact|contact|bounce) (?:with|on|against|off) (?:{GROUNDS})(?= |$)": r"\g<w>",
    "\\b(?:squeezed|pressed together|pushed together)(?= |$)": "compressed",
    "^(?P<a>(?:what|with what|at what) (?:power|rate) (?:does|is|did) )(?:pulling force|pull of hand|pull)"
    " (?=deliver|supply"
    "|do|doing|develop|transfer)": r"\g<a>hand ",
    # forces
    "^(?:how (?:strongly|much|hard)|with what force) is {s} (?:stressed|loaded|tensioned)(?= when| at| while| just"
    "|$)": (r"what is force in \g<s>"),
    "\\b(?P<v>push|press|pushes|presses) down (?=on @|on SURFACE)": r"\g<v> ",
    # periods and rounds
    "^(?:how long is|(?:ASK|what) (?:length|duration) of) (?:one )?(?:year|full year)(?: (?:on|of|for|of life on))"
    " (?:this |that )?{s}": r"what is period of \g<s>",
    "^(?:with|at) what (?P<q>frequency|period|angular frequency) does (?:system|everything|arrangement|set-up"
    "|whole thing) (?:vibrate|oscillate|swing|move)(?: to and fro)?$": r"what is \g<q>",
    "\\b(?P<v>oscillates?|vibrates?|swings?) together\\b": r"\g<v>",
    "^(?P<ask>.*\\bin (?:air|flight)) (?:altogether|in all|in total|overall)$": r"\g<ask>",
    # everything that turns
    "\\bmoment of inertia of @\\d+@ (?:with|together with|and|including|plus|carrying) @\\d+@ ,? ?(?=(?:with respect to"
    "|about|around|round|relative to) (?:its )?(?:axle|axis of rotation|pivot|hinge))": "moment of inertia ",
    "\\bmoment of inertia (?:with respect to|around|round|relative to) (?:its )?(?=axle)": "moment of inertia about ",
}
"""Plainer words, by the pattern of a part of a question without articles that has the same meaning."""


_ROOM = (
    rf"(?:{GROUNDS}|(?:laboratory|lab|earth|room|observer|someone|somebody|person|bystander)(?: standing)?(?:"
    rf" on (?:{GROUNDS}))?)"
)
_FRAME = "(?:reference )?frame(?: of reference)?"
_TELL = "(?:give|state|express|quote|write|report|take)"
_UNITS = "(?:kg|kilograms?|metres|meters|m|newtons?|n|joules?|j|seconds?|s|m/s|degrees?|years?|watts?|cm|km/s|radians?)"
ASIDES = tuple(
    re.compile(told)
    for told in (
        (
            rf" ?,? (?:as )?(?:seen|viewed|observed|measured|judged) (?:from|by|in|relative to) {_ROOM}(?: {_FRAME})?"
            rf" ?,?(?= |$)"
        ),
        (
            rf" (?:relative to|with respect to|in) (?:(?:{GROUNDS}|laboratory|lab|earth)(?: 's)? {_FRAME}|laboratory"
            rf"|lab|earth)(?= |$)"
        ),
        (
            rf" ?,? (?:as )?(?:measured|counted|reckoned|counting|measuring) (?:from|since)"
            rf" {pattern('START').pattern}(?: on)? ?,?"
            "(?= |$)"
        ),
        (
            rf"(?:[.?]|,|;| and| \() ?{_TELL} (?:only )?(?:(?:its|your|their|just|only) )?(?:answer|result|magnitude"
            rf"|amount|size|value)"
            rf"(?: only)?(?: (?:in|as) [a-z/²^0-9]+(?: per [a-z]+)?)?\)?$"
        ),
        rf"(?: ,)? \((?:measured )?in {_UNITS}(?: per [a-z]+)?\)(?: ,)?",
        rf" in {_UNITS}(?: per second(?: squared)?)?$",
        "(?<=first collision) of all(?= |$)|(?<=first impact) of all(?= |$)",
        " (?:like this|in this way|in doing so|in process|as described)(?= |$)",
        (
            rf"(?:,? )?(?:that|which) (?:follows|results|ensues|sets in)(?: (?:on|after|from|upon))?"
            rf"(?: (?:its )?{pattern('START').pattern})?(?= |$)"
        ),
        (
            "(?: ,)? (?:those with walls? (?:included|counted)|including those with walls?|counting those with"
            " walls?(?: too)?)(?: ,)?"
        ),
    )
)
"""Patterns of phrases that are removed from a question, on text without articles."""
_FIRST_INSTANT = re.compile(
    r"\b(?:at )?(?:very )?first (?:instant|moment|time) (?:at which|when|that|in which|it is that)\b"
)


_WORK = re.compile(r"how much work (?:has|does|did) friction (?:done|do)(?: on @\d+@)?")


def without_asides(text: str) -> str:
    """Return a question without incidental words; the work of friction becomes *how much energy is lost to it*."""
    if re.search(r"\bgive (?:only )?(?:its )?(?:magnitude|size)$", text) is not None:
        text = _WORK.sub("how much energy is lost to friction", text)
    for aside in ASIDES:
        text = aside.sub("", text)
    return " ".join(_FIRST_INSTANT.sub("when", text).split()).rstrip(" ,.;")


_ASK = (
    r"(?:what|which|find|determine|calculate|compute|give|state|how|obtain|with|at|after|in|when|by|work|show|to|for)"
)
_METHOD = (
    "(?:conservation|energy|momentum|newton|law|laws|second|work|theorem|principle|kinematics|equations?|motion|linear"
    "|mechanical|angular|otherwise|or|of|and|'s|the|considerations?|methods?|arguments?|initial|position|velocity"
    "|conditions?|given|data|values?|this|that|these|results?)"
)
LEAD_IN_PATTERNS = tuple(
    re.compile(told)
    for told in (
        r"^(?:okay|ok|hence|thus|therefore|so|now|next|finally|first|also|again|then|and|likewise|please|well)"
        r"(?: or otherwise)? ?,? (?=" + _ASK + r"\b|@\d+@)",
        (
            rf"^(?:by )?(?:using|applying|considering|use|with help of|by means of|from)(?: {_METHOD})+ ?,"
            rf" (?={_ASK}\b)"
        ),
        rf"^(?:measured|counted|reckoned|counting) from (?:start|release|launch) ,? ?(?={_ASK}\b)",
        (
            r"^(?:show|prove|explain|verify|note|notice|recall|remember|recognise|recognize)(?: \w+)? that"
            r" (?:[a-z ]+ )?(?:simple harmonic|harmonic|periodic|oscillatory|uniformly accelerated)\. "
        ),
        r"^(?:@\d+@|string|strings|they) (?:must|will|does|do) not (?:break|snap|slip off|tear)\. ",
        r"[.;] (?:mind|note|remember|recall|bear in mind|keep in mind) that [^.@#]+$",
        r" ,? (?:rotation|rotational energy|that of rotation|both parts)(?: being)? (?:included|counted)$",
        (
            r"(?<=component) ?,? (?:taking|counting|with) (?:up|upwards?|right|up direction) (?:as|being|as being)"
            r" positive$"
        ),
    )
)
"""Patterns of what is removed from a question in lower case, without articles."""
_POSITIVE = re.compile(r" ?,? ?(?:taking|counting|reckoning|with) (?:up|upwards?) (?:as |being )?positive$")
_REPEATED = re.compile(r"#(\d+)# \(#(\d+)#\)")


_SMOOTH = re.compile(
    r"^(?:all |both )?(?:floor|plane|table|track|surface|slope|top|surfaces|faces) (?:is|are) (?:smooth|frictionless)"
    r"(?: ,? ?(?:so|and so|therefore)(?: that)? [^.#]*)?\. "
)
_SEEN_BY = re.compile(
    r" ?,? (?:as )?(?:measured|seen|judged|viewed|observed) (?:by|from) (?:(?:observer|someone|somebody|person"
    r"|passenger|ant)"
    r"(?: who is| that is)? ?(?:sitting|standing|riding|at rest|fixed)? ?(?:on|to|with) )?(?=@)"
)


def without_leads(text: str, numbers: tuple[str, ...], *, smooth: bool) -> str:
    """Return a question without empty leading words, and without a repetition of the preceding number.

    In a scene without friction, which is `smooth`, a sentence such as *the floor is smooth* is left out as well.
    """
    text = _SMOOTH.sub("", text) if smooth else text
    text = _SEEN_BY.sub(" relative to ", text)
    for lead in LEAD_IN_PATTERNS:
        text = lead.sub("", text)
    if re.search(r"\bvertical component\b|\by[- ]component\b", text):
        text = _POSITIVE.sub("", text)
    return _REPEATED.sub(lambda match: _once(match, numbers), text)


def _once(match: re.Match[str], numbers: tuple[str, ...]) -> str:
    one, other = numbers[int(match[1])], numbers[int(match[2])]
    (size, _, unit), (twin, _, same) = one.partition(" "), other.partition(" ")
    return f"#{match[1]}#" if float(size) == float(twin) and unit == same else match[0]
