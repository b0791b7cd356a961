"""Figures: a line drawing of a scene's initial state, and plots of its motion.

`drawing` makes shapes out of a scene, without matplotlib; `canvas` alone turns shapes into a file, `plot` a motion, and
`histogram` counts. Machines of strings and planes are arranged: their angles are right, lengths and sizes are not.
Everything else is drawn to scale, by `scaled`, but for bodies whose size does not matter.
"""
