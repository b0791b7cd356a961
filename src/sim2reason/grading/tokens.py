r"""Tokenizer of answers in LaTeX or plain text.

One regular expression with linear alternatives splits the text. Letters become symbols here, because only the item's
table of symbols decides whether ``mgh`` is one name, three, or an unknown word.
"""

import re
from collections.abc import Collection
from functools import lru_cache
from typing import Final, NamedTuple

from sim2reason.grading.alphabet import (
    COMMANDS,
    FUNCTIONS,
    GREEK,
    GREEK_NAMES,
    HEDGES,
    INK,
    SCRIPTS,
    SIGNS,
    SOFT_HEDGES,
    SPACES,
    VARIANTS,
    Pieces,
    split,
)
from sim2reason.grading.score import Outcome, Refused

__all__ = ["Token", "canonical", "tokenize"]


class Token(NamedTuple):
    r"""A token of an answer.

    `kind` is number, symbol, constant, function, word, open, close, bar, root, fraction, over, part (½), power, script,
    plus, minus, dash, times, slash, degree, percent, relation, hedge, soft (a word or comma that hedges between
    numbers), arrow, step, stop, colon, mark or end; `text` its normal form; `begin` and `finish` where it stands;
    `apart` 1 where an explicit space such as ``\,`` precedes it, 2 where a wide one does; `upright` whether it stands
    inside ``\text{…}``; `label` what stands below a word; `said` how the answer spells what is no word. The text of a
    bar says whether ``\left`` or ``\right`` makes it an opening or a closing one.
    """

    kind: str
    text: str
    begin: int
    finish: int
    apart: int = 0
    upright: bool = False
    label: str = ""
    said: str = ""

    @property
    def shown(self) -> str:
        """Return the original text of the token."""
        return self.said or self.text


_SPACE = rf"(?:[\s~$]|\\[ ,;:!>]|\\(?:{'|'.join(SPACES)}|[bB]igg?[lr]?)(?![A-Za-z]))"
_BELOW: Final = r"(?:[^{}\\$_]|\\[A-Za-z,]++|\{[A-Za-z0-9,\s]*+\}){1,40}+"
_CUT: Final = re.compile(
    rf"(?P<space>{_SPACE}+)"
    r"|(?P<number>(?:[1-9][0-9]{0,2}(?P<group>[, ~\u00a0\u2009\u202f]|\{,\}|,\\!|\\[, !])[0-9]{3}"
    r"(?:(?P=group)[0-9]{3})*(?![0-9])(?:\.[0-9]+)?|[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?P<exponent>[eE][-+−]?[0-9]+)?)"
    rf"|(?P<color>\\(?:color|textcolor)\s*\{{\s*(?:{INK})(?:!(?:[4-9][0-9]|100)(?:!black)?)?\s*\}})"
    r"|(?P<named>\\(?:text|mathrm|operatorname\*?)\s*\{\s*(?P<name>[A-Za-z]{1,8})\s*\})"
    r"|(?P<degree>\^\s*(?:\\circ(?![A-Za-z])|\{\s*\\circ\s*\}|°)|°|\\degree(?![A-Za-z]))"
    r"|(?P<hedge>\+\s*+(?:/\s*+)?[-−–])|(?P<power>\*\*|\^)|(?P<script>[⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)"
    rf"|(?P<primed>(?P<plain>[A-Za-z{''.join(GREEK)}]|\\(?:{'|'.join(GREEK_NAMES)}))(?P<primes>['′]{{1,3}}))"
    rf"|(?P<below>_\s*(?:\{{{_BELOW}\}}|\\[A-Za-z]+|[A-Za-z0-9*]))"
    r"|(?P<command>\\(?:[A-Za-z]+|[^A-Za-z]))|(?P<letters>[A-Za-z]+)"
    rf"|(?P<greek>[{''.join(GREEK)}])|(?P<sign>[{re.escape(''.join(SIGNS))}])"
)
_SUBSCRIPT: Final = re.compile(
    rf"\s*_\s*(?:\{{({_BELOW})\}}"
    r"|(\\(?:text|mathrm)\s*\{[A-Za-z0-9,\s]{1,20}\}|\\[A-Za-z]+)|([A-Za-z0-9]{1,12}))|([₀₁₂₃₄₅₆₇₈₉]{1,3}|[0-9]{1,3}(?![0-9.]))"
)
_NO_NAME: Final = re.compile(r"\\(?:text|mathrm|rm)(?![A-Za-z])|[\\{}\s]")


_OPENING: Final = re.compile(r"\\(?:left|[Bb]igg?l)\s*(?:\\?\||\\\w+)$")
_CLOSING: Final = re.compile(r"\\(?:right|[Bb]igg?r)\s*(?:\\?\||\\\w+)$")
_DELIMITED: Final = len(r"\right ")


