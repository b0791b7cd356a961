"""Hints such as *a heavier block*, which imply that the number is greater or less than at present."""

import re
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from sim2reason.questions.following import FollowedMotion
from sim2reason.questions.ordinary.hearing import TokenizedSentence
from sim2reason.questions.ordinary.vocabulary import GROUNDS
from sim2reason.questions.ordinary.whatif.frames import WantedFrame
from sim2reason.questions.ordinary.whatif.numbers import NUMBERS
from sim2reason.questions.unknown import number_at

_NOUNS = "|".join(kind.nouns for name, kind in NUMBERS.items() if name != "motion at start")
_NUMBER = rf"(?:@\d+@ 's |its )?(?:{_NOUNS})(?: of @\d+@| between @\d+@ and (?:@\d+@|{GROUNDS}))?"
_AUX = "(?:would|must|should|could|will|does|can|has|might|may|is|are|were|was|had)"
_HAVE = "(?:have to |need to |has to |needs to |had to |to )?"
_THING = rf"(?:@\d+@|{GROUNDS}|wall|surface|surfaces|(?:electric |magnetic )?field)"
_MORE = {
    "heavier|more massive": "mass",
    "stiffer|harder|stronger": "stiffness",
    "rougher": "friction",
    "longer": "length",
    "faster|quicker": "speed",
    "steeper": "slope",
}
_LESS = {
    "lighter|less massive": "mass",
    "softer|weaker": "stiffness",
    "smoother|less rough": "friction",
    "shorter": "length",
    "slower": "speed",
    "flatter|less steep|gentler": "slope",
}
_COMPARATIVES = {word: (kind, rows is _MORE) for rows in (_MORE, _LESS) for told, kind in rows.items()
                 for word in told.split("|")}  # fmt: skip
_ADJ = "|".join(sorted(_COMPARATIVES, key=len, reverse=True))
_GREATER = "larger|greater|higher|bigger|increased|raised"
_SMALLER = "smaller|lower|less|reduced|lowered|decreased|diminished"
_CHANGED = r"(?P<up>increased|raised|enlarged)|(?P<down>reduced|lowered|decreased|diminished|cut)|changed|altered|set"
_SUPPOSE = (
    r"(?:(?:suppose|imagine|assume|consider|say)(?: now)?(?: that)? (?P<s>SAID)"
    r"|(?:let us |let |one |we |someone |you )?(?:now )?(?:replace|exchange|swap|change)s? (?P<swap>SAID))\. "
).replace("SAID", r"[^.#]+")
_WERE = r"(?:is|are|was|were|could be|can be|may be|had been|would be|be|becomes?|has|have|had)"
_MADE = "(?:made|chosen|taken|replaced by|exchanged for|swapped for|changed for|substituted by|changed|varied|adjusted)"
_ONE = (
    "(?:one|@\\d+@|block|body|ball|spring|load|string|cord|rope|cart|trolley|object|mass|weight|planet|star"
    "|disc|puck|rod|bead)"
)
_OTHER = rf"(?:a |another |some )?(?:(?P<adj>{_ADJ})|different|other|another)(?: {_ONE})?(?: instead)?"
_SUPPOSED = (
    rf"(?P<thing>{_THING}) {_WERE} (?:{_MADE} )?(?:(?:much|even|somewhat|a little|slightly|made|still) )*{_OTHER}",
    (
        rf"(?P<n>{_NUMBER}) {_WERE} (?:(?:made|to|{_MADE}) )*(?:(?P<more>{_GREATER})|(?P<less>{_SMALLER})|different"
        rf"|changed"
        r"|varied|adjusted|adjustable|variable|not known|unknown)"
    ),
    rf"(?P<thing>@\d+@) (?:by|for|with) {_OTHER}",
    rf"(?:there {_WERE} )?(?:(?P<rub>more)|(?P<slip>less)) friction",
    (
        r"hand (?:pulls|pulled|were to pull|tugs|tugged)(?: (?:much|even|somewhat|a little|slightly))?"
        r" (?:(?P<hard>harder|more strongly)"
        r"|less (?:hard|strongly)|more gently)"
    ),
)


class ToldDirection(NamedTuple):
    """A question without its hint that the number is greater or less than in the scene, and that hint.

    `grows` is None if the sentence does not tell whether the number is to be greater or less than it is. The `kind` of
    the number and the token of the `thing` that has it are empty if they are not told.
    """

    text: str
    kind: str = ""
    thing: str = ""
    grows: bool | None = None


