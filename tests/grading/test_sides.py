"""Tests of the sides of an equation: the last counts if the others agree; ambiguous ones give a reason."""

import pytest

from sim2reason.grading import Outcome, Score, formula, number


def boxed(answer: str, reference: float = 9.8, unit: str | None = "m/s^2") -> Score:
    return number(rf"So $\boxed{{{answer}}}$.", reference, unit)


@pytest.mark.parametrize(
    ("answer", "outcome", "why"),
    [
        ("4.9 = 9.8", "wrong", "'4.9' does not agree with the value behind it"),
        (r"2\cdot 4 = 9.8", "wrong", r"'2\\cdot 4' does not agree with the value behind it"),
        (r"a_1 = 4.9,\ a_2 = 9.8", "unreadable", "it names two values, and nothing says which is meant"),
        (r"a_1 = 4.9\quad a_2 = 9.8", "unreadable", "it names two values, and nothing says which is meant"),
        ("4.9, 9.8", "wrong", "a list is more than one value"),
        (r"4 \sim 9.8", "wrong", "a range is not one value"),
        ("2a = 9.8", "unreadable", "it is an equation that is still to be solved"),
        ("-a = 9.8", "unreadable", "it is an equation that is still to be solved"),
        (r"a \text{ is not } = 9.8", "unreadable", "'not' before the value changes what it says"),
        (r"\text{bananas} = 9.8", "unreadable", "'bananas' is no word for a quantity that is known here"),
        (r"1\text{ at }t = 9.8", "unreadable", "'at' stands among numbers and is no unit"),
        ("a = = 9.8", "unreadable", "there is nothing between two signs of equality"),
        (r"9.8\phantom{4}", "unreadable", r"\phantom hides a part of the answer"),
        (r"10\text{--}0.2", "wrong", "a range is not one value"),
        (r"9.8\tag{or 12}", "unreadable", r"\tag has no meaning here"),
        (r"\tag{not }9.8", "unreadable", r"\tag has no meaning here"),
        ("9.8 1", "unreadable", "two numbers stand side by side"),
        (
            r"9.8\text{ bananas}",
            "unreadable",
            r"'\\text{ bananas}' after the value: 'bananas' is not in the table of units",
        ),
    ],
)
def test_what_is_not_paid_says_why(answer: str, outcome: str, why: str) -> None:
    score = boxed(answer)
    assert (score.outcome, score.why) == (outcome, why)


@pytest.mark.parametrize(
    ("answer", "sign"),
    [
        (r"\neq 9.8", r"\neq"),
        ("a > 9.8", ">"),
        (r"a \gtrsim 9.8", r"\gtrsim"),
        (r"a\in\{9.8, 2\}", r"\in"),
        ("&&&", "&"),
        (r"a\to 9.8", r"\to"),
        (r"9.8 \mp 5", r"\mp"),
        ("9.8 +- 5", "+-"),
        (r"9.8\text{ or }12", "or"),
    ],
)
def test_a_reason_quotes_what_the_answer_has(answer: str, sign: str) -> None:
    assert boxed(answer).why == f"'{sign}' makes it more, or less, than one value"


def test_a_sign_that_cannot_be_read_is_quoted_as_it_stands() -> None:
    assert boxed(r"9.8 \times\div 5").why == r"'\div' cannot be read where it stands"


@pytest.mark.parametrize(
    "before", ["9.8", "9.75", r"19.6/2", r"\sqrt{96.04}", r"980\text{ cm/s}^2", r"9.8\text{ N/kg}"]
)
def test_sides_in_numbers_that_agree(before: str) -> None:
    assert boxed(rf"{before} = 9.8\text{{ m/s}}^2").reward
    assert boxed(rf"a = {before} = 9.8\text{{ m/s}}^2").reward
    assert boxed(rf"a = {before} \approx 9.8").reward
    assert not boxed(rf"a = 2\cdot {before} = 9.8\text{{ m/s}}^2").reward


@pytest.mark.parametrize("name", ["a", "a_A", "a_{x=2}", "|a|", r"\vec{a}'", "a(2)", r"\ddot x", r"\Delta v", "a^*"])
def test_names(name: str) -> None:
    assert boxed(f"{name} = 9.8").reward
    assert boxed(f"{name} = 4.9").outcome == Outcome.WRONG


@pytest.mark.parametrize(
    "name",
    [
        *(f"the {word} of the acceleration" for word in ("square", "cube", "sine", "cosine", "logarithm", "root")),
        *(
            "one third of the acceleration",
            "two tenths of it",
            "sum of the accelerations",
            "ratio of the accelerations",
        ),
        *("acceleration times mass", "acceleration per mass", "mean square acceleration", "rate of the acceleration"),
    ],
)
def test_words_that_make_another_quantity(name: str) -> None:
    for said in (rf"\text{{{name} is }}9.8", rf"\text{{{name}}} = 9.8", rf"\text{{{name}: }}9.8"):
        assert not boxed(said).reward


def test_words_that_name_a_thing_are_no_operations() -> None:
    for name in ("acceleration of the cube", "acceleration of the third block", "Block A", "For block A"):
        assert boxed(rf"\text{{{name}: }}9.8").reward
    assert not boxed(r"\text{Block B: }4.9, \text{ Block A: }9.8").reward
    assert not boxed(r"\text{acceleration}^2 = 9.8").reward


