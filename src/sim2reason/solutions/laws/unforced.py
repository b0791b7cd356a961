"""Directions in which no force acts on a body, so that its velocity in them is constant."""

from collections.abc import Sequence

from sim2reason.solutions.laws.dynamics import Dynamics


def tell_unforced(dynamics: Dynamics, goals: Sequence[str]) -> None:
    """Write that no force acts in the directions of coordinates whose accelerations are among the goals."""
    step = dynamics.book.open("unforced")
    for k in sorted(dynamics.unforced - dynamics.frozen):
        if f"q{k}" in goals:
            coordinate = dynamics.mechanism.coordinates[k]
            who, way = dynamics.setting.called(coordinate.body), f"in the {coordinate.label} direction"
            step.say(f"No force acts on {who} {way}, so its velocity in this direction is constant.")
    step.close()
