"""Statements with a number, each as a question for which the number is the answer."""

import re
from collections.abc import Iterator, Mapping

from sim2reason.questions.ordinary.base_forms import with_base_forms
from sim2reason.questions.ordinary.hearing import TokenizedSentence
from sim2reason.questions.ordinary.vocabulary import GROUNDS, pattern

_S = r"@\d+@"
_N = r"(?P<n>#\d+#)"
_ABOUT = r"(?:(?:exactly|just|only|about|at least|at most|no more than|up to) )?"
_Q = "QUANTITY"
_VERB = r"[a-z]+"
RESULT_STATEMENTS = (
    (
        (
            rf"(?P<what>(?:[a-z]+ )*?(?:{_S} 's |its )?(?:[a-z]+ )*?(?:{_Q}|period|amplitude|time of flight"
            rf"|radius of path|energy lost in (?:first |second )?collision|centre of mass)(?: (?:of|in|on"
            rf"|between|acting on|exerted on|for|at|when|after|before|just|as) .+?)?) (?:(?:(?:to )?(?:be|is|become"
            rf"|becomes|reach|reaches|equal|equals|amount to|have value of|come to|are)) )?(?:equal to"
            rf" )?{_ABOUT}{_N}(?P<rest>.*)"
        ),
        "what is {what}{rest}",
    ),
    (
        (
            rf"(?P<s>{_S}) (?:have|has|attain|attains|reach|reaches|acquire|acquires|get|gets|gain|gains|move with"
            rf"|moves with|be given|feel|feels|experience|experiences) (?P<what>(?:[a-z]+ )??{_Q}) of"
            rf" {_ABOUT}{_N}(?P<rest>.*)"
        ),
        "what is {what} of {s}{rest}",
    ),
    (
        (
            rf"(?P<s>{_S}) (?:oscillate|oscillates|swing|swings|vibrate|vibrates|move|go round|revolve|revolves|go to"
            rf" and fro) (?:to and fro )?(?:with|at) (?P<what>period|frequency) of {_ABOUT}{_N}"
        ),
        "what is {what} of {s}",
    ),
    (rf"(?P<s>{_S}) (?:have|has) (?P<what>period|frequency) of {_ABOUT}{_N}", "what is {what} of {s}"),
    (
        (
            rf"(?P<s>{_S}) (?:accelerate|accelerates|be accelerated) (?:(?P<way>up|down|upwards|downwards)"
            rf" (?:{GROUNDS} )?)?(?:at|with) {_ABOUT}{_N}(?P<rest>.*)"
        ),
        "what is acceleration of {s} {way}{rest}",
    ),
    (
        rf"(?P<s>{_S}) (?:rise|rises|go up|move up|climb) with acceleration of {_ABOUT}{_N}(?P<rest>.*)",
        "what is acceleration of {s} upwards{rest}",
    ),
    (
        (
            rf"(?P<s>{_S}) (?:fall|falls|sink|sinks|descend|descends|go down|come down|move down|drop) with"
            rf" acceleration of"
            rf" {_ABOUT}{_N}(?P<rest>.*)"
        ),
        "what is acceleration of {s} downwards{rest}",
    ),
    (
        rf"(?P<s>{_S}) (?:move|moves|start|starts|go) (?:off )?with acceleration of {_ABOUT}{_N}(?P<rest>.*)",
        "what is acceleration of {s}{rest}",
    ),
    (
        rf"(?P<what>(?:{_S} 's |its )?(?:[a-z]+ )??(?:{_Q}|period|amplitude)) of {_ABOUT}{_N}(?P<rest>.*)",
        "what is {what}{rest}",
    ),
)
"""Statements with a number, each with the question for which the number is the answer."""
SPEEDS = (
    (
        (
            rf"(?P<s>{_S}) (?:move|moves|be moving|travel|travels|go|be going|is moving|slide|fly) (?:at|with)"
            rf" (?:(?:speed|velocity) of )?{_ABOUT}{_N}(?P<rest>.*)"
        ),
        "how fast is {s} moving{rest}",
    ),
    (
        (
            rf"(?P<s>{_S}) (?P<verb>{_VERB})(?P<pred> .+?)? (?:at|with) (?:(?:speed|velocity) of"
            rf" )?{_ABOUT}{_N}(?P<rest>.*)"
        ),
        "with what speed does {s} {verb}{pred}{rest}",
    ),
    (rf"(?P<s>{_S}) (?:reach|reaches|attain|attains) {_ABOUT}{_N}(?P<rest> .+)", "how fast is {s} moving{rest}"),
    (
        (
            rf"(?P<s>{_S}) (?:reach|reaches|attain|attains|have|has|get to) (?:(?:greatest|maximum|top) )(?:speed"
            rf"|velocity) of {_ABOUT}{_N}"
        ),
        "what is greatest speed of {s}",
    ),
    (
        rf"(?P<s>{_S}) (?:reach|reaches|attain|attains|get to) (?:(?:speed|velocity) of )?{_ABOUT}{_N}",
        "what is greatest speed of {s}",
    ),
    (
        (
            rf"(?P<s>{_S}) (?:reach|reaches|attain|attains) (?:final|terminal) (?:speed|velocity) of"
            rf" {_ABOUT}{_N}"
        ),
        "what is final speed of {s}",
    ),
)
TIMES = (
    (
        rf"(?P<s>{_S}) (?:go|goes|revolve|circle|orbit)(?: (?:round|around))?(?: once)? in {_ABOUT}{_N}",
        "what is period of {s}",
    ),
    (
        (
            rf"(?P<s>{_S}) (?P<verb>{_VERB})(?P<pred> .+?)? (?:in|after|within) {_ABOUT}{_N}(?: (?:after start|after"
            rf" release|from start))?"
        ),
        "how long does {s} take to {verb}{pred}",
    ),
    (
        (
            rf"(?P<s>{_S}) (?:take|takes|need|needs|require|requires) {_ABOUT}{_N} to (?P<verb>{_VERB})(?P<pred>"
            rf" .+)?"
        ),
        "how long does {s} take to {verb}{pred}",
    ),
    (
        rf"it (?:take|takes) {_ABOUT}{_N} for (?P<s>{_S}) to (?P<verb>{_VERB})(?P<pred> .+)?",
        "how long does {s} take to {verb}{pred}",
    ),
    (
        rf"(?P<s>{_S}) (?:stay|stays|remain|remains|be|is) (?:in (?:air|flight)|airborne) for {_ABOUT}{_N}",
        "how long is {s} in air",
    ),
    (
        rf"(?P<s>{_S}) (?:complete|make|go through) (?P<pred>.+?) in {_ABOUT}{_N}",
        "how long does {s} take to complete {pred}",
    ),
)
LENGTHS = (
    (
        (
            rf"(?P<s>{_S}) (?:reach|reaches|rise to|rises to|get to|attain|climb to|rise up to) (?:(?:maximum"
            rf"|greatest) )?height of {_ABOUT}{_N}(?P<rest>.*)"
        ),
        "how high does {s} rise{rest}",
    ),
    (
        rf"(?P<s>{_S}) (?:come to rest|stop|halt|come to stop|come to halt) (?:after|within) {_N}",
        "how far does {s} move before {s} stops",
    ),
    (rf"(?P<s>{_S}) go down {_ABOUT}{_N}", "how far down does {s} go"),
    (
        rf"(?P<s>{_S}) (?:get|go|move|come)s? (?:no (?:farther|further) than|at most) {_N}(?P<rest> .+)?",
        "how far{rest} does {s} get at most",
    ),
    (rf"(?P<s>{_S}) (?:rise|rises|get|go|climb) {_ABOUT}{_N} high(?P<rest>.*)", "how high does {s} rise{rest}"),
    (
        rf"(?P<s>{_S}) (?P<verb>{_VERB}) (?:distance of )?{_ABOUT}{_N} (?P<dir>away|far)(?P<rest>.*)",
        "how far away does {s} {verb}{rest}",
    ),
    (
        (
            rf"(?P<s>{_S}) (?:rise|rises|climb|bounce|rebound) (?:up )?(?:to )?(?:height of )?{_ABOUT}{_N}(?:"
            rf" high)?(?P<rest>.*)"
        ),
        "how high does {s} rise{rest}",
    ),
    (rf"(?P<s>{_S}) (?P<verb>{_VERB}) (?:distance of )?{_ABOUT}{_N}(?P<rest>.*)", "how far does {s} {verb}{rest}"),
    (
        rf"(?P<s>{_S}) (?P<verb>{_VERB}) (?P<pred>(?:at|to|up|down|through|on|over).*?) {_ABOUT}{_N}(?P<rest>.*)",
        "how far does {s} {verb} {pred}{rest}",
    ),
    (
        (
            rf"(?P<s>{_S}) (?P<verb>{_VERB})(?: first)? (?:at|over|by) (?:horizontal )?distance of {_ABOUT}{_N}(?:"
            rf" (?:away|from {_S}))?(?P<rest>.*)"
        ),
        "how far away does {s} {verb}{rest}",
    ),
    (
        rf"(?P<s>{_S}) (?:be|is|get) (?P<how>compressed|stretched|extended) by {_ABOUT}{_N}(?P<rest>.*)",
        "by how much is {s} {how}{rest}",
    ),
    (rf"(?P<s>{_S}) compress (?P<t>{_S}) by {_ABOUT}{_N}", "what is greatest compression of {t}"),
)
ANGLES = (
    (
        (
            rf"(?P<s>{_S}) (?:swing|turn|rise|go|move) (?:out |up |away )?to (?:angle of )?{_ABOUT}{_N}"
            rf" (?:from|to|with) (?:downward )?vertical"
        ),
        "what is greatest angle of {s} with vertical",
    ),
    (
        rf"(?P<s>{_S}) (?P<verb>{_VERB}) (?:(?:through|up to|by|out to) )?(?:angle of )?{_ABOUT}{_N}(?P<rest>.*)",
        "through what angle does {s} {verb}{rest}",
    ),
)
_TOLD = r"(?:accelerate|rise|go|move|climb|fall|sink|descend|drop|come|start|be|pass|reach|have)s?\b"  # elsewhere
ACCELERATIONS = (
    (
        (
            rf"(?P<s>{_S}) (?P<verb>(?!{_TOLD}){_VERB})(?: off)?(?: (?:up|down|upwards|downwards)(?: {GROUNDS})?)?"
            rf" (?:at|with) (?:acceleration of )?{_ABOUT}{_N}(?P<rest>.*)"
        ),
        "what is acceleration of {s}{rest}",
    ),
)
_UNITS = (
    (SPEEDS, ("m/s", "km/s", "au/yr")),
    (TIMES, ("s", "yr", "ms")),
    (LENGTHS, ("m", "cm", "mm", "km", "au")),
    (ANGLES, ("°", "rad")),
    (ACCELERATIONS, ("m/s²",)),
)
OF_UNITS: Mapping[str, tuple[tuple[str, str], ...]] = {unit: rows for rows, units in _UNITS for unit in units}
"""By unit, the statements whose numbers have the unit, each with the question for which the number is the answer."""


def asked_by(statement: str, sentence: TokenizedSentence) -> Iterator[tuple[str, str]]:
    """Yield each question that a statement such as *A reaches 3 m/s* answers, with the stated number and its unit."""
    tokens = re.findall(r"#\d+#", statement)
    for token in dict.fromkeys(tokens):
        number = sentence.number(token)
        unit = number.partition(" ")[2]
        for template, question in (*RESULT_STATEMENTS, *OF_UNITS.get(unit, ())):
            match = re.fullmatch(template.replace(_N, token).replace(_Q, pattern("QUANTITY").pattern), statement)
            if match is not None:
                groups = {name: group or "" for name, group in match.groupdict().items()}
                if verb := groups.get("verb"):
                    groups["verb"] = with_base_forms(verb) or verb
                rest = groups.get("rest", "")
                groups["rest"] = rest if not rest or rest.startswith((" ", ",")) else f" {rest}"
                yield " ".join(question.format(**groups).split()), number
                if (template, question) in TIMES:
                    break
