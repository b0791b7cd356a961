"""Tests that each filter drops and keeps the right questions."""

from collections import Counter
from dataclasses import replace

import numpy as np
import pytest

from motions import rod_pendulum, spring_block
from plain_scenes import G, arm, atwood, bight, half_atwood, massive, ramp, row, squeezed, table, three
from sim2reason.generation.filters import FILTERS, Candidate, apply_filters
from sim2reason.generation.filters.misconceptions import effects, find_effects
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.questions import KINDS, MODES, Moment, Query, Question, SimulatedScene, Target
from sim2reason.questions.difficulty import Difficulty
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.angles import TurnedThrough
from sim2reason.questions.moments.contacts import Collided
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.times import AtStart, AtTime
from sim2reason.questions.moments.turning_points import Stopped
from sim2reason.questions.simplifications import MISCONCEPTIONS
from sim2reason.scenes.bodies.blocks import Block, Cart, Glider
from sim2reason.scenes.bodies.eccentric_bodies import BoredCylinder
from sim2reason.scenes.bodies.oscillators import Coil
from sim2reason.scenes.bodies.round_bodies import Sphere
from sim2reason.scenes.bodies.simple_machines import Incline, Plane, RoughTrack, Track
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.rolling import Hole, NoSlipping, Rolling, RollingEntity
from sim2reason.scenes.entities.slopes import TwoSideMassPlane
from sim2reason.scenes.entities.spring_chains import SpringMassChain, Strained
from sim2reason.scenes.entities.track_collisions import ComplexCollisionPlane, OwnRestitution
from sim2reason.scenes.entities.two_d_collision_plane import PairRestitution
from sim2reason.simulation.certify import certify_trace
from sim2reason.simulation.trace import Channel

BLOCK, OTHER = "one.system.blocks.0", "other.system.blocks.0"
LEFT, RIGHT = "table.pucks.0", "table.pucks.1"
BOTH = "table.pucks.0 & table.pucks.1"


def candidate(scene: Scene, moment: Moment, target: Target | None, answer: float | None = None) -> Candidate:
    """Build a question about a scene with its true answer, or with another one."""
    study = SimulatedScene.of(scene, np.linspace(0.0, 2.0, 41))
    query = Query(moment.kind if target else "time_to_event", target, moment)
    found = KINDS[query.kind].answer(query, study) if answer is None else answer
    assert found is not None
    unit = KINDS[query.kind].measured(query).unit
    return Candidate(study, Question("numeric", query, "?", found, unit), "a b c")


def reason(name: str, found: Candidate) -> str:
    return FILTERS[name].reason(found)


def test_nothing_is_told_from_zero_or_from_the_text() -> None:
    speed = Target("velocity", "ramp.blocks.0")
    assert not reason("degenerate", candidate(ramp(), AtTime(0.5), speed))
    assert "zero" in reason("degenerate", candidate(ramp(), AtTime(0.5), speed, 1e-4))
    assert "zero" in reason("degenerate", candidate(ramp(angle=10.0, friction=0.7), AtTime(0.5), speed))
    assert "stated" in reason("degenerate", candidate(ramp(speed=3.0), AtStart(), speed))
    assert "stated" in reason("degenerate", candidate(table(), AtTime(0.1), Target("velocity", LEFT)))
    assert not reason("degenerate", candidate(table(), AtTime(0.9), Target("velocity", LEFT), 0.3))
    assert "negative" in reason("degenerate", candidate(table(), AtTime(0.9), Target("velocity", LEFT), -0.3))


def test_what_a_hit_has_not_changed_yet_is_no_question() -> None:
    slow = table(speed=1.37)
    momentum = Target("momentum", LEFT)
    assert "changes" in reason("degenerate", candidate(slow, Collided(BOTH, after=False), momentum, 1.37))
    assert not reason("degenerate", candidate(table(speed=2.0), Collided(BOTH, after=True), momentum, 0.4))


