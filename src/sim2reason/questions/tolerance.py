"""How near an answer must come to the right one."""

TOLERANCE = 0.05
"""The relative error that an answer may have, by default: that of the paper."""
NEARLY = 1.2  # of the tolerance: an answer that is off by less may be paid, or nearly
