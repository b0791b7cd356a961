"""Vocabulary of the tokenizer: LaTeX commands and characters with their meanings, and names in letter runs."""

import re
from functools import lru_cache
from typing import Final

__all__ = [
    "ANGLES",
    "CLOSES",
    "COMMANDS",
    "FUNCTIONS",
    "GREEK",
    "GREEK_NAMES",
    "HEDGES",
    "HIDING",
    "INK",
    "LAYOUT",
    "SCRIPTS",
    "SIGNS",
    "SOFT_HEDGES",
    "SPACES",
    "SWITCHES",
    "VARIANTS",
    "Pieces",
    "alternatives_pattern",
    "is_angle",
    "split",
]

_ELEMENTARY: Final = """
    sin cos tan cot sec csc arcsin arccos arctan arccot arcsec arccsc asin acos atan
    sinh cosh tanh coth arsinh arcosh artanh arcsinh arccosh arctanh asinh acosh atanh exp ln log abs
"""
_LETTERS: Final = "αβγδεζηθικλμνξορστυφχψωΓΔΘΛΞΠΣΦΨΩϕϵϑµℓ"
_LETTER_NAMES: Final = """
    alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron rho sigma tau upsilon phi chi psi
    omega Gamma Delta Theta Lambda Xi Pi Sigma Phi Psi Omega phi epsilon theta mu ell
"""
FUNCTIONS: Final = frozenset(_ELEMENTARY.split())
GREEK: Final = dict(zip(_LETTERS, _LETTER_NAMES.split(), strict=True))
GREEK_NAMES: Final = frozenset(GREEK.values()) | {"ell", "hbar"}
VARIANTS: Final = {
    "varphi": "phi",
    "varepsilon": "epsilon",
    "vartheta": "theta",
    "varrho": "rho",
    "varsigma": "sigma",
    "Abs": "abs",
}
SCRIPTS: Final = str.maketrans("₀₁₂₃₄₅₆₇₈₉⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻", "01234567890123456789+-")
VULGAR: Final = {
    sign: str(int(above) / int(below)) for sign, above, below in zip("½⅓⅔¼¾⅕⅛", "1121311", "2334458", strict=True)
}

