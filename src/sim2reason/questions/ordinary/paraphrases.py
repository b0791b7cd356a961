"""Paraphrases of main clauses, and of questions for a limiting number, in any order of words."""

import re
from collections.abc import Iterator, Mapping
from functools import cache
from typing import NamedTuple

from sim2reason.questions.ordinary.base_forms import DIRECTION_PATTERN, PLACE_PATTERN, way_of, with_base_forms
from sim2reason.questions.ordinary.clause_heads import START_WORDS, S
from sim2reason.questions.ordinary.hearing import TokenizedSentence
from sim2reason.questions.ordinary.main_rows import ALL_COLLISIONS, ROWS, SIZES, VERBS
from sim2reason.questions.ordinary.vocabulary import GROUNDS, PHRASES, QUANTITIES, any_of_pattern, matching_entry
from sim2reason.questions.ordinary.wanted_row import WantedRow

_ASKS = re.compile(r"\b(?:what|which|where|find|determine|calculate|compute|give|how|obtain|work out|when)\b")
_WORK_OUT = re.compile(r"\bwork out\b")
_SUPPOSES = re.compile(
    r"\b(?:would|must|should|could|need|needed|required|if|not|half|without|more|less|average|mean|next|last(?= \w)"
    r"|another|second|third|(?:with|for|at|such) (?:which|that))\b"
)
_MATTERS = re.compile(rf"\babove (?:{GROUNDS})|\bby how much\b|\bmeasured along\b")
"""Phrases that name no height above the start: *above the ground*, *by how much*, *measured along*."""
_ON_GROUND = re.compile(rf"\bon (?:{GROUNDS})")  # a force on that
_LOOSE = frozenset(
    re.split(
        " ",
        "what which find determine calculate compute give how obtain large big great strong much high "
        "value size magnitude amount long of in on that for at with to by it its 's the a an , during while and "
        "along reach attain achieve acquire possess get go exert act experience undergo feel provide supply have "
        "exist between as from due upon body thing numerical modulus strength kind sort measured occur happen arise "
        "prevail through",
    )
)


@cache
def _part(told: str) -> re.Pattern[str]:
    for name, row in SIZES.items():
        told = told.replace(f"{{{name}}}", f"(?:{row})")
    told = told.replace("{size}", "|".join(f"(?P<{name}>{row})" for name, row in SIZES.items()))
    told = told.replace("{quantity}", f"(?P<quantity>{_quantities()})").replace("{motion}", _motions())
    for name in ("friction", "normal"):
        told = told.replace(f"{{{name}}}", any_of_pattern(QUANTITIES[f"{name} force"].split("|")))
    return re.compile(rf"(?<![\w@#-])(?:{told.replace('SURFACE', GROUNDS).replace('GROUNDS', GROUNDS)})(?![\w@#-])")


@cache
def _quantities() -> str:
    names = [name for row in QUANTITIES.values() for name in row.split("|")]
    plain = {name for name in names if name not in ("distance", "height", "altitude", "separation", "length", "mass")}
    return "|".join(sorted({*plain, "mass"}, key=len, reverse=True))


@cache
def _motions() -> str:
    return any_of_pattern(PHRASES["ITS_MOTION"].split("|"))


def paraphrased(question: str) -> Iterator[str]:
    """Yield plain equivalents of a main clause, if they account for every word of the clause."""
    if re.search(r"between (@\d+@) and \1", question) is not None:
        return
    supposes = re.sub(r"radius of .*?(?:on|along|in) which", "", question)
    if _ASKS.search(question) is None or _SUPPOSES.search(supposes) is not None:
        return
    if re.search(r"\b(?:does|do|did|will) @\d+@ (?:get )?(?:stretch|compress|extend|shorten|lengthen)", question):
        return  # a change of the length, maybe not counted from the natural length
    text = " ".join(DIRECTION_PATTERN.sub(lambda match: f" <{way_of(match['way'])}> ", _singular(question)).split())
    text = _WORK_OUT.sub("find", with_base_forms(text))
    for row in ROWS:
        yield from _filled(row, text)


def _singular(text: str) -> str:
    """Return a text with its quantities in the singular."""
    return re.sub(r"\b(tension|acceleration|speed|velocitie|force|momentum|distance)s\b(?! up)", _one, text)


def _one(match: re.Match[str]) -> str:
    return match[1].replace("velocitie", "velocity")


def _side(plain: str, side: str) -> str:
    """Return the side of a point as a direction, *up* or *down*, or as *above* or *below*."""
    above = side == "above"
    return ("up" if above else "down") if "vertically" not in plain else ("above" if above else "below")


def _without_parts(row: WantedRow, text: str, groups: dict[str, str]) -> str | None:
    """Return a text without the words that a row's patterns match; None if one has no match. Groups go to `groups`."""
    for part in row.parts:
        match = _part(part.removeprefix("?")).search(text)
        if match is None and part.startswith("?"):
            continue
        if match is None:
            return None
        groups |= {name: value for name, value in match.groupdict().items() if value}
        groups["verb"] = next(
            (verb for verb, forms in VERBS.items() if re.fullmatch(forms, match[0])), groups.get("verb", "")
        )
        groups["axis"] = match[0][0] if re.match("[xy][- ]", match[0]) else groups.get("axis", "")
        text = f"{text[: match.start()]} {text[match.end() :]}"
    return text


