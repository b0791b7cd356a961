import xml.etree.ElementTree as ET
from collections import Counter
from itertools import combinations
from pathlib import Path
from typing import NamedTuple

import pytest

from sim2reason.errors import FigureWarning, MissingExtraError, UnsupportedError
from sim2reason.figures.canvas import draw
from sim2reason.figures.drawing import drawing
from sim2reason.figures.hanging import PulleyPiece
from sim2reason.figures.layout import Arranger, Layout
from sim2reason.figures.plane import depth, dot, overlap_area, unit_vector
from sim2reason.figures.shapes import Area, Drawing
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.simple_machines import FixedPulley, Plane, Prism, Wedge
from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.builder import Frame
from sim2reason.scenes.dsl.connection import CONNECTIONS, Link
from sim2reason.scenes.dsl.entity import Entity, Named
from sim2reason.scenes.dsl.mechanism import ConstantTension, X, Z
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pulleys import MassWithFixedPulley
from sim2reason.scenes.entities.slopes import MassPrismPlane, TwoSideMassPlane
from sim2reason.scenes.entities.string_ends import Hanging, OnPlane
from sim2reason.text.prose.description import describe

SVG = "{http://www.w3.org/2000/svg}"


class Drawn(NamedTuple):
    scene: Scene
    drawing: Drawing
    layouts: list[Layout]


@pytest.fixture(scope="module")
def drawings(scenes: list[Scene]) -> list[Drawn]:
    """Draw all scenes once, recording the intermediate layouts."""
    found: list[Layout] = []
    original = Arranger.best

    def best(self: Arranger) -> Layout:
        found.append(original(self))
        return found[-1]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Arranger, "best", best)
        drawn = [(scene, drawing(scene), len(found)) for scene in scenes]
    ends = [end for _, _, end in drawn]
    return [Drawn(s, d, found[a:b]) for (s, d, _), a, b in zip(drawn, [0, *ends], ends, strict=False)]


@pytest.fixture(scope="module")
def layouts(drawings: list[Drawn]) -> list[Layout]:
    return [layout for drawn in drawings for layout in drawn.layouts]


def named(scene: Scene) -> dict[str, str]:
    names = describe(scene).names
    return {a: names.letters.get(a, "") or names.noun(b) for a, b in scene.bodies.items() if b.letters}


def test_every_body_of_the_text_is_labelled_as_the_text_names_it(drawings: list[Drawn]) -> None:
    for scene, drawn, _ in drawings:
        assert {label.subject: label.text for label in drawn.labels if label.name} == named(scene)
        for address, text in named(scene).items():
            assert text in describe(scene).mention(address)


def test_angles_and_forces_stand_in_the_drawing(drawings: list[Drawn]) -> None:
    for scene, drawn, _ in drawings:
        wanted: list[str] = []
        for body in scene.bodies.values():
            match body:
                case Plane(angle=angle) | Wedge(angle=angle):
                    wanted += [f"{angle:g}°"] if angle else []
                case Prism(left=left, right=right):
                    wanted += [f"{left:g}°", f"{right:g}°"]
                case _:
                    pass
        shown = [label.text for label in drawn.labels if label.text.endswith("°")]
        assert not Counter(wanted) - Counter(shown)
        assert set(shown) <= {p.measure.say(p.value) for p in scene.parameters if p.value and p.measure.unit == "deg"}
        for pull in scene.mechanism.pulls:
            assert any(
                label.text.endswith(" N") and ConstantTension(float(label.text.removeprefix("F = ")[:-2])) == pull.law
                for label in drawn.labels
            )


def test_labels_keep_clear_of_each_other(drawings: list[Drawn]) -> None:
    bad = 0
    for _, drawn, _ in drawings:
        for one, other in combinations(drawn.labels, 2):
            smaller = min((box[2] - box[0]) * (box[3] - box[1]) for box in (one.box, other.box))
            bad += overlap_area(one.box, other.box) > 0.02 * smaller
    assert bad == 0


def test_pieces_keep_clear_of_each_other(layouts: list[Layout]) -> None:
    touching = 0
    for layout in layouts:
        solids = [
            [tuple(p + layout.at[name] for p in polygon) for polygon in piece.hulls()]
            for name, piece in layout.pieces.items()
        ]
        touching += any(depth(p, q) > 0.01 for a, b in combinations(solids, 2) for p in a for q in b)
    assert touching == 0


