"""Forms of suppositions in ordinary English, each with the kind of number that it changes, and how."""

from collections.abc import Mapping

from sim2reason.questions.ordinary.vocabulary import GROUNDS
from sim2reason.questions.ordinary.whatif.numbers import EVERY_MASS

VALUE, TIMES, MORE, FIXED, SWAPPED, NONE, SAME = "value", "times", "more", "fixed", "swapped", "none", "same"
"""How a number is changed: to a value, by a factor, by a difference; what is held fixed, swapped, or vanishes."""
_S = r"@\d+@"
_W = "(?:was|were|is|are|be|had been|has been|would be|became|being)"
_N = r"(?P<n>#\d+#)"
MULTIPLES: Mapping[str, float] = {
    "(?:twice|double|two times)": 2.0,
    "(?:three times|thrice|triple|treble)": 3.0,
    "(?:four times|quadruple)": 4.0,
    "five times": 5.0,
    "ten times": 10.0,
    "(?:half|one half|half of)": 0.5,
    "(?:a third|one third|third of|third)": 1.0 / 3.0,
    "(?:a quarter|one quarter|quarter of|quarter)": 0.25,
}
DONE: Mapping[str, float] = {
    "doubled": 2.0,
    "halved": 0.5,
    "tripled": 3.0,
    "trebled": 3.0,
    "quadrupled": 4.0,
    "reduced to half": 0.5,
    "cut in half": 0.5,
    "reduced by half": 0.5,
    "increased to twice": 2.0,
}
_MULT = f"(?P<mult>{'|'.join(MULTIPLES)}|#\\d+# times)"
_SAME = (
    r"(?: (?:its|their|that|this|present|original|given|actual|current|initial|old|value|of|now|what it is|as"
    r" before|it is|it was|stated))*"
)
_LIKE = (
    rf"(?: (?:as|so) (?:large|great|big|high|strong|long|heavy|stiff|fast|much|small|massive|strong)(?: as)?)?{_SAME}"
)
_SET = (
    "(?:changed to|increased to|reduced to|raised to|lowered to|decreased to|set to|only|replaced by|made"
    "|equal to|instead|now|to be)"
)
_GROW = "(?P<grow>increased|greater|larger|raised|higher|longer|heavier|bigger|faster|more)"
_SHRINK = "(?P<shrink>reduced|smaller|lower|lowered|decreased|less|lighter|shorter|slower)"
_PCT = "(?: ?(?P<pct>%|percent|per cent))?"
_LAUNCHED = (
    "(?:thrown|launched|started|set moving|set in motion|set off|projected|fired|kicked|pushed off|sent"
    " off|released|moving|rolling|sliding|going|set rolling|travelling)"
)
_INSTEAD = r"(?: instead(?: of (?:#\d+#|with #\d+#|at #\d+#))?| rather than #\d+#| in place of #\d+#)?"
_DIRECTED = rf"(?: (?:(?P<way>up|down)(?:wards)?|off|initially|at start)(?: (?:{GROUNDS}))?)?"
_LATER = "(?: (?:at start|initially))?"
P = "NUMBER"
ROWS = (
    (rf"{P} {_W} {_MULT}{_LIKE}", TIMES),
    (rf"{P} {_W} (?:all |both |each )?(?P<done>{'|'.join(DONE)})", TIMES),
    (rf"{P} {_W} (?:{_SET} )*{_N}{_INSTEAD}", VALUE),
    (rf"{P} {_W} (?:{_GROW}|{_SHRINK}) by {_N}{_PCT}", MORE),
    (rf"{P} {_W} {_N}{_PCT} (?:{_GROW}|{_SHRINK})", MORE),
    (rf"{P}(?: {_W})?(?: (?:remained|stayed|kept|left|still))* (?:same|unchanged|as before)", SAME),
    (rf"{P} {_W} (?P<zero>zero|negligible)", NONE),
    (rf"(?P<s>{_S}) (?:had|has|have|were given|was given) {_MULT}{_SAME} {P}", TIMES),
    (rf"(?P<s>{_S}) (?:had|has|have|were given|was given) {P} of {_N}{_INSTEAD}", VALUE),
    (rf"(?P<s>{_S}) (?:had|were given) {P} {_MULT}{_LIKE}", TIMES),
)
OTHERS = (
    (
        (
            rf"(?P<s>{_S}) {_W} (?:instead )?(?:simply |only |just )?(?:released|let go|started|set free) from"
            rf" rest(?: instead)?"
        ),
        "motion at start",
        NONE,
    ),
    (rf"(?P<s>{_S}) {_W} {_MULT} (?:as )?(?:heavy|massive)(?: as)?{_SAME}", "mass", TIMES),
    (rf"(?P<s>{_S}) {_W} {_MULT} (?:as )?(?:stiff|strong|hard)(?: as)?{_SAME}", "stiffness", TIMES),
    (rf"(?P<s>{_S}) {_W} {_MULT} (?:as )?(?:long)(?: as)?{_SAME}", "length", TIMES),
    (rf"(?P<s>{_S}) {_W} replaced by (?:block|body|mass|one|ball|trolley|puck) of (?:mass )?{_N}", "mass", VALUE),
    (rf"(?P<s>{_S}) (?:weighed|had mass) (?:only )?{_N}{_INSTEAD}", "mass", VALUE),
    (rf"(?P<s>{_S}) {_W} (?:only )?(?P<n>#\d+#) (?:heavy|in mass){_INSTEAD}", "mass", VALUE),
    (rf"(?P<s>{_S}) {_W} (?:only )?(?P<n>#\d+#) long{_INSTEAD}", "length", VALUE),
    (
        (
            rf"(?P<s>{_S}) {_W} (?:instead )?{_LAUNCHED}{_DIRECTED} (?:at|with) (?:only )?(?:(?:initial )?(?:speed"
            rf"|velocity) of |(?:speed|velocity) )?{_N}{_LATER}{_INSTEAD}"
        ),
        "speed",
        VALUE,
    ),
    (
        (
            rf"(?P<s>{_S}) {_W} (?:instead )?{_LAUNCHED}{_DIRECTED} (?:at|with) {_MULT}{_SAME} (?:initial )?(?:speed"
            rf"|velocity){_LATER}"
        ),
        "speed",
        TIMES,
    ),
    (rf"(?P<s>{_S}) {_W} (?:instead )?{_LAUNCHED}{_DIRECTED} {_MULT} as fast(?: as)?{_SAME}", "speed", TIMES),
    (
        (
            rf"(?P<s>{_S}) {_W} (?:instead )?(?:thrown|launched|projected|fired|kicked) (?P<level>horizontally)(?: at"
            rf" same speed)?{_INSTEAD}"
        ),
        "launch angle",
        VALUE,
    ),
    (
        (
            rf"(?P<s>{_S}) {_W} (?:instead )?(?:thrown|launched|projected|fired|kicked) (?P<upright>(?:straight"
            rf"|vertically) (?:up|upwards))(?: at same speed)?"
        ),
        "launch angle",
        VALUE,
    ),
    (
        (
            rf"(?P<s>{_S}) {_W} (?:instead )?(?:thrown|launched|projected|fired|kicked) (?:at|under) (?:angle of"
            rf" )?{_N}(?: (?:above|to) horizontal)?(?: (?:at|with) same speed)?{_INSTEAD}"
        ),
        "launch angle",
        VALUE,
    ),
    (
        (
            rf"(?P<s>{_S}) {_W} (?:instead )?(?:thrown|launched|projected|fired|kicked) from (?:height of |point"
            rf" )?{_N}(?: (?:above ground|high|up))?(?: instead(?: of #\d+#)?)?"
        ),
        "height",
        VALUE,
    ),
    (
        rf"(?P<s>{_S}) {_W} (?:instead )?(?:thrown|launched|projected|fired|kicked) from {_MULT}{_SAME} height",
        "height",
        TIMES,
    ),
    (
        (
            rf"(?P<s>{_S}) {_W} (?:instead )?(?:thrown|launched|projected|fired|kicked) from (?P<ground>ground(?:"
            rf" level)?|level of ground)"
        ),
        "height",
        VALUE,
    ),
    (
        (
            rf"(?:{GROUNDS}) {_W} (?:only )?(?:(?:inclined|tilted|sloping) )?(?:at )?(?:angle of )?(?:only )?{_N}(?:"
            rf" (?:to|above) horizontal| steep)?{_INSTEAD}"
        ),
        "slope",
        VALUE,
    ),
    (rf"(?:{GROUNDS}) {_W} (?:(?P<grow>steeper)|(?P<shrink>less steep|flatter)) by {_N}", "slope", MORE),
    (rf"(?:{GROUNDS}) {_W} {_N} (?:(?P<grow>steeper)|(?P<shrink>less steep|flatter))", "slope", MORE),
    (rf"(?:{GROUNDS}) {_W} (?P<flat>horizontal|level)", "slope", VALUE),
    (
        (
            rf"(?P<s>{_S}) {_W} (?:instead )?(?:(?:released|let go|started|held|initially|first|start) )*(?:from |at"
            rf" )(?:angle of )?{_N}(?: (?:to|from|with)(?: downward)? vertical)?(?: at start)?{_INSTEAD}"
        ),
        "swing angle",
        VALUE,
    ),
    (
        (
            rf"(?:both|all|two|three|all three|both of)? ?masses(?: (?:of (?:both |all )?@\d+@|both|all))? {_W}"
            rf" (?P<done>{'|'.join(DONE)})"
        ),
        EVERY_MASS,
        TIMES,
    ),
    (rf"(?:both|all|two|three|all three)? ?masses(?: of (?:both |all )?@\d+@)? {_W} {_MULT}{_LIKE}", EVERY_MASS, TIMES),
    (rf"(?P<s>{_S}) {_W} (?P<done>{'|'.join(DONE)})", "charge", TIMES),
    (
        (
            rf"(?:blow|kick) (?:still |only |instead )*(?:gave|had given|had sent|sent) (?P<s>{_S}) (?:(?:initial"
            rf" )?speed of )?{_N}{_INSTEAD}"
        ),
        "speed",
        VALUE,
    ),
    (rf"(?:blow|kick) gave (?P<s>{_S}) {_MULT}{_SAME} speed", "speed", TIMES),
    (
        (
            rf"(?P<s>{_S}) (?:kept|retained|rebounded with|bounced with|lost all but) {_N}(?: times)?(?: of)? (?:its"
            rf" )?(?:vertical )?(?:speed|velocity)(?: (?:at|after|in|on) (?:each|every) (?:landing|bounce|impact"
            rf"|rebound))?{_INSTEAD}"
        ),
        "restitution",
        VALUE,
    ),
    (
        (
            rf"(?P<s>{_S}) (?:{_W} {_LAUNCHED}|started|set off|had started) (?:with )?{_N}{_PCT} (?:(?P<grow>faster)"
            rf"|(?P<shrink>slower))"
        ),
        "speed",
        MORE,
    ),
    (
        (
            rf"(?:its )?(?:fuel|gas|propellant) {_W} (?:burnt|burned|consumed|used|ejected) {_MULT} as (?:fast"
            rf"|quickly)(?: as)?{_SAME}"
        ),
        "burn rate",
        TIMES,
    ),
    (rf"(?:exhaust )?gas {_W} ejected at {_MULT}{_SAME} speed", "exhaust speed", TIMES),
    (
        rf"(?:exhaust )?gas {_W} ejected (?:at|with) (?:speed of )?{_N}(?: relative to {_S})?{_INSTEAD}",
        "exhaust speed",
        VALUE,
    ),
    (
        rf"engine (?:burned|burnt|consumed) (?:fuel )?(?:at )?(?:rate of )?{_N}(?: of fuel)?{_INSTEAD}",
        "burn rate",
        VALUE,
    ),
    (rf"engine (?:burned|burnt|consumed) (?:its )?fuel {_MULT} as (?:fast|quickly)(?: as)?{_SAME}", "burn rate", TIMES),
    (rf"hand (?:pulled|pulls) with (?:force of )?(?:only )?{_N}{_INSTEAD}", "force", VALUE),
    (rf"hand (?:pulled|pulls) {_MULT} as (?:hard|strongly)(?: as)?{_SAME}", "force", TIMES),
    (rf"hand (?:pulled|pulls) with {_MULT}{_SAME} (?:force)", "force", TIMES),
    (
        (
            rf"(?:there {_W} no friction(?: at all)?|friction {_W} (?:absent|negligible|removed|switched off"
            rf"|neglected|zero|absent altogether|eliminated|ignored))(?: (?:on|between|with|at) .+)?"
        ),
        "friction",
        NONE,
    ),
    (
        (
            rf"(?:(?:{GROUNDS})|(?P<s>{_S})|top of (?P<t>{_S})|contact|all surfaces|surfaces) {_W} (?:perfectly "
            rf"|made |completely |instead )*(?:smooth|frictionless|free of friction)(?: instead of rough)?"
        ),
        "friction",
        NONE,
    ),
    (
        (
            rf"(?:every |all |each )?(?:collisions?|impacts?|bounces?) {_W} (?:perfectly |completely |totally"
            rf" )?(?P<elastic>elastic)(?: instead)?"
        ),
        "restitution",
        VALUE,
    ),
    (
        (
            rf"(?:every |all |each )?(?:collisions?|impacts?) {_W} (?:perfectly |completely |totally"
            rf" )(?P<plastic>inelastic)(?: instead)?"
        ),
        "restitution",
        VALUE,
    ),
    (rf"(?P<e>electric|magnetic) field {_W} (?:switched off|turned off|absent|removed)(?: at start)?", "", NONE),
    (rf"there {_W} no (?P<e>electric|magnetic) field", "", NONE),
    (
        (
            rf"(?:this happened |experiment {_W} (?:done|made|performed|carried out) |it {_W} )?on (?:moon|mars"
            rf"|another planet|planet|jupiter)(?: ,)?(?: \(| where| with) ?,? ?g (?:= |is |of )?{_N}\)?"
        ),
        "gravity",
        VALUE,
    ),
    (rf"g {_W} (?:only )?{_N}{_INSTEAD}", "gravity", VALUE),
    (
        (
            rf"(?P<s>{_S}) {_W} (?:(?:held|kept|clamped|fixed|bolted|nailed|glued|screwed|locked|fastened|prevented"
            rf" from (?:moving|sliding))"
            rf"(?: (?:fixed|in place|at rest|to (?:{GROUNDS})|down|firmly|still|immovable|so that it (?:can not"
            rf"|cannot|can't) move))?)(?: instead of (?:being )?free to (?:move|slide))?"
        ),
        "",
        FIXED,
    ),
    (rf"(?P<s>{_S}) (?:could not|couldn't|could no longer) (?:move|slide)", "", FIXED),
    (rf"masses of (?P<s>{_S})(?: and (?P<t>{_S}))? {_W} (?:interchanged|swapped|exchanged)", "mass", SWAPPED),
    (rf"(?P<s>{_S}) and (?P<t>{_S}) (?:exchanged|swapped|interchanged) (?:their )?masses", "mass", SWAPPED),
)
ADJUNCTS = (
    (r"(?:without(?: any)? friction|in absence of (?:any )?friction|with no friction)", "friction", NONE),
    (rf"(?:on|with) (?:perfectly |completely )?(?:smooth|frictionless) (?:{GROUNDS})", "friction", NONE),
    (rf"with {_MULT}{_SAME} {P}", "", TIMES),
    (rf"with (?P<s>{_S}) {_MULT} as (?:heavy|massive)", "mass", TIMES),
    (rf"with (?P<s>{_S}) replaced by (?:block|body|mass|one|ball|trolley|puck) of (?:mass )?{_N}", "mass", VALUE),
    (rf"with (?P<s>{_S}) {_MULT} as stiff", "stiffness", TIMES),
    (rf"with (?P<s>{_S}) {_MULT} as long", "length", TIMES),
    (rf"with {P} of {_N}{_INSTEAD}", "", VALUE),
    (r"on (?:moon|mars)(?: ,)?(?: \(| where| with) ?,? ?g (?:= |is |of )?(?P<n>#\d+#)\)?", "gravity", VALUE),
)
"""Phrases that suppose something without a clause."""
