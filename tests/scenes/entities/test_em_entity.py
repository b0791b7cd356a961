"""Tests of a charged bead in all kinds of fields, media and regions, against closed forms."""

from math import atan, cos, hypot, pi, radians, sin, sqrt, tan

import numpy as np
import pytest
from pydantic import ValidationError

from lone_entities import alone, close, drawn, followed, happened, planar
from sim2reason.questions.prompt import words_of
from sim2reason.scenes.bodies.charges import (
    ChargedBead,
    CircularRegion,
    HalfPlane,
    Launched,
    Rectangle,
    Released,
    Strip,
)
from sim2reason.scenes.dsl.template import Wordings
from sim2reason.scenes.entities.fields import (
    ElectricField,
    ForceField,
    LinearDrag,
    LinearElectric,
    LinearMagnetic,
    QuadraticDrag,
    UniformElectric,
    UniformMagnetic,
)
from sim2reason.scenes.entities.particles import EmEntity
from sim2reason.scenes.entities.varying_fields import DipoleMagnetic, GrowingElectric, OscillatingElectric
from sim2reason.text.parsing.scene_parser import parse_scene
from sim2reason.text.prose.description import describe

BEAD = ChargedBead(mass=2.0, charge=3.0, sign="positive")
RATIO = 1.5  # C/kg, of its charge to its mass
AHEAD = Launched(speed=2.0, angle=0.0)
OUT = UniformMagnetic(strength=0.8, way="positive z")
OMEGA = RATIO * 0.8


@pytest.mark.parametrize(("sign", "way", "sense"), [("positive", "positive z", -1.0), ("negative", "positive z", 1.0)])
def test_a_circle(sign: str, way: str, sense: float) -> None:
    """The angular frequency is ω = qB/m (100 turns, J. J. Thomson, 1897).

    With B out of the plane, a positive charge turns clockwise.
    """
    bead = ChargedBead.model_validate({"mass": 2.0, "charge": 3.0, "sign": sign})
    field = UniformMagnetic.model_validate({"strength": 0.8, "way": way})
    trace = followed(EmEntity(magnetic=field, particle=bead, start=AHEAD), 200.0 * pi / OMEGA, 801)
    t = trace.state.times
    x, y, vx, vy = planar(trace)
    close(x, 2.0 / OMEGA * np.sin(OMEGA * t))
    close(y, sense * 2.0 / OMEGA * (1.0 - np.cos(OMEGA * t)))
    close(np.hypot(vx, vy), 2.0)


@pytest.mark.parametrize("start", [Released(), AHEAD, Launched(speed=1.5, angle=200.0)])
def test_crossed_fields(start: Launched | Released) -> None:
    """With E up and B out of the plane, the bead circles about a drift E/B to the right; from rest, a cycloid.

    With w = v_x + iv_y, dw/dt = −iωw + ia has w = a/ω + (w₀ − a/ω) e^{−iωt} (L. D. Landau, E. M. Lifshitz, § 22).
    """
    electric = UniformElectric(strength=1.1, way="positive y")
    trace = followed(EmEntity(magnetic=OUT, electric=electric, particle=BEAD, start=start), 15.0)
    t, began, drift = trace.state.times, complex(*start.velocity), 1.1 / 0.8
    turned = np.exp(-1j * OMEGA * t)
    w, s = drift + (began - drift) * turned, drift * t + (began - drift) * (1.0 - turned) / (1j * OMEGA)
    x, y, vx, vy = planar(trace)
    close(np.abs(vx + 1j * vy - w), 0.0, 1.0)
    close(np.abs(x + 1j * y - s), 0.0, 1.0)


@pytest.mark.parametrize(("trend", "sign"), [("increases", "positive"), ("decreases", "positive")])
def test_a_field_that_changes_along_its_own_axis(trend: str, sign: str) -> None:
    """With ẍ = a + kx, x = (a/k)(cosh √k t − 1) in a growing field, and with cos in a decreasing one."""
    values = {"strength": 0.9, "way": "positive x", "trend": trend, "axis": "x", "slope": 0.7}
    bead = ChargedBead.model_validate({"mass": 2.0, "charge": 3.0, "sign": sign})
    trace = followed(EmEntity(electric=LinearElectric.model_validate(values), particle=bead, start=Released()), 3.0)
    t, root = trace.state.times, sqrt(RATIO * 0.7)
    grown = np.cosh(root * t) - 1.0 if trend == "increases" else 1.0 - np.cos(root * t)
    close(trace.state.q[:, 0], 0.9 / 0.7 * grown)
    close(trace.state.q[:, 1], 0.0, 1.0)


