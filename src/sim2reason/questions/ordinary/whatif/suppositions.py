"""Suppositions in ordinary English: clauses that say how a scene is changed, as other values of its numbers."""

import re
from collections.abc import Iterator, Mapping
from functools import cache
from typing import NamedTuple

from sim2reason.questions.ordinary.hearing import Heard
from sim2reason.questions.ordinary.vocabulary import GROUNDS
from sim2reason.questions.ordinary.whatif.numbers import EVERY_MASS, NamedNumber, named_number, number_pattern

VALUE, TIMES, MORE, FIXED, SWAPPED, NONE, SAME = "value", "times", "more", "fixed", "swapped", "none", "same"
"""How a number is changed: to a value, by a factor, by a difference; what is held fixed, swapped, or vanishes."""
_S = r"@\d+@"
_W = "(?:was|were|is|are|be|had been|has been|would be|became|being)"
_N = r"(?P<n>#\d+#)"
_MULTIPLES: Mapping[str, float] = {
    "(?:twice|double|two times)": 2.0, "(?:three times|thrice|triple|treble)": 3.0, "(?:four times|quadruple)": 4.0,
    "five times": 5.0, "ten times": 10.0, "(?:half|one half|half of)": 0.5, "(?:a third|one third|third of|third)": 1.0 / 3.0,
    "(?:a quarter|one quarter|quarter of|quarter)": 0.25,
}  # fmt: skip
_DONE: Mapping[str, float] = {
    "doubled": 2.0, "halved": 0.5, "tripled": 3.0, "trebled": 3.0, "quadrupled": 4.0, "reduced to half": 0.5,
    "cut in half": 0.5, "reduced by half": 0.5, "increased to twice": 2.0,
}  # fmt: skip
_MULT = f"(?P<mult>{'|'.join(_MULTIPLES)}|#\\d+# times)"
_SAME = r"(?: (?:its|their|that|this|present|original|given|actual|current|initial|old|value|of|now|what it is|as before|it is|it was|stated))*"
_LIKE = rf"(?: (?:as|so) (?:large|great|big|high|strong|long|heavy|stiff|fast|much|small|massive|strong)(?: as)?)?{_SAME}"
_SET = "(?:changed to|increased to|reduced to|raised to|lowered to|decreased to|set to|only|replaced by|made|equal to|instead|now|to be)"
_GROW = "(?P<grow>increased|greater|larger|raised|higher|longer|heavier|bigger|faster|more)"
_SHRINK = "(?P<shrink>reduced|smaller|lower|lowered|decreased|less|lighter|shorter|slower)"
_PCT = "(?: ?(?P<pct>%|percent|per cent))?"
_LAUNCHED = "(?:thrown|launched|started|set moving|set in motion|set off|projected|fired|kicked|pushed off|sent off|released|moving|rolling|sliding|going|set rolling|travelling)"
_INSTEAD = rf"(?: instead(?: of (?:#\d+#|with #\d+#|at #\d+#))?| rather than #\d+#| in place of #\d+#)?"
_DIRECTED = rf"(?: (?:(?P<way>up|down)(?:wards)?|off|initially|at start)(?: (?:{GROUNDS}))?)?"
_LATER = "(?: (?:at start|initially))?"
P = "NUMBER"
ROWS = (
    (rf"{P} {_W} {_MULT}{_LIKE}", TIMES),
    (rf"{P} {_W} (?:all |both |each )?(?P<done>{'|'.join(_DONE)})", TIMES),
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
    (rf"(?P<s>{_S}) {_W} {_MULT} (?:as )?(?:heavy|massive)(?: as)?{_SAME}", "mass", TIMES),
    (rf"(?P<s>{_S}) {_W} {_MULT} (?:as )?(?:stiff|strong|hard)(?: as)?{_SAME}", "stiffness", TIMES),
    (rf"(?P<s>{_S}) {_W} {_MULT} (?:as )?(?:long)(?: as)?{_SAME}", "length", TIMES),
    (rf"(?P<s>{_S}) (?:weighed|had mass) (?:only )?{_N}{_INSTEAD}", "mass", VALUE),
    (rf"(?P<s>{_S}) {_W} (?:only )?(?P<n>#\d+#) (?:heavy|in mass){_INSTEAD}", "mass", VALUE),
    (rf"(?P<s>{_S}) {_W} (?:only )?(?P<n>#\d+#) long{_INSTEAD}", "length", VALUE),
    (rf"(?P<s>{_S}) {_W} (?:instead )?{_LAUNCHED}{_DIRECTED} (?:at|with) (?:only )?(?:(?:initial )?(?:speed|velocity) of |(?:speed|velocity) )?{_N}{_LATER}{_INSTEAD}", "speed", VALUE),
    (rf"(?P<s>{_S}) {_W} (?:instead )?{_LAUNCHED}{_DIRECTED} (?:at|with) {_MULT}{_SAME} (?:initial )?(?:speed|velocity){_LATER}", "speed", TIMES),
    (rf"(?P<s>{_S}) {_W} (?:instead )?{_LAUNCHED}{_DIRECTED} {_MULT} as fast(?: as)?{_SAME}", "speed", TIMES),
    (rf"(?P<s>{_S}) {_W} (?:instead )?(?:thrown|launched|projected|fired|kicked) (?P<level>horizontally)(?: at same speed)?{_INSTEAD}", "launch angle", VALUE),
    (rf"(?P<s>{_S}) {_W} (?:instead )?(?:thrown|launched|projected|fired|kicked) (?P<upright>(?:straight|vertically) (?:up|upwards))(?: at same speed)?", "launch angle", VALUE),
    (rf"(?P<s>{_S}) {_W} (?:instead )?(?:thrown|launched|projected|fired|kicked) (?:at|under) (?:angle of )?{_N}(?: (?:above|to) horizontal)?(?: (?:at|with) same speed)?{_INSTEAD}", "launch angle", VALUE),
    (rf"(?P<s>{_S}) {_W} (?:instead )?(?:thrown|launched|projected|fired|kicked) from (?:height of |point )?{_N}(?: (?:above ground|high|up))?(?: instead(?: of #\d+#)?)?", "height", VALUE),
    (rf"(?P<s>{_S}) {_W} (?:instead )?(?:thrown|launched|projected|fired|kicked) from {_MULT}{_SAME} height", "height", TIMES),
    (rf"(?P<s>{_S}) {_W} (?:instead )?(?:thrown|launched|projected|fired|kicked) from (?P<ground>ground(?: level)?|level of ground)", "height", VALUE),
    (rf"(?:{GROUNDS}) {_W} (?:only )?(?:(?:inclined|tilted|sloping) )?(?:at )?(?:angle of )?(?:only )?{_N}(?: (?:to|above) horizontal| steep)?{_INSTEAD}", "slope", VALUE),
    (rf"(?:{GROUNDS}) {_W} (?P<flat>horizontal|level)", "slope", VALUE),
    (rf"(?P<s>{_S}) {_W} (?:instead )?(?:(?:released|let go|started|held|initially|first|start) )*(?:from |at )(?:angle of )?{_N} (?:to|from|with)(?: downward)? vertical(?: at start)?{_INSTEAD}", "swing angle", VALUE),
    (rf"(?:both|all|two|three|all three|both of)? ?masses(?: (?:of (?:both |all )?@\d+@|both|all))? {_W} (?P<done>{'|'.join(_DONE)})", EVERY_MASS, TIMES),
    (rf"(?:both|all|two|three|all three)? ?masses(?: of (?:both |all )?@\d+@)? {_W} {_MULT}{_LIKE}", EVERY_MASS, TIMES),
    (rf"(?P<s>{_S}) {_W} (?P<done>{'|'.join(_DONE)})", "charge", TIMES),
    (rf"(?:blow|kick) (?:still |only |instead )*(?:gave|had given|had sent|sent) (?P<s>{_S}) (?:(?:initial )?speed of )?{_N}{_INSTEAD}", "speed", VALUE),
    (rf"(?:blow|kick) gave (?P<s>{_S}) {_MULT}{_SAME} speed", "speed", TIMES),
    (rf"(?P<s>{_S}) (?:kept|retained|rebounded with|bounced with|lost all but) {_N}(?: times)?(?: of)? (?:its )?(?:vertical )?(?:speed|velocity)(?: (?:at|after|in|on) (?:each|every) (?:landing|bounce|impact|rebound))?{_INSTEAD}", "restitution", VALUE),
    (rf"(?P<s>{_S}) (?:{_W} {_LAUNCHED}|started|set off|had started) (?:with )?{_N}{_PCT} (?:(?P<grow>faster)|(?P<shrink>slower))", "speed", MORE),
    (rf"(?:its )?(?:fuel|gas|propellant) {_W} (?:burnt|burned|consumed|used|ejected) {_MULT} as (?:fast|quickly)(?: as)?{_SAME}", "burn rate", TIMES),
    (rf"(?:exhaust )?gas {_W} ejected at {_MULT}{_SAME} speed", "exhaust speed", TIMES),
    (rf"(?:exhaust )?gas {_W} ejected (?:at|with) (?:speed of )?{_N}(?: relative to {_S})?{_INSTEAD}", "exhaust speed", VALUE),
    (rf"engine (?:burned|burnt|consumed) (?:fuel )?(?:at )?(?:rate of )?{_N}(?: of fuel)?{_INSTEAD}", "burn rate", VALUE),
    (rf"engine (?:burned|burnt|consumed) (?:its )?fuel {_MULT} as (?:fast|quickly)(?: as)?{_SAME}", "burn rate", TIMES),
    (rf"hand (?:pulled|pulls) with (?:force of )?(?:only )?{_N}{_INSTEAD}", "force", VALUE),
    (rf"hand (?:pulled|pulls) {_MULT} as (?:hard|strongly)(?: as)?{_SAME}", "force", TIMES),
    (rf"hand (?:pulled|pulls) with {_MULT}{_SAME} (?:force)", "force", TIMES),
    (rf"(?:there {_W} no friction(?: at all)?|friction {_W} (?:absent|negligible|removed|switched off|neglected|zero|absent altogether|eliminated|ignored))(?: (?:on|between|with|at) .+)?", "friction", NONE),
    (rf"(?:(?:{GROUNDS})|(?P<s>{_S})|top of (?P<t>{_S})|contact|all surfaces|surfaces) {_W} (?:perfectly |completely |instead )*(?:smooth|frictionless|free of friction)(?: instead of rough)?", "friction", NONE),
    (rf"(?:every |all |each )?(?:collisions?|impacts?|bounces?) {_W} (?:perfectly |completely |totally )?(?P<elastic>elastic)(?: instead)?", "restitution", VALUE),
    (rf"(?:every |all |each )?(?:collisions?|impacts?) {_W} (?:perfectly |completely |totally )(?P<plastic>inelastic)(?: instead)?", "restitution", VALUE),
    (rf"(?P<e>electric|magnetic) field {_W} (?:switched off|turned off|absent|removed)(?: at start)?", "", NONE),
    (rf"there {_W} no (?P<e>electric|magnetic) field", "", NONE),
    (rf"(?:this happened |experiment {_W} (?:done|made|performed|carried out) |it {_W} )?on (?:moon|mars|another planet|planet|jupiter)(?: ,)?(?: \(| where| with) ?,? ?g (?:= |is |of )?{_N}\)?", "gravity", VALUE),
    (rf"g {_W} (?:only )?{_N}{_INSTEAD}", "gravity", VALUE),
    (rf"(?P<s>{_S}) {_W} (?:(?:held|kept|clamped|fixed|bolted|nailed|glued|screwed|locked|fastened|prevented from (?:moving|sliding))"
     rf"(?: (?:fixed|in place|at rest|to (?:{GROUNDS})|down|firmly|still|immovable|so that it (?:can not|cannot|can't) move))?)(?: instead of (?:being )?free to (?:move|slide))?", "", FIXED),
    (rf"(?P<s>{_S}) (?:could not|couldn't|could no longer) (?:move|slide)", "", FIXED),
    (rf"masses of (?P<s>{_S})(?: and (?P<t>{_S}))? {_W} (?:interchanged|swapped|exchanged)", "mass", SWAPPED),
    (rf"(?P<s>{_S}) and (?P<t>{_S}) (?:exchanged|swapped|interchanged) (?:their )?masses", "mass", SWAPPED),
)  # fmt: skip
ADJUNCTS = (
    (r"(?:without(?: any)? friction|in absence of (?:any )?friction|with no friction)", "friction", NONE),
    (rf"(?:on|with) (?:perfectly |completely )?(?:smooth|frictionless) (?:{GROUNDS})", "friction", NONE),
    (rf"with {_MULT}{_SAME} {P}", "", TIMES),
    (rf"with (?P<s>{_S}) {_MULT} as (?:heavy|massive)", "mass", TIMES),
    (rf"with (?P<s>{_S}) {_MULT} as stiff", "stiffness", TIMES),
    (rf"with (?P<s>{_S}) {_MULT} as long", "length", TIMES),
    (rf"with {P} of {_N}{_INSTEAD}", "", VALUE),
    (r"on (?:moon|mars)(?: ,)?(?: \(| where| with) ?,? ?g (?:= |is |of )?(?P<n>#\d+#)\)?", "gravity", VALUE),
)
"""Phrases that suppose something without a clause."""