def test_strings_leave_pulleys_along_tangents(drawings: list[Drawn], layouts: list[Layout]) -> None:
    seen = 0
    for layout in layouts:
        for strand, a, b in layout.strands:
            assert abs(b - a) > 0.1
            way = unit_vector(b - a)
            for knot, end in ((strand.a, a), (strand.b, b)):
                piece = layout.pieces[knot.piece]
                if knot.rim and isinstance(piece, PulleyPiece):
                    spoke = end - layout.at[knot.piece]
                    assert abs(spoke) == pytest.approx(piece.radius)
                    assert dot(spoke, way) == pytest.approx(0.0, abs=1e-9)
                    seen += 1
    assert seen > len(drawings)


def test_strings_run_as_the_mechanism_has_them_or_mirrored(layouts: list[Layout]) -> None:
    for layout in layouts:
        for strand, a, b in layout.strands:
            if strand.direction is not None:
                way = unit_vector(b - a)
                assert way.imag == pytest.approx(strand.direction.imag, abs=1e-9)
                assert abs(way.real) == pytest.approx(abs(strand.direction.real), abs=1e-9)


def test_labels_are_text_inside_the_canvas(drawings: list[Drawn], tmp_path: Path) -> None:
    plain = [held for held in drawings if not any("$" in label.text for label in held.drawing.labels)]
    assert len(plain) > 5  # labels with formulas are drawn as paths
    for number, (scene, drawn, _) in enumerate(plain[::5]):
        path = tmp_path / f"{number}.svg"
        draw(drawn, path)
        root = ET.parse(path).getroot()
        width, height = (float(size) for size in root.attrib["viewBox"].split()[2:])
        texts = list(root.iter(f"{SVG}text"))
        words = " ".join(t.text or "" for t in texts).split()
        assert sorted(words) == sorted(" ".join(label.text for label in drawn.labels).split())
        assert set(named(scene).values()) <= {t.text for t in texts}
        scale = width / (drawn.box()[2] - drawn.box()[0] + 0.7)
        for text in texts:
            x, y = float(text.attrib["x"]), float(text.attrib["y"])
            label = next((label for label in drawn.labels if label.text == text.text), None)
            if label is None:  # a part of one, a letter or a number
                continue
            half = 0.5 * scale * (label.box[2] - label.box[0])
            assert 0.0 <= x - half <= x + half <= width
            assert 0.0 <= y <= height


@pytest.mark.parametrize("ending", ["svg", "png", "pdf"])
def test_the_same_bytes_twice(scenes: list[Scene], tmp_path: Path, ending: str) -> None:
    paths = [tmp_path / f"{n}.{ending}" for n in range(2)]
    for path in paths:
        draw(drawing(scenes[-3], numbers=True), path)
    assert paths[0].read_bytes() == paths[1].read_bytes()
    assert len(paths[0].read_bytes()) > 1000


def test_numbers_are_masses_as_the_text_has_them(scenes: list[Scene]) -> None:
    for scene in scenes[::6]:
        shown = " ".join(label.text for label in drawing(scene, numbers=True).labels)
        for parameter in scene.parameters:
            if parameter.path.endswith("mass") and parameter.value:
                assert parameter.measure.say(parameter.value) in shown


def test_of_an_answer_no_drawing_shows_all_digits() -> None:
    """Numbers that a result has determined have many digits, which a drawing rounds."""
    plane, block = Plane(angle=27.02527720163310, friction=0.2), Block(mass=1.091525566828)
    scene = Scene(entities=(Named(name="ramp", entity=TwoSideMassPlane(plane=plane, blocks=(block,))),))
    shown = {label.text for label in drawing(scene, numbers=True).labels}
    assert "27.025°" in shown
    assert any("1.0915 kg" in text for text in shown)


def test_glue_does_not_show(scenes: list[Scene]) -> None:
    scene = next(s for s in scenes if any(isinstance(b, Wedge) for b in s.bodies.values()))
    wedge = next(a for a, b in scene.bodies.items() if isinstance(b, Wedge))
    assert drawing(scene.gluing(wedge), describe(scene)).shapes == drawing(scene).shapes


