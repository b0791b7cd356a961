"""Questions for a number of the scene that leads to a given result or decides about an outcome."""

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import product

from sim2reason.questions.moments.occurrence import can_roll
from sim2reason.questions.ordinary.clauses import read_moments
from sim2reason.questions.ordinary.hearing import TokenizedSentence
from sim2reason.questions.ordinary.moment_phrases import CONNECTORS, When, addresses
from sim2reason.questions.ordinary.paraphrases import DecidingNumber, read_deciding_numbers
from sim2reason.questions.ordinary.readers import token_subjects
from sim2reason.questions.ordinary.reading import Reading
from sim2reason.questions.ordinary.vocabulary import QUANTITIES, matching_entry, pattern
from sim2reason.questions.query import OWN_PATH
from sim2reason.questions.structured import START, StructuredQuestion
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.simulation.quantities.subjects.bodies import Bodies, center_path

NUMBERS: Mapping[str, str] = {
    "mass": "mass",
    "speed": "initial angular speed|angular speed|initial speed|initial velocity|launch speed|starting speed"
    "|speed|velocity",
    "friction": "coefficient of friction|friction coefficient|coefficient of kinetic friction"
    "|coefficient of static friction",
    "force": "force|pull|pulling force|steady force|constant force",
    "length": "length",
    "restitution": "coefficient of restitution|restitution",
    "stiffness": "stiffness|spring constant|force constant",
    "strength": "field strength|magnetic field|electric field|strength of field|magnetic field strength"
    "|electric field strength",
    "angle": "angle|inclination|angle of SURFACE|inclination of SURFACE|launch angle|angle of inclination|slope angle",
    "height": "initial height|starting height|height",
    "exhaust": "exhaust speed",
    "rate": "burn rate",
}
"""By the last part of its address, how people call a number of a scene."""

OUTCOMES_BY_CLAUSE: Mapping[str, tuple[str, ...]] = {
    "gets over TOP|goes over TOP|get over TOP|makes full turn|goes right round|makes full circle|completes full circle"
    "|reach TOP|makes it over TOP|completes circle|passes TOP": ("goes round", "yes"),
    "slips|slides|starts to slip|begins to slip|starts to slide|begins to slide|starts to move|begins to move"
    "|slip|slide|move|starts moving|begins sliding": ("slides", "yes"),
    "slides up|slides up SURFACE|moves up|moves up SURFACE|is pulled up SURFACE|starts to move up SURFACE"
    "|goes up SURFACE|begins to move up SURFACE|begins to slide up SURFACE|starts to slide up SURFACE"
    "|is lifted|rises|starts to rise|begins to rise|move up SURFACE|slide up SURFACE|rise|is pulled upwards": (
        "rises",
        "yes",
    ),
    "does not slip|does not slide|does not move|do not slip|do not slide|do not move|stay at rest|remain at rest"
    "|stays at rest|remains at rest|rolls without slipping"
    "|not slip|not slide": ("slides", "no"),
    "goes slack|becomes slack|go slack": ("goes slack", "yes"),
    "stays taut|remains taut|does not go slack": ("goes slack", "no"),
}
"""By clauses for it, an outcome by its name, and whether it happens."""
ROLLING = {"slides": "slips rolling"}

