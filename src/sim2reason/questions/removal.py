"""Scenes in which something is removed during the motion: a string is cut, a hand lets go, a field is switched off."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from sim2reason.base.lazy import cached_property
from sim2reason.errors import UnsupportedError
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.displaced import displaced
from sim2reason.scenes.dsl.fields import Magnetic, Push
from sim2reason.scenes.dsl.mechanism import Force, Inextensible, Mechanism
from sim2reason.scenes.dsl.model import rebuilt
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.simulation.certify import RECORDED
from sim2reason.simulation.quantities.subjects.contacts import Hands
from sim2reason.simulation.quantities.subjects.lines import Springs, Strings
from sim2reason.simulation.quantities.subjects.rods import Rods, SwingingLines
from sim2reason.simulation.trace import ENGINES

SAMPLES = 41
FIELDS = {"magnetic": "the magnetic field", "electric": "the electric field"}


class SceneAfterRemoval(Scene):
    """A scene from the time `after`, s, on, at which the lines and forces with names in `removed` cease to act.

    Its motion begins, at t = 0, with the places and velocities that the scene's bodies have at that time.
    """

    removed: tuple[str, ...]
    after: float

    @cached_property
    def mechanism(self) -> Mechanism:
        """Return the mechanism without what is removed, displaced to where it is at that time.

        Raises:
            SimulationError: the motion cannot be solved.
            UnsupportedError: the motion ends before, or its state is more than places and velocities.
        """
        whole = self.builder.finish()
        trace = ENGINES[RECORDED](whole, np.linspace(0.0, self.after, SAMPLES))
        if trace.stable_until < self.after or float(trace.state.times[-1]) < self.after:
            raise UnsupportedError(f"the motion is not described until {self.after:g} s")
        _refuse_memory(whole)
        state = trace.at(self.after)
        there = displaced(whole, state.q[0].tolist(), state.v[0].tolist())
        return replace(
            _without_lines(there, frozenset(self.removed)),
            forces=tuple(_later(force, self.after) for force in there.forces if force.name not in self.removed),
        )


def _without_lines(mechanism: Mechanism, removed: frozenset[str]) -> Mechanism:
    """Return a mechanism without some lines, by `whole`, and without the massless parts that these alone loaded.

    A light movable pulley whose load is cut off stays behind, with its string without tension.
    """
    gone = [line for line in mechanism.lines if line.whole in removed]
    at = {site.name: site.body for site in mechanism.site.values()}
    light = {body.name for body in mechanism.bodies if not body.mass and body.coordinates}
    light -= {body.parent for body in mechanism.bodies}
    idle, slack = set[str](), set(removed)
    for name in light & {at[site] for line in gone for site in line.through}:
        others = {line.whole for line in mechanism.lines if name in {at[site] for site in line.through}} - removed
        if len(others) == 1:
            idle.add(name)
            slack |= others
    bodies = tuple(replace(body, coordinates=()) if body.name in idle else body for body in mechanism.bodies)
    lines = tuple(line for line in mechanism.lines if line.whole not in slack)
    return replace(mechanism, bodies=bodies, lines=lines)


def _refuse_memory(mechanism: Mechanism) -> None:
    """Raise UnsupportedError for a mechanism whose later motion depends on more than its places and velocities."""
    reeled = any(isinstance(line.law, Inextensible) and line.law.reel for line in mechanism.lines)
    sticks = any(meeting.sticks for meeting in mechanism.meetings)
    if reeled or sticks or mechanism.burns or mechanism.feet:
        raise UnsupportedError("nothing can be removed in the course of such a motion")


def _later(force: Force, after: float) -> Force:
    """Return a force whose time begins `after` seconds later."""
    law = force.law
    if not isinstance(law, Push | Magnetic) or law.profile.steady:
        return force
    profile = law.profile
    later = replace(
        profile, value=profile.value + profile.rate * after, phase=profile.phase + profile.frequency * after
    )
    return replace(force, law=replace(law, profile=later))


def removable(words: Words) -> Mapping[str, str]:
    """Return the text's phrases for everything that can be removed, by name: lines, hands and fields."""
    mechanism = words.mechanism
    kinds = (Strings(), SwingingLines(), Springs(), Rods(), Hands())
    named = {name: said for kind in kinds for name, said in words.called(kind).items()}
    whole = {line.name: line.whole for line in mechanism.lines}
    found = {whole[name]: said for name, said in named.items() if name in whole}
    forces = {force.name: FIELDS.get(force.name.rpartition(".")[2], "") for force in mechanism.forces}
    return found | {name: said for name, said in forces.items() if said}


def after_removal(scene: Scene, removed: tuple[str, ...], after: float) -> Scene:
    """Return a scene from the time `after`, s, on, at which lines and forces, by name, cease to act."""
    fields = {name: getattr(scene, name) for name in Scene.model_fields}
    return rebuilt(SceneAfterRemoval(**fields, removed=removed, after=after))
