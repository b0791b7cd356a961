"""Wording of questions for a number: plainer equivalents, and hints such as *a heavier block*."""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from sim2reason.questions.following import FollowedMotion
from sim2reason.questions.ordinary.hearing import TokenizedSentence
from sim2reason.questions.ordinary.vocabulary import GROUNDS, compiled
from sim2reason.questions.ordinary.whatif.frames import WantedFrame
from sim2reason.questions.ordinary.whatif.numbers import NUMBERS
from sim2reason.questions.ordinary.whatif.turns_of_limits import LIMIT_TURNS
from sim2reason.questions.ordinary.whatif.turns_of_need import NEED_REWORDINGS
from sim2reason.questions.unknown import number_at

_NOUNS = "|".join(kind.nouns for kind in NUMBERS.values())
_SAME = "(?:same|unchanged|present|given|original|this same|that same)"
_ELSE = (
    "(?:all|everything|every thing|other things|all other (?:data|numbers|values|quantities|things)|nothing"
    "|rest|other data)"
)
_HELD = "(?:kept|left|held|staying|remaining|kept at|being)"
_CONSTANT = re.compile(
    rf"(?: ,)? (?:,? ?(?:but|and) )?(?:at|with|for|from|in|under|keeping|starting (?:from|with|at)|leaving) {_SAME}"
    rf" (?:(?:{_NOUNS}|position|place"
    rf"|point|direction|way|start|compression|extension|stretch|initial compression|conditions)(?: and )?)+(?= "
    rf"|$)(?: ,)?"
    rf"|(?: ,)? (?:with |but )?(?:(?:its|their|initial|of|motion|launch) )*direction(?: of (?:motion|launch))?"
    rf" (?:{_HELD} )*(?:same|unchanged|as it is|as before)(?: ,)?"
    rf"|(?: ,)? (?:with |if |and |keeping |leaving )?{_ELSE} (?:else )?(?:is |are |being |remain |remains |stay "
    rf"|stays |kept |left )*"
    r"(?:unchanged|same|equal|changed|constant|as before|as they are|as it is|as given|fixed)(?: ,)?"
    r"|(?: ,)? \(?in (?:kg|kilograms|newtons|metres|seconds|kg/s|n|m/s|degrees)\)?(?: ,)?(?= |$)"
    r"|(?: ,)? (?:from|in|at) (?:its |this |that |their )?(?:initial|starting|original|present|same|own initial)"
    r" (?:position|point|place|height)(?= |$)"
    r"|(?: ,)? from (?:this|that) (?:position|point|place|height)(?= |$)"
    r"|^ ?suppose (?:that )?@\d+@ (?:could be|were|is|was) (?:swapped|replaced|exchanged|changed)[^.#]*\. "
    r"|^ ?suppose (?:that )?(?:@\d+@ (?:is|were|was|had|has) )?(?:(?:started|launched|thrown|released|in same way|but"
    r"|as before|round|around|with|of) |@\d+@ )*(?:different|another|other|some other) (?:mass|speed|stiffness|charge"
    r"|coefficient of friction|initial speed)\. "
    r"|\b(?:fully fuelled|fully fueled|fully loaded|bored) (?=@)"
    r"|(?: ,)? instead(?! of)(?: ,)?"
    rf"|(?: ,)? (?:with )?(?:its )?(?:{_NOUNS}) (?:{_HELD} )*(?:same|unchanged)(?:$| ,)"
)
"""Phrases that say only that everything else stays as it is, such as *at the same angle*."""

_AUX = "(?:would|must|should|could|will|does|can|has|might|may|did)"
_LEAST = "least|minimum|minimal|smallest|lowest"
_EACH = "(?:per second|each second|every second|in each second|in every second|second)"
_FUEL = "(?:fuel|propellant)"
_BURN = "(?:burn|consume|use|burn up|use up)"
_BURNT = "(?:burnt|burned|consumed|used|used up|burned up|burnt up)"
_ENGINE = r"(?:engine|it|@\d+@(?: 's engine)?)"
_HAVE = "(?:have to |need to |has to |needs to )?"
_LIKE = "(?:large|great|big|strong|high|small|low|steady|long)"
_FOR = "(?=for |so that |to |if |in order |before )"
_ADJECTIVES = {"heav(?:y|ier)|massive": "mass", "light(?:er)?": "mass", "stiff(?:er)?": "stiffness",
               "fast(?:er)?|slower": "speed", "steep(?:er)?": "slope"}  # fmt: skip
