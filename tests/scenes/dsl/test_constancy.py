"""Tests that masses, loads and gradients reported as constant are so, in random mechanisms and places."""

import math
from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest

from curved_mechanisms import FAMILIES
from random_mechanisms import pulleys, rough, table, wedges
from sim2reason.errors import Sim2ReasonError
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.fields import Profile, Push, Resistance
from sim2reason.scenes.dsl.frames import Frames, initial_frames
from sim2reason.scenes.dsl.mechanism import ZERO, ConstantTension, Elastic, Inextensible, Mechanism, Prop, X, Y, Z
from sim2reason.scenes.dsl.structure import changing, steady
from sim2reason.simulation.engines.exact.assembly import Assembly
from sim2reason.simulation.engines.exact.system import System
from spoiled_mechanisms import spoiled

TRIED = 40
MAKERS: dict[str, Callable[[int], Mechanism]] = {
    **FAMILIES,
    **{made.__name__: lambda seed, made=made: made(seed).finish() for made in (pulleys, wedges, table, rough)},
    "spoiled": spoiled,
}


def numbers(mechanism: Mechanism, q: list[float], v: list[float]) -> list[float]:
    """Return all entries of the equations of motion."""
    system = System(mechanism)
    assembly = Assembly(mechanism, system.phase, (q, v, 0.7), math)
    rows = assembly.rows(system.starts)
    found = [entry for row in assembly.full_mass() + assembly.lifted + assembly.heave for entry in row]
    found += [*assembly.force, *assembly.press]
    for row in rows:
        found += [row.along.get(k, 0.0) for k in range(system.size)]
        found += [row.lift.get(k, 0.0) for k in range(system.count)]
        found.append(row.target)
    return [float(entry) for entry in found]


@pytest.mark.parametrize("family", MAKERS)
def test_what_is_claimed_constant_is_constant(family: str) -> None:
    """The entries keep their values at random positions near the start, at any rates."""
    rng = np.random.default_rng(3)
    for seed in range(TRIED):
        mechanism = MAKERS[family](seed)
        try:
            System(mechanism)
            if changing(mechanism, initial_frames(mechanism)):
                continue
        except (Sim2ReasonError, ZeroDivisionError):
            continue
        n = len(mechanism.coordinates)
        began = numbers(mechanism, [0.0] * n, [0.0] * n)
        spare = min((_shortest(mechanism), 1.0))
        q = (0.1 * spare * rng.uniform(-1.0, 1.0, n)).tolist()
        now = numbers(mechanism, q, rng.normal(size=n).tolist())
        scale = max(map(abs, began), default=1.0)
        assert now == pytest.approx(began, rel=1e-9, abs=1e-9 * scale), (family, seed)


def _shortest(mechanism: Mechanism) -> float:
    frames = initial_frames(mechanism)
    found = [
        frames.distance(a, b).value
        for line in mechanism.lines
        for a, b in zip(line.through, line.through[1:], strict=False)
        if frames.site(a).place != frames.site(b).place
    ]
    return min(found, default=1.0) / (1.0 + len(mechanism.coordinates))


def _block() -> Builder:
    builder = Builder()
    builder.room().body("block", 1.0).rest(X, Z).site("hook")
    builder.room().site("nail", (1.0, 0.0, 0.0)).site("aside", (1.0, 0.0, 1.0))
    return builder


CHANGES: dict[str, Callable[[Builder], object]] = {
    "a spring": lambda b: b.room().spring("s", "nail", "hook", stiffness=1.0),
    "a rod": lambda b: b.room().rod("s", "nail", "hook"),
    "a string that bends": lambda b: b.room().string("s", "aside", "hook"),
    "drag": lambda b: b.room().body("c", 1.0).slide(Z).force("f", Resistance(1.0)),
    "a force that grows": lambda b: b.room().body("c", 1.0).slide(Z).force("f", Push(Z, Profile(1.0, rate=1.0))),
    "an engine": lambda b: b.room().body("c", 1.0).slide(Z).burn(0.1, 1.0, 1.0),
    "a pendulum": lambda b: b.room().body("c", 1.0, center=(0.0, 0.0, -1.0)).hinge(Y),
    "a round face": lambda b: b.room().body("c", 1.0).swing(Y, Z, 1.0, guided=False),
    "a foot": lambda b: b.room().body("c", 1.0).slide(X).slide(Z, name="z").stand("f", ZERO, X, Z),
    "a body that slides on one that turns": lambda b: b.room().body("c", 1.0).hinge(Y).body("d", 1.0).slide(X),
}
STAYS: dict[str, Callable[[Builder], object]] = {
    "a straight string": lambda b: b.room().string("s", "nail", "hook"),
    "a hand": lambda b: b.room().pull("s", "hook", "nail", force=1.0),
    "a strut": lambda b: b.room().prop("s", "nail", "hook"),
    "a wheel": lambda b: b.room().body("c", 1.0, inertia=(0.1, 0.1, 0.1, 0.0, 0.0, 0.0)).hinge(Y),
    "a ball that rolls": lambda b: b.room().body("c", 1.0).roll(X, Z, 0.2, 0.3),
    "a steady push": lambda b: b.room().body("c", 1.0).slide(Z).force("f", Push(Z, Profile(1.0))),
}