COMMANDS: Final = {
    name: (kind, text)
    for kind, text, names in (
        ("fraction", "frac", "frac dfrac tfrac cfrac sfrac nicefrac"),
        ("over", "over", "over"),
        ("root", "sqrt", "sqrt"),
        ("times", "*", "times cdot ast star cdotp bullet"),
        ("slash", "/", "div slash"),
        ("open", "(", "lparen lbrace"),
        ("close", ")", "rparen rbrace"),
        ("open", "[", "lbrack"),
        ("close", "]", "rbrack"),
        ("open", "{", "mathbf mathit bm boldsymbol pmb emph boxed mathnormal underline uline fbox ensuremath"),
        ("open upright", "{", "text textrm textup textnormal textsf texttt textsc textmd mathrm mathsf mathtt"),
        ("open upright", "{", "textbf textit operatorname mbox hbox"),
        ("bar", "|", "vert mid lvert rvert Vert lVert rVert"),
        ("percent", "%", "%"),
        ("relation", "=", "equiv coloneqq triangleq"),
        ("relation", "≈", "approx simeq cong doteq"),
        ("relation", "~", "sim thicksim"),
        ("hedge", "±", "pm mp"),
        ("hedge", "<", "lt gt le ge leq geq leqslant geqslant ne neq not ll gg lesssim gtrsim in"),
        ("hedge", ",", "\\ lor land vee wedge cup ldots dots cdots begin end"),
        ("arrow", "right", "to rightarrow longrightarrow"),
        ("arrow", "left", "leftarrow longleftarrow"),
        ("arrow", "up", "uparrow"),
        ("arrow", "down", "downarrow"),
        ("step", "so", "Rightarrow implies Longrightarrow therefore leadsto"),
        ("mark", "a prime", "prime"),
        ("mark", "an accent", "vec dot ddot hat bar tilde overline overrightarrow mathcal"),
        ("mark", "an operator", "sum partial nabla int perp parallel dagger langle rangle"),
        ("constant", "pi", "pi"),
        ("constant", "inf", "infty"),
    )
    for name in names.split()
}
SIGNS: Final = {
    **{sign: ("open", sign) for sign in "([{"},
    **{sign: ("close", sign) for sign in ")]}"},
    **dict.fromkeys("*×·⋅∙•", ("times", "*")),
    **dict.fromkeys("-−\u2010\u2011", ("minus", "-")),
    **dict.fromkeys("=≡", ("relation", "=")),
    **dict.fromkeys("≈≃≅≐", ("relation", "≈")),
    "∼": ("relation", "~"),
    **dict.fromkeys("±∓", ("hedge", "±")),
    **dict.fromkeys("<>≤≥≠≪≫∈", ("hedge", "<")),
    **dict.fromkeys(",;&…∨∧∪", ("hedge", ",")),
    **dict.fromkeys("⇒⟹∴", ("step", "so")),
    **dict(zip("→←↑↓", (("arrow", way) for way in ("right", "left", "up", "down")), strict=True)),
    **{sign: ("part", text) for sign, text in VULGAR.items()},
    ".": ("stop", "."),
    ":": ("colon", ":"),
    "+": ("plus", "+"),
    "–": ("dash", "–"),
    "/": ("slash", "/"),
    "÷": ("slash", "/"),
    "|": ("bar", "|"),
    "%": ("percent", "%"),
    "√": ("root", "sqrt"),
    "'": ("mark", "a prime"),
    "′": ("mark", "a prime"),
    "∞": ("constant", "inf"),
    "π": ("constant", "pi"),
}
_FONT: Final = """
    rm bf it sf tt sc bfseries normalfont upshape itshape boldmath
"""
_PASSED: Final = """
    quad qquad space thinspace displaystyle textstyle left right rm bf it
"""
_LAID_OUT: Final = """
    enspace enskip medspace thickspace nobreakspace normalsize small large Large LARGE huge Huge scriptstyle limits
    mathstrut strut centering nonumber notag middle allowbreak
"""
SWITCHES: Final = tuple(_FONT.split())  # of the font, up to the next brace
SPACES: Final = tuple(_PASSED.split())  # commands that the tokenizer skips
LAYOUT: Final = (*_LAID_OUT.split(), *(name for name in SWITCHES if name not in SPACES))  # rarer: taken out before
HEDGES: Final = frozenset({"or", "either", "versus", "vs"})
SOFT_HEDGES: Final = frozenset({"and", "to", "between", "through"})  # a list between numbers, harmless in words
HIDING: Final = "[hv]?phantom|smash|[lrc]lap|math[lrc]lap|transparent|opacity"
"""Names of commands that hide what they hold, as a pattern."""
INK: Final = (
    "red|blue|green|black|orange|purple|teal|brown|cyan|magenta|violet|[Gg]ray|navy|ForestGreen|RoyalBlue|maroon"
)
"""Inks that are seen on white and on black paper, as a pattern."""
ANGLES: Final = frozenset({"theta", "alpha", "beta", "gamma", "phi", "psi", "delta"})
CLOSES: Final = {"(": ")", "[": "]", "{": "}"}


def is_angle(name: str) -> bool:
    """Return whether a symbol, in canonical spelling, denotes an angle."""
    return name.partition("_")[0] in ANGLES


def alternatives_pattern(kind: str, text: str = "") -> str:
    """Return a regular expression for all LaTeX commands of one kind, or only those with the meaning `text`."""
    names = (name for name, (is_of, means) in COMMANDS.items() if is_of.split()[0] == kind and text in {"", means})
    return "|".join(re.escape(name) for name in sorted(names, key=len, reverse=True))


Pieces = tuple[tuple[str, str], ...]
_MAX_CACHED_LENGTH: Final = 24  # letters of the longest runs whose splits are cached


def split(run: str, symbols: frozenset[str] | None) -> Pieces | None:
    """Split letters such as ``mgh`` into known names, the longest first; None if some letter fits no name."""
    return (_split if len(run) <= _MAX_CACHED_LENGTH else _split.__wrapped__)(run, symbols)


@lru_cache(maxsize=4096)
def _split(run: str, symbols: frozenset[str] | None) -> Pieces | None:
    pieces: list[tuple[str, str]] = []
    at = 0
    while at < len(run):
        lengths = range(min(12, len(run) - at), 0, -1)
        piece = next((candidate for n in lengths if (candidate := _meaning(run[at : at + n], symbols))), None)
        if piece is None:
            return None
        pieces.append(piece)
        at += len(piece[1])
    return tuple(pieces)


def _meaning(name: str, symbols: frozenset[str] | None) -> tuple[str, str] | None:
    if symbols is not None and name in symbols:
        return "symbol", name
    if name in FUNCTIONS:
        return "function", name
    if name in {"pi", "e"}:
        return "constant", name
    if name == "sqrt":
        return "root", name
    is_symbol = symbols is None and (len(name) == 1 or name in GREEK_NAMES)
    return ("symbol", name) if is_symbol else None