_GOES = "(?:be (?:(?:moving|thrown|launched|started|set off|sent off|projected) )?|start (?:off )?|move |go |travel )"
PLAINER_WORDINGS: Mapping[str, str] = {
    rf"\bvalue of (?=(?:@\d+@ 's )?(?:{_NOUNS})\b)": "",
    r"^(?:what|how large) (?P<s>@\d+@) (?=(?:would|must|does) (?P=s) (?:need|have|require)\b)": "what charge ",
    r"(?P<s>@\d+@) 's (?P=s)(?= (?:have|need|be))": r"charge of \g<s>",
    r"(?<= )(?P<s>@\d+@) (?P<n>mass|stiffness)(?= (?:would|must|should|for|with|at|does|is|that)\b)": r"\g<n> of \g<s>",
    r"\bheaviest (?P<s>@\d+@) (?=for which|with which|that)": r"greatest mass of \g<s> ",
    r"\blightest (?P<s>@\d+@) (?=for which|with which|that)": r"least mass of \g<s> ",
    r"\bin order not to ": "to not ",
    r"(?<=need) at (?:launch|start|release|first)(?= )": "",
    r"\bwhat mass (?P<a>must|would|should) (?:have to )?(?:hang|be hung|hung) at (?P<s>@\d+@) ": (
        r"what mass \g<a> \g<s> need "
    ),
    r"\bwhat mass (?:hung|hanging) at (?P<s>@\d+@) ": r"what mass of \g<s> ",
    r"\bleave thrower 's hand\b": "be thrown",
    rf"how fast {_AUX} (?:exhaust|gas|exhaust gas(?:es)?) {_HAVE}(?:leave|stream out of|flow out of) @\d+@ {_FOR}": (
        "what BOUND exhaust speed is needed "
    ),
    r"\bhave had to\b": "have to",
    r"^if (?P<s>@\d+@) (?:is|are|was|were) to (?P<c>[^,]+) , (?P<rest>(?:with|at|from|under|what|which|how|by) .+)$": (
        r"\g<rest> for \g<s> to \g<c>"
    ),
    r"^(?:in order )?to (?P<c>[^,]+) , (?P<rest>(?:with|at|from|under|what|which|how|by) .+)$": r"\g<rest> to \g<c>",
    r"\b(?P<ask>what|which) value of (?=coefficient|mass|speed|initial speed|force)": r"\g<ask> ",
    rf"(?P<n>\b(?:{_NOUNS})(?: of @\d+@)? (?:have|need) to be) at start (?=larger|greater|for |so )": r"\g<n> ",
    r" (?P<b>no more than|not more than) (?=#)": " at most ",
    r" (?:at|with) (?:this|that) (?:angle|speed|velocity|mass)(?= |$)": "",
    r"(?: ,)? (?:in|measured in) (?:rad/s|m/s|kg|n)(?: ,)?(?= )": "",
    r"(?: at most)? without (?P<s>@\d+@) (?P<verb>[a-z]+ing)\b": r" at most so that \g<s> not \g<verb>",
    r" , (?=(?:if|so that|in order|for) @)": " ",
    r"\b(?P<size>least|greatest|smallest|largest) value of (?=coefficient|mass|speed|initial speed"
    r"|force)": r"\g<size> ",
    r"\b(?:at (?:very )?least|at minimum)(?= [^,.]*\bat least\b)": "",
    r"\bat very (?=least\b)": "at ",
    r"\b(?:still|yet) (?=[a-z]+ @)": "",
    rf"\bhow {_LIKE} (?:of )?(?=(?:(?:steady|constant|horizontal|pulling|initial) )*(?:{_NOUNS})\b)": "what ",
    r"\b(?:steady|constant) (?=(?:horizontal )?(?:force|pull)\b)": "",
    rf"^(?:up to|below|under|beneath) (?:what|which) (?P<n>.+?) (?={_AUX} |is |are )": r"for what greatest \g<n> ",
    rf"^(?:above|beyond|over|exceeding) (?:what|which) (?P<n>(?:{_NOUNS}).*?) (?={_AUX} |is |are )": (
        r"for what least \g<n> "
    ),
    r"^(?:on|under|at|with) (?:what|which) (?=(?:inclination|slope|incline)\b)": "at what ",
    rf"^at least (?P<ask>(?:with |for |at )?what) (?=(?:{_NOUNS})\b)": r"\g<ask> least ",
    rf"^at most (?P<ask>(?:with |for |at )?what) (?=(?:{_NOUNS})\b)": r"\g<ask> greatest ",
    r"^at least (?P<ask>how (?:fast|heavy|stiff|large|great|strong|high|hard|rough|long|much"
    r"|many)\b)": r"LEAST \g<ask>",
    r"^at most (?P<ask>how (?:fast|heavy|stiff|large|great|strong|high|hard|rough|long|steep|light)\b)": (
        r"GREATEST \g<ask>"
    ),
    rf"how (?:many kg of|much) {_FUEL} (?:{_EACH} )?{_AUX} {_ENGINE} {_HAVE}{_BURN}(?: {_EACH})?(?P<b> at least)? "
    rf"{_FOR}": r"what BOUND burn rate is needed\g<b> ",
    rf"how (?:many kg of|much) {_FUEL} (?:{_EACH} )?{_AUX} {_HAVE}be {_BURNT}(?: {_EACH})?(?P<b> at least)? "
    rf"{_FOR}": r"what BOUND burn rate is needed\g<b> ",
    rf"at what (?P<size>(?:{_LEAST}) )?rate(?P<b> at least)? {_AUX} {_ENGINE} {_HAVE}(?:{_BURN}|eject) (?:its )?{_FUEL}"
    rf"(?P<c> at least)? {_FOR}": r"what BOUND \g<size>burn rate is needed\g<b>\g<c> ",
    rf"at what (?P<size>(?:{_LEAST}) )?rate(?P<b> at least)? {_AUX} (?:its )?{_FUEL} {_HAVE}be {_BURNT}"
    rf"(?P<c> at least)? {_FOR}": r"what BOUND \g<size>burn rate is needed\g<b>\g<c> ",
    rf"(?:how fast|(?:with|at) what speed) {_AUX} (?:exhaust )?gas(?:es)? {_HAVE}be (?:ejected|expelled|blown out"
    rf"|thrown"
    rf" out)(?P<b> at least)? {_FOR}": r"what BOUND exhaust speed is needed\g<b> ",
    rf"(?P<ratio>by (?:what|which) factor|how many times) {_AUX} (?:one|we|you) {_HAVE}(?:raise|increase|multiply"
    rf"|change)"
    rf" (?P<n>(?:its )?(?:{_NOUNS})(?: of @\d+@)?) {_FOR}": (r"\g<ratio> must \g<n> be increased "),
    rf"^how light (?P<aux>{_AUX}) (?P<s>@\d+@) (?P<b>be|have to be|need to be)(?: at start)?(?: at most)? "
    r"(?=for |so that |to |in order |and )": r"what greatest mass \g<aux> \g<s> need ",
    r"(?: ,)? (?:moment|instant|second) (?:@\d+@|it|engine) (?:is lit|is ignited|starts|ignites|is started|is switched"
    r" on)$": " at once",
    r" (?:as soon as|when) (?:@\d+@|it|engine) is (?:lit|ignited|started|switched on)$": " at once",
}
"""By the pattern of a part of a question without articles, plainer words with the same meaning."""
MULTIPLE_QUESTION = (
    rf"how many times (?:as|so) (?P<how>{'|'.join(_ADJECTIVES)}) {_AUX} (?P<s>@\d+@) {_HAVE}{_GOES}{_FOR}"
)
COMPARISON_QUESTION = rf"(?:by )?how much (?P<how>{'|'.join(_ADJECTIVES)}) {_AUX} (?P<s>@\d+@) {_HAVE}{_GOES}{_FOR}"
_DECREASING = frozenset({"lighter", "slower"})