def test_a_distance_that_the_question_states_is_no_answer() -> None:
    same = candidate(atwood(), Moved(BLOCK, 0.83), Target("displacement", OTHER))
    assert "stated" in reason("degenerate", same)
    assert not reason("degenerate", candidate(atwood(), Moved(BLOCK, 0.83), Target("velocity", OTHER)))


def test_a_small_share_of_the_largest_value_is_nothing() -> None:
    found = candidate(atwood(), AtTime(1.0), Target("velocity", BLOCK))
    largest = found.question.answer
    assert not reason("degenerate", replace(found, question=replace(found.question, answer=0.05 * largest)))
    assert reason("degenerate", replace(found, question=replace(found.question, answer=0.005 * largest)))


def test_what_only_one_engine_vouches_for_goes() -> None:
    tension = Target("tension", "tendon_1")
    found = candidate(atwood(), AtTime(0.5), tension)
    assert reason("agreement", found), "no witness was heard"
    certificate = certify_trace(found.study.trace)[1]
    assert not reason("agreement", replace(found, certificate=certificate))
    parted = replace(certificate, until={**certificate.until, Channel("tendon_1", "tension"): 0.4})
    assert "disagree" in reason("agreement", replace(found, certificate=parted))
    ended = replace(certificate, stable_until=0.4, reason="the engines part")
    assert reason("agreement", replace(found, certificate=ended)) == "the engines part"


def test_a_distance_that_only_one_engine_sees_covered_goes() -> None:
    found = candidate(atwood(), Moved(BLOCK, 0.5), None)
    certificate = certify_trace(found.study.trace)[1]
    assert not reason("agreement", replace(found, certificate=certificate))
    parted = replace(certificate, until={**certificate.until, Channel(BLOCK, "displacement"): 0.1})
    assert "displacement" in reason("agreement", replace(found, certificate=parted))


@pytest.mark.parametrize("after", [True, False])
def test_what_happens_at_an_event_is_vouched_for_beyond_it(after: bool) -> None:
    found = candidate(table(), Collided(BOTH, after=after), Target("velocity", LEFT), 1.0)
    certificate = certify_trace(found.study.trace)[1]
    assert not reason("agreement", replace(found, certificate=certificate))
    until = {**certificate.until, Channel(LEFT, "velocity"): 0.39}  # they meet at 0.40 s
    assert reason("agreement", replace(found, certificate=replace(certificate, until=until)))


def test_precision_keeps_what_follows_from_the_digits() -> None:
    assert not reason("precision", candidate(atwood(), AtTime(1.0), Target("velocity", BLOCK)))
    assert not reason("precision", candidate(ramp(friction=0.2), AtTime(1.0), Target("velocity", "ramp.blocks.0")))


def test_precision_drops_a_small_difference_of_large_numbers() -> None:
    nearly = candidate(atwood(5.0, 4.9), AtTime(1.0), Target("velocity", BLOCK))
    assert "condition number" in reason("precision", nearly)


def test_precision_drops_what_hangs_on_the_order_of_events() -> None:
    limit = ramp(angle=30.0, friction=0.577, speed=1.0)  # tan 30° = 0.57735: it just slides back, or just does not
    assert reason("precision", candidate(limit, AtTime(1.9), Target("velocity", "ramp.blocks.0"), 1.0))


@pytest.mark.parametrize(("speed", "counts", "refused"), [(0.5, {4}, ""), (1.0, {4, 5}, "row.carts.0.mass")])
def test_precision_drops_a_count_that_rounding_changes(speed: float, counts: set[int], refused: str) -> None:
    """A cart of 2.05 or 2.15 kg turns back as often as one of 2.1 kg, but not after a harder blow on the next."""
    query = StretchQuery("count", None, AtTime(1.5), "number of reversals", "row.carts.0")
    scenes = (row([mass, 3.2], [73.0, 84.0], "left", strain=0.24, speed=speed) for mass in (2.1, 2.05, 2.15))
    studies = [SimulatedScene.of(scene, np.linspace(0.0, 3.0, 61)) for scene in scenes]
    answers = [KINDS["count"].answer(query, study) for study in studies]
    assert set(answers) == counts
    assert answers[0] is not None
    found = Candidate(studies[0], Question("numeric", query, "", answers[0], ""), "")
    assert reason("precision", found) == (
        f"half a unit in the last place of {refused} changes the count" if refused else ""
    )


