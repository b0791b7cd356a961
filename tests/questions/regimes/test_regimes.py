"""Tests of regimes: descriptions of a motion, and the other motions that share them."""

from dataclasses import replace
from math import cos, radians, sin

import numpy as np
import pytest

from plain_scenes import atwood, massive, ramp, squeezed
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions import KINDS, MODES, Query, Question, SimulatedScene, Target
from sim2reason.questions.moments.times import AtTime, WholeMotion
from sim2reason.questions.prompt import words_of
from sim2reason.questions.regimes import regimes
from sim2reason.questions.regimes.directions import StartsAcute
from sim2reason.questions.regimes.events import BurntOut, CollideInTurn, SlidesThroughout
from sim2reason.questions.sentences import parse_question
from sim2reason.questions.words import OwnSymbol
from sim2reason.scenes.bodies.blocks import Block, Glider
from sim2reason.scenes.bodies.oscillators import Spring
from sim2reason.scenes.bodies.round_bodies import Hoop
from sim2reason.scenes.bodies.simple_machines import Incline, Plane, Track
from sim2reason.scenes.bodies.space import DeepSpace, LevelGround, Rocket
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.rolling import RollingEntity, Rough, Sliding, Spinning
from sim2reason.scenes.entities.space import RocketEntity
from sim2reason.scenes.entities.spring_blocks import SpringMassIncline
from sim2reason.scenes.entities.track_collisions import ComplexCollisionPlane
from sim2reason.scenes.files import loads
from sim2reason.text.prose.description import describe


def study(scene: Scene, until: float = 1.0) -> SimulatedScene:
    return SimulatedScene.of(scene, np.linspace(0.0, until, 11))


def sprung() -> Scene:
    """Build a block on a slope, on a spring compressed by 0.3 m; at equilibrium it would be 0.1 m."""
    plane, spring = Plane(angle=30.0, friction=0.0), Spring(stiffness=100.0, length=0.8)
    entity = SpringMassIncline(plane=plane, block=Block(mass=2.0), spring=spring, start=0.5)
    return Scene(entities=(Named(name="spring", entity=entity),))


def said(scene: Scene, until: float) -> set[str]:
    words = words_of(describe(scene))
    return {found.clause(words) for found in regimes(study(scene, max(until, 1.0)), words, until)}


def test_a_block_slides_down_what_is_steep_enough() -> None:
    """The block slides if µ < tan 30° = 0.577."""
    assert "the block moves down the slope" in said(ramp(friction=0.3), 0.5)
    assert "the block slides down the plane" in said(ramp(friction=0.3), 0.5)
    assert "the block keeps sliding up the plane" in said(ramp(friction=0.3, speed=2.0), 0.1)
    assert said(ramp(friction=0.7), 0.5) == {"the block does not slide on the plane"}


def test_the_margin_of_sliding_tells_from_the_very_start() -> None:
    """The margin is sin θ − µ cos θ, relative to free fall, even at the start, where the speed is zero."""
    (block,) = ramp().mechanism.contacts
    slides = SlidesThroughout(block, slides=True, course=(-1,))
    for friction in (0.1, 0.3):
        margin = slides.margin(study(ramp(friction=friction)), 0.0)
        assert margin == pytest.approx(sin(radians(30.0)) - friction * cos(radians(30.0)), rel=1e-6)


def test_what_slides_up_and_down_again_is_told_to() -> None:
    """The block comes to rest after 2.0/(9.8 (0.5 + 0.3·0.866)) = 0.27 s."""
    told = said(ramp(friction=0.3, speed=2.0), 0.6)
    assert "the block first slides up the plane, turns back once and is sliding down it by then" in told


def hoop(start: Sliding | Spinning) -> Scene:
    """Build a hoop on a slope of 20° that slips at first."""
    plane, body = Incline(angle=20.0), Hoop(mass=2.0, radius=0.1)
    entity = RollingEntity(plane=plane, body=body, grip=Rough(friction=0.15), start=start)
    return Scene(entities=(Named(name="roller", entity=entity),))


