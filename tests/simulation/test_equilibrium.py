"""Tests of equilibria against closed forms, and against the search for all equilibria."""

from collections.abc import Callable
from itertools import product
from math import cos, hypot, isclose, pi, radians, sin, sqrt

import numpy as np
import pytest

from motions import charge, driven_charge, orbit, pushed_block, rocket, rod_pendulum, rolling_ball
from places_of_rest import equilibria
from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.generation.item_search import generator
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions.difficulty import DIFFICULTIES
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.fields import Profile, Push
from sim2reason.scenes.dsl.mechanism import GRAVITY, ZERO, Mechanism, X, Y, Z
from sim2reason.simulation.equilibrium import equilibrium, neighbour, unique_equilibrium
from spring_slopes import spring_slope

G = GRAVITY
SEEDS = range(4)


def two_loads(first: float, second: float, middle: float = 2.0) -> Mechanism:
    """Build a slider on a level guide between two strings to loads, over small pulleys 2 m apart and 1 m up."""
    builder = Builder()
    room = builder.room().site("left", (-1.0, 0.0, 1.0)).site("right", (1.0, 0.0, 1.0))
    room.body("slider", middle).slide(X).site("ring")
    for name, mass, x in (("left", first, -2.0), ("right", second, 2.0)):
        room.body(f"{name}.load", mass, at=(x, 0.0, -3.0)).slide(Z).site(f"{name}.hook")
        room.site(f"{name}.out", (x, 0.0, 1.0))
        room.string(f"{name}.string", "ring", name, f"{name}.out", f"{name}.hook")
    return builder.finish()


@pytest.mark.parametrize("seed", SEEDS)
def test_a_slider_between_two_loads(seed: int) -> None:
    """Equilibrium along the guide is m₁ cos α = m₂ cos β, and each string carries its load's weight."""
    first, second = np.random.default_rng(seed).uniform(1.0, 1.6, 2).tolist()
    rest = equilibrium(two_loads(first, second))
    assert rest is not None
    x = float(rest.coordinates[0])
    assert isclose(first * (x + 1.0) / hypot(x + 1.0, 1.0), second * (1.0 - x) / hypot(1.0 - x, 1.0), rel_tol=1e-8)
    assert rest.state.tension["left.string"][0] == pytest.approx(first * G)
    assert rest.state.tension["right.string"][0] == pytest.approx(second * G)
    assert unique_equilibrium(rest.mechanism) is rest
    assert not rest.linear


def test_a_block_on_a_wedge_that_a_spring_holds() -> None:
    """The forces are kx = mg sin θ, N₁ = mg cos θ, N₂ = (M + m) g; the free wedge may be anywhere."""
    slope = radians(25.0)
    up, out = (cos(slope), 0.0, sin(slope)), (-sin(slope), 0.0, cos(slope))
    builder = Builder()
    wedge = builder.room().body("wedge", 5.0).rest(X, Z).site("stop")
    wedge.body("block", 2.0, at=(up[0], 0.0, up[2])).rest(up, out).site("eye")
    wedge.spring("spring", "stop", "eye", stiffness=90.0, length=1.0)
    rest = equilibrium(builder.finish())
    assert rest is not None
    assert rest.free == 1
    assert rest.linear
    assert rest.state.tension["spring"][0] == pytest.approx(-2.0 * G * sin(slope))
    assert rest.state.normal["block"][0] == pytest.approx(2.0 * G * cos(slope))
    assert rest.state.normal["wedge"][0] == pytest.approx(7.0 * G)


def test_a_roller_with_its_weight_on_one_side_rests_on_a_slope() -> None:
    """With the centre of mass above the point of contact, d sin φ = R sin α; friction is mg sin α up the slope."""
    slope, radius, d = radians(6.0), 0.2, 0.05
    up, out = (cos(slope), 0.0, sin(slope)), (-sin(slope), 0.0, cos(slope))
    builder = Builder()
    roller = builder.room().body("roller", 3.0, center=(0.0, 0.0, -d), inertia=(0.0, 0.05, 0.0, 0.0, 0.0, 0.0))
    roller.roll(up, out, radius)
    rest = equilibrium(builder.finish())
    assert rest is not None
    assert d * sin(abs(rest.coordinates[1])) == pytest.approx(radius * sin(slope))
    assert rest.coordinates[0] == pytest.approx(radius * rest.coordinates[1])
    assert rest.state.friction["roller"][0] == pytest.approx(3.0 * G * sin(slope))
    assert rest.state.normal["roller"][0] == pytest.approx(3.0 * G * cos(slope))
    assert unique_equilibrium(rest.mechanism) is rest


