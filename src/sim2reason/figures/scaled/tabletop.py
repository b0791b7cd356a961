"""Outline and bounding walls of a table seen from above."""

from collections.abc import Mapping

from sim2reason.figures.scaled.setting import Setting, corners
from sim2reason.figures.shapes import Shape, hatched
from sim2reason.figures.vectors import Box, Polygon, box, unit


def sheet(setting: Setting, area: Box) -> Polygon:
    """Return the outline of a tabletop that covers an area."""
    del setting
    left, low, right, high = area
    return (complex(left, low), complex(right, low), complex(right, high), complex(left, high))


def spread(setting: Setting, margin: float = 2.1) -> Box:
    """Return the rectangle around all bodies, origins and field regions with a margin, cut off at a table's walls."""
    origins = [setting.view.at(setting.origin(owner)) for owner in setting.owners]
    borders = [setting.view.at(place) for region, _ in setting.regions() for place in corners(region)]
    left, low, right, high = box([*(setting.at(body.name) for body in setting.members), *origins, *borders])
    area = left - margin, low - margin, right + margin, high + margin
    return _within(area, cushions(setting)) if setting.view.level else area


def cushions(setting: Setting) -> dict[complex, float]:
    """Return the offset n·r of each wall of a table on the page, by the direction n from the table to the wall."""
    found: dict[complex, float] = {}
    for meeting in setting.mechanism.meetings:
        if meeting.a is None and meeting.normal is not None and setting.owns(meeting.b):
            way = -unit(setting.view.way(meeting.normal))
            found[complex(round(way.real), round(way.imag))] = setting.radius(meeting.b) - (
                meeting.distance * setting.view.scale
            )
    return found


def _within(area: Box, bounds: Mapping[complex, float]) -> Box:
    left, low, right, high = area
    return -bounds.get(-1 + 0j, -left), -bounds.get(-1j, -low), bounds.get(1 + 0j, right), bounds.get(1j, high)


def bounding_walls(setting: Setting, area: Box) -> list[Shape]:
    """Return the walls that bound a table of the given area, hatched on their far side."""
    found: list[Shape] = []
    for way in cushions(setting):
        left, low, right, high = area
        middle = complex(0.5 * (left + right), 0.5 * (low + high))
        size = complex(0.5 * (right - left), 0.5 * (high - low))
        foot = middle + complex(way.real * size.real, way.imag * size.imag)
        half = way * 1j * (abs(size.imag) if way.real else abs(size.real))
        found += hatched(foot - half, foot + half)
    return found
