"""Conditions that a number of the scene is to meet: outcomes such as *A slips*, and results such as *A rises 2 m*."""

import re
from collections.abc import Iterator
from typing import NamedTuple

from sim2reason.questions.ordinary.base_forms import based
from sim2reason.questions.ordinary.hearing import ALL, Heard
from sim2reason.questions.ordinary.vocabulary import GROUNDS, pattern
from sim2reason.questions.ordinary.whatif.condition_rows import HOLDS, PHRASES
from sim2reason.questions.ordinary.whatif.plainer_conditions import plainer_condition
from sim2reason.questions.ordinary.whatif.statements import asked_by
from sim2reason.questions.ordinary.whatif.supposed_rows import DONE, MULTIPLES

_S = r"@\d+@"
_LOOSE = frozenset(
    re.split(
        " ",
        "for so that such with in order to it its they them everything all system whole is be just still to and"
        " at on if then able"
        " ever can of start order both body object in total be always throughout permanently thing right from",
    )
)
_ROLLS = frozenset({"roll", "go", "keep", "continue", "down", "up", "along", "this", "all", "way", "pure", "purely"})
_TAUT_TOO = re.compile(
    rf"(?: ,)? (?:with|and|while|without)(?: {_S}| string| its string)?(?: (?:always|still|being|staying"
    rf"|remaining|keep|stay|remain|remaining|never))*"
    rf" (?:taut|slack|going slack|go slack)(?: (?:throughout|all time|all while|all way|always))?$"
    rf"|(?: ,)? without {_S} (?:ever )?(?:going|becoming) slack$"
)
_START = re.compile(
    rf"(?: ,)? (?:when|after|once|as soon as|if|on|upon)(?: (?:its|their|system|everything|it|they|{_S}|all))?"
    rf"(?: (?:is|are|has been|being|was|were))? (?:{pattern('START').pattern}|let go of|set free|freed|let"
    rf" loose)(?: from rest)?$"
    r"|(?: ,)? (?:on|right from|from|straight after|right after) (?:release|start|beginning|very beginning)$"
    r"|(?<=at rest) (?:where @\d+@|where it|where they)(?: (?:is|are|was|were|lies|is placed|is put|is now))?(?:"
    r" at start)?$"
    r"|(?<=was) at start$|(?<=were) at start$"
    r"|(?: ,)? from (?:its |this |that )?(?:initial|starting|original|present|same|first)? ?(?:position|point"
    r"|place|height)$"
    r"|(?: ,)? (?:in|at) (?:its|this|that|their|initial|starting|same|present) ?(?:initial|starting|original"
    r"|own)? ?(?:position|point|place|positions)$"
    r"|(?: ,)? wherever @\d+@ is released$|(?: ,)? in any position$|(?: ,)? wherever it is released$"
)
_TURNED = re.compile(r" instead of (?:slide|roll|fall|go|move)(?: back)?(?: down)?(?: again)?$")


class StatedCondition(NamedTuple):
    """A condition: the name of an outcome and its subject; or a question and the number that is to be its answer.

    With a `factor`, the answer is to be that factor times the answer in the scene as it is. The phrases `moving` name
    bodies that are to move meanwhile. With `taut`, a string is to stay taut as well.
    """

    outcome: str = ""
    subject: str = ""
    question: str = ""
    stated: str = ""
    taut: bool = False
    factor: float = 0.0
    moving: tuple[str, ...] = ()


_CAUSING = (
    r"(?:make|makes|made|let|lets|cause|causes|allow|allows|enable|enables|get|gets|set|sets|permit"
    r"|permits|keep|keeps|kept|carry|carries|carried|take|takes|taken|bring|brings|brought|leave|leaves|lift"
    r"|lifts|hold|holds|send|sends|put|puts)"
)


_STEMS = {done.removesuffix("ed"): factor for done, factor in DONE.items() if " " not in done}  # *halv*, *doubl*
_AS_LARGE = (
    r" (?:as (?:large|great|big|high|long|strong|much|fast)|(?:its|their) (?:present|original|given|actual) value"
    r"|what it is"
    r"|its value)(?: (?:as )?(?:now|before|it is|it is now|at present|in scene|given))?"
)
_MULTIPLES = (
    rf"(?P<verb>{'|'.join(_STEMS)})(?:es|e) (?P<what>[^#]+)",
    rf"(?P<what>[^#]+?) (?:to )?be (?P<verb>{'|'.join(_STEMS)})ed",
    rf"(?P<what>[^#]+?) (?:to )?be (?P<mult>{'|'.join(MULTIPLES)}){_AS_LARGE}",
)
"""Statements that a quantity is to change by a factor, such as *doubles its speed* or *its speed be halved*."""


def _factor(found: re.Match[str]) -> float:
    groups = found.groupdict()
    if groups.get("verb"):
        return _STEMS[groups["verb"]]
    return next(value for told, value in MULTIPLES.items() if re.fullmatch(told, groups["mult"]))


