"""Tests of springs on a line against closed forms: oscillation, normal modes, energy, momentum and statics."""

from math import acos, asin, cos, pi, radians, sin, sqrt

import pytest

from joined_entities import scene as joined
from joined_entities import string
from plain_scenes import row
from sim2reason.questions import Query, StatedResult, Target
from sim2reason.questions.kinds.equilibrium import EquilibriumQuery
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.contacts import StoppedSlipping
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.strings import MostCompressed, MostStretched, NaturalLength
from sim2reason.questions.moments.times import AtStart, AtTime
from sim2reason.questions.moments.turning_points import Stopped
from sim2reason.questions.phrasing import PeriodQuery
from sim2reason.scenes.bodies.blocks import Block, Slab
from sim2reason.scenes.bodies.oscillators import Spring
from sim2reason.scenes.bodies.simple_machines import Plane
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.spring_blocks import SpringMassIncline
from sim2reason.scenes.entities.stacked_mass_plane import StackedMassPlane
from sim2reason.scenes.entities.string_ends import Hanging, HangingMass
from sim2reason.solutions import STRATEGIES, ProblemContext, Solution, solve, solve_with
from sim2reason.solutions.reverse import forward
from sim2reason.solutions.solution import RELATION_RTOL
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import RTOL_BY_KIND, faults
from worked import asked, solution_text

G, STIFFNESS, MASS = 9.8, 50.0, 2.0


def lone(**start: float) -> Scene:
    """Return a scene with one cart on a spring to a wall on its left."""
    return row((MASS,), (STIFFNESS,), "left", **start)  # type: ignore[arg-type]


def cart(scene: Scene, number: int = 0) -> str:
    return [body.name for body in scene.mechanism.bodies if body.mass][number]


def spring(scene: Scene, number: int = 0) -> str:
    return scene.mechanism.lines[number].name


def found(scene: Scene, query: Query, *names: str) -> float:
    """Return the answer after asserting that all named strategies find it and agree."""
    setting, answers = forward(asked(scene, query)), list[float]()
    for name in names:
        solution = solve_with(STRATEGIES[name], setting)
        answers.append(sound(solution, setting))
    assert all(answer == pytest.approx(answers[0], rel=1e-9) for answer in answers)
    return answers[0]


def sound(solution: Solution, setting: ProblemContext) -> float:
    assert solution.answer is not None, solution.reason
    assert setting.answer is not None
    assert not faults(solution, setting.answer, RTOL_BY_KIND.get(setting.query.kind, RELATION_RTOL)), solution.text
    assert not read(solution.text).broken
    return solution.answer


def test_the_period_of_a_cart_on_a_spring() -> None:
    """The period is T = 2π √(m/k); see Kleppner and Kolenkow, § 3.7."""
    query = PeriodQuery("period", None, None, "period", small=False, of=(cart(lone(strain=0.1)),))
    answer = found(lone(strain=0.1), query, "oscillation", "normal modes")
    assert answer == pytest.approx(2.0 * pi * sqrt(MASS / STIFFNESS), rel=1e-9)


def test_a_struck_cart_turns_back_when_its_energy_is_all_in_the_spring() -> None:
    """The amplitude is A = v √(m/k)."""
    scene = lone(speed=1.5)
    query = Query("event", Target("displacement", cart(scene)), Stopped(cart(scene)))
    answer = found(scene, query, "oscillation", "normal modes", "energy")
    assert abs(answer) == pytest.approx(1.5 * sqrt(MASS / STIFFNESS), rel=1e-9)


def test_its_speed_after_a_distance_is_that_of_energy() -> None:
    """A cart released at A has v² = k (2 A d − d²)/m after a distance d."""
    scene = lone(strain=0.2)
    query = Query("event", Target("velocity", cart(scene)), Moved(cart(scene), 0.05))
    answer = found(scene, query, "oscillation", "normal modes", "energy")
    assert abs(answer) == pytest.approx(sqrt(STIFFNESS * (2.0 * 0.2 * 0.05 - 0.05**2) / MASS), rel=1e-9)


