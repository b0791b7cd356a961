"""Left sides of an answer: names of quantities in symbols or words, and expressions of them."""

from collections.abc import Sequence
from typing import Final

from sim2reason.grading.alphabet import GREEK_NAMES, VARIANTS
from sim2reason.grading.score import Outcome, Refused
from sim2reason.grading.tokens import Token
from sim2reason.grading.units import is_unit

__all__ = [
    "DENIALS",
    "check",
    "has_numbers",
    "is_bare",
    "is_change",
    "is_compound",
    "is_mixed_sum",
    "is_name",
    "is_plain",
    "is_pure",
    "is_symbolic",
    "names",
]

_QUANTITY_WORDS: Final = """
    answer result solution value speed velocity acceleration deceleration retardation force tension thrust weight mass
    momentum impulse energy work power time period duration interval frequency distance displacement height depth length
    width position coordinate angle radius diameter torque moment inertia density pressure coefficient friction normal
    reaction amplitude ratio efficiency magnitude charge current voltage field potential compression extension stretch
    elongation stiffness constant rate wavelength component change increase decrease loss gain rise drop fall total heat
    temperature volume area number fraction restitution separation deflection elevation altitude apex range gravity load
    ans
"""
_QUANTITIES: Final = frozenset(_QUANTITY_WORDS.split())
_DENYING: Final = """
    no not never nor neither none nothing but except excluding without unlike wrong false incorrect untrue isn aren wasn
    cannot most least exceeds exceeding maybe perhaps possibly either or nearly almost hardly instead rather anything
    everything unequal differs different isnt doesnt previous previously former formerly old outdated discarded rejected
    alternative alternate example hypothetical naive guess guessed non negative minus negated inverse reciprocal half
    twice double thrice squared cubed root sine cosine cotangent secant cosecant logarithm logarithmic
    exponential derivative integral times plus divided multiplied added subtracted
"""
DENIALS: Final = frozenset(_DENYING.split())
"""Words that show that a number beside them is not the answer: negations, alternatives, operations."""
_COMPARING: Final = """
    less more greater smaller larger fewer higher lower above below under over beyond within up other others another
    opposite
"""
_COMPARISONS: Final = frozenset(_COMPARING.split())  # deny at the end and before *than*; else tell one from another
_CHANGING: Final = """
    square cube sine cosine tangent secant log exponent third quarter fifth tenth hundredth sum product quotient
    difference percentage percent multiple rate logarithm
"""
_OPERATIONS: Final = frozenset(_CHANGING.split())  # make another quantity of what follows *of*; else name a thing
_PURE: Final = frozenset({"ratio", "fraction", "efficiency"})  # of anything, pure numbers
_OBJECTS: Final = frozenset(
    {"block", "body", "cart", "ball", "bob", "car", "disc", "disk", "object", "particle", "case"}
)
_LEADING: Final = frozenset({"for", "the", "of", "in"})  # before an object
_CHANGES: Final = frozenset({"delta", "Delta", "δ", "Δ", "d", "Sigma", "Σ"})
_NAMES: Final = frozenset({"word", "symbol"})
_NUMBERS: Final = frozenset({"number", "part", "constant"})
_SIGNS: Final = frozenset({"plus", "minus", "dash"})
_OPERATORS: Final = frozenset({"times", "open", "fraction", "root", "over", "bar", "function"}) | _SIGNS
_MAX_PRODUCT_LETTERS: Final = 3  # letters side by side that are a product or an abbreviation, not a word


def _unreadable(why: str) -> Refused:
    return Refused(Outcome.UNREADABLE, why)


def _textual(token: Token) -> bool:
    """Return whether a token is an English word: not a symbol, adjacent letters or an abbreviation."""
    if token.kind == "soft":
        return token.text.isalpha()
    word = token.text
    if token.kind != "word" or len(word) < 2 or not word.isascii() or word in GREEK_NAMES or word in VARIANTS:
        return False
    if word.lower() in DENIALS or word.lower() in _COMPARISONS:
        return True
    return (len(word) > _MAX_PRODUCT_LETTERS or token.upright) and not (
        word.isupper() and len(word) <= _MAX_PRODUCT_LETTERS
    )


