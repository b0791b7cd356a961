"""Turns of phrase about places, times and forces, with plainer equivalents."""

from collections.abc import Mapping

from sim2reason.questions.ordinary.clause_heads import HOME

_S = r"(?P<s>@\d+@)"
_POINT = "(?:point|position|place|spot|location|stage|state|moment|instant)"
_GO = "(?:pass|passes|go|goes|come|comes|move|moves|fly|flies|swing|swings|run|runs|slide|slides|travel|travels|roll)"
_OBSTACLE = (
    "(?:(?:thin|vertical|high|tall|low|narrow|upright) )*(?:wall|post|fence|net|pole|tree|building|hedge|bar|screen)"
)
_HOME = (
    f"(?:{HOME}|(?:(?:point|place|position|spot) )?(?:where|from which|at which) @\\d+@ (?:(?:was|is|has been|had"
    f" been) )?"
    "(?:first )?(?:thrown|launched|released|started|began|set off|left|projected|starts)(?: from)?)"
)
_FOOT = (
    "(?:foot|base|bottom) of (?:cliff|tower|building|wall|table|(?:throwing|launch|launching|release|starting) point"
    "|thrower|point of (?:throw|projection|launch|release|throwing)|launch position)"
    "|(?:point|place|spot) (?:directly |vertically |straight |exactly )?(?:below|beneath|under|underneath) (?:thrower"
    "|(?:throwing|launch|launching|starting|release) point|point of (?:projection|throw|launch|release|throwing)|HOME)"
    "|thrower 's feet|thrower"
).replace("HOME", HOME)
_THROWN_FROM = (
    f"(?:thrower|point of (?:throwing|throw|projection|launch|release)|(?:launch|throwing|starting) point|{HOME})"
)
_LANDING = (
    "(?:(?:place of )?first (?:bounce|impact|landing)|landing(?: point| place| spot)?|impact point|point of (?:impact"
    "|landing)|(?:(?:point|place|spot) )?where @\\d+@"
    " (?:lands?|(?:(?:first )?(?:hits?|strikes?|touches|reaches|meets)) (?:ground|floor)))"
)
_WHERE = "(?:where|at which|in which|that is|which is|when)"