class _Lexer:
    """A lexer of one text; with `symbols` None every letter is a symbol."""

    def __init__(self, text: str, symbols: Collection[str] | None, *, primes: bool = False) -> None:
        self.primes = primes
        self.text, self.symbols = text, None if symbols is None else frozenset(symbols)
        self.tokens: list[Token] = []
        self.upright: list[bool] = []
        self.apart = 0
        firsts = {name.partition("_")[0] for name in self.symbols or ()}
        self.l_is_ell = "ell" in firsts and "l" not in firsts  # then an l can mean nothing else

    def add(self, kind: str, text: str, begin: int, finish: int) -> None:
        upright = self.upright[-1] if self.upright else False
        source = self.text[begin:finish]
        if kind == "bar":
            text = _side(self.text[max(0, begin - _DELIMITED) : finish])
        self.tokens.append(Token(kind, text, begin, finish, self.apart, upright, "", source))
        self.apart = 0

    def run(self) -> list[Token]:
        at = 0
        cut, text, end = _CUT.match, self.text, len(self.text)
        while at < end:
            match = cut(text, at)
            if match is None:
                raise Refused(Outcome.UNREADABLE, f"{_show(text[at])} has no meaning here")
            at = self.take(match.lastgroup or "", match)
        return self.tokens

    def take(self, kind: str, match: re.Match[str]) -> int:
        """Add the token of a match and return the index where to continue."""
        text = match[0]
        begin, finish = match.span()
        match kind:  # the most frequent ones first
            case "sign":
                self.sign(text, begin, finish)
            case "space":
                spacing = text.strip("\\ \t\n$!") if "\\" in text else "left"
                self.apart = 2 if "quad" in spacing else int(spacing not in {"left", "right"})
            case "number":
                return self.number(match)
            case "letters" | "greek" | "name" | "named":
                named = kind == "named"
                return self.letters(match["name"] if named else text, begin, finish, named=named)
            case "primed":
                return self.primed(match)
            case "command":
                return self.command(text[1:], begin, finish)
            case "color":
                pass
            case "below":
                self.add("mark", "a subscript", begin, finish)
            case "hedge":
                self.add("hedge", "±", begin, finish)
            case _:
                self.add(kind, text.translate(SCRIPTS), begin, finish)
        return finish

    def number(self, match: re.Match[str]) -> int:
        mantissa, exponent = match["number"], match["exponent"]
        finish = match.end()
        if exponent and self.known(exponent[0]):  # the item has a symbol e: 2e3 is no power of ten
            finish -= len(exponent)
            mantissa = mantissa[: -len(exponent)]
        group = match["group"]
        digits = mantissa.replace(group, "") if group else mantissa
        self.add("number", digits.replace("−", "-"), match.start(), finish)
        return finish

    def sign(self, text: str, begin: int, finish: int) -> None:
        kind, normal = SIGNS[text]
        if kind == "open":
            self.upright.append(bool(self.upright) and self.upright[-1])
        elif kind == "close" and self.upright:
            self.upright.pop()
        self.add(kind, normal, begin, finish)

    def command(self, name: str, begin: int, finish: int) -> int:
        if name in "{}" or name == "|":
            kind, normal = {"{": ("open", "("), "}": ("close", ")"), "|": ("bar", "|")}[name]  # seen in print
            self.add(kind, normal, begin, finish)
            return finish
        if name in VARIANTS or name in GREEK_NAMES or name in FUNCTIONS:
            return self.letters(name, begin, finish)
        if name in {"color", "textcolor"}:  # of an ink that is not in the list
            raise Refused(Outcome.UNREADABLE, f"\\{name} may hide a part of the answer")
        if name not in COMMANDS:
            raise Refused(Outcome.UNREADABLE, f"\\{name[:20]} has no meaning here")
        kind, normal = COMMANDS[name]
        if normal == "{":
            finish = self.brace(name, finish)
            self.upright.append("upright" in kind)
        self.add(kind.split()[0], normal, begin, finish)
        return finish

    def brace(self, name: str, finish: int) -> int:
        brace = re.compile(r"\*?\s*\{").match(self.text, finish)
        if brace is None:
            raise Refused(Outcome.UNREADABLE, f"\\{name} needs braces")
        return brace.end()

    def known(self, name: str) -> bool:
        return self.symbols is not None and name in self.symbols

    def letters(self, run: str, begin: int, finish: int, *, named: bool = False) -> int:
        """Split a run of letters, such as ``mgh``, into known names with a subscript; else add it as one word."""
        upright = named or (bool(self.upright) and self.upright[-1])
        base = VARIANTS.get(run, GREEK.get(run, run))
        end = finish
        pieces, finish = self.subscripted(base, finish)
        if pieces is None and self.l_is_ell and "l" in base:
            pieces, finish = self.subscripted(base.replace("l", "ell"), end)
        if upright:
            pieces = pieces if base in FUNCTIONS or (base == "e" and pieces) else None
        if pieces is None:
            self.tokens.append(Token("word", run, begin, finish, self.apart, upright, self.text[end:finish]))
            self.apart = 0
        for kind, text in pieces or ():
            self.add(kind, text, begin, finish)
        return finish

    def subscripted(self, run: str, finish: int) -> tuple[Pieces | None, int]:
        following = self.text[finish : finish + 1]
        near = following == "_" or following.isspace() or following.isdigit()
        subscript = _SUBSCRIPT.match(self.text, finish) if near else None
        if subscript is None:
            return self.split(run), finish
        braced, command, plain, digits = subscript.groups()
        if plain or digits:
            return self.plain_subscript(run, subscript, finish)
        label = _NO_NAME.sub("", braced or command)
        return self.labelled(run, label), subscript.end()

    def plain_subscript(self, run: str, subscript: re.Match[str], finish: int) -> tuple[Pieces | None, int]:
        """Split ``m_1g`` into m₁ and g, as LaTeX prints it; ``v_max`` or ``m1`` is one name if it is a known symbol."""
        label = (subscript[3] or subscript[4]).translate(SCRIPTS)
        start = subscript.end() - len(label)
        for length in range(len(label), 0, -1):
            pieces = self.labelled(run, label[:length])
            if self.symbols is not None and pieces and self.known(pieces[-1][1]):
                return pieces, start + length
        if subscript[4] and subscript[4][0].isascii():
            return self.split(run), finish
        return self.labelled(run, label[:1]), start + 1

    def labelled(self, run: str, label: str) -> Pieces | None:
        """Return the names in a run of letters with a subscript, which belongs to the whole run or its last letter."""
        if run in FUNCTIONS:
            return (("function", f"{run}_{label}"),) if run == "log" else None
        for cut in (0, len(run) - 1, len(run) - 3 if run.endswith("ell") else 0):
            name = f"{run[cut:]}_{label}"
            is_single_letter = cut == len(run) - 1 or run in GREEK_NAMES
            head = self.split(run[:cut])
            if head is not None and (self.known(name) or (self.symbols is None and is_single_letter)):
                return *head, ("symbol", name)
        return None

    def split(self, run: str) -> Pieces | None:
        return split(run, self.symbols)

    def primed(self, match: re.Match[str]) -> int:
        """Add a letter with primes, such as v', as one symbol if it is known; else drop the primes."""
        plain = match["plain"].lstrip("\\")
        subscript = _SUBSCRIPT.match(self.text, match.end()) if self.text[match.end() :].lstrip()[:1] == "_" else None
        below = "" if subscript is None else "_" + _NO_NAME.sub("", subscript[1] or subscript[2] or subscript[3][:1])
        name = VARIANTS.get(plain, GREEK.get(plain, plain)) + "'" * len(match["primes"]) + below
        if not (self.primes if self.symbols is None else self.known(name)):
            return self.letters(plain, match.start(), match.end("plain"))
        finish = match.end() if subscript is None else subscript.end() - len((subscript[3] or "?")[1:])
        self.add("symbol", name, match.start(), finish)
        return finish


