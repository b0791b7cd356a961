"""An independent check of worked solutions: the answer recomputed from their data, and nothing left unstated.

The data are JSON values, in which formulas are prefix trees, see `trees`. Nothing here shares code with what writes
solutions, nor with the engines.
"""

from sim2reason.solutions.checking.recompute import Recomputed, recompute

__all__ = ["Recomputed", "recompute"]