def test_a_field_that_grows_with_time() -> None:
    """The displacement is y = −(a t²/2 + r t³/6) in a field along −y."""
    field = GrowingElectric(strength=0.5, way="negative y", trend="increases", growth=0.3)
    trace = followed(EmEntity(electric=field, particle=BEAD, start=Released()), 4.0)
    t = trace.state.times
    close(trace.state.q[:, 1], -RATIO * (0.25 * t**2 + 0.05 * t**3))


def test_a_field_that_oscillates() -> None:
    """The motion is v = (a/ω) sin ωt, x = (a/ω²)(1 − cos ωt)."""
    field = OscillatingElectric(strength=1.2, way="negative x", frequency=2.5)
    trace = followed(EmEntity(electric=field, particle=BEAD, start=Released()), 6.0)
    t = trace.state.times
    close(trace.state.v[:, 0], -RATIO * 1.2 / 2.5 * np.sin(2.5 * t))
    close(trace.state.q[:, 0], -RATIO * 1.2 / 2.5**2 * (1.0 - np.cos(2.5 * t)))


def test_a_spiral_with_drag() -> None:
    """The equation dw/dt = −(γ + iω) w has the solution w = w₀ e^{−(γ+iω)t}."""
    drag = LinearDrag(coefficient=0.8)
    trace = followed(EmEntity(magnetic=OUT, medium=drag, particle=BEAD, start=AHEAD), 10.0)
    rate = complex(0.8 / 2.0, OMEGA)
    s = 2.0 * (1.0 - np.exp(-rate * trace.state.times)) / rate
    x, y, _, _ = planar(trace)
    close(np.abs(x + 1j * y - s), 0.0, 1.0)


def test_a_terminal_speed() -> None:
    """The equation m dv/dt = qE − cv² has the solution v = √(qE/c) tanh(t √(qEc)/m)."""
    electric, drag = UniformElectric(strength=0.9, way="positive x"), QuadraticDrag(coefficient=0.4)
    trace = followed(EmEntity(electric=electric, medium=drag, particle=BEAD, start=Released()), 8.0)
    push, c, m = 3e-3 * 0.9, 0.4e-3, 2e-3
    close(trace.state.v[:, 0], sqrt(push / c) * np.tanh(trace.state.times * sqrt(push * c) / m))


@pytest.mark.parametrize("trend", ["increases", "decreases"])
def test_a_magnetic_field_with_a_gradient_keeps_a_momentum(trend: str) -> None:
    """In B = B₀ ± βx, v² and mv_y + q(B₀x ± βx²/2) are constant (the canonical momentum along y)."""
    values = {"strength": 0.9, "way": "positive z", "trend": trend, "axis": "x", "slope": 0.3}
    start = Launched(speed=2.0, angle=40.0)
    trace = followed(EmEntity(magnetic=LinearMagnetic.model_validate(values), particle=BEAD, start=start), 12.0)
    x, _, vx, vy = planar(trace)
    slope = 0.3 if trend == "increases" else -0.3
    close(np.hypot(vx, vy), 2.0)
    close(vy + RATIO * (0.9 * x + 0.5 * slope * x**2), 2.0 * sin(radians(40.0)), 2.0)


def test_a_dipole_keeps_speed_and_stoermers_momentum() -> None:
    """In the equatorial plane v and m(r × v)_z − qb/r are constant (C. Størmer, 1907)."""
    field = DipoleMagnetic(strength=2.0, way="positive z", x=1.2, y=-0.4)
    trace = followed(EmEntity(magnetic=field, particle=BEAD, start=Launched(speed=2.5, angle=330.0)), 6.0)
    x, y, vx, vy = planar(trace)
    across, up = x - 1.2, y + 0.4
    momentum = across * vy - up * vx - RATIO * 2.0 / np.hypot(across, up)
    close(np.hypot(vx, vy), 2.5)
    close(momentum, momentum[0])


