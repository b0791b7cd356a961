"""Formulas that know their values: how they are written, rewritten, and solved as equations."""