def _compared(match: re.Match[str]) -> str:
    """Return *by how much must mass of A be greater* for *how much heavier must A be*, and the like."""
    noun = next(noun for told, noun in _ADJECTIVES.items() if re.fullmatch(told, match["how"]))
    head = "by what factor" if match[0].startswith("how many") else "by how much"
    return f"{head} must {noun} of {match['s']} be {'smaller' if match['how'] in _DECREASING else 'greater'} "


def reword_plainly(text: str) -> str:
    """Return a question for a number of the scene in plainer words."""
    question = " ".join(_CONSTANT.sub(" ", f" {text}").split()).strip(" ,")
    for told, plain in (*LIMIT_TURNS.items(), *NEED_REWORDINGS.items(), *PLAINER_WORDINGS.items()):
        question = compiled(told).sub(plain, question)
    question = re.sub(COMPARISON_QUESTION, _compared, re.sub(MULTIPLE_QUESTION, _compared, question))
    bound = re.match("(LEAST|GREATEST) ", question)
    question = question.removeprefix("LEAST ").removeprefix("GREATEST ")
    if bound is not None and "BOUND" not in question:
        question = f"{'at least' if bound[1] == 'LEAST' else 'at most'} {question}"
    question = question.replace("BOUND ", "" if bound is None else f"{bound[1].lower()} ")
    return " ".join(question.split())