@pytest.mark.parametrize("angle", [0.0, 35.0, 320.0])
def test_a_half_plane(angle: float) -> None:
    """The bead leaves after an arc of π + 2α, 2mv cos α/(qB) along the border from its entry."""
    start, edge = Launched(speed=2.0, angle=angle), 0.6
    alpha = radians(angle if angle < 180.0 else angle - 360.0)
    enter = edge / (2.0 * cos(alpha))
    leave = enter + (pi + 2.0 * alpha) / OMEGA
    entity = EmEntity(magnetic=OUT, region=HalfPlane(edge=edge), particle=BEAD, start=start)
    trace = followed(entity, leave + 0.5)
    assert [kind for kind, _ in happened(trace)] == ["enter", "exit"]
    close([time for _, time in happened(trace)], [enter, leave])
    at = trace.sample(np.array([leave])).q[0]
    close(at, [edge, edge * tan(alpha) - 2.0 * 2.0 * cos(alpha) / OMEGA], 1.0)


@pytest.mark.parametrize("radius", [0.3, 0.9])
def test_a_circle_of_field_aimed_at_its_centre(radius: float) -> None:
    """The velocity on exit is radial too, turned by φ with tan(φ/2) = R/r_L."""
    center = (1.5 * cos(radians(30.0)), 1.5 * sin(radians(30.0)))
    entity = EmEntity(
        magnetic=OUT,
        region=CircularRegion(radius=radius, x=center[0], y=center[1]),
        particle=BEAD,
        start=Launched(speed=2.0, angle=30.0),
    )
    turned = 2.0 * atan(radius * OMEGA / 2.0)
    enter = (1.5 - radius) / 2.0
    trace = followed(entity, enter + turned / OMEGA + 0.4)
    close([time for _, time in happened(trace)], [enter, enter + turned / OMEGA])
    way = radians(30.0) - turned
    close(trace.state.v[-1], [2.0 * cos(way), 2.0 * sin(way)])


@pytest.mark.parametrize("region", [Strip(low=0.5, high=1.7), Rectangle(left=0.5, bottom=-1.0, right=1.7, top=1.0)])
def test_a_capacitor(region: Strip | Rectangle) -> None:
    """The deflection is aL²/2v² in the field, and the slope of the path after it aL/v²."""
    electric = UniformElectric(strength=0.6, way="negative y")
    trace = followed(EmEntity(electric=electric, region=region, particle=BEAD, start=AHEAD), 1.5)
    inside, a = 1.2 / 2.0, -RATIO * 0.6
    assert [kind for kind, _ in happened(trace)] == ["enter", "exit"]
    close([time for _, time in happened(trace)], [0.25, 0.85])
    close(trace.sample(np.array([0.85, 1.5])).q[:, 1], [0.5 * a * inside**2, 0.5 * a * inside**2 + a * inside * 0.65])


def test_a_filter_of_velocities() -> None:
    """With E = vB the bead passes straight through both fields; its entry into their region is one event."""
    electric = UniformElectric(strength=1.6, way="positive y")
    region = CircularRegion(radius=0.5, x=1.0, y=0.0)
    entity = EmEntity(magnetic=OUT, electric=electric, region=region, particle=BEAD, start=AHEAD)
    trace = followed(entity, 1.5)
    close([time for _, time in happened(trace)], [0.25, 0.75])
    close(trace.state.q[:, 1], 0.0, 1.0)


def test_drawn_fields_turn_the_bead_by_some_radians_and_are_reached() -> None:
    """The turn ω_c·T is 1–12 rad, E/(Bv) is about one, and a bead aimed at a region enters it."""
    reached = 0
    for seed in range(60):
        scene = drawn("EmEntity", seed)
        entity = scene.entities[0].entity
        assert isinstance(entity, EmEntity)
        mass, charge = entity.particle.mass, entity.particle.signed_charge
        if entity.magnetic is not None and entity.region is None:
            assert 0.5 < entity.magnetic.rate(charge, mass) * scene.horizon < 12.0
        if entity.region is not None and isinstance(entity.start, Launched):
            reached += 1
            assert hypot(*entity.region.middle) / entity.start.speed < scene.horizon
            kinds = [kind for kind, _ in happened(followed(entity, scene.horizon, 41), "enter")]
            assert kinds == ["enter"] * len(kinds)
            assert kinds
    assert reached > 10


