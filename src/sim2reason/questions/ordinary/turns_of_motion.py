"""Turns of phrase about slipping, turning, orbits, collisions and the course of a motion, and plainer equivalents."""

from collections.abc import Mapping

from sim2reason.questions.ordinary.clause_heads import HOME
from sim2reason.questions.ordinary.vocabulary import GROUNDS

_S = r"(?P<s>@\d+@)"
_DOES = "(?:does|do|did|will|is|are|has|have)"
_SLIP = "(?:slip|slid|skid|slide)(?:p?ing|d?ing)?"
_SLIPPING = "(?:slipping|sliding|skidding)(?: phase| stage| motion)?"
_PER_SECOND = "(?:radians?|rad) (?:per|a|in one|each|every) second"
_TURNING = "(?:turning|rotating|spinning|revolving|rolling|turn|rotate|spin|revolve)(?: round| around)?"
_MOTION = "(?:motion|movement|oscillations?|flight|swing|slide|run|journey|revolution)"
_ITS = r"(?:its |their |this |@\d+@ 's |subsequent |whole |entire |ensuing |resulting |further |following )*"
_APSIS = "(?:farthest|furthest|most distant|nearest|closest|most remote|remotest)"
_STEADY = "(?:final |ultimate )?(?:constant|steady|uniform|terminal|limiting)"
_POINT = "(?:point|position|place|spot|location|stage|state)"
_OFF = "(?:right angles|90°) to|perpendicular(?:ly)? to|normal to"
_FACE = f"(?:its surface|itself|@\\d+@ 's (?:surface|face)|surface of contact|contact surface|(?:{GROUNDS}))"