_VARIED_NOUNS = "|".join(kind.nouns for name, kind in NUMBERS.items() if name != "motion at start")
_NUMBER = rf"(?:@\d+@ 's |its )?(?:{_VARIED_NOUNS})(?: of @\d+@| between @\d+@ and (?:@\d+@|{GROUNDS}))?"
_AUXILIARY = "(?:would|must|should|could|will|does|can|has|might|may|is|are|were|was|had)"
_NEED_TO = "(?:have to |need to |has to |needs to |had to |to )?"
_THING = rf"(?:@\d+@|{GROUNDS}|wall|surface|surfaces|(?:electric |magnetic )?field)"
_MORE = {
    "heavier|more massive": "mass",
    "stiffer|harder|stronger": "stiffness",
    "rougher": "friction",
    "longer": "length",
    "faster|quicker": "speed",
    "steeper": "slope",
}
_LESS = {
    "lighter|less massive": "mass",
    "softer|weaker": "stiffness",
    "smoother|less rough": "friction",
    "shorter": "length",
    "slower": "speed",
    "flatter|less steep|gentler": "slope",
}
_COMPARATIVES = {word: (kind, rows is _MORE) for rows in (_MORE, _LESS) for told, kind in rows.items()
                 for word in told.split("|")}  # fmt: skip
_ADJ = "|".join(sorted(_COMPARATIVES, key=len, reverse=True))
_GREATER = "larger|greater|higher|bigger|increased|raised"
_SMALLER = "smaller|lower|less|reduced|lowered|decreased|diminished"
_CHANGED = r"(?P<up>increased|raised|enlarged)|(?P<down>reduced|lowered|decreased|diminished|cut)|changed|altered|set"
_SUPPOSE = (
    r"(?:(?:suppose|imagine|assume|consider|say)(?: now)?(?: that)? (?P<s>SAID)"
    r"|(?:let us |let |one |we |someone |you )?(?:now )?(?:replace|exchange|swap|change)s? (?P<swap>SAID))\. "
).replace("SAID", r"[^.#]+")
_WERE = r"(?:is|are|was|were|could be|can be|may be|had been|would be|be|becomes?|has|have|had)"
_MADE = "(?:made|chosen|taken|replaced by|exchanged for|swapped for|changed for|substituted by|changed|varied|adjusted)"
_ONE = (
    "(?:one|@\\d+@|block|body|ball|spring|load|string|cord|rope|cart|trolley|object|mass|weight|planet|star"
    "|disc|puck|rod|bead)"
)
_OTHER = rf"(?:a |another |some )?(?:(?P<adj>{_ADJ})|different|other|another)(?: {_ONE})?(?: instead)?"
_SUPPOSED = (
    rf"(?P<thing>{_THING}) {_WERE} (?:{_MADE} )?(?:(?:much|even|somewhat|a little|slightly|made|still) )*{_OTHER}",
    (
        rf"(?P<n>{_NUMBER}) {_WERE} (?:(?:made|to|{_MADE}) )*(?:(?P<more>{_GREATER})|(?P<less>{_SMALLER})|different"
        rf"|changed"
        r"|varied|adjusted|adjustable|variable|not known|unknown)"
    ),
    rf"(?P<thing>@\d+@) (?:by|for|with) {_OTHER}",
    rf"(?:there {_WERE} )?(?:(?P<rub>more)|(?P<slip>less)) friction",
    (
        r"hand (?:pulls|pulled|were to pull|tugs|tugged)(?: (?:much|even|somewhat|a little|slightly))?"
        r" (?:(?P<hard>harder|more strongly)"
        r"|less (?:hard|strongly)|more gently)"
    ),
)


class ToldDirection(NamedTuple):
    """A question without its hint that the number is greater or less than in the scene, and that hint.

    `grows` is None if the sentence does not tell whether the number is to be greater or less than it is. The `kind` of
    the number and the token of the `thing` that has it are empty if they are not told.
    """

    text: str
    kind: str = ""
    thing: str = ""
    grows: bool | None = None


