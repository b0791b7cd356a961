"""Tables seen from above, with their walls and axes."""

from collections.abc import Iterator, Mapping, Sequence
from math import ceil

from sim2reason.figures.plane import RIGHT, UP, Box, Polygon, box, cross, dot, segment_distance, unit_vector
from sim2reason.figures.scaled.arrows import speeds
from sim2reason.figures.scaled.setting import DrawingContext, corners
from sim2reason.figures.shapes import SMALL, TINY, Area, LabelRequest, LineShape, Shape, Sketch, hatched_line, width
from sim2reason.scenes.dsl.body import Tabletop
from sim2reason.scenes.dsl.measures import show_unit


def sheet(setting: DrawingContext, area: Box) -> Polygon:
    """Return the outline of a tabletop that covers an area."""
    del setting
    left, low, right, high = area
    return (complex(left, low), complex(right, low), complex(right, high), complex(left, high))


def spread(setting: DrawingContext, margin: float = 2.1) -> Box:
    """Return the rectangle around all bodies, origins and field regions with a margin, cut off at a table's walls."""
    origins = [setting.view.at(setting.origin(owner)) for owner in setting.owners]
    borders = [setting.view.at(corner) for region, _ in setting.regions() for corner in corners(region)]
    left, low, right, high = box([*(setting.at(body.name) for body in setting.members), *origins, *borders])
    area = left - margin, low - margin, right + margin, high + margin
    return _within(area, cushions(setting)) if setting.view.level else area


def cushions(setting: DrawingContext) -> dict[complex, float]:
    """Return the offset n·r, in units, of each wall of a table seen from above, by the direction n towards the wall."""
    offsets: dict[complex, float] = {}
    for meeting in setting.mechanism.meetings:
        if meeting.a is None and meeting.normal is not None and setting.owns(meeting.b):
            direction = -unit_vector(setting.view.project_direction(meeting.normal))
            offsets[complex(round(direction.real), round(direction.imag))] = setting.radius(meeting.b) - (
                meeting.distance * setting.view.scale
            )
    return offsets


def _within(area: Box, bounds: Mapping[complex, float]) -> Box:
    left, low, right, high = area
    return -bounds.get(-1 + 0j, -left), -bounds.get(-1j, -low), bounds.get(1 + 0j, right), bounds.get(1j, high)


def bounding_walls(setting: DrawingContext, area: Box) -> list[Shape]:
    """Return the walls that bound a table of the given area, hatched on their far side."""
    shapes: list[Shape] = []
    for direction in cushions(setting):
        left, low, right, high = area
        middle = complex(0.5 * (left + right), 0.5 * (low + high))
        size = complex(0.5 * (right - left), 0.5 * (high - low))
        foot = middle + complex(direction.real * size.real, direction.imag * size.imag)
        half = direction * 1j * (abs(size.imag) if direction.real else abs(size.real))
        shapes += hatched_line(foot - half, foot + half)
    return shapes


TICK, PITCH = 0.08, 1.3  # length of a tick, least distance of two
TICK_MARGIN = 0.15  # units between a tick's number and the axis' end, and between a tick and an arrow
BELOW, LINED = 0.55, 1e-6  # units: x axis below bodies on a track; tolerance of a line
AXIS_LENGTH = 1.0  # length of an axis without numbers


def axes(setting: DrawingContext) -> Sketch:
    """Return the coordinate axes; an empty sketch if the text names no x or y."""
    sketch = Sketch()
    labels = {c.label: setting.view.project_direction(c.axis) for body in setting.members for c in body.coordinates}
    if not {"x", "y"} & labels.keys():
        if _placed(setting):
            _beside_track(setting, sketch)
        return sketch
    origin = setting.view.at(setting.origin(next(o for o in sorted(setting.owners) if "." not in o)))
    if _placed(setting):
        area = spread(setting)
        if any(isinstance(body.look, Tabletop) for body in setting.bodies.values()):
            sketch.shapes.append(Area(sheet(setting, area), "table", weight="thin"))
            sketch.shapes += bounding_walls(setting, area)
        _full(setting, sketch, area, origin)
        return sketch
    left, low, _, _ = box(setting.at(body.name) for body in setting.members)
    corner = complex(left - 2.9, min(low, origin.imag) + 0.3)
    for name in ("x", "y"):
        direction = labels.get(name)
        if direction is not None and abs(direction) > 0.5:
            sketch.shapes.append(LineShape((corner, corner + AXIS_LENGTH * direction), "thin", arrow=True))
            sketch.labels.append(
                LabelRequest(name, (corner + (AXIS_LENGTH + 0.25) * direction,), "", SMALL, name=False)
            )
    return sketch