def test_a_changed_scene_is_asked_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """The answer in a changed scene is computed once for all filters."""
    found = candidate(ramp(angle=30.0), AtTime(0.5), Target("velocity", "ramp.blocks.0"))
    other = found.study.variant(ramp(angle=31.0))
    first = found.response(other)
    monkeypatch.setattr(type(found.kind), "answer", lambda *_: 0.0)
    assert first
    assert found.response(other) == first


def test_too_many_words_go() -> None:
    found = candidate(ramp(), AtTime(0.5), Target("velocity", "ramp.blocks.0"))
    assert not reason("length", replace(found, prompt="word " * 200))
    assert "words" in reason("length", replace(found, prompt="word " * 300))


def test_the_witness_is_heard_last_and_the_first_verdict_stands() -> None:
    speed = Target("velocity", "ramp.blocks.0")
    sliding = candidate(ramp(friction=0.2), AtTime(0.5), speed)
    assert apply_filters(replace(sliding, difficulty="easy"), witnessed=False).keep
    still = candidate(ramp(angle=10.0, friction=0.7), AtTime(0.5), speed)
    assert apply_filters(replace(still, prompt="word " * 900), witnessed=False).filter == "degenerate"
    unheard = apply_filters(candidate(ramp(), AtTime(0.5), speed), witnessed=True)
    assert (unheard.keep, unheard.filter) == (False, "agreement")


def test_a_body_that_stops_is_vouched_for() -> None:
    found = candidate(ramp(angle=20.0, friction=0.6, speed=2.0), Stopped("ramp.blocks.0"), None)
    assert found.question.answer == pytest.approx(2.0 / (G * (np.sin(np.pi / 9) + 0.6 * np.cos(np.pi / 9))), rel=1e-9)
    assert not reason("agreement", replace(found, certificate=certify_trace(found.study.trace)[1]))


@pytest.mark.parametrize(("difficulty", "said"), [("easy", "many: 7 collisions"), ("medium", "")])
def test_many_collisions_are_no_easy_problem(difficulty: Difficulty, said: str) -> None:
    """A light cart bounces to and fro ever faster between a heavy one and a wall."""
    asked_late = candidate(squeezed(25.0), AtTime(1.99), Target("velocity", "track.gliders.0"), 1.0)
    assert reason("collision", replace(asked_late, difficulty=difficulty)) == said


def test_before_a_collision_nothing_is_asked_of_what_may_collide() -> None:
    assert reason("collision", candidate(table(), AtTime(0.3), Target("displacement", LEFT)))  # they meet at 0.40 s
    assert not reason("collision", candidate(table(), AtTime(0.5), Target("displacement", LEFT)))
    velocity = Target("velocity", LEFT)
    assert not reason("collision", candidate(table(), Collided(BOTH, after=True), velocity))
    assert reason("collision", candidate(table(), Collided(BOTH, after=False), velocity))
    assert not reason("collision", candidate(ramp(), AtTime(0.5), Target("velocity", "ramp.blocks.0")))


