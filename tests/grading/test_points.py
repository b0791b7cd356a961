"""Tests that formulas are compared with all symbols moved at once, so that no local approximation passes."""

import math
import random

import pytest

from sim2reason.grading import Score, formula
from sim2reason.grading.arithmetic import TEST_POINTS

OWN = {"m": 2.0, "g": 9.8, "h": 3.0, "m_1": 2.0, "m_2": 3.0, "theta": 1e-3, "v": 5.0, "k": 1.2}


def graded(answer: str, reference: str, bindings: object, **options: object) -> Score:
    return formula(rf"So $\boxed{{{answer}}}$.", reference, bindings, **options)


def near(width: float) -> list[dict[str, float]]:
    """Return the bindings of an item: its own numbers, and each of them times a random factor."""
    rng = random.Random(7)
    return [
        OWN,
        *({name: x * math.exp(rng.uniform(-width, width)) for name, x in OWN.items()} for _ in range(TEST_POINTS)),
    ]


BINDINGS = {"own": OWN, "near": near(0.08), "wide": near(1.1), "none": None}


@pytest.mark.parametrize("given", BINDINGS)
@pytest.mark.parametrize(
    ("answer", "reference"),
    [
        (r"mg\cdot 3+19.6(h-3)", "mgh"),
        (r"m\cdot 29.4+6(g-9.8)+19.6(h-3)", "mgh"),
        (r"g\theta", r"g\sin\theta"),
        (r"g\tan\theta", r"g\sin\theta"),
        (r"g(1-\frac{\theta^2}{2})", r"g\cos\theta"),
        (r"58.8+29.4(m-2)+6(g-9.8)+19.6(h-3)", "mgh"),
        (r"mgh(1+(m-2)(g-9.8)(h-3))", "mgh"),
    ],
)
def test_what_agrees_only_at_or_near_the_items_numbers(answer: str, reference: str, given: str) -> None:
    symbols = ["m", "g", "h", "theta"]
    assert graded(reference, reference, BINDINGS[given], symbols=symbols).reward
    assert not graded(answer, reference, BINDINGS[given], symbols=symbols).reward


@pytest.mark.parametrize("given", ["own", "wide", "none"])
def test_the_absolute_value_of_what_has_a_sign(given: str) -> None:
    reference = "(m_2-m_1)g"
    symbols = ["m_1", "m_2", "g"]
    assert not graded("|m_2-m_1|g", reference, BINDINGS[given], symbols=symbols).reward
    assert graded("-(m_1-m_2)g", reference, BINDINGS[given], symbols=symbols).reward


def test_a_magnitude_holds_where_it_is_one() -> None:
    """With m₂ > m₁ at all bindings the size of a force is |m₂ − m₁| g, but a component is not."""
    options = {"symbols": ["m_1", "m_2", "g"]}
    assert graded("|m_2-m_1|g", "(m_2-m_1)g", near(0.08), **options).reward
    assert not graded("|m_2-m_1|g", "(m_2-m_1)g", near(0.08), positive="up", **options).reward


@pytest.mark.parametrize("given", BINDINGS)
@pytest.mark.parametrize(
    ("answer", "reference"),
    [
        (r"\sqrt{1-\cos^2\theta}", r"\sin\theta"),
        (r"2\sin\frac{\theta}{2}\cos\frac{\theta}{2}", r"\sin\theta"),
        (r"\frac{m_2^2-m_1^2}{m_1+m_2}g", "(m_2-m_1)g"),
        (r"v\left(1-e^{-k}\right)", r"v-\frac{v}{e^k}"),
        (r"\frac{v(e^{k}-e^{-k})}{e^k+e^{-k}}", r"v\tanh k"),
        (r"g\tan\theta\cos\theta", r"g\sin\theta"),
        (r"\sqrt{2}\sqrt{g}\sqrt{h}", r"\sqrt{2gh}"),
    ],
)
def test_identities(answer: str, reference: str, given: str) -> None:
    symbols = sorted(OWN)
    assert graded(answer, reference, BINDINGS[given], symbols=symbols).reward