@pytest.mark.parametrize("product", ["xy", "ma", "m a", r"v \cdot t", "mgh"])
def test_a_product_with_another_dimension_is_no_name(product: str) -> None:
    assert boxed(f"{product} = 9.8").outcome == Outcome.UNREADABLE
    assert boxed(f"a = {product} = 9.8").reward


def test_a_product_with_the_asked_dimension_is_a_step() -> None:
    assert boxed("mgh = 9.8", unit="J").reward
    assert boxed("ma = 9.8", unit="N").reward
    assert boxed("kq = 9.8", unit="N").reward, "letters that may be anything"


def test_a_condition_in_numbers_could_be_an_answer() -> None:
    assert boxed(r"\text{for }12, 9.8").outcome == Outcome.UNREADABLE
    assert boxed(r"\text{at }t = 12, 9.8").reward
    assert boxed(r"\text{for block 12, }9.8").reward


@pytest.mark.parametrize("joint", [r"\Rightarrow", r"\implies", r"\text{ so }", ",", r"\therefore", "⇒"])
def test_a_step_is_no_claim(joint: str) -> None:
    assert boxed(rf"a^2 = 96.04 {joint} a = 9.8").reward
    assert boxed(rf"a^2 = 9.8 {joint} a = 3.13").outcome == Outcome.WRONG
    assert not boxed(rf"a = 4.9 {joint} a = 9.8").reward


JOINTS = [r"\text{ so }", r"\text{, so }", r"\quad\text{hence}\quad ", r"\text{ thus }", r"\text{ therefore }"]
JOINTS += [r"\to ", r"\rightarrow ", r"\Rightarrow ", r"\implies ", r"\therefore ", r";\ \therefore "]


@pytest.mark.parametrize("joint", JOINTS)
def test_a_step_may_not_give_another_name_another_value(joint: str) -> None:
    for name in ("x", "a_1", r"\text{Speed of A}", "|b|"):
        assert boxed(rf"{name} = 4.9{joint}a = 9.8").outcome == Outcome.UNREADABLE
        assert boxed(rf"4.9 = {name}{joint}a = 9.8").outcome == Outcome.UNREADABLE
        assert boxed(rf"{name} = 9.8{joint}a = 9.8").reward, "the same value"
    assert boxed(rf"x = 4.9\text{{ m/s}}^2{joint}a = 9.8\text{{ m/s}}^2").outcome == Outcome.UNREADABLE
    assert boxed(rf"x = 4.9 = a{joint}a = 9.8").outcome == Outcome.UNREADABLE
    assert formula(rf"\boxed{{E=mgh{joint}W=2mgh}}", "2mgh").outcome == Outcome.UNREADABLE
    assert formula(rf"\boxed{{E=2mgh{joint}W=2mgh}}", "2mgh").reward


@pytest.mark.parametrize("word", ["then", "giving", "which gives", "so that", "and so", "implies"])
def test_other_words_between_two_values_are_refused(word: str) -> None:
    assert boxed(rf"x = 4.9\text{{ {word} }}a = 9.8").outcome == Outcome.UNREADABLE


@pytest.mark.parametrize("joint", JOINTS)
def test_an_honest_step_is_read(joint: str) -> None:
    assert boxed(rf"a = gt{joint}a = 9.8").reward, "the value of the formula"
    assert boxed(rf"m = 2\,\mathrm{{kg}}{joint}F = ma = 9.8\,\mathrm{{N}}", unit="N").reward, "of another dimension"
    assert boxed(rf"h = 4.9t^2 = 20{joint}t = 9.8", unit="s").reward, "an equation for what is asked"
    assert formula(rf"\boxed{{W=Fd{joint}W=2mgh}}", "2mgh").reward


@pytest.mark.parametrize(
    ("answer", "unit", "reference"),
    [
        (r"\theta = \arcsin 0.5 = 30^\circ", "deg", 30),
        (r"0.5236 = 30^\circ", "rad", 0.5236),
        (r"2/3 = 66.7\%", "", 0.667),
    ],
)
def test_a_bare_side_may_be_in_radians_or_a_fraction(answer: str, unit: str, reference: float) -> None:
    assert boxed(answer, reference, unit).reward


@pytest.mark.parametrize(
    "answer", [r"9.8\tag{1.2*}", r"9.8\tag*{3}", r"12\text{-}2.2", r"a = \frac{19.6\text{ N}}{2\text{ Kg}} = 9.8"]
)
def test_what_print_adds_or_dashes(answer: str) -> None:
    assert boxed(answer).reward


def test_an_en_dash_where_a_value_begins_is_a_minus() -> None:
    assert boxed(r"\text{--}9.8", -9.8).reward


@pytest.mark.parametrize("word", ["for", "with", "when", "at", "after", "since", "given"])
def test_a_condition_is_of_another_quantity(word: str) -> None:
    for joint in (r",\ ", ";", r"\Rightarrow "):
        assert boxed(rf"\text{{{word} }}a=4.9{joint}a=9.8").outcome == Outcome.UNREADABLE
        assert boxed(rf"\text{{{word} }}a_1=4.9{joint}a_2=9.8").reward
        assert boxed(rf"\text{{{word} }}t=2\text{{ s}}{joint}v(t)=9.8").reward
        assert boxed(rf"\text{{{word} }}t=2\text{{ s}}{joint}9.8").reward