def test_no_field_at_rest_has_a_curl() -> None:
    """A static electric field has ∂E_x/∂y = ∂E_y/∂x."""
    values = {"strength": 1.0, "way": "negative x", "trend": "increases", "slope": 0.5}
    assert LinearElectric.model_validate({**values, "axis": "x"}).axis == "x"
    with pytest.raises(ValidationError, match="axis: a field at rest does not change across its direction"):
        LinearElectric.model_validate({**values, "axis": "y"})


@pytest.mark.parametrize(
    ("fields", "says"),
    [
        ({"start": AHEAD}, "there is no field"),
        ({"start": Released(), "magnetic": OUT}, "does nothing to a bead at rest"),
        (
            {
                "start": Released(),
                "electric": UniformElectric(strength=1.0, way="positive x"),
                "region": HalfPlane(edge=0.5),
            },
            "no field where the bead is released",
        ),
    ],
)
def test_what_does_not_move_is_refused(fields: dict[str, object], says: str) -> None:
    with pytest.raises(ValidationError, match=says):
        EmEntity(particle=BEAD, **fields)  # type: ignore[arg-type]


def test_a_bead_starts_at_the_origin_at_t_0() -> None:
    """The text mentions neither a release of the system nor g."""
    scene = alone(EmEntity(magnetic=OUT, particle=BEAD, start=AHEAD))
    assert not scene.starts_from_rest


@pytest.mark.parametrize(
    ("sign", "number", "symbol"),
    [
        ("positive", "a positive charge of 3.0 µC", "a positive charge of $q$"),
        ("negative", "a negative charge of magnitude 3.0 µC", "a negative charge of magnitude $q$"),
    ],
)
def test_the_number_is_the_size_of_a_charge_and_words_tell_its_sign(sign: str, number: str, symbol: str) -> None:
    bead = ChargedBead.model_validate({"mass": 2.0, "charge": 3.0, "sign": sign})
    scene = alone(EmEntity(magnetic=OUT, particle=bead, start=AHEAD))
    for seed in range(4):
        assert number in describe(scene, seed).text
        assert symbol in describe(scene, seed, "symbolic").text
    asked = next(u for u in words_of(describe(scene)).unknowns if u.path == "it.particle.charge")
    assert all("magnitude of the charge" in phrase for phrase in asked.phrases[:-1])


@pytest.mark.parametrize("law", [LinearElectric, LinearMagnetic, GrowingElectric])
def test_the_text_says_which_way_a_changing_field_points(law: type[ForceField]) -> None:
    """A component alone could be negative, so that a question about it might have two answers."""
    saying = law.says[0]
    assert isinstance(saying, Wordings)
    assert all("magnitude {strength}" in told and "points in {direction}" in told for told in saying.wordings)


def electric(text: str) -> ElectricField | None:
    """Return the electric field of the scene that a text describes."""
    entity = parse_scene(text).scene.entities[0].entity
    assert isinstance(entity, EmEntity)
    return entity.electric


@pytest.mark.parametrize(("way", "trend", "does"), [("positive", "increases", "in"), ("negative", "increases", "de")])
@pytest.mark.parametrize("seed", range(4))
def test_what_changes_is_told_as_a_component_along_an_axis(way: str, trend: str, does: str, seed: int) -> None:
    """The x component of E = −(E₀ + k x) decreases with x."""
    values = {"strength": 1.1, "way": f"{way} x", "trend": trend}
    linear = LinearElectric.model_validate({**values, "axis": "x", "slope": 0.4})
    told = describe(alone(EmEntity(electric=linear, particle=BEAD, start=Released())), seed).text
    assert f"x component {does}creases with x at a rate of 0.40 N/(C·m)" in told
    assert f"the {way} x direction" in told
    assert "the only one" not in told
    assert electric(told) == linear
    growing = GrowingElectric.model_validate({**values, "growth": 0.3})
    told = describe(alone(EmEntity(electric=growing, particle=BEAD, start=Released())), seed).text
    assert f"x component {does}creases at a " in told
    assert electric(told) == growing


def test_the_strength_of_a_field_that_changes_is_not_called_the_field() -> None:
    field = LinearElectric(strength=1.1, way="positive x", trend="increases", axis="x", slope=0.4)
    words = words_of(describe(alone(EmEntity(electric=field, particle=BEAD, start=Released()))))
    assert "it.electric.strength" not in words.named
    asked = next(u for u in words.unknowns if u.path == "it.electric.strength")
    assert asked.phrases == ("the magnitude $E$", "$E$")