MOTION_TURNS: Mapping[str, str] = {
    # in the course of what
    f" ?,? (?:in|during|over|throughout) (?:the )?(?:whole )?course of {_ITS}{_MOTION}(?= |$)": "",
    f" ?,? (?:at any (?:time|moment|instant|point)|anywhere|ever) (?:in|during|of|on) {_ITS}(?:{_MOTION}|path)"
    "(?= |$)": "",
    f"\\b(?P<most>GREATEST) (?P<q>QUANTITY) of {_S} (?:during|in) (?:its )?{_MOTION}$": r"\g<most> \g<q> of \g<s>",
    # slipping
    f"^(?:for )?how long {_DOES} {_S} (?:keep|keep on|go on|continue|remain|stay)(?: to)? {_SLIP}(?: (?:on|along|down"
    f"|up) (?:{GROUNDS}))?$": r"how long does \g<s> slip",
    f"^(?:for )?how long {_DOES} {_S} (?:still )?{_SLIP}(?: (?:on|along|down|up|over) (?:{GROUNDS}))?(?: ,)?"
    f" (?:before|until|till) (?:@\\d+@|it) (?:(?:starts?|begins?) )?(?:to )?(?:purely )?roll(?:s|ing)?(?: purely)?"
    "(?: without slipping)?$": r"how long does \g<s> slip",
    f"^(?:for )?how long {_DOES} {_S} {_SLIP} on (?:{GROUNDS})$": r"how long does \g<s> slip",
    f"\\b(?:end|finish|conclusion) of (?:its |@\\d+@ 's )?{_SLIPPING}": "moment slipping stops",
    f"\\b(?:at|by) moment {_SLIPPING} stops": "when slipping stops",
    "\\b(?:by|to|through|due to|because of|in|against|from) (?:sliding|kinetic|dynamic|solid|dry) friction\\b": (
        "to friction"
    ),
    "^(?P<ask>how much (?:kinetic |mechanical )?energy) (?:are|were) (?=lost|dissipated)": r"\g<ask> is ",
    "\\bstarts? (?:to )?(?:pure(?:ly)? )?roll(?:ing)?$|\\brolls purely$": "rolls without slipping",
    # turning, and units named inside
    f"^(?:at )?how many {_PER_SECOND} {_DOES} {_S} (?:still )?(?:{_TURNING})(?: (?:at|with|through|by))?": (
        r"how fast is \g<s> turning"
    ),
    f"^(?P<ask>at what rate|how fast|how quickly|with what angular (?:speed|velocity)) ?,? ?(?:expressed |measured"
    f" |given )?in (?:rad/s|m/s²|m/s|{_PER_SECOND}|metres per second) ?,? (?={_DOES} )": r"\g<ask> ",
    # orbits
    f"\\bpoint(?: (?:of|on|in) (?:its |@\\d+@ 's )?(?:orbit|path|trajectory|ellipse))?,? (?:that|which) (?:is|lies)"
    f" (?={_APSIS})": "point ",
    "\\b(?:remotest|most remote|outermost) (?=point)": "farthest ",
    "\\b(?:innermost) (?=point)": "closest ",
    "\\bfrom (?P<one>perihelion|periapsis|pericentre|aphelion|apoapsis|apocentre) to (?:(?:next|following"
    "|subsequent) )?(?=perihelion|aphelion|periapsis|apoapsis|pericentre|apocentre)": r"from \g<one> to ",
    # places
    f"\\b(?:as|when|while|at moment when) @\\d+@ (?:passes|reaches|goes through|is at|gets to|arrives at|crosses)(?:"
    f" (?:by"
    f"|through|over))? {_POINT} (?:where|at which|in which) (?=@)": "when ",
    "^at what (?:value of )?(?P<axis>x|y)(?:(?:-| )(?:value|coordinate|position))? (?:does|will) @0@ (?:(?:first|next)"
    " )?(?=(?:cross|meet|pass|hit|reach|cut|intersect))": r"what is \g<axis> coordinate of @0@ when @0@ ",
    f"^(?P<ask>how far|at what distance) ,? ?(?:measured |reckoned |counted )?(?:along|on|over) (?:{GROUNDS}) ,"
    "(?= )": r"\g<ask> horizontally",
    "^(?P<ask>how far|at what distance) ,? ?(?:measured |reckoned )?(?:in )?horizontal(?:ly)?(?: direction)? ,": (
        r"\g<ask> horizontally"
    ),
    f" ?,? measured (?:horizontally|(?:along|on|over) (?:{GROUNDS})) ,? (?=(?:does|will) @0@)": " horizontally ",
    "^how far(?: horizontally)? from (?P<home>.+?) horizontally (?=(?:does|will) @0@)": (
        r"how far horizontally from \g<home> "
    ),
    "^(?:through|by|to) what angle (?:from|to|with|away from) vertical (?P<does>does|will) (?P<s>@\\d+@) (?:swing"
    "|rise|turn"
    "|move|get)(?: (?:out|up|over))? on (?:far|other|opposite) side$": (
        r"what angle \g<does> \g<s> make with vertical when \g<s> comes to rest on other side"
    ),
    "^through what angle does (?:collision|impact) (?:turn|deflect|change|rotate) (?:direction (?:in which"
    " (?P<s>@\\d+@) (?:is"
    " )?(?:moving|moves|travels)|of motion of (?P<t>@\\d+@)|of (?P<u>@\\d+@) 's (?:motion|velocity))|(?P<v>@\\d+@) 's"
    " direction(?: of motion)?|velocity of (?P<w>@\\d+@))$": (
        r"through what angle is \g<s>\g<t>\g<u>\g<v>\g<w> deflected in collision"
    ),
    "^(?:through )?what angle (?:does|is) (?:velocity of (?P<s>@\\d+@)|(?P<t>@\\d+@) 's velocity) (?:turn|turned"
    "|rotate)"
    "(?: through)? (?P<in>in|by|during|through) (?P<what>collision|impact)$": (
        r"through what angle is \g<s>\g<t> deflected in collision"
    ),
    # how often
    f"^how many (?:complete |full |whole )?(?P<what>oscillations|swings|vibrations|revolutions|orbits|circles|cycles)"
    f" (?:per|a|in (?:one|a|each)|every|each) second {_DOES} {_S} (?:perform|make|complete|execute|carry out|go through"
    "|describe)$": r"what is frequency of \g<s>",
    f"^how (?:many times|often) (?:per|a|in (?:one|a|each)|every|each) second {_DOES} {_S} (?:go round(?: (?:its|the)"
    " (?:circle|orbit|path))?|oscillate|swing(?: to and fro)?|vibrate|revolve|circle)$": r"what is frequency of \g<s>",
    "^(?P<ask>how high .*?) (?:in total|in all|altogether|overall)$": r"\g<ask>",
    "\\b(?P<verb>cross|crosses|crossed|meet|meets|hit|hits|cut|cuts) (?P<axis>x|y)(?:-| )axis(?: (?:again|next|(?:for"
    " )?first"
    " time))? (?:after|since) (?:START|leaving (?:origin|it|there))": r"\g<verb> \g<axis> axis",
    # forces
    f"(?P<verb>\\b(?:push|press|bear|act)(?:es|s|ed|ing)?) (?P<on>(?:against |down )?(?:on|against|upon)? ?@\\d+@)"
    f" (?:at )?(?:{_OFF}) {_FACE}": r"\g<verb> \g<on>",
    "\\b(?:pressing force|force of pressure|normal pressure force|contact pressure force) of (?P<s>@\\d+@) on"
    " (?P<t>@\\d+@|GROUNDS)".replace("GROUNDS", GROUNDS): r"normal force on \g<s>",
    "^(?P<ask>.*?)(?P<size>GREATEST )?force with which (?=@\\d+@ (?:press|push|pull|act)e?s?)": (
        r"\g<ask>\g<size>force that "
    ),
    "^(?P<ask>ASK|what) relative (?P<q>acceleration|velocity|speed) of (?P<s>@\\d+@) (?:with respect|relative) to": (
        r"\g<ask> \g<q> of \g<s> relative to"
    ),
    # on what carries it
    f"^(?P<ask>what distance|how far) (?P<on>along|on|over|across) (?:(?:top|surface|face) of )?(?P<t>@\\d+@)(?: 's"
    f" (?:top|surface|face))? {_DOES}"
    f" {_S} (?P<verb>\\w+)": r"\g<ask> does \g<s> \g<verb> \g<on> \g<t>",
    "(?<= )(?P<on>along|over|across|down|up|against) (?P<t>@\\d+@) 's (?:(?:left|right|sloping|inclined|upper|top|rough"
    "|smooth) )?(?:face|top|surface)\\b": r"\g<on> \g<t>",
    # after a long time
    f"^(?:after (?:very |sufficiently )?long time|eventually|finally|in long run|in end) ,? ?{_S} (?:moves|travels"
    f"|flies"
    f"|goes|drifts|continues|settles down|is moving|will move|approaches|reaches|attains|acquires)(?: to| at| with)*"
    f" {_STEADY} (?:speed|velocity)\\. (?P<ask>how (?:large|great|big|high) is|what is|find|determine|calculate)"
    f" (?:this|that|its|@0@ 's) (?:{_STEADY} )?(?P<q>speed|velocity)$": r"what is \g<q> of \g<s> after long time",
    f"\\b{_STEADY} (?P<q>speed|velocity) (?P<does>does|will) {_S} (?:finally|eventually|ultimately|at last|in end)"
    " (?:HAVE|move at|travel at|approach|settle to|settle down to)$": (r"\g<q> \g<does> \g<s> have after long time"),
    f"^(?P<ask>ASK|to what|what) (?:{_STEADY} )?(?P<q>speed|velocity) {_DOES} {_S} (?:finally |eventually "
    f"|ultimately )?(?:tend to|settle down to|approach"
    "|tend|settle down|settle)(?: (?:finally|eventually|in end|after long time))?$": (
        r"what is \g<q> of \g<s> after long time"
    ),
    f"^(?P<ask>ASK) (?:@0@ 's )?{_STEADY} (?P<q>speed|velocity)(?: of @0@)?$": r"what is \g<q> of @0@ after long time",
    # energies
    f"^how much (?P<q>(?:kinetic |mechanical )?energy) {_DOES} {_S} (?:acquire|receive|win|obtain|take over|pick up"
    "|take up|get)(?= |$)": r"how much \g<q> does \g<s> gain",
    f"^how much (?P<q>(?:kinetic |mechanical )?energy) (?:is|was) (?:handed over|given|handed|passed on|transferred"
    f"|imparted|communicated) to {_S}": r"how much \g<q> does \g<s> gain",
    "^by how much (?:is|does|has|did|will) (?:(?P<s>@\\d+@) 's (?P<q>(?:kinetic )?energy)|(?P<r>(?:kinetic )?energy)"
    " of (?P<t>@\\d+@)) (?:been )?(?:fall|fallen|drop|dropped|go down|diminished|reduced|sink|decline)(?= |$)": (
        r"how much \g<q>\g<r> does \g<s>\g<t> lose"
    ),
    "^by how much (?:is|does|has|did|will) (?:(?P<s>@\\d+@) 's (?P<q>(?:kinetic )?energy)|(?P<r>(?:kinetic )?energy)"
    " of (?P<t>@\\d+@)) (?:been )?(?:go up|gone up|rise|risen|raised|grow|grown|climb)(?= |$)": (
        r"how much \g<q>\g<r> does \g<s>\g<t> gain"
    ),
    # collisions
    f"^(?P<ask>with what (?:speed|velocity)|how fast) (?:does|will) {_S} (?:leave|emerge from|come out of|go out of)"
    " (?:this |their |its )?(?P<what>collision|impact)": r"\g<ask> does \g<s> move just after \g<what>",
    # speeds at an impact, and what is nearest or farthest
    "^ASK (?P<q>speed|velocity) (?:of|at|on) impact(?: of @0@)?(?: (?:when|as) @0@ (?:first )?lands)?$": (
        "with what speed does @0@ hit ground"
    ),
    "\\bshortest (?=(?:distance|separation)\\b)": "least ",
    "\\blongest (?=(?:distance|separation)\\b)": "greatest ",
    "\\bslowest (?=speed\\b)": "least ",
    "\\b(?P<most>GREATEST|LEAST) distance to which (?P<s>@\\d+@) (?:recedes|gets|goes|moves|approaches|comes)(?: away)?"
    "(?: (?:from|to))? (?P<t>@\\d+@)": r"\g<most> distance of \g<s> from \g<t>",
    f"^how far from (?:its )?equilibrium(?: position)? (?:does|will) {_S} (?:swing|move|go|get|travel|oscillate)(?:"
    f" out)?"
    "(?: to (?:each|either) side)?(?: at most)?$": r"what is amplitude of \g<s>",
    f"^(?P<ask>ASK) horizontal distance of {_S} from (?:thrower|{HOME})": r"how far horizontally does \g<s> move",
    # times
    f"^(?:in|within) what time (?:does|will|do) {_S} ": r"how long does \g<s> take to ",
    "^how (?:much time|many years|many seconds|long) (?:goes by|go by|passes|pass|elapses|elapse|is it|lies|is there)"
    " between (?:two )?(?:successive|consecutive) (?:passages? through )?(?:perihelion|aphelion|periapsis|apoapsis"
    "|pericentre|apocentre)(?: passages?)?(?: of @0@)?$": "what is period",
    "\\btotal (?=(?:time of flight|flight time)\\b)": "",
    "^how long must engine (?:run|burn|fire|work|operate) (?:for|until|before|so that) (?P<s>@\\d+@) (?:to )?(?:reach"
    "|reaches|attain|attains|has|have)(?: speed of)? (?P<n>#\\d+#)$": r"how long does it take until \g<s> reaches"
    r" \g<n>",
    "\\bpropellant\\b": "fuel",
    # heights
    "^(?:by |through )?(?:what|how much) (?:vertical )?height (?:does|will) (?P<s>@\\d+@) gain": (
        r"how high does \g<s> rise"
    ),
    "\\b(?:gain|gains|gained) (?P<n>#\\d+#) (?:in|of) (?:height|altitude|elevation)": r"rise \g<n> vertically",
    # lengths of paths
    "\\b(?:what|find|determine|calculate) (?:is )?(?:total |whole |entire )?length of (?:@0@ 's (?:path|track"
    "|trajectory)|(?:path|track|trajectory) of @0@)$": "how far altogether does @0@ move before @0@ finally stops",
    f"(?P<end>\\b(?:before|until|till|when) )(?:medium|friction|resistance|drag|air|liquid|fluid)(?: of medium)?"
    f" (?:has )?(?:brings|brought|slows|slowed) {_S}(?: down)? to (?P<rest>rest|halt|stop|standstill)": (
        r"\g<end>\g<s> comes to \g<rest>"
    ),
    "^what (?:total )?length of path (?=(?:does|has|will) )": "what distance ",
    # springs with a fixed end
    "\\b(?:fixed|held|far|other) (?:end|point) of (?=@\\d+@)": "far end of ",
    "\\bfixed end\\b(?! of)|\\bfixed point\\b(?! of)": "far end",
}
"""Plainer words, by the pattern of a part of a question without articles that has the same meaning."""
