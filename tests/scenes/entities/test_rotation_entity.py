"""Tests of rigid bodies about an axle, against closed forms and sums over point clouds."""

import re
from math import cos, degrees, pi, radians, sin, sqrt

import numpy as np
import pytest
from numpy.typing import NDArray

import sim2reason
from drawn_entities import certified, drawn_entity, travels
from lone_entities import alone, followed
from quadrature import CLOUDS
from sim2reason.errors import SceneError
from sim2reason.generation.item_search import sample
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.scenes.bodies.blocks import PolygonalPrism
from sim2reason.scenes.bodies.eccentric_bodies import Bowl, Hemisphere, HollowSphereWithHole, SphereWithHole
from sim2reason.scenes.bodies.oscillators import Bar, FixedBall, UniformRod
from sim2reason.scenes.bodies.round_bodies import Cylinder, Disc, Sphere
from sim2reason.scenes.connections.two_ended import Pivot, Weld
from sim2reason.scenes.dsl.connection import Link
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import RigidPendulum, RotationEntity, WeldedArm, holds_axle
from sim2reason.scenes.entities.pieces import (
    FIRST,
    LIKE_FIRST,
    OTHER_SIDE,
    SAME_SIDE,
    UNLIKE_FIRST,
    AnyPiece,
    AxialPiece,
    BallPiece,
    BarPiece,
    CappedPiece,
    HoledPiece,
    RoundPiece,
    Side,
    TiltedPiece,
)
from sim2reason.simulation.engines.exact import simulate
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.quantities.subjects.rotating_parts import SwingingLines
from sim2reason.text.prose.description import describe

G = 9.8
CLOSE = 1e-8
CHOICES = {"rate?": 0.4, "side?": 0.2, "reach?": 0.0}
Array = NDArray[np.float64]


def complete(k: float) -> float:
    """Return the complete elliptic integral K(k) = π/(2 agm(1, √(1 − k²))); Abramowitz and Stegun 17.6."""
    a, b = 1.0, sqrt(1.0 - k * k)
    while abs(a - b) > 1e-15 * a:
        a, b = 0.5 * (a + b), sqrt(a * b)
    return pi / (a + b)


def hung(length: float = 1.2, mass: float = 2.0, angle: float = 60.0, rate: float | None = None) -> RotationEntity:
    """Build a uniform rod that hangs by its end."""
    piece = AxialPiece(body=UniformRod(mass=mass, length=length), distance=0.5 * length, axis="along the arm")
    return RotationEntity(pieces=(piece,), angle=angle, rate=rate)


@pytest.mark.parametrize("angle", [5.0, 60.0, 120.0, 175.0])
def test_the_period_of_a_rod_hung_by_its_end(angle: float) -> None:
    """The period is T = 4√(2L/3g)·K(sin θ₀/2).

    Landau and Lifshitz, Mechanics, §11, with the length 2L/3 of the equivalent simple pendulum.
    """
    length = 1.2
    period = 4.0 * sqrt(2.0 * length / (3.0 * G)) * complete(sin(radians(angle) / 2.0))
    trace = followed(hung(length, angle=angle), 1.2 * period)
    turns = [event.time for event in trace.events if event.kind == "turn"]
    assert turns == pytest.approx([period / 2.0, period], rel=CLOSE)


def test_small_balls_on_both_sides() -> None:
    """The initial angular acceleration is g sin θ (m₁d₁ − m₂d₂)/(m₁d₁² + m₂d₂²)."""
    pieces = (
        BallPiece(body=FixedBall(mass=3.0), distance=0.8),
        BallPiece(body=FixedBall(mass=2.0), distance=0.5, side="on the other side"),
    )
    trace = followed(RotationEntity(pieces=pieces, angle=40.0), 1.0, 3)
    expected = G * sin(radians(40.0)) * (3.0 * 0.8 - 2.0 * 0.5) / (3.0 * 0.8**2 + 2.0 * 0.5**2)
    assert abs(trace.state.a[0, 0]) == pytest.approx(expected, rel=CLOSE)


def test_a_rod_that_goes_over_the_top() -> None:
    """Energy gives ½·⅓mL²(ω² − ω₀²) = −mg(L/2)(cos θ₀ − cos θ), here with ω₀² > 6g/L."""
    length, rate = 1.2, 8.0
    trace = followed(hung(length, angle=0.0, rate=rate), 2.0)
    assert trace.events == ()
    angle, speed = trace.state.q[:, 0], trace.state.v[:, 0]
    assert speed[0] == -rate
    assert speed**2 == pytest.approx(rate**2 - 3.0 * G / length * (1.0 - np.cos(angle)), rel=CLOSE)