def conditions(text: str, subject: str, heard: Heard) -> Iterator[StatedCondition]:
    """Yield the condition that a clause states, as an outcome or else as results; nothing if a word is left over."""
    said = _statement(text, subject)
    outcome = _outcome(said, heard)
    if outcome is not None:
        yield outcome
        return
    for told in _MULTIPLES:
        found = re.fullmatch(told, said)
        if found is not None:
            yield StatedCondition(question=f"what is {found['what']}", factor=_factor(found))
            return
    for question, stated in asked_by(said, heard):
        yield StatedCondition(question=question, stated=stated)


_NO_VERB = (
    r"(?!(?:come|get|go|rise|swing|fall|drop|climb|sink|move|slow|grow|begin|start|turn)\b)"  # of which *to* is part
)
_EMPTY = re.compile(
    r"\b(?:just|exactly|precisely|barely|only(?! @)|still|yet|in fact|actually|then|ever|at all|possibly)\b ?"
)


def _statement(text: str, subject: str) -> str:
    """Return a clause such as *for A to slip* as a statement that begins with its subject, *A slip*."""
    said = re.sub(r"^(?:for|that|so that|suppose|to) ", "", text)
    said = plainer_condition(said)
    said = re.sub(r"\b(?:would|could|should|might|must) have (?=\w+(?:ed|t|n|ne)\b)", "", said)
    if subject:
        said = re.sub(r"^(its|their) (?:own )?(?=[a-z])", f"{subject} 's ", said)
    said = _EMPTY.sub("", said)
    gets = re.match(r"(?:ensures? that|prevents?) (?P<rest>.+)", said)
    if gets is not None and said.startswith("prevent"):
        said = re.sub(rf"^prevents? ({_S}) from (\w+)", r"\1 not \2", said)
    elif gets is not None:
        said = gets["rest"]
    said = re.sub(rf"^(?:(?:would|will|to) )?(?:give|gives|given) ({_S}|it) ", r"\1 have ", said)
    said = re.sub(
        rf"^(?:will |would |to )?{_CAUSING} (?=(?:{_S}(?= |$)|(?:(?:greatest|least|maximum|minimum|final|initial)"
        rf" )*(?:its|it|system|everything|period|both|all|{pattern('QUANTITY').pattern})\b))",
        "",
        said,
    )
    said = re.sub(rf"^(?:does|do|did|will|would|should|must|can|could|is|are) (?={_S})", "", said)
    said = re.sub(
        r"\b(?:is|are|was|were|has|have) (?:not )?to (?=\w)", lambda f: "not " if " not " in f[0] else "", said, count=1
    )
    said = re.sub(
        rf"^((?:{_S}|{_NO_VERB}\w+)(?: and {_S})?) (?:should|would|must|will|can|could|to|does|do|shall|may)(?:"
        rf" (not))? ",
        lambda f: f"{f[1]} {'not ' if f[2] else ''}",
        said,
    )
    said = re.sub(rf"^((?:{_S}|it|\w+)) not to ", r"\1 not ", said)
    if (
        subject
        and not re.match(rf"(?:{_S}|it\b)", said)
        and not re.match(r"(?:\w+ ){0,3}(?:of|in) @", said)
        and "'s" not in said[:8]
    ):
        said = f"{subject} {said}" if _is_predicate(said) else said
    return " ".join(re.sub(r"^it\b", subject or "it", said).split())


def _is_predicate(said: str) -> bool:
    """Return whether a clause begins with a verb, so that it lacks its subject."""
    return pattern("QUANTITY").match(said) is None and not re.match(
        r"(?:its|their|system|everything|all|both|period|it|greatest|least|maximum|minimum|final|initial|largest"
        r"|highest"
        r"|lowest|smallest|top|amplitude|frequency)\b",
        said,
    )


_GOES = rf"(?:move|fall|rise|accelerate|drop|sink|slide)s?(?: (?:on|over|along) (?:it|{_S}|top of {_S}))?"
_MEANWHILE = re.compile(
    rf"(?: ,)? (?:while|as) (?P<who>{_S}(?: and {_S})?) (?:{_GOES})(?: and (?P<other>{_S}) (?:{_GOES}))?$"
)


def _outcome(said: str, heard: Heard) -> StatedCondition | None:
    """Return the condition if a statement names an outcome and every word has its place; else None."""
    bare = _TAUT_TOO.sub("", said)
    taut = bare != said
    meanwhile = _MEANWHILE.search(bare)
    who = f"{meanwhile['who']} {meanwhile['other'] or ''}" if meanwhile is not None else ""
    moving = tuple(map(heard.subject, re.findall(_S, who)))
    bare = _MEANWHILE.sub("", bare)
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
        named = (
            f"{ALL} {heard.subject(both[1])} & {heard.subject(both[2])}"
            if both is not None
            else heard.subject(who or None)
        )
        stated = re.findall(r"#\d+#", found[0])
        return StatedCondition(
            outcome, named, stated=heard.number(stated[0]) if stated else "", taut=taut, moving=moving
        )
    return None
