"""Pucks on a table, seen from above, with their axes and velocities."""

from math import ceil

from sim2reason.bodies.puck import Puck, Table
from sim2reason.dsl.measures import Angle
from sim2reason.figures.hanging import said
from sim2reason.figures.pieces import DrawingPlan, around
from sim2reason.figures.shapes import SIZE, SMALL, TINY, Arc, Area, Line, Sketch, Wanted, width
from sim2reason.figures.vectors import UP, box, rectangle

SPAN = 7.0  # units across the larger side
LONGEST = 1.7  # arrow
SMALLEST = 0.3  # radius of a drawn puck
TICK, PITCH = 0.08, 1.3  # length of a tick, least distance of two
STILL = 1e-3  # of the fastest


def table(plan: DrawingPlan, address: str) -> Sketch:
    """The table at an address with all pucks of its entity; places are to scale, as are arrows among each other."""
    owner = address.rpartition(".")[0]
    bodies = plan.scene.bodies
    pucks = {a: b for a, b in bodies.items() if isinstance(b, Puck) and a.startswith(f"{owner}.")}
    radius = float(getattr(plan.scene.value(owner), "radius", 0.1))
    spots = {name: complex(puck.x, puck.y) for name, puck in pucks.items()}
    left, low, right, high = box([*spots.values(), 0j])
    scale = SPAN / max(right - left, high - low, 4.0 * radius)
    found = Sketch()
    edge = max(LONGEST, scale * radius) + 0.4
    middle = 0.5 * scale * complex(left + right, low + high)
    wide, tall = scale * (right - left) + 2.0 * edge, scale * (high - low) + 2.0 * edge
    found.shapes.append(Area(rectangle(middle, wide, tall), "table"))
    corner = middle - 0.5 * complex(wide, tall)
    _axes(found, corner, corner + complex(wide, tall), address)
    covered = [(scale * spot, max(SMALLEST, scale * radius) + 0.15) for spot in spots.values()]
    _ticks(found, corner, corner + complex(wide, tall), scale, covered)
    fastest = max((abs(complex(puck.vx, puck.vy)) for puck in pucks.values()), default=0.0)
    for name, puck in pucks.items():
        _puck(
            found,
            plan,
            name,
            scale * spots[name],
            max(SMALLEST, scale * radius),
            complex(puck.vx, puck.vy) / (fastest or 1.0),
        )
    body = bodies[address]
    if isinstance(body, Table) and body.tilt:
        text = f"tilted at {said(Angle, body.tilt)}; y points up the slope"
        below = corner + complex(0.5 * wide, -0.4)
        found.labels.append(Wanted(text, (below,), address, SMALL, name=False))
    return found


def _axes(found: Sketch, low: complex, high: complex, subject: str) -> None:
    """The x and y axes through the origin."""
    for name, start, end, beyond in (
        ("x", complex(low.real + 0.15, 0.0), complex(high.real + 0.5, 0.0), 0.55 + 0j),
        ("y", complex(0.0, low.imag + 0.15), complex(0.0, high.imag + 0.5), 0.3j),
    ):
        found.shapes.append(Line((start, end), "thin", arrow=True))
        found.labels.append(Wanted(f"{name} (m)", (end + beyond,), subject, SMALL, name=False))


def _ticks(found: Sketch, low: complex, high: complex, scale: float, covered: list[tuple[complex, float]]) -> None:
    """Ticks with numbers, at round distances, wherever no puck covers the axis."""
    step = next(m * 10.0**k for k in range(-6, 7) for m in (1.0, 2.0, 5.0) if m * 10.0**k * scale >= PITCH)
    for way, start, end in ((1.0 + 0j, low.real, high.real), (UP, low.imag, high.imag)):
        for number in range(ceil((start + 0.2) / (scale * step)), int((end - 0.2) / (scale * step)) + 1):
            at, across = number * step * scale * way, way * 1j
            if not number or any(abs(at - spot) < reach for spot, reach in covered):
                continue
            found.shapes.append(Line((at - TICK * across, at + TICK * across), "thin"))
            sides = (-1.0, 1.0) if way.real else (1.0, -1.0)
            text = f"{number * step:g}".replace("-", "\N{MINUS SIGN}")
            aside = 0.3 if way.real else 0.17 + 0.5 * width(text, TINY)
            found.labels.append(Wanted(text, tuple(at + side * aside * across for side in sides), "", TINY, name=False))


def _puck(found: Sketch, plan: DrawingPlan, name: str, at: complex, radius: float, velocity: complex) -> None:
    """A disc with its letter, and its velocity as an arrow from its rim on."""
    found.shapes.append(Arc(at, radius, fill="block"))
    if abs(velocity) > STILL:
        way = velocity / abs(velocity)
        start = at + radius * way
        found.shapes.append(Line((start, start + LONGEST * velocity), "string", arrow=True))
    letter, mass = plan.name(name), plan.mass(name)
    back = -velocity / abs(velocity) if abs(velocity) > STILL else UP
    for text, size in ((letter, SIZE), (mass, SMALL)):
        wide = width(text, size)
        inside = text == letter and wide < 1.7 * radius
        places = (at,) if inside else around(at, radius + 0.1, wide, start=back)
        if text:
            found.labels.append(Wanted(text, places, name, size, name=text == letter))
