"""Tests of the search for all equilibria, against textbook results."""

from collections.abc import Callable
from math import acos, cos, degrees, hypot, isclose, pi, radians, sin, sqrt

import pytest

from places_of_rest import equilibria
from sim2reason.errors import SimulationError, UnsupportedError
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import GRAVITY, X, Y, Z

G = GRAVITY


def test_three_weights_over_two_pegs() -> None:
    """Weights 3, 4, 5 have a right triangle of forces (Lami): the angles to the vertical have sines 3/5 and 4/5."""
    builder = Builder()
    room = builder.room()
    room.site("left", (-0.5, 0.0, 0.0)).site("right", (0.5, 0.0, 0.0))
    room.body("knot", 5.0, at=(0.1, 0.0, -0.3)).slide(X, name="across").slide(Z, name="rise").site("ring")
    for name, mass, x in (("left", 3.0, -0.6), ("right", 4.0, 0.6)):
        room.body(f"{name}.load", mass, at=(x, 0.0, -2.0)).slide(Z).site(f"{name}.hook")
        room.site(f"{name}.out", (x, 0.0, 0.0))
        room.string(f"{name}.string", "ring", name, f"{name}.out", f"{name}.hook")
    (rest,) = equilibria(builder.finish())
    x, z = 0.1 + rest.coordinates["knot.across"], -0.3 + rest.coordinates["knot.rise"]
    assert rest.stable
    assert isclose(hypot(x + 0.5, z), 0.8, rel_tol=1e-9)  # a right angle over the 1 m between the pegs; the string
    assert isclose(hypot(x - 0.5, z), 0.6, rel_tol=1e-9)  # of 3 kg has cos 3/5 to the vertical, a height of 0.48 m
    assert isclose(rest.tensions["left.string"], 3.0 * G, rel_tol=1e-9)
    assert isclose(rest.tensions["right.string"], 4.0 * G, rel_tol=1e-9)


def test_a_pendulum_rests_below_and_stands_above_its_pivot() -> None:
    """The potential energy −mgl cos θ has a minimum at θ = 0, a maximum at π."""
    builder = Builder()
    start = radians(40.0)
    bob = builder.room().body("bob", 2.0, center=(1.5 * sin(start), 0.0, -1.5 * cos(start)))
    bob.hinge((0.0, -1.0, 0.0))
    below, above = equilibria(builder.finish())
    assert (below.stable, above.stable) == (True, False)
    assert isclose(below.coordinates["bob.hinge"], -start, rel_tol=1e-9)
    assert isclose(cos(above.coordinates["bob.hinge"] + start), -1.0, rel_tol=1e-9)


def test_a_load_hangs_from_a_spring_or_stands_on_it() -> None:
    """The spring is stretched by mg/k below its support, or compressed by mg/k above it, which is unstable."""
    builder = Builder()
    room = builder.room().site("support")
    room.body("load", 0.5, at=(0.2, 0.0, -0.7)).slide(X, name="across").slide(Z, name="rise").site("hook")
    room.spring("spring", "support", "hook", stiffness=40.0, length=0.6)
    below, above = equilibria(builder.finish())
    heights = [-0.7 + rest.coordinates["load.rise"] for rest in (below, above)]
    assert (below.stable, above.stable) == (True, False)
    assert isclose(heights[0], -(0.6 + 0.5 * G / 40.0), rel_tol=1e-9)
    assert isclose(heights[1], 0.6 - 0.5 * G / 40.0, rel_tol=1e-9)
    assert isclose(below.tensions["spring"], 0.5 * G, rel_tol=1e-9)
    assert isclose(above.tensions["spring"], -0.5 * G, rel_tol=1e-9)


def test_a_bead_on_a_rod_between_springs_snaps_to_either_side() -> None:
    """With springs of length l > w between walls 2w apart, the middle is unstable and ±√(l² − w²) are stable."""
    builder = Builder(gravity=(0.0, 0.0, 0.0))
    room = builder.room().site("left", (-0.3, 0.0, 0.0)).site("right", (0.3, 0.0, 0.0))
    room.body("bead", 0.1, at=(0.0, 0.0, 0.1)).slide(Z, limits=(-2.0, 2.0)).site("ring")
    for side in ("left", "right"):
        room.spring(f"{side}.spring", side, "ring", stiffness=10.0, length=0.5)
    found = equilibria(builder.finish())
    heights = {round(0.1 + rest.coordinates["bead.slide"], 9): rest.stable for rest in found}
    aside = round(sqrt(0.5**2 - 0.3**2), 9)
    assert heights == {aside: True, -aside: True, 0.0: False}


