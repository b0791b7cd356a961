"""Springs in a plane: the equilibrium of a body held by several springs, and its small oscillations.

A spring of stiffness k and natural length ℓ₀ that is ℓ long resists along itself with k, and across with k (1 − ℓ₀/ℓ),
its pull over its length. See Goldstein, Poole and Safko, Classical Mechanics, § 6.2.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import atan2, pi, sin

from sim2reason.base.records import cached_property
from sim2reason.questions.difficulty import Need
from sim2reason.questions.phrasing import PeriodQuery
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import Elastic, Line, Mechanism
from sim2reason.simulation.equilibrium import equilibrium
from sim2reason.solutions.algebra.evaluated import NumericRoot
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Number, Symbol, sum_terms
from sim2reason.solutions.algebra.functions import PI, Call, Power, Root
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.algebra.root_finding import roots_sentence, substitute
from sim2reason.solutions.goals import GOALS
from sim2reason.solutions.laws.newton import Newton
from sim2reason.solutions.laws.straight_way import StraightMotion
from sim2reason.solutions.oscillations.harmonic import measured_period
from sim2reason.solutions.setting import DIRECTION_TOLERANCE, ProblemContext, join_words
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.writing.lexicon import DualValue
from sim2reason.solutions.writing.notation import ANGULAR_SPEED, DEGREES, METRES, STIFFNESS
from sim2reason.solutions.writing.steps import SolutionBuilder, StepBuilder, UnsolvedError

HALF, TWO = Number(0.5), Number(2.0)
MIN_RUN_TO_RISE = 0.01  # ratio of run to rise below which the tangent would lose too many digits
PLANE_DIMENSIONS = 2  # number of coordinates in a plane


@strategy
class PlaneSprings(Strategy):
    """The strategy for a body on a level table held by springs in several directions."""

    name = "springs in a plane"
    cost = 1.3
    kinds = frozenset({"equilibrium", "period"})
    least_need = Need.ROOT

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason that a mechanism is not a single body held by springs in a plane; empty if it is one."""
        return "" if _held_in_a_plane(mechanism) else "no lone body is held by springs in a plane"

    def formulas(self, mechanism: Mechanism) -> frozenset[str]:
        """Return the question kinds that have a compact formula: none, since the equilibrium has no closed form."""
        del mechanism
        return frozenset()

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        query, target = setting.query, setting.target
        if isinstance(query, PeriodQuery):
            return "" if query.small and query.modes == PLANE_DIMENSIONS else "no way to motions that are not small"
        known = target is not None and target.quantity in GOALS
        return "" if known else f"no way to the quantity {target.quantity if target is not None else ''}"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the equilibrium and the answer, and return the answer's symbol."""
        model = _Held(setting, book)
        if isinstance(setting.query, PeriodQuery):
            return model.oscillate(setting.query).name
        assert model.target is not None
        return GOALS[model.target.quantity].write(model.target, model).name


def _held_in_a_plane(m: Mechanism) -> bool:
    others = m.faces or m.forces or m.attractions or m.burns or m.meetings or m.feet
    slides = all(c.kind == "slide" and abs(c.axis[2]) < DIRECTION_TOLERANCE for c in m.coordinates)
    if others or len(m.bodies) != 1 or len(m.coordinates) != PLANE_DIMENSIONS or not slides:
        return False
    return all(isinstance(line.law, Elastic) and not line.law.side and _nail(m, line) for line in m.lines)


def _nail(m: Mechanism, line: Line) -> str:
    """Return the fixed end of a spring; empty if it has none."""
    return (
        next((site for site in line.through if m.site[site].body is None), "")
        if len(line.through) == PLANE_DIMENSIONS
        else ""
    )


@dataclass(frozen=True, slots=True)
class _Spring:
    """A spring with its fixed end, in the symbols of the text."""

    name: str
    stiffness: Expression
    natural: Expression
    end: tuple[Expression, Expression]
    length: Symbol  # in equilibrium