def test_what_pairs_share_must_have_come_to_bear() -> None:
    """Carts of 1 kg: A, at 2 m/s, hits B at 0.5 s, which goes on at 1 + e and hits C, 1 m farther, 1/(1 + e) later."""
    carts = tuple(Glider(mass=1.0, x=float(n), v=2.0 * (n == 0)) for n in range(3))
    own = OwnRestitution(first=0, second=1, restitution=0.6)
    track = ComplexCollisionPlane(track=Track(), gliders=carts, restitution=1.0, pairs=(own,))
    scene = Scene(entities=(Named(name="track", entity=track),))
    speed = Target("velocity", "track.gliders.0")
    assert "restitution" in reason("collision", candidate(scene, AtTime(1.1), speed))
    assert reason("collision", candidate(scene, AtTime(1.2), speed)) == ""
    assert reason("collision", candidate(scene, AtTime(1.2), Target("velocity", "track.gliders.2"))) == ""
    one = Scene(entities=(Named(name="track", entity=track.model_copy(update={"pairs": ()})),))
    assert reason("collision", candidate(one, AtTime(1.1), speed)) == ""


def test_a_part_without_bearing_is_allowed_once_on_hard_problems_alone() -> None:
    """The normal force on a block on a fixed plane is mg cos θ, whatever the string does."""
    scene = half_atwood()
    normal = candidate(scene, AtStart(), Target("normal force", "ramp.blocks.0"))
    assert reason("shortcut", replace(normal, difficulty="easy")).startswith("body held: ")
    assert reason("shortcut", normal).startswith("body held: ")
    assert not reason("shortcut", replace(normal, difficulty="hard"))
    tension = candidate(scene, AtStart(), Target("tension", "tendon_1"))
    assert not reason("shortcut", replace(tension, difficulty="easy"))


def test_what_would_pay_a_wrong_idea_goes() -> None:
    """A disc of M = 0.2 kg changes (m₁ − m₂)g/(m₁ + m₂ + M/2), where m₁ + m₂ = 5 kg, by only 2 %."""
    block = Target("acceleration", BLOCK)
    assert reason("simplification", candidate(massive(0.2), AtStart(), block)).startswith("massless pulley: ")
    assert not reason("simplification", candidate(massive(2.0), AtStart(), block))
    assert reason("simplification", candidate(massive(0.002), AtStart(), block)), "so light a disc is not told of"


def test_a_disc_whose_rotation_may_be_forgotten_goes() -> None:
    """The weight of a movable disc matters, but its rotation changes the answer by 4 %, within the tolerance."""
    accelerates = Target("acceleration", "loaded.load")
    found = candidate(bight(4.0, 5.0, 2.0), AtStart(), accelerates)
    assert reason("simplification", found) == "pulley rotation left out: the answer changes by 0.043"
    assert not reason("simplification", candidate(bight(4.0, 2.0, 5.0), AtStart(), accelerates))


@pytest.mark.parametrize(("hole", "refused"), [(0.09, True), (0.14, False)])
def test_a_hole_that_may_be_forgotten_goes(hole: float, refused: bool) -> None:
    """A small hole hardly changes the acceleration, which depends on the body's inertia."""
    body = BoredCylinder(mass=2.0, radius=0.2, hole=hole, offset=0.05)
    entity = RollingEntity(
        body=body, plane=Incline(angle=0.0), hole=Hole(bearing=90.0, towards="right"), grip=NoSlipping()
    )
    scene = Scene(entities=(Named(name="roller", entity=entity),))
    found = candidate(scene, AtStart(), Target("acceleration", "roller.body"))
    assert ("hole" in reason("simplification", found)) == refused


def test_an_angle_whose_complement_is_close_goes() -> None:
    speeds_up = Target("acceleration", "ramp.blocks.0")
    close = reason("simplification", candidate(ramp(angle=44.0), AtStart(), speeds_up))
    assert close == "sine for cosine: the answer changes by 0.036"
    assert not reason("simplification", candidate(ramp(angle=30.0), AtStart(), speeds_up))


def test_friction_by_the_whole_weight_is_not_paid() -> None:
    speeds_up = Target("acceleration", "ramp.blocks.0")
    gentle = candidate(ramp(angle=20.0, friction=0.1), AtStart(), speeds_up)
    assert reason("simplification", gentle).startswith("weight as normal force: ")
    assert not reason("simplification", candidate(ramp(angle=35.0, friction=0.3), AtStart(), speeds_up))


