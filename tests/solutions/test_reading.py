"""What a text alone says of its last line."""

from sim2reason.solutions.reading import read

KNOWN = {"m": 2.0, "u": 1.5, "v": 4.0}


def ending(formula: str) -> str:
    return r"The impulse is $J = m \left(v - u\right)$." + "\n\n" + rf"Answer: $J = \boxed{{{formula}}}$."


def test_a_magnitude_of_a_sum_is_read() -> None:
    told = read(ending(r"\left|m u - m v\right|"), KNOWN)
    assert not told.unread
    assert not told.broken
    assert read(ending(r"\left|m u + m v\right|"), KNOWN).broken


def test_roots_within_fractions_within_roots_are_read() -> None:
    """J = m (v − u) = √(√(m⁴ (v − u)⁴)), however deep."""
    deep = r"\sqrt{\frac{\sqrt{m^{4} \left(v %s u\right)^{\frac{8}{2}}}}{1}}"
    right, wrong = (read(ending(deep % sign), KNOWN) for sign in "-+")
    assert not right.unread
    assert not right.broken
    assert wrong.broken


def test_a_last_line_that_can_not_be_read_is_told() -> None:
    assert read(ending(r"\left|m u - m v"), KNOWN).unread
