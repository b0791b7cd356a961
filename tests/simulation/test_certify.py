"""Tests that certificates accept two correct engines and cut at the right time if one is falsified."""

import json
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

import machines
from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import Mechanism, X
from sim2reason.scenes.dsl.state import State
from sim2reason.simulation import certify as module
from sim2reason.simulation.certify import EVENTFUL_RTOL, SMOOTH_RTOL, Certificate, certify, compare, truncated
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.trace import ENGINES, Channel, Event, Trace
from states import altered

TIMES = np.linspace(0.0, 2.0, 201)
STEP = TIMES[1]
Falsify = Callable[[State], State]


def both(mechanism: Mechanism) -> tuple[Trace, Trace]:
    return ENGINES["exact"](mechanism, TIMES), ENGINES["mujoco"](mechanism, TIMES)


def against(mechanism: Mechanism, falsify: Falsify) -> Certificate:
    recorded, witness = both(mechanism)
    return compare(recorded, replace(witness, state=falsify(witness.state)))


def with_events(mechanism: Mechanism, change: Callable[[list[Event]], list[Event]]) -> Certificate:
    recorded, witness = both(mechanism)
    return compare(recorded, replace(witness, events=tuple(change(list(witness.events)))))


@pytest.mark.parametrize("name", machines.SAMPLES)
def test_true_engines_are_certified_to_the_physical_end(name: str) -> None:
    mechanism = machines.SAMPLES[name]()
    trace, certificate = certify(mechanism, TIMES)
    recorded = ENGINES["exact"](mechanism, TIMES)
    assert certificate.reason == recorded.cut == trace.cut
    assert trace.stable_until == pytest.approx(recorded.stable_until, abs=1e-6)
    subjects = [(q.name, s) for q in QUANTITIES.values() for s in q.subjects(mechanism)]
    everything = {Channel(s, q) for q, s in subjects}
    drawn = {channel for channel in everything if QUANTITIES[channel.quantity].drawn_by_recipes}
    assert set(certificate.until) == set(certificate.agreement) == drawn
    assert set(certificate.until.values()) == {certificate.stable_until}
    assert {certificate.trusted(channel) for channel in drawn} == {certificate.stable_until}
    assert all(certificate.trusted(channel) >= 0.0 for channel in everything - drawn)
    assert max(certificate.agreement.values()) <= 1e-6


def test_the_tolerance_depends_on_what_happens() -> None:
    assert compare(*both(machines.atwood(2.0, 2.2))).tolerance == SMOOTH_RTOL
    assert compare(*both(machines.atwood())).tolerance == SMOOTH_RTOL  # a block that reaches its pulley jerks nothing
    assert compare(*both(machines.carts())).tolerance == EVENTFUL_RTOL


def test_a_coordinate_scaled_by_a_thousandth_is_noticed() -> None:
    """The error grows as t², and passes 1e-4 of the largest displacement at T·√0.1.

    The string's length is compared with a floor of 0.1 m, and reveals the error sooner.
    """
    certificate = against(machines.atwood(2.0, 2.2), lambda s: altered(s, q=s.q * np.array([1.001, 1.0])))
    assert certificate.reason == "the engines disagree on the length of rope"
    a = 0.2 / 4.2 * 9.8
    assert certificate.stable_until == pytest.approx(np.sqrt(2.0 * 0.01 / a), abs=2 * STEP)
    parted = certificate.agreement[Channel("left", "displacement")]
    assert parted == pytest.approx(1e-3, rel=0.01)
    assert certificate.agreement[Channel("right", "displacement")] <= 1e-8


def test_a_falling_body_scaled_by_a_thousandth_is_noticed() -> None:
    builder = Builder()
    builder.room().body("stone", 1.0).slide((0.0, 0.0, 1.0))
    certificate = against(builder.finish(), lambda s: altered(s, q=s.q * 1.001))
    assert certificate.reason == "the engines disagree on the displacement of stone"
    assert certificate.stable_until == pytest.approx(2.0 * np.sqrt(0.1), abs=2 * STEP)
    assert certificate.until[Channel("stone", "displacement")] == certificate.stable_until


def test_an_error_of_a_thousandth_passes_where_impacts_allow_it() -> None:
    certificate = against(machines.discs(), lambda s: altered(s, q=s.q * 1.0009))
    assert certificate.reason == ""
    assert certificate.stable_until == 2.0


def test_a_force_of_the_wrong_sign_is_noticed_at_once() -> None:
    certificate = against(machines.tied_incline(), lambda s: altered(s, friction={"block": -s.friction["block"]}))
    assert certificate.stable_until == 0.0
    assert certificate.reason == "the engines disagree on the friction force of block"
    assert not certificate.covers(Channel("block", "friction force"), 0.01)
    certificate = against(
        machines.atwood(2.0, 2.2), lambda s: altered(s, constraint_tension={"rope": -s.tension["rope"]})
    )
    assert certificate.reason == "the engines disagree on the tension of rope"


def test_an_error_from_some_moment_on_cuts_just_before() -> None:
    def jump(state: State) -> State:
        return altered(state, v=state.v + np.where(state.times >= 0.7, 0.01, 0.0)[:, None])

    certificate = against(machines.atwood(2.0, 2.2), jump)
    assert certificate.stable_until == pytest.approx(0.7 - STEP)
    assert certificate.covers(Channel("left", "velocity"), 0.69)
    assert not certificate.covers(Channel("left", "velocity"), 0.71)


