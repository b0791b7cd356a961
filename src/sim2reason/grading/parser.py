"""Parser of values: from tokens to a function of symbol values, in floats only.

Juxtaposition binds as tightly as a multiplication sign, so ``a/bc`` is ambiguous and refused. The running time is
linear in the number of tokens, and nesting is limited.
"""

from collections.abc import Sequence
from itertools import islice
from typing import Final

from sim2reason.grading import arithmetic
from sim2reason.grading.alphabet import CLOSES, is_angle
from sim2reason.grading.arithmetic import Node
from sim2reason.grading.score import Outcome, Refused
from sim2reason.grading.tokens import Token

__all__ = ["parse"]

MAX_DEPTH: Final = 32
_STARTS: Final = frozenset({"symbol", "constant", "function", "root", "fraction", "part"})
_SIGNS: Final = frozenset({"plus", "minus", "dash"})


def _unreadable(why: str) -> Refused:
    return Refused(Outcome.UNREADABLE, why)


class _Parser:
    """A recursive descent parser of one answer; with `unit_follows`, a final degree sign belongs to the unit."""

    def __init__(self, tokens: Sequence[Token], *, unit_follows: bool) -> None:
        end = tokens[-1].finish if tokens else 0
        self.tokens = [*tokens, *[Token("end", "", end, end)] * 3]
        self.at = self.depth = 0
        self.in_bars = ""  # the text of the bar that opened
        self.is_sum = False
        self.unit_follows = unit_follows
        self.refusal: Refused | None = None

    @property
    def next(self) -> Token:
        return self.tokens[self.at]

    def take(self) -> Token:
        self.at += 1
        return self.tokens[self.at - 1]

    def skip(self, kind: str) -> bool:
        if self.next.kind != kind:
            return False
        self.at += 1
        return True

    def sign(self) -> bool:
        """Return whether a minus sign comes next; an en dash counts as one where a value must follow."""
        return self.next.kind in _SIGNS and self.take().kind != "plus"

    def expression(self) -> Node:
        negative = self.sign()
        terms = [(self.product(), negative)]
        while self.next.kind in _SIGNS:
            if self.next.kind == "dash":
                raise Refused(Outcome.WRONG, "a range is not one value")
            negative = self.take().kind == "minus"
            terms.append((self.product(), negative))
        self.is_sum = len(terms) > 1
        return arithmetic.total(terms)

    def quotient(self) -> Node:
        r"""Parse the content of a brace pair: a sum, or two sums with ``\over`` between them."""
        above = self.expression()
        if not self.skip("over"):
            return above
        below = self.expression()
        self.is_sum = False
        return arithmetic.product([(above, False), (below, True)])

    def product(self) -> Node:
        """Parse factors joined by signs or written side by side; the tokens after an answer's product are its unit."""
        factors = [(self.power(), False)]
        while True:
            mark, depth = self.at, self.depth
            try:
                factor = self.next_factor(divided=factors[-1][1])
            except Refused as refusal:
                if depth or refusal.outcome is Outcome.TOO_LONG:
                    raise
                self.at, self.depth, self.refusal, factor = mark, depth, refusal, None
            if factor is None:
                return arithmetic.product(factors)
            factors.append(factor)

    def next_factor(self, *, divided: bool) -> tuple[Node, bool] | None:
        """Parse the next factor and return it with whether it divides; None at the end of the product."""
        if self.next.kind in {"times", "slash"} or self.is_cross():
            divides = self.take().kind == "slash"
            negative = self.sign()
            factor = self.power()
            return (arithmetic.negated(factor) if negative else factor), divides
        if not self.starts():
            if self.depth and self.next.kind == "number":
                raise _unreadable("two numbers stand side by side")
            return None
        if self.is_mixed():
            raise _unreadable("a whole number beside a fraction could be a sum or a product")
        factor = self.power()
        if divided:
            raise _unreadable("what stands under a slash needs parentheses")
        return factor, False

    def starts(self) -> bool:
        """Return whether a factor may begin at the next token, without a multiplication sign."""
        token = self.next
        if token.kind == "open":  # braces are unseen in print, where 3{.5} reads as 3.5, and 3{{2}} as 32
            after = islice(self.tokens, self.at + 1, None)
            inside = next(each.kind for each in after if token.text != "{" or each.text != "{")
            return inside in _STARTS | {"open"} or (token.text != "{" and inside != "word")
        return token.kind in _STARTS or self.opens_bars()

    def opens_bars(self) -> bool:
        return self.next.kind == "bar" and (self.next.text == "(" or self.next.text == "|" != self.in_bars)

    def is_cross(self) -> bool:
        """Return whether the letter x here is the multiplication sign of a power of ten."""
        cross = self.next
        if cross.kind != "word" or cross.text not in {"x", "X"}:
            return False
        ten, power = self.tokens[self.at + 1 : self.at + 3]
        return ten.text == "10" and power.kind in {"power", "script"}

    def is_mixed(self) -> bool:
        """Return whether a whole number precedes a fraction of whole numbers, as in 1½."""
        raised = self.tokens[self.at - 2].kind == "power"
        if self.next.kind == "part" and self.tokens[self.at - 1].kind == "number":
            return True
        if self.next.kind != "fraction" or self.tokens[self.at - 1].kind != "number" or raised:
            return False
        after = self.tokens[self.at + 1]
        inside = [token.kind for token in self.tokens[self.at + 1 : self.at + 7] if token.kind not in {"open", "close"}]
        return inside[:2] == ["number", "number"] or (after.kind == "number" and len(after.text) > 1)

    def power(self) -> Node:
        base = self.atom()
        if self.next.kind == "script":
            base = arithmetic.power(base, arithmetic.constant(float(self.take().text)))
        if self.next.kind == "power":
            self.take()
            base = arithmetic.power(base, self.exponent())
        if self.next.kind == "degree" and (self.depth or not self.unit_follows):
            self.take()
            base = arithmetic.degrees(base)
        return base

    def exponent(self) -> Node:
        """Parse an exponent: a group, or a sign and one atom; towers associate to the right."""
        self.deeper()
        negative = self.sign()
        node = self.group() if self.next.kind == "open" else self.atom()
        if self.skip("power"):
            node = arithmetic.power(node, self.exponent())
        self.depth -= 1
        return arithmetic.negated(node) if negative else node

    def deeper(self) -> None:
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise Refused(Outcome.TOO_LONG, f"the answer is nested more than {MAX_DEPTH} deep")

    def atom(self) -> Node:
        match self.next.kind:
            case "number" | "symbol" | "constant" | "part":
                return self.leaf()
            case "open":
                return self.visible_group()
            case "bar" if self.next.text != ")":  # within bars, too: a factor must begin here
                return self.bars()
            case "fraction":
                self.take()
                return arithmetic.product([(self.argument(), False), (self.argument(), True)])
            case "root":
                return self.root()
            case "function":
                return self.function()
            case _:
                raise self.unexpected()

    def leaf(self) -> Node:
        token = self.take()
        if token.kind == "symbol":
            return arithmetic.symbol(token.text)
        return arithmetic.constant(arithmetic.CONSTANTS[token.text] if token.kind == "constant" else float(token.text))

    def visible_group(self) -> Node:
        """Parse a group, which must be visible in print: a sum in invisible braces is refused."""
        opening, begin, group = self.next.text, self.at + 1, self.group()
        raised = self.next.kind in {"power", "script"}
        product = self.at - begin > 2 and self.tokens[begin].kind not in {"open", "root"}
        if opening == "{" and (self.is_sum or (raised and product)):
            raise _unreadable("what belongs together needs parentheses that can be seen")
        return group

    def unexpected(self) -> Refused:
        """Return the refusal for the next token, which is invalid at its position."""
        match self.next.kind:
            case "end":
                return _unreadable("the answer breaks off")
            case "mark":  # primes and accents may stand on the left of an equation only
                return _unreadable(f"{self.next.text} has no meaning in a value")
            case "word":
                return _unreadable(f"{self.next.text!r} is neither a number nor a symbol of the problem")
            case _:
                return _unreadable(f"'{self.next.shown}' cannot be read where it stands")

    def group(self) -> Node:
        opening = self.take()
        self.deeper()
        in_bars, self.in_bars = self.in_bars, ""
        inside = self.quotient() if opening.text == "{" else self.expression()
        if self.next.kind != "close" or self.take().text != CLOSES[opening.text]:
            raise self.unexpected()
        self.in_bars = in_bars
        self.depth -= 1
        return inside

    def bars(self) -> Node:
        in_bars, self.in_bars = self.in_bars, self.take().text
        self.deeper()
        inside = self.expression()
        if self.next.text == "(" or not self.skip("bar"):
            raise _unreadable("a bar is not closed")
        self.in_bars = in_bars
        self.depth -= 1
        return arithmetic.call("abs", inside)

    def argument(self) -> Node:
        """Parse the argument of a TeX command: a group, or a single digit or letter."""
        if self.next.kind != "number":
            self.deeper()
            node = self.group() if self.next.kind == "open" else self.atom()
            self.depth -= 1
            return node
        token = self.take()
        if len(token.text) > 1:
            if not token.text.isdigit() or token.finish - token.begin != len(token.text):
                raise _unreadable("the argument needs braces")
            self.at -= 1
            self.tokens[self.at] = token._replace(text=token.text[1:], begin=token.begin + 1)
        return arithmetic.constant(float(token.text[0]))

    def root(self) -> Node:
        sign = self.take()
        if sign.finish - sign.begin == 1 and self.next.kind == "number":  # the sign √ takes the number behind it
            return arithmetic.call("sqrt", self.leaf())
        index = self.group() if self.next.text == "[" else None
        radicand = self.argument()
        return arithmetic.root(radicand, index) if index else arithmetic.call("sqrt", radicand)

    def function(self) -> Node:
        r"""Parse ``\sin x``, ``\sin^2 x``, ``\sin^{-1} x`` (the inverse) or ``\log_{10} x``."""
        self.deeper()
        name, exponent = self.take().text, None
        mark = self.at
        if self.next.kind == "script":
            exponent = arithmetic.constant(float(self.take().text))
        elif self.skip("power"):
            exponent = self.exponent()
        raised = "".join(t.text for t in self.tokens[mark : self.at] if t.kind not in {"power", "open", "close"})
        if raised == "-1":
            name, exponent = arithmetic.inverse(name), None
        value = arithmetic.call(name, self.operand())
        self.depth -= 1
        return arithmetic.power(value, exponent) if exponent else value

    def operand(self) -> Node:
        r"""Parse the argument of a function: a group, or juxtaposed numbers and names up to a space like ``\,``."""
        if self.next.kind == "open":
            return self.group()
        if self.next.kind == "function" or self.opens_bars():
            return self.atom()
        factors: list[tuple[Node, bool]] = []
        start = self.next.kind
        while self.next.kind in {"symbol", "constant", "fraction", "root"} or (not factors and start == "number"):
            if factors and self.next.apart:
                break
            complete = is_angle(self.next.text)  # in \cos\alpha\sqrt{x} the root is a factor of its own
            factors.append((self.power(), False))
            if complete:
                break
        if not factors:
            raise _unreadable("a function has no argument")
        if len(factors) == 1 and start == "number" and self.next.kind == "open" and not self.next.upright:
            raise _unreadable("the argument of a function needs parentheses")
        return arithmetic.product(factors)


def parse(tokens: Sequence[Token], *, unit_follows: bool) -> tuple[Node, int, Refused | None]:
    """Parse the value at the start of `tokens`; return it, the number of tokens used, and why parsing stopped.

    The remaining tokens may be a unit. Raises `Refused`: unreadable, wrong (a range), or too long (nested too deeply).
    """
    parser = _Parser(tokens, unit_follows=unit_follows)
    node = parser.quotient()
    return node, parser.at, parser.refusal