AT_REST = "at rest"  # a required result: that no body is accelerated
NUMBER = "number"  # stands for the number that a question asks for, until its address in the scene is known
_PARAMETER = "(?:(?P<own>@\\d+@) 's )?{p=NUMBERS}(?: of (?P<of>@\\d+@))?"
_SUCH = "for which|with which|at which|such that|so that|that makes"
_NEEDED = "needed|required|necessary"
_FRAMES = (
    "what PARAMETER (?:would|must|should|does|will) {s} (?:need|have|require)[ in order](?: to|) (?P<rest>.+)",
    "what PARAMETER (?:would|must|should|will) (?P<rest>(?:make|give) {s} .+)",
    "what (?:would|must|should) PARAMETER (?:have to be|be|need to be) (?:for|so that|if) (?P<rest>.+)",
    "what PARAMETER (?:would be|is) (?:NEEDED) (?:for|so that|to) (?P<rest>.+)",
    "(?:for|with|at) what PARAMETER (?:would|does|will|is|must) (?P<rest>.+)",
    "(?:find|determine|calculate|what is) PARAMETER SUCH (?P<rest>.+)",
    "how (?:long) (?:should|must|would) (?P<of>@\\d+@) (?:have to be|be) for (?P<rest>.+)",
)
_LIMITS = (
    "(?:find|determine|calculate|what is) {size=SIZES} PARAMETER SUCH {s} {clause=OUTCOMES}",
    "what {size=SIZES} PARAMETER (?:does|must|would|should) {s} (?:need|have)[ in order] to {clause=OUTCOMES}",
    "what PARAMETER (?:would|does|must|should) {s} (?:need|have) [in order ]to just {clause=OUTCOMES}",
    "what PARAMETER is just (?:enough|sufficient) to (?:set|make|get) {s} (?P<set>in motion|move|slide|slip|moving)",
    "(?:at|from|beyond|above) what PARAMETER (?:does|will|would) {s} (?:begin|start) (?P<set>to (?:slide|slip|move))",
)
_RESULTS = (
    "{q=QUANTITY}[ (?:of|in) {t}] ~(?:to be|is|be|of|equal to|equals) {n}(?: WHEN|)",
    "{t} 's {q=QUANTITY} ~(?:is|to be|be) {n}(?: WHEN|)",
)
_ACCELERATES = "[{t} ]~(?:accelerate|accelerates) (?:at|with) {n}"
_GIVES = "(?:give|gives) {t} {q=QUANTITY} of {n}(?: WHEN|)"
_GOES = (
    "(?:make )?[{t} ]~MOTION [exactly |just ]{n} (?P<connector>before|until) (?P<clause>.+)",
    "(?:make )?[{t} ]~(?P<clause>STOPS) (?:after|within|in) [exactly |just ]{n}",
)
_AT_SPEED = "[{t} ]~(?P<clause>.+?) (?:at|with) [speed of ]{n}"
_AT_TIME = "[{t} ]~(?P<clause>.+?) (?:after|at t =) {n}"


@dataclass(frozen=True, slots=True)
class WantedNumber:
    """A number of the scene that a sentence asks for: its name, its owner, and the result to which it leads.

    The result `given`, such as *velocity = 2 m/s*, holds for the subject `of` at the moment `when`. A number that
    decides an outcome has the outcome `does` of that subject instead, whether the outcome `happens`, and whether the
    `least` or the greatest such number is asked for.
    """

    name: str
    owner: str = ""
    of: str = ""
    given: str = ""
    when: When = When("")  # noqa: RUF009 - frozen
    does: str = ""
    happens: bool = True
    least: bool | None = None


def read_wanted_numbers(sentence: TokenizedSentence) -> Iterator[WantedNumber]:
    """Yield every number of the scene that a sentence may ask for."""
    for template in _FRAMES:
        match = _compile_templates(template).fullmatch(sentence.text)
        if match is not None:
            groups = match.groupdict()
            name = matching_entry(NUMBERS, groups["p"]) if groups.get("p") else "length"
            owner = sentence.subject(groups.get("own") or groups.get("of"))
            rest = re.sub(r"^it\b", groups.get("s") or "it", groups["rest"])
            yield from _results(name, owner, rest, sentence, sentence.subject(groups.get("s")))
    known = False
    for template in _LIMITS:
        match = _compile_templates(template).fullmatch(sentence.text)
        if match is not None:
            known = True
            yield from _limits(match, sentence)
    if not known:
        for limit in read_deciding_numbers(sentence, NUMBERS):
            yield from _outcomes(limit)


def _outcomes(limit: DecidingNumber) -> Iterator[WantedNumber]:
    """Yield a wanted number for each outcome that a clause may mean."""
    if limit.does == "rests" and limit.least is None:
        yield WantedNumber(limit.name, limit.owner, limit.of, AT_REST)
        return
    does, happens = ("slides", False) if limit.does == "rests" else (limit.does, limit.happens)
    for outcome in filter(None, (does, ROLLING.get(does, ""))):
        yield WantedNumber(limit.name, limit.owner, limit.of, does=outcome, happens=happens, least=limit.least)


def _compile_templates(template: str) -> re.Pattern[str]:
    template = template.replace("PARAMETER", _PARAMETER).replace("NEEDED", _NEEDED)
    for name, rows in (
        ("NUMBERS", NUMBERS.values()),
        ("OUTCOMES", OUTCOMES_BY_CLAUSE),
        ("SIZES", ("GREATEST", "LEAST")),
    ):
        template = re.sub(
            rf"\{{(\w+)={name}\}}", lambda match, rows=rows: f"(?P<{match[1]}>(?:{'|'.join(rows)}))", template
        )
    when = rf"(?P<connector>{'|'.join(CONNECTORS)}) (?P<clause>.+)"
    return pattern(template.replace("WHEN", when).replace("SUCH", f"(?:{_SUCH})"))


