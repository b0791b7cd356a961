"""A small body that swings about a fixed point: its pivot, length, initial angle and speed."""

from math import acos, hypot

from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import Inextensible, Mechanism, Rigid
from sim2reason.scenes.dsl.vectors import minus


def pivot(m: Mechanism) -> tuple[str, str | None, tuple[float, float, float]] | None:
    """Return the swinging body, the line that holds it (None: a hinge), and the pivot; None if there is none."""
    heavy = [body for body in m.bodies if body.mass]
    if len(heavy) != 1 or any(heavy[0].inertia) or m.faces or m.forces or m.attractions or m.burns or m.feet:
        return None
    frames, body = initial_frames(m), heavy[0]
    if len(m.coordinates) == 1 and m.coordinates[0].kind == "hinge" and not m.lines:
        carrier = m.body[m.coordinates[0].body]
        level = abs(m.coordinates[0].axis[2]) < 1e-9
        return (body.name, None, frames[carrier.name].origin) if carrier.parent is None and level else None
    line = m.lines[0] if len(m.lines) == 1 else None
    if line is None or len(line.through) != 2 or not isinstance(line.law, Inextensible | Rigid):
        return None
    fixed = [m.site[site] for site in line.through if m.site[site].body is None]
    flat = {c.axis for c in m.coordinates} == {(1.0, 0.0, 0.0), (0.0, 0.0, 1.0)} and len(m.coordinates) == 2
    loose = getattr(line.law, "slack", 0.0) or getattr(line.law, "reel", 0.0)
    return (body.name, line.name, fixed[0].at) if len(fixed) == 1 and flat and not loose else None


def place(m: Mechanism) -> tuple[float, float, float]:
    """Return the vector, m, from the pivot to the body at the start."""
    found = pivot(m)
    assert found is not None, "who asks has seen that it swings"
    body, _, point = found
    x, y, z = minus(initial_frames(m).center(body).place, point)
    return float(x), float(y), float(z)


def geometry(m: Mechanism) -> tuple[float, float, float]:
    """Return the length, m, the initial angle with the downward vertical, rad, and the initial speed, m/s."""
    apart = place(m)
    length = hypot(*apart)
    if len(m.coordinates) == 1:
        speed = abs(m.coordinates[0].speed) * length
    else:
        speed = hypot(*(coordinate.speed for coordinate in m.coordinates))
    return length, acos(max(-1.0, min(1.0, -apart[2] / length))), speed