class _Held(StraightMotion):
    """The body in equilibrium at the position (X, Y)."""

    @property
    def newton(self) -> Newton:
        """Return Newton's laws, for the mass alone."""
        return Newton(self.setting.lexicon, self.setting.motion.segments[0])

    def force(self, kind: str, name: str) -> Symbol:
        """Raise UnsolvedError, since only springs exert forces."""
        raise UnsolvedError(f"no {kind} of {name}")

    def rate(self, kind: str, k: int) -> Polynomial:
        """Return the displacement from the start to the equilibrium; zero for other kinds."""
        return Polynomial.from_expression(self.place[k]) - self._places[k][0] if kind == "s" else NIL

    def spring(self, what: str, line: str) -> Polynomial:
        """Return a parameter of a spring; ``strain`` and ``length`` are those in equilibrium."""
        entry = next(entry for entry in self.springs if entry.name == line)
        if what == "damping":
            return NIL
        if what == "stiffness":
            return Polynomial.from_expression(entry.stiffness)
        _ = self.place
        length = Polynomial.from_expression(entry.length)
        return length - Polynomial.from_expression(entry.natural) if what == "strain" else length

    def growth(self, kind: str, line: str) -> Polynomial:
        """Return zero as a spring's change of length or its rate, since the body is at rest in equilibrium."""
        del kind, line
        return NIL

    # ---- equilibrium

    @cached_property
    def _places(self) -> Sequence[Sequence[Polynomial]]:
        """Return, by axis, the positions of the body and of the fixed ends, in the numbers of the text."""
        m, lexicon = self.mechanism, self.setting.lexicon
        body, nails = m.bodies[0].name, [_nail(m, line) for line in m.lines]
        positions: list[list[Polynomial]] = []
        for axis in range(PLANE_DIMENSIONS):
            pairs: list[tuple[float, ...]] = []
            for f in (initial_frames(m), initial_frames(lexicon.twin)):
                points = [f.center(body).place, *(f.site(nail).place for nail in nails)]
                pairs.append(tuple(float(point[axis]) for point in points))
            positions.append(_unshifted([lexicon.read(DualValue(*pair)) for pair in zip(*pairs, strict=True)]))
        return positions

    @cached_property
    def springs(self) -> list[_Spring]:
        """Return all springs."""
        m, lexicon, entries = self.mechanism, self.setting.lexicon, list[_Spring]()
        for number, line in enumerate(m.lines):
            twin = lexicon.twin.lines[number]
            assert isinstance(line.law, Elastic)
            assert isinstance(twin.law, Elastic)
            x, y = (places[number + 1].expression() for places in self._places)
            stiffness = lexicon.read(DualValue(line.law.stiffness, twin.law.stiffness)).expression()
            natural = lexicon.read(DualValue(line.law.length, twin.law.length)).expression()
            length = self.book.fresh(r"\ell", str(number + 1) if len(m.lines) > 1 else "")
            entries.append(_Spring(line.name, stiffness, natural, (x, y), length))
        return entries

    @cached_property
    def _there(self) -> tuple[float, float]:
        """Return the engine's equilibrium position, m, in the coordinates of the text."""
        rest = equilibrium(self.mechanism)
        if rest is None:
            raise UnsolvedError("there is no equilibrium")
        begun = [self.book.value(places[0].expression()) for places in self._places]
        return begun[0] + float(rest.coordinates[0]), begun[1] + float(rest.coordinates[1])

    @cached_property
    def place(self) -> tuple[Symbol, Symbol]:
        """Write both balances of forces and their solution, and return the symbols X and Y."""
        names = self.book.fresh("X"), self.book.fresh("Y")
        step, who = self.book.begin_step("balance"), self.setting.display_name(self.mechanism.bodies[0].name)
        lengths = {item.length: Root(_square(item, names)) for item in self.springs}
        definitions = [step.law(name, formula) for name, formula in lengths.items()]
        position = f"$({names[0].name}, {names[1].name})$"
        step.add_text(f"With {who} at {position} the springs have the lengths {join_words(definitions)}.")
        sums = [self._sum(names, axis) for axis in range(2)]
        equations = [step.law(item, ZERO) for item in sums]
        step.add_text(f"In equilibrium their forces cancel along both axes: {join_words(equations)}.")
        across, along = (_without(item, lengths) for item in sums)
        inner = NumericRoot(along, names[1].name, self._there[1])
        outer = substitute(across, names[1].name, inner)
        step.add_text(
            roots_sentence(self.book, step, [(names[0], outer, self._there[0])], METRES, "Solved numerically,")
        )
        step.add_text(roots_sentence(self.book, step, [(names[1], along, self._there[1])], METRES, "With it,"))
        shown = [self._told_length(step, name, formula) for name, formula in lengths.items()]
        step.add_text(f"There {join_words(shown)}.")
        step.close()
        return names

    def _sum(self, names: tuple[Symbol, Symbol], axis: int) -> Expression:
        """Return the total restoring force along an axis."""
        force: Expression = ZERO
        for spring in self.springs:
            force = sum_terms(
                force, spring.stiffness * (ONE - spring.natural / spring.length) * (names[axis] - spring.end[axis])
            )
        return force

    def _told_length(self, step: StepBuilder, name: Symbol, formula: Expression) -> str:
        """Record the length of a spring and return it in LaTeX, as a number or as a formula."""
        if self.book.is_hidden(formula):
            return step.result(name, formula, METRES)
        self.book.set_value(name.name, self.book.value(formula), self.book.unit_in_text(METRES))
        step.label(name.name)
        return step.stated(name, METRES)

    # ---- small oscillations

    def oscillate(self, query: PeriodQuery) -> Symbol:
        """Write the direction and stiffness of a mode of small oscillations, and return the answer's symbol."""
        turn = self._direction(query.rank)
        step, stiff, total_stiffness = self.book.begin_step("stiffness"), self.book.fresh(r"\kappa"), ZERO
        for spring in self.springs:
            weight, bearing = self._weights[spring.name]
            across = spring.stiffness - weight
            total_stiffness = total_stiffness + across + weight * Power(Call("cos", bearing - turn), 2)
        text = "Including the tensions, which resist a transverse displacement, the stiffness in this direction is"
        step.add_text(f"{text} {step.result(stiff, total_stiffness, STIFFNESS, law=True)}.")
        step.close()
        mass = self.mass(self.mechanism.bodies[0].name).expression()
        rate = self.book.fresh(r"\omega")
        self.book.add_step("rate", "The angular frequency is", rate, Root(stiff / mass), ANGULAR_SPEED)
        return measured_period(self.book, query, rate)

    @cached_property
    def _weights(self) -> Mapping[str, tuple[Symbol, Symbol]]:
        """Write k ℓ₀/ℓ and the angle with the x axis of each spring; return both symbols by the name of the spring."""
        weights: dict[str, tuple[Symbol, Symbol]] = {}
        position = self.place
        for number, spring in enumerate(self.springs, start=1):
            mark = str(number) if len(self.springs) > 1 else ""
            weight, bearing = self.book.fresh("w", mark), self.book.fresh(r"\beta", mark)
            step = self.book.begin_step("bearing")
            equation = step.result(
                bearing, self._slope(position[1] - spring.end[1], position[0] - spring.end[0]), DEGREES, law=True
            )
            part = step.result(weight, spring.stiffness * spring.natural / spring.length, STIFFNESS, law=True)
            step.add_text(f"Spring {mark} is at {equation} to the x axis; let {part}.")
            step.close()
            weights[spring.name] = weight, bearing
        return weights

    def _slope(self, rise: Expression, run: Expression) -> Expression:
        """Return the angle of a line with the x axis, from the cotangent if the line is steep."""
        steep = abs(self.book.value(run)) < MIN_RUN_TO_RISE * abs(self.book.value(rise))
        return PI / TWO - Call("arctan", run / rise) if steep else Call("arctan", rise / run)

    def _direction(self, rank: int) -> Expression:
        """Write the angle of a mode with the x axis, tan 2α = Σ w sin 2β / Σ w cos 2β, and return it."""
        sine, cosine = ZERO, ZERO
        for weight, bearing in self._weights.values():
            sine = sine + weight * Call("sin", TWO * bearing)
            cosine = cosine + weight * Call("cos", TWO * bearing)
        angle = self.book.fresh(r"\alpha")
        # along 2α the weights add up to the most: there it is stiffest
        stiffest = atan2(self.book.value(sine), self.book.value(cosine)) / 2.0
        formula = HALF * self._slope(sine, cosine)
        wanted = stiffest + (0.0 if rank else pi / 2.0)
        if abs(sin(self.book.value(formula) - wanted)) > HALF.x:
            formula = formula + PI / TWO
        which = "stiffest" if rank else "softest"
        text = f"The force is antiparallel to the displacement in the {which} direction, at the angle"
        return self.book.add_step("direction", text, angle, formula, DEGREES)


def _square(spring: _Spring, position: tuple[Symbol, Symbol]) -> Expression:
    """Return the square of the length of a spring to a position."""
    (x, y), (far, up) = position, spring.end
    return Power(x - far, 2) + Power(y - up, 2)


def _without(formula: Expression, lengths: Mapping[Symbol, Expression]) -> Expression:
    """Return a formula with the lengths of springs substituted for their symbols."""
    for name, length in lengths.items():
        formula = substitute(formula, name.name, length)
    return formula


def _unshifted(places: list[Polynomial]) -> list[Polynomial]:
    """Return positions along an axis without a common shift: x₁, x₂ and x for 0, x₂ − x₁ and x − x₁."""
    for position in places:
        taken = Polynomial({monomial: -part for monomial, part in position.terms.items() if part == -1.0})
        moved = [coordinate + taken for coordinate in places]
        if taken and all(len(coordinate.terms) <= 1 for coordinate in moved):
            return moved
    return places