def _results(name: str, owner: str, rest: str, sentence: TokenizedSentence, subject: str) -> Iterator[WantedNumber]:
    """Yield a wanted number for each way to read the result that a clause states."""
    for template in (*_RESULTS, _GIVES, _ACCELERATES, *_GOES, _AT_SPEED):
        match = _compile_templates(template).fullmatch(rest)
        if match is None:
            continue
        groups = match.groupdict()
        number = sentence.number(groups["n"])
        of = sentence.subject(groups.get("t")) or subject
        quantity = matching_entry(QUANTITIES, groups["q"]) if groups.get("q") else ""
        if template == _ACCELERATES:
            quantity = "acceleration"
        elif template == _AT_SPEED:
            quantity = "velocity"
        elif template in _GOES:
            quantity = "time" if number.endswith(" s") else "displacement"
        clause, side = groups.get("clause") or "", CONNECTORS.get(groups.get("connector") or "", "then")
        ends = read_moments(clause, sentence, of, side) if clause else [When("")]
        yield from (
            WantedNumber(name, owner, of if quantity != "time" else "", f"{quantity} = {number}", end) for end in ends
        )


def _limits(match: re.Match[str], sentence: TokenizedSentence) -> Iterator[WantedNumber]:
    groups = match.groupdict()
    name = matching_entry(NUMBERS, groups["p"])
    does, happens = ("slides", "yes") if groups.get("set") else OUTCOMES_BY_CLAUSE[_row(groups["clause"])]
    owner = sentence.subject(groups.get("own") or groups.get("of"))
    is_minimum = None if not groups.get("size") else pattern("LEAST").fullmatch(groups["size"]) is not None
    for who, outcome in product(token_subjects(sentence, groups["s"]), (does, ROLLING.get(does, ""))):
        if outcome:
            yield WantedNumber(name, owner, who, does=outcome, happens=happens == "yes", least=is_minimum)


def _row(clause: str) -> str:
    return next(row for row in OUTCOMES_BY_CLAUSE if pattern(f"(?:{row})").fullmatch(clause))


def numbers_wanted(sentence: TokenizedSentence, scene: Scene, words: Words) -> Iterator[Reading]:
    """Yield the readings of a sentence that asks for a number of the scene, with the number's address."""
    for number in read_wanted_numbers(sentence):
        path = _path(number, scene, words)
        if not path:
            continue
        if number.does:
            for rank, who in enumerate(dict.fromkeys((number.of, ""))):
                question = StructuredQuestion(path, when=f"{who} {number.does}".strip())
                yield Reading(question, least=number.least, happens=number.happens, rank=rank)
        elif number.given == AT_REST:
            yield from _balanced(path, number.of, words)
        else:
            question = StructuredQuestion(path, number.of, number.when.told, given=number.given)
            yield Reading(question, number.when.side, rank=number.when.rank)


def _balanced(path: str, of: str, words: Words) -> Iterator[Reading]:
    """Yield readings that ask for the number with which a named body, else each body, has no acceleration."""
    if lies_on_rough_face(words):
        return  # within a whole range of numbers
    alone = addresses(words).get(of)
    yield from without_acceleration(path, words.subject_phrases(Bodies()) if alone is None else (alone,), words)


def lies_on_rough_face(words: Words) -> bool:
    """Return whether a body that does not roll lies on a rough face."""
    contacts = words.mechanism.contacts
    return any(contact.friction > 0.0 and not can_roll(words, name) for name, contact in contacts.items())


def without_acceleration(path: str, names: Iterable[str], words: Words) -> Iterator[Reading]:
    """Yield the question for the number with which a body has no acceleration, for each body that moves on a line."""
    for name in names:
        senses = Bodies().senses(words.mechanism, name)
        if len(senses) == 1 or (not senses and center_path(words.mechanism, name).straight):
            along = senses[0].positive if senses else OWN_PATH
            given = f"acceleration along {along} = 0 m/s^2"
            yield Reading(StructuredQuestion(path, name, START, given=given))


def _path(number: WantedNumber, scene: Scene, words: Words) -> str:
    """Return the address of the number that a sentence asks for; empty unless exactly one number matches."""
    given = [p.path for p in scene.parameters if p.value is not None and not p.hidden]
    owners = [address for address, phrase in words.mentions.items() if phrase == number.owner]
    named = [path for path in given if path.rpartition(".")[2] == number.name]
    if number.owner:
        named = [path for path in named if path.rpartition(".")[0] in owners]
    return named[0] if len(named) == 1 else ""
