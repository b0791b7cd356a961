"""Motions whose equations are linear: springs along lines, harmonic oscillations and normal modes."""