def _beside_track(setting: DrawingContext, sketch: Sketch) -> None:
    """Draw an x axis below the bodies if all of them move along one straight track."""
    slides = [c for body in setting.members for c in body.coordinates if c.kind == "slide"]
    ways = {
        complex(round(w.real, 9), round(w.imag, 9))
        for c in slides
        if abs(w := setting.view.project_direction(c.axis)) > 0.5
    }
    if len(ways) != 1:
        return
    direction = unit_vector(ways.pop())
    down = (0.5 * setting.plan.sizes.height + BELOW) * (direction * -1j if direction.real > 0.0 else direction * 1j)
    owner = next(o for o in sorted(setting.owners) if "." not in o)
    origin = setting.view.at(setting.origin(owner)) + down
    ends = [((setting.at(body.name) + down - origin) / direction).real for body in setting.members]
    ends += [((end + down - origin) / direction).real for end in _walls(setting, direction)]
    start, stop = min([0.0, *ends]) - 0.4, max([0.0, *ends]) + 0.6
    scaled = not any(setting.plan.leaves_open(o, setting.mechanism.units.length) for o in setting.owners)
    sketch.shapes.append(LineShape((origin + start * direction, origin + stop * direction), "thin", arrow=True))
    text = f"x ({show_unit(setting.mechanism.units.length)})" if scaled else "x"
    position = origin + (stop + 0.15) * direction + 0.5 * width(text, SMALL) * RIGHT
    sketch.labels.append(LabelRequest(text, (position,), "", SMALL, name=False))
    if scaled:
        _ticks(setting, sketch, (origin, direction, start, stop), [], zero=True)


def _walls(setting: DrawingContext, direction: complex) -> Iterator[complex]:
    """Yield the points where walls cross the line through the bodies of a track."""
    for meeting in setting.mechanism.meetings:
        if meeting.a is None and meeting.normal is not None and setting.owns(meeting.b):
            normal = setting.view.project_direction(meeting.normal)
            if abs(cross(normal, direction)) < LINED:
                at = setting.at(meeting.b)
                yield at + (meeting.distance * setting.view.scale - dot(at, normal)) * normal


def _placed(setting: DrawingContext) -> bool:
    """Return whether the text states positions as coordinates."""
    names = {p.measure.name for p in setting.plan.scene.parameters if setting.owns(p.path)}
    return "position" in names


def _full(setting: DrawingContext, sketch: Sketch, area: Box, origin: complex) -> None:
    """Draw both axes through the origin, with numbers if the text gives all lengths."""
    scaled = not any(setting.plan.leaves_open(owner, setting.mechanism.units.length) for owner in setting.owners)
    left, low, right, high = area
    metre = show_unit(setting.mechanism.units.length)
    covered = [(setting.at(body.name), setting.radius(body.name) + 0.15) for body in setting.members]
    ends = (
        ("x", RIGHT, left - origin.real, right - origin.real),
        ("y", UP, low - origin.imag, high - origin.imag),
    )
    for name, direction, start, stop in ends:
        sketch.shapes.append(
            LineShape((origin + (start + 0.15) * direction, origin + (stop + 0.5) * direction), "thin", arrow=True)
        )
        text = f"{name} ({metre})" if scaled else name
        beyond = 0.12 + 0.5 * width(text, SMALL) if direction == RIGHT else 0.3
        position = origin + (stop + 0.5 + beyond) * direction
        sketch.labels.append(LabelRequest(text, (position,), "", SMALL, name=False))
        if scaled:
            _ticks(setting, sketch, (origin, direction, start, stop), covered)


def _ticks(
    setting: DrawingContext,
    sketch: Sketch,
    axis: tuple[complex, complex, float, float],
    covered: list[tuple[complex, float]],
    *,
    zero: bool = False,
) -> None:
    """Draw ticks with numbers at round distances, except under bodies and arrows and near the ends of the axis.

    The origin gets a tick only on request, because two axes cross there.
    """
    origin, direction, start, stop = axis
    scale = setting.view.scale
    arrows = [
        shape.points for shape in speeds(setting, headings=False).shapes if isinstance(shape, LineShape) and shape.arrow
    ]
    step = next(m * 10.0**k for k in range(-6, 7) for m in (1.0, 2.0, 5.0) if m * 10.0**k * scale >= PITCH)
    for number in range(ceil(start / (scale * step)), int(stop / (scale * step)) + 1):
        at, across = origin + number * step * scale * direction, direction * 1j
        if (not number and not zero) or any(abs(at - spot) < reach for spot, reach in covered):
            continue
        text = f"{number * step:g}".replace("-", "\N{MINUS SIGN}")
        half = 0.5 * (width(text, TINY) if abs(direction.real) > abs(direction.imag) else TINY) + TICK_MARGIN
        if not start + half < number * step * scale < stop - half or any(_is_near(at, arrow) for arrow in arrows):
            continue
        sketch.shapes.append(LineShape((at - TICK * across, at + TICK * across), "thin"))
        level = abs(direction.real) > abs(direction.imag)
        aside = 0.3 if level else 0.17 + 0.5 * width(text, TINY)
        sides = (-1.0, 1.0) if level else (1.0, -1.0)
        sketch.labels.append(
            LabelRequest(text, tuple(at + side * aside * across for side in sides), "", TINY, name=False)
        )


def _is_near(at: complex, arrow: Sequence[complex]) -> bool:
    """Return whether a tick would touch a straight arrow."""
    return segment_distance(at, arrow[0], arrow[-1]) < TICK_MARGIN + TICK