def test_a_charge_that_a_field_deflects() -> None:
    """A charged bob on a string in a horizontal field has tan θ = qE/(mg), S = √((mg)² + (qE)²)."""
    builder = Builder()
    room = builder.room().site("nail")
    bob = room.body("bob", 0.2, at=(0.0, 0.0, -1.0)).slide(X, name="x").slide(Z, name="y").site("hook")
    room.string("string", "nail", "hook")
    bob.force("field", Push(X, Profile(1.1)))
    rest = equilibrium(builder.finish())
    assert rest is not None
    x, z = rest.coordinates[0], -1.0 + rest.coordinates[1]
    assert x / -z == pytest.approx(1.1 / (0.2 * G))
    assert rest.state.tension["string"][0] == pytest.approx(hypot(1.1, 0.2 * G))


def test_a_string_may_hang_slack() -> None:
    """A spring holds a load higher than the taut string would."""
    builder = Builder()
    room = builder.room().site("support")
    room.body("load", 1.0, at=(0.0, 0.0, -1.0)).slide(Z, limits=(-5.0, 0.5)).site("hook")
    room.string("string", "support", "hook")
    room.spring("spring", "support", "hook", stiffness=100.0, length=0.5)
    rest = equilibrium(builder.finish())
    assert rest is not None
    assert rest.active == ()
    assert rest.state.tension["string"][0] == 0.0
    assert 1.0 - rest.coordinates[0] == pytest.approx(0.5 + G / 100.0)


def test_two_strings_that_share_a_weight_leave_it_open_how() -> None:
    """The tensions of parallel strings are NaN, the position is known."""
    builder = Builder()
    room = builder.room().site("top").site("floor", (0.0, 0.0, -2.0))
    room.body("load", 1.0, at=(0.0, 0.0, -1.0)).slide(X, name="x").slide(Z, name="y").site("hook")
    room.string("one", "top", "hook")
    room.string("two", "top", "hook")
    room.spring("spring", "floor", "hook", stiffness=50.0, length=0.8)
    rest = equilibrium(builder.finish())
    assert rest is not None
    assert np.isnan([rest.state.tension["one"][0], rest.state.tension["two"][0]]).all()


@pytest.mark.parametrize("angle", [5.0, 90.0, 120.0, 179.0])
def test_a_pendulum_comes_to_rest_below_from_anywhere(angle: float) -> None:
    """The result is never the unstable equilibrium above."""
    rest = equilibrium(rod_pendulum(angle).mechanism)
    assert rest is not None
    assert abs(rest.coordinates[0]) == pytest.approx(radians(angle))
    assert unique_equilibrium(rest.mechanism) is rest


def test_a_bead_between_two_pressed_springs_has_two_places() -> None:
    """Both positions ±√(l² − w²) are stable, so neither is unique."""
    builder = Builder(gravity=ZERO)
    room = builder.room().site("left", (-0.3, 0.0, 0.0)).site("right", (0.3, 0.0, 0.0))
    room.body("bead", 0.1, at=(0.0, 0.0, 0.1)).slide(Z).site("ring")
    for side in ("left", "right"):
        room.spring(f"{side}.spring", side, "ring", stiffness=10.0, length=0.5)
    rest = equilibrium(builder.finish())
    assert rest is not None
    assert 0.1 + rest.coordinates[0] == pytest.approx(sqrt(0.5**2 - 0.3**2))
    assert unique_equilibrium(rest.mechanism) is None


def test_a_second_place_to_which_few_ways_lead_is_found() -> None:
    """One in eight starts of a block on three springs leads to the second stable equilibrium."""
    builder = Builder(gravity=ZERO)
    room = builder.room()
    room.body("block", 9.2, at=(-0.3, 0.0, 0.0)).slide(X, name="x").slide(Y, name="y").site("hook")
    nails = ((127.0, 0.31, 0.88, 0.41), (64.0, 0.54, 0.04, -0.87), (117.0, 0.87, 0.71, -0.15))
    for number, (stiffness, length, x, y) in enumerate(nails):
        room.site(f"nail{number}", (x, y, 0.0))
        room.spring(f"spring{number}", f"nail{number}", "hook", stiffness=stiffness, length=length)
    mechanism = builder.finish()
    rest = equilibrium(mechanism)
    assert rest is not None
    assert rest.coordinates - (0.3, 0.0) == pytest.approx((0.30194, 0.22519), abs=1e-5)
    assert sum(other.stable for other in equilibria(mechanism)) == 2
    assert unique_equilibrium(mechanism) is None


def _balanced() -> Mechanism:
    builder = Builder()
    room = builder.room()
    wheel = room.pulley("wheel", radius=1.0)
    for side, x in (("left", -1.0), ("right", 1.0)):
        room.body(side, 1.0, at=(x, 0.0, -1.0)).slide(Z).site(f"{side}.hook")
    room.string("string", "left.hook", wheel, "right.hook")
    return builder.finish()


def _upright() -> Mechanism:
    builder = Builder()
    builder.room().body("bob", 1.0, center=(0.0, 0.0, 1.0)).hinge(Y)
    return builder.finish()