PHRASE_REWORDINGS: Mapping[str, str] = {
    f"(?P<range>\\brange of (?:throw|@\\d+@|motion|shot)) ?,?(?: (?:that is|i.e.) ,?)?(?: measured)? (?:horizontally"
    f" )?from"
    f" (?:{_FOOT}|{_THROWN_FROM}) to {_LANDING}$": r"\g<range>",
    "^(?P<prep>at|in|after|by|within|for|with|to) which (?=\\w)": r"\g<prep> what ",
    "^by what time (?=does|is|has|will|are|do)": "when ",
    "\\b(?:launch |launching |launch-)?pad\\b": "ground",
    "\\b(?P<verb>fall|drop|come)(?P<s>s?)(?: back)?(?: down)? (?:to|on|onto|upon) (?=ground|floor)": r"hit\g<s> ",
    "^how long does (?:flight|throw) last$": "what is time of flight",
    "^how long does (?:slipping|sliding|skidding)(?: phase)? (?:last|go on|continue)$": "when does slipping stop",
    "^how long does (?:motion|movement|slide) (?:last|go on|continue)$": "when does motion stop",
    "(?P<size>GREATEST|LEAST) (?:separation|distance) of (?=@\\d+@$)": r"\g<size> distance between ",
    "^(?:ASK|what) work (?=(?:is|does|has|do|did) )": "how much work ",
    "\\bamplitude with which (?P<s>@\\d+@) (?:oscillates?|vibrates?|moves?|swings?)": r"amplitude of \g<s>",
    "^(?:up )?(?:to )?what (?:maximum |greatest )?angle does (?P<s>@\\d+@) (?:reach|make|swing|swing out|rise|deflect"
    "|get)"
    "(?: to)?(?: with vertical)? on other side$": (
        r"what angle does \g<s> make with vertical when \g<s> comes to rest on other side"
    ),
    "^(?:at what rate|how fast) (?:does|is) (?P<s>@\\d+@) 's angular (?:speed|velocity) (?P<early>initially"
    " )?(?:increase"
    "|increasing|grow|growing|change|changing|rise)": r"what is \g<early>angular acceleration of \g<s>",
    "\\b(?<=what is )initially (?=angular)": "initial ",
    "^how much (?P<than>higher|lower) (?=is @)": r"how far vertically \g<than> ",
    "^.*\\bforce (?:that is )?(?:exerted |acting )?on (?P<p>@\\d+@) by (?:string|rope|cord) (?:that|which) (?:passes"
    "|runs|goes|is"
    " laid) (?:over|under|round|around) (?P=p)": r"what force of its string on pulley \g<p>",
    "(?<=tension )(?P<in>in|of) (?P<s>@\\d+@) (?:(?:that|which) )?(?:connecting|joining|connects|joins|linking|links)"
    " @\\d+@"
    "(?=$| ,| when| while| at| just| after)": r"\g<in> \g<s>",
    "^(?P<ask>what (?:total |resultant )?(?:force|load)|how large a (?:force|load)) (?:must|has|does)"
    " (?P<what>(?:@\\d+@ 's"
    " )?(?:axle|support|bearing|hinge|pivot|mounting)(?: of @\\d+@)?) (?:have to )?(?=withstand|bear|carry|exert"
    "|sustain"
    "|support|hold)": r"\g<ask> does \g<what> ",
    "^(?:with what force|how hard|how strongly) is (?P<s>@\\d+@) (?:pressed|pushed|pulled|forced) (?:against|on"
    "|onto|towards)"
    " (?:its )?(?:axle|bearing|support|mounting)": r"what load does axle of \g<s> carry",
    "^(?:with what (?:force|load)|how (?:strongly|heavily|hard)) is (?:(?P<s>@\\d+@) 's (?P<o>axle|bearing"
    "|support)|(?P<o2>axle"
    "|bearing|support) of (?P<s2>@\\d+@)) (?:loaded|strained|stressed|pulled|pressed)": (
        r"what load does axle of \g<s>\g<s2> carry"
    ),
    "^(?:with what (?:force|load)|how (?:strongly|heavily|hard)) is (?P<o>axle|bearing|pivot) (?:loaded|strained"
    "|stressed|pulled|pressed)": (r"what is force on \g<o>"),
    "\\bat (?:its |@\\d+@ 's )?(?P<p>lowest|highest) point of (?:its |this )?(?:swing|motion|path|arc|circle)\\b": (
        r"at \g<p> point"
    ),
    "^(?P<how>how (?:large|great|big|strong|high) (?:does|do|will|can) .+?) (?:become|grow|be|turn out) at"
    " (?:most|maximum)$": (r"\g<how> get at most"),
    "\\bbearing force\\b": "force on axle",
    "\\bforce (?:do|does) (?:two|both) (?:parts|sides|halves|sections|strands|ends|portions) of (?=@\\d+@ exert)": (
        "force does "
    ),
    "^(?:what (?:breaking )?(?:strength|load|tension|force|pull) (?:must|should) (?P<s>@\\d+@) (?:be able to"
    " )?(?:have|withstand|bear|stand|support)"
    "|how strong (?:must|should) (?P<t>@\\d+@) be)(?: at least)?(?: ,)?(?: (?:so as |in order |if @\\d+@ is"
    " )?(?:not to (?:break|snap|tear|give way)"
    "|to survive(?: (?:swing|motion|fall|release))?)| so that @\\d+@ (?:does|will|would) not (?:break|snap|tear))$": (
        r"what is greatest tension in \g<s>\g<t>"
    ),
    "\\bthis (?=ITS_MOTION)": "",
    "\\btop (?=(?:speed|velocity) )": "greatest ",
    "^(?P<ask>how much time (?:passes|elapses|goes by|passed)|how long does it take|how long is it) from START"
    " (?:until|till"
    "|to moment when) ": "how much time passes until ",
    "(?P<s>@\\d+@) (?:is|passes|swings|hangs|lies|moves) (?:vertically|directly|straight|exactly) (?:below|under"
    "|underneath|beneath) (?:(?P=s)|axle)": (r"\g<s> is at its lowest point"),
    "(?P<s>@1@) (?P<verb>moved|slid|shifted|gone|recoiled|travelled) back (?=along|on|over)": r"\g<s> \g<verb> ",
    "(?P<s>@\\d+@) then (?=\\w+ing\\b)": r"\g<s> ",
    "\\bfinal (?=QUANTITY (?:of|does|has|will) .*(?:once|when|after|as soon as) )": "",
    "^(?P<ask>how far apart are) (?:points|places|spots) where @0@ (?:lands|hits ground|bounces|strikes ground)"
    " (?:for )?first"
    " and (?:for )?second time": r"\g<ask> first and second bounce",
    "\\bdistance between (?:points|places|spots) of (?=ORDINAL and)": "distance between ",
    "\\b(?:ASK) separation of (?=@\\d+@$)": "what is distance between ",
    "(?:LEAST) length of (?=@)": "shortest length of ",
    "(?<=what is )greatest length of (?=@)": "longest length of ",
    # places by what is so there
    f"^(?P<ask>how fast|with what speed|at what speed|with what velocity) (?P<aux>does|will|do|did|is|are) {_S} "
    f"(?:first |moving |travelling |going )*(?:{_GO}) ?(?:through|by|over|past|across|along)? {_POINT}"
    f"(?: of (?:its|@\\d+@ 's) (?:orbit|path|track|motion|swing|trajectory))? {_WHERE} (?P<clause>.+)$": (
        r"how fast is \g<s> moving when \g<clause>"
    ),
    f"\\b(?:passes|pass|reaches|reach|is at|goes through|go through|gets to|get to|arrives at|comes to) {_POINT}"
    f" {_WHERE} (?=@)": "moves when ",
    # times
    "\\b(?:in|within) what time\\b|^(?:find|determine|calculate|compute|what is) (?:length of )?time"
    " (?:in|within|after) which ": "how long does it take until ",
    "\\blast (?:bit |drop |rest )?of (?:its )?fuel\\b": "all fuel",
    "\\b(?:fuel )?tanks are\\b": "tank is",
    "\\bat end of (?:its )?(?:burn|burning|powered flight|boost)\\b": "just before burnout",
    " (?:between|from) (?:its |moment of |instant of )?(?:START|throwing|throw) (?:and|to|until|till) (?=.*(?:land"
    "|impact|collision"
    "|bounce|stop|rest|burnout|ground))": " until ",
    "\\bmust be (?:burned|burnt|used|consumed) (?:up )?(?:to bring (?P<s>@\\d+@) to|(?:for|before) (?P<t>@\\d+@)"
    " (?:to reach"
    "|reaches|to have)) (?P<n>#\\d+#)$": r"has been burnt when \g<s>\g<t> reaches \g<n>",
    "\\b(?:very )?(?:start|beginning|outset|first instant) of (?:its |@\\d+@ 's )?(?:burn|motion|movement|flight|fall"
    "|slide|run|swing|descent|climb|oscillation|journey|throw)s?\\b": "start",
    "\\b(?:at|in) very (?:start|beginning|outset|first(?! \\w))\\b": "at start",
    "(?<=for first time) after (?:leaving (?:origin|it|HOME)|START)(?=$| ,|\\.)".replace("HOME", HOME): "",
    "(?<=is |es |et |ss ) ?for first time (?=(?:after|since) START$)": "",
    "\\bafter leaving origin\\b": "after start",
    "^(?P<n>#\\d+#) into (?:its )?(?:burn|motion|flight|fall|swing|slide|run|movement|journey) ,": r"\g<n> after"
    r" start ,",
    "\\b(?:to complete |for |of )?(?P<one>one (?:complete |full |whole )?ROUND) ,? ?(?:to and fro|there and back"
    "|back and forth|back and fro|forth and back)(?: again)?": r"to complete \g<one>",
    "(?P<ask>^how long does )(?P<one>one ROUND) ,? ?there and back ,? take": r"\g<ask>\g<one> take",
    "\\bfrom one (?:side|end|turning point|extreme) to (?:other|opposite)(?: side| end| one)?\\b": "to other side",
    "\\bto other side(?: , where @\\d+@ (?:comes to rest|stops)(?: again| for instant)?)": "to other side",
    "\\b(?:swing|move|go|travel|get|slide|come)(?: over| across)?(?: from (?:its )?(?:starting|initial|own)"
    " (?:position|point|side))?(?: over| across)? to other side(?: of (?:its )?(?:swing|path|motion))?": (
        "come to rest on other side"
    ),
    f"(?<!distance)(?<!range)(?<!displacement)(?<!horizontally) (?:down |up )?from {HOME} (?=(?:down |up |back"
    f" )?(?:to|into) )": (" "),
    "\\b(?:swing|fall|move|go|travel|sweep|drop|turn)s? (?:down |up )?(?:in)?to (?=(?:lowest|highest|bottom|top|its"
    " lowest|its highest|vertical))": "reach ",
    "(?<=reach )vertical(?: position)?$": "its lowest point",
    f"\\b(?P<go>{_GO}) (?:down )?(?:through|past|over|across) (?:its )?downward vertical(?: position| line|"
    f" direction)?"
    "\\b": r"\g<go> through its lowest point",
    "\\b(?:while|as long as|so long as|during time that) there is (?:still )?(?:slipping|sliding|skidding)\\b": (
        "while slipping"
    ),
    "\\blater (?=(?:cross|pass|hit|strike|reach|return)(?:es|s)?\\b)": "",
    "(?<=is )then (?=\\w+ing\\b)": "",
    # places
    f"\\b(?:over|past|above|clear|clears) {_OBSTACLE} (?:that (?:stands|is) )?(?P<n>#\\d+#) (?:away|ahead|in front)"
    f"(?: (?:of|from) {_THROWN_FROM})?$": r"\g<n> horizontally",
    f"^(?:there (?:is|stands) )?{_OBSTACLE} (?:stands |is |placed |located |standing )*(?P<n>#\\d+#) (?:away|ahead"
    f"|in front)(?: (?:of|from) {_THROWN_FROM})?\\. (?P<q>.+?) (?:as|when|where) (?P<b>@\\d+@) (?:just )?(?:passes"
    f"|clears|flies|goes|is|crosses)(?: over| above| directly above)? (?:it|@\\d+@|wall|post|net|fence|there)$": (
        r"\g<q> when \g<b> has moved \g<n> horizontally"
    ),
    f"^(?:there (?:is|stands) )?{_OBSTACLE} (?:stands |is |placed |located |standing )*(?P<n>#\\d+#) (?:away|ahead"
    f"|in front)(?: (?:of|from) {_THROWN_FROM})?\\. (?:at what height above|how high above) ground (?:does|will|is)"
    f" (?P<b>@\\d+@) (?:just )?(?:pass|clear|fly|go|cross)(?: over| above)? (?:it|@\\d+@|wall|post|net|fence)$": (
        r"how high is \g<b> above ground when \g<b> has moved \g<n> horizontally"
    ),
    f"(?P<n>#\\d+#) (?:away )?horizontally (?:away )?from {_HOME}|(?P<m>#\\d+#) (?:away )?from {_HOME} ,?"
    f" (?:measured )?horizontally": r"moved \g<n>\g<m> horizontally",
    f"(?:at what distance|how far|what distance) (?:away )?(?:(?:from|in front of|ahead of) (?:{_FOOT})) ?,?(?:"
    f" measured (?:along|on) ground ,?)?"
    f" (?:does|will) {_S} (?:first )?(?:hit|strike|reach|land|touch|come down|meet|land on)(?: on)?(?: ground)?"
    f"(?: first time)?$": r"what is range of \g<s>",
    f"^(?P<ask>what is|find|determine|calculate|compute) horizontal (?:distance|displacement) (?:between|from)"
    f" (?:{_FOOT}"
    f"|{_THROWN_FROM}) (?:and|to) {_LANDING}$": r"what is range",
    "^where on (?P<axis>x|y)(?: |-)axis (?:does|will|is) (?P<s>@\\d+@) (?P<verb>cross|hit|meet|pass|reach|strike|cut)"
    "(?: through)?(?: (?:it|that axis|axis))?(?P<first> for first time)?(?: after START)?\\. (?:give|find|state"
    "|calculate) its (?P=axis)(?: |-)coordinate(?: there)?$": (
        r"what is \g<axis> coordinate of \g<s> when \g<s> crosses \g<axis> axis"
    ),
    "^where is (?P<s>@\\d+@) (?P<when>(?:when|at|just|as|after) .+)\\. (?:give|find|state|calculate) its"
    " (?P<axis>x|y)(?: |-)coordinate(?: then)?$": r"what is \g<axis> coordinate of \g<s> \g<when>",
    "(?<=crosses )(?P<axis>x|y) axis again\\b": r"\g<axis> axis",
    "(?<=cross )(?P<axis>x|y) axis again\\b": r"\g<axis> axis",
    "\\b(?P<prep>along|on|over|across|against|down|up) (?:top|surface|face)(?: surface| side)? of (?=@)": r"\g<prep> ",
    "(?<= on )(?P<s>@\\d+@) 's (?:(?:left|right|sloping|inclined|upper|top|rough|smooth) )?(?:face|top|surface)\\b": (
        r"\g<s>"
    ),
    # quantities
    "^(?:at what rate|how fast|how quickly) (?:does|do|is|will) (?P<s>@\\d+@) 's (?:speed|velocity) (?:increase"
    "|increasing|grow|growing|rise|go up|change|changing)": r"what is acceleration of \g<s>",
    "^(?:at what rate|how fast) (?:does|do|is|will) (?:speed|velocity) of (?P<s>@\\d+@) (?:increase|increasing|grow"
    "|growing|rise|change|changing)": r"what is acceleration of \g<s>",
    "^how many (?:j|joules|n|newtons|kg|w|watts|m|metres) of (?=QUANTITY|fuel|HEAT)": "how much ",
    "\\b(?:pair|set|group|couple) of (?=@)": "",
    "^(?P<ask>.*\\bforce\\b.*?) ?,? (?:in total|in all|altogether)(?=$| ,)": r"\g<ask>",
    "\\b(?:speed|velocity) of (?P<s>@\\d+@) over (?:ground|floor)\\b": r"speed of \g<s>",
    "(?P<who>@\\d+@) (?P<verb>slides|rolls|moves|is sliding|is rolling|is moving|comes|falls) back (?P<way>down|up)"
    "(?: SURFACE)?$": r"\g<who> moves \g<way>",
    "^how (?P<how>far|long)(?P<more> .*?)? must (?P<s>@\\d+@) (?P<verb>\\w+ (?:before|until|to) )": (
        r"how \g<how>\g<more> does \g<s> \g<verb>"
    ),
}
"""Plainer words, by the pattern of a part of a question without articles that has the same meaning."""

LATER_TURNS: Mapping[str, str] = {
    "^(?:with|at) what (?P<q>QUANTITY) (?:(?:does|is|will) )?(?P<s>@\\d+@) (?P<verb>slides?|rolls?|moves?|falls?"
    "|comes?|runs?|sliding|rolling|moving) back (?P<way>down|up)(?: SURFACE)?$": (
        r"what is \g<q> of \g<s> while \g<s> moves \g<way>"
    ),
    "^(?:with|at) what (?P<q>QUANTITY) (?P<s>@\\d+@) (?=\\w+s )": r"with what \g<q> does \g<s> ",
}
"""Turns of phrase that the other replacements may leave behind, so that they come last."""
