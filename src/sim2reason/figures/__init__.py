"""Figures: a line drawing of a scene's initial state, and plots of its motion.

`drawing` makes shapes out of a scene, without matplotlib; `canvas` alone turns shapes into a file, and
`plot` a motion. A drawing is a schematic: angles are right, lengths and sizes are not.
"""
