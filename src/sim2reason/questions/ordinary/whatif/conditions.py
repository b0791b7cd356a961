"""Conditions that a number of the scene must meet: outcomes such as *A slips*, and results."""

import re
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from sim2reason.questions.ordinary.base_forms import with_base_forms
from sim2reason.questions.ordinary.hearing import ALL_WORD, TokenizedSentence
from sim2reason.questions.ordinary.vocabulary import GROUNDS, pattern
from sim2reason.questions.ordinary.whatif.plainer_conditions import plainer_condition
from sim2reason.questions.ordinary.whatif.statements import asked_by
from sim2reason.questions.ordinary.whatif.supposed_rows import FACTORS_BY_PARTICIPLE, MULTIPLES

RESTS, HOLDS, STAYS, SLIPS, RISES, SINKS, ROUND = "rests", "holds", "stays", "slips", "rises", "does not rise", "round"
TAUT, SLACK, ESCAPES, BOUND, CIRCULAR, LIFTS = "taut", "slack", "escapes", "bound", "circular", "lifts off"
CLIMBS, DESCENDS, SLIDES = "climbs steadily", "descends steadily", "does not slide down"
GRIPS, HALTED, TILTED, TIPS, SPINS = "grips", "halted", "keeps its angle", "tips over", "stays while it slips"
"""Outcomes: *holds* means that nothing slips, *stays* that a body stays at rest where it first stops.

*grips* means that a rolling body that slips at first stops slipping, *halted* that a collision leaves a body at rest.
"""
_S = r"@\d+@"
_ROUND = "(?:turn|circle|revolution|loop|round|rotation)"
_ON = rf"(?: (?:on|along|over) (?:(?:this |its )?(?:{GROUNDS})|{_S}|top of {_S}))?"
_AT_REST = "(?:at rest|in equilibrium|in balance|motionless|stationary|balance[d]?|put|still|where (?:it|they|{S}))"
_SLIPPING = "(?:slip|skid)(?:ping)?"
PHRASES: Mapping[str, str] = {
    r"(?:be )?halt by collision": HALTED,
    rf"(?:be )?(?:at some time |ever |at last |finally |in end |eventually )*(?:stop|cease|end) {_SLIPPING}"
    rf"(?: (?:ever|at some time|some time|sooner or later|in end|eventually))?"
    rf"|(?:begin|start|come) to roll (?:purely|without {_SLIPPING})(?: (?:ever|at some time|in end|eventually))?"
    rf"|(?:in end|finally|eventually|at last|at some time|sooner or later) roll without {_SLIPPING}": GRIPS,
    r"keep (?:its|same|constant|initial) ?(?:initial )?(?:inclination|angle|direction|tilt|slope|slant)"
    r"(?: of #\d+#)?(?: (?:to|with) (?:downward )?vertical)?(?: (?:all time|throughout|always|constantly))?": TILTED,
    rf"(?:tip|topple|fall|tumble|turn|roll|get|go|rock) over (?:its )?(?:lower |next |front )?(?:edge)?"
    rf"|(?:tip|topple|tumble)(?: over)?"
    rf"|not (?:fall|tip|rock|drop|tumble|sink) back(?: (?:on|onto|to) (?:its |same |original |first )?face"
    rf"(?: (?:it|{_S}) (?:lie|lay|lay on|lie on|stand on|start on)(?: on)?)?)?": TIPS,
    rf"(?:stay|remain|be|keep) (?:at rest|where (?:it|{_S})(?: be)?|in place|still)"
    rf" (?:as long as|while|until|so long as) (?:it|{_S}) (?:be )?(?:still )?(?:stop )?{_SLIPPING}": SPINS,
    rf"not (?:slide|slip|move|go|be pulled|sink|creep) down(?: (?:{GROUNDS}))?": SLIDES,
    rf"(?:move|go|rise|climb|slide) (?:up|upwards|uphill)(?: (?:{GROUNDS}))? (?:at|with) constant (?:speed"
    rf"|velocity)": CLIMBS,
    rf"(?:move|go|sink|descend|slide) (?:down|downwards|downhill)(?: (?:{GROUNDS}))? (?:at|with) constant"
    r" (?:speed|velocity)": DESCENDS,
    r"(?:stay|remain|keep|rest|lie|hold|stop)(?: at rest)? (?:for good )?(?:at|on|in) (?:its )?(?:highest point"
    r"|top|turning point|upper turning point|highest position)"
    r"|(?:stay|remain)(?: at rest)? (?:there|where it stop|after it stop)(?: for good)?|not (?:slide|slip|move"
    r"|come) (?:back|down)(?: again)?(?: (?:down|after it stop))?": STAYS,
    rf"(?:not|without) (?:begin |start )?(?:to )?(?:pull|move|slide|go|climb|rise|lift|haul|drag|draw)(?: {_S})?"
    rf" (?:up|upwards|uphill)(?: (?:{GROUNDS}))?": SINKS,
    rf"(?:not (?:begin |start )?(?:to )?(?:slip|slide|skid)|without (?:slip|slide|skid)(?:ping)?|(?:no|never)"
    rf" (?:slip|slide|skid)(?:ping)?)"
    rf"{_ON}|roll(?: purely| without (?:slip|slide|skid)(?:ping)?){_ON}|roll rather than slide|move together"
    rf"|stick together": HOLDS,
    rf"(?:(?:remain|stay|keep|hold|leave|be|lie|sit|hang) )?{_AT_REST}{_ON}|(?:not (?:begin |start )?(?:to )?"
    rf"|nothing (?:will |would )?)(?:move|accelerate|happen){_ON}|remain where"
    rf"|(?:hold|keep|stay|remain|leave)(?: {_S})? (?:where|in place)(?: (?:it|they|{_S}))?"
    rf"|balance(?: {_S})?|(?:move|go|rise|fall|descend|climb|slide)(?: (?:up|down)(?: (?:{GROUNDS}))?)? (?:at"
    rf"|with) constant (?:speed|velocity)"
    r"|not accelerate|no acceleration|without acceleration": RESTS,
    rf"(?:(?:begin|start|be able) (?:to )?)?(?:move|slide|go|climb|rise|lift|haul|drag|pull) (?:up|upwards"
    rf"|uphill)(?: (?:{GROUNDS}))?"
    r"|(?:begin|start) (?:to )?(?:rise|climb|ascend|lift)": RISES,
    rf"(?:begin|start) (?:to )?(?:slip|slide|move|skid){_ON}|set in motion|(?:slip|move|slide|budge){_ON}": SLIPS,
    rf"(?:(?:go|swing|turn|move|get|carry|travel|come|take|make|complete|perform|describe|execute|rotate|loop) )*"
    rf"(?:(?:over|past|through|reach|beyond|to|at least) (?:top|highest point|vertical)(?: of (?:circle|path|its"
    rf" path))?"
    rf"|(?:all way |right )?(?:round |around )?(?:in |through )?(?:(?:full|complete|whole|one|vertical) )+{_ROUND}"
    r"|(?:all way|right) (?:round|around)(?: (?:in |along )?"
    r"(?:(?:full|complete|vertical|whole) )*circle)?|loop (?:loop|round)|full circle)": ROUND,
    r"(?:stay|remain|keep|be) (?:always )?taut|not (?:go|become|get) slack|never (?:go|become|get) slack": TAUT,
    r"(?:go|become|get) slack": SLACK,
    rf"(?:escape|break free|get away|leave|fly away|break away|depart)(?: from(?: (?:{_S}|its gravity|gravity))?|"
    rf" {_S})?(?: for ever| forever| for good| altogether| to infinity| completely| entirely| and never (?:come"
    rf" back|return))?"
    r"|never (?:return|come back)|get infinitely far(?: away)?|reach infinity|unbound|not (?:return|come back)"
    r"|not bound|move (?:along|on|in) parabola"
    r"|(?:parabolic|open) (?:orbit|path)": ESCAPES,
    rf"(?:remain|stay|be|keep)? ?bound(?: to {_S})?|not escape(?: from {_S})?": BOUND,
    rf"(?:move|go|travel|orbit|revolve|be)?(?: {_S})? ?(?:round|around|about)? ?(?:{_S})? ?(?:in|on|along)?"
    rf" ?(?:its )?circular (?:orbit|path)"
    rf"|orbit be circular|describe circle(?: (?:about|around|round) {_S})?"
    rf"|(?:move|go|orbit|travel)(?: (?:round|around|about))?(?: {_S})? (?:in|on|along)"
    rf" circle(?: (?:about|around|round) {_S})?": CIRCULAR,
    rf"(?:lift off|take off|rise|leave (?:{GROUNDS})|lift|start (?:to )?rise|leave)(?: (?:from )?(?:{GROUNDS}"
    rf"|pad))?(?: (?:straight away|at once|immediately|right away"
    r"|as soon as engine (?:start|ignite)|when engine (?:start|ignite)|without delay|on ignition|at ignition))?": LIFTS,
}
"""Outcomes, by the pattern of a condition in base forms."""


