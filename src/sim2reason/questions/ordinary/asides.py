"""Words and phrases of a question that do not change what it asks for."""

import re

from sim2reason.questions.ordinary.vocabulary import GROUNDS, pattern

_ROOM = (
    rf"(?:{GROUNDS}|(?:laboratory|lab|earth|room|observer|someone|somebody|person|bystander)(?: standing)?(?:"
    rf" on (?:{GROUNDS}))?)"
)
_FRAME = "(?:reference )?frame(?: of reference)?"
_TELL = "(?:give|state|express|quote|write|report|take)"
_UNITS = "(?:kg|kilograms?|metres|meters|m|newtons?|n|joules?|j|seconds?|s|m/s|degrees?|years?|watts?|cm|km/s|radians?)"
ASIDES = tuple(
    re.compile(told)
    for told in (
        (
            rf" ?,? (?:as )?(?:seen|viewed|observed|measured|judged) (?:from|by|in|relative to) {_ROOM}(?: {_FRAME})?"
            rf" ?,?(?= |$)"
        ),
        (
            rf" (?:relative to|with respect to|in) (?:(?:{GROUNDS}|laboratory|lab|earth)(?: 's)? {_FRAME}|laboratory"
            rf"|lab|earth)(?= |$)"
        ),
        (
            rf" ?,? (?:as )?(?:measured|counted|reckoned|counting|measuring) (?:from|since)"
            rf" {pattern('START').pattern}(?: on)? ?,?"
            "(?= |$)"
        ),
        (
            rf"(?:[.?]|,|;| and| \() ?{_TELL} (?:only )?(?:(?:its|your|their|just|only) )?(?:answer|result|magnitude"
            rf"|amount|size|value)"
            rf"(?: only)?(?: (?:in|as) [a-z/²^0-9]+(?: per [a-z]+)?)?\)?$"
        ),
        rf"(?: ,)? \((?:measured )?in {_UNITS}(?: per [a-z]+)?\)(?: ,)?",
        rf" in {_UNITS}(?: per second(?: squared)?)?$",
        "(?<=first collision) of all(?= |$)|(?<=first impact) of all(?= |$)",
        " (?:like this|in this way|in doing so|in process|as described)(?= |$)",
        (
            rf"(?:,? )?(?:that|which) (?:follows|results|ensues|sets in)(?: (?:on|after|from|upon))?"
            rf"(?: (?:its )?{pattern('START').pattern})?(?= |$)"
        ),
        (
            "(?: ,)? (?:those with walls? (?:included|counted)|including those with walls?|counting those with"
            " walls?(?: too)?)(?: ,)?"
        ),
    )
)
"""Patterns of phrases that are removed from a question, on text without articles."""
_FIRST_INSTANT = re.compile(
    r"\b(?:at )?(?:very )?first (?:instant|moment|time) (?:at which|when|that|in which|it is that)\b"
)


_WORK = re.compile(r"how much work (?:has|does|did) friction (?:done|do)(?: on @\d+@)?")


def without_asides(text: str) -> str:
    """Return a question without incidental words; the work of friction becomes *how much energy is lost to it*."""
    if re.search(r"\bgive (?:only )?(?:its )?(?:magnitude|size)$", text) is not None:
        text = _WORK.sub("how much energy is lost to friction", text)
    for aside in ASIDES:
        text = aside.sub("", text)
    return " ".join(_FIRST_INSTANT.sub("when", text).split()).rstrip(" ,.;")


_ASK = (
    r"(?:what|which|find|determine|calculate|compute|give|state|how|obtain|with|at|after|in|when|by|work|show|to|for)"
)
_METHOD = (
    "(?:conservation|energy|momentum|newton|law|laws|second|work|theorem|principle|kinematics|equations?|motion|linear"
    "|mechanical|angular|otherwise|or|of|and|'s|the|considerations?|methods?|arguments?|initial|position|velocity"
    "|conditions?|given|data|values?|this|that|these|results?)"
)
LEADS = tuple(
    re.compile(told)
    for told in (
        r"^(?:okay|ok|hence|thus|therefore|so|now|next|finally|first|also|again|then|and|likewise|please|well)"
        r"(?: or otherwise)? ?,? (?=" + _ASK + r"\b|@\d+@)",
        (
            rf"^(?:by )?(?:using|applying|considering|use|with help of|by means of|from)(?: {_METHOD})+ ?,"
            rf" (?={_ASK}\b)"
        ),
        rf"^(?:measured|counted|reckoned|counting) from (?:start|release|launch) ,? ?(?={_ASK}\b)",
        (
            r"^(?:show|prove|explain|verify|note|notice|recall|remember|recognise|recognize)(?: \w+)? that"
            r" (?:[a-z ]+ )?(?:simple harmonic|harmonic|periodic|oscillatory|uniformly accelerated)\. "
        ),
        r"^(?:@\d+@|string|strings|they) (?:must|will|does|do) not (?:break|snap|slip off|tear)\. ",
        r"[.;] (?:mind|note|remember|recall|bear in mind|keep in mind) that [^.@#]+$",
        r" ,? (?:rotation|rotational energy|that of rotation|both parts)(?: being)? (?:included|counted)$",
        (
            r"(?<=component) ?,? (?:taking|counting|with) (?:up|upwards?|right|up direction) (?:as|being|as being)"
            r" positive$"
        ),
    )
)
"""Patterns of what is removed from a question in lower case, without articles."""
_POSITIVE = re.compile(r" ?,? ?(?:taking|counting|reckoning|with) (?:up|upwards?) (?:as |being )?positive$")
_REPEATED = re.compile(r"#(\d+)# \(#(\d+)#\)")


_SMOOTH = re.compile(
    r"^(?:all |both )?(?:floor|plane|table|track|surface|slope|top|surfaces|faces) (?:is|are) (?:smooth|frictionless)"
    r"(?: ,? ?(?:so|and so|therefore)(?: that)? [^.#]*)?\. "
)
_SEEN_BY = re.compile(
    r" ?,? (?:as )?(?:measured|seen|judged|viewed|observed) (?:by|from) (?:(?:observer|someone|somebody|person"
    r"|passenger|ant)"
    r"(?: who is| that is)? ?(?:sitting|standing|riding|at rest|fixed)? ?(?:on|to|with) )?(?=@)"
)


def without_leads(text: str, numbers: tuple[str, ...], *, smooth: bool) -> str:
    """Return a question without empty leading words, and without a repetition of the preceding number.

    In a scene without friction, which is `smooth`, a sentence such as *the floor is smooth* is left out as well.
    """
    text = _SMOOTH.sub("", text) if smooth else text
    text = _SEEN_BY.sub(" relative to ", text)
    for lead in LEADS:
        text = lead.sub("", text)
    if re.search(r"\bvertical component\b|\by[- ]component\b", text):
        text = _POSITIVE.sub("", text)
    return _REPEATED.sub(lambda found: _once(found, numbers), text)


def _once(found: re.Match[str], numbers: tuple[str, ...]) -> str:
    one, other = numbers[int(found[1])], numbers[int(found[2])]
    (size, _, unit), (twin, _, same) = one.partition(" "), other.partition(" ")
    return f"#{found[1]}#" if float(size) == float(twin) and unit == same else found[0]