class Supposition(NamedTuple):
    """A change of a number, or of a body: how, to or by how much, of what; the number has the unit that is told.

    A speed may be told with the `way`, *up* or *down*.
    """

    how: str
    number: NamedNumber
    value: str = ""
    factor: float = 1.0
    sign: int = 0
    way: str = ""


def suppositions(text: str, heard: Heard) -> tuple[Supposition, ...]:
    """Return the changes that a clause supposes, which *and* may join; none if a part of the clause is not understood."""
    whole = tuple(_one(text, heard, (*((told, "", how) for told, how in ROWS), *OTHERS)))
    if whole:
        return whole[:1]
    for found in re.finditer(r" (?:,? ?and|,) (?:if )?", text):
        one, other = suppositions(text[: found.start()], heard), suppositions(text[found.end() :], heard)
        if one and other:
            return (*one, *other)
    return ()


def adjunct(text: str, heard: Heard) -> tuple[Supposition, ...]:
    """Return the change that a phrase such as *without friction* supposes; none if it is not understood."""
    return tuple(_one(text, heard, ADJUNCTS))[:1]


def _one(text: str, heard: Heard, rows: tuple[tuple[str, str, str], ...]) -> Iterator[Supposition]:
    subject = {f"@{index}@": said for index, said in enumerate(heard.subjects)}
    said = re.sub(r"\b(?:just|instead only|only)\b ?", "", text).strip(" ,")
    for told, kind, how in rows:
        found = _compiled(told).fullmatch(said)
        if found is None:
            continue
        groups = found.groupdict()
        number = named_number(found, subject) if P in told else NamedNumber(kind or f"{groups.get('e')} field")
        owners = tuple(subject[groups[key]] for key in ("s", "t") if groups.get(key))
        if owners and not number.owners and how != SWAPPED:
            number = number._replace(owners=owners[:1])
        elif how == SWAPPED:
            number = number._replace(owners=owners)
        yield _changed(how, number, groups, heard)


