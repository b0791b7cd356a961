"""Questions for the impulse that starts a motion, and for the period of small oscillations."""

import re

from sim2reason.questions.following import FollowedMotion
from sim2reason.questions.kinds.period import PENDULUM
from sim2reason.questions.ordinary.hearing import TokenizedSentence
from sim2reason.questions.ordinary.reading import Reader, Reading, UnderstoodQuestion
from sim2reason.questions.phrasing import PeriodQuery
from sim2reason.questions.structured import EQUILIBRIUM, START, StructuredQuestion
from sim2reason.questions.words import Words
from sim2reason.simulation.quantities.subjects.bodies import Bodies

_BLOW = "(?:blow|kick|hammer|push)"
_REST = "(?:standing still|at rest|stationary|motionless|standing)"
_BEFORE = (
    rf"(?P<s>@\d+@|it) (?:was|were|had been|had|is) {_REST} (?:just |immediately )?before(?: (?:{_BLOW}|start|that))?"
)
_ASK_IMPULSE = "(?:how large (?:was|is)|what (?:was|is)|find|determine|calculate|how great (?:was|is))"
_IMPULSE = (
    rf"(?:magnitude of )?impulse (?:that )?(?:(?P<t>@\d+@|it) (?:received|was given|got)|of {_BLOW}"
    rf"|(?:given|imparted) to (?P<u>@\d+@|it)(?: by {_BLOW})?|{_BLOW} (?:gave|imparted to) (?P<v>@\d+@|it))"
)
BLOW_PATTERNS = (
    rf"(?:if|given that|assuming(?: that)?|supposing(?: that)?) {_BEFORE} , {_ASK_IMPULSE} {_IMPULSE}",
    rf"{_ASK_IMPULSE} {_IMPULSE}(?: ,)? (?:if|given that|assuming(?: that)?) {_BEFORE}",
    rf"(?P<s>@\d+@|it) (?:was|had been) {_REST} before {_BLOW}\. {_ASK_IMPULSE} {_IMPULSE}",
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


def read_blow_impulse(
    sentence: TokenizedSentence, motion: FollowedMotion, words: Words, reader: Reader
) -> UnderstoodQuestion | None:
    """Return the question for the impulse that sets a body at rest in motion, which is its initial momentum."""
    match = next(filter(None, (re.fullmatch(regex, sentence.text) for regex in BLOW_PATTERNS)), None)
    if match is None or words.released:
        return None
    groups = match.groupdict()
    tokens = {token for name in "stuv" if (token := groups.get(name) or "").startswith("@")}
    bodies = {phrase: name for name, phrase in words.subject_phrases(Bodies()).items()}
    phrase = (
        sentence.subject(next(iter(tokens))) if len(tokens) == 1 else next(iter(bodies)) if len(bodies) == 1 else ""
    )
    if phrase not in bodies or len(tokens) > 1:
        return None
    return reader.first_of([Reading(StructuredQuestion("momentum", bodies[phrase], START))], motion, words)


_MEASURE = "(?P<q>period|frequency|angular frequency)"
_SMALL = (
    "(?:(?:very )?small (?:oscillations?|swings?|vibrations?|angles?|amplitudes?|displacements?)"
    "|small-amplitude oscillations?)"
)
_ABOUT = (
    r"(?: ?(?:about|around) (?:its |@\d+@ 's |position of )?(?:equilibrium(?: position)?|lowest position"
    r"|rest position|lowest point))"
)
_OF = r"(?: of (?:this |that )?(?:@\d+@|pendulum|system))?"
_ASK = "(?:what is|find|determine|calculate)"
_WITH = "(?:with|at) which"
_SWING = "(?:oscillate|swing|vibrate)"
_OSCILLATES = f"@0@ (?:would )?{_SWING}s?"
_SLIGHTLY = f"(?:(?:through|with|at) {_SMALL}|slightly)"
OSCILLATION_PATTERNS = (
    rf"(?:what would|what is|find|determine|calculate) {_MEASURE} (?:be )?(?:of|for) {_SMALL}{_OF}{_ABOUT}",
    rf"what would be {_MEASURE} (?:of|for) {_SMALL}{_OF}{_ABOUT}?",
    rf"what would {_MEASURE}{_OF} be (?:for|with|in case of) {_SMALL}{_OF}{_ABOUT}?",
    (
        rf"what would (?:be )?{_MEASURE}{_OF} (?:be )?if (?:@\d+@ |pendulum |system )?(?:were|was) (?:only |just"
        rf" )?(?:swinging|oscillating|vibrating)"
        rf" (?:(?:only )?(?:through|with) {_SMALL}|only slightly){_ABOUT}?"
    ),
    (
        rf"what would (?:be )?{_MEASURE}{_OF} (?:be )?if (?:@\d+@ |it )?(?:only )?(?:swung|oscillated|vibrated)"
        rf" (?:(?:only )?(?:through|with) {_SMALL}|only slightly){_ABOUT}?"
    ),
)
OF_MOTION = (
    rf"{_ASK} {_MEASURE} (?:of|for) {_SMALL}{_OF}",
    rf"{_ASK} {_MEASURE} of @0@ 's {_SMALL}{_ABOUT}?",
    rf"{_ASK} {_MEASURE} {_WITH} {_OSCILLATES} {_SLIGHTLY}{_ABOUT}?",
    rf"with what {_MEASURE} (?:does|would|will) @0@ {_SWING} {_SLIGHTLY}{_ABOUT}?",
    (
        rf"with what {_MEASURE} (?:does|would|will) @0@ {_SWING} if (?:its |their )?(?:amplitude|angle|swings?"
        r"|oscillations?) (?:were|was|is|are) (?:very |only )*small"
    ),
    rf"{_ASK} small(?:-angle|-amplitude)? {_MEASURE} of (?:@0@ 's (?:oscillations?|swings?|motion)|@0@)",
)
"""Patterns that presume that the motion in the scene is itself a small oscillation, unlike `OSCILLATION_PATTERNS`."""
_LONG = "(?:how long|of what length|what length)"
_SIMPLE = "(?:simple|mathematical) pendulum"
_SAME = (
    "(?:swing|oscillate|vibrate|have|keep|move)(?: (?:with|at|in))?(?: same)?(?: small-?oscillation)? "
    r"(?:period|frequency|time|step)(?: (?:as|with) (?:that of )?(?:this |that )?(?:@\d+@|one|system|body|pendulum))"
)
_SMALLER = rf"(?:(?: ,)? (?:when|if|for|in case of|provided) (?:its |their |both )?(?:swings|{_SMALL})(?: are small)?)?"
PENDULUMS = (
    (
        rf"{_LONG} (?:would|must|should|does) {_SIMPLE} (?:have to |need to )?be (?:to|in order to|so that it"
        rf"|if it is to|for it to) {_SAME}{_SMALLER}"
    ),
    (
        rf"{_ASK} length of {_SIMPLE} (?:that|which) (?:would )?(?:{_SAME}|(?:swings|has|oscillates)[a-z ]* (?:period|"
        rf"frequency) (?:as|with) (?:that of )?(?:this |that )?@0@){_SMALLER}"
    ),
    (
        rf"what length (?:would|must|should|does) {_SIMPLE} (?:need|have)(?: to have)? for its (?:period|frequency) to"
        r" (?:equal|be equal to|be same as) (?:that|period) of (?:small (?:swings|oscillations) of )?(?:this )?@\d+@"
    ),
    rf"(?:how long is|{_ASK} length of) {_SIMPLE} with same (?:period|frequency)(?: of small (?:oscillations|swings))?",
    (
        rf"what length (?:would|must|should|does) {_SIMPLE} (?:need|have)(?: to have)? (?:to|in order to|so that it"
        rf"|if it is to) (?:{_SAME}|(?:have|swing with) same (?:period|frequency)){_SMALLER}"
    ),
    (
        rf"{_ASK} length of {_SIMPLE} (?:with|of) same (?:small )?(?:period|frequency)(?: of small oscillations)?"
        rf"(?: as (?:this |that )?@\d+@)?{_SMALLER}"
    ),
    rf"{_ASK} length of (?:equivalent|equivalent simple) pendulum(?: of (?:this |that )?@\d+@)?",
)
"""Patterns of questions for the length of the simple pendulum whose small swings have the same period."""
MAX_SMALL_AMPLITUDE = 20.0  # degrees: largest amplitude of a small oscillation


def _is_small(motion: FollowedMotion, words: Words, reader: Reader) -> bool:
    """Return whether a body swings, and only through small angles."""
    reading = Reading(StructuredQuestion("greatest deflection"))
    meaning = reader.first_of([reading], motion, words)
    return (
        meaning is not None
        and (meaning.simulated_answer.answer or MAX_SMALL_AMPLITUDE) < MAX_SMALL_AMPLITUDE
        and "deg" in meaning.posed_question.unit(words)
    )


def read_small_oscillations(
    sentence: TokenizedSentence, motion: FollowedMotion, words: Words, reader: Reader
) -> UnderstoodQuestion | None:
    """Return the question for the period or a frequency of small oscillations; None if there are several modes."""
    if any(re.fullmatch(regex, sentence.text) for regex in PENDULUMS):
        return _in_one_mode(PENDULUM, motion, words, reader)
    for number, regex in enumerate((*OSCILLATION_PATTERNS, *OF_MOTION)):
        match = re.fullmatch(regex, sentence.text)
        if match is not None and (number < len(OSCILLATION_PATTERNS) or _is_small(motion, words, reader)):
            return _in_one_mode(match["q"], motion, words, reader)
    return None


def _in_one_mode(measure: str, motion: FollowedMotion, words: Words, reader: Reader) -> UnderstoodQuestion | None:
    """Return the question for a measure of small oscillations if there is only one mode of them; else None."""
    meaning = reader.first_of([Reading(StructuredQuestion(measure, "", EQUILIBRIUM))], motion, words)
    query = meaning.posed_question.query if meaning is not None else None
    return meaning if isinstance(query, PeriodQuery) and query.modes == 1 else None
