"""Tests of what strategies state about mechanisms, against the exact engine and against their solutions."""

from math import cos, radians, sin

import numpy as np
import pytest

from plain_scenes import row
from sim2reason.generation.item_search import sample
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions import MODES, SimulatedScene
from sim2reason.questions.prompt import words_of
from sim2reason.scenes.bodies.round_bodies import Pipe
from sim2reason.scenes.bodies.simple_machines import Incline
from sim2reason.scenes.bodies.space import HeavyPlanet, Star
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.rolling import RollingEntity, Rough
from sim2reason.scenes.entities.space import SolarSystem
from sim2reason.simulation.engines.exact.engine import motion
from sim2reason.solutions import STRATEGIES, ProblemContext, solve, solve_with
from sim2reason.solutions.strategies import varying_acceleration
from sim2reason.text.prose.description import describe
from worked import asked

SHARE = 0.01  # of the horizon
LINEAR = ("energy", "momentum", "oscillation", "half swings", "Lagrange's equations", "statics")


@pytest.mark.parametrize("recipe", list(RECIPES))
def test_accelerations_change_where_the_engine_integrates(recipe: str) -> None:
    """The engine uses a numerical integrator exactly for motions with varying accelerations."""
    scene = sample(recipe, "medium", seed=3)
    segments = motion(scene.mechanism, SHARE * scene.horizon).segments
    assert bool(varying_acceleration(scene.mechanism)) == any(segment.flow is not None for segment in segments)


@pytest.mark.parametrize("recipe", list(RECIPES))
def test_a_strategy_that_is_unfit_for_a_mechanism_would_find_nothing(
    recipe: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """No strategy that declares a mechanism unsuitable could solve a question about it.

    Mechanisms with possible collisions are left out, since strategies may exclude these cautiously.
    """
    scene = sample(recipe, "hard", seed=4)
    study, description = SimulatedScene.of(scene, np.linspace(0.0, scene.horizon, 41)), describe(scene, 1)
    words, rng = words_of(description), np.random.default_rng(1)
    linear = [STRATEGIES[name] for name in LINEAR if not scene.mechanism.meetings]
    unfit = [strategy for strategy in linear if strategy.why_unsuitable(scene.mechanism)]
    for kind in sorted(frozenset[str]().union(*(strategy.kinds for strategy in unfit))):
        question = MODES["numeric"].ask(study, words, kind, rng)
        if question is None:
            continue
        setting = ProblemContext(scene, words, words.symbols, study, question.query)
        for strategy in unfit:
            if kind in strategy.kinds and not strategy.why_not_applicable(setting):
                with monkeypatch.context() as patched:
                    patched.setattr(type(strategy), "why_unsuitable", lambda *_: "")
                    assert solve_with(strategy, setting).answer is None, (strategy.name, question.text)


def test_no_formula_is_looked_for_where_none_fits_into_a_box() -> None:
    """Oblique collisions, blocks on springs at angles and heavy planets have no formulas that fit an answer."""
    heavy = (HeavyPlanet(mass=1e-3, x=x, y=0.0, vx=0.0, vy=vy) for x, vy in ((1.0, 6.28), (2.0, 4.44)))
    system = SolarSystem(star=Star(mass=1.0), planets=tuple(heavy))
    planets = Scene(entities=(Named(name="system", entity=system),))
    for scene in (sample("springs", "hard", seed=1, index=22), planets):  # of three springs, and of two heavy planets
        mechanism = scene.mechanism
        assert not any(
            s.formulas(mechanism) & {"start", "state"} for s in STRATEGIES.values() if not s.why_unsuitable(mechanism)
        )
    tables = (sample("collision", "easy", seed=1, index=n).mechanism for n in range(8))
    aside = [any(meeting.normal is None for meeting in mechanism.meetings) for mechanism in tables]
    assert any(aside)
    tables = (sample("collision", "easy", seed=1, index=n).mechanism for n in range(8))
    assert [not STRATEGIES["impulse"].formulas(mechanism) for mechanism in tables] == aside
    above = sample("rocket", "hard", seed=1, index=1).mechanism
    assert above.attractions
    assert not STRATEGIES["rocket"].formulas(above)
    assert not STRATEGIES["integration"].formulas(above)


@pytest.mark.parametrize(("carts", "kinds"), [(2, {"period"}), (3, set[str]())])
def test_periods_of_two_modes_alone_are_formulas(carts: int, kinds: set[str]) -> None:
    """With two modes the squares of the frequencies are the roots of a quadratic equation."""
    mechanism = row((2.0,) * carts, (50.0,) * (carts + 1), "both", strain=0.1).mechanism
    assert STRATEGIES["normal modes"].formulas(mechanism) == kinds


def test_how_far_what_rolls_slips_hangs_on_forces() -> None:
    """For a pipe with a = g (sin θ - µ cos θ) and R α = µ g cos θ, friction takes µ m g cos θ d (1 - R α/a)."""
    mass, slope, friction, distance = 2.0, radians(40.0), 0.1, 5.5
    pipe = RollingEntity(body=Pipe(mass=mass, radius=0.1), plane=Incline(angle=40.0), grip=Rough(friction=friction))
    energy = "How much energy does friction between the tube and the plane dissipate"
    said = f"{energy} from release until the tube has moved 5.5 m?"
    setting = asked(Scene(entities=(Named(name="lane", entity=pipe),)), said)
    assert solve_with(STRATEGIES["constraint"], setting).answer is None
    slip = distance * (1.0 - friction * cos(slope) / (sin(slope) - friction * cos(slope)))
    assert solve(setting).answer == pytest.approx(friction * mass * 9.8 * cos(slope) * slip, rel=1e-8)