def names(side: Sequence[Token]) -> list[tuple[str, str]]:
    """Return the symbols on one side of an equation, each with its subscript.

    A sign of change is a name only if it is alone, and so is the number e.
    """
    name_tokens = [token for token in side if token.kind in _NAMES and not _textual(token)]
    rest = [token for token in name_tokens if token.text not in _CHANGES] or name_tokens
    if not rest:
        rest = [token for token in side if token.kind == "constant"] if _is_lone_constant(side) else []
    return [piece for token in rest for piece in _letters(token)]


def is_change(token: Token) -> bool:
    """Return whether a token is a sign of change, such as Δ, which alone names nothing."""
    return token.text in _CHANGES


def _letters(token: Token) -> list[tuple[str, str]]:
    """Return the symbols in a token; a run such as ``mgh`` gives three."""
    run = token.text
    if (
        token.kind == "word"
        and 1 < len(run) <= _MAX_PRODUCT_LETTERS
        and run.isascii()
        and run.islower()
        and run not in GREEK_NAMES
    ):
        return [*((letter, "") for letter in run[:-1]), (run[-1], token.label)]
    return [(run, token.label)]


def _is_lone_constant(side: Sequence[Token]) -> bool:
    return [token.text for token in side if token.kind not in {"mark", "open", "close", "bar"}] == ["e"]


def has_numbers(side: Sequence[Token]) -> bool:
    """Return whether one side of an equation contains a number."""
    return any(token.kind in _NUMBERS for token in side) and not _is_lone_constant(side)


def _words(side: Sequence[Token]) -> list[Token]:
    """Return the English words on one side of an equation, except in exponents, where *max* is a mark."""
    words: list[Token] = []
    depth, raised = 0, False
    for token, before in zip(side, [None, *side], strict=False):
        if token.kind == "open" and token.text == "{":
            raised = raised or (before is not None and before.kind == "power")
            depth += raised
        elif token.kind == "close" and raised:
            depth -= 1
            raised = depth > 0
        if not raised and _textual(token) and not (before is not None and before.kind == "power"):
            words.append(token)
    return words


def is_bare(side: Sequence[Token]) -> bool:
    """Return whether a side of an equation is only a name, with marks or arguments: ``|v_A'|``, *speed of A*."""
    if _is_letter(side):
        return True
    if words := _words(side):
        return not _is_power(side) and (not has_numbers(side) or _is_called(side, words))
    outside = _outside(side) or list(side)
    kinds = {token.kind for token in outside}
    if kinds & {"minus", "dash", "plus", "slash", "fraction", "root", "number", "part", "script", "over", "function"}:
        return False
    return len(set(names(outside))) == 1 and not _is_power(side)


def _is_letter(side: Sequence[Token]) -> bool:
    """Return whether one side of an equation is a single letter."""
    return len(side) == 1 and side[0].kind in _NAMES and len(side[0].text) == 1


def _outside(side: Sequence[Token]) -> list[Token]:
    """Return the tokens of one side of an equation outside parentheses; braces do not count."""
    depth, outside = 0, list[Token]()
    for token in side:
        depth += (token.kind == "open" and token.text in "([") - (token.kind == "close" and token.text in ")]")
        if depth == 0 and token.kind not in {"open", "close"}:
            outside.append(token)
    return outside


def _is_power(side: Sequence[Token]) -> bool:
    """Return whether a side of an equation contains a numeric power, not only a mark as in ``t^*``."""
    for position, token in enumerate(side):
        raised = [later.kind for later in side[position + 1 : position + 4] if later.text != "{"]
        if token.kind == "script" or (token.kind == "power" and raised[:1] in (["number"], ["minus"])):
            return True
    return False


def is_name(side: Sequence[Token]) -> bool:
    """Return whether a side of an equation names a quantity, so that a colon or *is* may follow it."""
    if not side or has_numbers(side):
        return False
    words = _words(side)
    return (_names_quantity(words) or _names_object(side, words)) if words else is_bare(side)


def _names_quantity(words: Sequence[Token]) -> bool:
    lowered = {word.text.lower() for word in words}
    singular = lowered | {word.removesuffix("s") for word in lowered}
    return bool(singular & _QUANTITIES) and _denial(words) is None


