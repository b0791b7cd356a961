"""Figures of scenes: the drawing of the initial state, its division into parts, and the plot of the motion."""

import warnings
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from sim2reason.errors import FigureWarning
from sim2reason.figures import faces
from sim2reason.figures.canvas import check, draw, matplotlib
from sim2reason.figures.hanging import HandPiece, HookPiece, PulleyPiece, plate
from sim2reason.figures.labels import disguise_unknowns, place_labels
from sim2reason.figures.layout import Arranger, Layout
from sim2reason.figures.paths import Paths, Strand, flat, has_faces, is_pulley, owner_name, spring, without_welds
from sim2reason.figures.pieces import PIECES, DrawingPlan, Piece, Sizes
from sim2reason.figures.plane import box, mirror
from sim2reason.figures.plot import plot as plotted
from sim2reason.figures.scaled.piece import ScaledPiece
from sim2reason.figures.shapes import SMALL, Drawing, LabelRequest, LineShape, Shape, Sketch, outline, width
from sim2reason.scenes.dsl.body import Small as SmallBody
from sim2reason.scenes.dsl.ports import StringPort
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import SceneLike, Wording, given_scene, read_wording
from sim2reason.simulation.scenes import BOTH, simulate_full_duration
from sim2reason.text.prose.description import Description, describe


@dataclass(frozen=True, slots=True)
class Component:
    """A connected part of a scene: the names of entities with adaptable lengths, and the groups drawn to scale.

    The entities of a group, with the connections between them, are drawn as one piece.
    """

    arranged: frozenset[str]
    groups: tuple[frozenset[str], ...]

    def home(self) -> Mapping[str, str]:
        """Return the name of the drawn group, by entity or connection that it contains."""
        return {name: min(group) for group in self.groups for name in group}


def components(scene: Scene) -> list[Component]:
    """Return all connected components of a scene, in the order of its entities."""
    joined = {f"{c.key}_{n}": [link.entity for link in c.links] for n, c in enumerate(scene.connections, start=1)}
    entities = [named.name for named in scene.entities]
    return [_component(scene, owners) for owners in _clusters([*entities, *joined], joined)]


def _component(scene: Scene, owners: frozenset[str]) -> Component:
    """Return a connected part of a scene, divided into entities with adaptable lengths and groups drawn to scale."""
    scaled = {name for name in owners if _is_entity(scene, name) and not _can_be_arranged(scene, name)}
    if not scaled:
        return Component(owners, ())
    rigid = {name: _ends(scene, name) for name in owners if name in scene.joints and not _is_string(scene, name)}
    carried = any(not ends <= scaled and scene.joints[name].connection.carries for name, ends in rigid.items())
    if scaled == {name for name in owners if _is_entity(scene, name)} or carried:
        return Component(frozenset(), (owners,))
    inner = {name: sorted(ends) for name, ends in rigid.items() if ends <= scaled}
    groups = _clusters([*sorted(scaled), *inner], inner)
    return Component(owners - frozenset[str]().union(*groups), tuple(groups))


def _is_entity(scene: Scene, name: str) -> bool:
    return any(named.name == name for named in scene.entities)


def _can_be_arranged(scene: Scene, name: str) -> bool:
    """Return whether an entity may be drawn with adapted lengths, and all its bodies have shapes for such drawings."""
    bodies = [body for address, body in scene.bodies.items() if address.startswith(f"{name}.")]
    return scene.entity(name).schematic and all(type(body.look) in PIECES for body in bodies)


def _is_string(scene: Scene, name: str) -> bool:
    return issubclass(scene.joints[name].connection.joins, StringPort)


def _ends(scene: Scene, name: str) -> frozenset[str]:
    return frozenset(link.entity for link in scene.joints[name].connection.links)


def _clusters(names: Iterable[str], joined: Mapping[str, Iterable[str]]) -> list[frozenset[str]]:
    """Return the names in groups: each key of `joined` together with all names of its value."""
    leader = {name: name for name in names}
    for name, group in joined.items():
        for other in group:
            old, new = leader[other], leader[name]
            leader = {each: new if head == old else head for each, head in leader.items()}
    heads = dict.fromkeys(leader.values())
    return [frozenset(name for name, group in leader.items() if group == head) for head in heads]


COMPONENT_GAP = 1.2  # units between unconnected parts of a scene
MAX_BRACKET = 1.9  # units, the longest bracket from a corner to a pulley
assert faces  # its import enters what it draws


def drawing(scene: Scene, description: Description | None = None, *, numbers: bool = False) -> Drawing:
    """Draw the initial state of a scene; machines of strings and planes keep angles but not lengths.

    `description` gives the names, by default the text with seed 0; `numbers` adds masses. A body whose class declares
    no look is drawn as a dashed box with its name, with a `FigureWarning`. Lengths and angles that the text leaves open
    are drawn with other values.
    """
    description = description or describe(scene)
    for address, body in scene.bodies.items():
        if body.look is None:
            problem = f"no figure shows a body of the type {type(body).__name__}, here {address}"
            warnings.warn(f"{problem}; give its class a look", FigureWarning, stacklevel=2)
    _, disguised = disguise_unknowns(scene, description, partial(_drawn, description=description, numbers=numbers))
    return disguised