_LOOSE = frozenset(
    re.split(
        " ",
        "for so that such with in order to it its they them everything all system whole is be just still to and"
        " at on if then able"
        " ever can of start order both body object in total be always throughout permanently thing right from",
    )
)
_ROLLS = frozenset({"roll", "go", "keep", "continue", "down", "up", "along", "this", "all", "way", "pure", "purely"})
_TAUT_TOO = re.compile(
    rf"(?: ,)? (?:with|and|while|without)(?: {_S}| string| its string)?(?: (?:always|still|being|staying"
    rf"|remaining|keep|stay|remain|remaining|never))*"
    rf" (?:taut|slack|going slack|go slack)(?: (?:throughout|all time|all while|all way|always))?$"
    rf"|(?: ,)? without {_S} (?:ever )?(?:going|becoming) slack$"
)
_START = re.compile(
    rf"(?: ,)? (?:when|after|once|as soon as|if|on|upon)(?: (?:its|their|system|everything|it|they|{_S}|all))?"
    rf"(?: (?:is|are|has been|being|was|were))? (?:{pattern('START').pattern}|let go of|set free|freed|let"
    rf" loose)(?: from rest)?$"
    r"|(?: ,)? (?:on|right from|from|straight after|right after) (?:release|start|beginning|very beginning)$"
    r"|(?<=at rest) (?:where @\d+@|where it|where they)(?: (?:is|are|was|were|lies|is placed|is put|is now))?(?:"
    r" at start)?$"
    r"|(?<=was) at start$|(?<=were) at start$"
    r"|(?: ,)? from (?:its |this |that )?(?:initial|starting|original|present|same|first)? ?(?:position|point"
    r"|place|height)$"
    r"|(?: ,)? (?:in|at) (?:its|this|that|their|initial|starting|same|present) ?(?:initial|starting|original"
    r"|own)? ?(?:position|point|place|positions)$"
    r"|(?: ,)? wherever @\d+@ is released$|(?: ,)? in any position$|(?: ,)? wherever it is released$"
)
_TURNED = re.compile(r" instead of (?:slide|roll|fall|go|move)(?: back)?(?: down)?(?: again)?$")


