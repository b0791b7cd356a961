"""A spring as a zigzag, alone or with a dashpot beside it."""

from collections.abc import Iterator

from sim2reason.figures.vectors import Polygon, unit
from sim2reason.scenes.dsl.mechanism import Elastic, Line

COIL, LOOPS, LEAD = 0.17, 0.26, 0.25  # half the width, how long a loop is, the straight part at each end
ASIDE = 0.22  # how far a spring and its dashpot lie from the line between them
CUP, PISTON, DEEP = 0.11, 0.08, 0.25  # half the widths of a dashpot's two parts, and half its length at most


def spring(a: complex, b: complex, line: Line | None) -> Iterator[Polygon]:
    """Yield the strokes of a spring from `a` to `b`."""
    if not (line is not None and isinstance(line.law, Elastic) and line.law.damping):
        yield _zigzag(a, b)
        return
    way = unit(b - a)
    out, lead = ASIDE * way * 1j, min(0.5 * LEAD, 0.08 * abs(b - a)) * way
    yield (a, a + lead)
    yield (b - lead, b)
    for end in (a + lead, b - lead):
        yield (end + out, end - out)
    yield _zigzag(a + lead + out, b - lead + out)
    yield from _dashpot(a + lead - out, b - lead - out)


def _dashpot(a: complex, b: complex) -> Iterator[Polygon]:
    """Yield a cup that is open towards `b`, and a piston in it."""
    way, long = unit(b - a), abs(b - a)
    across, middle, deep = way * 1j, 0.5 * (a + b), min(0.12 * long, DEEP) * way
    bottom, top, piston = middle - deep, middle + deep, middle + 0.2 * deep
    yield (a, bottom)
    yield tuple(at + side * CUP * across for at, side in ((top, 1.0), (bottom, 1.0), (bottom, -1.0), (top, -1.0)))
    yield (piston + PISTON * across, piston - PISTON * across)
    yield (piston, b)


def _zigzag(a: complex, b: complex) -> Polygon:
    way, long = unit(b - a), abs(b - a)
    lead = min(LEAD, 0.15 * long)
    count = max(4, min(14, round((long - 2.0 * lead) / LOOPS)))
    step = (long - 2.0 * lead) / count
    across = COIL * way * 1j
    zigzag = (a + way * (lead + (n + 0.5) * step) + across * (1.0 if n % 2 else -1.0) for n in range(count))
    return (a, a + lead * way, *zigzag, b - lead * way, b)