def test_a_wrong_idea_that_changes_nothing_is_paid_all_the_same() -> None:
    """N = m g cos θ with or without friction, so that a student who overlooks the friction is right by accident."""
    force = Target("normal force", "ramp.blocks.0")
    rough = candidate(ramp(friction=0.2), AtTime(0.5), force)
    assert reason("simplification", rough).startswith("no friction: ")
    assert not reason("simplification", candidate(ramp(), AtTime(0.5), force))


def test_a_wrong_idea_about_nothing_but_a_marked_part_is_not_paid() -> None:
    """A third disc collides too late to matter, which the item states, so slips about its collisions do not count."""
    scene = three().having("table.restitution", 1.0)
    special = PairRestitution(first=1, second=2, restitution=0.4)
    hit, velocity = Collided(BOTH, after=True), Target("velocity", RIGHT)
    found = candidate(scene.having("table.pairs", (special,)), hit, velocity)
    assert {effect.subject for effect in effects(found, part=True) if effect.is_accepted} == {"table.pucks.2"}
    assert {e.simplification.name for e in effects(found, part=False) if e.is_accepted} == {"elastic collisions"}
    assert not reason("simplification", found)
    tilted = candidate(scene.having("table.table.angle", 5.0), hit, None)
    assert reason("simplification", tilted).startswith("gravity left out: "), "which is about all three"


def test_no_wrong_idea_is_an_approximation_that_holds() -> None:
    """Energy conservation gives the speed at an angle, at whichever passage."""
    large = arm(90.0).having_all({"arm.pieces.0.body.radius": 0.5, "arm.pieces.0.distance": 0.6})
    passed = candidate(large, TurnedThrough("arm.arm", 40.0), Target("angular velocity", "arm.arm"))
    slips = {effect.simplification.name: effect for effect in effects(passed, part=False)}
    assert slips["later root"].is_unchanged
    assert not slips["later root"].is_error
    assert slips["small angle"].is_error
    assert not reason("simplification", passed)


def test_what_is_not_read_off_a_motion_is_no_matter_of_reading_it() -> None:
    """The period of small oscillations assumes a small angle, and does not depend on the start."""
    study, words = rod_pendulum(60.0).told()
    queries = (KINDS["period"].draw(study, words, {}, np.random.default_rng(seed)) for seed in range(20))
    query = next(query for query in queries if query is not None and KINDS["period"].time(query, study) == 0.0)
    answer = KINDS["period"].answer(query, study)
    assert answer is not None
    found = Candidate(study, Question("numeric", query, "?", answer, "s"), "a b c")
    assert not {"small angle", "from rest"} & {effect.simplification.name for effect in effects(found, part=False)}


def test_no_more_than_two_in_five_numbers_are_idle_for_whatever_reason() -> None:
    """The acceleration 5/7 g sin θ of a sphere depends on neither mass nor radius: one of three numbers is left."""
    ball = RollingEntity(body=Sphere(mass=2.0, radius=0.1), plane=Incline(angle=20.0), grip=NoSlipping())
    scene = Scene(entities=(Named(name="ball", entity=ball),))
    start = candidate(scene, AtStart(), Target("acceleration", "ball.body"))
    assert reason("sensitivity", start) == "idle numbers: ball.body.mass, ball.body.radius"


def test_numbers_that_do_not_matter() -> None:
    speed = Target("velocity", "ramp.blocks.0")
    steep = candidate(ramp(friction=0.3, speed=2.0), AtTime(0.2), speed)
    assert not reason("sensitivity", steep)  # its mass cancels, which is a point to see
    normal = candidate(ramp(friction=0.3, speed=2.0), AtTime(0.2), Target("friction force", "ramp.blocks.0"))
    assert reason("sensitivity", replace(normal, difficulty="easy")) == "idle numbers: ramp.speed"


