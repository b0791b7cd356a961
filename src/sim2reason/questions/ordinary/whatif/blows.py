"""Questions for the impulse of the blow that sets a body moving at the start."""

import re

from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.questions.following import FollowedMotion
from sim2reason.questions.ordinary.hearing import Heard
from sim2reason.questions.ordinary.meaning import Reader, Understood
from sim2reason.questions.ordinary.reading import Reading
from sim2reason.questions.structured import START, StructuredQuestion
from sim2reason.questions.words import Words

_BLOW = "(?:blow|kick|hammer|push)"
_REST = "(?:standing still|at rest|stationary|motionless|standing)"
_BEFORE = (
    rf"(?P<s>@\d+@|it) (?:was|were|had been|had|is) {_REST} (?:just |immediately )?before(?: (?:{_BLOW}|start|that))?"
)
_ASK = "(?:how large (?:was|is)|what (?:was|is)|find|determine|calculate|how great (?:was|is))"
_IMPULSE = (
    rf"(?:magnitude of )?impulse (?:that )?(?:(?P<t>@\d+@|it) (?:received|was given|got)|of {_BLOW}"
    rf"|(?:given|imparted) to (?P<u>@\d+@|it)(?: by {_BLOW})?|{_BLOW} (?:gave|imparted to) (?P<v>@\d+@|it))"
)
PATTERNS = (
    rf"(?:if|given that|assuming(?: that)?|supposing(?: that)?) {_BEFORE} , {_ASK} {_IMPULSE}",
    rf"{_ASK} {_IMPULSE}(?: ,)? (?:if|given that|assuming(?: that)?) {_BEFORE}",
    rf"(?P<s>@\d+@|it) (?:was|had been) {_REST} before {_BLOW}\. {_ASK} {_IMPULSE}",
    (
        rf"(?:if|given that|assuming(?: that)?) {_BEFORE} , what impulse (?:did|must|does) {_BLOW} (?:have"
        rf" )?(?:given?|impart(?:ed)?)(?: to)?"
        r" (?P<t>@\d+@|it)"
    ),
    (
        rf"what impulse (?:did|must) {_BLOW} (?:have )?(?:given?|imparted?)(?: to)? (?P<t>@\d+@|it)"
        rf"(?: ,)? (?:if|given that|assuming(?: that)?) {_BEFORE}"
    ),
)


def of_blow(heard: Heard, motion: FollowedMotion, words: Words, reader: Reader) -> Understood | None:
    """Return the question for the impulse of the blow that sets a body off from rest: its momentum at the start."""
    found = next(filter(None, (re.fullmatch(told, heard.text) for told in PATTERNS)), None)
    if found is None or words.released:
        return None
    groups = found.groupdict()
    tokens = {token for name in "stuv" if (token := groups.get(name) or "").startswith("@")}
    bodies = {said: name for name, said in words.called(Bodies()).items()}
    said = heard.subject(next(iter(tokens))) if len(tokens) == 1 else next(iter(bodies)) if len(bodies) == 1 else ""
    if said not in bodies or len(tokens) > 1:
        return None
    return reader.first_of([Reading(StructuredQuestion("momentum", bodies[said], START))], motion, words)
