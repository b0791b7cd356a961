"""The area that the line between two bodies sweeps out."""

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.quantities.kinematics import Velocity
from sim2reason.quantities.pairs import DistanceBetween
from sim2reason.quantities.subjects.bodies import moves
from sim2reason.quantities.subjects.pairs import Pairs, members
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.integral import Integral
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.orbited import Orbited
from sim2reason.questions.moments.parts.apsis import Apsis
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel


@functional
class AreaSwept(Integral):
    """The area that the line from a fixed body to one that it attracts sweeps out, as in Kepler's second law."""

    name, unit, least = "area swept", "m^2", 1e-4
    of = Pairs()
    phrase = "the area that the line between {pair} sweeps out"
    how = "how large an area does the line between {pair} sweep out {when}?"
    weight = 0.3

    def rate(self, state: State, name: str) -> Array:
        """½|r × v|, (n,)."""
        return np.linalg.norm(_areal_velocity(state, name), axis=1)

    def worth(self, study: Study, name: str, end: float) -> bool:
        """Only where the line turns in one sense: of one that turns back nobody says whether areas cancel."""
        scan = study.trace.scan
        swept = _areal_velocity(scan, name)[scan.times <= end]
        return super().worth(study, name, end) and bool((swept @ swept.mean(axis=0) >= 0.0).all())

    def present(self, words: Words, name: str) -> bool:
        """One that is fixed, and one that it attracts."""
        pulls = any({pull.a, pull.b} == set(members(name)) for pull in words.mechanism.attractions)
        return pulls and sum(moves(words.mechanism, body) for body in members(name)) == 1

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Until something happens on the same orbit; a time by the areal velocity at the start needs no attraction."""
        return super().when(moment, words, name) if isinstance(moment, Orbited | Apsis) and moment.name == name else ()

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Both velocities and the distance."""
        del mechanism
        velocities = (Channel(body, Velocity.name) for body in members(name))
        return (Channel(name, DistanceBetween.name), *velocities)


def _areal_velocity(state: State, name: str) -> Array:
    """½ r × v, (n, 3)."""
    a, b = members(name)
    apart = state.vector(state.frames.center(b).place) - state.vector(state.frames.center(a).place)
    parting = Velocity.evaluate(state, b) - Velocity.evaluate(state, a)
    return 0.5 * np.cross(apart, parting)
