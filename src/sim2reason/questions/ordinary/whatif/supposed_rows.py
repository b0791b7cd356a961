"""Clauses that suppose a change, such as *A were twice as heavy*, each with the number and the type of change."""

from collections.abc import Mapping

from sim2reason.questions.ordinary.vocabulary import GROUNDS
from sim2reason.questions.ordinary.whatif.numbers import EVERY_MASS, NUMBER

VALUE, TIMES, MORE, FIXED, SWAPPED, NONE, SAME = "value", "times", "more", "fixed", "swapped", "none", "same"
"""Changes: of a number to a value, by a factor or by a difference; of a body that is held fixed; and so on."""
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
    "(?:one third|third of|third)": 1.0 / 3.0,
    "(?:one quarter|quarter of|quarter)": 0.25,
}
FACTORS_BY_PARTICIPLE: Mapping[str, float] = {
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
_THROWN = rf"(?P<s>{_S}) {_W} (?:instead )?(?:thrown|launched|projected|fired|kicked)"
_SENT = rf"(?P<s>{_S}) {_W} (?:instead )?{_LAUNCHED}{_DIRECTED}"
_SPEED = "(?:speed|velocity)"
_BURNED = "engine (?:burned|burnt|consumed)"
_PLACE = f"(?:{GROUNDS})"
_STEEPER = "(?:(?P<grow>steeper)|(?P<shrink>less steep|flatter))"
_REPLACED = rf"replaced by (?:block|body|mass|one|ball|trolley|puck) of (?:mass )?{_N}"
_PURELY = "(?:perfectly |completely |totally )"
_THERE = rf"(?: ,)?(?: \(| where| with) ?,? ?g (?:= |is |of )?{_N}\)?"
CLAUSES = (
    (rf"{NUMBER} {_W} {_MULT}{_LIKE}", "", TIMES),
    (rf"{NUMBER} {_W} (?:all |both |each )?(?P<done>{'|'.join(FACTORS_BY_PARTICIPLE)})", "", TIMES),
    (rf"{NUMBER} {_W} (?:{_SET} )*{_N}{_INSTEAD}", "", VALUE),
    (rf"{NUMBER} {_W} (?:{_GROW}|{_SHRINK}) by {_N}{_PCT}", "", MORE),
    (rf"{NUMBER} {_W} {_N}{_PCT} (?:{_GROW}|{_SHRINK})", "", MORE),
    (rf"{NUMBER}(?: {_W})?(?: (?:remained|stayed|kept|left|still))* (?:same|unchanged|as before)", "", SAME),
    (rf"{NUMBER} {_W} (?:zero|negligible)", "", NONE),
    (rf"(?P<s>{_S}) (?:had|has|have|were given|was given) {_MULT}{_SAME} {NUMBER}", "", TIMES),
    (rf"(?P<s>{_S}) (?:had|has|have|were given|was given) {NUMBER} of {_N}{_INSTEAD}", "", VALUE),
    (rf"(?P<s>{_S}) (?:had|were given) {NUMBER} {_MULT}{_LIKE}", "", TIMES),
    # what a verb or an adjective says of a body
    (
        (
            rf"(?P<s>{_S}) {_W} (?:instead )?(?:simply |only |just )?(?:released|let go|started|set free) from rest"
            "(?: instead)?"
        ),
        "motion at start",
        NONE,
    ),
    (rf"(?P<s>{_S}) {_W} {_MULT} (?:as )?(?:heavy|massive)(?: as)?{_SAME}", "mass", TIMES),
    (rf"(?P<s>{_S}) {_W} {_MULT} (?:as )?(?:stiff|strong|hard)(?: as)?{_SAME}", "stiffness", TIMES),
    (rf"(?P<s>{_S}) {_W} {_MULT} (?:as )?long(?: as)?{_SAME}", "length", TIMES),
    (rf"(?P<s>{_S}) {_W} {_REPLACED}", "mass", VALUE),
    (rf"(?P<s>{_S}) (?:weighed|had mass) (?:only )?{_N}{_INSTEAD}", "mass", VALUE),
    (rf"(?P<s>{_S}) {_W} (?:only )?{_N} (?:heavy|in mass){_INSTEAD}", "mass", VALUE),
    (rf"(?P<s>{_S}) {_W} (?:only )?{_N} long{_INSTEAD}", "length", VALUE),
    (rf"(?P<s>{_S}) {_W} (?P<done>{'|'.join(FACTORS_BY_PARTICIPLE)})", "charge", TIMES),
    # how a motion begins
    (
        rf"{_SENT} (?:at|with) (?:only )?(?:(?:initial )?{_SPEED} of |{_SPEED} )?{_N}{_LATER}{_INSTEAD}",
        "speed",
        VALUE,
    ),
    (rf"{_SENT} (?:at|with) {_MULT}{_SAME} (?:initial )?{_SPEED}{_LATER}", "speed", TIMES),
    (rf"{_SENT} {_MULT} as fast(?: as)?{_SAME}", "speed", TIMES),
    (rf"{_THROWN} (?P<level>horizontally)(?: at same speed)?{_INSTEAD}", "launch angle", VALUE),
    (rf"{_THROWN} (?P<upright>(?:straight|vertically) (?:up|upwards))(?: at same speed)?", "launch angle", VALUE),
    (
        (
            rf"{_THROWN} (?:at|under) (?:angle of )?{_N}(?: (?:above|to) horizontal)?(?: (?:at|with) same speed)?"
            rf"{_INSTEAD}"
        ),
        "launch angle",
        VALUE,
    ),
    (
        rf"{_THROWN} from (?:height of |point )?{_N}(?: (?:above ground|high|up))?(?: instead(?: of #\d+#)?)?",
        "height",
        VALUE,
    ),
    (rf"{_THROWN} from {_MULT}{_SAME} height", "height", TIMES),
    (rf"{_THROWN} from (?P<ground>ground(?: level)?|level of ground)", "height", VALUE),
    (
        (
            rf"(?P<s>{_S}) {_W} (?:instead )?(?:(?:released|let go|started|held|initially|first|start) )*(?:from |at )"
            rf"(?:angle of )?{_N}(?: (?:to|from|with)(?: downward)? vertical)?(?: at start)?{_INSTEAD}"
        ),
        "swing angle",
        VALUE,
    ),
    (
        (
            "(?:blow|kick) (?:still |only |instead )*(?:gave|had given|had sent|sent) "
            rf"(?P<s>{_S}) (?:(?:initial )?speed of )?{_N}{_INSTEAD}"
        ),
        "speed",
        VALUE,
    ),
    (rf"(?:blow|kick) gave (?P<s>{_S}) {_MULT}{_SAME} speed", "speed", TIMES),
    (
        (
            rf"(?P<s>{_S}) (?:{_W} {_LAUNCHED}|started|set off|had started) (?:with )?{_N}{_PCT}"
            " (?:(?P<grow>faster)|(?P<shrink>slower))"
        ),
        "speed",
        MORE,
    ),
    # slopes
    (
        (
            rf"{_PLACE} {_W} (?:only )?(?:(?:inclined|tilted|sloping) )?(?:at )?(?:angle of )?(?:only )?{_N}"
            rf"(?: (?:to|above) horizontal| steep)?{_INSTEAD}"
        ),
        "slope",
        VALUE,
    ),
    (rf"{_PLACE} {_W} {_STEEPER} by {_N}", "slope", MORE),
    (rf"{_PLACE} {_W} {_N} {_STEEPER}", "slope", MORE),
    (rf"{_PLACE} {_W} (?P<flat>horizontal|level)", "slope", VALUE),
    # all masses, and masses exchanged
    (
        (
            rf"(?:both|all|two|three|all three|both of)? ?masses(?: (?:of (?:both |all )?{_S}|both|all))? "
            rf"{_W} (?P<done>{'|'.join(FACTORS_BY_PARTICIPLE)})"
        ),
        EVERY_MASS,
        TIMES,
    ),
    (
        rf"(?:both|all|two|three|all three)? ?masses(?: of (?:both |all )?{_S})? {_W} {_MULT}{_LIKE}",
        EVERY_MASS,
        TIMES,
    ),
    (
        rf"masses of (?P<s>{_S})(?: and (?P<t>{_S}))? {_W} (?:interchanged|swapped|exchanged)",
        "mass",
        SWAPPED,
    ),
    (rf"(?P<s>{_S}) and (?P<t>{_S}) (?:exchanged|swapped|interchanged) (?:their )?masses", "mass", SWAPPED),
    # impacts
    (
        (
            rf"(?P<s>{_S}) (?:kept|retained|rebounded with|bounced with|lost all but) {_N}(?: times)?(?: of)?"
            rf" (?:its )?(?:vertical )?{_SPEED}(?: (?:at|after|in|on) (?:each|every)"
            rf" (?:landing|bounce|impact|rebound))?{_INSTEAD}"
        ),
        "restitution",
        VALUE,
    ),
    (
        rf"(?:every |all |each )?(?:collisions?|impacts?|bounces?) {_W} {_PURELY}?(?P<elastic>elastic)(?: instead)?",
        "restitution",
        VALUE,
    ),
    (
        rf"(?:every |all |each )?(?:collisions?|impacts?) {_W} {_PURELY}(?P<plastic>inelastic)(?: instead)?",
        "restitution",
        VALUE,
    ),
    # engines and hands
    (
        (
            rf"(?:its )?(?:fuel|gas|propellant) {_W} (?:burnt|burned|consumed|used|ejected) {_MULT} as (?:fast"
            rf"|quickly)"
            rf"(?: as)?{_SAME}"
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
    (rf"{_BURNED} (?:fuel )?(?:at )?(?:rate of )?{_N}(?: of fuel)?{_INSTEAD}", "burn rate", VALUE),
    (
        rf"{_S} (?:burned|burnt|consumed|used up) (?:its )?fuel {_MULT} as (?:fast|quickly)(?: as)?{_SAME}",
        "burn rate",
        TIMES,
    ),
    (rf"{_BURNED} (?:its )?fuel {_MULT} as (?:fast|quickly)(?: as)?{_SAME}", "burn rate", TIMES),
    (rf"hand (?:pulled|pulls) with (?:force of )?(?:only )?{_N}{_INSTEAD}", "force", VALUE),
    (rf"hand (?:pulled|pulls) {_MULT} as (?:hard|strongly)(?: as)?{_SAME}", "force", TIMES),
    (rf"hand (?:pulled|pulls) with {_MULT}{_SAME} force", "force", TIMES),
    # friction, fields and gravity
    (
        (
            rf"(?:there {_W} no friction(?: at all)?|friction {_W} (?:absent|negligible|removed|switched off|neglected"
            "|zero|absent altogether|eliminated|ignored))(?: (?:on|between|with|at) .+)?"
        ),
        "friction",
        NONE,
    ),
    (
        (
            rf"(?:{_PLACE}|(?P<s>{_S})|top of (?P<t>{_S})|contact|all surfaces|surfaces) {_W} (?:perfectly |made "
            "|completely |instead )*(?:smooth|frictionless|free of friction)(?: instead of rough)?"
        ),
        "friction",
        NONE,
    ),
    (
        rf"(?P<e>electric|magnetic) field {_W} (?:switched off|turned off|absent|removed)(?: at start)?",
        "",
        NONE,
    ),
    (rf"there {_W} no (?P<e>electric|magnetic) field", "", NONE),
    (
        (
            rf"(?:this happened |experiment {_W} (?:done|made|performed|carried out) |it {_W} )?on (?:moon|mars"
            rf"|another planet|planet|jupiter){_THERE}"
        ),
        "gravity",
        VALUE,
    ),
    (rf"g {_W} (?:only )?{_N}{_INSTEAD}", "gravity", VALUE),
    # bodies held fixed
    (
        (
            rf"(?P<s>{_S}) {_W} (?:held|kept|clamped|fixed|bolted|nailed|glued|screwed|locked|fastened"
            r"|prevented from (?:moving|sliding))"
            rf"(?: (?:fixed|in place|at rest|to {_PLACE}|down|firmly|still|immovable"
            r"|so that it (?:can not|cannot|can't) move))?(?: instead of (?:being )?free to (?:move|slide))?"
        ),
        "",
        FIXED,
    ),
    (rf"(?P<s>{_S}) (?:could not|couldn't|could no longer) (?:move|slide)", "", FIXED),
)
"""Clauses that suppose something: a pattern, the kind of number, if its noun is not in the pattern, and the change."""
ADJUNCTS = (
    (r"(?:without(?: any)? friction|in absence of (?:any )?friction|with no friction)", "friction", NONE),
    (rf"(?:on|with) (?:perfectly |completely )?(?:smooth|frictionless) {_PLACE}", "friction", NONE),
    (rf"with {_MULT}{_SAME} {NUMBER}", "", TIMES),
    (rf"with (?P<s>{_S}) {_MULT} as (?:heavy|massive)", "mass", TIMES),
    (rf"with (?P<s>{_S}) {_REPLACED}", "mass", VALUE),
    (rf"with (?P<s>{_S}) {_MULT} as stiff", "stiffness", TIMES),
    (rf"with (?P<s>{_S}) {_MULT} as long", "length", TIMES),
    (rf"with {NUMBER} of {_N}{_INSTEAD}", "", VALUE),
    (rf"on (?:moon|mars){_THERE}", "gravity", VALUE),
)
"""Phrases that suppose something without a clause, such as *without friction*, in rows like those of `CLAUSES`."""