@pytest.mark.parametrize(
    ("start", "way"),
    [
        (Sliding(way="down the slope", speed=2.0), "down"),
        (Sliding(way="up the slope", speed=2.0), "up"),
        (Spinning(way="up the slope", spin=30.0), "down"),
    ],
)
def test_what_rolls_slips_one_way_where_it_touches_its_plane(start: Sliding | Spinning, way: str) -> None:
    """The lowest point of a body that spins as if it rolled up moves down the slope."""
    found = said(hoop(start), 0.05)
    assert any(clause.endswith(f"keeps slipping {way} the plane at the point of contact") for clause in found)
    assert sum("slipping" in clause for clause in found) == 1


def test_several_strings_stay_taut_together() -> None:
    """A single string is named, even across a disc; of several all are mentioned, if all of them pull."""
    assert not any("all strings" in clause for scene in (atwood(), massive(2.0)) for clause in said(scene, 0.5))
    draws = (RECIPES["pulley"].draw("medium", np.random.default_rng(seed)) for seed in range(60))
    several = [scene for scene in draws if len({line.name.partition("/")[0] for line in scene.mechanism.strings}) > 1]
    assert several
    for scene in several:
        tensions = SimulatedScene.of(scene, np.linspace(0.0, 0.2, 5)).trace.scan.tension
        pull = all((tensions[line.name] > 1e-9).all() for line in scene.mechanism.strings)
        assert ("all strings stay taut" in said(scene, 0.2)) is pull


def test_what_swings_back_moves_one_way_first() -> None:
    """A block released on a compressed spring goes up the slope, and returns after half a period π √(m/k)."""
    found = said(sprung(), 3.0)
    assert "the block first moves up the slope" in found
    assert not any("the block moves" in clause for clause in found)
    assert {"the block keeps moving up the slope", "the block first moves up the slope"} <= said(sprung(), 0.1)
    assert "the block keeps moving up the slope" not in said(sprung(), 0.0), "just at the start nothing has kept moving"


def test_what_is_launched_is_told_how() -> None:
    assert not any("first" in clause for clause in said(ramp(speed=2.0), 0.3))


def test_on_its_way_up_and_back_it_moves_no_one_way() -> None:
    """At 2 m/s up a smooth slope of 30° the block turns after 2/(9.8 · 0.5) = 0.41 s."""
    assert said(ramp(speed=2.0), 0.3) == {"the block keeps moving up the slope"}
    assert said(ramp(speed=2.0), 0.6) == set()


@pytest.mark.parametrize(("left", "way"), [(3.0, "down"), (1.0, "up")])
def test_the_heavier_side_goes_down(left: float, way: str) -> None:
    found = said(atwood(left, 2.0), 0.5)
    assert f"block A moves {way}" in found
    assert f"block A first moves {way}" in found
    assert any("stays taut" in clause for clause in found)


def test_it_holds_where_it_is_so() -> None:
    words = words_of(describe(atwood()))
    down = next(r for r in regimes(study(atwood()), words, 0.5) if r.clause(words) == "block A moves down")
    assert down.holds(study(atwood(5.0, 2.0)), 0.5)
    assert not down.holds(study(atwood(1.0, 2.0)), 0.5)
    assert down.holds(study(atwood(5.0, 2.0)), 0.0), "what is about to move counts"


def test_collisions_in_turn() -> None:
    """A cart at 1 m/s hits an equal one at rest at 1 s, 1 m ahead, which hits the wall, 1 m farther, at 2 s."""
    scene = squeezed(heavy=1.0)
    words, motion = words_of(describe(scene)), study(scene, 10.0)

    def listed(until: float) -> list[str]:
        return [r.clause(words) for r in regimes(motion, words, until) if isinstance(r, CollideInTurn)]

    assert listed(0.5) == ["there is no collision before then"]
    assert listed(1.0) == listed(0.5), "the one that is asked about does not come before itself"
    assert listed(1.5) == ["the only collision before then is between carts A and B"]
    both = "between carts A and B and between cart B and the wall"
    assert listed(2.5) == [f"the only collisions before then are, in this order, {both}"]
    twice = CollideInTurn("", (motion.mechanism.meetings[0].names,) * 2)
    assert twice.clause(words) == "there are exactly two collisions before then, each between carts A and B"


