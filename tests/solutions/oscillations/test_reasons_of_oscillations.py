"""Tests of the reasons in solutions for oscillations: half periods, initial directions, and points on the way."""

import re
from dataclasses import replace

import pytest

from plain_scenes import row
from sim2reason.questions import Formula, Query, Target
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.strings import NaturalLength
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.moments.turning_points import Halted, Stopped
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.solutions import Solution, solve
from sim2reason.testing.solution_text import read
from worked import asked, derived, solution_text

CART, SPRING = "row.carts.0", "row.springs.0"


def rubbing(strain: float = 0.2, tilt: float = 0.0) -> Scene:
    return row((1.8,), (132.0,), "right", strain=strain, friction=0.32, tilt=tilt)


def spring(scene: Scene) -> str:
    return scene.mechanism.lines[0].name


def verified(found: Solution) -> dict[str, float]:
    relations = (relation for relation in found.relations if relation.role == "verified")
    return {held.left.latex(): float(held.right.value(found.values).real) for held in relations}


def test_a_swing_says_which_way_friction_acts_and_that_it_is_half_an_oscillation() -> None:
    text = derived(rubbing(), Query("event", Target("displacement", CART), Halted(CART))).text
    assert r"constant friction $\mu m g$ acts to the left" in text
    assert "half an oscillation, symmetric about the point at which the net force is zero" in text
    assert text.index("half an oscillation") < text.index("first comes to rest at")
    assert "next comes to rest, friction acts to the right; let" in text
    assert "The equilibrium is at" not in text  # no body would stay there


def test_a_speed_is_no_modulus_of_a_negative_velocity() -> None:
    scene = row((1.8,), (132.0,), "left", strain=0.2, friction=0.32)
    query = StretchQuery("extremum", None, Stopped(CART), "greatest speed", CART)
    found = derived(scene, query)
    assert r"\left|" not in found.text
    assert "with the velocity $-v$ along $x$" in found.text
    assert "Friction makes each swing smaller" not in found.text  # there is no other swing in question


def test_the_place_of_the_greatest_speed_is_before_the_natural_length() -> None:
    scene = rubbing()
    query = StretchQuery("extremum", None, NaturalLength(spring(scene)), "greatest speed", CART)
    found = derived(scene, query)
    assert found.strategy == "energy"
    assert "This point is passed before the spring has its natural length" in found.text
    assert verified(found)[r"x_{\text{end}}"] == pytest.approx(0.2)


def test_what_starts_from_rest_says_which_way_it_begins() -> None:
    scene = row((2.0,), (50.0,), "left", strain=0.3)
    found = derived(scene, Query("time_to_event", None, Stopped(CART)))
    assert "sets the trolley in motion to the left" in found.text
    assert verified(found)["F_0"] == pytest.approx(15.0)
    assert "The trolley turns back when" in found.text


def test_modes_are_told_to_be_orthogonal_before_they_are_used() -> None:
    scene = row((2.3, 2.2), (79.0, 93.0), "right", speed=1.4)
    cart = [body.name for body in scene.mechanism.bodies if body.mass][-1]
    text = derived(scene, Query("state", Target("velocity", cart), AtTime(0.3))).text
    assert text.index("Normal modes are orthogonal, $m") < text.index("effective mass of mode 1")
    assert "so that the displacements from the start are $x_B = r_1\\,q_1 + q_2$ and $x_A = q_1 + r_2\\,q_2$." in text


@pytest.mark.parametrize("number", [1, 2])
def test_each_mode_has_an_equation_of_motion_that_its_displayed_solution_fulfils(number: int) -> None:
    """Finite differences show that the stated solution of each mode fulfils its stated equation of motion."""
    scene = row((2.3, 2.2), (79.0, 93.0), "right", speed=1.4, strain=0.2)
    cart = [body.name for body in scene.mechanism.bodies if body.mass][-1]
    found = derived(scene, Query("state", Target("velocity", cart), AtTime(0.3)))
    told = re.search(
        rf"The equation of motion of mode {number} is \$(?P<left>[^$=]*) = (?P<right>[^$]*)\$, and its solution with "
        rf"\$q_{number} = 0\$ and \$\\dot{{q}}_{number} = (?P<rate>[^$]*)\$ at \$t = 0\$ is "
        rf"\$q_{number} = (?P<q>[^$]*)\$",
        found.text,
    )
    assert told is not None, found.text

    def value(formula: str, **more: float) -> float:
        held = formula.replace(rf"\ddot{{q}}_{number}", "z")
        return read(f"$y = {held}$", {**found.values, **more}).values["y"]

    step, time = 1e-4, 0.07
    early, now, late = (value(told["q"], t=time + n * step) for n in (-1, 0, 1))
    bent = (early - 2.0 * now + late) / step**2
    assert value(told["left"], z=bent) == pytest.approx(value(told["right"], **{f"q_{number}": now}), rel=1e-5)
    assert value(told["q"], t=0.0) == pytest.approx(0.0, abs=1e-12)
    assert value(told["q"], t=1e-6) / 1e-6 == pytest.approx(value(told["rate"]), rel=1e-4)


def test_displacements_are_no_longer_called_deviations_from_equilibrium() -> None:
    scene = row((2.3, 2.2), (79.0, 93.0), "right", speed=1.4)
    cart = [body.name for body in scene.mechanism.bodies if body.mass][-1]
    text = derived(scene, Query("state", Target("velocity", cart), AtTime(0.3))).text
    assert "the deviations of $x_B$ and $x_A$ from equilibrium are in the ratio" in text