@pytest.mark.parametrize("answer", [r"\sqrt{2gh}(1-e^{-1000h})", r"\sqrt{2gh}\tanh(100g)", r"\sqrt{2gh}+10^{-9}h^{-3}"])
def test_without_numbers_symbols_are_small_as_well_as_large(answer: str) -> None:
    assert not graded(answer, r"\sqrt{2gh}", None).reward


def test_ranges_are_kept_to() -> None:
    ranges = {"x": (10.0, 20.0)}
    assert not graded("x+|x-5|+5", "2x", None).reward
    assert graded("x+|x-5|+5", "2x", None, ranges=ranges).reward
    assert not graded("x+|x-15|+15", "2x", None, ranges=ranges).reward


def test_a_side_before_the_formula_must_agree() -> None:
    assert graded(r"\sqrt{2gh} = (2gh)^{1/2}", r"\sqrt{2gh}", None).reward
    assert graded(r"\sqrt{2gh} \approx 1.414\sqrt{gh}", r"\sqrt{2gh}", None).reward, "what precedes ≈ is exact"
    assert not graded(r"1.414\sqrt{gh} \approx 1.41\sqrt{gh}", r"\sqrt{2gh}", None).reward
    assert not graded(r"\sqrt{gh} \approx \sqrt{2gh}", r"\sqrt{2gh}", None).reward
    assert not graded(r"\sqrt{gh} = \sqrt{2gh}", r"\sqrt{2gh}", None).reward


def test_a_direction_signs_a_bare_formula() -> None:
    for answer, paid in (
        ("mg", 0),
        (r"mg\text{ (down)}", 1),
        (r"-mg\text{ (down)}", 1),
        (r"mg\text{ upward}", 0),
        (r"mg\text{ left}", 0),
    ):
        assert graded(answer, "-mg", None, positive="up").reward == paid, answer


@pytest.mark.parametrize("before", ["", r"a = \frac{g\sqrt{h-2.8}}{\sqrt{h-2.8}} = ", r"a = g = "])
def test_behind_the_items_own_points_no_side_needs_a_value(before: str) -> None:
    answer = rf"{before}\frac{{g\sqrt{{h-2}}}}{{\sqrt{{h-2}}}}"
    own = [{"g": 9.8, "h": 3 + step / 100} for step in range(TEST_POINTS)]
    assert graded(answer, "g", own, symbols={"g", "h"}, ranges={"g": (5, 15), "h": (1, 5)}).reward
    assert not graded(f"a = 2g = {answer}", "g", own, symbols={"g", "h"}).reward
    outside = [{**point, "h": point["h"] - 2} for point in own]
    assert not graded(answer, "g", outside, symbols={"g", "h"}).reward


def test_angles_stay_within_their_quadrant() -> None:
    """A formula without bars passes if its value is positive for all θ between 90° and 180°."""
    bindings = [{"g": 9.8, "theta": 1.7 + 0.15 * count} for count in range(TEST_POINTS + 1)]
    assert graded(r"g\sin\theta", r"|g\sin\theta|", bindings, symbols=["g", "theta"]).reward
    assert not graded(r"g\cos\theta", r"|g\cos\theta|", bindings, symbols=["g", "theta"]).reward


@pytest.mark.parametrize(
    "answer", [r"v\cos\alpha\sqrt{2gh}", r"\cos\alpha v\sqrt{2gh}", r"v\cos\alpha\sqrt{2g}\sqrt{h}"]
)
def test_an_angle_ends_an_argument(answer: str) -> None:
    bindings = [{"g": 9.8, "h": 1.0 + 0.1 * count, "v": 2.0, "alpha": 0.5} for count in range(TEST_POINTS + 1)]
    assert graded(answer, r"v \sqrt{2\,g h} \cos\alpha", bindings, symbols=["g", "h", "v", "alpha"]).reward
