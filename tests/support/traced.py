"""Digests of motions by the exact engine, for comparing what the native core and Python compute, to the last bit.

    python tests/support/traced.py FAMILY [FAMILY...] [--count N]

A family is a recipe, of which scenes of all difficulties are drawn, or one of random mechanisms. Each motion is
followed at two tolerances; its digest is of all samples, events, knots and the end, or of the error.
"""

import argparse
import hashlib
import json
import sys
from collections.abc import Callable

import numpy as np

import random_mechanisms
from curved_mechanisms import FAMILIES
from sim2reason.errors import Sim2ReasonError
from sim2reason.generation.item_search import sample
from sim2reason.questions.difficulty import DIFFICULTIES
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.engines.exact import simulate
from sim2reason.simulation.engines.exact.native import uses_native_core
from sim2reason.simulation.trace import DEFAULT_STEP_RTOL, Trace
from spoiled_mechanisms import collapse, spoiled

SAMPLES = 23
RANDOM: dict[str, Callable[[int], Mechanism]] = {
    **FAMILIES,
    **{
        name: lambda seed, name=name: getattr(random_mechanisms, name)(seed).finish()
        for name in ("pulleys", "wedges", "table", "rough")
    },
    "spoiled": spoiled,
    "collapse": collapse,
}


def drawn(recipe: str, index: int) -> Mechanism:
    """A random scene of a recipe."""
    return sample(recipe, list(DIFFICULTIES)[index % len(DIFFICULTIES)], seed=11, index=index).mechanism


def told(trace: Trace) -> list[object]:
    """All that a trace says; which NaN one is depends on the order of operands, and counts for nothing."""
    state = trace.state
    forces = (state.constraint_tension, state.normal, state.friction)
    arrays = [state.q, state.v, state.a, trace.knots(), *(part for held in forces for part in held.values())]
    exact = [np.where(np.isnan(array), np.nan, array).tobytes().hex() for array in arrays]
    events = [(event.time.hex(), event.kind, event.subjects) for event in trace.events]
    return [exact, events, float(trace.stable_until).hex(), trace.cut]


def digest(mechanism: Mechanism, tolerance: float) -> str:
    """The digest of a motion over 2 s, or the message of its error."""
    try:
        trace = simulate(mechanism, np.linspace(0.0, 2.0, SAMPLES), tolerance)
        found = told(trace)
    except (Sim2ReasonError, ArithmeticError, ValueError) as error:
        return f"{type(error).__name__}: {error}"
    return hashlib.sha256(json.dumps(found).encode()).hexdigest()[:16]


def main() -> None:
    options = argparse.ArgumentParser()
    options.add_argument("families", nargs="+")
    options.add_argument("--count", type=int, default=6)
    given = options.parse_args()
    found: dict[str, object] = {"native": uses_native_core()}
    for family in given.families:
        for index in range(given.count):
            mechanism = RANDOM[family](index) if family in RANDOM else drawn(family, index)
            for tolerance in (DEFAULT_STEP_RTOL, 1e-6):
                found[f"{family} {index} {tolerance}"] = digest(mechanism, tolerance)
    sys.stdout.write(json.dumps(found))


if __name__ == "__main__":
    main()