class StatedCondition(NamedTuple):
    """A condition: an outcome with its subject, or a question with its required answer.

    With a `factor`, the answer is to be that factor times the answer in the scene as it is. The phrases `moving` name
    bodies that are to move meanwhile. With `taut`, a string is to stay taut as well.
    """

    outcome: str = ""
    subject: str = ""
    question: str = ""
    stated: str = ""
    taut: bool = False
    factor: float = 0.0
    moving: tuple[str, ...] = ()


_CAUSING = (
    r"(?:make|makes|made|let|lets|cause|causes|allow|allows|enable|enables|get|gets|set|sets|permit"
    r"|permits|keep|keeps|kept|carry|carries|carried|take|takes|taken|bring|brings|brought|leave|leaves|lift"
    r"|lifts|hold|holds|send|sends|put|puts)"
)


_STEMS = {
    done.removesuffix("ed"): factor for done, factor in FACTORS_BY_PARTICIPLE.items() if " " not in done
}  # *halv*, *doubl*
_AS_LARGE = (
    r" (?:as (?:large|great|big|high|long|strong|much|fast)|(?:its|their) (?:present|original|given|actual) value"
    r"|what it is"
    r"|its value)(?: (?:as )?(?:now|before|it is|it is now|at present|in scene|given))?"
)
_MULTIPLES = (
    rf"(?P<verb>{'|'.join(_STEMS)})(?:es|e) (?P<what>[^#]+)",
    rf"(?P<what>[^#]+?) (?:to )?be (?P<verb>{'|'.join(_STEMS)})ed",
    rf"(?P<what>[^#]+?) (?:to )?be (?P<mult>{'|'.join(MULTIPLES)}){_AS_LARGE}",
)
"""Statements that a quantity is to change by a factor, such as *doubles its speed* or *its speed be halved*."""