def tokenize(text: str, symbols: Collection[str] | None, *, primes: bool = False) -> list[Token]:
    """Return the tokens of `text`; letters become the canonical names in `symbols`, or any symbols if None.

    A table states which names have primes; without one, `primes` allows them for all names.

    Raises `Refused` (unreadable) at the first character or command that has no meaning in an answer.
    """
    tokens = _Lexer(text, symbols, primes=primes).run()
    for at, token in enumerate(tokens):
        if token.kind == "word" and (hedging := _HEDGING.get(token.text.lower())):
            tokens[at] = token._replace(kind=hedging)
    return tokens


_HEDGING: Final = dict.fromkeys(HEDGES, "hedge") | dict.fromkeys(SOFT_HEDGES, "soft")


@lru_cache(maxsize=2048)
def canonical(name: str) -> str:
    r"""Return the canonical spelling of a symbol: ``\mu_{k}``, ``μ_k`` and ``mu_k`` are all ``mu_k``."""
    tokens = tokenize(name, None, primes=True)
    plain = name.strip().lstrip("\\")
    if len(tokens) == 1 and tokens[0].kind in {"symbol", "constant"}:
        return tokens[0].text
    if re.fullmatch(r"[A-Za-z]+(?:_[A-Za-z0-9]+)?", plain):
        return plain
    raise ValueError(f"{name!r} is no symbol")


def _side(text: str) -> str:
    """Return ``(`` or ``)`` for a bar | that can only open or only close an absolute value, else ``|``."""
    if text.endswith("lvert") or _OPENING.search(text):
        return "("
    return ")" if text.endswith("rvert") or _CLOSING.search(text) else "|"


def _show(character: str) -> str:
    if character == "!":
        return "a factorial"
    return repr(character) if character.isprintable() else f"U+{ord(character):04X}"