def test_the_time_for_a_distance() -> None:
    """A (1 − cos ωt) = d from rest at A; A sin ωt = d for a struck cart."""
    omega, held = sqrt(STIFFNESS / MASS), lone(strain=0.2)
    query = Query("time_to_event", None, Moved(cart(held), 0.05))
    assert found(held, query, "oscillation", "normal modes") == pytest.approx(acos(0.75) / omega, rel=1e-9)
    struck = lone(speed=1.0)
    assert found(struck, query, "oscillation", "normal modes") == pytest.approx(asin(0.05 * omega) / omega, rel=1e-9)


def test_on_a_slope_it_oscillates_about_where_weight_and_spring_balance() -> None:
    """The cart released from the natural length moves down by 2 m g sin θ/k at most."""
    scene = lone(tilt=30.0)
    query = StretchQuery("extremum", None, AtTime(1.5), "greatest displacement", cart(scene))
    answer = found(scene, query, "oscillation", "energy")
    assert answer == pytest.approx(MASS * G / STIFFNESS, rel=1e-9)
    rest = EquilibriumQuery("equilibrium", Target("displacement", cart(scene)))
    assert abs(found(scene, rest, "statics")) == pytest.approx(0.5 * MASS * G / STIFFNESS, rel=1e-9)


def test_a_path_to_and_fro() -> None:
    """The path in half a period and a third of the next half is 2 A + A (1 − cos 60°)."""
    scene, omega = lone(strain=0.2), sqrt(STIFFNESS / MASS)
    query = StretchQuery("sum", None, AtTime(round(4.0 * pi / 3.0 / omega, 12)), "distance travelled", cart(scene))
    assert found(scene, query, "oscillation", "normal modes") == pytest.approx(0.5, rel=1e-9)


def test_two_free_carts_vibrate_with_their_reduced_mass() -> None:
    """ω² = k (1/m + 1/M); see Kleppner and Kolenkow, problem 3.27."""
    scene = row((1.0, 3.0), (60.0,), "free", strain=0.1)
    query = PeriodQuery("period", None, None, "angular frequency", small=True, of=())
    assert found(scene, query, "oscillation", "normal modes") == pytest.approx(sqrt(60.0 * 4.0 / 3.0), rel=1e-9)


def test_the_greatest_compression_of_two_free_carts_leaves_the_energy_of_their_centre_of_mass() -> None:
    """½ k x² = ½ µ v² with the reduced mass µ."""
    scene = row((1.0, 3.0), (60.0,), "free", speed=2.0)
    query = Query("event", Target("extension", spring(scene)), MostCompressed(spring(scene)))
    answer = found(scene, query, "momentum", "oscillation", "normal modes")
    assert abs(answer) == pytest.approx(2.0 * sqrt(0.75 / 60.0), rel=1e-9)


def test_equal_carts_between_walls_have_the_modes_of_every_textbook() -> None:
    """ω² = k/m and 3 k/m; Goldstein, Poole and Safko, § 6.2. One strained spring at release excites both modes."""
    scene = row((2.0, 2.0), (50.0, 50.0, 50.0), "both", strain=0.1, at=1)
    for rank, share in ((0, 1.0), (1, 3.0)):
        query = PeriodQuery("period", None, None, "angular frequency", small=True, of=(), rank=rank, modes=2)
        assert found(scene, query, "normal modes") == pytest.approx(sqrt(25.0 * share), rel=1e-9)
    query = Query("time_to_event", None, NaturalLength(spring(scene, 1)))  # of the second mode alone: 1 + 2 cos ωt = 0
    assert found(scene, query, "normal modes") == pytest.approx(acos(-0.5) / sqrt(75.0), rel=1e-9)


def test_three_carts_by_numeric_roots() -> None:
    """Equal carts between walls have ω² = (2 − √2) k/m in the slowest mode; French, Vibrations and Waves, ch. 5."""
    scene = row((1.0, 1.0, 1.0), (40.0,) * 4, "both", speed=1.0)
    query = PeriodQuery("period", None, None, "angular frequency", small=True, of=(), rank=0, modes=3)
    assert found(scene, query, "normal modes") == pytest.approx(sqrt(40.0 * (2.0 - sqrt(2.0))), rel=1e-9)
    said = Query("state", Target("displacement", cart(scene, 2)), AtTime(0.7))
    assert found(scene, said, "normal modes")