def test_a_string_may_hang_slack_at_rest() -> None:
    """A spring holds a load higher than the taut string would, with tension 0 and the whole weight on the spring."""
    builder = Builder()
    room = builder.room().site("support")
    room.body("load", 1.0, at=(0.0, 0.0, -1.0)).slide(Z, limits=(-5.0, 0.5)).site("hook")
    room.string("string", "support", "hook")
    room.spring("spring", "support", "hook", stiffness=100.0, length=0.5)
    rest, *_ = equilibria(builder.finish())
    assert isclose(1.0 - rest.coordinates["load.slide"], 0.5 + G / 100.0, rel_tol=1e-9)
    assert rest.tensions["string"] == 0.0
    assert isclose(rest.tensions["spring"], G, rel_tol=1e-9)


def test_a_ball_leans_on_a_plane() -> None:
    """A block on a smooth incline, held by a spring along it, has kx = mg sin α, N = mg cos α."""
    angle = radians(30.0)
    up, out = (cos(angle), 0.0, sin(angle)), (-sin(angle), 0.0, cos(angle))
    builder = Builder()
    room = builder.room()
    room.site("top", (2.0 * up[0], 0.0, 2.0 * up[2]))
    room.body("block", 3.0).rest(up, out).site("eye")
    room.spring("spring", "top", "eye", stiffness=200.0, length=1.5)
    rest, *_ = [found for found in equilibria(builder.finish()) if found.stable]
    assert isclose(2.0 - rest.coordinates["block.slide"], 1.5 + 3.0 * G * sin(angle) / 200.0, rel_tol=1e-9)
    assert isclose(rest.normal[0], 3.0 * G * cos(angle), rel_tol=1e-9)


def test_angles_of_a_triangle_of_forces() -> None:
    """Strings that pull with m₁g and m₂g on Mg have cos = (M² − m₁² − m₂²)/(2 m₁ m₂) between them (Lami)."""
    first, second, middle = 2.0, 3.0, 4.0
    builder = Builder()
    room = builder.room().site("left", (-0.4, 0.0, 0.1)).site("right", (0.7, 0.0, 0.0))
    room.body("knot", middle, at=(0.0, 0.0, -0.5)).slide(X, name="across").slide(Z, name="rise").site("ring")
    for name, mass in (("left", first), ("right", second)):
        room.pull(f"{name}.string", "ring", name, force=mass * G)
    rest, *_ = equilibria(builder.finish())
    x, z = rest.coordinates["knot.across"], -0.5 + rest.coordinates["knot.rise"]
    one, other = (-0.4 - x, 0.1 - z), (0.7 - x, -z)
    cosine = (one[0] * other[0] + one[1] * other[1]) / (hypot(*one) * hypot(*other))
    expected = (middle**2 - first**2 - second**2) / (2.0 * first * second)
    assert isclose(degrees(acos(cosine)), degrees(acos(expected)), rel_tol=1e-9)


def _atwood(builder: Builder) -> None:
    room = builder.room()
    wheel = room.pulley("wheel", radius=1.0)
    for side, x in (("left", -1.0), ("right", 1.0)):
        room.body(side, 1.0, at=(x, 0.0, -1.0)).slide(Z).site(f"{side}.hook")
    room.string("string", "left.hook", wheel, "right.hook")


def _falling(builder: Builder) -> None:
    builder.room().body("ball", 1.0).slide(Z)


def _rough(builder: Builder) -> None:
    builder.room().body("block", 1.0).rest(X, Z, friction=0.2)


@pytest.mark.parametrize(
    ("make", "error", "word"),
    [
        (_atwood, UnsupportedError, "without any force"),
        (_falling, SimulationError, "no equilibrium"),
        (_rough, UnsupportedError, "friction"),
    ],
)
def test_what_has_no_single_place_of_rest_is_refused(
    make: Callable[[Builder], None], error: type[Exception], word: str
) -> None:
    builder = Builder()
    make(builder)
    with pytest.raises(error, match=word):
        equilibria(builder.finish())


def test_turning_right_round_is_the_same_place() -> None:
    """Hinge angles are compared modulo a turn, so a rod about its end has only two equilibria."""
    builder = Builder()
    rod = builder.room().body("rod", 1.0, center=(0.5, 0.0, 0.0), inertia=(0.0, 1.0 / 12.0, 1.0 / 12.0, 0.0, 0.0, 0.0))
    rod.hinge(Y)
    found = equilibria(builder.finish())
    assert sorted(round(abs(rest.coordinates["rod.hinge"]) % pi, 6) for rest in found) == [round(pi / 2, 6)] * 2
