"""How numbers are rounded, and written in LaTeX."""

DIGITS = 5  # significant ones that a worked solution carries


def shortened(value: float, digits: int = DIGITS) -> float:
    """A number rounded to so many significant digits."""
    return float(f"{value:.{digits - 1}e}")


def rounded(value: float, digits: int = DIGITS) -> str:
    """A number with so many significant digits, in LaTeX."""
    if value == 0.0:
        return "0"
    mantissa, _, power = f"{value:.{digits - 1}e}".partition("e")
    exponent = int(power)
    if -4 < exponent < 6:
        return f"{value:.{max(0, digits - 1 - exponent)}f}"
    return rf"{mantissa} \times 10^{{{exponent}}}"