def test_a_physical_pendulum_of_a_rod_and_a_sphere() -> None:
    """Energy gives ½Iω² = Mgd(cos θ − cos θ₀), with I and Md by the parallel-axis theorem."""
    rod, ball = UniformRod(mass=1.2, length=0.8), Sphere(mass=2.0, radius=0.1)
    pieces = (
        AxialPiece(body=rod, distance=0.4, axis="along the arm"),
        RoundPiece(body=ball, distance=0.8),
    )
    trace = followed(RotationEntity(pieces=pieces, angle=60.0), 3.0)
    inertia = 1.2 * 0.8**2 / 3.0 + 2.0 * (0.4 * 0.1**2 + 0.8**2)
    moment = 1.2 * 0.4 + 2.0 * 0.8
    angle, speed = radians(60.0) - trace.state.q[:, 0], trace.state.v[:, 0]
    wanted = 2.0 * G * moment / inertia * (np.cos(angle) - 0.5)
    assert speed**2 == pytest.approx(wanted, abs=CLOSE * float(wanted.max()))


Z_TO_X = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]])
Z_TO_Y = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
Z_BACK = Z_TO_X @ Z_TO_X @ Z_TO_X
SIZED = {"radius": 0.12, "mass": 1.5}
TILT = radians(35.0)
Z_TILTED = np.array([[0.0, -sin(TILT), cos(TILT)], [0.0, cos(TILT), sin(TILT)], [-1.0, 0.0, 0.0]])
BAR = Bar(mass=1.1, length=0.5, width=0.16, thickness=0.04)
HOLED = SphereWithHole(hole=0.04, offset=0.05, **SIZED)
PLACED: list[tuple[AnyPiece, Array]] = [
    (AxialPiece(body=Cylinder(height=0.3, **SIZED), distance=0.6, axis="along the arm"), Z_TO_X),
    (AxialPiece(body=Disc(**SIZED), distance=0.6, axis="parallel to the axle"), Z_TO_Y),
    (AxialPiece(body=Disc(**SIZED), distance=0.6, axis="at right angles to both arm and axle"), np.eye(3)),
    (TiltedPiece(body=Cylinder(height=0.3, **SIZED), distance=0.6, tilt=35.0), Z_TILTED),
    (AxialPiece(body=PolygonalPrism(shape="square", height=0.2, **SIZED), distance=0.6, axis="along the arm"), Z_TO_X),
    (CappedPiece(body=Hemisphere(**SIZED), distance=0.6, faces="the axle"), Z_TO_X),
    (CappedPiece(body=Hemisphere(**SIZED), distance=0.6, faces="away from the axle"), Z_BACK),
    (CappedPiece(body=Bowl(height=0.1, thickness=0.02, **SIZED), distance=0.6, faces="the axle"), Z_TO_X),
    (
        HoledPiece(body=SphereWithHole(hole=0.04, offset=0.05, **SIZED), distance=0.6, hole="farther from the axle"),
        Z_TO_X,
    ),
    (
        HoledPiece(
            body=HollowSphereWithHole(hole=0.06, offset=0.12, thickness=0.02, **SIZED),
            distance=0.6,
            hole="nearer to the axle",
        ),
        Z_BACK,
    ),
    (BarPiece(body=BAR, distance=0.6, along="length", across="width"), np.array([[0.0, 0, 1], [1, 0, 0], [0, 1, 0]])),
    (BarPiece(body=BAR, distance=0.6, along="width", across="thickness"), np.eye(3)),
    (
        BarPiece(body=BAR, distance=0.6, along="thickness", across="length"),
        np.array([[0.0, 1, 0], [0, 0, 1], [1, 0, 0]]),
    ),
]


