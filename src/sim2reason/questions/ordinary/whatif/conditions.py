"""Conditions that a number of the scene is to meet: outcomes by name, and results as questions with stated answers."""

import re
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from sim2reason.questions.ordinary.base_forms import based
from sim2reason.questions.ordinary.hearing import ALL, Heard
from sim2reason.questions.ordinary.vocabulary import GROUNDS, pattern

RESTS, HOLDS, STAYS, SLIPS, RISES, SINKS, ROUND = "rests", "holds", "stays", "slips", "rises", "does not rise", "round"
TAUT, SLACK, ESCAPES, BOUND, CIRCULAR, LIFTS = "taut", "slack", "escapes", "bound", "circular", "lifts off"
"""What a condition may say comes about: *holds* is that nothing slips, *stays* that it rests where it first stops."""
_S = r"@\d+@"
_ROUND = "(?:turn|circle|revolution|loop|round|rotation)"
_ON = rf"(?: (?:on|along|over) (?:(?:this |its )?(?:{GROUNDS})|{_S}|top of {_S}))?"
_AT_REST = "(?:at rest|in equilibrium|in balance|motionless|stationary|balance[d]?|put|still|where (?:it|they|{S}))"
PHRASES: Mapping[str, str] = {
    r"(?:stay|remain|keep|rest|lie|hold|stop)(?: at rest)? (?:for good )?(?:at|on|in) (?:its )?(?:highest point|top|turning point|upper turning point|highest position)"
    r"|(?:stay|remain)(?: at rest)? (?:there|where it stop|after it stop)(?: for good)?|not (?:slide|slip|move|come) (?:back|down)(?: again)?(?: (?:down|after it stop))?": STAYS,
    rf"(?:not|without) (?:begin |start )?(?:to )?(?:pull|move|slide|go|climb|rise|lift|haul|drag|draw)(?: {_S})? (?:up|upwards|uphill)(?: (?:{GROUNDS}))?": SINKS,
    rf"(?:not (?:begin |start )?(?:to )?(?:slip|slide|skid)|without (?:slip|slide|skid)(?:ping)?|(?:no|never) (?:slip|slide|skid)(?:ping)?)"
    rf"{_ON}|roll(?: purely| without (?:slip|slide|skid)(?:ping)?){_ON}|roll rather than slide|move together|stick together": HOLDS,
    rf"(?:(?:remain|stay|keep|hold|leave|be|lie|sit|hang) )?{_AT_REST}{_ON}|(?:not (?:begin |start )?(?:to )?|nothing (?:will |would )?)(?:move|accelerate|happen){_ON}|remain where"
    rf"|(?:hold|keep|stay|remain|leave)(?: {_S})? (?:where|in place)(?: (?:it|they|{_S}))?"
    rf"|balance(?: {_S})?|(?:move|go|rise|fall|descend|climb|slide)(?: (?:up|down)(?: (?:{GROUNDS}))?)? (?:at|with) constant (?:speed|velocity)"
    r"|not accelerate|no acceleration|without acceleration": RESTS,
    rf"(?:(?:begin|start|be able) (?:to )?)?(?:move|slide|go|climb|rise|lift|haul|drag|pull) (?:up|upwards|uphill)(?: (?:{GROUNDS}))?"
    r"|(?:begin|start) (?:to )?(?:rise|climb|ascend|lift)": RISES,
    rf"(?:begin|start) (?:to )?(?:slip|slide|move|skid){_ON}|set in motion|slip{_ON}": SLIPS,
    rf"(?:(?:go|swing|turn|move|get|carry|travel|come|take|make|complete|perform|describe|execute|rotate|loop) )*"
    rf"(?:(?:over|past|through|reach|beyond|to|at least) (?:top|highest point|vertical)(?: of (?:circle|path|its path))?"
    rf"|(?:all way |right )?(?:round |around )?(?:in |through )?(?:(?:full|complete|whole|one|vertical) )+{_ROUND}"
    r"|(?:all way|right) (?:round|around)|loop (?:loop|round)|full circle)": ROUND,
    r"(?:stay|remain|keep|be) (?:always )?taut|not (?:go|become|get) slack|never (?:go|become|get) slack": TAUT,
    r"(?:go|become|get) slack": SLACK,
    rf"(?:escape|break free|get away|leave|fly away|break away|depart)(?: from(?: (?:{_S}|its gravity|gravity))?| {_S})?(?: for ever| forever| for good| altogether| to infinity| completely| entirely)?"
    r"|never (?:return|come back)|get infinitely far(?: away)?|reach infinity|unbound|not (?:return|come back)|not bound|move (?:along|on|in) parabola"
    r"|(?:parabolic|open) (?:orbit|path)": ESCAPES,
    rf"(?:remain|stay|be|keep)? ?bound(?: to {_S})?|not escape(?: from {_S})?": BOUND,
    rf"(?:move|go|travel|orbit|revolve|be)?(?: {_S})? ?(?:round|around|about)? ?(?:{_S})? ?(?:in|on|along)? ?(?:its )?circular (?:orbit|path)"
    rf"|orbit be circular|(?:move|go|orbit|travel)(?: (?:round|around|about))?(?: {_S})? (?:in|on|along) circle(?: (?:about|around|round) {_S})?": CIRCULAR,
    rf"(?:lift off|take off|rise|leave (?:{GROUNDS})|lift|start (?:to )?rise|leave)(?: (?:from )?(?:{GROUNDS}|pad))?(?: (?:straight away|at once|immediately|right away"
    r"|as soon as engine (?:start|ignite)|when engine (?:start|ignite)|without delay|on ignition|at ignition))?": LIFTS,
}
"""By the base form of a condition, the outcome."""
_LOOSE = frozenset(
    re.split(
        " ",
        "for so that such with in order to it its they them everything all system whole is be just still to and at on if then able"
        " ever can of start order both body object in total be always throughout permanently",
    )
)
_ROLLS = frozenset({"roll", "go", "keep", "continue", "down", "up", "along", "this", "all", "way", "pure", "purely"})
_TAUT_TOO = re.compile(
    rf"(?: ,)? (?:with|and|while|without)(?: {_S}| string| its string)?(?: (?:always|still|being|staying|remaining|keep|stay|remain|remaining|never))*"
    rf" (?:taut|slack|going slack|go slack)(?: (?:throughout|all time|all while|all way|always))?$"
    rf"|(?: ,)? without {_S} (?:ever )?(?:going|becoming) slack$"
)
_START = re.compile(
    rf"(?: ,)? (?:when|after|once|as soon as|if|on|upon)(?: (?:its|their|system|everything|it|they|{_S}|all))?"
    rf"(?: (?:is|are|has been|being|was|were))? (?:{pattern('START').pattern}|let go of|set free|freed|let loose)(?: from rest)?$"
    r"|(?: ,)? from (?:its |this |that )?(?:initial|starting|original|present|same|first)? ?(?:position|point|place|height)$"
    r"|(?: ,)? (?:in|at) (?:its|this|that|their|initial|starting|same|present) ?(?:initial|starting|original|own)? ?(?:position|point|place|positions)$"
    r"|(?: ,)? wherever @\d+@ is released$|(?: ,)? in any position$|(?: ,)? wherever it is released$"
)


