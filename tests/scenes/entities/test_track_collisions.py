"""Tests of collisions on a straight track: closed forms, texts, files, agreement of both engines."""

from math import pi, radians, sin, sqrt

import numpy as np
import pytest

from sim2reason.figures.drawing import drawing
from sim2reason.figures.shapes import Arc, LineShape
from sim2reason.scenes.bodies.blocks import Glider, SlidingBall
from sim2reason.scenes.bodies.simple_machines import Track
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.track_collisions import ComplexCollisionPlane
from sim2reason.simulation.engines.exact import simulate
from sim2reason.simulation.trace import Trace
from sim2reason.text.prose.description import describe
from told import certified, check_told, check_whole, drawn, scene_of

CLOSE = 1e-9
G = 9.8


def track(gliders: list[tuple[float, float, float]], restitution: float = 1.0, **more: object) -> Scene:
    """Build gliders on a track, each given by mass, position and velocity."""
    told = tuple(Glider(mass=m, x=x, v=v) for m, x, v in gliders)
    held = {"track": {}, "gliders": told, "restitution": restitution, **more}
    return scene_of(ComplexCollisionPlane.model_validate(held))


def moved(scene: Scene, times: list[float]) -> Trace:
    return simulate(scene.mechanism, np.array(times))


def hits(trace: Trace) -> list[float]:
    return [event.time for event in trace.events if event.kind == "collision"]


@pytest.mark.parametrize("e", [1.0, 0.6])
def test_three_in_a_row(e: float) -> None:
    """The pairs collide one after the other by Newton's law of impact, u⁺ = −e u⁻ with Σmv constant."""
    masses, v = [1.0, 2.0, 0.5], [2.0, 0.5, -0.3]
    trace = moved(track([(1.0, 0.0, 2.0), (2.0, 1.5, 0.5), (0.5, 4.0, -0.3)], e), [0.0, 1.1, 10.0])
    first = 1.5 / 1.5

    def after(m1: float, m2: float, v1: float, v2: float) -> tuple[float, float]:
        both = m1 * v1 + m2 * v2
        return (both - e * m2 * (v1 - v2)) / (m1 + m2), (both + e * m1 * (v1 - v2)) / (m1 + m2)

    v[0], v[1] = after(masses[0], masses[1], v[0], v[1])
    second = first + (4.0 - 0.3 * first - 2.0) / (v[1] + 0.3)
    v[1], v[2] = after(masses[1], masses[2], v[1], v[2])
    assert hits(trace)[:2] == pytest.approx([first, second], abs=CLOSE)
    if v[0] <= v[1]:
        assert trace.state.v[-1] == pytest.approx(v, abs=CLOSE)


@pytest.mark.parametrize("wall", [False, True])
def test_those_that_stick_go_on_together(wall: bool) -> None:
    """With e = 0, v = Σmv/Σm after each collision; at a wall all come to rest."""
    ends = {"right": 9.0} if wall else {}
    scene = track([(1.0, 0.0, 3.0), (2.0, 1.5, 0.0), (0.5, 4.0, -0.5)], 0.0, **ends)
    first = 0.5
    second = first + (4.0 - 0.5 * first - 1.5) / 1.5
    common = (3.0 - 0.25) / 3.5
    place = 1.5 + 1.0 * (second - first)
    trace = moved(scene, [0.0, second + 1.0, 15.0])
    assert hits(trace)[:2] == pytest.approx([first, second], abs=CLOSE)
    assert trace.state.v[1] == pytest.approx([common] * 3, abs=CLOSE)
    assert trace.state.v[2] == pytest.approx([0.0 if wall else common] * 3, abs=CLOSE)
    if wall:
        assert hits(trace)[2] == pytest.approx(second + (9.0 - place) / common, abs=CLOSE)


@pytest.mark.parametrize(("power", "count"), [(0, 3), (1, 31)])
def test_galperin_counts_the_digits_of_pi(power: int, count: int) -> None:
    """Masses 1 and 100^k and a wall have floor(π·10^k) elastic collisions.

    G. Galperin, Playing pool with π (2003).
    """
    speed = 0.1**power
    scene = track([(1.0, 1.0, 0.0), (100.0**power, 2.0, -speed)], left=0.0)
    assert len(hits(moved(scene, [0.0, 60.0 / speed]))) == count


def test_bounces_on_a_slope() -> None:
    """The k-th bounce is at t₁ + (2v₁/a) e (1 − e^(k−1))/(1 − e), with a = g sin θ, v₁ = a t₁.

    The times between bounces are a geometric series.
    """
    e, a = 0.7, G * sin(radians(30.0))
    scene = track([(1.0, 1.0, 0.0), (1.0, 50.0, 0.0)], e, left=0.0, track={"angle": 30.0})
    first = sqrt(2.0 / a)
    expected = [first + 2.0 * first * e * (1.0 - e**k) / (1.0 - e) for k in range(6)]
    found = moved(scene, [0.0, expected[-1] + 0.01])
    assert hits(found) == pytest.approx(expected, abs=CLOSE)


def test_a_buffer_is_touched_for_half_a_period() -> None:
    """The contact lasts π√(µ/k) and ends as an elastic collision, whatever the coefficient of restitution."""
    buffer = {"first": 0, "second": 1, "buffer": {"stiffness": 80.0, "length": 0.3}}
    scene = track([(1.0, 0.0, 1.2), (3.0, 1.5, 0.0)], 0.5, buffers=(buffer,), right=9.0)
    mu = 0.75
    touch, apart = 1.0, 1.0 + pi * sqrt(mu / 80.0)
    trace = moved(scene, [0.0, 0.5 * (touch + apart), apart + 0.5])
    seen = [(event.kind, event.subjects[0].rpartition(".")[2]) for event in trace.events if event.kind != "turn"]
    assert seen == [("land", "buffer"), ("leave", "buffer")]
    times = [event.time for event in trace.events if event.kind != "turn"]
    assert times == pytest.approx([touch, apart], abs=CLOSE)
    assert trace.state.v[1] == pytest.approx([0.3, 0.3], abs=CLOSE)
    assert trace.state.v[2] == pytest.approx([-0.6, 0.6], abs=CLOSE)


