"""Tests of the order of collisions: every pair that might collide earlier is excluded by an argument."""

import re
from math import cos, hypot, radians, sin

import pytest

from sim2reason.questions import Query, StatedResult, Target
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.contacts import Collided, LastCollision
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.moments.turning_points import HighestPoint
from sim2reason.scenes.bodies.blocks import Glider, Puck, Table
from sim2reason.scenes.bodies.simple_machines import Track
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.track_collisions import ComplexCollisionPlane
from sim2reason.scenes.entities.two_d_collision_plane import TwoDCollisionPlane
from sim2reason.simulation.quantities.subjects import Sense
from sim2reason.simulation.quantities.subjects.interactions import PAIR_SEPARATOR
from sim2reason.solutions import ProblemContext, Solution, solve
from sim2reason.solutions.checking import recompute
from sim2reason.solutions.data import as_data
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import faults
from worked import asked, solution_text

RADIUS = 0.1
PUCKS = [f"table.pucks.{n}" for n in range(4)]


def scene(*pucks: tuple[float, float, float, float], restitution: float = 0.5, mass: float = 1.0) -> Scene:
    """Build pucks A, B, ... on a table, each given by position and velocity."""
    held = tuple(Puck(mass=mass, x=x, y=y, vx=vx, vy=vy) for x, y, vx, vy in pucks)
    entity = TwoDCollisionPlane(table=Table(), radius=RADIUS, pucks=held, restitution=restitution)
    return Scene(entities=(Named(name="table", entity=entity),))


def solved(setting: ProblemContext) -> Solution:
    found = solve(setting)
    assert found.answer is not None, found.reason
    assert setting.answer is not None
    assert not faults(found, setting.answer, 1e-6), found.text
    assert not read(found.text).broken
    return found


def after(place: Scene, body: int, time: float) -> Solution:
    return solved(asked(place, Query("state", Target("velocity", PUCKS[body]), AtTime(time))))


A, B = (0.0, 0.02, 1.0, 0.06), (1.0, 0.05, -1.1, -0.04)  # nothing cancels
SLOW, AHEAD = (1.0, 0.05, -0.02, 0.03), (1.6, 0.15, 0.02, 0.01)


def test_a_bystander_that_passes_is_named_with_its_distance() -> None:
    """Puck C crosses the line of A and B at a distance |r × u|/|u|."""
    C = (0.3, -2.0, 0.01, 1.0)
    found = after(scene(A, B, C), 0, 1.0)
    x, y, u, v = (c - a for a, c in zip(A, C, strict=True))
    apart = abs(x * v - y * u) / hypot(u, v)
    assert found.values["b_{AC}"] == pytest.approx(apart, rel=1e-9)
    assert "the centres of the pairs AC and BC would be" in found.text
    assert "apart where closest, more than $2\\,R$" in found.text
    assert "Position and velocity of puck C relative to puck A at t = 0: $x_{AC} = x_C" in found.text
    assert "so pucks A and B meet first" in found.text
    assert "so there is no further collision before $t$" in found.text


def test_a_pair_that_would_meet_later_has_its_time() -> None:
    """Puck A would meet C when |r + u t| is twice the radius, after its collision with B."""
    found = after(scene(A, B, (2.0, 0.0, 0.0, 0.0)), 1, 0.6)
    x, y, u, v = 2.0 - A[0], -A[1], -A[2], -A[3]
    time = found.values["t_{AC}"]
    assert hypot(x + u * time, y + v * time) == pytest.approx(2.0 * RADIUS, rel=1e-9)
    assert x * u + y * v + (u * u + v * v) * time < 0.0  # they still approach
    assert "pucks A and C would meet, with their centres $2\\,R$ apart, only at" in found.text
    assert "$p_{AC} = u_{x,AC}^{2} + u_{y,AC}^{2} = " in found.text


def test_pucks_that_move_apart_are_named() -> None:
    """Puck C moves away from both others."""
    found = after(scene(A, B, (0.5, 3.0, 0.0, 1.0)), 0, 1.0)
    assert "move apart, since $q_" in found.text


def test_two_pucks_alone_need_no_argument() -> None:
    found = after(scene(A, B), 0, 1.0)
    assert all(relation.role != "exceeds" for relation in found.relations)


def test_all_collisions_before_the_moment_are_told_in_order() -> None:
    """Puck A collides only with B, but B's collision with C might send B back to A."""
    chain = scene(A, SLOW, AHEAD)
    found = after(chain, 0, 2.0)
    assert found.text.index("Pucks A and B meet when") < found.text.index("Pucks B and C meet when")
    assert re.search("After the collision of pucks B and C, [^.]*(pucks A and B|pairs AB)", found.text)


def test_the_last_collision_is_the_last_for_all_times() -> None:
    place = scene(A, SLOW, AHEAD)
    query = StretchQuery("sum", None, LastCollision(), "energy lost in collisions", "")
    found = solved(asked(place, query))
    assert "so there is no further collision." in found.text
    assert re.search("After the collision of pucks B and C, [^.]*(pucks A and B|pairs AB)", found.text)
    assert "These collisions occur" not in found.text


