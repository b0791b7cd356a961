"""Reference solutions from equations of motion written for each mechanism, without any code of the library.

`follow` integrates by Gauss's collocation and finds events by Hénon's trick: other methods than those of either engine.
The other modules hold the equations of motion, derived from a Lagrangian or from Newton's law in coordinates of their
own, with the forces that hold the parts together.
"""
