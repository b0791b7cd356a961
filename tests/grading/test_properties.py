"""Tests that every allowed spelling passes, and that every mutation of a reference fails."""

import math
import random
import time
from collections.abc import Callable
from fractions import Fraction

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from formula_trees import NAMES, Tree, leaf, mutant, values
from sim2reason.grading import Outcome, Score, formula, number
from sim2reason.scenes.dsl.units import parse_unit

steady = settings(derandomize=True, max_examples=400)

EXACT = 1e-9  # as a tolerance, so that only the very value passes


# numbers -----------------------------------------------------------------------------------------------------------


def grouped(digits: str, comma: str) -> str:
    whole, _, rest = digits.partition(".")
    return f"{int(whole):,}".replace(",", comma) + (f".{rest}" if rest else "")


def plain(x: Fraction) -> str:
    text = f"{x.numerator * 10**12 // x.denominator:013d}"
    return f"{text[:-12]}.{text[-12:]}".rstrip("0").rstrip(".")


POWERS = [
    "{m}e{n}",
    "{m}E{n}",
    r"{m}\times10^{{{n}}}",
    r"{m} \cdot 10^{{{n}}}",
    "{m} x 10^{n}",
    "{m}*10**{n}",
    "{m}×10^{{{n}}}",
    r"{m}\times 10^{{{m2}}}",
    "{m}·10{s}",
    r"{m} \; \times \; {{10}}^{{{n}}}",
    r"\left({m}\right)\left(10^{{{n}}}\right)",
]
WRAPPERS = [
    "{}",
    " {} ",
    r"\text{{{}}}",
    r"\mathrm{{{}}}",
    r"\mathbf{{{}}}",
    r"\color{{red}}{{{}}}",
    r"{{\color{{blue}} {}}}",
    r"\displaystyle {}",
    r"\left({}\right)",
    r"({})",
    "{{{}}}",
    r"\boxed{{{}}}",
    r"{}\,",
    r"x = {}",
    r"\vec{{v}}' = {}",
    r"\Delta t_{{\text{{fall}}}} = {}",
    r"v_0 \approx {}",
    r"\approx {}",
    r"a = b = {}",
    "{}.",
    "${}$",
]


@steady
@given(
    mantissa=st.integers(1, 999_999).map(lambda n: Fraction(n, 1000)),
    exponent=st.integers(-30, 30),
    spelling=st.sampled_from(POWERS),
    wrapper=st.sampled_from(WRAPPERS),
    minus=st.sampled_from(["", "-", "−", "–", "+", "- "]),
)
def test_every_scientific_spelling_passes(
    mantissa: Fraction, exponent: int, spelling: str, wrapper: str, minus: str
) -> None:
    raised = str(exponent).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    dashed = str(exponent).replace("-", "−")
    text = minus + spelling.format(m=plain(mantissa), n=exponent, m2=dashed, s=raised)
    value = float(mantissa) * 10.0**exponent * (-1 if minus.strip() in {"-", "−", "–"} else 1)
    response = rf"\boxed{{{wrapper.format(text)}}}"
    assert number(response, value, tolerance=EXACT).reward, response
    assert number(response, -value).outcome == Outcome.WRONG
    assert number(response, value * 1.06).outcome == Outcome.WRONG
    assert number(response, value * 10).outcome == Outcome.WRONG


@steady
@given(
    st.integers(1000, 10**12),
    st.integers(0, 99),
    st.sampled_from([",", "{,}", r"\,", " ", "~", r"\ ", "\u202f", r"\!"]),
)
def test_thousands_in_groups_of_three_pass(whole: int, cents: int, comma: str) -> None:
    text = grouped(f"{whole}.{cents:02d}", comma)
    assert number(rf"\boxed{{{text}}}", whole + cents / 100, tolerance=EXACT).reward
    broken = text.replace(comma, comma + "0", 1)
    assert not number(rf"\boxed{{{broken}}}", whole + cents / 100).reward


CLOSED: dict[str, Callable[[int, int], float]] = {
    r"\frac{{{a}}}{{{b}}}": lambda a, b: a / b,
    r"\dfrac{{{a}}}{{{b}}}": lambda a, b: a / b,
    "{a}/{b}": lambda a, b: a / b,
    r"{a} \div {b}": lambda a, b: a / b,
    r"{a}\sqrt{{{b}}}": lambda a, b: a * math.sqrt(b),
    r"\sqrt[3]{{{a}}}": lambda a, _: a ** (1 / 3),
    "{a}√{{{b}}}": lambda a, b: a * math.sqrt(b),
    r"\frac{{{a}\pi}}{{{b}}}": lambda a, b: a * math.pi / b,
    "{a}π/{b}": lambda a, b: a * math.pi / b,
    r"{a}\sin\left(\frac{{\pi}}{{{b}+1}}\right)": lambda a, b: a * math.sin(math.pi / (b + 1)),
    r"{a}\tan {b}^\circ": lambda a, b: a * math.tan(math.radians(b)),
    r"{a}e^{{-{b}/100}}": lambda a, b: a * math.exp(-b / 100),
    r"{a}\ln({b}+1)": lambda a, b: a * math.log(b + 1),
    r"{a}^{{1/{b}}}": lambda a, b: a ** (1 / b),
    r"({a})({b})": lambda a, b: a * b,
    r"{a} + {b}": lambda a, b: a + b,
    r"{a} \times {b}^2": lambda a, b: a * b**2,
}