def test_where_a_number_is_unknown_the_arguments_follow_its_value() -> None:
    place = scene(A, SLOW, (1.2, -2.0, 0.01, 0.5))
    query = Query("state", Target("velocity", PUCKS[0]), AtTime(1.5))
    plain = asked(place, query)
    path = next(held.path for held in place.parameters if held.path.endswith("restitution"))
    stated = StatedResult(f"{plain.answer!r}", "m/s")
    found = solved(ProblemContext(place, plain.words, plain.symbols, plain.study, query, path, stated))
    assert found.answer == pytest.approx(0.5, rel=1e-6)
    assert found.text.index("the given $") < found.text.index("After the collision of pucks A and B, ")
    supposed = "This supposes that there is no further collision before $t$, which is verified below."
    assert found.text.index(supposed) < found.text.index("the given $")


def test_a_comparison_that_is_false_is_refused() -> None:
    found = after(scene(A, B, (0.3, -2.0, 0.01, 1.0)), 0, 1.0)
    data = as_data(found)
    assert not recompute(data).faults
    for step in data["steps"]:
        for relation in step["relations"]:
            if relation["role"] == "exceeds":
                relation["left"], relation["right"] = relation["right"], relation["left"]
    assert any("isn't larger" in fault for fault in recompute(data).faults)


@pytest.mark.parametrize("restitution", [0.0, 0.5])
def test_the_law_that_gives_an_impulse_is_named(restitution: float) -> None:
    met = Collided(f"{PUCKS[0]} & {PUCKS[1]}")
    query = StretchQuery("sum", None, met, "impulse of a collision", f"{PUCKS[0]} & {PUCKS[1]}")
    found = solved(asked(scene(A, B, restitution=restitution), query))
    law = "restitution along the line of centres" if restitution else "no relative velocity along the line of centres"
    assert law in found.text


def test_a_collision_without_influence_is_named() -> None:
    """Ball C hits the wall before A, which collides with B, could affect it."""
    text = solution_text("collision-hard-symbolic-301913-0")
    assert "The collision of balls A and B does not affect ball C before the moment in question." in text


def tilted() -> Scene:
    """Build pucks A, B and C on a slope, A and B colliding on their way up."""
    places = (A, B, (0.3, -2.0, 0.01, 1.0))
    held = tuple(Puck(mass=1.0, x=x, y=y, vx=vx, vy=vy + 3.0) for x, y, vx, vy in places)
    entity = TwoDCollisionPlane(table=Table(angle=20.0), radius=RADIUS, pucks=held, restitution=0.5)
    return Scene(entities=(Named(name="table", entity=entity),))


def test_no_collision_is_excluded_before_a_time_that_is_not_said_yet() -> None:
    """The time since the start is only stated after the argument."""
    text = solved(asked(tilted(), Query("time_to_event", None, HighestPoint(PUCKS[0])))).text
    assert "so there is no further collision before the moment in question" in text


def test_on_a_slope_the_velocity_up_the_slope_vanishes_at_the_top() -> None:
    up = Sense("up the slope", (0.0, cos(radians(20.0)), sin(radians(20.0))), axis="y")
    text = solved(asked(tilted(), Query("event", Target("displacement", PUCKS[0], up), HighestPoint(PUCKS[0])))).text
    assert "At the highest point of the path the velocity of puck A along y is zero." in text
    assert "be its displacement in this direction since the collision of pucks A and B; then" in text
    assert "vertical" not in text


def test_discs_that_touch_after_an_inelastic_collision_move_apart_unless_it_is_head_on() -> None:
    """Both keep their velocity perpendicular to the line of centres, which is zero in a head-on collision."""
    found = after(scene(A, B, restitution=0.0), 0, 2.0)
    assert "keep only a relative velocity perpendicular to their line of centres, which takes them apart" in found.text
    place = scene((0.02, 0.03, 0.6, 0.35), (0.92, 0.48, -0.4, -0.15), restitution=0.0)
    headlong = solve(asked(place, Query("state", Target("velocity", PUCKS[0]), AtTime(2.0))))
    assert "move on together at the same velocity" in headlong.text
    assert "move apart" not in headlong.text


def test_two_walls_are_told_apart() -> None:
    """With walls on the left and on the right, *the wall* would be ambiguous."""
    text = solution_text("collision-hard-multipart-301915-0")
    assert "moves away from the right wall" in text
    assert " hits the left wall" in text
    assert " the wall" not in text


def test_relative_motion_is_numbered_by_the_collision_after_which_it_is_told() -> None:
    """Symbols have no number at the start, 1 after the first collision, 2 after the second one."""
    found = after(scene(A, SLOW, AHEAD), 0, 2.0)
    assert "Position and velocity of puck B relative to puck A at t = 0: $x_{AB} = x_B" in found.text
    met = (
        "Position and velocity of puck C relative to puck B just after the collision of pucks A and B: $x_{BC,1} = x_C"
    )
    assert met in found.text
    assert "impulse $J_1 = " in found.text
    assert "In the same way, $J_2 = " in found.text