class PairRestitution(Entity):
    block: Block
    wedge: Wedge

    says = ("{block} lies on {wedge}, and friction has the coefficient {wedge.friction}.",)

    def build(self, room: Frame) -> None:
        wedge = room.body("wedge", self.wedge.mass).rest(along=X, normal=Z)
        wedge.site("pulley", at=(0.8, 0.0, 0.6))
        wedge.body("block", self.block.mass).rest(along=(0.8, 0.0, 0.6), normal=(-0.6, 0.0, 0.8)).site("hook")
        room.site("nail", at=(3.0, 0.0, 0.6))
        room.string("cord", "pair.hook", "pair.pulley", "pair.nail")


def test_an_entity_of_known_bodies_needs_no_code_here() -> None:
    pair = PairRestitution(block=Block(mass=1.0), wedge=Wedge(mass=2.0, angle=37.0, friction=0.1))
    drawn = drawing(Scene(entities=(Named(name="pair", entity=pair),)))
    assert {"block", "wedge"} <= {label.text for label in drawn.labels}


@pytest.mark.parametrize("angle", [1e-12, 1e-9, 1e-8, 1e-5, 89.9999, 89.9999999, 89.999999999999])
def test_a_slope_may_be_nearly_level_or_upright(angle: float) -> None:
    plane = Plane(angle=angle, friction=0.2)
    ramp = TwoSideMassPlane(plane=plane, blocks=(Block(mass=1.0), Block(mass=2.0)))
    on_plane = OnPlane(plane=plane, blocks=(Block(mass=1.0),))
    over = Named(name="over", entity=MassWithFixedPulley(system=on_plane, pulley=FixedPulley()))
    load = Named(
        name="load", entity=MassWithFixedPulley(system=Hanging(blocks=(Block(mass=2.0),)), pulley=FixedPulley())
    )
    ends = Link(entity="over", port="tail"), Link(entity="load", port="tail")
    joined = Scene(entities=(over, load), connections=(CONNECTIONS["tendon"](links=ends),))
    for scene in (Scene(entities=(Named(name="ramp", entity=ramp),)), joined):
        assert {"A", "B"} <= {label.text for label in drawing(scene).labels}


@pytest.mark.parametrize("right", [1e-9, 1e-8, 1e-5, 45.0])
@pytest.mark.parametrize("left", [1e-12, 1e-9, 1e-8, 85.0])
def test_the_faces_of_a_prism_may_be_nearly_level(left: float, right: float) -> None:
    prism = Prism(mass=1.0, left=left, right=right)
    both = MassPrismPlane(prism=prism, left_blocks=(Block(mass=1.0),), right_blocks=(Block(mass=2.0),))
    drawn = drawing(Scene(entities=(Named(name="pair", entity=both),)))
    assert {"A", "B"} <= {label.text for label in drawn.labels}


class Balloon(Body):
    nouns = ("balloon",)
    lone = ("a {noun}", "one {noun}")
    named = ("{noun} {letter}", "a {noun} {letter}")


class Sky(Entity):
    balloon: Balloon

    says = ("{balloon} rises.",)

    def build(self, room: Frame) -> None:
        room.body("balloon", 1.0).slide(Z)


def test_a_body_without_a_look_is_drawn_as_a_box_with_its_name_and_said_so() -> None:
    with pytest.warns(FigureWarning, match=r"Balloon, here sky\.balloon; give its class a look"):
        drawn = drawing(Scene(entities=(Named(name="sky", entity=Sky(balloon=Balloon())),)))
    assert [label.text for label in drawn.labels if label.subject == "sky.balloon"] == ["balloon"]
    assert any(isinstance(shape, Area) and shape.dashed for shape in drawn.shapes)


def test_another_format_is_refused_by_name(scenes: list[Scene], tmp_path: Path) -> None:
    with pytest.raises(UnsupportedError, match=r"\.svg, \.png or \.pdf"):
        draw(drawing(scenes[0]), tmp_path / "scene.bmp")


def test_a_missing_extra_is_said_with_the_remedy(
    scenes: list[Scene], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(__import__("sys").modules, "matplotlib", None)
    with pytest.raises(MissingExtraError, match=r"pip install 'matplotlib"):
        draw(drawing(scenes[0]), tmp_path / "scene.svg")
