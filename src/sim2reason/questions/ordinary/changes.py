"""Questions about the interval between two moments: times, changes of a quantity, heights, energies lost."""

import re
from collections.abc import Iterator
from itertools import product

from sim2reason.questions.ordinary.clause_heads import HOME
from sim2reason.questions.ordinary.clauses import read_moments
from sim2reason.questions.ordinary.hearing import ALL_WORD, TokenizedSentence
from sim2reason.questions.ordinary.moment_phrases import AFTER, DURING, THEN, When
from sim2reason.questions.ordinary.readers import CHANGE, GAIN, JUMP, LOSS, STRETCH, Main, token_subjects
from sim2reason.questions.ordinary.vocabulary import GAINED, GROUNDS, LOWEST, ONCE, QUANTITIES, matching_entry, pattern
from sim2reason.questions.posing import MINUS, PLUS
from sim2reason.questions.structured import START
from sim2reason.questions.words import ORDINALS

CHANGING = {GAIN: "gain increase rise grow", LOSS: "lose decrease drop fall diminish", CHANGE: "change"}


IMPULSE = "impulse of a collision"
ENERGIES = "kinetic energy", "translational kinetic energy", "rotational kinetic energy", "spring energy"


UNDIRECTED = {name: name for name in (*ENERGIES, "speed", "spring length", "extension", "fuel left")}


