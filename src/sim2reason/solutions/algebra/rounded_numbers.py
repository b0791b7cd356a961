"""LaTeX of numbers: rounded to significant digits, with all digits, or as simple fractions."""

import re
from fractions import Fraction
from functools import lru_cache

GUARD_DIGITS = 7  # significant digits of numbers whose differences are formed
DIGITS = 5  # significant digits of numbers in a worked solution
MAX_SIMPLE_DENOMINATOR = 60  # largest denominator of a number that is written as a fraction
MAX_PLAIN_NUMBER = 1e9  # larger numbers are written with a power of ten
SIMPLE_FRACTION_RTOL = 1e-12  # relative: rounding error allowed in the comparison of a number with a simple fraction


def round_to_digits(value: float, digits: int = DIGITS) -> float:
    """Round a number to a number of significant digits."""
    return float(f"{value:.{digits - 1}e}")


def rounded_latex(value: float, digits: int = DIGITS) -> str:
    """Return the LaTeX of a number rounded to significant digits, with a power of ten in place of padding zeros."""
    if value == 0.0:
        return "0"
    mantissa, _, power = f"{value:.{digits - 1}e}".partition("e")
    exponent = int(power)
    if -4 < exponent < digits:
        return f"{value:.{digits - 1 - exponent}f}"
    return rf"{mantissa} \times 10^{{{exponent}}}"


def full_latex(value: float) -> str:
    """Write a number with all its digits in LaTeX, with a power of ten where Python uses an exponent."""
    mantissa, _, power = repr(value).partition("e")
    return rf"{mantissa} \times 10^{{{int(power)}}}" if power else mantissa


def with_guard_digits(value: float) -> str:
    """Write a number with guard digits, for equations to be subtracted from each other, without trailing zeros."""
    text = rounded_latex(value, GUARD_DIGITS)
    return text if "times" in text or "." not in text else re.sub(r"(\.\d+?)0+$", r"\1", text)


def simple_fraction(x: float) -> Fraction | None:
    """Return the fraction equal to a number; None if its denominator is not small."""
    fraction = Fraction(x).limit_denominator(MAX_SIMPLE_DENOMINATOR)
    if (x and not fraction) or abs(fraction) > MAX_PLAIN_NUMBER:
        return None
    return fraction if abs(float(fraction) - x) <= SIMPLE_FRACTION_RTOL * max(1.0, abs(x)) else None


@lru_cache(maxsize=4096)
def pure_number(x: float) -> str:
    """Return the LaTeX of a dimensionless number: a simple fraction where possible, else decimals."""
    fraction = simple_fraction(x)
    if fraction is None:
        return rounded_latex(x)
    if fraction.denominator == 1:
        return str(fraction.numerator)
    sign = "-" if fraction < 0 else ""
    return rf"{sign}\tfrac{{{abs(fraction.numerator)}}}{{{fraction.denominator}}}"