def test_a_stiffness_is_found_from_a_time() -> None:
    """A relaxed spring turns the cart back after t = T/4, so k = m (π/2t)²."""
    scene = lone(speed=1.0)
    plain = asked(scene, Query("time_to_event", None, Stopped(cart(scene))))
    path = next(p.path for p in scene.parameters if p.path.endswith("stiffness"))
    time = 0.5 * pi * sqrt(MASS / STIFFNESS)
    stated = StatedResult(f"{time:.14g}", "s")
    for name in ("oscillation", "normal modes"):
        setting = ProblemContext(plain.scene, plain.words, plain.symbols, plain.study, plain.query, path, stated)
        solution = solve_with(STRATEGIES[name], setting)
        assert sound(solution, setting) == pytest.approx(STIFFNESS, rel=1e-9)
        assert f"{time:.4f}" not in solution.text.partition("Put into")[0].partition("Given")[0]


def test_two_slabs_end_with_the_velocity_of_their_centre_of_mass() -> None:
    """On a smooth floor (m + M) v = m u, whatever the friction between the slabs, so no acceleration is needed."""
    slabs = StackedMassPlane(
        plane=Plane(angle=0.0, friction=0.0), lower=Slab(mass=3.0), upper=Slab(mass=1.0), friction=0.4, speed=2.0
    )
    scene = Scene(entities=(Named(name="stack", entity=slabs),))
    upper = cart(scene, 1)
    query = Query("event", Target("velocity", upper), StoppedSlipping(upper))
    assert abs(found(scene, query, "momentum")) == pytest.approx(0.5, rel=1e-9)
    assert solve(asked(scene, query)).strategy == "momentum"
    other = solve_with(STRATEGIES["constant acceleration"], asked(scene, query)).answer
    assert other is not None
    assert abs(other) == pytest.approx(0.5, rel=1e-9)


def test_friction_holds_what_the_spring_pulls() -> None:
    """The friction force is F = k x as long as that is less than µ m g."""
    scene = lone(strain=0.05, friction=0.3)
    query = Query("start", Target("friction force", cart(scene)), AtStart())
    assert found(scene, query, "statics") == pytest.approx(STIFFNESS * 0.05, rel=1e-9)


def test_friction_takes_as_much_of_every_half_swing() -> None:
    """The amplitude decreases by 2 µ m g/k per half oscillation, which always takes T/2.

    Source: Lapidus, American Journal of Physics 38 (1970) 1360.
    """
    friction, strain = 0.1, 0.3
    scene = lone(strain=strain, friction=friction)
    lost, half = 2.0 * friction * MASS * G / STIFFNESS, pi * sqrt(MASS / STIFFNESS)
    query = Query("event", Target("displacement", cart(scene)), Stopped(cart(scene)))
    assert abs(found(scene, query, "half swings")) == pytest.approx(2.0 * strain - lost, rel=1e-9)
    later = StretchQuery("sum", None, AtTime(1.5 * half), "energy dissipated by friction", cart(scene))
    path = 2.0 * strain - lost + strain - 1.5 * lost
    assert found(scene, later, "half swings") == pytest.approx(friction * MASS * G * path, rel=1e-9)


def test_what_is_assumed_to_stick_is_verified() -> None:
    """Both slabs slide down together: the upper one needs m (g sin θ − a) = µ m g cos θ, less than µ′ m g cos θ."""
    slabs = StackedMassPlane(
        plane=Plane(angle=40.0, friction=0.2), lower=Slab(mass=3.0), upper=Slab(mass=1.0), friction=0.5
    )
    scene = Scene(entities=(Named(name="stack", entity=slabs),))
    setting = asked(scene, Query("start", Target("acceleration", cart(scene)), AtStart()))
    solution = solve_with(STRATEGIES["constant acceleration"], setting)
    sound(solution, setting)
    held = [relation for relation in solution.relations if relation.role == "verified"]
    needed, most = (float(relation.right.value(solution.values).real) for relation in held)
    assert needed == pytest.approx(0.2 * G * cos(radians(40.0)), rel=1e-9)
    assert most == pytest.approx(0.5 * G * cos(radians(40.0)), rel=1e-9)
    assert "does not slip" in solution.text


def test_where_all_is_at_rest_for_good_no_half_swing_is_written() -> None:
    """One cart has stopped and the other never moved; their final positions are found only numerically."""
    scene = row((4.4, 3.9), (82.0, 155.0, 113.0), "both", speed=0.98, friction=0.49)
    setting = asked(scene, Query("state", Target("displacement", "row.carts.1"), AtTime(0.5)))
    assert not solve(setting, derived=True).strategy
    assert solve(setting).answer == pytest.approx(setting.answer, rel=1e-9)