def test_of_two_that_can_meet_nobody_else_no_other_collision_is_spoken_of() -> None:
    carts = (Glider(mass=1.0, x=0.0, v=1.0), Glider(mass=2.0, x=1.0, v=0.0))
    track = ComplexCollisionPlane(track=Track(), gliders=carts, restitution=1.0)
    scene = Scene(entities=(Named(name="track", entity=track),))
    words, motion = words_of(describe(scene)), study(scene, 10.0)
    (met,) = (r for r in regimes(motion, words, 2.0) if isinstance(r, CollideInTurn))
    assert met.clause(words) == "carts A and B have collided by then"


def rocket(rate: float) -> Scene:
    """Build a rocket of 1000 kg with an exhaust of 1 km/s, whose thrust equals its weight at 9.8 kg/s."""
    entity = RocketEntity(rocket=Rocket(mass=1000.0, dry=300.0), place=LevelGround(), exhaust=1.0, rate=rate)
    return Scene(entities=(Named(name="rocket", entity=entity),))


def test_what_is_too_heavy_waits() -> None:
    """At 9.0 kg/s the rocket lifts off at 9.1 s, with 918 kg; at 2.0 kg/s even 300 kg without fuel are too heavy."""

    def lift_off(rate: float) -> list[str]:
        found = [clause for clause in said(rocket(rate), 20.0) if "lifts off" in clause]
        return [clause.partition(" lifts off ")[2] for clause in found]  # whatever this text calls the rocket

    assert lift_off(9.0) == ["only after its engine has burned part of its fuel"]
    assert lift_off(11.0) == ["as soon as its engine starts"]
    assert lift_off(2.0) == []
    assert {clause.rpartition(" ")[2] for clause in said(rocket(9.0), 20.0) if "keeps moving" in clause} == {"up"}


@pytest.mark.parametrize(
    ("until", "clause"),
    [(0.0, ""), (40.0, "still has fuel at that moment"), (80.0, "burned all its fuel by that moment")],
)
def test_whether_fuel_is_left_is_always_told(until: float, clause: str) -> None:
    """The 700 kg of fuel last for 70 s at 10 kg/s."""
    scene = rocket(10.0)
    motion, words = study(scene, 90.0), words_of(describe(scene))
    found = [held for held in regimes(motion, words, until) if isinstance(held, BurntOut)]
    assert [held.clause(words) for held in found if clause not in held.clause(words)] == []
    assert len(found) == bool(clause)
    assert all(held.must_be_stated(motion) for held in found)


def test_at_burn_out_itself_nothing_need_be_said_of_fuel() -> None:
    scene = rocket(10.0)
    assert not any("fuel" in clause for clause in said(scene, 70.0))


def assuming(scene: Scene, query: Query) -> str:
    """Return the text and the assumptions of a symbolic question."""
    motion, words = study(scene, scene.horizon), words_of(describe(scene))
    kind = KINDS[query.kind]
    answer = kind.answer(query, motion)
    assert answer is not None
    question = Question("symbolic", query, "", answer, kind.measured(query).unit)
    found = MODES["symbolic"].completed(question, motion, words, np.random.default_rng(0))
    assert found is not None
    return found.text


