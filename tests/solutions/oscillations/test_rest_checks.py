"""Tests of springs with friction: times of swings, and rest at turning points."""

import re
from math import atan, pi, sqrt

import pytest

from plain_scenes import row
from sim2reason.questions import Query, Target
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.strings import NaturalLength
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.moments.turning_points import Halted, Stopped
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.solutions import Solution, solve
from sim2reason.solutions.multipart import unify_names
from sim2reason.solutions.multipart.recall import recall_results
from sim2reason.solutions.solve import solve_prompt
from worked import derived, settings_of

G, MASS, STIFFNESS, FRICTION, SPEED, TIME = 9.8, 1.8, 132.0, 0.32, 2.0, 0.58
RATE, LIMIT = sqrt(STIFFNESS / MASS), FRICTION * MASS * G


def struck(**start: float) -> Scene:
    return row((MASS,), (STIFFNESS,), "right", friction=FRICTION, **start)  # type: ignore[arg-type]


def cart(scene: Scene, number: int = 0) -> str:
    return [body.name for body in scene.mechanism.bodies if body.mass][number]


def verified(found: Solution) -> dict[str, float]:
    """Return the values of all relations that are verified numerically, by the LaTeX code of their left sides."""
    relations = (relation for relation in found.relations if relation.role == "verified")
    return {held.left.latex(): float(held.right.value(found.values).real) for held in relations}


def turning_points() -> tuple[float, float]:
    """Return the first two turning points of a cart struck from a relaxed spring, which swings about ∓µmg/k."""
    shift = LIMIT / STIFFNESS
    first = sqrt(shift**2 + (SPEED / RATE) ** 2) - shift
    return first, 2.0 * shift - first


def test_only_the_time_between_turning_points_is_half_an_oscillation() -> None:
    """The first swing starts with a speed and takes arctan(v ω/µg)/ω, less than π/2ω."""
    scene = struck(speed=SPEED)
    found = derived(scene, Query("state", Target("displacement", cart(scene)), AtTime(TIME)))
    early = r"so $\tan\left(\omega t_1\right)"
    late = "From one moment of rest to the next it takes half an oscillation: $t_2"
    assert found.text.index(early) < found.text.index("next comes to rest, friction") < found.text.index(late)
    assert "This half oscillation" not in found.text
    assert found.values["t_1"] == pytest.approx(atan(SPEED * RATE / (FRICTION * G)) / RATE, rel=1e-9)
    assert found.values["t_2"] == pytest.approx(pi / RATE, rel=1e-9)
    assert "As $t_3 < t_2$" in found.text


def test_what_begins_at_rest_takes_half_an_oscillation_from_the_start() -> None:
    scene = struck(strain=0.2)
    found = derived(scene, Query("time_to_event", None, Halted(cart(scene))))
    assert found.text.count(r"\frac{\pi}{\omega}") == 1
    assert "Both half oscillations take the same time, so the total time is $t_1 = 2\\,t" in found.text
    assert found.answer == pytest.approx(2.0 * pi / RATE, rel=1e-8)


def test_at_each_turning_point_the_spring_is_stronger_than_friction() -> None:
    scene = struck(speed=SPEED)
    found = derived(scene, Query("state", Target("displacement", cart(scene)), AtTime(TIME)))
    first, second = turning_points()
    assert verified(found)["F_1"] == pytest.approx(STIFFNESS * first, rel=1e-9)
    assert verified(found)["F_2"] == pytest.approx(-STIFFNESS * second, rel=1e-9)
    assert verified(found)[r"f_{\text{max}}"] == pytest.approx(LIMIT, rel=1e-9)


def test_what_comes_to_rest_for_good_is_held_by_friction() -> None:
    scene = struck(strain=0.2)
    found = derived(scene, Query("event", Target("displacement", cart(scene)), Halted(cart(scene))))
    held = verified(found)
    *moving, last = (held[name] for name in sorted(held) if name.startswith("F"))
    assert all(pull > LIMIT for pull in moving)
    assert last < LIMIT
    assert "is less than $f_{\\text{max}}$, so the trolley stays at rest." in found.text
    assert "starts to move to the right" in found.text
    assert "turns back" not in found.text
    assert found.text.count("comes to rest at") == len(moving)


def test_a_body_that_never_moves_is_shown_to_stay() -> None:
    """Spring 1 pulls cart A most when cart B is farthest away, and friction can hold A even then."""
    scene = row((4.7, 3.3), (156.0, 72.0), "right", speed=1.5, friction=0.53)
    moving = cart(scene, 1)
    found = derived(scene, Query("event", Target("displacement", moving), Halted(moving)))
    rate, shift = sqrt(228.0 / 3.3), 0.53 * 3.3 * G / 228.0
    farthest = sqrt(shift**2 + (1.5 / rate) ** 2) - shift
    assert verified(found)["f_A"] == pytest.approx(156.0 * farthest, rel=1e-9)
    assert verified(found)[r"f_{\text{max},A}"] == pytest.approx(0.53 * 4.7 * G, rel=1e-9)
    assert "stays at rest: the friction required" in found.text