def test_a_spring_block_that_is_struck() -> None:
    """After an elastic collision of A with an equal ball, x_B − x_A − ℓ = −(v/ω) sin ωt with ω² = k/µ."""
    joined = {"first": 1, "second": 2, "spring": {"stiffness": 120.0}}
    scene = track([(0.8, 0.0, 1.5), (0.8, 0.6, 0.0), (2.0, 1.2, 0.0)], joined=(joined,))
    hit, omega = 0.4, sqrt(120.0 * (1.0 / 0.8 + 0.5))
    times = hit + np.linspace(0.01, 0.12, 12)
    trace = moved(scene, [0.0, *times])
    stretch = trace.state.q[1:, 2] - trace.state.q[1:, 1]
    assert stretch == pytest.approx(-1.5 / omega * np.sin(omega * (times - hit)), abs=CLOSE)
    assert trace.state.v[1:, 0] == pytest.approx(np.zeros(12), abs=CLOSE)


@pytest.mark.parametrize("count", [10, pytest.param(50, marks=pytest.mark.slow)])
def test_texts_and_files_lead_back(count: int) -> None:
    for seed, scene in enumerate(drawn(ComplexCollisionPlane, count)):
        check_told(scene, seed)


@pytest.mark.parametrize(
    ("kinds", "called"),
    [("bb", "two small blocks"), ("ss", "two small balls"), ("bs", "two small bodies"), ("sbs", "")],
)
def test_balls_are_called_balls_and_drawn_round(kinds: str, called: str) -> None:
    """Balls and blocks have their own nouns and shapes, and move alike."""
    classes = {"b": Glider, "s": SlidingBall}
    gliders = tuple(classes[kind](mass=1.0 + n, x=float(n), v=-0.5 * n) for n, kind in enumerate(kinds))
    scene = scene_of(ComplexCollisionPlane(track=Track(), gliders=gliders, restitution=0.8))
    for seed in range(8):
        check_told(scene, seed)
        description = describe(scene, seed)
        nouns = dict(zip(classes.values(), ("block", "ball"), strict=True)) | dict(description.names.nouns)
        said = called.replace("block", nouns[Glider]).replace("ball", nouns[SlidingBall])
        assert said in description.text.lower()
        assert "|" not in description.text
        shapes = drawing(scene, description).shapes
        assert sum(isinstance(shape, Arc) and shape.fill == "block" for shape in shapes) == kinds.count("s")
        assert sum(isinstance(shape, LineShape) and shape.weight == "rod" for shape in shapes) == 1
    check_whole(scene, 0)
    blocks = track([(g.mass, g.x, g.v) for g in gliders], 0.8)
    assert moved(scene, [0.0, 3.0]).state.q.tolist() == moved(blocks, [0.0, 3.0]).state.q.tolist()


def test_dead_hits_are_told() -> None:
    for seed in range(6):
        check_told(track([(1.0, 0.0, 3.0), (2.0, 1.5, 0.0)], 0.0, right=9.0), seed)


def test_the_order_on_the_track_is_told() -> None:
    """Symbolic positions do not show the order of the bodies, so the text states it."""
    scene = track([(1.0, -1.0, 2.0), (2.0, 0.0, 0.0)])
    assert all("named in order of increasing x" in describe(scene, seed).text for seed in range(10))


@pytest.mark.parametrize("restitution", [0.0, 0.6, 1.0])
def test_what_is_said_of_collisions_is_true_of_walls(restitution: float) -> None:
    """No sentence about restitution speaks of two bodies, since a body may also hit a wall."""
    scene = track([(1.0, 0.0, 3.0), (2.0, 1.5, 0.0)], restitution, right=9.0)
    told = {describe(scene, seed).sentences[-1] for seed in range(30)}
    assert len(told) == 3
    assert not any(words in sentence for sentence in told for words in ("odies", "those", "they", "the two"))


@pytest.mark.slow  # testing/test_entities cuts the sentences of every entity
def test_no_sentence_can_be_left_out() -> None:
    for seed, scene in enumerate(drawn(ComplexCollisionPlane, 8, seed=1)):
        check_whole(scene, seed)


def test_both_engines_agree() -> None:
    """A few random draws end early, at fully compressed springs or accumulating collisions."""
    assert sum(certified(scene) for scene in drawn(ComplexCollisionPlane, 12, seed=2)) >= 7


@pytest.mark.parametrize(
    ("more", "says"),
    [
        ({"left": 0.5}, "in order from left to right"),
        (
            {"buffers": ({"first": 0, "second": 1, "buffer": {"stiffness": 80.0, "length": 0.3}},)},
            "nothing can collide",
        ),
        ({"pairs": ({"first": 0, "second": 1, "restitution": 1.0},)}, "other than that of all the others"),
        ({"pairs": ({"first": 0, "second": 0, "restitution": 0.5},)}, "two neighbours"),
    ],
)
def test_what_can_not_be_is_refused(more: dict[str, object], says: str) -> None:
    with pytest.raises(ValueError, match=says):
        track([(1.0, 0.0, 1.0), (1.0, 1.0, 0.0)], **more)
