"""Tests that drawn numbers are plausible, and that implausible ones are reported in words."""

import pytest

from plain_scenes import atwood, ramp
from sim2reason.generation.item_search import generator
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions.difficulty import DIFFICULTIES, Difficulty
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.oscillators import Spring
from sim2reason.scenes.bodies.round_bodies import Sphere
from sim2reason.scenes.bodies.space import AirlessPlanet, HeavyPlanet, Rocket, Star
from sim2reason.scenes.dsl.entity import Entity, Named
from sim2reason.scenes.dsl.magnitudes import STATED, implausible_numbers
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import RotationEntity
from sim2reason.scenes.entities.pieces import RoundPiece
from sim2reason.scenes.entities.space import RocketEntity, SolarSystem
from sim2reason.scenes.entities.spring_blocks import AnchoredSpring

DRAWS = [9, pytest.param(45, marks=pytest.mark.slow)]  # of each recipe and difficulty: 2025 in all


@pytest.mark.parametrize("draws", DRAWS)
@pytest.mark.parametrize("difficulty", DIFFICULTIES)
@pytest.mark.parametrize("recipe", RECIPES)
def test_all_that_is_drawn_is_plausible(recipe: str, difficulty: Difficulty, draws: int) -> None:
    for index in range(draws):
        scene = RECIPES[recipe](difficulty, generator("magnitudes", recipe, difficulty, index))
        assert not list(implausible_numbers(scene))
        for parameter in scene.parameters:
            assert parameter.hidden or (parameter.measure.name, parameter.measure.unit) in STATED


def alone(entity: Entity) -> Scene:
    return Scene(entities=(Named(name="it", entity=entity),))


def sphere(mass: float, radius: float) -> Scene:
    piece = RoundPiece(body=Sphere(mass=mass, radius=radius), distance=0.9)
    return alone(RotationEntity(pieces=(piece,), angle=60.0))


def planets(mass: float) -> Scene:
    """Build two planets of a given mass, in solar masses, about a star of 1.0 solar mass."""
    heavy = (HeavyPlanet(mass=mass, x=x, y=0.0, vx=0.0, vy=vy) for x, vy in ((1.0, 6.28), (2.0, 4.44)))
    return alone(SolarSystem(star=Star(mass=1.0), planets=tuple(heavy)))


def airless(gravity: float) -> Scene:
    """Build a rocket on an airless planet with a radius of 2000 km."""
    rocket, place = Rocket(mass=1000.0, dry=200.0), AirlessPlanet(radius=2000.0, gravity=gravity)
    return alone(RocketEntity(rocket=rocket, place=place, exhaust=2.0, rate=2.0))


def sprung(start: float) -> Scene:
    """Build a block on a spring of natural length 0.50 m, released at another length."""
    spring = Spring(stiffness=100.0, length=0.5)
    return alone(AnchoredSpring(spring=spring, block=Block(mass=2.0), start=start))


@pytest.mark.parametrize(
    ("scene", "said"),
    [
        (atwood(), []),
        (ramp(mass=5000.0), ["ramp.blocks.0.mass is 5000 kg"]),
        (ramp(speed=300.0), ["ramp.speed is 300 m/s"]),
        (sphere(2.0, 0.08), []),  # 0.93 g/cm³
        (sphere(8.0, 0.05), ["it.pieces.0.body has a density of 1.53e+04 kg/m³"]),
        (sphere(0.5, 0.4), ["it.pieces.0.body has a density of 1.87 kg/m³"]),
        (planets(5e-4), []),
        (planets(0.24), [f"it.planets.{n} has 0.24 of the mass of it.star, which stays fixed" for n in range(2)]),
        (airless(2.0), []),  # 3.6 g/cm³
        (airless(5.4), ["it.place has a density of 9.66e+03 kg/m³"]),
        (sprung(0.6), []),
        (sprung(0.09), ["it.spring is squeezed to 0.18 of its natural length"]),
        (sprung(1.0), ["it.spring is stretched to 2 of its natural length"]),
    ],
)
def test_what_is_not_plausible_is_said(scene: Scene, said: list[str]) -> None:
    assert list(implausible_numbers(scene)) == said


def test_zero_is_plausible() -> None:
    """A smooth plane has a coefficient of friction of zero."""
    assert not list(implausible_numbers(ramp(friction=0.0)))
