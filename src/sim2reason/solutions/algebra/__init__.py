"""Symbolic formulas: evaluation, LaTeX, simplification and the solution of equations."""
