"""Motions with linear equations: springs along lines, harmonic oscillations and normal modes."""
