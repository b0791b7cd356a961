"""Assembly of the equations of motion of a mechanism, for floats or symbols.

With floats the result holds at one instant, with symbols at all instants. Unknowns are the n coordinates and, for each
of the c contacts, the distance by which the body would rise from its face: that distance stays zero, and its row of the
equations gives the normal force.
"""

from collections.abc import Mapping, Sequence

from sim2reason.scenes.dsl.frames import BodyFrame, Frames
from sim2reason.scenes.dsl.mechanism import (
    ZERO,
    CollisionPair,
    ConstantTension,
    Elastic,
    Force,
    Inextensible,
    Line,
    Mechanism,
    Prop,
)
from sim2reason.scenes.dsl.vectors import (
    Maths,
    Number,
    Point,
    Tensor,
    Triple,
    add_triples,
    apply_tensor,
    cross,
    distance,
    dot,
    scale_triple,
    subtract_triples,
)
from sim2reason.simulation.engines.exact.lengths import (
    ORIGIN,
    PathLength,
    RowTerms,
    Separation,
    SwitchState,
    add_gradient,
    point_row,
    project_gradient,
)

Numbers = list[Number]


def masses_at(mechanism: Mechanism, phase: SwitchState, time: Number) -> dict[str, Number]:
    """Return the masses of all bodies at a time, in kg; rockets lose the mass of burnt fuel."""
    masses: dict[str, Number] = {body.name: float(body.mass) for body in mechanism.bodies}
    for burn, burning in zip(mechanism.burns, phase.burning, strict=True):
        masses[burn.body] = masses[burn.body] - burn.rate * (time if burning else burn.until)
    return masses


