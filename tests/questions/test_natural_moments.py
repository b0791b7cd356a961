"""Tests of moments in words that fit the scene: the only collision, a vertical flight, a spring's extension."""

import pytest

from lone_entities import alone
from plain_scenes import ramp, row
from sim2reason.questions.functionals.aggregates import collision_phrases
from sim2reason.questions.moments.contacts import Collided
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.strings import MostStretched
from sim2reason.questions.moments.turning_points import Stopped
from sim2reason.questions.prompt import words_of
from sim2reason.questions.query import Target, targets
from sim2reason.questions.words import Words
from sim2reason.scenes.bodies.blocks import Puck, Table
from sim2reason.scenes.bodies.oscillators import Ball
from sim2reason.scenes.bodies.space import DeepSpace, LevelGround, Rocket
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.particles import Projectile
from sim2reason.scenes.entities.space import RocketEntity
from sim2reason.scenes.entities.two_d_collision_plane import TwoDCollisionPlane
from sim2reason.text.prose.description import describe

PUCKS = (
    Puck(mass=1.0, x=-1.0, y=0.0, vx=2.0, vy=0.1),
    Puck(mass=2.0, x=1.0, y=0.0, vx=-1.0, vy=0.0),
    Puck(mass=1.5, x=1.0, y=1.0, vx=-1.0, vy=0.0),
)
PAIR = "it.pucks.0 & it.pucks.1"


def on_table(count: int, restitution: float = 0.6, right: float | None = None) -> Scene:
    """Build a table with the first `count` pucks, and perhaps a wall."""
    pucks = PUCKS[:count]
    return alone(TwoDCollisionPlane(table=Table(), radius=0.1, pucks=pucks, restitution=restitution, right=right))


def thrown(angle: float, side: str = "above", restitution: float | None = None) -> Scene:
    """Build a ball thrown from a height."""
    given = {"ball": Ball(mass=0.5), "height": 2.0, "speed": 5.0, "angle": angle, "side": side}
    return alone(Projectile.model_validate(given | {"restitution": restitution}))


def rocket(place: LevelGround | DeepSpace) -> Scene:
    """Build a rocket that starts from rest."""
    return alone(RocketEntity(rocket=Rocket(mass=1000.0, dry=200.0), place=place, exhaust=1.0, rate=12.0))


def words(scene: Scene) -> Words:
    """Return the words of a text about a scene."""
    return words_of(describe(scene))


def test_two_pucks_without_walls_collide_but_once() -> None:
    told = words(on_table(2))
    moment = Collided(PAIR)
    assert "just after pucks A and B collide" in moment.phrases(told)
    assert collision_phrases(moment, told, PAIR)[0] == "in their collision"
    assert not any("first" in phrase for phrase in (*moment.phrases(told), *moment.stretches(told)))


@pytest.mark.parametrize("scene", [on_table(3), on_table(2, right=2.5)])
def test_pucks_that_may_meet_again_first_collide(scene: Scene) -> None:
    told = words(scene)
    assert all("first" in phrase for phrase in Collided(PAIR).phrases(told))
    assert collision_phrases(Collided(PAIR), told, PAIR)[0] == "in their first collision"


@pytest.mark.parametrize("restitution", [0.0, 0.6, 1.0])
def test_the_text_on_two_pucks_does_not_speak_of_several_collisions(restitution: float) -> None:
    for seed in range(8):
        text = describe(on_table(2, restitution), seed).text
        assert "collisions" not in text
        assert "every" not in text


@pytest.mark.parametrize(
    ("scene", "name"),
    [(rocket(LevelGround()), "it.rocket"), (thrown(90.0), "it.ball"), (thrown(90.0, restitution=0.5), "it.ball")],
)
def test_what_goes_straight_up_reaches_its_greatest_height(scene: Scene, name: str) -> None:
    told = words(scene)
    assert Stopped(name).does(told).told == "reaches its greatest height"
    assert not any("first" in phrase for phrase in Stopped(name).phrases(told))
    assert Stopped(name, 2).does(told).told.startswith("comes to rest")


@pytest.mark.parametrize(
    ("scene", "name"),
    [(rocket(DeepSpace()), "it.rocket"), (thrown(90.0, "below", 0.5), "it.ball"), (ramp(speed=2.0), "ramp.blocks.0")],
)
def test_what_does_not_go_straight_up_comes_to_rest(scene: Scene, name: str) -> None:
    assert Stopped(name).does(words(scene)).told.startswith("comes to rest")


def test_a_rocket_rises_from_the_ground_and_moves_in_space() -> None:
    def when(told: str, text: Words) -> str:
        return f"when {text.mentions['it.rocket']} {told}"

    ground, space = words(rocket(LevelGround())), words(rocket(DeepSpace()))
    moment = Moved("it.rocket", 65.0)
    assert moment.phrases(ground)[1] == when("has risen 65 m", ground)
    assert moment.phrases(space)[1] == when("has moved 65 m", space)
    clause = moment.clause(ground)
    assert clause is not None
    assert clause.takes == "to rise 65 m"


def test_one_spring_has_its_maximum_extension_and_of_several_each_has_maxima() -> None:
    one, two = row((2.0,), (80.0,), "left", strain=0.1), row((1.0, 2.0), (100.0, 60.0), "left", strain=0.1)
    for scene, told in ((one, "reaches its maximum extension"), (two, "reaches a maximum of its extension")):
        assert MostStretched(scene.mechanism.lines[0].name).does(words(scene)).told == told


def test_a_flight_has_a_horizontal_and_a_vertical_displacement() -> None:
    asked = {noun.phrase for target, noun in targets(words(thrown(40.0))).items() if target.quantity == "displacement"}
    assert "the horizontal displacement of the ball from its starting point" in asked
    assert "the vertical displacement of the ball from its starting point" in asked
    level = {noun.phrase for target, noun in targets(words(on_table(2))).items() if target.quantity == "displacement"}
    assert "the x component of the displacement of puck A from its starting point" in level


def test_by_how_much_a_potential_energy_changes_is_asked_over_a_stretch_alone() -> None:
    noun = targets(words(thrown(40.0)))[Target("potential energy", "it.ball")]
    assert noun.how == "by how much does the gravitational potential energy of the ball change {when}?"