def test_the_impulse_of_a_string_that_a_spring_pulls_is_the_momentum_of_what_hangs_on_it() -> None:
    """J = m (g t − v), where M x″ = −k (x − m g/k), M = m + m′, gives v = g m/(M ω) sin ωt with ω² = k/M."""
    time, hung, rate = 0.2, 0.8, sqrt(STIFFNESS / (MASS + 0.8))
    table = SpringMassIncline(
        plane=Plane(angle=0.0, friction=0.0),
        block=Block(mass=MASS),
        spring=Spring(stiffness=STIFFNESS, length=0.3),
        start=0.3,
    )
    load = HangingMass(system=Hanging(blocks=(Block(mass=hung),)))
    made = joined({"table": table, "load": load}, string("table.right", "load.end"))
    query = StretchQuery("sum", None, AtTime(time), "impulse of a tension", made.mechanism.strings[0].name)
    fast = G * hung / ((MASS + hung) * rate) * sin(rate * time)
    assert found(made, query, "oscillation", "normal modes") == pytest.approx(hung * (G * time - fast), rel=1e-9)


@pytest.mark.parametrize("quantity", ["net force", "acceleration"])
def test_what_nothing_drives_back_has_no_share_in_an_acceleration(quantity: str) -> None:
    """For three free carts the solution doesn't need the velocity of their centre of mass."""
    scene = row((1.5, 4.8, 4.3), (122.0, 41.0), "free", speed=0.9)
    for moment in (MostStretched(spring(scene)), AtTime(0.4)):
        setting = asked(scene, Query("event", Target(quantity, cart(scene)), moment))
        sound(solve_with(STRATEGIES["normal modes"], setting), setting)


def test_a_time_follows_from_the_law_of_motion_that_is_stated() -> None:
    """With friction x = x₀ (1 − cos ωt), so no separate displacement is named at the moment in question."""
    scene = lone(strain=0.2, friction=0.1)
    found = solve(asked(scene, Query("time_to_event", None, NaturalLength(spring(scene)))))
    assert found.strategy == "half swings"
    assert r"x = x_0 - x_0\,\cos\left(\omega t\right)$, so $t" in found.text
    assert "This happens" not in found.text
    assert "s_1" not in found.text
    rest = 0.2 - 0.1 * MASS * G / STIFFNESS
    assert found.answer == pytest.approx(acos(1.0 - 0.2 / rest) / sqrt(STIFFNESS / MASS), rel=1e-8)


def test_an_acceleration_beyond_the_place_of_balance_has_the_sense_of_the_displacement() -> None:
    """a = ω² (x₀ − x) is negative where x > x₀, so the text doesn't direct it towards the equilibrium."""
    scene = lone(tilt=30.0)
    found = solve(asked(scene, Query("state", Target("net force", cart(scene)), AtTime(0.5))))
    assert found.answer == pytest.approx(abs(MASS * G * 0.5 * cos(0.5 * sqrt(STIFFNESS / MASS))), rel=1e-8)
    assert "towards the equilibrium" not in found.text


def test_what_two_carts_gain_as_their_spring_relaxes_is_told_with_their_names() -> None:
    """½ µ v² = ½ k d², and m_A v_A + m_B (v_A + v) = 0."""
    scene = row((2.0, 3.0), (50.0,), "free", strain=0.1)
    first = next(held.name for held in scene.mechanism.bodies if held.mass)
    query = Query("event", Target("kinetic energy", first), NaturalLength(spring(scene)))
    setting = asked(scene, query)
    found = solve_with(STRATEGIES["momentum"], setting)
    assert found.answer == pytest.approx(0.25 * 3.0 / 5.0), found.reason
    assert setting.answer is not None
    assert not faults(found, setting.answer)
    assert "The total momentum along the track is conserved; with the velocity $v_A$ of" in found.text
    assert "when the spring has its natural length: " in found.text
    assert r"\left(x - d\right)" not in found.text


def test_the_law_from_the_power_is_said_of_small_velocities_in_the_direction_of_friction_that_was_assumed() -> None:
    assert "As this holds however small the velocity is, $m a = " in solution_text("springs-medium-reverse-301923-2")
