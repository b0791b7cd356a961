"""Moments of questions in ordinary English, and the splitting of a sentence into a question and a clause."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from sim2reason.questions.ordinary.vocabulary import DOWN, MOTIONS, ROLL, ROLLING, UP, WAYS, meant

BEFORE, AFTER, THEN, DURING = "before", "after", "then", "during"
_SIDES: Mapping[str, str] = {
    BEFORE: "just before|immediately before|right before|shortly before|before|prior to",
    AFTER: "just after|immediately after|right after|directly after|shortly after|after|following|by|as result"
    " of|because of|due to|as consequence of",
    THEN: "at instant of|at moment of|at time of"
    "|at moment when|at instant when|at moment at which|at instant at which|at moment|at instant|at time when"
    "|moment|instant|by time|by time that|as soon as|when|once|as|until|till|right at|just as|right when|at|in|over|for"
    "|from release until|at end of|up to|up until|up to moment when|up to instant when|until moment when"
    "|up to point where|from start until|from release to moment when|at point where|whenever|at which",
    DURING: "during|while|on",
}
ONLY_LINE = "itself"  # the axis of a component along the only line on which a body can move
CONNECTORS: Mapping[str, str] = {said: side for side, row in _SIDES.items() for said in row.split("|")}
"""By what a clause begins with: on which side of what it names it asks."""
_CONNECTED = re.compile(rf"(?:^|(?<= ))(?:{'|'.join(sorted(CONNECTORS, key=len, reverse=True))})(?= )")
_BESIDE = re.compile(
    r"(?:(?<= over)|(?<= on)|(?<= in)|(?<= by)) @\d+@ #\d+# (?:after|later)\b"
    r"|(?:(?<= over)|(?<= on)) @\d+@ (?:in|within|during|after|by|until|before|when|once) "
)
_LASTING = re.compile(r"[^,]*\b(?:roll|slip|slid|skid|together|bounced off|collided|collision|been hit|been struck)")
"""What is so from the moment on that a clause with *once* names."""
_ENDED = re.compile(
    r" @\d+@ (?:has|have) (?:finally come to (?:rest|stop|standstill)|come to (?:rest|stop|standstill) for good)\b"
)
_GOING_ON = re.compile(r" (?:@\d+@|they|both) (?:is|are) (?:still )?(?:sliding|moving|slipping|in motion)$")
_LATER = re.compile(r"(?:^|(?<= ))#\d+# (?=after )")


@dataclass(frozen=True, slots=True)
class When:
    """A moment as a structured question names it, the side of the moment, and the presumed ways of bodies until then.

    `told` is empty for the whole motion. `ways` has the subject and *up*, *down*, … of each presumption. A moment of a
    higher `rank` counts only where the scene has none of a lower rank.
    """

    told: str
    side: str = THEN
    ways: tuple[tuple[str, str], ...] = ()
    rank: int = 0


def split(text: str) -> Iterator[tuple[str, str, str]]:
    """Yield every split of a sentence into a question, a clause and the clause's side, the whole sentence first."""
    yield text, "", ""
    for ending in (" initially", " at first"):
        if text.endswith(ending):
            yield text.removesuffix(ending), "start", THEN
    for found in _LATER.finditer(text):
        if found.start() > 0:
            yield text[: found.start()].strip(" ,"), text[found.start() :].strip(), THEN
        elif " , " in text:
            clause, _, question = text.partition(" , ")
            yield question.strip(), clause.strip(), THEN
    for found in _CONNECTED.finditer(text):
        if _BESIDE.match(text, found.end()) or (found[0] == "on" and text[: found.start()].endswith(" done ")):
            continue  # *sliding over the box 2 s after release*: no time of the box; *the work done on B*
        side = AFTER if found[0] == "once" and _LASTING.match(text, found.end()) else CONNECTORS[found[0]]
        side = AFTER if found[0] in ("when", "once") and _ENDED.match(text, found.end()) else side
        side = DURING if found[0] == "once" and _GOING_ON.match(text, found.end()) else side
        if found.start() > 0:
            yield text[: found.start()].strip().rstrip(" ,"), text[found.end() :].strip(), side
        elif " , " in text:
            clause, _, question = text[found.end() :].partition(" , ")
            yield question.strip(), clause.strip(), side


def ways_of(found: re.Match[str], who: str) -> tuple[tuple[str, str], ...]:
    """Return the ways in which a subject moves, as told by the matched verb and the words beside that verb."""
    groups = found.groupdict()
    verb = meant(MOTIONS, groups["motion"], " ") if groups.get("motion") else ""
    told = {UP: ("up",), DOWN: ("down",), ROLL: (ROLLING,)}.get(verb, ())
    beside = meant(WAYS, groups["way"]) if groups.get("way") else ""
    return tuple((who, way) for way in dict.fromkeys((*told, *((beside,) if beside else ()))))