class Assembly:
    """Mass matrix, loads, constraint equations, slips and gaps of a mechanism for given coordinates, rates and time."""

    def __init__(
        self,
        mechanism: Mechanism,
        phase: SwitchState,
        state: tuple[Sequence[Number], Sequence[Number], Number],
        maths: Maths,
        frames: Frames | None = None,
    ) -> None:
        """Assemble the equations at `state` (coordinates, rates, time); reuse precomputed `frames` if given."""
        self.mechanism, self.phase, self.maths = mechanism, phase, maths
        self.q, self.v, self.time = state
        self.n, self.c = len(mechanism.coordinates), len(mechanism.faces)
        self.frames = frames or Frames(mechanism, self.q, self.v, maths)
        self.masses = masses_at(mechanism, phase, self.time)
        self.mass: list[Numbers] = [[0.0] * self.n for _ in range(self.n)]
        self.lifted: list[Numbers] = [[0.0] * self.n for _ in range(self.c)]
        self.heave: list[Numbers] = [[0.0] * self.c for _ in range(self.c)]
        self.force: Numbers = [0.0] * self.n
        self.press: Numbers = [0.0] * self.c
        for body in mechanism.bodies:
            self._body(body.name)
        self._loads()

    # ---- inertia

    def _body(self, name: str) -> None:
        """Add the mass matrix Σ m JᵀJ + Jᵀ I J, the inertial loads and the weight of one body."""
        frame, point, mass = self.frames[name], self.frames.center(name), self.masses[name]
        if not (type(mass) is float and mass == 0.0):
            weight = scale_triple(mass, self.mechanism.gravity)
            if point.bias is not ZERO:
                weight = add_triples(weight, scale_triple(-mass, point.bias))
            self._push(point, weight)
            entries = list(point.gradient.items())
            for index, (i, axis) in enumerate(entries):
                row = self.mass[i]
                for j, other in entries[: index + 1]:
                    part = dot(axis, other)
                    if not (type(part) is float and part == 0.0):
                        row[j] = row[j] + mass * part
            for i, normal in point.lift.items():
                row = self.lifted[i]
                for j, other in entries:
                    row[j] = row[j] + mass * dot(normal, other)
                heave = self.heave[i]
                for j, other in point.lift.items():
                    heave[j] = heave[j] + mass * dot(normal, other)
        if frame.spin is not None and any(self.mechanism.body[name].inertia):
            self._spinning(frame, self.mechanism.body[name].inertia)

    def _spinning(self, frame: BodyFrame, inertia: Tensor) -> None:
        """Add the rotational inertia Jᵀ I J and loads −Jᵀ(I α + ω × Iω), in the body's axes, where I is constant."""
        turning = frame.turning
        own = [(number, frame.to_body_axes(axis)) for number, axis in turning.gradient.items()]
        spin, bias = frame.to_body_axes(turning.velocity), frame.to_body_axes(turning.bias)
        torque = add_triples(apply_tensor(inertia, bias), cross(spin, apply_tensor(inertia, spin)))
        for index, (i, axis) in enumerate(own):
            moment = apply_tensor(inertia, axis)
            for j, other in own[: index + 1]:
                self.mass[i][j] = self.mass[i][j] + dot(moment, other)
            self.force[i] = self.force[i] - dot(axis, torque)

    def full_mass(self) -> list[Numbers]:
        """Return the complete symmetric mass matrix (n, n) from its stored lower half."""
        full = [row[:] for row in self.mass]
        for i, row in enumerate(self.mass):
            for j in range(i):
                full[j][i] = row[j]
        return full

    # ---- loads

    def _push(self, point: Point, force: Triple) -> None:
        """Add the generalized loads of a force at a point."""
        for i, axis in point.gradient.items():
            self.force[i] = self.force[i] + dot(axis, force)
        for i, normal in point.lift.items():
            self.press[i] = self.press[i] + dot(normal, force)

    def _loads(self) -> None:
        mechanism = self.mechanism
        halves = zip(mechanism.half_springs, self.phase.strained, strict=True)
        idle = {line.name for (line, _), strained in halves if not strained}
        for line in mechanism.lines:
            if not line.law.row and line.name not in idle:
                self._pull(line)
        for number, force in enumerate(mechanism.forces):
            if all(self.phase.inside[number]):
                self._field(force)
        for pair in mechanism.attractions:
            one, other = self.frames.center(pair.a), self.frames.center(pair.b)
            offset = subtract_triples(other.place, one.place)
            square = dot(offset, offset)
            distance = self.maths.sqrt(square)
            strength = pair.constant * self.masses[pair.a] * self.masses[pair.b]
            pull = scale_triple(strength / (distance * _power(distance, square, pair.power)), offset)
            self._push(one, pull)
            self._push(other, scale_triple(-1.0, pull))
        for burn, burning in zip(mechanism.burns, self.phase.burning, strict=True):
            if burning:
                thrust = self.frames[burn.body].turned(burn.direction)
                self._push(self.frames.center(burn.body), scale_triple(burn.rate * burn.exhaust, thrust))

    def _pull(self, line: Line) -> None:
        length = self.length(line)
        tension = self.tension(line, length)
        for i, part in length.along.items():
            self.force[i] = self.force[i] - tension * part
        for i, part in length.lift.items():
            self.press[i] = self.press[i] - tension * part

    @staticmethod
    def tension(line: Line, length: PathLength) -> Number:
        """Return the tension of a line by its force law: that of a spring or of a prescribed pull."""
        law = line.law
        if isinstance(law, ConstantTension):
            return law.force
        assert isinstance(law, Elastic)
        tension = law.stiffness * (length.value - law.length)
        return tension + law.damping * length.rate if law.damping else tension

    def _field(self, force: Force) -> None:
        point = self.frames.center(force.body)
        self._push(point, force.law.force(point.place, point.velocity, self.time, self.maths))

    # ---- lengths and rows

    def length(self, line: Line) -> PathLength:
        """Return the length of a line, Σ |Δr| + Σ radius·angle, with its derivatives."""
        along: dict[int, Number] = {}
        lift: dict[int, Number] = {}
        value: Number = 0.0
        rate: Number = 0.0
        bias: Number = 0.0
        for wheel in line.wheels:
            number, radius = self.mechanism.number[wheel.coordinate], float(wheel.radius)
            along[number] = along.get(number, 0.0) + radius
            value, rate = value + radius * self.q[number], rate + radius * self.v[number]
        for run in self.frames.pieces(line):
            value = value + run.value
            if run.along or run.lift:
                rate, bias = rate + run.rate, bias + run.bias
                add_gradient(along, run.along)
                add_gradient(lift, run.lift)
        return PathLength(value, rate, bias, along, lift)

    def rows(self, starts: Mapping[str, float]) -> list[RowTerms]:
        """Return all constraint rows in the order of `row_kinds`; `starts` holds the initial length of each line."""
        row_terms = [self._line_row(line, starts[line.name]) for line in self.mechanism.constraints]
        for foot in self.mechanism.feet:
            point = self.frames.site(foot.site)
            down = scale_triple(-1.0, foot.normal)
            gap = dot(foot.normal, point.place) - foot.height
            row_terms.append(point_row(point, down, gap))
            row_terms.append(point_row(point, foot.along, gap))
        for meeting, stuck in zip(self.mechanism.meetings, self.phase.stuck, strict=True):
            if stuck:
                separation = self.separation(meeting)
                row_terms.append(
                    RowTerms(separation.along, separation.lift, separation.gap, separation.rate, -separation.bias)
                )
        return row_terms

    def _line_row(self, line: Line, start: float) -> RowTerms:
        length = self.length(line)
        if isinstance(line.law, Prop):
            along = {i: -part for i, part in length.along.items()}
            lift = {i: -part for i, part in length.lift.items()}
            return RowTerms(along, lift, length.value - start, -length.rate, length.bias)
        reel = line.law.reel if isinstance(line.law, Inextensible) else 0.0
        slack = line.law.slack if isinstance(line.law, Inextensible) else 0.0
        spare, rate = slack + start - length.value, length.rate
        if reel:
            spare, rate = spare - reel * self.time, rate + reel
        return RowTerms(length.along, length.lift, spare, rate, -length.bias)

    def separation(self, meeting: CollisionPair) -> Separation:
        """Return the gap of a collision pair with its gradient, rate, and second derivative at q̈ = 0 (bias)."""
        other = self.frames.center(meeting.b)
        one = ORIGIN if meeting.a is None else self.frames.center(meeting.a)
        if meeting.normal is None:
            run = distance(one, other, self.maths)
            return Separation(run.value - meeting.distance, run.rate, run.bias, run.along, run.lift)
        normal = meeting.normal
        offset = subtract_triples(other.place, one.place)
        parting = subtract_triples(other.velocity, one.velocity)
        bias = subtract_triples(other.bias, one.bias)
        along, lift = (
            project_gradient(one.gradient, other.gradient, normal),
            project_gradient(one.lift, other.lift, normal),
        )
        gap = dot(normal, offset) - meeting.distance
        return Separation(gap, dot(normal, parting), dot(normal, bias), along, lift)


def _power(distance: Number, square: Number, power: float) -> Number:
    """Return a distance to a power; even exponents need only products of its square, so that symbols need no root."""
    product: Number = distance if power % 2 else 1.0
    for _ in range(int(power) // 2):
        product = product * square
    return product