@pytest.mark.parametrize("name", CHANGES)
def test_what_changes_is_named(name: str) -> None:
    builder = _block()
    CHANGES[name](builder)
    mechanism = builder.finish()
    assert changing(mechanism, initial_frames(mechanism))


@pytest.mark.parametrize("name", STAYS)
def test_what_stays_is_known_to_stay(name: str) -> None:
    builder = _block()
    STAYS[name](builder)
    mechanism = builder.finish()
    assert changing(mechanism, initial_frames(mechanism)) == ""
    assert all(isinstance(line.law, Inextensible | ConstantTension | Prop) for line in mechanism.lines)


@pytest.mark.parametrize("family", FAMILIES)
def test_points_of_random_mechanisms_move_as_their_derivatives_say(family: str) -> None:
    """Velocity, bias and gradient of every centre of mass, and rate and bias of every line, match differences."""
    rng = np.random.default_rng(5)
    h = 1e-4
    for seed in range(3):
        mechanism = FAMILIES[family](seed)
        n = len(mechanism.coordinates)
        q, v = rng.uniform(-0.1, 0.1, n), rng.normal(size=n)
        now, before, after = (
            Frames(mechanism, list(map(float, q + s * h * v)), list(map(float, v)), math) for s in (0.0, -1.0, 1.0)
        )
        for body in mechanism.bodies:
            old, here, new = (np.array(frames.center(body.name).place) for frames in (before, now, after))
            point = now.center(body.name)
            assert np.array(point.velocity) == pytest.approx((new - old) / (2.0 * h), abs=1e-6)
            assert np.array(point.bias) == pytest.approx((new - 2.0 * here + old) / h**2, abs=1e-5)
            moved = sum((v[k] * np.array(way) for k, way in point.gradient.items()), np.zeros(3))
            assert moved == pytest.approx(np.array(point.velocity), abs=1e-12)
        for line in mechanism.lines:
            for one, other in zip(line.through, line.through[1:], strict=False):
                old, here, new = (frames.distance(one, other).value for frames in (before, now, after))
                run = now.distance(one, other)
                assert run.rate == pytest.approx((new - old) / (2.0 * h), abs=1e-5)
                assert run.bias == pytest.approx((new - 2.0 * here + old) / h**2, abs=1e-3)
                assert sum(v[k] * part for k, part in run.along.items()) == pytest.approx(run.rate, abs=1e-10)


def _ring() -> Builder:
    """Return two bodies that turn about one axis, with a wound spring between them."""
    builder = Builder()
    one, other = (builder.room().body(name, 1.0, center=(way, 0.0, 0.0)) for name, way in (("a", 1.0), ("b", -1.0)))
    builder.room().wind("s", one.hinge(Z), other.hinge(Z), 1.0, math.pi, Elastic(1.0, 3.0))
    return builder


def _shared() -> Builder:
    """Return a cart with a rod between two places on it, and a string that continues from the rod's end."""
    builder = _block()
    builder.room().body("cart", 1.0).slide(X).site("rear", (0.2, 0.0, 1.0)).site("front", (0.5, 0.0, 1.0))
    builder.room().rod("r", "rear", "front")
    builder.room().string("s", "front", "aside")
    return builder


KEEPERS: dict[str, Callable[[int], Mechanism]] = {
    **MAKERS,
    "ring": lambda _: _ring().finish(),
    "shared": lambda _: _shared().finish(),
}


@pytest.mark.parametrize("family", KEEPERS)
def test_directions_that_are_kept_change_no_length(family: str) -> None:
    """Lengths, rates, second derivatives and gradients are the same with and without cached directions."""
    rng = np.random.default_rng(4)
    for seed in range(TRIED):
        mechanism = KEEPERS[family](seed)
        try:
            kept, spare = steady(mechanism), _shortest(mechanism)
        except (Sim2ReasonError, ZeroDivisionError):
            continue
        n = len(mechanism.coordinates)
        q, v = (0.1 * min(spare, 1.0) * rng.uniform(-1.0, 1.0, n)).tolist(), rng.normal(size=n).tolist()
        with_them, without = Frames(mechanism, q, v, math, steady=kept), Frames(mechanism, q, v, math)
        for ends in {ends for line in mechanism.lines for ends in pairwise(line.through)}:
            try:
                known = without.distance(*ends)
            except ZeroDivisionError:
                continue
            found = with_them.distance(*ends)
            assert found.direction == pytest.approx(known.direction, abs=1e-9)
            assert (found.value, found.rate, found.bias) == pytest.approx(
                (known.value, known.rate, known.bias), rel=1e-9, abs=1e-9
            )
            assert found.along == pytest.approx(known.along, rel=1e-9, abs=1e-9)