@pytest.mark.parametrize(("piece", "turn"), PLACED)
def test_each_piece_turns_as_its_points_do(piece: AnyPiece, turn: Array) -> None:
    """The equation of motion is Iθ̈ = −g Σ m (x sin θ + z cos θ), with sums over a point cloud.

    The piece's own momentum is Σ m v, its kinetic energy Σ ½mv² = ½Iω².
    """
    rod = AxialPiece(body=UniformRod(mass=1.0, length=0.4), distance=0.2, axis="along the arm")
    trace = followed(RotationEntity(pieces=(rod, piece), angle=70.0), 2.0, 41)
    points, shares = CLOUDS[type(piece.body)](piece.body)
    masses, placed = piece.shape.mass * shares / shares.sum(), points @ turn.T + np.array([0.6, 0.0, 0.0])
    inertia = float(masses @ (placed[:, 0] ** 2 + placed[:, 2] ** 2))
    x, z = float(masses @ placed[:, 0]), float(masses @ placed[:, 2])
    angle, speed = radians(70.0) - trace.state.q[:, 0], trace.state.v[:, 0]
    pull = -G * ((x + 0.2) * np.sin(angle) + z * np.cos(angle))
    assert -trace.state.a[:, 0] == pytest.approx(pull / (inertia + 0.4**2 / 3.0), abs=CLOSE * 20.0)
    energy = QUANTITIES["kinetic energy"].evaluate(trace.state, "it.pieces.1.body")
    assert energy == pytest.approx(0.5 * inertia * speed**2, abs=CLOSE * float(energy.max()))
    momentum = np.linalg.norm(QUANTITIES["momentum"].evaluate(trace.state, "it.pieces.1.body"), axis=-1)
    assert momentum == pytest.approx(np.hypot(x, z) * np.abs(speed), abs=CLOSE * float(momentum.max()))


def test_beyond_the_axle() -> None:
    """A dumb-bell has I = Σ m(d² + ⅖r²), and its moment is the difference of both sides."""
    one = RoundPiece(body=Sphere(mass=3.0, radius=0.1), distance=0.5)
    other = RoundPiece(body=Sphere(mass=1.0, radius=0.1), distance=0.7, side="on the other side")
    trace = followed(RotationEntity(pieces=(one, other), angle=40.0), 1.0, 11)
    inertia, moment = 3.0 * (0.5**2 + 0.004) + 1.0 * (0.7**2 + 0.004), 3.0 * 0.5 - 0.7
    angle = radians(40.0) - trace.state.q[:, 0]
    assert trace.state.a[:, 0] == pytest.approx(G * moment / inertia * np.sin(angle), abs=CLOSE * G)


def test_energy_is_kept_for_a_long_time() -> None:
    """Four pieces swing for a hundred periods."""
    entity = drawn_entity(RotationEntity, 7, {**CHOICES, "rate?": 0.0})
    trace = followed(entity, 100.0 * entity.horizon(G) / 1.5, 401)
    state, bodies = trace.state, [body.name for body in trace.mechanism.bodies if body.mass]
    kinetic = sum(QUANTITIES["kinetic energy"].evaluate(state, body) for body in bodies)
    potential = sum(QUANTITIES["potential energy"].evaluate(state, body) for body in bodies)
    assert kinetic + potential == pytest.approx(0.0, abs=CLOSE * float(np.max(kinetic)))


def double(reach: float | None = 0.9, *, stiff: bool = False) -> Scene:
    """Build a rod on an axle, with another rod hinged or welded to its end."""
    upper = hung(0.9, 2.0, 50.0).model_copy(update={"reach": reach})
    piece = AxialPiece(body=UniformRod(mass=1.4, length=0.6), distance=0.3, axis="along the arm")
    lower = RigidPendulum(pieces=(piece,), angle=20.0)
    links = (Link(entity="upper", port="tip"), Link(entity="lower", port="axle"))
    entities = (Named(name="upper", entity=upper), Named(name="lower", entity=lower))
    return Scene(entities=entities, connections=((Weld if stiff else Pivot)(links=links),))


def test_a_double_physical_pendulum() -> None:
    """The motion satisfies Lagrange's equations of two rods of masses M, m and lengths L, l.

    (M/3 + m)L²θ̈ + ½mLl(φ̈ cos(θ−φ) + φ̇² sin(θ−φ)) = −(M/2 + m)gL sin θ and
    ⅓ml²φ̈ + ½mLl(θ̈ cos(θ−φ) − θ̇² sin(θ−φ)) = −½mgl sin φ; Goldstein, ch. 1, for uniform rods.
    """
    scene = double()
    trace = simulate(scene.mechanism, np.linspace(0.0, 3.0, 61))
    (q, p), (w, u), (a, b) = trace.state.q.T, trace.state.v.T, trace.state.a.T  # the second is relative
    theta, phi = radians(50.0) - q, radians(20.0) - q - p
    rate, other, alpha, beta = -w, -(w + u), -a, -(a + b)
    big, m, long, short = 2.0, 1.4, 0.9, 0.6
    share = 0.5 * m * long * short
    one = (big / 3 + m) * long**2 * alpha + share * (beta * np.cos(theta - phi) + other**2 * np.sin(theta - phi))
    two = m * short**2 / 3 * beta + share * (alpha * np.cos(theta - phi) - rate**2 * np.sin(theta - phi))
    assert one == pytest.approx(-(big / 2 + m) * G * long * np.sin(theta), abs=CLOSE * 10)
    assert two == pytest.approx(-0.5 * m * G * short * np.sin(phi), abs=CLOSE * 10)
    text = sim2reason.describe(scene, 3).text
    assert sim2reason.parse_scene(text).scene.entities[1].entity == scene.entities[1].entity
    assert sim2reason.certify(scene)[1].stable_until == scene.horizon


