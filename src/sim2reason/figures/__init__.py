"""Figures: a line drawing of a scene's initial state, and plots of its motion.

`drawing` converts a scene to shapes; `canvas` writes shapes to files with matplotlib, and `plot` draws motions and
histograms. Machines of strings and planes are arranged: angles are correct, lengths and sizes are not. Everything else
is drawn to scale by `scaled`, except bodies whose size does not matter.
"""
