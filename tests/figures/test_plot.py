from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from sim2reason.figures.curves import describe_event, motion_curves
from sim2reason.figures.plot import REASONS, Colors, plot
from sim2reason.generation.item_search import sample
from sim2reason.scenes.bodies.blocks import Block, Puck, Table
from sim2reason.scenes.bodies.oscillators import Ball
from sim2reason.scenes.bodies.simple_machines import Plane
from sim2reason.scenes.dsl.entity import Entity, Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.particles import Projectile
from sim2reason.scenes.entities.slopes import TwoSideMassPlane
from sim2reason.scenes.entities.two_d_collision_plane import TwoDCollisionPlane
from sim2reason.simulation.scenes import simulate, simulate_full_duration
from sim2reason.simulation.trace import EVENT_KINDS, Event, Trace
from sim2reason.text.prose.description import describe


def alone(entity: Entity) -> Scene:
    return Scene(entities=(Named(name="it", entity=entity),))


SLIDING = alone(TwoSideMassPlane(plane=Plane(angle=30.0, friction=0.2), blocks=(Block(mass=1.0),), speed=3.0))
MEETING = alone(
    TwoDCollisionPlane(
        table=Table(),
        radius=0.1,
        pucks=(Puck(mass=1.0, x=0.0, y=0.0, vx=1.0, vy=0.0), Puck(mass=2.0, x=1.2, y=0.0, vx=-1.0, vy=0.0)),
        restitution=0.5,
    )
)


def exact(scene: Scene, duration: float = 2.0) -> Trace:
    return simulate_full_duration(scene, duration)


def test_curves_are_named_as_in_the_text(scenes: list[Scene]) -> None:
    for scene in scenes[::4]:
        description = describe(scene)
        shown = motion_curves(exact(scene), description)
        for panel in (p for p in shown.panels if p.title.startswith(("displacement", "velocity", "speed"))):
            for curve in panel.curves:
                name = curve.name.partition(",")[0]
                assert any(name in description.mention(address) for address in scene.bodies)
                assert len(curve.values) == len(shown.times)
                assert np.isfinite(curve.values).all()


def test_a_sliding_block_is_shown_as_it_slides() -> None:
    scene = SLIDING
    shown = motion_curves(exact(scene), describe(scene))
    assert [panel.title for panel in shown.panels][:3] == ["displacement (m)", "velocity (m/s)", "acceleration (m/s²)"]
    speed, acceleration = shown.panels[1].curves[0].values, shown.panels[2].curves[0].values
    assert shown.panels[1].curves[0].name.endswith("up the slope")
    assert speed[-1] - speed[0] == pytest.approx(np.trapezoid(acceleration, shown.times), abs=1e-2)
    assert [mark.text for mark in shown.marks][:1] == ["the block begins to slide, or slides back"]


def test_paths_are_drawn_in_the_plane_in_place_of_displacements() -> None:
    shown = motion_curves(exact(MEETING), describe(MEETING))
    (group,) = shown.trajectories
    assert (group.across, group.up) == ("x (m)", "y (m)")
    one, other = group.members
    assert (one.x[0], other.x[0]) == pytest.approx((0.0, 1.2))
    assert one.y == pytest.approx(np.zeros(len(shown.times)))
    titles = [panel.title for panel in shown.panels]
    assert titles == ["speed (m/s)", "energy (J)", "distance (m)"]  # nothing that is zero throughout
    loss = shown.panels[1].curves[0].values
    before, after = (0.5 * 1.0 + 0.5 * 2.0, 0.5 * 3.0 * (-1.0 / 3.0) ** 2 + 0.5 * (2.0 / 3.0) * 4.0 * 0.25)
    assert (loss[0], loss[-1]) == pytest.approx((before, after))  # König: ½ M V² + ½ µ (e v)²


def test_a_body_that_hits_the_ground_is_told_so() -> None:
    scene = alone(Projectile(ball=Ball(mass=1.0), height=2.0, speed=3.0, angle=30.0, restitution=0.5))
    shown = motion_curves(exact(scene), describe(scene))
    assert "hits the ground" in " ".join(mark.text for mark in shown.marks)
    potential, kinetic = (next(c for c in shown.panels[-1].curves if c.name == n) for n in ("potential", "kinetic"))
    before = shown.times < shown.marks[-1].time - 1.0
    total = (potential.values + kinetic.values)[: max(2, int(np.argmin(before)))]
    assert total[:2] == pytest.approx([4.5, 4.5])


def test_names_are_explained_once_and_colours_stay() -> None:
    colors = Colors()
    assert colors.unexplained(["A", "B"])
    assert not colors.unexplained(["B"])
    assert colors.of("A, up") == colors.of("A")
    assert colors.of("A") != colors.of("B")


def test_planets_have_the_units_of_their_text(tmp_path: Path) -> None:
    scene = sample("orbital", "easy", seed=1)
    shown = motion_curves(simulate(scene, scene.horizon), describe(scene))
    assert shown.trajectories[0].across == "x (au)"
    assert "speed (au/yr)" in [panel.title for panel in shown.panels]
    path = tmp_path / "orbits.svg"
    plot(simulate(scene, scene.horizon), describe(scene), path)
    assert "time (yr)" in path.read_text(encoding="utf-8")


def test_both_sides_of_an_event_are_drawn() -> None:
    scene = MEETING
    trace = exact(scene)
    shown = motion_curves(trace, describe(scene))
    hit = next(event.time for event in trace.events if event.kind == "collision")
    assert {hit, np.nextafter(hit, 0.0)} <= set(shown.times)
    assert "collide" in shown.marks[0].text


def test_the_part_cut_off_is_not_drawn_but_shaded(tmp_path: Path) -> None:
    scene = sample("pulley", "easy", seed=1)
    trace = replace(exact(scene), stable_until=0.8, cut="certificate")
    shown = motion_curves(trace, describe(scene))
    assert shown.times[-1] == pytest.approx(0.8)
    path = tmp_path / "traces.svg"
    plot(trace, describe(scene), path)
    text = path.read_text(encoding="utf-8")
    assert "cut off:" in text
    assert REASONS["certificate"] in text


def test_the_same_bytes_twice(tmp_path: Path) -> None:
    scene = sample("hybrid", "medium", seed=2)
    paths = [tmp_path / f"{n}.svg" for n in range(2)]
    for path in paths:
        plot(exact(scene), describe(scene), path)
    assert paths[0].read_bytes() == paths[1].read_bytes()


def test_every_kind_of_event_has_words() -> None:
    scene = SLIDING
    mentions = {address: describe(scene).mention(address) for address in scene.bodies}
    body = next(name for name in scene.mechanism.body)
    for kind in EVENT_KINDS:
        said = describe_event(Event(0.1, kind, (body, body)), scene.mechanism, mentions)
        assert "{" not in said
        assert kind == "crowd" or mentions[body] in said
