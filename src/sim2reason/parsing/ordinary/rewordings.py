"""Sentences of textbooks on usual arrangements that no single sentence of the library matches word by word."""

import re
from collections.abc import Mapping

_MASS = r"(?:of (?:mass(?:es)? )?)?(\d[\d.]*(?: ?[x×] ?10\^?-?\d+)?)[ -]?(k?g|kilograms?)"
_STRING = r"(?:a |the )?(?:(?:single|light|massless|inextensible|ideal)(?:,? and|,)? )*(?:string|rope|cord)"
_PULLEY = r"(?:a |an )?(?:(?:light|massless|frictionless|smooth|fixed|ideal)(?:,? and|,)? )*pulley"
_LEADS = r"(?:(?:that|which) )?(?:passes |passing |runs |running |goes |going |hung |is hung |slung )?over"
_TIED = r"(?:connected|attached|joined|tied)"
_BODY = r"(?:blocks|masses|weights|bodies|objects)"

REWORDED: Mapping[str, str] = {
    rf"Two {_BODY},? {_MASS} and {_MASS},? (?:hang|are hung|are suspended|are {_TIED})"
    rf"(?: vertically)?(?: (?:together|from|to|at|on|the|both|two|opposite|ends?|of))*"
    rf"(?: by)? {_STRING} {_LEADS} {_PULLEY}\.": (
        r"A light string is tied to block A of mass \1 \2; it runs straight up, passes over a light fixed pulley"
        r" and runs straight down to block B of mass \3 \4."
    ),
    rf"(?:It|The block|Block A) is {_TIED} by {_STRING} {_LEADS} {_PULLEY} at (?:the|its) edge(?: of the \w+)?"
    rf" to (?:a |another |a second )?(?:hanging )?(?:block|mass|weight)(?: B)? {_MASS}"
    r"(?:,? (?:that|which) hangs (?:freely|vertically))?\.": (
        r"A light string tied to block A runs to the right along the plane, passes over a light fixed pulley"
        r" and runs straight down to block B (\1 \2)."
    ),
}
"""By a pattern of a whole sentence, the library's sentence that says the same; the first body mentioned is A."""


def reworded(sentence: str) -> str | None:
    """Return the library's sentence that says the same as one of a textbook on a usual arrangement; None if unknown."""
    for pattern, said in REWORDED.items():
        found = re.fullmatch(pattern, sentence)
        if found is not None:
            return found.expand(said)
    return None
