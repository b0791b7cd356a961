"""Paraphrases of main clauses, selected by the quantity asked for and accepted only if they use every word."""

import re
from collections.abc import Iterator
from functools import cache

from sim2reason.questions.ordinary.base_forms import PLACES, WAY, way_of, with_base_forms
from sim2reason.questions.ordinary.main_rows import ALL_COLLISIONS, ROWS, SIZES, VERBS, S
from sim2reason.questions.ordinary.vocabulary import GROUNDS, PHRASES, QUANTITIES, either
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
        told = told.replace(f"{{{name}}}", either(QUANTITIES[f"{name} force"].split("|")))
    return re.compile(rf"(?<![\w@#-])(?:{told.replace('SURFACE', GROUNDS).replace('GROUNDS', GROUNDS)})(?![\w@#-])")


@cache
def _quantities() -> str:
    said = [name for row in QUANTITIES.values() for name in row.split("|")]
    plain = {name for name in said if name not in ("distance", "height", "altitude", "separation", "length", "mass")}
    return "|".join(sorted({*plain, "mass"}, key=len, reverse=True))


@cache
def _motions() -> str:
    return either(PHRASES["ITS_MOTION"].split("|"))


def paraphrased(question: str) -> Iterator[str]:
    """Yield plain equivalents of a main clause, if they account for every word of the clause."""
    if re.search(r"between (@\d+@) and \1", question) is not None:
        return
    supposes = re.sub(r"radius of .*?(?:on|along|in) which", "", question)
    if _ASKS.search(question) is None or _SUPPOSES.search(supposes) is not None:
        return
    if re.search(r"\b(?:does|do|did|will) @\d+@ (?:get )?(?:stretch|compress|extend|shorten|lengthen)", question):
        return  # a change of the length, maybe not counted from the natural length
    text = " ".join(WAY.sub(lambda found: f" <{way_of(found['way'])}> ", _singular(question)).split())
    text = _WORK_OUT.sub("find", with_base_forms(text))
    for row in ROWS:
        yield from _filled(row, text)


def _singular(text: str) -> str:
    """Return a text with its quantities in the singular."""
    return re.sub(r"\b(tension|acceleration|speed|velocitie|force|momentum|distance)s\b(?! up)", _one, text)


def _one(found: re.Match[str]) -> str:
    return found[1].replace("velocitie", "velocity")


def _side(plain: str, said: str) -> str:
    """Return the side of a point as a direction, *up* or *down*, or as *above* or *below*."""
    above = said == "above"
    return ("up" if above else "down") if "vertically" not in plain else ("above" if above else "below")


def _without_parts(row: WantedRow, text: str, groups: dict[str, str]) -> str | None:
    """Return a text without the words that a row's patterns match; None if one has no match. Groups go to `groups`."""
    for told in row.parts:
        found = _part(told.removeprefix("?")).search(text)
        if found is None and told.startswith("?"):
            continue
        if found is None:
            return None
        groups |= {name: said for name, said in found.groupdict().items() if said}
        groups["verb"] = next(
            (verb for verb, forms in VERBS.items() if re.fullmatch(forms, found[0])), groups.get("verb", "")
        )
        groups["axis"] = found[0][0] if re.match("[xy][- ]", found[0]) else groups.get("axis", "")
        text = f"{text[: found.start()]} {text[found.end() :]}"
    return text


def _filled(row: WantedRow, text: str) -> Iterator[str]:
    """Yield a row's plain clause, filled in, if a text has all parts of the row and otherwise only fillers."""
    groups = dict[str, str]()
    rest = _without_parts(row, text, groups)
    if rest is None or _MATTERS.search(rest) is not None:
        return
    ways = re.findall(r"<(.+?)>", rest)
    rest = PLACES.sub(" ", re.sub(r"<.+?>", " ", rest))
    subjects = list(dict.fromkeys(re.findall(S, rest)))
    if set(re.sub(S, " ", rest).split()) - _LOOSE or len(ways) > ("{way}" in row.plain) or len(subjects) > row.subjects:
        return
    if (row.subjects == 2 and not subjects) or (row.plain == ALL_COLLISIONS and subjects):
        return
    force = row.plain.startswith(("what force does", "what force acts", "what force of string")) or groups.get(
        "quantity"
    ) in ("force", "pull")
    if force and _ON_GROUND.search(text) is not None:
        return
    if "impulse does {s}" in row.plain and re.search(GROUNDS, text) is not None:
        return  # exchanged with that
    size = next((name for name in SIZES if groups.get(name)), "")
    verb = groups.get("verb") or "move"
    one, other = (*subjects, "", "")[:2]
    told = row.plain.format(
        s=one,
        t=other,
        way=f" {ways[0]}" if ways else "",
        verb=verb,
        size=size,
        axis=groups.get("axis", ""),
        quantity=groups.get("quantity", ""),
        toward=groups.get("toward", "").strip("<>"),
        side=_side(row.plain, groups.get("side", "")),
        line=groups.get("line", ""),
        speed="angular speed" if verb == "turn" else "speed",
    )
    yield re.sub(
        r" (?:of|in|by)(?= ?$)| of (?=about its axis$)| and(?= ?$| move )|(?<=give) $", "", " ".join(told.split())
    )