def _factor(match: re.Match[str]) -> float:
    groups = match.groupdict()
    if groups.get("verb"):
        return _STEMS[groups["verb"]]
    return next(value for regex, value in MULTIPLES.items() if re.fullmatch(regex, groups["mult"]))


def read_conditions(text: str, subject: str, sentence: TokenizedSentence) -> Iterator[StatedCondition]:
    """Yield the conditions that a clause may state, as an outcome or as results; nothing if a word is left over."""
    statement = _statement(text, subject)
    outcome = _outcome(statement, sentence)
    if outcome is not None:
        yield outcome
        return
    for regex in _MULTIPLES:
        match = re.fullmatch(regex, statement)
        if match is not None:
            yield StatedCondition(question=f"what is {match['what']}", factor=_factor(match))
            return
    for question, stated in asked_by(statement, sentence):
        yield StatedCondition(question=question, stated=stated)


_NO_VERB = (
    r"(?!(?:come|get|go|rise|swing|fall|drop|climb|sink|move|slow|grow|begin|start|turn)\b)"  # of which *to* is part
)
_EMPTY = re.compile(
    r"\b(?:just|exactly|precisely|barely|only(?! @)|still|yet|in fact|actually|then|ever|at all|possibly)\b ?"
)


def _statement(text: str, subject: str) -> str:
    """Return a clause such as *for A to slip* as a statement that begins with its subject, *A slip*."""
    statement = re.sub(r"^(?:for|that|so that|suppose|to) ", "", text)
    statement = plainer_condition(statement)
    statement = re.sub(r"\b(?:would|could|should|might|must) have (?=\w+(?:ed|t|n|ne)\b)", "", statement)
    if subject:
        statement = re.sub(r"^(its|their) (?:own )?(?=[a-z])", f"{subject} 's ", statement)
    statement = _EMPTY.sub("", statement)
    gets = re.match(r"(?:ensures? that|prevents?) (?P<rest>.+)", statement)
    if gets is not None and statement.startswith("prevent"):
        statement = re.sub(rf"^prevents? ({_S}) from (\w+)", r"\1 not \2", statement)
    elif gets is not None:
        statement = gets["rest"]
    statement = re.sub(rf"^(?:(?:would|will|to) )?(?:give|gives|given) ({_S}|it) ", r"\1 have ", statement)
    statement = re.sub(
        rf"^(?:will |would |to )?{_CAUSING} (?=(?:{_S}(?= |$)|(?:(?:greatest|least|maximum|minimum|final|initial)"
        rf" )*(?:its|it|system|everything|period|both|all|{pattern('QUANTITY').pattern})\b))",
        "",
        statement,
    )
    statement = re.sub(rf"^(?:does|do|did|will|would|should|must|can|could|is|are) (?={_S})", "", statement)
    statement = re.sub(
        r"\b(?:is|are|was|were|has|have) (?:not )?to (?=\w)",
        lambda f: "not " if " not " in f[0] else "",
        statement,
        count=1,
    )
    statement = re.sub(
        rf"^((?:{_S}|{_NO_VERB}\w+)(?: and {_S})?) (?:should|would|must|will|can|could|to|does|do|shall|may)(?:"
        rf" (not))? ",
        lambda f: f"{f[1]} {'not ' if f[2] else ''}",
        statement,
    )
    statement = re.sub(rf"^((?:{_S}|it|\w+)) not to ", r"\1 not ", statement)
    has_subject = re.match(rf"(?:{_S}|it\b)|(?:\w+ ){{0,3}}(?:of|in) @", statement) is not None
    if subject and not has_subject and "'s" not in statement[:8]:
        statement = f"{subject} {statement}" if _is_predicate(statement) else statement
    return " ".join(re.sub(r"^it\b", subject or "it", statement).split())


