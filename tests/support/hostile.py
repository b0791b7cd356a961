"""Answers that try to crash, stall, blow up or mislead a grader; shared by the tests and the benchmark."""

import random
from collections.abc import Iterator

LETTERS = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
CODE = [
    "__import__('os').system('touch canary')",
    "open('canary','w')",
    "exec('import os')",
    "eval('9.8')",
    "().__class__.__base__.__subclasses__()",
    "lambda: 9.8",
    "[x for x in (9.8,)]",
    'f"{9.8}"',
    "\\input{/etc/passwd}",
    "\\immediate\\write18{ls}",
    "\\csname boxed\\endcsname{9.8}",
    "\\def\\x{9.8}\\x",
    "%9.8\n",
    "9.8 if True else 0",
    "0x9p1",
    "9_8",
    "${9.8}",
    "{{9.8}}",
    "<script>9.8</script>",
    "nan",
    "inf",
    "-inf",
    "1e999999999",
    "None",
    "True",
]
PIECES = [
    *"0123456789.,;:+-*/^_=()[]{}|<>!'\"%$&~?@#` \t\n\\",
    *"−–—±×·÷√π∞°²³⁻¹₀₁≈≤…µΩθ٣９𝟗․\u200b\u200d\u202e\ufeff\x00\x07\x1b",
    *["\\frac", "\\sqrt", "\\left", "\\right", "\\text{", "\\mathrm{", "\\boxed{", "\\cdot", "\\times", "\\pm", "\\,"],
    *["\\sin", "\\log_", "\\pi", "\\theta", "\\mu_k", "\\circ", "\\begin{cases}", "\\\\", "\\infty", "\\approx", "\\%"],
    *[
        "e",
        "E",
        "x",
        "g",
        "h",
        "m",
        "m_1",
        "m_{",
        "kg",
        "m/s",
        "sqrt(",
        "sin",
        "or",
        "and",
        "to",
        "10^",
        "1e",
        "**",
        "!!",
    ],
    *["<think>", "</think>", "9.8", "73219.4", "1,200", "0", "1/0", "(-1)^", "^{^{"],
]


def giants() -> dict[str, str]:
    """Return the largest answer of each kind that is known to be harmful."""
    deep = "1"
    for _ in range(25):
        deep = rf"\frac{{1}}{{1+{deep}}}"
    inside = {
        "tower": "^{".join(["9"] * 300) + "}" * 299,
        "plain tower": "^".join("9" * 400),
        "starred tower": "**".join("9" * 300),
        "short tower": "9^{9^{9}}",
        "factorials": "9" + "!" * 900,
        "nested factorials": "(" * 300 + "9" + "!)" * 300,
        "25-deep fraction": deep,
        "200-deep fraction": r"\frac{1}{1+" * 80 + "1" + "}" * 80,
        "digits": "9" * 990,
        "a million digits": "9" * 999_000,
        "fraction of digits": "0." + "0" * 900 + "1",
        "exponent of digits": "1e" + "9" * 900,
        "groups": "1" + ",000" * 240,
        "sum": "1+" * 490 + "1",
        "product": "2*" * 490 + "2",
        "quotient": "2/" * 490 + "2",
        "juxtaposed": "(2)" * 330,
        "parentheses": "(" * 499 + "1" + ")" * 499,
        "open parentheses": "(" * 999,
        "braces": "{" * 499 + "1" + "}" * 499,
        "bars": "|" * 999,
        "half-open bars": "|1+" * 300,
        "signs": "-" * 999,
        "alternating signs": "+-" * 490 + "1",
        "equals": "=" * 999,
        "equations": "1=" * 490 + "1",
        "roots": r"\sqrt" * 190 + "2",
        "indexed roots": r"\sqrt[2]{" * 100 + "2" + "}" * 100,
        "functions": r"\sin" * 240 + "1",
        "powers of functions": r"\sin^" * 190 + "2",
        "wrappers": r"\text{" * 150 + "9.8" + "}" * 150,
        "colours": r"\color{red}" * 85 + "9.8",
        "commands in a subscript": "m_{" + r"\aaaaaaaaa" * 90 + "!",
        "letters in a subscript": "m_{" + "a" * 990,
        "spaces": "9" + " " * 980 + "8",
        "spaces after plus": "9+" + " " * 970 + "!",
        "thin spaces": "9" + r"\," * 490 + "8",
        "letters": LETTERS * 19,
        "function letters": "sincostan" * 105,
        "greek": "θ" * 990,
        "units": "9.8 " + "m" * 190,
        "spelled units": "9.8 " + "m " * 90,
        "unit groups": "9.8 " + "(m" * 60 + ")" * 60,
        "unit powers": "9.8 m" + "^9" * 60,
        "unit fractions": "9.8 " + r"\frac{" * 30 + "m" + "}{s}" * 30,
        "long unit": "9.8 " + "kg m " * 195,
        "superscripts": "9" + "⁹" * 990,
        "degrees": "9" + "°" * 900,
        "control characters": "".join(map(chr, range(32))) * 20,
        "combining marks": "9" + "\u0301" * 900,
        "mixed scripts": "９𝟗٣৯" * 200,
        "lone surrogate": "9.8\ud800",
        "underflow": "10^{-400}",
        "overflow": "10^{308}*10^{308}",
        "infinite quotient": r"\frac{1}{\infty}",
    }
    repeated = "(s:", "ab:", "is ", "s:", "speed:", "→", "←", r"\to ", "(m", r"\SI{", ", ", r"\quad "
    inside |= {f"many {piece}": piece * (990 // len(piece)) for piece in repeated}
    inside |= {f"many {piece} in a parenthesis": "(" + piece * (980 // len(piece)) for piece in repeated}
    boxed = {name: rf"\boxed{{{content}}}" for name, content in inside.items()}
    return boxed | {
        "no braces": r"\boxed" * 150_000,
        "open boxes": r"\boxed{" * 140_000,
        "closed boxes": r"\boxed{" * 60_000 + "}" * 60_000,
        "many boxes": r"\boxed{9}" * 100_000,
        "open braces": "{" * 999_999,
        "closing braces": "}" * 999_999,
        "backslashes": "\\" * 999_999,
        "thinking": "<think>" * 140_000,
        "half thinking": "<think" * 160_000,
        "thought": "</think>" * 120_000 + r"\boxed{1}",
        "a gigantic response": "9" * 5_000_000,
        "empty": "",
    }


def strings(count: int, seed: int) -> Iterator[str]:
    """Yield random boxed texts: mixed pieces, nested pieces, code, broken answers."""
    rng = random.Random(seed)
    for _ in range(count):
        length = rng.choice((1, 2, 3, 5, 8, 13, 40, 150))
        soup = "".join(rng.choices(PIECES, k=length))
        match rng.randrange(5):
            case 0:
                soup = rng.choice(CODE)[: rng.randrange(1, 60)] + soup
            case 1:
                soup = _nested(rng, soup)
            case 2:
                soup = "".join(chr(rng.randrange(1, 0xD7FF)) if rng.random() < 0.3 else c for c in soup)
            case _:
                pass
        yield soup if rng.random() < 0.03 else rf"\boxed{{{soup}}}"


def _nested(rng: random.Random, soup: str) -> str:
    for _ in range(rng.randrange(1, 30)):
        before, after = rng.choice(
            [("(", ")"), ("{", "}"), (r"\frac{1}{", "}"), (r"\sqrt{", "}"), ("2^{", "}"), ("|", "|")]
        )
        soup = before + soup + after
    return soup