def test_a_string_that_goes_slack_in_a_motion_without_an_answer_is_said_to_stay_taut() -> None:
    """For k (ℓ − ℓ₀) > (m_A + 2 m_B) g the spring pushes A back with more than g, and the string goes slack."""
    scene = loads("""
scene:
  entities:
  - name: sprung
    type: SpringMassIncline
    parameters:
      plane: {angle: 52.0, friction: 0.0}
      block: {mass: 1.4}
      spring: {stiffness: 80.0, length: 0.32}
      start: 0.52
  - name: other
    type: TwoSideMassPlane
    parameters: {plane: {angle: 42.0, friction: 0.0}, blocks: [{mass: 2.0}]}
  connections:
  - {tendon: [{entity: sprung, direction: right}, {entity: other, direction: right}], free: 3.2}
""")
    asked = "What is the least tension in the string during the motion that follows?"
    query = parse_question(asked, study(scene, scene.horizon), words_of(describe(scene)))
    assert query is not None
    drawn = replace(query, moment=WholeMotion(ends=False))  # as recipes ask: of a motion that repeats itself
    assert assuming(scene, drawn).endswith(
        "Assume that block A first moves down the slope and that the string stays taut."
    )


def test_a_rod_that_may_start_above_its_hinge_is_said_to_start_below() -> None:
    """From above its hinge the rod is first level as the trolley stops, since the momentum along the rail is zero."""
    words = words_of(describe(swung(40.0)))
    acute = next(held for held in regimes(study(swung(40.0)), words, 0.5) if isinstance(held, StartsAcute))
    assert acute.clause(words).endswith("makes an acute angle with the downward vertical at the start")
    assert acute.holds(study(swung(89.0)), 0.5)
    assert not acute.holds(study(swung(100.0)), 0.5)


def swung(angle: float) -> Scene:
    """Build a ball on a rod that is hinged to a trolley."""
    return loads(f"""
scene:
  entities:
  - {{name: slider, type: SliderMass, parameters: {{carriage: {{mass: 2.0}}}}}}
  - name: rod
    type: LightRodPendulum
    parameters: {{bob: {{mass: 1.0}}, rod: {{length: 1.0}}, angle: {angle}, side: right}}
  connections:
  - {{pivot: [{{entity: slider, direction: pivot}}, {{entity: rod, direction: base}}]}}
""")


def test_what_may_come_down_before_a_time_that_is_a_symbol_has_not() -> None:
    """The rocket keeps moving up, or has not fallen back; in deep space, or without a time, nothing is said."""
    entity = RocketEntity(rocket=Rocket(mass=724.0, dry=184.0), place=LevelGround(), exhaust=2.8, rate=2.3)
    scene = Scene(entities=(Named(name="rocket", entity=entity),))
    text = assuming(scene, Query("state", Target("velocity", "rocket.rocket"), AtTime(280.0)))
    assert text.endswith("that it keeps moving up, and that it has burned all its fuel by that moment.")

    def fallen(place: LevelGround | DeepSpace, own: dict[str, OwnSymbol]) -> list[str]:
        entity = RocketEntity(rocket=Rocket(mass=1000.0, dry=300.0), place=place, exhaust=1.0, rate=10.0)
        scene = Scene(entities=(Named(name="rocket", entity=entity),))
        words = replace(words_of(describe(scene)), own=own)
        found = [held.clause(words) for held in BurntOut.possible(study(scene, 90.0), words)]
        return [clause.partition(" has ")[2] for clause in found if "fallen back" in clause]

    a_time = {"s": OwnSymbol("a time", "t_1", 80.0)}
    assert fallen(LevelGround(), a_time) == ["burned all its fuel by that moment but has not yet fallen back"]
    assert fallen(LevelGround(), {}) == []
    assert fallen(DeepSpace(), a_time) == []


def test_where_bodies_may_collide_one_moves_only_one_way() -> None:
    """A cart at 1 m/s strikes one at rest at 1 s, so that *the cart that moves to the right* would be ambiguous."""
    found = [clause for clause in said(squeezed(heavy=1.0), 1.5) if " moves " in clause]
    assert "cart B moves only to the right" in found
    assert all("moves only" in clause for clause in found)