_TURNED = re.compile(r" instead of (?:slide|roll|fall|go|move)(?: back)?(?: down)?(?: again)?$")


class Condition(NamedTuple):
    """What is to be so: an outcome by its name, and of what; or a question with the number that is to be its answer."""

    outcome: str = ""
    subject: str = ""
    question: str = ""
    stated: str = ""
    taut: bool = False


def conditions(text: str, subject: str, heard: Heard) -> Iterator[Condition]:
    """Yield what a clause says is to be so, as an outcome or else as a result; nothing if no word of it is left over."""
    said = _statement(text, subject)
    outcome = _outcome(said, heard)
    if outcome is not None:
        yield outcome
        return
    for question, stated in asked_by(said, heard):
        yield Condition(question=question, stated=stated)


def _statement(text: str, subject: str) -> str:
    """Return a clause as a statement that begins with its subject, without what turns it into a wish."""
    said = re.sub(r"^(?:for|that|so that|suppose|to) ", "", text)
    said = re.sub(r"\b(?:would|could|should|might|must) have (?=\w+(?:ed|t|n|ne)\b)", "", said)
    if subject:
        said = re.sub(r"^(its|their) (?:own )?(?=[a-z])", f"{subject} 's ", said)
    said = re.sub(r"\b(?:just|exactly|precisely|barely|only|in fact|actually|then|ever|at all|possibly)\b ?", "", said)
    gets = re.match(r"(?:ensures? that|prevents?) (?P<rest>.+)", said)
    if gets is not None and said.startswith("prevent"):
        said = re.sub(rf"^prevents? ({_S}) from (\w+)", r"\1 not \2", said)
    elif gets is not None:
        said = gets["rest"]
    said = re.sub(rf"^(?:(?:would|will|to) )?(?:give|gives|given) ({_S}|it) ", r"\1 have ", said)
    causing = r"(?:make|makes|made|let|lets|cause|causes|allow|allows|enable|enables|get|gets|set|sets|permit|permits|keep|keeps|kept|carry|carries|carried|take|takes|taken|bring|brings|brought|leave|leaves|lift|lifts|hold|holds|send|sends)"
    said = re.sub(rf"^(?:will |would |to )?{causing} (?=(?:{_S}(?= |$)|(?:(?:greatest|least|maximum|minimum|final|initial) )*(?:its|it|system|everything|period|both|all|{pattern('QUANTITY').pattern})\b))", "", said)
    said = re.sub(rf"^(?:does|do|did|will|would|should|must|can|could|is|are) (?={_S})", "", said)
    said = re.sub(r"\b(?:is|are|was|were|has|have) (?:not )?to (?=\w)", lambda f: "not " if " not " in f[0] else "", said, count=1)
    said = re.sub(rf"^((?:{_S}|\w+)(?: and {_S})?) (?:should|would|must|will|can|could|to|does|do|shall|may)(?: (not))? ", lambda f: f"{f[1]} {'not ' if f[2] else ''}", said)
    said = re.sub(rf"^((?:{_S}|it|\w+)) not to ", r"\1 not ", said)
    if subject and not re.match(rf"(?:{_S}|it\b)", said) and not re.match(r"(?:\w+ ){0,3}(?:of|in) @", said) and "'s" not in said[:8]:
        said = f"{subject} {said}" if _is_predicate(said) else said
    return " ".join(re.sub(rf"^it\b", subject or "it", said).split())