def told_direction(text: str) -> ToldDirection:
    """Return the parts of a sentence such as *suppose C is replaced by a heavier block. what mass ...*."""
    match = re.match(_SUPPOSE, text)
    if match is None:
        return _of_value(text) or ToldDirection(text)
    clause = (match["s"] or match["swap"]).strip(" ,")
    supposition = next(filter(None, (re.fullmatch(told, clause) for told in _SUPPOSED)), None)
    return ToldDirection(text) if supposition is None else _told(text[match.end() :], supposition)


def _told(rest: str, supposition: re.Match[str]) -> ToldDirection:
    groups = {name: group or "" for name, group in supposition.groupdict().items()}
    if groups.get("adj"):
        kind, grows = _COMPARATIVES[groups["adj"]]
        kind = groups["thing"] if groups["thing"].endswith("field") else kind
        return ToldDirection(rest, kind, _token(groups["thing"]), grows)
    if groups.get("rub") or groups.get("slip"):
        return ToldDirection(rest, "friction", "", bool(groups["rub"]))
    if supposition[0].startswith("hand "):
        return ToldDirection(rest, "force", "", bool(groups.get("hard")))
    number = groups.get("n", "")
    grows = True if groups.get("more") else False if groups.get("less") else None
    return ToldDirection(rest, _kind(number), _token(number or groups["thing"]), grows)


def _token(phrase: str) -> str:
    match = re.search(r"@\d+@", phrase)
    return match[0] if match is not None else ""


def _kind(number: str) -> str:
    """Return the kind of a number that a phrase such as *mass of @0@* names; empty for no phrase."""
    bare = re.sub(r"^(?:@\d+@ 's |its )| (?:of|between) @.*$", "", number)
    return next((name for name, kind in NUMBERS.items() if re.fullmatch(kind.nouns, bare)), "")


def _of_value(text: str) -> ToldDirection | None:
    """Return *to what value must A's mass be reduced* as *what must A's mass be*, with the hint *less*; else None."""
    match = re.match(
        rf"to (?:what|which) (?:(?:new|other|different|smaller|larger|lower|higher) )*(?:value )?(?P<aux>{_AUXILIARY})"
        rf" (?:one|we|you)"
        rf" {_NEED_TO}(?:(?P<up>increase|raise|enlarge)|(?P<down>reduce|lower|decrease|diminish|cut)|change|alter|set)"
        rf" (?P<n>{_NUMBER}) (?=for |so |to |if |in )",
        text,
    )
    match = match or re.match(
        rf"to (?:what|which) (?:(?:new|other|different|smaller|larger|lower|higher) )*(?:value )?(?P<aux>{_AUXILIARY})"
        rf" (?P<n>{_NUMBER}) {_NEED_TO}be (?:{_CHANGED}) (?=for |so |to |if |in )",
        text,
    )
    match = match or re.match(
        rf"to (?:what|which) (?P<n>{_VARIED_NOUNS}) (?P<aux>{_AUXILIARY}) (?P<s>@\d+@) {_NEED_TO}be (?:{_CHANGED}) "
        "(?=for |so |to |if |in )",
        text,
    )
    if match is None:
        return None
    grows = True if match["up"] else False if match["down"] else None
    of = f" of {match['s']}" if match.groupdict().get("s") else ""
    return ToldDirection(f"what would {match['n']}{of} have to be {text[match.end() :]}", grows=grows)


def filter_by_hint(
    frames: Iterable[WantedFrame], told: ToldDirection, sentence: TokenizedSentence
) -> Iterator[WantedFrame]:
    """Yield the parsed questions whose number a hint such as *heavier* concerns, with the direction it implies."""
    for frame in frames:
        owners = frame.number.owners or ((sentence.subject(frame.subject),) if frame.subject else ())
        of_it = not told.thing or not owners or sentence.subject(told.thing) in owners
        if (not told.kind or told.kind == frame.number.kind) and of_it:
            yield frame if told.grows is None else frame._replace(grows=told.grows)


def told_values(values: Sequence[float], path: str, frame: WantedFrame, motion: FollowedMotion) -> list[float]:
    """Return the values of a number that are greater, or less, than the present one, as hinted; else all."""
    now = number_at(motion.study.scene, path)
    return [value for value in values if frame.grows is None or (value > now) == frame.grows]
