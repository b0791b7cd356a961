"""Independent verification of worked solutions: the answer is recomputed from their stated data alone.

The data are JSON values, in which formulas are prefix trees, see `trees`. This package shares no code with the writers
of solutions or with the engines.
"""

from sim2reason.solutions.checking.recompute import Recomputed, recompute

__all__ = ["Recomputed", "recompute"]