def test_a_string_in_an_oscillation_is_shown_to_stay_taut() -> None:
    text = solution_text("mixed-easy-multipart-301914-0")
    assert "sets block A in motion to the right" in text
    assert "stays taut. Its tension is at least $T_{\\text{min}} = " in text
    assert "It turns back" not in text


def test_a_relative_motion_turns_back_before_a_cart_comes_to_rest() -> None:
    text = solution_text("chain-easy-numeric-301914-2")
    assert "the relative velocity is zero where" in text
    assert "This is the negative root, as $x$ decreases at first." in text
    assert "Until then cart A is faster, so it has not come to rest before." in text


def test_the_kinetic_energy_of_a_box_is_written_before_its_effective_mass() -> None:
    text = solution_text("box-easy-symbolic-301914-0")
    assert r"to the right is $\frac{m_A}{M + m_A + m_B} \dot{x}$. With $V$ for this velocity" in text
    assert text.index("the total kinetic energy is") < text.index("effective mass")
    assert r"-\left(-" not in text


def test_friction_has_the_first_direction_until_the_first_rest_alone() -> None:
    text = solution_text("springs-hard-numeric-301930-0")
    assert "Until the crate first comes to rest, friction acts up the slope." in text


def test_a_natural_length_is_assumed_to_be_reached_before_friction_turns() -> None:
    text = solution_text("springs-hard-symbolic-301928-0")
    assert "Assume that the block gets to $x$ before it first comes to rest." in text
    assert r"The spring has its natural length when $x = x_0 - x_0\,\cos" in text


def test_a_dashpot_is_no_part_of_its_spring_and_a_negative_pull_is_a_push() -> None:
    text = solution_text("springs-hard-numeric-301928-0")
    begin, end = "Spring 1 and its dashpot together pull with the force $F_1 = ", "$, a negative value being a push."
    assert text.count(end) == 1
    assert text.partition(begin)[2].partition(end)[0].endswith(r"= -63.913\ \text{N}")


def test_the_half_oscillations_that_take_the_same_time_are_those_before_the_last_one() -> None:
    text = solution_text("springs-hard-choice-301929-0")
    assert "The first two half oscillations take the same time, so the remaining time is" in text
    assert "The net force is proportional to the displacement from the point where it is zero" in text


def test_in_equilibrium_the_net_force_is_zero_whatever_acts() -> None:
    """Only springs act on a smooth horizontal track, and one of them was strained at first."""
    text = solution_text("chain-medium-choice-301930-0")
    assert "In equilibrium the net force on each body is zero: " in text


def test_on_a_rough_track_displacements_count_from_where_the_net_force_is_zero() -> None:
    """The point where friction and spring force cancel isn't called an equilibrium, as friction at rest is static."""
    text = solution_text("chain-medium-multipart-301930-0")
    assert "The displacement from the point at which the net force is zero is $A \\cos(\\omega t - \\varphi)$" in text
    assert "equilibrium" not in text


def test_a_displacement_without_the_common_motion_is_told_to_be_that() -> None:
    """At 1.0 s cart A is 0.42 m from its starting point, but the modes contribute only 0.07 m of that."""
    text = solution_text("chain-hard-choice-301926-1")
    assert "The displacement of cart A, apart from the common motion, is $c_2" in text
    assert "accelerations; in what follows, displacements are those apart from it." in text


def test_a_side_that_was_assumed_is_the_only_one_that_the_given_time_allows() -> None:
    text = solution_text("chain-medium-reverse-301926-0")
    told = "Indeed $x_0 > 0$, as was assumed; on the other side of $x_0 = 0$, $\\omega t_1$ would be less than"
    assert told in text


def test_a_slower_cart_still_reaches_the_place_before_it_comes_to_rest() -> None:
    """At half the speed the cart would come to rest at 0.0648 m, hardly beyond 0.064 m."""
    part = solution_text("chain-medium-multipart-301930-0").partition("\n\n(c) ")[2]
    assert "With $v$ halved, $x_{1,\\text{new}} = x_0 + " in part
    assert "= 0.064812\\ \\text{m}$ still exceeds $d_1$." in part


def test_a_later_part_does_not_begin_with_there() -> None:
    part = solution_text("chain-medium-multipart-301930-0").partition("\n\n(b) ")[2]
    assert "At the moment in question $x$ increases at the rate $v_1 = " in part


def test_what_is_always_negative_is_no_case_of_several() -> None:
    """With a relaxed spring on a rough track, x₀ = −μmg/k is negative for all numbers."""
    scene = row((2.2,), (116.0,), "right", friction=0.62, speed=1.2)
    cart = next(body.name for body in scene.mechanism.bodies if body.mass)
    plain = asked(scene, Query("time_to_event", None, Stopped(cart)))
    names = tuple(given.symbol for given in plain.lexicon.givens.values())
    latex = r"\arctan\left(\frac{k v}{\mu m g \sqrt{\frac{k}{m}}}\right)\,\sqrt{\frac{m}{k}}"
    found = solve(replace(plain, formula=Formula(latex, names, ("",) * len(names), (), ())))
    assert "As $x_0 < 0$, $\\omega t_1$ is less than" in found.text
