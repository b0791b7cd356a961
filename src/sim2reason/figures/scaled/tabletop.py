"""A table from above: how far it reaches, and the walls that bound it."""

from collections.abc import Mapping

from sim2reason.figures.scaled.setting import Setting, corners
from sim2reason.figures.shapes import Shape, hatched
from sim2reason.figures.vectors import Box, Polygon, box, unit


def sheet(setting: Setting, area: Box) -> Polygon:
    """The outline of a tabletop."""
    del setting
    left, low, right, high = area
    return (complex(left, low), complex(right, low), complex(right, high), complex(left, high))


def spread(setting: Setting, margin: float = 2.1) -> Box:
    """The smallest rectangle around all bodies and the origin, with a margin."""
    origins = [setting.view.at(setting.origin(owner)) for owner in setting.owners]
    borders = [setting.view.at(place) for region, _ in setting.regions() for place in corners(region)]
    left, low, right, high = box([*(setting.at(body.name) for body in setting.members), *origins, *borders])
    area = left - margin, low - margin, right + margin, high + margin
    return _within(area, cushions(setting)) if setting.view.level else area


def cushions(setting: Setting) -> dict[complex, float]:
    """Where walls bound a table, by the directions of the page that lead there, as n·r of their points."""
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
    """The walls of a table that reaches so far, hatched on their far side."""
    found: list[Shape] = []
    for way in cushions(setting):
        left, low, right, high = area
        middle = complex(0.5 * (left + right), 0.5 * (low + high))
        size = complex(0.5 * (right - left), 0.5 * (high - low))
        foot = middle + complex(way.real * size.real, way.imag * size.imag)
        half = way * 1j * (abs(size.imag) if way.real else abs(size.real))
        found += hatched(foot - half, foot + half)
    return found