def _is_predicate(said: str) -> bool:
    """Return whether a clause begins with a verb, so that it lacks its subject."""
    return pattern("QUANTITY").match(said) is None and not re.match(r"(?:its|their|system|everything|all|both|period|it)\b", said)


def _outcome(said: str, heard: Heard) -> Condition | None:
    """Return the outcome that a statement says, if every word of the statement has its place."""
    bare = _TAUT_TOO.sub("", said)
    taut = bare != said
    bare = re.sub(rf"(?: ,)? (?:while|as) {_S}(?: and {_S})? (?:move|fall|rise|accelerate)s?$", "", bare)
    while (shorter := _START.sub("", bare)) != bare:
        bare = shorter
    based_on = based(bare)
    based_on = _TURNED.sub("", based_on)
    subjects = list(dict.fromkeys(re.findall(_S, bare)))
    for told, outcome in PHRASES.items():
        found = re.search(rf"(?<![\w@#])(?:{told.replace('{S}', _S)})(?![\w@#])", based_on)
        if found is None:
            continue
        rest = re.sub(_S, " ", f"{based_on[: found.start()]} {based_on[found.end() :]}")
        loose = _LOOSE | _ROLLS if outcome == HOLDS else _LOOSE
        if set(re.sub(rf"\b(?:{GROUNDS})\b", " ", rest).replace(",", " ").split()) - loose or len(subjects) > 2:
            continue
        before = based_on[: found.start()]
        both = re.search(rf"({_S}) and ({_S})", before)
        first = re.search(_S, before)
        who = first[0] if first is not None else subjects[0] if subjects else ""
        named = f"{ALL} {heard.subject(both[1])} & {heard.subject(both[2])}" if both is not None else heard.subject(who or None)
        return Condition(outcome, named, taut=taut)
    return None


