"""Words before or after a question that ask for nothing, such as *using conservation of energy*."""

import re

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
    """Return a question without words that ask for nothing, and without a number that repeats the one before it.

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