def _drawn(scene: Scene, description: Description, *, numbers: bool) -> Drawing:
    """Draw a scene without replacing lengths and angles that the text leaves unknown."""
    sizes = Sizes(width=1.6, height=1.4) if numbers else Sizes()
    parts: list[Sketch] = []
    for component in components(scene):
        paths = Paths(without_welds(scene), component.arranged, component.home())
        plan = DrawingPlan(without_welds(scene), paths, description, sizes if component.arranged else Sizes(), numbers)
        pieces = {min(group): ScaledPiece(min(group), plan, group) for group in component.groups}
        if component.arranged:
            made = partial(make, pieces)
            parts += [_finished(Arranger(plan, *part, made).best(), plan) for part in _parts(plan, component, pieces)]
        else:
            parts += [piece.sketch() for piece in pieces.values()]
    sketch = _side_by_side(parts)
    labels, leaders = place_labels(sketch.labels, sketch.shapes)
    return Drawing((*sketch.shapes, *leaders), labels)


def make(scaled: Mapping[str, Piece], name: str, plan: DrawingPlan) -> Piece:
    """Return the drawn piece with a name: a group drawn to scale, or else one by the look of its body."""
    if name in scaled:
        return scaled[name]
    look = plan.scene.bodies[name].look if name in plan.scene.bodies else None
    if look is not None:
        return PIECES[type(look)](name, plan)
    if name in plan.paths.mechanism.body:
        return PulleyPiece(name, plan)
    return (HandPiece if name in plan.scene.builder.drawing else HookPiece)(name, plan)


def _parts(plan: DrawingPlan, component: Component, scaled: Iterable[str]) -> Iterable[tuple[list[str], list[Strand]]]:
    """Yield the groups of pieces that strings connect: the pieces' names, and the string segments between them."""
    strands = plan.paths.strands
    names = list(
        dict.fromkeys([*scaled, *_standing(plan, component.arranged), *(k.piece for s in strands for k in (s.a, s.b))])
    )
    leader = {name: name for name in names}
    for strand in strands:
        old, new = leader[strand.b.piece], leader[strand.a.piece]
        leader = {name: new if root == old else root for name, root in leader.items()}
    for head in dict.fromkeys(leader.values()):
        members = [name for name in names if leader[name] == head]
        yield members, [strand for strand in strands if strand.a.piece in members]


def _standing(plan: DrawingPlan, owners: frozenset[str]) -> Iterator[str]:
    """Yield the names of the pieces that are drawn even without a string: planes, free blocks and unused pulleys."""
    carried = plan.paths.carriers
    rims = {knot.item for knots in plan.paths.knots.values() for knot in knots if knot.rim}
    for address, body in plan.scene.bodies.items():
        own = address.split(".", maxsplit=1)[0] in owners
        free = isinstance(body.look, SmallBody) and address not in carried
        if own and (has_faces(body) or free or (is_pulley(body) and address not in rims)):
            yield address


def _finished(layout: Layout, plan: DrawingPlan) -> Sketch:
    """Return the sketch of a layout: pieces, strings, and brackets of pulleys at corners."""
    combined = Sketch()
    for name, piece in layout.pieces.items():
        sketch = piece.sketch().moved(layout.at[name])
        if isinstance(piece, PulleyPiece) and piece.corners:
            sketch.shapes[1:1] = _mounted(layout, name, piece)  # over the disc, to its axle
        combined.extend(sketch)
    for strand, a, b in layout.strands:
        combined.shapes += _strokes(plan.scene, strand.string, a, b)
    _speeds(layout, plan, combined)
    return combined


def _strokes(scene: Scene, name: str, a: complex, b: complex) -> Iterator[LineShape]:
    """Yield the shapes of a string segment, drawn as a string, spring or rod by its connection."""
    look = scene.joints[name].connection.look if name in scene.joints else "string"
    if look == "spring":
        line = next((line for line in scene.mechanism.lines if line.whole == name), None)
        yield from (LineShape(part, "thin") for part in spring(a, b, line))
    else:
        yield LineShape((a, b), "rod" if look == "rod" else "string")


def _mounted(layout: Layout, name: str, piece: PulleyPiece) -> list[Shape]:
    """Return a bracket from a pulley to the nearest corner of a plane, or a plate if all corners are far."""
    here = layout.at[name]
    ends = [
        layout.at[corner] + edge
        for corner in piece.corners
        for direction in (1.0 + 0j, -1.0 + 0j)
        if (edge := layout.pieces[corner].edge(direction)) is not None
    ]
    nearest = min(ends, key=lambda end: abs(end - here))
    if abs(nearest - here) <= MAX_BRACKET:
        return [LineShape((nearest, here), "edge")]
    return plate(piece.support, here)


