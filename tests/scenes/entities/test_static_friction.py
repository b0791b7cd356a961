"""Tests of static friction greater than kinetic friction: motions, texts, questions, solutions, figures."""

from math import atan, cos, degrees, radians, sin, tan

import numpy as np
import pytest

from sim2reason.authoring import Entity, Frame, X, Z, either
from sim2reason.datasets.scene_questions import solve
from sim2reason.errors import SceneError
from sim2reason.figures.drawing import drawing
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.simple_machines import Plane
from sim2reason.scenes.dsl.entity import ENTITIES
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import dump, loads
from sim2reason.simulation.scenes import certify
from sim2reason.testing.specimens import specimen
from sim2reason.text.parsing import parse_scene
from sim2reason.text.prose import describe

G, M, KINETIC, STATIC = 9.8, 2.0, 0.2, 0.5
CLOSE = 1e-9  # relative
RESTS = pytest.mark.parametrize("angle", [5.0, 15.0, 26.0])
SLIDES = pytest.mark.parametrize("angle", [27.0, 40.0, 60.0])
ROUGH = (
    "MassBoxPlane",
    "MassPrismPlane",
    "MassWithFixedPulley",
    "RollingEntity",
    "SpringMassChain",
    "SpringMassIncline",
    "StackedMassPlane",
    "TwoSideMassPlane",
)
SEEDS = 40  # of which one has both coefficients


def slope(angle: float, speed: float = 0.0, static: float | None = STATIC) -> Scene:
    """Build a block on a plane with both coefficients of friction."""
    plane = f"{{angle: {angle}, friction: {KINETIC}{f', static_friction: {static}' if static else ''}}}"
    more = f", speed: {speed}" if speed else ""
    parameters = f"{{plane: {plane}, blocks: [{{mass: {M}}}]{more}}}"
    return loads(f"scene: {{entities: [{{name: it, type: TwoSideMassPlane, parameters: {parameters}}}]}}")


def sphere(angle: float) -> Scene:
    """Build a sphere on a plane with both coefficients of friction."""
    grip = f"{{kind: rough, friction: {KINETIC}, static_friction: {STATIC}}}"
    parameters = f"{{plane: {{angle: {angle}}}, body: {{kind: sphere, radius: 0.1, mass: {M}}}, grip: {grip}}}"
    return loads(f"scene: {{entities: [{{name: it, type: RollingEntity, parameters: {parameters}}}]}}")


def oscillator(stretch: float) -> Scene:
    """Build a cart of 1 kg on a spring of 100 N/m on a rough track."""
    track = f"{{friction: {KINETIC}, static_friction: {STATIC}}}"
    rest = f"ends: left, springs: [{{stiffness: 100.0}}], strain: {{way: stretched, by: {stretch}}}"
    parameters = f"{{track: {track}, carts: [{{mass: 1.0}}], {rest}}}"
    return loads(f"scene: {{entities: [{{name: it, type: SpringMassChain, parameters: {parameters}}}]}}")


def told(scene: Scene) -> list[float | None]:
    """Return all numbers that the text states."""
    return [p.value for p in scene.parameters if not p.hidden]


@RESTS
def test_what_static_friction_holds_stays_at_rest(angle: float) -> None:
    """Static friction is f = m g sin θ, on slopes where kinetic friction alone would not hold the block."""
    trace, certificate = certify(slope(angle))
    assert certificate.stable_until == trace.state.times[-1]
    assert np.abs(trace.state.q).max() == 0.0
    assert trace.state.friction["it.blocks.0"] == pytest.approx(M * G * sin(radians(angle)), rel=CLOSE)


@SLIDES
def test_what_slides_is_rubbed_by_kinetic_friction(angle: float) -> None:
    """The acceleration is a = g (sin θ − µ_k cos θ)."""
    trace, certificate = certify(slope(angle))
    assert certificate.stable_until == trace.state.times[-1]
    wanted = G * (sin(radians(angle)) - KINETIC * cos(radians(angle)))
    assert -trace.state.a[:, 0] == pytest.approx(wanted, rel=CLOSE)


@pytest.mark.parametrize(("angle", "back"), [(20.0, False), (30.0, True)])
def test_a_block_thrown_up_a_slope_stays_where_static_friction_holds_it(angle: float, back: bool) -> None:
    """The block rises by v²/(2 g (sin θ + µ_k cos θ)), and slides back only if tan θ > µ_s."""
    trace, certificate = certify(slope(angle, speed=3.0))
    assert certificate.stable_until == trace.state.times[-1]
    way = 9.0 / (2.0 * G * (sin(radians(angle)) + KINETIC * cos(radians(angle))))
    highest = float(trace.scan.q[:, 0].max())
    assert highest == pytest.approx(way, rel=1e-6)
    assert bool(trace.state.v[-1, 0] < -0.1) is back


def test_a_spring_stops_where_it_pulls_less_than_static_friction() -> None:
    """Turning points approach the middle by 2 µ_k m g/k; the cart stops at the first with k |x| ≤ µ_s m g."""
    place, step, hold = 0.2, 2.0 * KINETIC * G / 100.0, STATIC * G / 100.0
    while abs(place) > hold:
        place = -place + (step if place > 0.0 else -step)
    trace, certificate = certify(oscillator(0.2), duration=2.0)
    assert certificate.stable_until == trace.state.times[-1]
    assert trace.state.q[-1, 0] + 0.2 == pytest.approx(place, rel=1e-8)
    assert abs(place) > KINETIC * G / 100.0  # kinetic friction alone would let it go on