def test_a_distance_is_moved_before_the_first_turning_point() -> None:
    """Released from rest, the cart moves 2 (s − µmg/k) before it turns back."""
    scene = struck(strain=0.1)
    found = derived(scene, Query("time_to_event", None, Moved(cart(scene), 0.05)))
    assert verified(found)["x_1"] == pytest.approx(2.0 * (0.1 - LIMIT / STIFFNESS), rel=1e-9)
    assert "beyond $x = d_1$, so friction is constant until then." in found.text


def test_a_later_part_says_what_it_counts_from() -> None:
    """The part after the first turning point introduces a displacement from there before using it."""
    scene = struck(speed=SPEED)
    first = derived(scene, Query("time_to_event", None, Stopped(cart(scene))))
    later = derived(scene, Query("state", Target("displacement", cart(scene)), AtTime(TIME)))
    first, later = unify_names([first, later])
    text = recall_results(later, [("a", first)], whole=True).text
    assert "$t_1 = 0.16228" in text.partition("The amplitude")[0]
    assert text.index("let $s_2$ be the displacement") < text.index("at $s_2 =")
    assert "moves back" in text


def test_a_velocity_is_the_derivative_of_a_displacement_that_is_shown() -> None:
    scene = struck(speed=SPEED)
    found = derived(scene, Query("state", Target("velocity", cart(scene)), AtTime(TIME)))
    assert "let $s_3$ be the displacement to the right from here" in found.text
    shown = r"The displacement is $s_{\text{eq},3} - s_{\text{eq},3} \cos\left(\omega t_3\right)$; its derivative is $v"
    assert shown in found.text


def test_forces_that_are_compared_with_friction_have_a_direction() -> None:
    found = derived(
        struck(speed=SPEED), Query("state", Target("displacement", cart(struck(speed=SPEED))), AtTime(TIME))
    )
    assert re.search(r"The spring force here is \$F_1[^$]*\$ to the left; it exceeds", found.text)
    assert re.search(r"The spring force here is \$F_2[^$]*\$ to the right; it exceeds", found.text)


def test_the_first_time_at_rest_is_derived_from_the_velocity() -> None:
    """v cos ωt + x₀ω sin ωt = 0 gives tan ωt = −v/(ωx₀); x₀ < 0 selects the branch."""
    found = derived(
        struck(speed=SPEED), Query("state", Target("displacement", cart(struck(speed=SPEED))), AtTime(TIME))
    )
    assert (
        r"so $\tan\left(\omega t_1\right) = -\frac{v}{\omega x_0}$. As $x_0 < 0$, $\omega t_1$ is less than"
        in found.text
    )


def test_a_spring_has_its_natural_length_before_friction_changes() -> None:
    """On the way back of a struck cart, its next turning point is beyond the natural length."""
    scene = row((MASS,), (STIFFNESS,), "left", friction=FRICTION, speed=SPEED, strain=0.05)
    spring = next(line.name for line in scene.mechanism.lines)
    found = derived(scene, StretchQuery("sum", None, NaturalLength(spring), "distance travelled", cart(scene)))
    back = 2.0 * (LIMIT / STIFFNESS - 0.05 - found.values["x_1"])
    assert verified(found)[r"s_{\text{turn}}"] == pytest.approx(back, rel=1e-9)
    assert "would next come to rest at" in found.text
    assert "Part by part, the path of the trolley is $x_1$ and $x_1 - x_2$ long" in found.text


def test_what_is_assumed_of_an_unknown_is_verified_in_the_end() -> None:
    """Starting, turning back and staying at rest are compared with friction once the unknown mass is known."""
    prompt = (
        "A rough, fixed plane inclined at 60° to the horizontal carries a block (mass $m$). The block is joined to a "
        "stop at the foot of the slope by a light spring with a stiffness of 365 N/m and a natural length of 0.54 m. "
        "The coefficients of static and of kinetic friction on this plane are both 0.31. The initial length of the "
        "spring is 0.56 m. The motion starts from rest. The magnitude of the change in the block's gravitational "
        "potential energy between release and the moment when it comes to rest for good is 0.82 J. What is $m$? "
        "Use g = 9.8 m/s². State the answer in kg to three significant figures, inside \\boxed{}."
    )
    found, _ = solve_prompt(prompt)
    assert "Assume that the block starts to move down the slope and moves back at each turning point" in found.text
    told = found.text.partition(r" = 1.7035\ \text{kg}$. The other root")[2]
    assert told.count("as was assumed") == 4
    assert "it is less than $f_{\\text{max}}$, so the block stays at rest." in told


def test_the_time_that_is_left_is_compared_with_half_an_oscillation_in_the_data_too() -> None:
    """The time t + 2 t₁ has the same cosine as t − 2 t₁; only the comparison distinguishes them."""
    (setting,) = settings_of("springs-hard-choice-75-9")
    found = solve(setting)
    assert "As $t_2 < t_1$, it does not come to rest again within this time." in found.text
    compared = [(r.left.latex(), r.right.latex()) for r in found.relations if r.role == "exceeds"]
    assert ("t_1", "t_2") in compared
    assert ("t_2", "0") in compared