def read_stored_energy(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the energy stored in a spring, or in several springs together."""
    yield Main("spring energy", PLUS.join(token_subjects(sentence, match["s"])))


def read_change(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the question for the gain, loss or change of a scalar quantity."""
    name, verb = matching_entry(QUANTITIES, match["q"]), match["verb"]
    needs = next((needs for needs, row in CHANGING.items() if verb in row.split()), GAIN)
    who = sentence.subject(match.groupdict().get("s"))
    if name in UNDIRECTED and not (
        who.startswith(ALL_WORD) and needs != CHANGE
    ):  # where one gains what the other loses
        yield from (
            Main(UNDIRECTED[name], of, needs=needs) for of in token_subjects(sentence, match.groupdict().get("s"))
        )


def read_exchanged_momentum(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the question for the impulse on a body, asked as the momentum that it gains or loses in a collision."""
    of = sentence.subject(match["s"])
    if not of.startswith(f"{ALL_WORD} "):  # the momenta of both change by nothing together
        yield Main(IMPULSE, of, needs=JUMP)


def lost_in_impact(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[Main]:
    """Yield the questions for the kinetic energy that a body loses in an impact, and for all energy lost there."""
    for of in token_subjects(sentence, match.groupdict().get("s")):
        yield Main("kinetic energy", of, needs=JUMP)
        yield Main("energy dissipated by friction", needs=STRETCH, ways=((f"{ALL_WORD} {of}", ALL_WORD),) if of else ())


_LONG = "how (?:much time|long|many (?:seconds|years))"
_BETWEEN = tuple(
    pattern(told)
    for told in (
        (
            f"{_LONG} ~(?:pass|passes|elapse|elapses|lie|lies|go by|goes by|there|have passed)? ?between (?P<one>.+)"
            f" and (?P<other>.+)"
        ),
        (
            "(?:ASK|what) (?:time|interval|time interval|delay)(?: that)? ?~(?:pass|passes|elapse|elapses|lies)?"
            " ?between (?P<one>.+) and "
            "(?P<other>.+)"
        ),
        f"{_LONG} ~(?:take|last|there)? ?from (?:moment )?(?P<one>[^,]+?) (?:to|until|till) (?P<other>.+)".replace(
            "[^,]", "(?:\\w|@|#| )"
        ),
        f"{_LONG} after (?P<one>.+?) (?:do|does|did|is|are|will|has|until) (?P<other>.+)",
        (
            f"{_LONG} ~{{s}} ~(?:stay|remain|fly)? ?(?:in air|in flight|airborne|aloft|flying) between (?P<one>.+)"
            f" and (?P<other>.+)"
        ),
        f"{_LONG} ~{{s}} (?:take|need|require) (?:to (?:MOTION|get|pass) )?from (?P<one>.+) (?:to|until) (?P<other>.+)",
        (
            f"{_LONG} ~{{s}} (?:take|need|require) to (?P<verb>MOTION|get|come|return)(?: back)? from (?P<one>.+?)"
            f" (?:to|until) "
            "(?P<other>.+)"
        ),
    )
)
_NUMBERED = re.compile(pattern("ORDINAL").pattern)
_FOLLOWING = re.compile(
    rf"(?P<number>{_NUMBERED.pattern})(?: one)?(?: (?:follow|occur|come|take place|happen|take|begin)s?)?"
)
COLLISION = "energy lost in a collision"
POINT_BELOW = (
    "(?:(?:point|place|spot)(?: on (?:level )?(?:ground|floor))?(?: (?:directly|vertically|straight|exactly))?"
    " (?:below|beneath|under|underneath) (?:throw|thrower|launch(?: point)?|throwing point|(?:point|place) of (?:throw"
    "|release|launch|projection)|release(?: point)?)"
    "|foot of (?:(?:throwing|launch|launching|starting|release) point|thrower|(?:point|place) of (?:throw|projection)))"
)
_HOMEWARD = re.compile(HOME)
_AGAIN = re.compile(r"\b(?:again|next|another|second time|third time)\b")
_LANDING = (
    "(?:landing|landing point|landing place|bounce|impact|impact point|hit|hits|point of impact|point|place|spot"
    "|touchdown)s?"
    rf"(?: (?:of @0@|where @0@ (?:touches|hits|strikes|lands on|bounces off|meets) (?:{GROUNDS})|where @0@"
    rf" (?:lands|bounces)"
    rf"|on (?:{GROUNDS})))?"
)
_SPAN = tuple(
    pattern(told)
    for told in (
        f"how far apart ~(?:points of )?(?P<one>ORDINAL) and (?P<other>ORDINAL) {_LANDING}",
        f"how far(?: horizontally)? ~(?P<other>ORDINAL) {_LANDING} from (?P<one>ORDINAL)(?: one| {_LANDING})?",
        f"(?:ASK|what) (?:horizontal )?distance between (?P<one>ORDINAL) and (?P<other>ORDINAL) {_LANDING}",
        f"(?:ASK|what) distance between @0@ 's (?P<one>ORDINAL) and (?P<other>ORDINAL) {_LANDING}",
        (
            f"how far(?: ,? ?(?:measured )?horizontally ,?)? ~@0@ (?:MOTION )?(?:horizontally )?between (?:its"
            f" )?(?P<one>ORDINAL) and (?:its )?"
            f"(?P<other>ORDINAL) {_LANDING}"
        ),
    )
)
_FROM_START = pattern(
    f"(?:how far|at what (?:horizontal )?distance)(?: ,? ?(?:measured )?horizontally(?: ,)?)?(?: away)? from"
    f" (?:{HOME}|{POINT_BELOW}|thrower|foot of (?:tower|cliff)) ~@0@ "
    f"(?:lands?|bounces?|comes? down|(?:hits?|strikes?|touch(?:es)?|reach(?:es)?|lands? on) (?:{GROUNDS}))(?:(?: for)?"
    f" (?P<number>ORDINAL) time)?"
    f"|how far(?: ,? ?(?:measured )?horizontally(?: ,)?)? ~(?P<other>ORDINAL) {_LANDING} from"
    f" (?:{HOME}|{POINT_BELOW}|thrower)"
)
_PEAK = pattern(
    "(?:how high(?: above SURFACE)?|(?:to )?what (?:greatest |maximum )?height) ~@0@ (?:rise|get|go|fly|climb"
    "|reach|bounce)(?: up)?"
    "(?: above SURFACE)? between (?:its )?(?P<one>ORDINAL) and (?:its )?(?P<other>ORDINAL) (?:bounce|impact"
    "|landing|rebound)s?"
)
_RISE = pattern(
    "(?:ASK|what) (?:@0@ 's )?GREATEST height(?: of @0@)? above (?:its |@0@ 's )?BOTTOM(?: of [its ]PATH)?"
    "|how high ~@0@ (?:rise|get|go|climb|swing|come)(?: up)? above (?:its |@0@ 's )?BOTTOM(?: of [its ]PATH)?"
    "|(?:how high|(?:to )?(?:what|which) (?:maximum |greatest )?height) above (?:its |@0@ 's )?BOTTOM(?: of [its"
    " ]PATH)?"
    " ~@0@ (?:(?:rise|get|go|climb|swing|come|ascend|reach)(?: up)?|(?:come to rest|turn back|stop)(?: momentarily)?)"
)
_TOP = pattern(
    "(?:(?:to )?(?:what|which) (?:maximum |greatest )?(?:height|altitude)|how high)(?: above SURFACE)? ~{s} "
    "~(?:rise|get|go|fly|climb|reach|come|bounce|rebound|jump)(?: back)?(?: up)?(?: above SURFACE)?"
    "|(?:ASK|what) GREATEST height(?: above SURFACE)?(?: of {t}| (?:that )?@\\d+@ ~(?:reaches|reach|attains"
    "|attain)| reached)?"
)
_BOUNCE = pattern(
    "(?:[its |@0@ 's ]{number=ORDINAL} (?:bounce|impact|landing|rebound)|BOUNCES (?:for )?{count=ORDINAL} time"
    "|[@0@ ]~(?:bounced|bouncing|BOUNCES|LANDS)(?: for {time=ORDINAL} time| once)?)"
)


_SLACK = pattern("how long ~{s} (?:(?:stay|remain|keep|hang|last) )?~slack(?: FIRST_TIME)?")
_ABOVE_LOWEST = pattern(
    "(?:how (?:high|far)|at what height|what is height of {t}) above (?:its |@\\d+@ 's )?BOTTOM(?: of [its |@\\d+@ 's "
    "]PATH)?(?: ~{s})?(?: vertically)?"
)


def above_lowest(question: str, clause: str, side: str, sentence: TokenizedSentence) -> Iterator[tuple[Main, When]]:
    """Yield questions, as main clause and moment, for a body's height above the lowest point of its path."""
    match = _ABOVE_LOWEST.fullmatch(question) if clause else None
    if match is None or not sentence.subjects:
        return
    who = sentence.subject(match["s"] or match["t"]) or sentence.subject("@0@")
    for when in read_moments(clause, sentence, who, side):
        told = f"{when.told.removesuffix(' before')}{MINUS}{who} lowest point"
        yield Main("displacement", who, "vertical"), When(told, AFTER, (*when.ways, (who, GAINED)), when.rank)


def _slack(sentence: TokenizedSentence) -> Iterator[tuple[Main, When]]:
    """Yield the question, as main clause and moment, for the time for which a string is slack."""
    match = _SLACK.fullmatch(sentence.text)
    if match is not None:
        line = sentence.subject(match["s"])
        yield Main("time"), When(f"{line} went taut{MINUS}{line} went slack", AFTER, (("", GAINED),))


def read_differences(sentence: TokenizedSentence) -> Iterator[tuple[Main, When]]:
    """Yield the questions of a sentence about an interval between two moments, each as main clause and moment."""
    subject = sentence.subject("@0@") if sentence.subjects else ""
    for told in _BETWEEN:
        match = told.fullmatch(sentence.text)
        if match is not None:
            yield from _times(
                match["one"], match["other"], sentence, sentence.subject(match.groupdict().get("s")) or subject
            )
    for told in _SPAN:
        match = told.fullmatch(sentence.text)
        if match is not None:
            who = subject
            when = f"{match['other']} {who} bounced{MINUS}{match['one']} {who} bounced"
            yield Main("displacement", who, "horizontal"), When(" ".join(when.split()), AFTER, ((who, GAINED),))

    yield from _slack(sentence)
    match = _FROM_START.fullmatch(sentence.text)
    if match is not None and re.search(r"\b(?:horizontal|horizontally|thrower|foot|below)\b", sentence.text):
        number = match["number"] or match["other"] or "first"
        for rank, when in enumerate(
            (f"{number} {subject} bounced", *((f"{subject} landed",) if number == "first" else ()))
        ):
            yield Main("displacement", subject, "horizontal"), When(when, AFTER, rank=rank)
    match = _PEAK.fullmatch(sentence.text)
    if match is not None and ORDINALS.index(match["other"]) == ORDINALS.index(match["one"]) + 1:
        yield Main("height above the ground", subject), When(f"{match['one']} {subject} top after bounce")
    if _RISE.fullmatch(sentence.text) is not None:
        for top in ("highest point", "stopped"):
            when = f"{subject} {top}{MINUS}{subject} lowest point"
            yield Main("displacement", subject, "vertical"), When(when, AFTER, ((subject, GAINED),))
            yield Main("displacement", subject, "vertical"), When(f"{subject} {top}", AFTER, ((subject, LOWEST),))


def _times(one: str, other: str, sentence: TokenizedSentence, who: str) -> Iterator[tuple[Main, When]]:
    """Yield questions, as main clause and moment, for the time between the moments that two clauses name."""
    if _AGAIN.search(other) or _AGAIN.search(one):
        return
    if _HOMEWARD.fullmatch(other):
        other = "returns"
    following, noun = _FOLLOWING.fullmatch(other), _NUMBERED.sub("", one, count=1)
    if following is not None:
        other = f"{following['number']}{noun}"
    first = _NUMBERED.match(other)
    if _NUMBERED.fullmatch(one) and first is not None:
        one = f"{one}{other[first.end() :]}"
    for early, late in product(read_moments(one, sentence, who, AFTER), read_moments(other, sentence, who, AFTER)):
        if not late.told or late.told.startswith("at ") or early.told == late.told or not early.told:
            continue
        told = MINUS.join(when.told.removesuffix(" before") for when in (late, early))
        yield Main("time"), When(told, AFTER, (("", GAINED), *late.ways), early.rank + late.rank)
        if {when.told.rpartition(" ")[2] for when in (early, late)} == {"closest", "farthest"}:  # half an orbit
            told = MINUS.join(when.told for when in (early, late))
            yield Main("time"), When(told, AFTER, (("", GAINED),), early.rank + late.rank)


def after_bounce(question: str, clause: str, side: str, sentence: TokenizedSentence) -> Iterator[tuple[Main, When]]:
    """Yield the question, as main clause and moment, for the height above the ground of the top after a bounce."""
    match, bounced = _TOP.fullmatch(question), _BOUNCE.fullmatch(clause)
    if side != AFTER or match is None or bounced is None or not sentence.subjects:
        return
    who = sentence.subject(match["s"] or match["t"]) or sentence.subject("@0@")
    number = next(filter(None, (bounced[key] for key in ("number", "count", "time"))), "first")
    if not who.startswith(ALL_WORD):
        yield Main("height above the ground", who), When(f"{number} {who} top after bounce")


def moments_of_change(main: Main, when: When, side: str) -> When | None:
    """Return two moments, joined by *minus*, between which a quantity changes: about an event, or from the start on."""
    told = when.told.removesuffix(" before")
    jumps = told.endswith(("bounced", "collided", "edge landed")) and side in (THEN, DURING)
    if main.needs == JUMP and (not jumps or (not main.of and "collided" in told)):
        return When(told, AFTER, when.ways, when.rank) if jumps and main.find == COLLISION else None
    if main.find == COLLISION:
        return None
    if main.find == IMPULSE:
        return When(told, AFTER, (*when.ways, ("", ONCE)), when.rank) if jumps and "collided" in told else None
    later, earlier = (told, f"{told} before") if jumps else (when.told, START)
    both = MINUS.join((earlier, later) if main.needs in (LOSS, JUMP) else (later, earlier))
    ways = (*when.ways, *(() if main.needs == CHANGE else (("", GAINED),)))
    return When(both, AFTER, ways, when.rank)
