"""The relative tolerance of answers."""

TOLERANCE = 0.05
"""The relative error that an answer may have, by default: that of the paper."""
STRICTEST = 0.005
"""The smallest one that is of use: answers are asked for to three digits."""
NEARLY = 1.2  # of the tolerance: larger errors are clearly incorrect


def out_of_range(tolerance: float) -> str:
    """Return why a relative tolerance is invalid; empty if it is valid."""
    if STRICTEST <= tolerance <= TOLERANCE:
        return ""
    return f"{tolerance!r} is none; give a number from {STRICTEST} to {TOLERANCE}"