def test_what_a_slower_motion_leaves_unchanged_is_idle() -> None:
    """A cart on a compressed spring turns back after 2d at any stiffness, which changes the time alone."""
    chain = SpringMassChain(
        track=RoughTrack(),
        carts=(Cart(mass=2.0),),
        ends="left",
        springs=(Coil(stiffness=90.0),),
        strain=Strained(way="compressed", by=0.08),
    )
    scene = Scene(entities=(Named(name="chain", entity=chain),))
    found = candidate(scene, Stopped("chain.carts.0"), Target("displacement", "chain.carts.0"))
    assert "springs.0.stiffness" in reason("sensitivity", replace(found, difficulty="easy"))


def test_the_radius_of_what_rolls_may_cancel() -> None:
    """The speed of a sphere that rolls down depends on neither its mass nor its radius."""
    ball = RollingEntity(
        body=Sphere(mass=2.0, radius=0.1),
        plane=Incline(angle=20.0),
        grip=NoSlipping(),
        start=Rolling(way="down the slope", speed=1.5),
    )
    scene = Scene(entities=(Named(name="ball", entity=ball),))
    found = candidate(scene, AtTime(0.8), Target("velocity", "ball.body"))
    assert not reason("sensitivity", replace(found, difficulty="easy"))


def test_what_is_held_has_no_force_of_its_own() -> None:
    """Without its plane a block has no normal force, so that there is no answer."""
    found = candidate(ramp(friction=0.3, speed=2.0), AtTime(0.2), Target("normal force", "ramp.blocks.0"))
    study = found.study
    assert found.response(study) == found.question.answer
    free = replace(study.mechanism, faces=())
    assert found.response(study.changed("no plane", lambda _: free, 1.0)) is None


def test_too_few_numbers_that_matter_make_no_problem() -> None:
    """The acceleration g sin θ depends on one number alone."""
    start = candidate(ramp(), AtStart(), Target("acceleration", "ramp.blocks.0"))
    assert reason("sensitivity", replace(start, difficulty="easy")) == "idle numbers: ramp.blocks.0.mass"
    later = candidate(ramp(), AtTime(0.5), Target("velocity", "ramp.blocks.0"))
    assert not reason("sensitivity", replace(later, difficulty="easy"))
    assert reason("sensitivity", later) == "reach: 2 numbers matter"


def test_slips_that_are_about_the_whole_are_made_where_nothing_is_asked_of_a_part() -> None:
    """A period has no subject, so slips about the whole scene apply."""
    study, words = spring_block().told()
    query = KINDS["period"].draw(study, words, {}, np.random.default_rng(1))
    assert query is not None
    answer = KINDS["period"].answer(query, study)
    assert answer is not None
    found = Candidate(study, Question("numeric", query, "?", answer, "s"), "a b c")
    assert list(find_effects(MISCONCEPTIONS["length as extension"], found))


def test_a_string_that_is_slack_at_once_is_not_called_taut() -> None:
    """Two blocks that slide down a slope with the same acceleration leave the string between them slack."""
    assert not reason("taut", candidate(half_atwood(), AtTime(0.5), Target("velocity", "ramp.blocks.0")))
    lower, upper = Block(mass=1.0), Block(mass=2.0)
    sliding = TwoSideMassPlane(plane=Plane(angle=30.0, friction=0.1), blocks=(lower, upper))
    scene = Scene(entities=(Named(name="ramp", entity=sliding),))
    assert "slack" in reason("taut", candidate(scene, AtTime(0.5), Target("velocity", "ramp.blocks.0")))
    refused = Counter[str]()
    search = QuestionSearch(scene, 1)
    assert search.ask(MODES["numeric"], np.random.default_rng(1), refused, "state") is None
    assert refused["taut"] == 1, "nothing else is asked about a scene like that"