def _changed(how: str, number: NamedNumber, groups: Mapping[str, str | None], heard: Heard) -> Supposition:
    value = heard.number(groups["n"]) if groups.get("n") else ""
    value = next((told for name, told in (("level", "0"), ("ground", "0 m"), ("flat", "0"), ("upright", "90"), ("elastic", "1"), ("plastic", "0")) if groups.get(name)), value)
    sign = 1 if groups.get("grow") else -1 if groups.get("shrink") else 0
    if groups.get("pct") or (sign and value.endswith(("%", "percent"))):
        return Supposition(TIMES, number, factor=1.0 + sign * float(re.match(r"[\d.]+", value)[0]) / 100.0)  # type: ignore[index]
    return Supposition(how, number, value, _factor(groups, heard), sign, groups.get("way") or "")


def _factor(groups: Mapping[str, str | None], heard: Heard) -> float:
    done, multiple = groups.get("done"), groups.get("mult")
    if done:
        return _DONE[done]
    if multiple and multiple.startswith("#"):
        return float(heard.number(multiple.partition(" ")[0]).partition(" ")[0])
    return next((value for told, value in _MULTIPLES.items() if multiple and re.fullmatch(told, multiple)), 1.0)


@cache
def _compiled(told: str) -> re.Pattern[str]:
    return re.compile(told.replace(P, number_pattern()))