def _speeds(layout: Layout, plan: DrawingPlan, sketch: Sketch) -> None:
    """Draw an arrow beside every block that moves at the start."""
    for block, carrier in plan.paths.carriers.items():
        body, piece = plan.paths.mechanism.body[block], layout.pieces.get(carrier)
        moving = [c for c in body.coordinates if c.speed != 0.0]
        if piece is None or not moving or not isinstance(piece, faces.FacePiece):
            continue
        direction = flat(moving[0].axis) * (1.0 if moving[0].speed > 0.0 else -1.0)
        direction = mirror(direction) if carrier in piece.plan.mirrored else direction
        out = direction * 1j if (direction * 1j).imag > 0.0 or abs(direction.imag) > 0.999 else direction * -1j
        start = layout.at[carrier] + piece.center(block) + out * (0.5 * plan.sizes.height + 0.22) - 0.45 * direction
        sketch.shapes.append(LineShape((start, start + 0.9 * direction), "thin", arrow=True))
        text = plan.stated(owner_name(block), "m/s", abs(moving[0].speed))
        wide = 0.5 * width(text, SMALL)
        spots = [
            start + along * direction + complex(out.real * (wide + 0.1), out.imag * 0.36)
            for along in (0.45, 0.0, 0.9, 1.4)
        ]
        sketch.labels.append(LabelRequest(text, tuple(spots), block, SMALL, name=False))


def _side_by_side(parts: Sequence[Sketch]) -> Sketch:
    """Return several sketches side by side from left to right, on one ground level."""
    combined, right = Sketch(), 0.0
    for part in parts:
        left, low, end, _ = box(point for shape in part.shapes for point in outline(shape))
        part = part.moved(complex(right - left, -low))  # noqa: PLW2901 - the same part, in its place
        combined.extend(part)
        right += end - left + COMPONENT_GAP
    return combined


def figure(
    scene: SceneLike,
    out: Path | str,
    *,
    numbers: bool = False,
    seed: int | None = None,
    wording: Wording | None = None,
) -> None:
    """Draw the initial state of a scene into a file, with the names of its text.

    Numbers that the wording replaces by symbols are shown as symbols. A FigureWarning names features that the figure
    can only suggest.

    Args:
        scene: A scene, the path of its file, its YAML text, an item about it, or the result of `parse_scene`.
        out: File with the ending .svg, .png or .pdf.
        numbers: Whether to write the masses, too.
        seed: Seed of the text, on which names depend; by default that of `wording`, or 0.
        wording: Wording of the text; by default that in the scene's file, if there is one.

    Raises:
        TypeError: `scene` is of another type.
        MissingExtraError: matplotlib is not installed.
        UnsupportedError: `out` has another ending.

    Examples:
        >>> import sim2reason
        >>> scene = sim2reason.parse_scene("A 2 kg block is released from rest on a frictionless 30-degree incline.")
        >>> sim2reason.figure(scene, "scene.svg")
    """
    check(Path(out))
    scene, wording = _given(scene, wording, "figure")
    draw(drawing(scene, _described(scene, seed, wording), numbers=numbers), Path(out))


def plot(
    scene: SceneLike,
    out: Path | str,
    *,
    duration: float | None = None,
    engine: str = BOTH,
    seed: int | None = None,
    wording: Wording | None = None,
) -> None:
    """Plot displacement, velocity, acceleration and tension over time into a file.

    Args:
        scene: A scene, the path of its file, its YAML text, an item about it, or the result of `parse_scene`.
        out: File with the ending .svg, .png or .pdf.
        duration: Duration in the scene's unit of time (s unless its text uses another); by default its horizon.
        engine: ``exact``, ``mujoco``, or ``both``: the motion of the exact engine, cut where the engines part.
        seed: Seed of the text, on which names depend; by default that of `wording`, or 0.
        wording: Wording of the text; by default that in the scene's file, if there is one.

    Raises:
        TypeError: `scene` is of another type.
        MissingExtraError: matplotlib is not installed.
        UnsupportedError: `out` has another ending.
        SceneError, SimulationError, UnknownNameError: The scene cannot be simulated, as in `simulate`.

    Examples:
        >>> import sim2reason
        >>> scene = sim2reason.parse_scene("A 2 kg block is released from rest on a frictionless 30-degree incline.")
        >>> sim2reason.plot(scene, "motion.svg", duration=1.0)
    """
    check(Path(out))
    scene, wording = _given(scene, wording, "plot")
    matplotlib()
    plotted(simulate_full_duration(scene, duration, engine), _described(scene, seed, wording), Path(out))


def _given(scene: SceneLike, wording: Wording | None, function: str) -> tuple[Scene, Wording | None]:
    """Return the scene with its wording; the default is the wording in the scene's file, else None."""
    resolved, text = given_scene(scene, function)
    return resolved, wording or (read_wording(text) if text else None)


def _described(scene: Scene, seed: int | None, wording: Wording | None) -> Description:
    wording = wording or Wording()
    wanted = wording.seed if seed is None else seed
    return describe(scene, wanted, without=wording.without, hide=wording.symbols)