def test_welded_to_each_other_they_turn_as_one() -> None:
    """Only the coordinate of the upper arm is left."""
    mechanism = double(stiff=True).mechanism
    assert [coordinate.body for coordinate in mechanism.coordinates] == ["upper.arm"]


def test_what_hangs_from_an_arm_needs_its_end() -> None:
    with pytest.raises(SceneError, match="needs reach"):
        double(None)


def test_the_length_of_an_arm_is_given_only_where_something_hangs_there() -> None:
    """An unused length is refused, and removed from a scene together with the part that used it."""
    upper = hung().model_copy(update={"reach": 1.5})
    with pytest.raises(SceneError, match="reach only matters to what is joined to its port 'tip', which is open"):
        Scene(entities=(Named(name="upper", entity=upper),))
    left = double().without("lower").entity("upper")
    assert isinstance(left, RotationEntity)
    assert left.reach is None


def test_a_tilt_towards_the_axle_changes_the_inertia() -> None:
    """A tilted cylinder has I = I⊥ cos²β + I∥ sin²β + md², and initially mgd sin θ / I.

    I∥ = ½mr², I⊥ = m(3r² + h²)/12.
    """
    mass, radius, height, distance, tilt = 1.5, 0.12, 0.4, 0.5, radians(35.0)
    body = Cylinder(mass=mass, radius=radius, height=height)
    entity = RotationEntity(pieces=(TiltedPiece(body=body, distance=distance, tilt=35.0),), angle=40.0)
    axial, across = 0.5 * mass * radius**2, mass * (3.0 * radius**2 + height**2) / 12.0
    inertia = across * cos(tilt) ** 2 + axial * sin(tilt) ** 2 + mass * distance**2
    start = followed(entity, 1.0).state.a[0, 0]
    assert start == pytest.approx(mass * G * distance * sin(radians(40.0)) / inertia, rel=CLOSE)


@pytest.mark.parametrize("seed", range(50))
def test_text_and_file_lead_back(seed: int) -> None:
    travels(drawn_entity(RotationEntity, seed, CHOICES), seed)


@pytest.mark.parametrize("seed", range(8))
def test_engines_agree(seed: int) -> None:
    assert certified(drawn_entity(RotationEntity, 1000 + seed, CHOICES)) == 1.0


@pytest.mark.parametrize(
    ("fields", "says"),
    [
        ({"angle": 0.0}, "hangs at rest"),
        ({"angle": 9.0, "side": "on the other side"}, "begin with a piece on the side"),
        ({"angle": 9.0, "twice": True}, "overlap"),
    ],
)
def test_what_makes_no_sense_is_refused(fields: dict[str, object], says: str) -> None:
    side, twice = fields.pop("side", "from the axle"), fields.pop("twice", False)
    piece = RoundPiece(body=Sphere(mass=1.0, radius=0.1), distance=0.5, side=side)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match=says):
        RotationEntity(pieces=(piece,) * (2 if twice else 1), **fields)  # type: ignore[arg-type]


def test_two_small_balls_have_places_of_their_own() -> None:
    ball = BallPiece(body=FixedBall(mass=1.0), distance=0.5)
    across = ball.model_copy(update={"side": "on the other side"})
    with pytest.raises(ValueError, match="overlap"):
        RotationEntity(pieces=(ball, ball), angle=9.0)
    assert len(RotationEntity(pieces=(ball, across), angle=9.0).pieces) == 2


def test_a_rod_ends_in_what_is_thick_on_its_own_side_alone() -> None:
    ball = RoundPiece(body=Sphere(mass=2.0, radius=0.1), distance=0.2)
    rod = AxialPiece(body=UniformRod(mass=1.0, length=0.5), distance=0.1, axis="along the arm")
    assert len(RotationEntity(pieces=(ball, rod), angle=9.0).pieces) == 2
    with pytest.raises(ValueError, match="overlap"):
        RotationEntity(pieces=(ball, rod.model_copy(update={"side": OTHER_SIDE})), angle=9.0)