def _filled(row: WantedRow, text: str) -> Iterator[str]:
    """Yield a row's plain clause, filled in, if a text has all parts of the row and otherwise only fillers."""
    groups = dict[str, str]()
    rest = _without_parts(row, text, groups)
    if rest is None or _MATTERS.search(rest) is not None:
        return
    ways = re.findall(r"<(.+?)>", rest)
    rest = PLACE_PATTERN.sub(" ", re.sub(r"<.+?>", " ", rest))
    subjects = list(dict.fromkeys(re.findall(S, rest)))
    plain = row.plain_clause
    if set(re.sub(S, " ", rest).split()) - _LOOSE or len(ways) > ("{way}" in plain) or len(subjects) > row.subjects:
        return
    if (row.subjects == 2 and not subjects) or (plain == ALL_COLLISIONS and subjects):
        return
    force = plain.startswith(("what force does", "what force acts", "what force of string")) or groups.get(
        "quantity"
    ) in ("force", "pull")
    if force and _ON_GROUND.search(text) is not None:
        return
    if "impulse does {s}" in plain and re.search(GROUNDS, text) is not None:
        return  # exchanged with that
    size = next((name for name in SIZES if groups.get(name)), "")
    verb = groups.get("verb") or "move"
    one, other = (*subjects, "", "")[:2]
    clause = plain.format(
        s=one,
        t=other,
        way=f" {ways[0]}" if ways else "",
        verb=verb,
        size=size,
        axis=groups.get("axis", ""),
        quantity=groups.get("quantity", ""),
        toward=groups.get("toward", "").strip("<>"),
        side=_side(plain, groups.get("side", "")),
        line=groups.get("line", ""),
        speed="angular speed" if verb == "turn" else "speed",
    )
    yield re.sub(
        r" (?:of|in|by)(?= ?$)| of (?=about its axis$)| and(?= ?$| move )|(?<=give) $", "", " ".join(clause.split())
    )


OUTCOMES_BY_PATTERN: Mapping[str, tuple[str, bool]] = {
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

_LIMIT_FILLERS = frozenset(
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


def _mass(match: re.Match[str]) -> str:
    """Return *how heavy would A have to be* as a question for the mass of A."""
    return f"what mass {match['verb']} {match['who']} have"


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


def read_deciding_numbers(sentence: TokenizedSentence, numbers: Mapping[str, str]) -> Iterator[DecidingNumber]:
    """Yield the number that a sentence such as *what mass makes A slip* asks for, if this accounts for every word."""
    text = " ".join(
        DIRECTION_PATTERN.sub(lambda match: f" <{way_of(match['way'])}> ", _HEAVY.sub(_mass, sentence.text)).split()
    )
    number_match = _parameter(tuple(numbers.values())).search(text)
    if (
        number_match is None
        or re.match(r"(?:what|which|find|determine|calculate|compute|how|for|with|at)\b", text) is None
    ):
        return
    if _WISHES.search(text) is None:
        return  # *the length of the spring in equilibrium* is what it is there
    rest = f"{text[: number_match.start()]} {text[number_match.end() :]}"
    has = _HAS.search(rest) if not (number_match["own"] or number_match["of"]) else None
    owner = sentence.subject(number_match["own"] or number_match["of"] or (has["who"] if has is not None else None))
    rest = with_base_forms(_ASIDES.sub(" ", rest if has is None else f"{rest[: has.start()]} {rest[has.end() :]}"))
    for wording, (does, happens) in OUTCOMES_BY_PATTERN.items():
        match = re.search(rf"(?<![\w@])(?:{wording})(?![\w@])", rest)
        if match is None:
            continue
        others, smallest = f"{rest[: match.start()]} {rest[match.end() :]}", None
        for small, row in _SIZES.items():
            others, count = re.subn(rf"\b(?:{row})\b", " ", others)
            smallest = small if count else smallest
        subjects = list(dict.fromkeys(re.findall(r"@\d+@", f"{others} {match.groupdict().get('kept') or ''}")))
        words = PLACE_PATTERN.sub(" ", re.sub(r"@\d+@", " ", others)).split()
        if len(subjects) <= 1 and not set(words) - _LIMIT_FILLERS:
            alone = has["who"] if has is not None and not _ALL.search(others) else None
            of = sentence.subject(subjects[0] if subjects else alone)
            name = matching_entry(numbers, number_match["p"])
            owner = owner or (of if does == "rests" and name == "mass" else "")
            yield DecidingNumber(name, owner, does, happens, of, smallest)
            return


_NOT_NATURAL = r"(?:(?<!initial )(?<!starting )(?<!original )|(?!length))"  # *the starting length* is another number


@cache
def _parameter(rows: tuple[str, ...]) -> re.Pattern[str]:
    names = any_of_pattern(name for row in rows for name in row.split("|"))
    name = rf"(?<![\w-]){_NOT_NATURAL}(?P<p>{names})(?![\w-])"
    return re.compile(rf"(?:(?P<own>@\d+@) 's )?{name}(?: of (?P<of>@\d+@))?(?: at start)?")