_N = r"(?P<n>#\d+#)"
_ABOUT = r"(?:(?:exactly|just|only|about|at least|at most|no more than|up to) )?"
_Q = "QUANTITY"
_VERB = r"[a-z]+"
RESULTS = (
    (rf"(?P<what>(?:[a-z]+ )*?(?:{_S} 's |its )?(?:[a-z]+ )*?(?:{_Q}|period|centre of mass)(?: (?:of|in|on|between|acting on|exerted on|for|at|when|after|before|just|as) .+?)?) (?:(?:(?:to )?(?:be|is|become|becomes|reach|reaches|equal|equals|amount to|have value of|come to|are)) )?(?:equal to )?{_ABOUT}{_N}(?P<rest>.*)",
     "what is {what}{rest}"),
    (rf"(?P<s>{_S}) (?:have|has|attain|attains|reach|reaches|acquire|acquires|get|gets|gain|gains|move with|moves with|be given|feel|feels|experience|experiences) (?P<what>(?:[a-z]+ )??{_Q}) of {_ABOUT}{_N}(?P<rest>.*)",
     "what is {what} of {s}{rest}"),
    (rf"(?P<s>{_S}) (?:oscillate|oscillates|swing|swings|vibrate|vibrates|move|go round|revolve|revolves|go to and fro) (?:to and fro )?(?:with|at) (?P<what>period|frequency) of {_ABOUT}{_N}(?P<rest>)", "what is {what} of {s}"),
    (rf"(?P<s>{_S}) (?:have|has) (?P<what>period|frequency) of {_ABOUT}{_N}(?P<rest>)", "what is {what} of {s}"),
    (rf"(?P<s>{_S}) (?:accelerate|accelerates|be accelerated) (?:(?P<way>up|down|upwards|downwards) (?:{GROUNDS} )?)?(?:at|with) {_ABOUT}{_N}(?P<rest>.*)",
     "what is acceleration of {s} {way}{rest}"),
    (rf"(?P<s>{_S}) (?:rise|rises|go up|move up|climb) with acceleration of {_ABOUT}{_N}(?P<rest>.*)", "what is acceleration of {s} upwards{rest}"),
    (rf"(?P<s>{_S}) (?:fall|falls|sink|sinks|descend|descends|go down|move down|drop) with acceleration of {_ABOUT}{_N}(?P<rest>.*)", "what is acceleration of {s} downwards{rest}"),
    (rf"(?P<s>{_S}) (?:move|moves|start|starts|go) (?:off )?with acceleration of {_ABOUT}{_N}(?P<rest>.*)", "what is acceleration of {s}{rest}"),
    (rf"(?P<what>(?:{_S} 's |its )?(?:[a-z]+ )??{_Q}) of {_ABOUT}{_N}(?P<rest>.*)", "what is {what}{rest}"),
)  # fmt: skip
SPEEDS = (
    (rf"(?P<s>{_S}) (?:move|moves|be moving|travel|travels|go|be going|is moving|slide|fly) (?:at|with) (?:(?:speed|velocity) of )?{_ABOUT}{_N}(?P<rest>.*)", "how fast is {s} moving{rest}"),
    (rf"(?P<s>{_S}) (?P<verb>{_VERB})(?P<pred> .+?)? (?:at|with) (?:(?:speed|velocity) of )?{_ABOUT}{_N}(?P<rest>.*)", "with what speed does {s} {verb}{pred}{rest}"),
    (rf"(?P<s>{_S}) (?:reach|reaches|attain|attains) {_ABOUT}{_N}(?P<rest> .+)", "how fast is {s} moving{rest}"),
    (rf"(?P<s>{_S}) (?:reach|reaches|attain|attains|have|has|get to) (?:(?:greatest|maximum|top) )(?:speed|velocity) of {_ABOUT}{_N}(?P<rest>)", "what is greatest speed of {s}"),
    (rf"(?P<s>{_S}) (?:reach|reaches|attain|attains|get to) (?:(?:speed|velocity) of )?{_ABOUT}{_N}(?P<rest>)", "what is greatest speed of {s}"),
    (rf"(?P<s>{_S}) (?:reach|reaches|attain|attains) (?:final|terminal) (?:speed|velocity) of {_ABOUT}{_N}(?P<rest>)", "what is final speed of {s}"),
)  # fmt: skip
TIMES = (
    (rf"(?P<s>{_S}) (?:go|goes|revolve|circle|orbit)(?: (?:round|around))?(?: once)? in {_ABOUT}{_N}(?P<rest>)", "what is period of {s}"),
    (rf"(?P<s>{_S}) (?P<verb>{_VERB})(?P<pred> .+?)? (?:in|after|within) {_ABOUT}{_N}(?: (?:after start|after release|from start))?(?P<rest>)", "how long does {s} take to {verb}{pred}"),
    (rf"(?P<s>{_S}) (?:take|takes|need|needs|require|requires) {_ABOUT}{_N} to (?P<verb>{_VERB})(?P<pred> .+)?(?P<rest>)", "how long does {s} take to {verb}{pred}"),
    (rf"it (?:take|takes) {_ABOUT}{_N} for (?P<s>{_S}) to (?P<verb>{_VERB})(?P<pred> .+)?(?P<rest>)", "how long does {s} take to {verb}{pred}"),
    (rf"(?P<s>{_S}) (?:stay|stays|remain|remains|be|is) (?:in (?:air|flight)|airborne) for {_ABOUT}{_N}(?P<rest>)", "how long is {s} in air"),
    (rf"(?P<s>{_S}) (?:complete|make|go through) (?P<pred>.+?) in {_ABOUT}{_N}(?P<rest>)", "how long does {s} take to complete {pred}"),
)  # fmt: skip
LENGTHS = (
    (rf"(?P<s>{_S}) (?:reach|reaches|rise to|rises to|get to|attain|climb to|rise up to) (?:(?:maximum|greatest) )?height of {_ABOUT}{_N}(?P<rest>.*)", "how high does {s} rise{rest}"),
    (rf"(?P<s>{_S}) (?:rise|rises|get|go|climb) {_ABOUT}{_N} high(?P<rest>.*)", "how high does {s} rise{rest}"),
    (rf"(?P<s>{_S}) (?P<verb>{_VERB}) (?:distance of )?{_ABOUT}{_N} (?P<dir>away|far)(?P<rest>.*)", "how far away does {s} {verb}{rest}"),
    (rf"(?P<s>{_S}) (?:rise|rises|climb|bounce|rebound) (?:up )?(?:to )?(?:height of )?{_ABOUT}{_N}(?: high)?(?P<rest>.*)", "how high does {s} rise{rest}"),
    (rf"(?P<s>{_S}) (?P<verb>{_VERB}) (?:distance of )?{_ABOUT}{_N}(?P<rest>.*)", "how far does {s} {verb}{rest}"),
    (rf"(?P<s>{_S}) (?P<verb>{_VERB}) (?P<pred>(?:at|to|up|down|through|on|over).*?) {_ABOUT}{_N}(?P<rest>.*)", "how far does {s} {verb} {pred}{rest}"),
    (rf"(?P<s>{_S}) (?P<verb>{_VERB})(?: first)? (?:at|over|by) (?:horizontal )?distance of {_ABOUT}{_N}(?: (?:away|from {_S}))?(?P<rest>.*)", "how far away does {s} {verb}{rest}"),
    (rf"(?P<s>{_S}) (?:be|is|get) (?P<how>compressed|stretched|extended) by {_ABOUT}{_N}(?P<rest>.*)", "by how much is {s} {how}{rest}"),
    (rf"(?P<s>{_S}) compress (?P<t>{_S}) by {_ABOUT}{_N}(?P<rest>)", "what is greatest compression of {t}"),
)  # fmt: skip
ANGLES = (
    (rf"(?P<s>{_S}) (?P<verb>{_VERB}) (?:(?:through|up to|by|out to) )?(?:angle of )?{_ABOUT}{_N}(?P<rest>.*)", "through what angle does {s} {verb}{rest}"),
)  # fmt: skip
"""By the form of a statement with a number, the question that asks for the number."""
OF_UNITS = {"m/s": SPEEDS, "km/s": SPEEDS, "au/yr": SPEEDS, "s": TIMES, "yr": TIMES, "ms": TIMES, "°": ANGLES, "rad": ANGLES}
OF_UNITS |= dict.fromkeys(("m", "cm", "mm", "km", "au"), LENGTHS)


def asked_by(said: str, heard: Heard) -> Iterator[tuple[str, str]]:
    """Yield each question that a statement with a number answers, with the number and its unit."""
    tokens = re.findall(r"#\d+#", said)
    for token in dict.fromkeys(tokens):
        number = heard.number(token)
        unit = number.partition(" ")[2]
        for told, question in (*RESULTS, *OF_UNITS.get(unit, ())):
            found = re.fullmatch(told.replace(_N, token).replace(_Q, pattern("QUANTITY").pattern), said)
            if found is not None:
                groups = {name: group or "" for name, group in found.groupdict().items()}
                if verb := groups.get("verb"):
                    groups["verb"] = based(verb) or verb
                rest = groups.get("rest", "")
                groups["rest"] = rest if not rest or rest.startswith((" ", ",")) else f" {rest}"
                yield " ".join(question.format(**groups).split()), number
                if (told, question) in TIMES:
                    break
