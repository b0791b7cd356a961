"""Tests of regions and force fields in drawings to scale."""

from math import pi

import pytest

from figure_parts import scene_of
from sim2reason.figures.drawing import drawing
from sim2reason.figures.plane import cross, degrees
from sim2reason.figures.shapes import Arc, Area, Drawing, LineShape
from sim2reason.scenes.dsl.body import Body, Small
from sim2reason.scenes.dsl.builder import Frame
from sim2reason.scenes.dsl.entity import Entity
from sim2reason.scenes.dsl.fields import Law, Magnetic, Profile, Push, Resistance
from sim2reason.scenes.dsl.mechanism import X, Y, Z
from sim2reason.scenes.dsl.vectors import BoxRegion, DiscRegion, HalfSpace, Region

FIELDS: list[tuple[Law, Region | None]] = []


class Bead(Body):
    """Bead with a positive charge."""

    nouns = ("bead",)
    lone = ("a {noun}", "one {noun}")
    named = ("{noun} {letter}", "a {noun} {letter}")

    @property
    def look(self) -> Small:
        """Return a ball with its sign."""
        return Small("ball", "+")


class InField(Entity):
    """Entity whose bead moves in a horizontal plane."""

    bead: Bead

    says = ("{bead} moves.",)

    def build(self, room: Frame) -> None:
        """Build the bead under the forces of the test."""
        bead = room.body("bead", 1.0).slide(X, 2.0, name="x").slide(Y, 0.0, name="y")
        for number, (law, region) in enumerate(FIELDS):
            bead.force(f"force{number}", law, region)


def drawn(monkeypatch: pytest.MonkeyPatch, *fields: tuple[Law, Region | None]) -> Drawing:
    monkeypatch.setitem(globals(), "FIELDS", list(fields))
    return drawing(scene_of(it=InField(bead=Bead())))


def marks(found: Drawing) -> tuple[int, int, list[float]]:
    """Return the numbers of dots and crosses, and the directions of the arrows."""
    dots = [s for s in found.shapes if isinstance(s, Arc) and s.weight == "hair" and not s.fill]
    strokes = [s for s in found.shapes if isinstance(s, LineShape) and s.weight == "hair"]
    arrows = [degrees(s.points[1] - s.points[0]) for s in strokes if s.arrow]
    return len(dots), sum(not s.arrow for s in strokes) // 2, arrows


def test_a_magnetic_field_out_of_the_page_is_dots_and_into_it_crosses(monkeypatch: pytest.MonkeyPatch) -> None:
    region = DiscRegion((1.5, 0.0, 0.0), 0.8)
    dots, crosses, arrows = marks(drawn(monkeypatch, (Magnetic(Z, Profile(2.0)), region)))
    assert dots > 3
    assert (crosses, arrows) == (0, [])
    dots, crosses, arrows = marks(drawn(monkeypatch, (Magnetic(Z, Profile(-2.0)), region)))
    assert crosses > 3
    assert (dots, arrows) == (0, [])


def test_an_electric_field_is_arrows_along_it_and_both_are_lettered(monkeypatch: pytest.MonkeyPatch) -> None:
    found = drawn(monkeypatch, (Push((0.6, 0.8, 0.0), Profile(1.0)), None), (Magnetic(Z, Profile(1.0)), None))
    dots, _, arrows = marks(found)
    assert dots == pytest.approx(len(arrows), abs=6)
    assert arrows == pytest.approx([53.13010235415598] * len(arrows))
    assert {"E field", "B field"} <= {label.text for label in found.labels}


def test_a_drag_has_no_direction_to_be_drawn(monkeypatch: pytest.MonkeyPatch) -> None:
    assert marks(drawn(monkeypatch, (Resistance(linear=0.1), None))) == (0, 0, [])


@pytest.mark.parametrize(
    ("region", "size"),
    [
        (DiscRegion((1.5, 0.5, 0.0), 0.8), pi * 0.64),
        (BoxRegion(((X, 0.5, 1.5), (Y, -0.5, 0.7))), 1.2),
    ],
)
def test_a_bounded_region_is_shaded_to_scale(monkeypatch: pytest.MonkeyPatch, region: Region, size: float) -> None:
    found = drawn(monkeypatch, (Magnetic(Z, Profile(1.0)), region))
    shaded = next(s for s in found.shapes if isinstance(s, Area) and s.fill == "field")
    corners = shaded.points
    area = 0.5 * sum(cross(a, b) for a, b in zip(corners, (*corners[1:], corners[0]), strict=True))
    across = max(p.real for p in corners) - min(p.real for p in corners)
    width = 1.6 if isinstance(region, DiscRegion) else 1.0
    assert abs(area) * (width / across) ** 2 == pytest.approx(size, rel=0.01)


@pytest.mark.parametrize("region", [HalfSpace(X, 0.6), BoxRegion(((X, 0.6, 1.5),))])
def test_a_region_without_end_is_cut_at_its_border(monkeypatch: pytest.MonkeyPatch, region: Region) -> None:
    found = drawn(monkeypatch, (Magnetic(Z, Profile(1.0)), region))
    shaded = next(s for s in found.shapes if isinstance(s, Area) and s.fill == "field")
    bead = next(s for s in found.shapes if isinstance(s, Arc) and s.fill == "ball")
    assert min(p.real for p in shaded.points) > bead.center.real + bead.radius
    assert marks(found)[0] >= 3
