"""Questions for a quantity in the equilibrium position."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from sim2reason.errors import TextError
from sim2reason.questions.choices import DISTINCT_RTOL, draw_target
from sim2reason.questions.kinds import Kind, kind
from sim2reason.questions.phrasing import equilibrium_called, question_sentences
from sim2reason.questions.query import Noun, Query, Target, Targets, quantities_named, target_named
from sim2reason.questions.structured import EQUILIBRIUM, StructuredQuestion
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Elastic, Mechanism
from sim2reason.simulation.certify import Certificate
from sim2reason.simulation.equilibrium import equilibrium, unique_equilibrium
from sim2reason.simulation.oscillation import agree_at_rest, equilibrium_disagreement
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.trace import Channel

WHEN = ("in the position of {}", "at the position of {}", "in the {} position")
START_POSITION_TOL = 1e-6  # m or rad


@dataclass(frozen=True, slots=True)
class EquilibriumQuery(Query):
    """A query for a quantity in equilibrium; the text calls the equilibrium `stable` if there may be others."""

    stable: bool = False


@kind
class EquilibriumKind(Kind):
    """The kind that asks for a length, an angle or a force in equilibrium, whatever the motion before."""

    name = "equilibrium"
    share = 0.3

    def of_motion(self, query: Query) -> bool:
        """Return whether the answer depends on the motion: only for displacements from the start."""
        assert query.target is not None
        return QUANTITIES[query.target.quantity].from_start

    def draw(self, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Return a query for a magnitude, not a weight, in a stable equilibrium away from the start; None without one.

        Nor a change in energy since the start. `doubt` refuses it where there is another equilibrium.
        """
        del words
        mechanism = study.mechanism
        if not _worth(mechanism):
            return None
        rest = equilibrium(mechanism)
        if rest is None or rest.free or float(np.abs(rest.coordinates).max()) <= START_POSITION_TOL:
            return None
        start, there = study.trace.at(0.0), rest.state
        weights = [body.mass * float(np.linalg.norm(mechanism.gravity)) for body in mechanism.bodies]

        def differs(target: Target) -> bool:
            value, quantity = target.value(there), QUANTITIES[target.quantity]
            if not abs(value) > quantity.least or (quantity.from_start and quantity.unit == "J"):
                return False
            known = [target.value(start), *(weights if target.unit == "N" else ())]
            return all(abs(value - other) > DISTINCT_RTOL * abs(value) for other in known)

        target = draw_target([target for target in targets if not target.signed], rng, differs)
        if target is None:
            return None
        return EquilibriumQuery(self.name, target, stable=not rest.linear)

    def answer(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the quantity in equilibrium, in SI units."""
        assert query.target is not None
        rest = equilibrium(study.mechanism)
        return query.target.value(rest.state) if rest is not None else None

    def time(self, query: Query, study: SimulatedScene) -> float | None:
        """Return zero, as the answer does not depend on the motion."""
        del query, study
        return 0.0

    def channels(self, query: Query) -> tuple[Channel, ...]:
        """Return no channels, as the answer does not depend on the motion."""
        del query
        return ()

    def doubt(self, query: Query, study: SimulatedScene, certificate: Certificate | None) -> str:
        """Return why the second engine, started at rest in equilibrium, disagrees; empty if it agrees."""
        del query, certificate
        rest = unique_equilibrium(study.mechanism)
        return "there is no equilibrium, or another one" if rest is None else equilibrium_disagreement(rest)

    def indifferent(self, query: Query, study: SimulatedScene, other: SimulatedScene) -> bool:
        """Return whether the scenes differ only in initial velocities and in masses that do not affect equilibrium."""
        del query
        return agree_at_rest(study.mechanism, other.mechanism, ("lengths", "forces", "stiffness"))

    def shapes(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return sentences such as *in the position of equilibrium, what is the length of the spring?*."""
        del words
        assert query.target is not None
        assert noun is not None
        shapes = (
            shape for when in _equilibrium_phrases(query) for shape in question_sentences(query.target, noun, when)
        )
        return tuple(dict.fromkeys(shapes))

    def noun_phrases(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return noun phrases for the answer, such as *the length of the spring in the position of equilibrium*."""
        del words
        assert noun is not None
        return tuple(f"{noun.phrase} {when}" for when in _equilibrium_phrases(query))

    def finds(self, words: Words) -> tuple[str, ...]:
        """Return the names of all quantities in the scene."""
        return tuple(quantities_named(words.mechanism))

    def posed(self, asked: StructuredQuestion, study: SimulatedScene, words: Words) -> Query | None:
        """Return the query for a quantity in equilibrium; None for a question about another moment."""
        if asked.when != EQUILIBRIUM:
            return None
        rest, target = equilibrium(study.mechanism), target_named(asked, words)
        if rest is None:
            problem = "this scene has no place at which all would stay at rest"
            raise TextError("when", problem, "name a moment of the motion, see: sim2reason list moments")
        if not np.any(target.values(rest.state)) and target.unit.endswith("/s"):
            raise TextError("find", "in equilibrium nothing moves", "find a length, an angle or a force there")
        return EquilibriumQuery(self.name, target, stable=not rest.linear)

    def parsed(self, text: str, study: SimulatedScene, words: Words, targets: Targets) -> Iterator[Query]:
        """Yield a query for every quantity that a sentence names."""
        del study, words
        if "equilibrium" in text:
            yield from (
                EquilibriumQuery(self.name, target, stable=stable) for target in targets for stable in (False, True)
            )


def _equilibrium_phrases(query: Query) -> tuple[str, ...]:
    """Return the phrases for the equilibrium position."""
    assert isinstance(query, EquilibriumQuery)
    called = equilibrium_called(stable=query.stable)
    return tuple(when.format(called) for when in WHEN)


def _worth(mechanism: Mechanism) -> bool:
    """Return whether the equilibrium needs a calculation, unlike a pendulum vertically below its pivot."""
    springs = any(isinstance(line.law, Elastic) for line in mechanism.lines)
    strings = len(mechanism.lines)
    return springs or strings > 1 or bool(mechanism.forces)