def test_velocities_after_a_collision_are_told_before_the_next_one_is_looked_for() -> None:
    found = after(scene(A, SLOW, AHEAD), 0, 2.0)
    told = next(part for part in found.text.split("\n\n") if part.startswith("After the impact, "))
    assert all(f"v'_{{{axis},{puck}}} = " in told for axis in "xy" for puck in "AB")
    assert found.text.index(told) < found.text.index("just after the collision of pucks A and B")


def test_on_a_slope_relative_velocities_are_those_just_after_the_collision() -> None:
    """Gravity since the start of the motion cancels in relative velocities."""
    held = tuple(Puck(mass=1.0, x=x, y=y, vx=vx, vy=vy) for x, y, vx, vy in (A, SLOW, AHEAD))
    entity = TwoDCollisionPlane(table=Table(angle=20.0), radius=RADIUS, pucks=held, restitution=0.5)
    place = Scene(entities=(Named(name="table", entity=entity),))
    found = after(place, 0, 2.0)
    relative = [r for r in found.relations if r.left.latex().startswith(("x_{", "y_{", "u_{"))]
    assert any(r.left.latex() == "u_{y,AB,2}" for r in relative)
    assert all("g" not in r.right.symbols() for r in relative)


def carts(*held: tuple[float, float, float], left: float | None = None, restitution: float = 1.0) -> Scene:
    """Build carts on a track by mass, position and velocity, optionally with a wall at `left`."""
    gliders = tuple(Glider(mass=m, x=x, v=v) for m, x, v in held)
    entity = ComplexCollisionPlane(track=Track(), gliders=gliders, left=left, restitution=restitution)
    return Scene(entities=(Named(name="track", entity=entity),))


def test_on_which_side_a_distance_is_reached_is_said() -> None:
    """Cart B first moves to the left, by less than the asked distance; the collision sends it to the right."""
    place = carts((9.9, -1.43, 2.48), (6.9, -0.85, -0.78))
    found = solved(asked(place, Query("time_to_event", None, Moved("track.gliders.1", 1.5))))
    assert "never as far as $d$ from its start; then it moves to the right. The two do not meet again" in found.text
    assert "is the distance $d$ from its starting point when $s_B + v'_B t_1 = d$" in found.text


def test_who_collides_after_a_rebound_is_shown_by_how_fast_they_approach() -> None:
    place = carts((3.1, -1.96, -1.69), (1.2, -1.59, 0.10), left=-2.11, restitution=0.34)
    first, second = (f"track.gliders.{n}" for n in range(2))
    moment = Collided(PAIR_SEPARATOR.join((first, second)), after=True)
    found = solved(asked(place, Query("event", Target("velocity", first), moment)))
    assert "approach each other at $u_{AB,1} = v'_A - v_B = 0.47460" in found.text
    assert "; nothing else collides before they do." in found.text
    assert "$e = 1.00$ (elastic)" not in found.text


def test_an_elastic_collision_is_the_reason_for_its_coefficient() -> None:
    found = solved(
        asked(
            carts((9.9, -1.43, 2.48), (6.9, -0.85, -0.78)), Query("time_to_event", None, Moved("track.gliders.1", 1.5))
        )
    )
    assert "$e = 1.00$ (elastic)" in found.text


def test_times_at_which_bodies_would_meet_all_count_from_the_start() -> None:
    """A and B would meet 0.725 s after the first collision, at 0.934 s; A hits the wall before, at 0.919 s."""
    text = solution_text("collision-hard-multipart-301927-0")
    assert "would meet only at $t_{AB,1} = t + \\frac{d_{AB,1}}{u_{AB,1}} = 0.93420" in text
    assert "= 0.91935\\ \\text{s}$, counted from t = 0." in text
    later = solution_text("collision-hard-choice-301929-0")
    assert "would meet only at $t_{BC,2} = t_3 + \\frac{d_{BC,2}}{u_{BC,2}} = 5.4223" in later


def test_what_collides_later_undisturbed_does_not_come_first() -> None:
    """Ball A moves towards the left wall, but B and C meet before A reaches it."""
    text = solution_text("collision-hard-multipart-301927-0")
    first = next(part for part in text.split("\n\n") if part.startswith("Undisturbed"))
    assert "ball A, $d_A = x_A - X_1 = 1.1400" in first
    assert "would reach the left wall only at $t_A = \\frac{d_A}{u_A} = 0.91935" in first
    assert first.endswith("so balls B and C meet first.")


def test_what_collides_later_is_told_where_no_times_of_collisions_are() -> None:
    """The later collision of B and C is stated: they approach each other already when A meets the wall again."""
    text = solution_text("collision-hard-multipart-301927-0").partition("\n\n(b) ")[2].partition("\n\n(c) ")[0]
    assert "would meet only at $t_{BC,3} = t_3 + " in text
    assert "move apart" not in text, "part (a) has told that"