def _names_object(side: Sequence[Token], words: Sequence[Token]) -> bool:
    """Return whether a side names only an object, such as *Block A*, whose quantity the question asks for."""
    lowered = [word.text.lower() for word in words]
    others = [token for token in side if token not in words]
    plain = all(token.kind in _NAMES and len(token.text) == 1 for token in others) and len(others) <= 1
    return plain and bool(lowered) and lowered[-1] in _OBJECTS and set(lowered[:-1]) <= _LEADING


def _denial(words: Sequence[Token]) -> Token | None:
    """Return the first word that makes a side of an equation name another quantity, such as *not* or *half of*."""
    lowered = ["", *(word.text.lower() for word in words), ""]
    for at, word in enumerate(words, 1):
        before, name, after = lowered[at - 1 : at + 2]
        compares = name in _COMPARISONS and after in {"", "than"}
        changes = name.removesuffix("s") in _OPERATIONS and after == "of"
        divides = name == "per" and not is_unit(words[at].text if at < len(words) else "")
        if (
            compares
            or changes
            or divides
            or name in DENIALS
            or (name == "prior" and after != "to")
            or (before, name) == ("mean", "square")
        ):
            return word
    return None


def _is_called(side: Sequence[Token], words: Sequence[Token]) -> bool:
    """Return whether a side of an equation with numbers is nevertheless a name in words: *speed of block 1*."""
    inside = [token for token in side if token.kind not in {"open", "close"}]
    called = inside[0] is words[0] and _names_quantity(words) and not _is_power(side)
    return called and all(token.kind not in _OPERATORS for token in inside)


def check(sides: Sequence[Sequence[Token]]) -> None:
    """Raise Refused for a side of an equation with words such as *not*, or with words that name no quantity."""
    for side in sides:
        if _is_letter(side):
            continue
        words = _words(side)
        denial = _denial(words)
        if denial is not None:
            raise _unreadable(f"{denial.text!r} before the value changes what it says")
        if has_numbers(side):
            stranger = next((word for word in words if not is_unit(word.text)), None)
            if stranger is not None and not (_is_call(side) or _is_called(side, words)):
                raise _unreadable(f"{stranger.text!r} stands among numbers and is no unit")
        elif words and (_is_power(side) or not (_names_quantity(words) or _names_object(side, words))):
            raise _unreadable(f"{words[0].text!r} is no word for a quantity that is known here")


def _is_call(side: Sequence[Token]) -> bool:
    """Return whether one side of an equation is a name with its argument, as in ``v(2 s)``."""
    return bool(side) and side[0].kind in _NAMES and is_bare(side)


def is_compound(side: Sequence[Token]) -> bool:
    """Return whether one side of an equation is an expression of one symbol, not its name: ``2T``, ``-a``."""
    kinds = {token.kind for token in side}
    changed = bool(kinds & {"minus", "dash", "slash", "fraction", "root", "number", "part", "over", "function"})
    return len(set(names(side))) == 1 and (changed or _is_power(side))


def is_mixed_sum(side: Sequence[Token]) -> bool:
    """Return whether one side of an equation is a sum of symbols with at least two different letters, as *a - g*."""
    inside = [token for token in side if token.kind not in {"open", "close", "mark"}]
    signs = [token for token in inside if token.kind in _SIGNS]
    named = [token for token in inside if token.kind not in _SIGNS]
    if not signs or any(len(names([token])) != 1 for token in named):
        return False
    return len({letter for letter, _ in names(named)}) > 1


def is_plain(side: Sequence[Token]) -> bool:
    """Return whether one side of an equation is a number, perhaps with a unit, without operators."""
    first = 1 if len(side) > 1 and side[0].kind in _SIGNS else 0
    return side[first].kind == "number" and all(token.kind not in _OPERATORS for token in side[first + 1 :])


def is_symbolic(side: Sequence[Token]) -> bool:
    """Return whether a side of an equation has symbols and no English words."""
    return bool(names(side)) and not _words(side)


def is_pure(side: Sequence[Token]) -> bool:
    """Return whether the words on a side of an equation name a pure number, such as *ratio*."""
    return any(word.text.lower() in _PURE for word in _words(side))