@pytest.mark.parametrize(
    ("side", "angle", "line"), [(OTHER_SIDE, 150.0, "the bodies on the arm"), (SAME_SIDE, 30.0, "the arm")]
)
def test_an_arm_that_carries_bodies_on_both_sides_does_not_point(side: Side, angle: float, line: str) -> None:
    """The centre of mass is on the side of the ball at 2 m, not at 0.5 m: the deflection is 30° or 180° − 30°."""
    near = BallPiece(body=FixedBall(mass=1.0), distance=0.5)
    arm = RotationEntity(pieces=(near, near.model_copy(update={"distance": 2.0, "side": side})), angle=30.0)
    search = QuestionSearch(Scene(entities=(Named(name="it", entity=arm),)), 0)
    (name, phrase), *others = search.words.subject_phrases(SwingingLines()).items()
    assert not others
    assert phrase.endswith(line)
    assert QUANTITIES["deflection"].evaluate(search.study.trace.at(0.0), name)[0] == pytest.approx(angle)


def test_the_start_is_where_the_text_says() -> None:
    """The rod starts 60° to the right of the downward vertical, moving down and to the left."""
    trace = followed(hung(1.0, angle=60.0, rate=2.0), 0.1, 11)
    center = trace.state.frames.center("it.pieces.0.body")
    place, velocity = trace.state.vector(center.place)[0], trace.state.vector(center.velocity)[0]
    assert place == pytest.approx([0.5 * sin(radians(60)), 0.0, -0.5 * cos(radians(60))])
    assert velocity == pytest.approx([-cos(radians(60)), 0.0, -sin(radians(60))])
    assert degrees(np.arctan2(place[0], -place[2])) == pytest.approx(60.0)
    assert alone(hung()).horizon == pytest.approx(1.5 * 2.0 * pi * sqrt(2.0 * 1.2 / (3.0 * G)))


@pytest.mark.parametrize("faces", ["the axle", "away from the axle"])
def test_how_a_hemisphere_is_turned_is_told(faces: str) -> None:
    piece = CappedPiece.model_validate({"body": Hemisphere(**SIZED), "distance": 0.6, "faces": faces})
    scene = alone(RotationEntity(pieces=(piece,), angle=60.0))
    for seed in range(8):
        text = describe(scene, seed).text
        assert re.search(r"axis of symmetry (?:lies )?along the arm", text)
        assert re.search(rf"flat face (faces|facing) {faces}", text)


@pytest.mark.parametrize(("tilt", "past"), [(38.0, True), (80.0, False)])
def test_a_tilted_rod_may_reach_past_the_axle(tilt: float, past: bool) -> None:
    """A rod of 0.67 m tilted by 38° extends by 0.26 m, past the axle 0.14 m from its centre.

    A rod along the arm is allowed to.
    """
    rod = UniformRod(mass=3.3, length=0.67)
    assert holds_axle(TiltedPiece(body=rod, distance=0.14, tilt=tilt)) is past
    assert not holds_axle(AxialPiece(body=rod, distance=0.14, axis="along the arm"))


def test_no_piece_that_is_drawn_holds_the_axle() -> None:
    """The user may still give such a piece."""
    for index in range(100):
        scene = sample("rotation", "hard", seed=3, index=index)
        arms = [named.entity for named in scene.entities if isinstance(named.entity, WeldedArm)]
        assert not any(holds_axle(piece) for arm in arms for piece in arm.pieces)


def test_once_a_piece_is_on_the_other_side_the_next_is_told_from_the_first() -> None:
    """The phrase *the other side* would be ambiguous after two pieces on opposite sides."""

    def sides(*opposite: bool) -> list[str]:
        balls = (
            BallPiece(body=FixedBall(mass=1.0), distance=0.2 + 0.1 * n, side=OTHER_SIDE if beyond else SAME_SIDE)
            for n, beyond in enumerate(opposite)
        )
        return [piece.side for piece in RotationEntity(pieces=tuple(balls), angle=40.0).pieces]

    assert sides(False, False, True) == [FIRST, SAME_SIDE, OTHER_SIDE]
    assert sides(False, True, True, False) == [FIRST, OTHER_SIDE, UNLIKE_FIRST, LIKE_FIRST]
