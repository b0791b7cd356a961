"""How near an answer must come to the right one."""

TOLERANCE = 0.05
"""The relative error that an answer may have, by default: that of the paper."""
STRICTEST = 0.005
"""The smallest one that is of use: answers are asked for to three digits."""
NEARLY = 1.2  # of the tolerance: an answer that is off by less may be paid, or nearly


def out_of_range(tolerance: float) -> str:
    """Return why no answer may have a relative error; empty if it may."""
    if STRICTEST <= tolerance <= TOLERANCE:
        return ""
    return f"{tolerance!r} is none; give a number from {STRICTEST} to {TOLERANCE}"
