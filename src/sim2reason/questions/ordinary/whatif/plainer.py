"""Replacement of turns of phrase in questions for a number by equivalents that the module `frames` matches."""

import re
from collections.abc import Mapping

from sim2reason.questions.ordinary.vocabulary import compiled
from sim2reason.questions.ordinary.whatif.numbers import NUMBERS
from sim2reason.questions.ordinary.whatif.turns_of_limits import LIMIT_TURNS
from sim2reason.questions.ordinary.whatif.turns_of_need import TURNS

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
PLAINER: Mapping[str, str] = {
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
MULTIPLE = rf"how many times (?:as|so) (?P<how>{'|'.join(_ADJECTIVES)}) {_AUX} (?P<s>@\d+@) {_HAVE}{_GOES}{_FOR}"
COMPARED = rf"(?:by )?how much (?P<how>{'|'.join(_ADJECTIVES)}) {_AUX} (?P<s>@\d+@) {_HAVE}{_GOES}{_FOR}"
_SMALLER = frozenset({"lighter", "slower"})


def _compared(found: re.Match[str]) -> str:
    """Return *by how much must mass of A be greater* for *how much heavier must A be*, and the like."""
    noun = next(noun for told, noun in _ADJECTIVES.items() if re.fullmatch(told, found["how"]))
    head = "by what factor" if found[0].startswith("how many") else "by how much"
    return f"{head} must {noun} of {found['s']} be {'smaller' if found['how'] in _SMALLER else 'greater'} "


def plainer(text: str) -> str:
    """Return a question for a number of the scene in plainer words."""
    said = " ".join(_CONSTANT.sub(" ", f" {text}").split()).strip(" ,")
    for told, plain in (*LIMIT_TURNS.items(), *TURNS.items(), *PLAINER.items()):
        said = compiled(told).sub(plain, said)
    said = re.sub(COMPARED, _compared, re.sub(MULTIPLE, _compared, said))
    bound = re.match("(LEAST|GREATEST) ", said)
    said = said.removeprefix("LEAST ").removeprefix("GREATEST ")
    if bound is not None and "BOUND" not in said:
        said = f"{'at least' if bound[1] == 'LEAST' else 'at most'} {said}"
    said = said.replace("BOUND ", "" if bound is None else f"{bound[1].lower()} ")
    return " ".join(said.split())