@pytest.mark.parametrize("change", ["missed", "invented", "shifted", "renamed", "other kind", "swapped"])
def test_an_event_that_differs_cuts_there(change: str) -> None:
    """The carts collide at 0.214 s, when a string goes slack; it snaps taut at 0.857 s."""

    def falsify(events: list[Event]) -> list[Event]:
        hit, slack, taut, *rest = events
        match change:
            case "missed":
                return [hit, slack, *rest]
            case "invented":
                return [hit, slack, Event(0.5, "slip", ("runner",)), taut, *rest]
            case "shifted":
                return [hit, slack, replace(taut, time=taut.time + 0.01), *rest]
            case "renamed":
                return [hit, slack, replace(taut, subjects=("another",)), *rest]
            case "other kind":
                return [hit, slack, replace(taut, kind="slack"), *rest]
            case _:
                return [hit, replace(taut, time=slack.time), slack, *rest]

    certificate = with_events(machines.carts(), falsify)
    expected = {"invented": 0.5, "swapped": 0.2142}.get(change, 0.8575)
    assert certificate.reason.startswith("only one engine sees")
    assert certificate.stable_until == pytest.approx(expected, abs=1e-4)


def test_a_small_shift_of_an_event_is_forgiven_and_hides_its_surroundings() -> None:
    certificate = with_events(
        machines.carts(restitution=0.0), lambda events: [replace(e, time=e.time + 1.5e-4) for e in events]
    )
    assert certificate.reason == "reach"
    assert [match.apart for match in certificate.matched] == pytest.approx([1.5e-4] * 4, abs=1e-6)
    start, stop = certificate.blind[0]
    assert stop - start == pytest.approx(4 * 1.5e-4, rel=0.05)
    assert not certificate.covers(Channel("target", "velocity"), certificate.matched[0].event.time)


def test_events_of_different_things_may_swap() -> None:
    one, two = Event(1.0, "stick", ("a",)), Event(1.00001, "stick", ("b",))
    recorded, witness = both(machines.atwood(2.0, 2.2))
    certificate = compare(
        replace(recorded, events=(one, two)),
        replace(witness, events=(replace(two, time=1.0), replace(one, time=1.00001))),
    )
    assert certificate.reason == ""
    assert len(certificate.matched) == 2


def test_an_event_just_before_the_end_is_ignored() -> None:
    late = Event(2.0 - 1e-4, "stick", ("a",))
    recorded, witness = both(machines.atwood(2.0, 2.2))
    assert compare(replace(recorded, events=(late,)), witness).reason == ""


def test_a_turn_needs_no_match() -> None:
    recorded, witness = both(machines.atwood(3.0, 2.0, speed=2.0))
    assert any(event.kind == "turn" for event in recorded.events)
    still = [event for event in witness.events if event.kind != "turn"]
    assert compare(recorded, replace(witness, events=tuple(still))).reason == ""


def test_a_witness_that_ends_sooner_ends_the_certificate() -> None:
    recorded, witness = both(machines.atwood(2.0, 2.2))
    sooner = replace(witness, stable_until=0.5, cut="limit", events=(Event(0.5, "limit", ("left.slide",)),))
    certificate = compare(recorded, sooner)
    assert certificate.stable_until == 0.5
    assert truncated(recorded, certificate).cut == "certificate"


def test_what_one_engine_leaves_open_is_not_compared() -> None:
    def unknown(state: State) -> State:
        return altered(state, constraint_tension={"rope": np.where(state.times > 0.4, np.nan, state.tension["rope"])})

    certificate = against(machines.atwood(2.0, 2.2), unknown)
    assert certificate.stable_until == 2.0
    assert certificate.until[Channel("rope", "tension")] == pytest.approx(0.4)
    assert certificate.until[Channel("left", "velocity")] == 2.0


def test_a_scene_at_rest_is_measured_by_floors() -> None:
    builder = Builder()
    builder.room().body("block", 1.0).rest(X, (0.0, 0.0, 1.0), 0.5)
    certificate = against(builder.finish(), lambda s: altered(s, q=s.q + 1e-6, v=s.v + 1e-6))
    assert certificate.reason == ""
    certificate = against(builder.finish(), lambda s: altered(s, q=s.q + 1e-4))
    assert certificate.reason == "the engines disagree on the displacement of block"


def test_no_witness_no_certificate(monkeypatch: pytest.MonkeyPatch) -> None:
    def helpless(_: Mechanism, __: np.ndarray) -> Trace:
        raise SimulationError("friction may be too strong")

    monkeypatch.setattr(module, "ENGINES", {"exact": ENGINES["exact"], "mujoco": helpless})
    trace, certificate = certify(machines.atwood(), TIMES)
    assert certificate.reason == "no witness: friction may be too strong"
    assert (trace.stable_until, trace.cut) == (0.0, "certificate")
    assert not certificate.covers(Channel("left", "velocity"), 0.0)


def test_a_certificate_is_plain_json() -> None:
    _, certificate = certify(machines.carts(), TIMES)
    document = json.loads(json.dumps(certificate.document(), allow_nan=False))
    assert document["engines"] == ["exact", "mujoco"]
    assert document["stable_until"] == certificate.stable_until
    assert document["matched"][0][:2] == ["collision", ["runner", "target"]]
    assert len(document["channels"]) == len(certificate.agreement)


@pytest.mark.parametrize("factor", [1.003, 0.997])
def test_a_witness_on_another_planet_is_noticed(factor: float) -> None:
    mechanism = machines.wedge(friction=0.1, floor=0.05, weight=1.5)
    heavier = replace(mechanism, gravity=(0.0, 0.0, -9.8 * factor))
    certificate = compare(ENGINES["exact"](mechanism, TIMES), ENGINES["mujoco"](heavier, TIMES))
    assert certificate.stable_until == 0.0