def _drawn_away() -> Mechanism:
    """Build two carts on a spring, with a force on one and hence no equilibrium."""
    builder = Builder()
    room = builder.room()
    first = room.body("a", 1.0).rest(X, Z).site("a.hook")
    room.body("b", 1.0, at=(1.0, 0.0, 0.0)).rest(X, Z).site("b.hook")
    room.spring("spring", "a.hook", "b.hook", stiffness=50.0, length=1.0)
    first.force("push", Push(X, Profile(2.0)))
    return builder.finish()


def _past_the_pulley() -> Mechanism:
    """Build a block on a soft spring and a string over a pulley 0.1 m away, with equilibrium beyond the pulley."""
    builder = Builder()
    room = builder.room().site("wall", (-1.0, 0.0, 0.0)).site("in", (0.1, 0.0, 0.0)).site("out", (0.3, 0.0, 0.0))
    room.body("block", 1.0).rest(X, Z).site("eye").site("hook")
    room.body("load", 1.0, at=(0.3, 0.0, -1.0)).slide(Z).site("clasp")
    room.spring("spring", "wall", "eye", stiffness=20.0, length=1.0)
    room.string("string", "hook", "in", "out", "clasp")
    return builder.finish()


def _lifted() -> Mechanism:
    """Build a block on a floor, which springs would lift although the floor cannot pull."""
    builder = Builder()
    room = builder.room().site("wall", (-1.0, 0.0, 1.0)).site("beam", (1.0, 0.0, 3.0))
    room.body("block", 0.1).rest(X, Z).site("eye")
    room.spring("one", "wall", "eye", stiffness=20.0, length=0.5)
    room.spring("two", "beam", "eye", stiffness=20.0, length=0.5)
    return builder.finish()


@pytest.mark.parametrize(
    "mechanism",
    [
        pytest.param(lambda: pushed_block().mechanism, id="friction holds it, and a force grows"),
        pytest.param(lambda: rolling_ball().mechanism, id="friction"),
        pytest.param(lambda: orbit().mechanism, id="an orbit"),
        pytest.param(lambda: rocket().mechanism, id="a rocket"),
        pytest.param(lambda: charge().mechanism, id="a field with an end"),
        pytest.param(lambda: driven_charge().mechanism, id="a field that drives away"),
        pytest.param(_balanced, id="at rest anywhere"),
        pytest.param(_upright, id="on its head"),
        pytest.param(_drawn_away, id="drawn away"),
        pytest.param(_past_the_pulley, id="beyond the pulley"),
        pytest.param(_lifted, id="off its face"),
    ],
)
def test_what_has_no_place_of_rest_to_name(mechanism: Callable[[], Mechanism]) -> None:
    assert equilibrium(mechanism()) is None
    assert unique_equilibrium(mechanism()) is None


@pytest.mark.parametrize(("recipe", "count"), [("chain", 4), ("mixed", 4), ("pendulum", 4), ("springs", 16)])
def test_it_is_one_of_all(recipe: str, count: int) -> None:
    """The equilibrium is one of the stable ones from the independent search over all positions."""
    seen = 0
    for difficulty, index in product(DIFFICULTIES, range(count)):
        try:
            mechanism = RECIPES[recipe](difficulty, generator(recipe, difficulty, "numeric", 3, index, 0)).mechanism
            rest = equilibrium(mechanism)
            others = equilibria(mechanism) if rest is not None and not rest.free else ()
        except (SceneError, SimulationError, UnsupportedError):
            continue
        if rest is None or not others:
            continue
        stable = [other for other in others if other.stable]
        apart = [
            max(
                abs((value - float(rest.coordinates[number]) + pi) % (2.0 * pi) - pi)
                for number, value in enumerate(other.coordinates.values())
            )
            for other in stable
        ]
        assert min(apart) < 1e-6
        if unique_equilibrium(mechanism) is not None and not rest.linear:
            assert len(stable) == 1
        seen += 1
    assert seen


def test_a_neighbour_keeps_every_string_as_long_as_it_was() -> None:
    rest = equilibrium(two_loads(1.2, 1.5))
    assert rest is not None
    places = neighbour(rest, np.array([0.05, 0.0, 0.0]))
    x = float(places[0])
    for side, number in ((-1.0, 1), (1.0, 2)):
        gone = hypot(side - x, 1.0) - sqrt(2.0)
        assert places[number] == pytest.approx(gone)


def test_a_place_far_away_to_which_a_wheel_turns_many_times() -> None:
    """The spring is stretched by x = (m_B − m_A sin θ) g/k, here 1.15 m over a wheel that turns by 27 rad."""
    scene = spring_slope(stiffness=34.0)
    rest = equilibrium(scene.mechanism)
    assert rest is not None
    pulled = (4.7 - 2.3 * sin(radians(18.0))) * 9.8 / 34.0
    assert float(np.abs(rest.coordinates[0])) == pytest.approx(0.45 + pulled - 0.2, rel=1e-9)
    assert float(np.abs(rest.coordinates).max()) > 20.0
