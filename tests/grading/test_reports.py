"""Tests of errors reported for other graders: units, alternative spellings, left sides."""

import pytest

from sim2reason.grading import Outcome, formula, number


@pytest.mark.parametrize(
    ("answer", "value", "unit"),
    [
        (r"2\,\text{mins}", 120, "s"),
        (r"3\text{ rads/s}", 3, "rad/s"),
        (r"3\text{ cycles/s}", 3, "Hz"),
        (r"3\text{ cycles per second}", 3, "Hz"),
        (r"21.5\text{ mph}", 9.6, "m/s"),
        (r"31.5\text{ ft/s}", 9.6, "m/s"),
        (r"31.5\text{ feet per second squared}", 9.6, "m/s^2"),
        (r"2.16\text{ lbf}", 9.6, "N"),
        (r"9.6\text{ KJ}", 9600, "J"),
        (r"1\text{ h }5\text{ min }20\text{ s}", 3920, "s"),
        (r"-1\text{ h }5\text{ min }20\text{ s}", -3920, "s"),
        (r"26^\circ 30'", 26.5, "deg"),
        (r"26^\circ\,30'\,36''", 26.51, "deg"),
        ("26°30′", 26.5, "deg"),
        (r"2\,310{,}5\text{ m}", 2310.5, "m"),
        ("0.42 m (or 42 cm)", 0.42, "m"),
        (r"0.42\text{ m }(\text{or }42\text{ cm})", 0.42, "m"),
        (r"0.42\text{ m (equivalently 42 cm)}", 0.42, "m"),
        (r"2.4\,\hat{i}\text{ m/s}", 2.4, "m/s"),
        (r"2.4\text{ m/s}\;\hat{\mathbf{x}}", 2.4, "m/s"),
        (r"-2.4\,\mathbf{\hat{k}}\text{ m/s}^2", -2.4, "m/s^2"),
        (r"9.6\text{ m/s at an angle of }30^\circ\text{ below the horizontal}", 9.6, "m/s"),
        (r"9.6\text{ m/s, where }v\text{ is the speed of the block}", 9.6, "m/s"),
        (r"9.6\text{ m} = h", 9.6, "m"),
        ("0.42 : 1", 0.42, ""),
        ("v_2 - v_1 = 9.6", 9.6, "m/s"),
        (r"\frac{v^2}{2g} = 9.6", 9.6, "m"),
    ],
)
def test_what_people_write_is_read(answer: str, value: float, unit: str) -> None:
    score = number(rf"$\boxed{{{answer}}}$", value, unit, tolerance=0.002)
    assert score.reward, score.why
    assert not number(rf"$\boxed{{{answer}}}$", 1.05 * value, unit, tolerance=0.002).reward


@pytest.mark.parametrize(
    ("answer", "value", "unit"),
    [
        (r"\frac{a}{g} = 9.6", 9.6, "m/s^2"),
        (r"\frac{v}{t^2} = 9.6", 9.6, "m/s^2"),
        (r"\sqrt{gh} = 9.6", 9.6, "m/s^2"),
        ("a - g = 9.6", 9.6, "m/s^2"),
        ("a + b = 9.6", 9.6, None),
        (r"\text{previous value: }9.6", 9.6, "m/s^2"),
        (r"\text{Speed prior: }9.6", 9.6, "m/s"),
        ("4.8 (or 2)", 9.6, "m/s"),
        ("0.42 m (or 43 cm and 1 cm)", 0.42, "m"),
        ("0.42 m (or 84 cm)", 0.42, "m"),
        (r"3.2\,\hat{y}\text{ m/s}", -3.2, "m/s"),
        (r"9.6\hat{i}+4.8\hat{j}", 9.6, "m/s"),
        (r"2\hat{i}\,4.8", 9.6, "m/s"),
        (r"9.6\text{ m/s at }30^\circ", 9.6, "m/s"),
        (r"9.6\text{ m/s at }30^\circ\text{ below the horizontal}", -9.6, "m/s"),
        (r"9.6\text{ m/s, where the right value is half of it}", 9.6, "m/s"),
        (r"9.6\text{ m/s, where }v\text{ is the wrong speed}", 9.6, "m/s"),
        ("0.42:1", 0.42, "m"),
        ("0.42:2", 0.42, ""),
        ("4.8 = 9.6 = h", 9.6, "m"),
        (r"4.8 \leq h", 4.8, "m"),
        ("1 h 65 min", 7500, "s"),
        (r"26^\circ 70'", 27.17, "deg"),
        (r"3\text{ cycles/s}", 3, "rad/s"),
        (r"3\text{ lb}", 3, "N"),
    ],
)
def test_what_says_something_else_is_not_paid(answer: str, value: float, unit: str | None) -> None:
    assert not number(rf"$\boxed{{{answer}}}$", value, unit).reward


@pytest.mark.parametrize(
    ("answer", "reference", "outcome"),
    [
        (r"\sqrt{2gh}\text{ where }h\text{ is the height}", r"\sqrt{2gh}", "correct"),
        (
            r"\sqrt{2gh},\ \text{where } g \text{ is the weight per mass and } h_1 \text{ is the drop}",
            r"\sqrt{2gh}",
            "correct",
        ),
        (r"v\text{ where }v = \sqrt{2gh}", r"\sqrt{2gh}", "unreadable"),
        (r"\sqrt{2gh} = v", r"\sqrt{2gh}", "correct"),
        (r"a - b = \sqrt{2gh}", r"\sqrt{2gh}", "unreadable"),
        (r"\vec{N} = m(\vec{g}+\vec{a})", "m(g+a)", "correct"),
        (r"\vec{N} = m(\vec{g}-\vec{a})", "m(g+a)", "wrong"),
        (r"|\vec{g}+\vec{a}|m", "m(g+a)", "unreadable"),
        (r"\vec{F}\cdot\vec{d}", "Fd", "unreadable"),
        (r"\vec{r}\times\vec{F}", "rF", "unreadable"),
    ],
)
def test_formulas_with_vectors_and_with_what_letters_mean(answer: str, reference: str, outcome: str) -> None:
    assert formula(rf"$\boxed{{{answer}}}$", reference).outcome == Outcome(outcome)