def told_direction(text: str) -> ToldDirection:
    """Return the parts of a sentence such as *suppose C is replaced by a heavier block. what mass ...*."""
    found = re.match(_SUPPOSE, text)
    if found is None:
        return _of_value(text) or ToldDirection(text)
    said = (found["s"] or found["swap"]).strip(" ,")
    meant = next(filter(None, (re.fullmatch(told, said) for told in _SUPPOSED)), None)
    return ToldDirection(text) if meant is None else _told(text[found.end() :], meant)


def _told(rest: str, meant: re.Match[str]) -> ToldDirection:
    groups = {name: group or "" for name, group in meant.groupdict().items()}
    if groups.get("adj"):
        kind, grows = _COMPARATIVES[groups["adj"]]
        kind = groups["thing"] if groups["thing"].endswith("field") else kind
        return ToldDirection(rest, kind, _token(groups["thing"]), grows)
    if groups.get("rub") or groups.get("slip"):
        return ToldDirection(rest, "friction", "", bool(groups["rub"]))
    if meant[0].startswith("hand "):
        return ToldDirection(rest, "force", "", bool(groups.get("hard")))
    number = groups.get("n", "")
    grows = True if groups.get("more") else False if groups.get("less") else None
    return ToldDirection(rest, _kind(number), _token(number or groups["thing"]), grows)


def _token(said: str) -> str:
    found = re.search(r"@\d+@", said)
    return found[0] if found is not None else ""


def _kind(number: str) -> str:
    """Return the kind of a number that a phrase such as *mass of @0@* names; empty for no phrase."""
    bare = re.sub(r"^(?:@\d+@ 's |its )| (?:of|between) @.*$", "", number)
    return next((name for name, kind in NUMBERS.items() if re.fullmatch(kind.nouns, bare)), "")


def _of_value(text: str) -> ToldDirection | None:
    """Return *to what value must A's mass be reduced* as *what must A's mass be*, with the hint *less*; else None."""
    found = re.match(
        rf"to (?:what|which) (?:(?:new|other|different|smaller|larger|lower|higher) )*(?:value )?(?P<aux>{_AUX})"
        rf" (?:one|we|you)"
        rf" {_HAVE}(?:(?P<up>increase|raise|enlarge)|(?P<down>reduce|lower|decrease|diminish|cut)|change|alter|set)"
        rf" (?P<n>{_NUMBER}) (?=for |so |to |if |in )",
        text,
    )
    found = found or re.match(
        rf"to (?:what|which) (?:(?:new|other|different|smaller|larger|lower|higher) )*(?:value )?(?P<aux>{_AUX})"
        rf" (?P<n>{_NUMBER}) {_HAVE}be (?:{_CHANGED}) (?=for |so |to |if |in )",
        text,
    )
    found = found or re.match(
        rf"to (?:what|which) (?P<n>{_NOUNS}) (?P<aux>{_AUX}) (?P<s>@\d+@) {_HAVE}be (?:{_CHANGED}) (?=for |so "
        rf"|to |if |in )",
        text,
    )
    if found is None:
        return None
    grows = True if found["up"] else False if found["down"] else None
    of = f" of {found['s']}" if found.groupdict().get("s") else ""
    return ToldDirection(f"what would {found['n']}{of} have to be {text[found.end() :]}", grows=grows)


def directed(frames: Iterable[WantedFrame], told: ToldDirection, heard: TokenizedSentence) -> Iterator[WantedFrame]:
    """Yield the parsed questions whose number a hint such as *heavier* concerns, with the direction it implies."""
    for frame in frames:
        owners = frame.number.owners or ((heard.subject(frame.subject),) if frame.subject else ())
        of_it = not told.thing or not owners or heard.subject(told.thing) in owners
        if (not told.kind or told.kind == frame.number.kind) and of_it:
            yield frame if told.grows is None else frame._replace(grows=told.grows)


def told_values(values: Sequence[float], path: str, frame: WantedFrame, motion: FollowedMotion) -> list[float]:
    """Return the values of a number that are greater, or less, than the present one, as hinted; else all."""
    now = number_at(motion.study.scene, path)
    return [value for value in values if frame.grows is None or (value > now) == frame.grows]