@pytest.mark.parametrize("form", CLOSED)
def test_closed_forms_pass(form: str) -> None:
    rng = random.Random(form)
    for _ in range(20):
        a, b = rng.randrange(1, 80), rng.randrange(1, 80)
        assert number(rf"\boxed{{{form.format(a=a, b=b)}}}", CLOSED[form](a, b), tolerance=EXACT).reward, (form, a, b)


# units -------------------------------------------------------------------------------------------------------------

PREFIXES = {"": 1, "k": 1e3, "M": 1e6, "G": 1e9, "c": 1e-2, "m": 1e-3, "u": 1e-6, "µ": 1e-6, r"\mu ": 1e-6, "n": 1e-9}
SYMBOLS = ["m", "g", "s", "A", "K", "mol", "cd", "rad", "Hz", "N", "Pa", "J", "W", "C", "V", "F", "S", "Wb", "T", "H"]
SYMBOLS += ["lm", "lx", "Bq", "Gy", "Sv", "kat", "eV", "L"]
WORDS = {
    "metres": "m",
    "meter": "m",
    "Newtons": "N",
    "joules": "J",
    "kilometers": "km",
    "seconds": "s",
    "radians": "rad",
    "degrees": "deg",
    "hours": "h",
    "minutes": "min",
    "days": "d",
    "years": "yr",
    "kilograms": "kg",
    "percent": "%",
    "litres": "L",
    "AU": "au",
    "metres per second": "m/s",
    "meters per second squared": "m/s^2",
    "°": "deg",
    r"^\circ": "deg",
    r"^{\circ}": "deg",
    r"\%": "%",
}
UPRIGHT = [
    "{}",
    r"\text{{ {}}}",
    r"\,\mathrm{{{}}}",
    r"\ \text{{{}}}",
    r"~\mathrm{{{}}}",
    r"\; {}",
    r"\cdot\text{{{}}}",
    r"\,({})",
]


@pytest.mark.parametrize("symbol", SYMBOLS)
def test_every_prefixed_symbol_passes(symbol: str) -> None:
    for (prefix, scale), frame in zip(PREFIXES.items(), UPRIGHT * 2, strict=False):
        response = rf"\boxed{{3 {frame.format(prefix + symbol)}}}"
        assert number(response, 3 * scale, symbol, tolerance=EXACT).reward, response
        assert not number(response, 30 * scale, symbol).reward
        assert number(response, 3 * scale, "kg^2*s").outcome == Outcome.WRONG_UNIT


@pytest.mark.parametrize("word", WORDS)
def test_every_name_passes(word: str) -> None:
    assert number(rf"\boxed{{3 {word}}}", 3, WORDS[word], tolerance=EXACT).reward
    assert number(rf"\boxed{{3}} {word}", 3, WORDS[word], tolerance=EXACT).reward


@steady
@given(
    powers=st.dictionaries(
        st.sampled_from(["kg", "m", "s", "A", "K", "N", "rad", "km"]),
        st.integers(-3, 3).filter(bool),
        min_size=1,
        max_size=4,
    ),
    joint=st.sampled_from([r"\,", " ", r"\cdot ", "·", "*", r"}\text{", r"}\cdot\mathrm{"]),
    raised=st.sampled_from(["^{{{}}}", "^{}", "sup"]),
    style=st.sampled_from(["negative", "slash", "fraction"]),
)
def test_every_compound_unit_passes(powers: dict[str, int], joint: str, raised: str, style: str) -> None:
    def spell(items: list[tuple[str, int]]) -> str:
        marks = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
        exponents = [str(n).translate(marks) if raised == "sup" else raised.format(n) for _, n in items]
        return joint.join(word + ("" if n == 1 else mark) for (word, n), mark in zip(items, exponents, strict=True))

    above = [(word, n) for word, n in powers.items() if n > 0]
    below = [(word, -n) for word, n in powers.items() if n < 0]
    if style == "negative" or not below or not above:
        text = rf"\mathrm{{{spell(list(powers.items()))}}}"
    elif style == "slash":
        under = spell(below) if len(below) == 1 else rf"\left(\mathrm{{{spell(below)}}}\right)"
        text = (
            rf"\mathrm{{{spell(above)}}}/\mathrm{{{under}}}"
            if len(below) > 1
            else rf"\mathrm{{{spell(above)}/{under}}}"
        )
    else:
        text = rf"\frac{{\mathrm{{{spell(above)}}}}}{{\mathrm{{{spell(below)}}}}}"
    asked = "*".join(f"{word}^{n}" for word, n in powers.items())
    assert number(rf"\boxed{{7.5\,{text}}}", 7.5, asked, tolerance=EXACT).reward, text
    assert number(rf"\boxed{{7.5\,{text}}}", 7.5, parse_unit(asked).name, tolerance=EXACT).reward
    assert number(rf"\boxed{{7.5\,{text}}}", 7.5, f"{asked}*mol").outcome == Outcome.WRONG_UNIT


