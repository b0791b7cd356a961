"""Phrases of a question that add nothing to what is asked: frames that go without saying, and wishes for the answer."""

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
    """Return a question without what adds nothing to it; the size of friction's work is the heat that it produces."""
    if re.search(r"\bgive (?:only )?(?:its )?(?:magnitude|size)$", text) is not None:
        text = _WORK.sub("how much energy is lost to friction", text)
    for aside in ASIDES:
        text = aside.sub("", text)
    return " ".join(_FIRST_INSTANT.sub("when", text).split()).rstrip(" ,.;")
