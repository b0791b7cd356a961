"""Newton's second law of a mechanism with constant equations, in the symbols of the text.

For each coordinate k with direction e, the law Σ m (a·e) = Σ F·e is that of the body it moves with all that it carries.
Contact forces between these bodies cancel. The module has its own symbols: ``q3`` is the acceleration of a coordinate
(for a hinge, that of its rim), ``T2`` the tension of a line, ``N1`` and ``f1`` the forces of a contact.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import reduce
from operator import mul

from sim2reason.base.records import cached_property
from sim2reason.scenes.dsl.fields import Push
from sim2reason.scenes.dsl.frames import Frames, initial_frames
from sim2reason.scenes.dsl.mechanism import ConstantTension, Line, Mechanism
from sim2reason.scenes.dsl.vectors import Triple, apply_tensor, dot
from sim2reason.simulation.engines.exact.motion import Segment
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, total
from sim2reason.solutions.writing.lexicon import DualValue, Lexicon, UnreadError

Side = tuple[Mechanism, Frames]


def symbol(kind: str, number: int) -> Polynomial:
    """Return an unknown such as ``q3``, ``T1`` or ``N0`` as a polynomial."""
    return Polynomial.from_expression(Symbol(f"{kind}{number}"))


@dataclass(frozen=True)
class Row:
    """One law, `forces` = `inertia`; that of a string has its accelerations as `inertia`, and no forces."""

    kind: str  # newton, normal, string, grip
    number: int  # index of the coordinate, contact or line
    forces: Polynomial
    inertia: Polynomial

    @cached_property
    def zero(self) -> Polynomial:
        """Return forces minus inertia, which vanishes."""
        return self.forces - self.inertia


def _push(mechanism: Mechanism, number: int) -> Push:
    """Return the force law, with magnitude and direction, of a constant force given by its index."""
    law = mechanism.forces[number].law
    assert isinstance(law, Push)
    return law


class Newton:
    """The laws of one segment of a motion, computed on demand."""

    def __init__(self, lexicon: Lexicon, segment: Segment) -> None:
        """Take a segment; UnreadError for forces other than weight, strings, contacts and constant forces."""
        self.lexicon, self.mechanism, self.segment = lexicon, lexicon.mechanism, segment
        self._stretches: dict[tuple[int, int], DualValue] = {}
        varying = any(f.region or not (isinstance(f.law, Push) and f.law.constant) for f in self.mechanism.forces)
        if varying or self.mechanism.feet or any(segment.found.mode.acting[len(self.lines) :]):
            raise UnreadError("there are forces of fields, or feet")
        self._sides: tuple[Side, Side] = tuple((m, initial_frames(m)) for m in (lexicon.mechanism, lexicon.twin))  # type: ignore[assignment]

    @property
    def lines(self) -> tuple[Line, ...]:
        """Return the lines that impose constraints, such as strings."""
        return self.mechanism.constraints

    # ---- numbers

    def _both(self, number: Callable[[Mechanism, Frames], float]) -> DualValue:
        """Return a number of the mechanism and of its twin, which is the same mechanism with other parameters."""
        (here, frames), (there, others) = self._sides
        return DualValue(float(number(here, frames)), float(number(there, others)))

    def read(self, number: Callable[[Mechanism, Frames], float]) -> Polynomial:
        """Return a number of the mechanism and its initial geometry, in symbols."""
        return self.lexicon.read(self._both(number))

    @cached_property
    def scale(self) -> list[DualValue]:
        """Return, by coordinate, the factor of its rate: the largest rim radius of a rotating body, or 1."""
        factors = [DualValue(1.0, 1.0)] * len(self.mechanism.coordinates)
        for k, radii in self._rims.items():
            factors[k] = max(radii, key=lambda both: both.value)
        for number, face in enumerate(self.mechanism.faces):
            for index, (name, _) in enumerate(face.slip):
                k = self.mechanism.number[name]
                if self.mechanism.coordinates[k].kind == "hinge":
                    factors[k] = self._both(lambda m, _, n=number, p=index: abs(m.faces[n].slip[p][1]))
        return factors

    @cached_property
    def _rims(self) -> dict[int, list[DualValue]]:
        """Return the radii at which lines are wound round rotating bodies, by coordinate."""
        radii: dict[int, list[DualValue]] = {}
        for number, line in enumerate(self.mechanism.lines):
            for index, wheel in enumerate(line.wheels):
                both = self._both(lambda m, _, n=number, p=index: abs(m.lines[n].wheels[p].radius))
                radii.setdefault(self.mechanism.number[wheel.coordinate], []).append(both)
        return radii

    def _over(self, number: DualValue, *coordinates: int) -> Polynomial:
        """Divide a number by the rim radii of coordinates; for several radii, by the symbol of the largest one."""
        stepped = [k for k in coordinates if len(set(self._rims.get(k, ()))) > 1]
        plain = (self.scale[k] for k in coordinates if k not in stepped)
        radii = (self.lexicon.read(self.scale[k]).symbol for k in stepped)
        inverse = (Polynomial({((radius, -1),): 1.0}) for radius in radii if radius is not None)
        return reduce(mul, inverse, self.lexicon.read(reduce(DualValue.__truediv__, plain, number)))

    @cached_property
    def gravity(self) -> Polynomial:
        """Return the gravitational acceleration, g or zero."""
        return self.read(lambda m, _: -m.gravity[2])

    @cached_property
    def _masses(self) -> list[Polynomial]:
        """Return the masses of all bodies."""
        return [self.read(lambda m, _, n=n: m.bodies[n].mass) for n in range(len(self.mechanism.bodies))]

    def mass(self, body: str) -> Polynomial:
        """Return the mass of a body."""
        return self._masses[next(n for n, candidate in enumerate(self.mechanism.bodies) if candidate.name == body)]

    def moving_coordinates(self, body: str) -> list[int]:
        """Return the coordinates that move the centre of mass of a body."""
        gradient = self._sides[0][1].center(body).gradient
        return [k for k, direction in gradient.items() if dot(direction, direction) > 1e-18]

    def along(self, body: str, k: int, way: tuple[float, float, float]) -> Polynomial:
        """Return the component of a body's displacement per unit of coordinate k, along a world direction."""
        return self.read(lambda _, f: dot(f.center(body).gradient[k], way))

    # ---- laws

    def newton(self, k: int) -> Row:
        """Return Newton's law along a coordinate."""
        inertia, forces = list[Polynomial](), list[Polynomial]()
        for number, body in enumerate(self.mechanism.bodies):
            moved = self.moving_coordinates(body.name) if body.mass else []
            if k in moved:
                mass = self._masses[number]
                inertia += [mass * self._dot(body.name, k, j) * symbol("q", j) for j in moved]
                forces.append(mass * self.gravity * self.along(body.name, k, (0.0, 0.0, -1.0)))
        inertia += self._turning(k)
        forces += self._pushes(lambda f, body: f.center(body).gradient.get(k))
        forces += [pull for number, line in enumerate(self.mechanism.lines) if (pull := self._pull(number, line, k))]
        forces += self._rubbing(k)
        return Row("newton", k, total(forces), total(inertia))

    def _pushes(self, way: Callable[[Frames, str], Triple | None]) -> list[Polynomial]:
        """Return the components of all constant forces along the directions that `way` gives for their bodies."""
        components = list[Polynomial]()
        for number, force in enumerate(self.mechanism.forces):
            if way(self._sides[0][1], force.body) is not None:
                size = self.read(lambda m, _, n=number: _push(m, n).profile.value)
                along = self.read(
                    lambda m, f, n=number, b=force.body: dot(_push(m, n).direction, way(f, b) or (0.0, 0.0, 0.0))
                )
                components.append(size * along)
        return components

    def _dot(self, body: str, k: int, j: int) -> Polynomial:
        """Return the scalar product of two vectors: a body's displacements per unit of two of its coordinates."""
        if k == j:
            return Polynomial.from_expression(1.0)
        return self.read(lambda _, f: dot(f.center(body).gradient[k], f.center(body).gradient[j]))

    def _turning(self, k: int) -> list[Polynomial]:
        """Return terms, I/r² times the acceleration of a rim, for the rotating bodies in the law of a coordinate."""
        hinges = [j for j, coordinate in enumerate(self.mechanism.coordinates) if coordinate.kind == "hinge"]
        return [part * symbol("q", j) for j in hinges if k in hinges and (part := self.turning(k, j))]

    def turning(self, k: int, j: int) -> Polynomial:
        """Return the moment of inertia that couples two hinges, over the product of their rims' radii."""

        def inertia(m: Mechanism, f: Frames) -> float:
            total = 0.0
            for body in m.bodies:
                axes = f[body.name].turning.gradient
                if any(body.inertia) and k in axes and j in axes:
                    total += float(dot(axes[k], apply_tensor(body.inertia, axes[j])))
            return total

        return self._over(self._both(inertia), k, j)

    def _pull(self, number: int, line: Line, k: int) -> Polynomial:
        """Return the component along a coordinate of the force that a line exerts."""
        tension = self.tension(number, line)
        return (tension * self.stretch(number, k)).scale(-1.0) if tension else NIL

    def tension(self, number: int, line: Line) -> Polynomial:
        """Return the tension of a line: an unknown, the force of a hand, or zero if it is slack."""
        if isinstance(line.law, ConstantTension):
            return self.read(lambda m, _: getattr(m.lines[number].law, "force", 0.0))
        if not line.law.row:
            raise UnreadError("there is a spring")
        index = self.lines.index(line)
        return symbol("T", index) if self.segment.found.mode.acting[index] else NIL

    def stretch(self, number: int, k: int) -> Polynomial:
        """Return the increase of a line's length per unit of a coordinate."""
        return self._over(self._stretch(number, k), k)

    def _stretch(self, number: int, k: int) -> DualValue:
        """Return the increase of a line's length per unit of a coordinate as a number; for a rotation, per radian."""

        def along(m: Mechanism, f: Frames) -> float:
            line = m.lines[number]
            turned = sum(w.radius for w in line.wheels if m.number[w.coordinate] == k)
            return turned + sum(float(piece.along.get(k, 0.0)) for piece in f.pieces(line))

        if (number, k) not in self._stretches:
            self._stretches[number, k] = self._both(along)
        return self._stretches[number, k]

    def string(self, place: int) -> Row:
        """Return the law that the length of a taut string does not change."""
        number = self.mechanism.lines.index(self.lines[place])
        terms = [
            self.stretch(number, k) * symbol("q", k)
            for k in range(len(self.mechanism.coordinates))
            if self._stretch(number, k).value
        ]
        return Row("string", place, NIL, total(terms))

    # ---- faces

    @cached_property
    def slip_directions(self) -> dict[int, int]:
        """Return the direction of slip at each rough contact by index: 1 or -1, 0 if it sticks."""
        faces = [number for number, face in enumerate(self.mechanism.faces) if face.friction > 0.0]
        return dict(zip(faces, self.segment.found.mode.rubbing, strict=True))

    def slip(self, face: int) -> dict[int, Polynomial]:
        """Return the slip at a contact per unit of each coordinate, by index."""
        ratios: dict[int, Polynomial] = {}
        for index, (name, _) in enumerate(self.mechanism.faces[face].slip):
            k = self.mechanism.number[name]
            both = self._both(lambda m, _, p=index: m.faces[face].slip[p][1]) / self.scale[k]
            ratios[k] = self.lexicon.read(both)
        return ratios

    def single_slip_coordinate(self, face: int) -> int | None:
        """Return the only coordinate along which a contact slips; None if there are several."""
        slip = self.slip(face)
        return next(iter(slip)) if len(slip) == 1 else None

    def friction(self, face: int) -> Polynomial:
        """Return the friction along the slip: −µN against it, or an unknown if the contact sticks."""
        side = self.slip_directions.get(face)
        if side is None:
            return NIL
        if side == 0:
            return symbol("f", face)
        return (self.coefficient(face) * symbol("N", face)).scale(float(-side))

    def coefficient(self, face: int) -> Polynomial:
        """Return the symbol of the coefficient of kinetic friction of a contact, such as µ or µ_k."""
        return self.read(lambda m, _: m.faces[face].friction)

    def static_coefficient(self, face: int) -> Polynomial:
        """Return the symbol of the coefficient of static friction of a contact, such as µ or µ_s."""
        return self.read(lambda m, _: m.faces[face].static_friction)

    def _rubbing(self, k: int) -> list[Polynomial]:
        """Return the friction forces along a coordinate."""
        pairs = [(self.friction(face), self.slip(face)) for face in self.slip_directions]
        return [force * slip[k] for force, slip in pairs if k in slip]

    def normal(self, face: int) -> Row:
        """Return Newton's law along the normal of a contact, for the body on it with all that it carries."""
        inertia, forces = list[Polynomial](), [symbol("N", face)]
        for number, body in enumerate(self.mechanism.bodies):
            lift = self._sides[0][1].center(body.name).lift
            if face not in lift or not body.mass:
                continue
            mass = self._masses[number]
            for j in self.moving_coordinates(body.name):
                part = self.read(lambda _, f, b=body.name, j=j: dot(f.center(b).lift[face], f.center(b).gradient[j]))
                inertia.append(mass * part * symbol("q", j))
            down = self.read(lambda _, f, b=body.name: -float(f.center(b).lift[face][2]))
            forces.append(mass * self.gravity * down)
        forces += self._pushes(lambda f, body: f.center(body).lift.get(face))
        for number, line in enumerate(self.mechanism.lines):
            lifted = self.read(lambda m, f, n=number: sum(float(p.lift.get(face, 0.0)) for p in f.pieces(m.lines[n])))
            if lifted:
                forces.append((self.tension(number, line) * lifted).scale(-1.0))
        return Row("normal", face, total(forces), total(inertia))

    def rolling(self, face: int) -> Row:
        """Return the law that a body rolls without slipping at a contact."""
        return Row("grip", face, NIL, total(part * symbol("q", k) for k, part in self.slip(face).items()))

    @cached_property
    def values(self) -> dict[str, float]:
        """Return the values of the unknowns, in SI units, as the engine computed them."""
        force_balance = self.segment.found
        scaled = {f"q{k}": a * s.value for k, (a, s) in enumerate(zip(force_balance.a, self.scale, strict=True))}
        tension = {f"T{n}": value for n, value in enumerate(force_balance.rows)}
        normal = {f"N{n}": value for n, value in enumerate(force_balance.normal)}
        return {**scaled, **tension, **normal, **{f"f{n}": value for n, value in enumerate(force_balance.friction)}}
