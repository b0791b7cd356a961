"""Statements of an answer, their sides, and the choice of the side that is the value.

The last right-hand side counts. Sides before it are names, symbolic steps, or numeric claims, which must agree with it.
Ambiguous answers are refused here.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Final

from sim2reason.grading import labels, remarks
from sim2reason.grading.alphabet import CLOSES
from sim2reason.grading.score import Outcome, Refused
from sim2reason.grading.tokens import Token

__all__ = ["Statement", "flatten", "is_signed", "more_or_less", "statement", "two_values", "unwrap"]

_NO_NAME: Final = frozenset({"number", "symbol", "fraction", "root", "function"})  # of what has no value here
_SPECIAL: Final = frozenset({"relation", "hedge", "soft", "arrow", "step", "colon", "stop"})
_DIVIDING: Final = frozenset({"step", "word", "arrow", "hedge"})
_STEPS: Final = frozenset({"so", "hence", "thus", "therefore", "thereby"})
_SAYS: Final = frozenset({"is", "equals", "was"})
_CONDITIONS: Final = frozenset({"at", "when", "for", "after", "with", "given", "from", "since"})
_NUMERIC: Final = frozenset({"number", "part", "plus", "minus", "dash", "slash", "times"})

Tokens = list[Token]


@dataclass(frozen=True, slots=True)
class Statement:
    """The last equation of an answer: its side with the value, and the earlier sides that are more than a name.

    `doubt` is a token on the value's own side that may offer another value, unless it is part of a remark. `rounded`
    means that the value follows a sign for *approximately*, `named` that an earlier side is a name. `others` are the
    sides of steps that name something else: a value among them must equal this one.
    """

    value: Tokens
    before: tuple[Tokens, ...] = ()
    doubt: Token | None = None
    rounded: bool = False
    named: bool = False
    others: tuple[Tokens, ...] = ()

    def refuse_unsolved(self, side: Tokens) -> None:
        """Raise Refused for an unsolved equation, such as 2T = 9.8, or a sum, unless another side is a name."""
        if not self.named and (labels.is_compound(side) or labels.is_mixed_sum(side)):
            raise _unreadable("it is an equation that is still to be solved")


def statement(tokens: Tokens) -> Statement:
    """Return the statement that an answer's tokens make.

    Raises `Refused`: wrong for hedges (a list, a range, ±, "or", an inequality), unreadable if nothing or too much
    remains as the value.
    """
    tokens = unwrap(tokens)
    kinds = {token.kind for token in tokens}
    if not tokens:
        raise _unreadable("there is nothing in the box that could be a value")
    if "hedge" in kinds:
        _refuse_hedges(tokens)
    if tokens[0].kind == "word":
        tokens = _without_hedge(tokens)
    elif kinds.isdisjoint(_SPECIAL):
        return Statement(tokens)
    parts = _parts(tokens)
    sides, relations = _sides(parts[-1][1])
    others: list[Tokens] = []
    for (_, earlier), (step, _) in pairwise(parts):
        others += _check_earlier(earlier, sides[0] if len(sides) > 1 else [], implied=step)
    chosen = _chosen(sides, relations)
    return replace(chosen, others=tuple(others)) if others else chosen


def _unreadable(why: str) -> Refused:
    return Refused(Outcome.UNREADABLE, why)


def two_values() -> Refused:
    """Return the refusal of an answer that assigns two values."""
    return _unreadable("it names two values, and nothing says which is meant")


def more_or_less(token: Token) -> Refused:
    """Return the refusal of an answer in which a token, such as ±, makes the value ambiguous."""
    return Refused(Outcome.WRONG, f"'{token.shown}' makes it more, or less, than one value")


def _refuse_hedges(tokens: Tokens) -> None:
    """Raise Refused for hedges such as *or*; signs between statements are checked later."""
    for token in tokens:
        if token.kind == "hedge" and token.text != ",":
            raise more_or_less(token)


def _without_hedge(tokens: Tokens) -> Tokens:
    """Return the tokens of a statement without an initial word for *approximately*."""
    if tokens[0].text.lower() in remarks.APPROXIMATELY:
        skip = 2 if len(tokens) > 1 and tokens[1].kind == "stop" else 1
        return tokens[skip:]
    return tokens


def _parts(tokens: Tokens) -> list[tuple[bool, Tokens]]:
    """Return the equations and values in an answer, each with whether it follows from earlier ones (*so*, ⇒)."""
    parts: list[tuple[bool, Tokens]] = [(False, [])]
    depth = 0
    kinds = [token.kind for token in tokens]
    last = len(kinds) - 1 - kinds[::-1].index("relation") if "relation" in kinds else -1
    related = False  # whether the statement that is being read has a relation
    for position, token in enumerate(tokens):
        kind = kinds[position]
        depth += (kind == "open") - (kind == "close")
        divides = depth == 0 and kind in _DIVIDING
        if divides and (implied := _divides(tokens, position, related=position < last)) is not None:
            if parts[-1][1]:
                parts.append((implied, []))
                related = False
            elif implied:  # behind a comma: *so* says more
                parts[-1] = (True, [])
            elif position == 0 and kind == "hedge":
                raise more_or_less(token)
            continue
        if depth == 0 and token.apart > 1 and related and position <= last:
            parts.append((False, []))
            related = False
        related = related or kind == "relation"
        parts[-1][1].append(token)
    if not parts[-1][1]:
        parts.pop()
    if not parts:
        raise _unreadable("there is nothing in the box that could be a value")
    return parts


def _divides(tokens: Tokens, position: int, *, related: bool) -> bool | None:
    """Return whether a new equation begins after a token, as a conclusion (True) or not; None if none begins.

    `related` means that a relation follows.
    """
    token = tokens[position]
    if token.kind == "step" or (token.kind == "word" and token.text.lower() in _STEPS):
        return True
    if token.kind == "arrow":
        return True if related else None
    if token.kind != "hedge" or token.text != ",":
        return None
    following = next((later for later in tokens[position + 1 :] if later.kind != "open"), None)
    if following is None or following.kind == "arrow":
        return None
    remark = following.kind in {"word", "soft"} and remarks.begins(following.text)
    return None if remark and not related else False


def _sides(tokens: Tokens) -> tuple[list[Tokens], list[Token]]:
    """Return the sides of an equation such as F = m a = 3 N, and the tokens between them: signs, colons or verbs."""
    sides: list[Tokens] = [[]]
    relations: list[Token] = []
    depth = 0
    seen_kinds: set[str] = set()  # a name ends at the first colon or the first verb, or at none: so this stays linear
    for token in unwrap(tokens):
        kind = token.kind
        depth += (kind == "open") - (kind == "close")
        says = kind == "colon" or (kind == "word" and token.text.lower() in _SAYS)
        if says := says and depth == 0 and len(sides) == 1 and kind not in seen_kinds:
            seen_kinds.add(kind)
        if (depth == 0 and kind == "relation") or (says and labels.is_name(sides[0])):
            if not sides[-1] and relations and relations[-1].kind != "colon" and relations[-1].kind != "word":
                raise _unreadable("there is nothing between two signs of equality")
            sides.append([])
            relations.append(token)
        else:
            sides[-1].append(token)
    return sides, relations


def _check_earlier(tokens: Tokens, name: Tokens, *, implied: bool) -> list[Tokens]:
    """Raise Refused if an earlier equation gives another answer; conditions and unsolved equations may stand.

    For a step with another name, its other sides are returned, so that they can be checked for values.
    """
    if tokens[0].kind == "word" and tokens[0].text.lower() in _CONDITIONS:
        given = _sides(tokens[1:])[0][0]
        if given and all(token.kind in _NUMERIC for token in given):
            raise _unreadable("a condition in numbers names nothing, and could be an answer")
        if name and labels.is_bare(given) and labels.names(given)[:1] == labels.names(name)[:1]:
            raise _unreadable("what is asked has a value in a condition, too")
        return []
    sides, relations = _sides(tokens)
    if not relations or not sides[0] or not name:
        raise Refused(Outcome.WRONG, "a list is more than one value")
    mine = set(labels.names(name))
    if not implied and (labels.is_bare(sides[0]) or mine.isdisjoint(labels.names(sides[0]))):
        raise two_values()
    named = next((at for at, side in enumerate(sides) if labels.is_bare(side)), None)
    if not implied or named is None:
        return []
    rest = [unwrap(side) for at, side in enumerate(sides) if at != named and side]
    solved = any(not labels.is_bare(side) and not mine.isdisjoint(labels.names(side)) for side in rest)
    return [] if solved else rest


def _chosen(sides: list[Tokens], relations: Sequence[Token]) -> Statement:
    """Return the equation with its last side as the value; Refused if the earlier sides make that doubtful."""
    if len(sides) > 1 and _is_name_of(sides[-1], sides[-2]):
        sides, relations = [sides[-1], *sides[:-1]], [relations[-1], *relations[:-1]]
    value = unwrap(sides[-1])
    if not value:
        raise _unreadable("nothing stands behind the last sign of equality")
    if value[0].kind == "word":
        value = _without_hedge(value)
    named = [side for side in (unwrap(side) for side in sides[:-1]) if side]
    if named and relations[-1].text == "~" and labels.has_numbers(named[-1]):
        raise Refused(Outcome.WRONG, "a range is not one value")
    labels.check(named)
    claims = tuple(side for side in named if len(side) > 1 or len(side[0].text) > 1 or labels.has_numbers(side))
    return Statement(
        value, claims, _doubt(value), bool(relations) and relations[-1].text == "≈", any(map(labels.is_bare, named))
    )


def _is_name_of(last: Tokens, before: Tokens) -> bool:
    """Return whether the last side of an equation only names the value before it, as in *9.8 m = h*."""
    if not last or any(token.kind in _NO_NAME for token in last):
        return False
    return labels.is_bare(last) and not labels.is_bare(before)


def _doubt(tokens: Tokens) -> Token | None:
    return next((token for token in tokens if token.kind in {"hedge", "soft", "arrow"}), None)


def is_signed(tokens: Sequence[Token]) -> bool:
    """Return whether a value begins with a sign, also inside parentheses or a numerator."""
    first = next((token for token in tokens if token.kind not in {"open", "fraction"}), None)
    return first is not None and first.kind in {"plus", "minus", "dash"}


def flatten(tokens: Tokens) -> Tokens:
    r"""Return the tokens without the invisible braces of ``\text{…}`` and similar, except around arguments."""
    kept: Tokens = []
    stack: list[tuple[str, bool]] = []  # for each open group, what closes it, and whether it is kept
    argument = 0  # how many groups a fraction still takes
    for token in tokens:
        if token.kind == "open":
            last = kept[-1].kind if kept else ""
            argument = 2 if last == "fraction" else argument
            printed = token.text != "{" or token.finish - token.begin == 1  # a brace alone may hold an argument
            is_kept = printed or last in {"power", "root", "fraction", "function"} or argument > 0
            stack.append((CLOSES[token.text], is_kept))
            argument = max(argument - 1, 0) if token.text == "{" else 0
            if not is_kept:
                continue
        elif token.kind == "close":
            at = next((n for n in range(len(stack) - 1, -1, -1) if stack[n][0] == token.text), None)
            if at is not None and not stack.pop(at)[1]:
                continue
        kept.append(token)
    return kept


def unwrap(tokens: Tokens) -> Tokens:
    """Return the tokens without groups that enclose all of them: braces, parentheses, font commands."""
    if not tokens or tokens[0].kind != "open" or tokens[-1].kind != "close":
        return tokens
    closings: dict[int, int] = {}
    stack: list[int] = []
    for position, token in enumerate(tokens):
        if token.kind == "open":
            stack.append(position)
        elif token.kind == "close" and stack and CLOSES[tokens[stack[-1]].text] == token.text:
            closings[stack.pop()] = position
    first, last = 0, len(tokens) - 1
    while first < last and closings.get(first) == last:
        first, last = first + 1, last - 1
    return tokens[first : last + 1]
