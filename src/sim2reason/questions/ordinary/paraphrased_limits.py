"""Patterns of questions, in any word order, for the number that decides about an outcome."""

import re
from collections.abc import Iterator, Mapping
from functools import cache
from typing import NamedTuple

from sim2reason.questions.ordinary.base_forms import PLACES, WAY, way_of, with_base_forms
from sim2reason.questions.ordinary.clause_heads import START_WORDS, S
from sim2reason.questions.ordinary.hearing import TokenizedSentence
from sim2reason.questions.ordinary.vocabulary import either, matching_entry

OUTCOMES: Mapping[str, tuple[str, bool]] = {
    r"roll without (?:slip|slide|skid)(?:ping)?|not (?:begin |start )?(?:to )?(?:slip|skid)|without slip(?:ping)?": (
        "slides",
        False,
    ),
    rf"(?:keep|prevent|stop|hold) (?={S})(?P<kept>{S}) from (?:move|slide|accelerate|fall|rise|slip)"
    r"|(?:remain|stay|keep|be|hold|leave)? ?(?:at rest|in equilibrium|in balance|motionless|stationary|balanced)"
    r"|balance"
    r"|not (?:begin |start )?(?:to )?(?:move|accelerate|slide)|remain where it|stay put": ("rests", True),
    r"(?:(?:begin|start|be able) (?:to )?)?(?:move|slide|go|pull|climb|rise|lift|haul|drag) <up>"
    r"|(?:begin|start) (?:to )?(?:rise|climb|ascend)": ("rises", True),
    r"(?:begin|start) (?:to )?(?:slip|slide|move|skid)|set in motion": ("slides", True),
    r"(?:over|past|through|reach|beyond|get over) (?:top|highest point)|(?:all way (?:round|around) )?(?:in"
    r" )?(?:full|complete|whole) (?:turn|circle|revolution|loop)"
    r"|(?:all way|right) (?:round|around)": ("goes round", True),
    r"(?:stay|remain|keep) taut|not go slack": ("goes slack", False),
    r"(?:go|become|get) slack": ("goes slack", True),
}
"""By the base form of a clause, the outcome, and whether it happens; *rests* is that everything stays at rest."""

_LOOSE = frozenset(
    re.split(
        " ",
        "what which find determine calculate compute how large big great must would should could need needed "
        "require make required necessary enough sufficient just have to be for so that such with in order allow let "
        "keep everything all system whole it they can still at it go carry bring get give of on prevent from where "
        "if start than and barely the value whole just pull push exert apply slow release launch let will leave put",
    )
)
_SIZES = {
    True: "least|minimum|minimal|smallest|lowest",
    False: "greatest|maximum|maximal|largest|highest|biggest",
}


_HEAVY = re.compile(
    r"\bhow (?P<word>heavy|light) (?P<verb>would|must|should|could|may) (?P<who>@\d+@) (?:have to )?be\b"
)
_HAS = re.compile(r"\b(?:would|must|should|could|may|does) (?P<who>@\d+@) (?:need to |have to )?have\b")
_ASIDES = re.compile(
    rf"\b(?:after|when|on|once|as soon as)(?: (?:its|their|system|everything|it|@\d+@))?(?: (?:is|are|has been))?"
    rf" {START_WORDS}(?:ed|s|d)?\b"
    r"|,? ?\bat same (?:angle|place|position|height|point)\b ?,?"
    r"|\b(?:from|in|at) (?:this|that|its|same|its initial|initial|its starting|its own|starting|original)"
    r" (?:position|place|point)\b"
    r"|\b(?:in|on) place\b|\bat all\b|\bjust like this\b|\bby hand\b|(?<=would )hand\b|(?<=must )hand\b"
)
"""What is passed over: what only says that the motion begins, or that all else is as it was."""


def _mass(found: re.Match[str]) -> str:
    """Return *how heavy would A have to be* as a question for the mass of A."""
    return f"what mass {found['verb']} {found['who']} have"


_ALL = re.compile(r"\b(?:everything|system|all|equilibrium|balance|balanced)\b")


_WISHES = re.compile(
    r"\b(?:would|must|should|could|may|need|needs|needed|requires?|required|necessary|which|such|so that|so|enough"
    r"|sufficient"
    r"|least|minimum|minimal|smallest|lowest|greatest|maximum|maximal|largest|highest|biggest|have to|has to|does"
    r" @\d+@ have"
    r"|(?:for|with|at|from|above|below|beyond) what|just|to)\b"
)


class DecidingNumber(NamedTuple):
    """A number, such as a mass, that decides whether an outcome occurs, with the outcome and the extreme asked for."""

    name: str
    owner: str
    does: str
    happens: bool
    of: str
    least: bool | None


def limits(heard: TokenizedSentence, numbers: Mapping[str, str]) -> Iterator[DecidingNumber]:
    """Yield the number that a sentence such as *what mass makes A slip* asks for, if this accounts for every word."""
    text = " ".join(WAY.sub(lambda found: f" <{way_of(found['way'])}> ", _HEAVY.sub(_mass, heard.text)).split())
    asked = _parameter(tuple(numbers.values())).search(text)
    if asked is None or re.match(r"(?:what|which|find|determine|calculate|compute|how|for|with|at)\b", text) is None:
        return
    if _WISHES.search(text) is None:
        return  # *the length of the spring in equilibrium* is what it is there
    rest = f"{text[: asked.start()]} {text[asked.end() :]}"
    has = _HAS.search(rest) if not (asked["own"] or asked["of"]) else None
    owner = heard.subject(asked["own"] or asked["of"] or (has["who"] if has is not None else None))
    rest = with_base_forms(_ASIDES.sub(" ", rest if has is None else f"{rest[: has.start()]} {rest[has.end() :]}"))
    for told, (does, happens) in OUTCOMES.items():
        found = re.search(rf"(?<![\w@])(?:{told})(?![\w@])", rest)
        if found is None:
            continue
        others, least = f"{rest[: found.start()]} {rest[found.end() :]}", None
        for small, row in _SIZES.items():
            others, count = re.subn(rf"\b(?:{row})\b", " ", others)
            least = small if count else least
        subjects = list(dict.fromkeys(re.findall(r"@\d+@", f"{others} {found.groupdict().get('kept') or ''}")))
        words = PLACES.sub(" ", re.sub(r"@\d+@", " ", others)).split()
        if len(subjects) <= 1 and not set(words) - _LOOSE:
            alone = has["who"] if has is not None and not _ALL.search(others) else None
            of = heard.subject(subjects[0] if subjects else alone)
            name = matching_entry(numbers, asked["p"])
            owner = owner or (of if does == "rests" and name == "mass" else "")
            yield DecidingNumber(name, owner, does, happens, of, least)
            return


_NOT_NATURAL = r"(?:(?<!initial )(?<!starting )(?<!original )|(?!length))"  # *the starting length* is another number


@cache
def _parameter(rows: tuple[str, ...]) -> re.Pattern[str]:
    names = either(name for row in rows for name in row.split("|"))
    name = rf"(?<![\w-]){_NOT_NATURAL}(?P<p>{names})(?![\w-])"
    return re.compile(rf"(?:(?P<own>@\d+@) 's )?{name}(?: of (?P<of>@\d+@))?(?: at start)?")