# whatever is said ---------------------------------------------------------------------------------------------------

COMMANDS = (
    "text{ mathrm{ frac{ sqrt{ SI{ qty{ num{ pu{ ang{ Rightarrow quad over bar{ ldots sim approx boxed{ downarrow"
)
PIECES = [
    *"0123456789.,;:+-*/^_=()[]{}|<>~$&%°½√ \n\ud800",
    "9.8",
    "v = ",
    "e",
    "m/s",
    "kg",
    "up",
    " to the right",
    "or",
]
PIECES += [f"\\{name}" for name in COMMANDS.split()]
PIECES += ["}", "}{", r"\meter\per\second", "not", "is", "(3 s.f.)", "**", "x^2"]


@settings(steady, max_examples=1500)
@given(st.one_of(st.text(max_size=300), st.lists(st.sampled_from(PIECES), max_size=60).map("".join)))
def test_any_text_has_its_score_in_time(text: str) -> None:
    for response in (text, rf"\boxed{{{text}}}"):
        (scores, first), (_, second) = _timed(response), _timed(response)  # one may meet a collection of garbage
        assert min(first, second) < 2 * 0.05
        assert all(score.why and not score.reward for score in scores)


def _timed(response: str) -> tuple[list[Score], float]:
    start = time.thread_time()
    scores = [
        number(response, 73219.456, "m/s", positive="up", lenient=True, tolerance=EXACT),
        formula(response, r"\frac{m_1 g\sin\theta+h^3}{2m_1+5h}"),
    ]
    return scores, time.thread_time() - start


OBJECTS = st.recursive(
    st.one_of(st.none(), st.booleans(), st.integers(), st.floats(), st.text(max_size=20), st.binary(max_size=20)),
    lambda inner: st.one_of(
        st.lists(inner, max_size=3),
        st.dictionaries(st.sampled_from(["role", "content", "text", 3]), inner, max_size=3),
        st.tuples(inner, inner),
    ),
    max_leaves=8,
)


@steady
@given(OBJECTS)
def test_any_object_has_its_score(response: object) -> None:
    assert not number(response, 73219.456, lenient=True, tolerance=EXACT).reward
    assert formula(response, "mgh").outcome in {Outcome.NO_ANSWER, Outcome.UNREADABLE}


@pytest.mark.parametrize(
    "response",
    [
        rb"\boxed{9.8}",
        bytearray(rb"\boxed{9.8}"),
        [{"role": "user", "content": "?"}, {"role": "assistant", "content": r"\boxed{9.8}"}],
        {"role": "assistant", "content": r"\boxed{9.8}"},
        [{"role": "assistant", "content": [{"type": "text", "text": r"\boxed{9.8}"}]}],
        "\ud800" + r"\boxed{9.8}",
    ],
)
def test_the_last_message_counts(response: object) -> None:
    assert number(response, 9.8).reward
    assert not number([response, ""], 9.8).reward


# formulas ----------------------------------------------------------------------------------------------------------

LEAVES = st.one_of(
    st.sampled_from(NAMES).map(lambda name: leaf("symbol", name=name)),
    st.sampled_from([2.0, 3.0, 0.5, 4.9, 7.25]).map(lambda x: leaf("number", number=x)),
)
TREES = st.recursive(
    LEAVES,
    lambda inner: st.one_of(
        st.builds(
            lambda k, a, b: Tree(k, (a, b)), st.sampled_from(["sum", "difference", "product", "quotient"]), inner, inner
        ),
        st.builds(lambda k, a: Tree(k, (a,)), st.sampled_from(["sqrt", "sin", "cos", "exp", "minus"]), inner),
        st.builds(lambda a, n: Tree("power", (a,), number=n), inner, st.sampled_from([2.0, 3.0, -1.0, 0.5])),
    ),
    max_leaves=8,
)