def _is_predicate(clause: str) -> bool:
    """Return whether a clause begins with a verb, so that it lacks its subject."""
    return pattern("QUANTITY").match(clause) is None and not re.match(
        r"(?:its|their|system|everything|all|both|period|it|greatest|least|maximum|minimum|final|initial|largest"
        r"|highest"
        r"|lowest|smallest|top|amplitude|frequency)\b",
        clause,
    )


_GOES = rf"(?:move|fall|rise|accelerate|drop|sink|slide)s?(?: (?:on|over|along) (?:it|{_S}|top of {_S}))?"
_MEANWHILE = re.compile(
    rf"(?: ,)? (?:while|as) (?P<who>{_S}(?: and {_S})?) (?:{_GOES})(?: and (?P<other>{_S}) (?:{_GOES}))?$"
)


def _outcome(statement: str, sentence: TokenizedSentence) -> StatedCondition | None:
    """Return the condition of a statement that names an outcome, if this accounts for every word; else None."""
    bare = _TAUT_TOO.sub("", statement)
    taut = bare != statement
    meanwhile = _MEANWHILE.search(bare)
    who = f"{meanwhile['who']} {meanwhile['other'] or ''}" if meanwhile is not None else ""
    moving = tuple(map(sentence.subject, re.findall(_S, who)))
    bare = _MEANWHILE.sub("", bare)
    while (shorter := _START.sub("", bare)) != bare:
        bare = shorter
    based_on = with_base_forms(bare)
    based_on = _TURNED.sub("", based_on)
    subjects = list(dict.fromkeys(re.findall(_S, bare)))
    for regex, outcome in PHRASES.items():
        match = re.search(rf"(?<![\w@#])(?:{regex.replace('{S}', _S)})(?![\w@#])", based_on)
        if match is None:
            continue
        rest = re.sub(_S, " ", f"{based_on[: match.start()]} {based_on[match.end() :]}")
        loose = _LOOSE | _ROLLS if outcome == HOLDS else _LOOSE
        if set(re.sub(rf"\b(?:{GROUNDS})\b", " ", rest).replace(",", " ").split()) - loose or len(subjects) > 2:
            continue
        before = based_on[: match.start()]
        both = re.search(rf"({_S}) and ({_S})", before)
        first = re.search(_S, before)
        who = first[0] if first is not None else subjects[0] if subjects else ""
        named = (
            f"{ALL_WORD} {sentence.subject(both[1])} & {sentence.subject(both[2])}"
            if both is not None
            else sentence.subject(who or None)
        )
        stated = re.findall(r"#\d+#", match[0])
        return StatedCondition(
            outcome, named, stated=sentence.number(stated[0]) if stated else "", taut=taut, moving=moving
        )
    return None
