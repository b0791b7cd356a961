"""What commands and signs mean in an answer: the closed vocabulary of the tokenizer."""

from typing import Final

__all__ = ["CLOSES", "COMMANDS", "FUNCTIONS", "GREEK", "GREEK_NAMES", "HEDGES", "SCRIPTS", "SIGNS", "VARIANTS"]

_ELEMENTARY: Final = """
    sin cos tan cot sec csc arcsin arccos arctan arccot arcsec arccsc asin acos atan
    sinh cosh tanh coth arsinh arcosh artanh arcsinh arccosh arctanh asinh acosh atanh exp ln log abs
"""
_LETTERS: Final = "αβγδεζηθικλμνξορστυφχψωΓΔΘΛΞΠΣΦΨΩϕϵϑµ"
_LETTER_NAMES: Final = """
    alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron rho sigma tau upsilon phi chi psi
    omega Gamma Delta Theta Lambda Xi Pi Sigma Phi Psi Omega phi epsilon theta mu
"""
FUNCTIONS: Final = frozenset(_ELEMENTARY.split())
GREEK: Final = dict(zip(_LETTERS, _LETTER_NAMES.split(), strict=True))
GREEK_NAMES: Final = frozenset(GREEK.values()) | {"ell", "hbar"}
VARIANTS: Final = {"varphi": "phi", "varepsilon": "epsilon", "vartheta": "theta", "varrho": "rho", "varsigma": "sigma"}
SCRIPTS: Final = str.maketrans("₀₁₂₃₄₅₆₇₈₉⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻", "01234567890123456789+-")

COMMANDS: Final = {
    name: (kind, text)
    for kind, text, names in (
        ("fraction", "frac", "frac dfrac tfrac cfrac"),
        ("root", "sqrt", "sqrt"),
        ("times", "*", "times cdot ast"),
        ("slash", "/", "div"),
        ("open", "(", "lparen"),
        ("close", ")", "rparen"),
        ("open", "[", "lbrack"),
        ("close", "]", "rbrack"),
        ("open", "{", "mathbf mathit bm boldsymbol pmb textbf textit emph boxed mathnormal"),
        ("open upright", "{", "text textrm textup textnormal textsf mathrm mathsf operatorname mbox"),
        ("bar", "|", "vert mid lvert rvert"),
        ("percent", "%", "%"),
        ("relation", "=", "approx simeq cong equiv sim doteq"),
        ("hedge", "±", "pm mp"),
        ("hedge", "<", "lt gt le ge leq geq leqslant geqslant ne neq not ll gg lesssim gtrsim in"),
        ("hedge", ",", "\\ lor land vee wedge cup to rightarrow ldots dots cdots begin end"),
        ("mark", "a prime", "prime"),
        ("mark", "an accent", "vec dot ddot hat bar tilde overline overrightarrow mathcal"),
        ("constant", "pi", "pi"),
        ("constant", "inf", "infty"),
    )
    for name in names.split()
}
SIGNS: Final = {
    **{sign: ("open", sign) for sign in "([{"},
    **{sign: ("close", sign) for sign in ")]}"},
    **dict.fromkeys("*×·⋅∙", ("times", "*")),
    **dict.fromkeys("-−", ("minus", "-")),
    **dict.fromkeys("=≈≃≅≡", ("relation", "=")),
    **dict.fromkeys("±∓", ("hedge", "±")),
    **dict.fromkeys("<>≤≥≠≪≫∈", ("hedge", "<")),
    **dict.fromkeys(",;&…∨∧∪→", ("hedge", ",")),
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
HEDGES: Final = frozenset({"or", "and", "to", "between", "either", "through", "versus", "vs"})
CLOSES: Final = {"(": ")", "[": "]", "{": "}", "\\{": "\\}"}