POINTS = [{name: 0.2 + 1.3 * random.Random(f"{i}{name}").random() for name in NAMES} for i in range(40)]


@settings(steady, max_examples=300)
@given(TREES, st.integers(0, 10**9))
def test_every_form_passes_and_every_mutation_fails(tree: Tree, seed: int) -> None:
    check_forms(tree, seed)


@pytest.mark.slow
@settings(steady, max_examples=1500)
@given(TREES, st.integers(0, 10**9))
def test_many_forms_pass_and_their_mutations_fail(tree: Tree, seed: int) -> None:
    check_forms(tree, seed)


def check_forms(tree: Tree, seed: int) -> None:
    rng = random.Random(seed)
    truth = values(tree, POINTS)
    sound = [x for x in truth if x is not None]
    assume(any(node.kind == "symbol" for node in tree.nodes()))
    assume(len(sound) > 30 and all(1e-6 < abs(x) < 1e6 for x in sound))
    reference = tree.spell(rng)
    right = formula(rf"\boxed{{{tree.spell(rng)}}}", reference, symbols=NAMES)
    assert right.reward, (reference, right)
    changed = mutant(tree, rng)
    different = [
        y is None or abs(y - x) > 1e-4 * abs(x)
        for x, y in zip(truth, values(changed, POINTS), strict=True)
        if x is not None
    ]
    assume(sum(different) > len(different) / 2)
    wrong = formula(rf"\boxed{{{changed.spell(rng)}}}", reference, symbols=NAMES)
    assert not wrong.reward, (reference, changed.spell(rng))
    assert wrong.outcome in {Outcome.WRONG, Outcome.UNREADABLE, Outcome.TOO_LONG}
    at = {name: 0.4 + 0.1 * i for i, name in enumerate(NAMES)}
    around = values(tree, [at, *({**at, name: 1.02 * at[name]} for name in NAMES)])
    if None not in around and max(abs(x - around[0]) for x in around) > 1e-4 * abs(around[0]) > 0:
        assert formula(rf"\boxed{{{tree.spell(rng)}}}", reference, at).reward
        assert not formula(rf"\boxed{{{tree.value(at)!r}}}", reference, at).reward, "the bare value"


MUTATIONS = {
    r"\sqrt{2gh}": [
        r"-\sqrt{2gh}",
        r"\sqrt{gh}",
        r"\sqrt{2gh^2}",
        r"\sqrt{2g}",
        r"\sqrt{2.05gh}",
        "2gh",
        r"\sqrt{2g}h",
        r"\sqrt[3]{2gh}",
    ],
    r"2\pi\sqrt{\frac{L}{g}}": [
        r"2\pi\sqrt{\frac{g}{L}}",
        r"\pi\sqrt{\frac{L}{g}}",
        r"6.28\sqrt{L/g}",
        r"2\pi\frac{L}{g}",
        r"2\pi\sqrt{\frac{l}{g}}",
        r"2\sqrt{L/g}",
    ],
    r"\frac{m_1-m_2}{m_1+m_2}g": [
        r"\frac{m_2-m_1}{m_1+m_2}g",
        r"\frac{m_1-m_2}{m_1+m_2}",
        r"\frac{m_1+m_2}{m_1-m_2}g",
        r"\frac{m_1-m_2}{m_1}g",
        "g",
        r"\frac{m_1-1.02m_2}{m_1+m_2}g",
        r"\frac{M_1-M_2}{M_1+M_2}g",
        r"\frac{m_1-m_2}{m_1+m_2}G",
    ],
    r"mg\sin\theta-\mu mg\cos\theta": [
        r"mg\cos\theta-\mu mg\sin\theta",
        r"mg\sin\theta+\mu mg\cos\theta",
        r"g\sin\theta-\mu g\cos\theta",
        r"mg\sin(\theta-\mu)",
        r"mg\sin\theta-mg\cos\theta",
        r"mg\sin\theta",
        r"mg\sin2\theta-\mu mg\cos\theta",
        r"mg\sin\theta-\mu mg\cos^2\theta",
    ],
    r"v_0e^{-kt}": [
        r"v_0e^{kt}",
        r"v_0(1-e^{-kt})",
        r"v_0 2.72^{-kt}",
        r"v e^{-kt}",
        r"v_0e^{-k/t}",
        r"v_0(2.7)^{-kt}",
        r"v_0-kt",
    ],
}


@pytest.mark.parametrize(("reference", "wrong"), [(ref, wrong) for ref, many in MUTATIONS.items() for wrong in many])
def test_known_mistakes_fail(reference: str, wrong: str) -> None:
    assert formula(rf"\boxed{{{reference}}}", reference).reward
    assert not formula(rf"\boxed{{{wrong}}}", reference).reward
