"""The points of a mechanism in MuJoCo: positions, velocities and Jacobians of sites and centres of mass, and gaps."""

from typing import Any

import numpy as np

from sim2reason.scenes.dsl.mechanism import CollisionPair, Mechanism
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.mujoco.distances import PointMotion, distance, separated
from sim2reason.simulation.engines.mujoco.specification import Specification, mujoco


class ModelPoints:
    """The points of a compiled mechanism in its present state, which a subclass sets."""

    def __init__(self, mechanism: Mechanism, spec: Specification) -> None:
        """Compile the mechanism; raise SimulationError if MuJoCo rejects it.

        The views of MuJoCo's arrays are stored, since their memory does not move and each look-up takes time.
        """
        self.mechanism = mechanism
        compiled: tuple[Any, Any] = spec.compile()
        self._model, self._data = compiled
        self.size = int(self._model.nv)
        self.index = {c.name: int(spec.joints[c.name].id) for c in mechanism.coordinates}
        self._site_id = {name: int(site.id) for name, site in spec.sites.items()}
        self._body_id = {name: int(body.id) for name, body in spec.bodies.items()}
        self._carriers = [int(body) for body in self._model.site_bodyid]
        self._sites = {name: self._data.site_xpos[number] for name, number in self._site_id.items()}
        self._centers = {name: self._data.xipos[number] for name, number in self._body_id.items()}
        self._straight = bool((self._model.jnt_type == mujoco.mjtJoint.mjJNT_SLIDE).all())
        self._slides: dict[tuple[str, str], Array] = {}  # gradients that never change, since nothing turns
        self._points: dict[tuple[str, str], PointMotion] = {}  # those of the present state
        self._still, self.v = np.zeros(3), np.zeros(0)

    def _point_motion(self, kind: str, name: str) -> PointMotion:
        """Return the position, velocity and Jacobian of a site or a centre of mass."""
        known = self._points.get((kind, name))
        if known is not None:
            return known
        if kind == "site":
            place, carrier = self._sites[name], self._carriers[self._site_id[name]]
        else:
            place, carrier = self._centers[name], self._body_id[name]
        jacobian = self._slides.get((kind, name))
        if jacobian is None:
            jacobian = np.zeros((3, self.size))
            if carrier:
                mujoco.mj_jac(self._model, self._data, jacobian, None, place, carrier)
            if self._straight or not carrier:  # nothing turns, or the point belongs to the room
                self._slides[kind, name] = jacobian
        found = self._points[kind, name] = PointMotion(place, jacobian.dot(self.v), jacobian)
        return found

    def _bias_of(self, place: Array, carrier: int) -> Array:
        """Return the acceleration at q̈ = 0 of a point of a body."""
        if self._straight or not carrier:
            return self._still
        dot = np.zeros((3, self.size))
        mujoco.mj_jacDot(self._model, self._data, dot, None, place, carrier)
        return np.asarray(dot.dot(self.v), dtype=np.float64)

    def places(self, ends: list[tuple[str, str]]) -> list[tuple[list[float], list[float]]]:
        """Return the present positions of pairs of sites, m."""
        places: list[list[float]] = self._data.site_xpos.tolist() if ends else []
        return [(places[self._site_id[first]], places[self._site_id[last]]) for first, last in ends]

    def site(self, name: str) -> PointMotion:
        """Return the position, velocity and Jacobian of a site."""
        return self._point_motion("site", name)

    def center(self, name: str) -> PointMotion:
        """Return the position, velocity and Jacobian of the centre of mass of a body."""
        return self._point_motion("body", name)

    def gap(self, meeting: CollisionPair) -> float:
        """Return the present gap of a collision pair, m."""
        apart = self._apart(meeting)
        if meeting.normal is None:
            return separated(apart) - meeting.distance
        return float(np.array(meeting.normal).dot(apart)) - meeting.distance

    def _apart(self, meeting: CollisionPair) -> Array:
        """Return the vector between the centres of mass of a collision pair; from the origin if one is the room."""
        other = self._centers[meeting.b]
        return other if meeting.a is None else np.subtract(other, self._centers[meeting.a])

    def separation(self, meeting: CollisionPair) -> tuple[float, float, Array, float]:
        """Return the gap of a collision pair, its rate, gradient and second derivative at q̈ = 0."""
        other, still = self.center(meeting.b), self._still
        bias = self._bias_of(other.place, self._body_id[meeting.b])
        if meeting.a is None:
            one = PointMotion(still, still, np.zeros((3, self.size)))
        else:
            one = self.center(meeting.a)
            bias = bias - self._bias_of(one.place, self._body_id[meeting.a])
        if meeting.normal is None:
            length, rate, gradient, bend = distance(one, other, bias)
            return length - meeting.distance, rate, gradient, bend
        normal = np.array(meeting.normal)
        gradient = normal @ (other.jacobian - one.jacobian)
        gap = float(normal.dot(other.place - one.place)) - meeting.distance
        return gap, float(gradient @ self.v), gradient, float(normal.dot(bias))

    def square_gap(self, meeting: CollisionPair) -> float:
        """Return a gap as a polynomial of positions: for centres r apart that meet at a distance d, (r² − d²)/2d.

        It has the zero of r − d and the slope there, and exists where the centres coincide.
        """
        if meeting.normal is not None:
            return self.gap(meeting)
        apart = self._apart(meeting)
        square = float(apart.dot(apart))
        return 0.5 * (square / meeting.distance - meeting.distance) if meeting.distance else square