def test_a_sphere_rolls_up_to_static_friction_and_slips_with_kinetic() -> None:
    """The sphere slips where tan θ > 7/2 µ_s, with a = g (sin θ − µ_k cos θ)."""
    for angle, slips in ((60.0, False), (61.0, True)):
        trace, certificate = certify(sphere(angle))
        assert certificate.stable_until == trace.state.times[-1]
        lean = radians(angle)
        wanted = sin(lean) - KINETIC * cos(lean) if slips else 5.0 / 7.0 * sin(lean)
        assert -trace.state.a[:, 0] == pytest.approx(G * wanted, rel=CLOSE)


@pytest.mark.parametrize("name", ROUGH)
def test_every_rough_entity_tells_both_and_is_read_back(name: str) -> None:
    """Both coefficients are drawn, described, parsed and saved for every entity with friction."""
    cls = ENTITIES[name]
    scenes = (specimen(cls, seed).scene for seed in range(SEEDS))
    scene = next(s for s in scenes if any(p.value and p.path.endswith("static_friction") for p in s.parameters))
    assert loads(dump(scene)) == scene
    for seed in range(3):
        text = describe(scene, seed).text
        assert told(parse_scene(text).scene) == told(scene), text
        assert "static and kinetic" in text or "static friction" in text


def test_their_symbols_say_which_is_which() -> None:
    """The symbols are µ_s and µ_k if both are given, else µ."""
    both, one = describe(slope(20.0), 0, "symbolic").text, describe(slope(20.0, static=None), 0, "symbolic").text
    assert r"$\mu_s$ and $\mu_k$" in both
    assert r"$\mu$" in one


@pytest.mark.parametrize(
    ("scene", "parts", "answer"),
    [
        (slope(20.0), {"find": "it.plane.static_friction", "when": "slides"}, tan(radians(20.0))),
        (slope(20.0), {"find": "it.plane.angle", "when": "slides"}, degrees(atan(STATIC))),
        (sphere(40.0), {"find": "it.plane.angle", "when": "slips rolling"}, degrees(atan(3.5 * STATIC))),
        (slope(20.0, 3.0), {"find": "friction force", "when": "2 s"}, M * G * sin(radians(20.0))),
        (slope(20.0, 3.0), {"find": "friction force", "when": "0.1 s"}, KINETIC * M * G * cos(radians(20.0))),
        (
            slope(20.0, 3.0),
            {"find": "it.plane.friction", "when": "stopped", "given": "displacement = 0.8 m"},
            (9.0 / (1.6 * G) - sin(radians(20.0))) / cos(radians(20.0)),
        ),
        (oscillator(0.2), {"find": "displacement", "when": "halted"}, 0.2 - 0.0432),
    ],
)
def test_either_can_be_asked_for_and_decides_answers(scene: Scene, parts: dict[str, str], answer: float) -> None:
    """Structured questions agree with closed forms."""
    assert solve(scene, question=parts).answer == pytest.approx(answer, rel=1e-6)


@pytest.mark.parametrize(
    ("scene", "parts", "said"),
    [
        (slope(20.0), {"find": "it.plane.static_friction", "when": "slides"}, r"\mu_s m g \cos\theta - m g \sin\theta"),
        (slope(20.0), {"find": "it.plane.angle", "when": "slides"}, r"\arctan\mu_s"),
        (slope(20.0, 3.0), {"find": "displacement", "when": "stopped"}, r"\sin\theta + \mu_k \cos\theta"),
        (sphere(55.0), {"find": "displacement", "when": "1 s"}, r"f_{\text{max}} = \mu_s m g \cos\theta"),
        (sphere(65.0), {"find": "velocity", "when": "1 s"}, r"more than $f_{\text{max}} = \mu_s m g \cos\theta"),
        (oscillator(0.2), {"find": "displacement", "when": "halted"}, r"f_{\text{max}} = \mu_s m g"),
    ],
)
def test_solutions_name_the_one_that_acts(scene: Scene, parts: dict[str, str], said: str) -> None:
    """The solution compares the force on a body at rest with µ_s N, and uses µ_k N for a sliding one."""
    solution = solve(scene, question=parts).solution
    assert solution is not None
    assert said in solution.text


def test_a_figure_shows_both() -> None:
    """The figure labels both coefficients as the text does."""
    scene = slope(20.0)
    labels = {label.text for label in drawing(scene, describe(scene)).labels}
    assert r"$\mu_s$ = 0.50, $\mu_k$ = 0.20" in labels


@pytest.mark.parametrize("static", [0.1, KINETIC])
def test_it_is_greater_than_kinetic_friction(static: float) -> None:
    """A smaller or equal static coefficient is refused."""
    with pytest.raises(SceneError, match=r"static_friction.*not greater than friction.*leave it out"):
        slope(20.0, static=static)


def test_an_entity_without_words_for_it_refuses_it() -> None:
    """An entity whose sentences omit the static coefficient still works without one."""

    class Shelf(Entity):
        """Block on a plane."""

        plane: Plane
        block: Block

        says = (
            either("{block} lies on {plane}.", "on {plane} lies {block}.", "{plane} carries {block}."),
            either(*(f"µ is {{plane.friction}}{end}" for end in (".", " there.", " here."))),
        )

        def build(self, room: Frame) -> None:
            room.body("block", self.block.mass).rest(X, Z, self.plane.friction)

    block = Block(mass=1.0)
    assert Shelf(plane=Plane(angle=0.0, friction=0.3), block=block).plane.friction == 0.3
    with pytest.raises(ValueError, match=r"plane\.static_friction: no line of Shelf tells it"):
        Shelf(plane=Plane(angle=0.0, friction=0.3, static_friction=0.4), block=block)
