"""A small body that swings about a fixed point: its pivot and length, and its angle and speed at one moment."""

from math import acos, cos, hypot

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.questions.moments.times import AtStart
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import Inextensible, Mechanism, Rigid
from sim2reason.scenes.dsl.state import Array
from sim2reason.scenes.dsl.vectors import subtract_triples
from sim2reason.solutions.algebra.expressions import (
    ONE,
    ZERO,
    Expression,
    Number,
    Symbol,
    multiply_factors,
    ratio,
    sum_terms,
)
from sim2reason.solutions.algebra.functions import PI, Call, Power, Root, sum_of_squares
from sim2reason.solutions.setting import ProblemContext, capitalized
from sim2reason.solutions.swings.angle import SMALL_OSCILLATIONS_LEAD, SwingAngle
from sim2reason.solutions.swings.asked import by_energy
from sim2reason.solutions.writing.notation import ANGULAR_SPEED, DEGREES, SPEED
from sim2reason.solutions.writing.steps import SolutionBuilder, StepBuilder, record_inequality


def pivot(m: Mechanism) -> tuple[str, str | None, tuple[float, float, float]] | None:
    """Return the swinging body, the line that holds it (None: a hinge), and the pivot; None if there is none."""
    heavy = [body for body in m.bodies if body.mass]
    if len(heavy) != 1 or any(heavy[0].inertia) or m.faces or m.forces or m.attractions or m.burns or m.feet:
        return None
    frames, body = initial_frames(m), heavy[0]
    if len(m.coordinates) == 1 and m.coordinates[0].kind == "hinge" and not m.lines:
        carrier = m.body[m.coordinates[0].body]
        level = abs(m.coordinates[0].axis[2]) < 1e-9
        return (body.name, None, frames[carrier.name].origin) if carrier.parent is None and level else None
    line = m.lines[0] if len(m.lines) == 1 else None
    if line is None or len(line.through) != 2 or not isinstance(line.law, Inextensible | Rigid):
        return None
    fixed = [m.site[site] for site in line.through if m.site[site].body is None]
    flat = {c.axis for c in m.coordinates} == {(1.0, 0.0, 0.0), (0.0, 0.0, 1.0)} and len(m.coordinates) == 2
    loose = getattr(line.law, "slack", 0.0) or getattr(line.law, "reel", 0.0)
    return (body.name, line.name, fixed[0].at) if len(fixed) == 1 and flat and not loose else None


def pendulum_vector(m: Mechanism) -> tuple[float, float, float]:
    """Return the vector, m, from the pivot to the body at the start."""
    suspension = pivot(m)
    assert suspension is not None, "who asks has seen that it swings"
    body, _, point = suspension
    x, y, z = subtract_triples(initial_frames(m).center(body).place, point)
    return float(x), float(y), float(z)


def geometry(m: Mechanism) -> tuple[float, float, float]:
    """Return the length, m, the initial angle with the downward vertical, rad, and the initial speed, m/s."""
    offset = pendulum_vector(m)
    length = hypot(*offset)
    if len(m.coordinates) == 1:
        speed = abs(m.coordinates[0].speed) * length
    else:
        speed = hypot(*(coordinate.speed for coordinate in m.coordinates))
    return length, acos(max(-1.0, min(1.0, -offset[2] / length))), speed


TURN_SAMPLES = 257  # samples up to the moment, which is at most a few turns after the start


class SwingState(SwingAngle):
    """The angle and the speed of a swing at the moment of the question, written as needed.

    Angles are counted from the downward vertical, positive on the initial side.
    """

    def __init__(self, setting: ProblemContext, book: SolutionBuilder) -> None:
        """Read the parameters; raise UnreadError if the length or initial state is not a simple function of them."""
        super().__init__(setting, book)
        suspension = pivot(setting.mechanism)
        assert suspension is not None
        self.body, self.line, _ = suspension
        lexicon = setting.lexicon
        parts = (lexicon.formula_for(lambda m, n=n: geometry(m)[n]).expression() for n in range(3))
        self.length, self.initial_angle, self.launch = parts
        self.gravity = lexicon.formula_for(lambda m: -m.gravity[2]).expression()
        self.mass = lexicon.formula_for(lambda m: m.body[self.body].mass).expression()
        moment = setting.query.moment
        assert moment is not None
        when = moment.evaluation_time(setting.time)
        angles, rates = self._engine_angles(np.array([0.0, when]))
        self.initial_angle_value, self.moment_angle, self.turning = (
            geometry(lexicon.mechanism)[1],
            float(angles[1]),
            float(rates[1]),
        )
        self.initial_rate_sign = 1.0 if rates[0] >= 0.0 else -1.0
        self._when_seen = when

    @cached_property
    def turned(self) -> float:  # type: ignore[override]
        """Return the angle turned through, rad, including whole turns."""
        angles = np.unwrap(self._engine_angles(np.linspace(0.0, self._when_seen, TURN_SAMPLES))[0])
        return float(angles[-1] - angles[0])

    def _engine_angles(self, times: Array) -> tuple[Array, Array]:
        """Return the engine's angles and their rates at some times, each (n,), for signs alone."""
        state = self.setting.study.trace.sample(times)
        suspension = pivot(self.setting.mechanism)
        assert suspension is not None
        point, center = suspension[2], state.frames.center(self.body)
        x, y, z = (np.broadcast_to(part, times.shape) - point[n] for n, part in enumerate(center.place))
        side = 1.0 if pendulum_vector(self.setting.mechanism)[0] >= 0.0 else -1.0
        across = side * (center.velocity[2] * x - center.velocity[0] * z)
        return np.arctan2(side * x, -z), across / (x * x + y * y + z * z)

    # ---- the angle and the speed

    _slackened: Symbol | None = None  # the speed at which the string goes slack, once it is written

    @cached_property
    def small_oscillation_frequency(self) -> Symbol:
        """Write the angular frequency of small oscillations, ω₀² = g/ℓ, and return its symbol."""
        formula = Root(ratio(self.gravity, self.length))
        return self.book.add_step(
            "natural", SMALL_OSCILLATIONS_LEAD, self.book.fresh(r"\omega", "0"), formula, ANGULAR_SPEED
        )

    @cached_property
    def initial_angular_speed(self) -> Expression:
        """Return the initial angular speed v₀/ℓ, rad/s."""
        return ratio(self.launch, self.length)

    @property
    def goes_round(self) -> bool:
        """Return whether the energy suffices to pass the top, v₀² > 2 g ℓ (1 + cos θ₀), if no string goes slack."""
        g, ell, v = (self.book.value(part) for part in (self.gravity, self.length, self.launch))
        return v**2 > 2.0 * g * ell * (1.0 + cos(self.initial_angle_value))

    def _write_turning_angle(self) -> Expression:
        """Write the angle of the turning point from conservation of energy and return it with its sign."""
        name = self.book.fresh(r"\phi", r"\text{max}")
        step = self.book.begin_step("energy")
        m, g, ell, v = self.mass, self.gravity, self.length, self.launch
        high = multiply_factors(multiply_factors(m, multiply_factors(g, ell)), sum_terms(ONE, -Call("cos", name)))
        law = step.law(high, self._energy)
        ratio_of = ratio(sum_of_squares([v]), multiply_factors(Number(2.0), multiply_factors(g, ell)))
        formula = Call("arccos", sum_terms(self.cosine_first, -ratio_of))
        beyond = self.moment_angle < 0.0 if not self.extreme else True
        other = " on the other side of the vertical," if beyond and self.initial_angle != ZERO else ""
        text = f"{capitalized(self.who)} turns back{other} where all its energy is potential"
        step.add_text(f"{text}: {law}, so {step.result(name, formula, DEGREES)}.")
        if self.line is not None and not self.book.is_hidden(formula):
            self._tell_reach(step, name, "this")
        step.close()
        if self.line is not None and not self.book.in_symbols and self.book.is_hidden(formula):
            self.book.afterwards.append(lambda: self._verify_reach(name))
        return -name if beyond else name

    def _tell_reach(self, step: StepBuilder, reach: Symbol, called: str) -> None:
        """Write that the string stays taut, as the angle `reach` of the turning point is less than 90°."""
        record_inequality(self.book, step, PI / Number(2.0), reach)
        step.add_text(f"As {called} is less than $90^\\circ$, the string stays taut until then.")

    def _verify_reach(self, reach: Symbol) -> None:
        """Write after the answer that the string stays taut, if the turning angle depends on the unknown."""
        step = self.book.begin_step("verify")
        self._tell_reach(step, reach, f"${reach.latex()}$")
        step.close()

    def _at_extreme(self) -> Expression:
        if self.extreme != "fastest" and self.goes_round:
            self._tell_top()
        return super()._at_extreme()

    def _tell_top(self) -> None:
        """Write why the body passes the top of the circle, if numbers are known."""
        g, ell, begun = self.gravity, self.length, sum_of_squares([self.launch])
        needed = multiply_factors(
            Number(2.0), multiply_factors(multiply_factors(g, ell), sum_terms(ONE, self.cosine_first))
        )
        if self.book.is_hidden(begun) or self.book.is_hidden(needed):
            return
        step = self.book.begin_step("extreme")
        record_inequality(self.book, step, begun, needed)
        step.add_text(f"As ${begun.latex()} > {needed.latex()}$, {self.who} still moves at the top of the circle.")
        step.close()

    def _slack(self) -> Expression:
        """Write the angle at which the string goes slack, m v²/ℓ = −m g cos φ, and return it with its sign."""
        name, fast = self.book.fresh(r"\phi"), self.book.fresh("v", r"\text{s}")
        step, bent = self.book.begin_step("slack"), Call("cos", name)
        g, ell, v = self.gravity, self.length, self.launch
        circle = step.law(ratio(Power(fast, 2), ell), -multiply_factors(g, bent))
        gained = multiply_factors(
            multiply_factors(Number(2.0), multiply_factors(g, ell)), sum_terms(bent, -self.cosine_first)
        )
        energy = step.law(Power(fast, 2), sum_terms(sum_of_squares([v]), gained))
        over = ratio(sum_of_squares([v]), multiply_factors(g, ell))
        formula = Call("arccos", ratio(sum_terms(multiply_factors(Number(2.0), self.cosine_first), -over), Number(3.0)))
        step.add_text(f"Let ${name.name}$ be the angle of the string with the downward vertical when it goes slack.")
        step.add_text(
            "There the tension is zero, and the component of gravity along the string alone is the centripetal"
        )
        step.add_text(f"acceleration: {circle}.")
        step.add_text(f"By conservation of energy, {energy}.")
        step.add_text(f"Together, {step.result(name, formula, DEGREES)}")
        step.add_text(f"and {step.result(fast, Root(-multiply_factors(multiply_factors(g, ell), bent)), SPEED)}.")
        step.close()
        self._slackened = fast
        return name if self.moment_angle >= 0.0 else -name

    @property
    def _energy(self) -> Expression:
        """Return the initial kinetic and potential energy, with zero potential energy at the lowest point, J."""
        m, g, ell = self.mass, self.gravity, self.length
        high = multiply_factors(multiply_factors(m, multiply_factors(g, ell)), sum_terms(ONE, -self.cosine_first))
        if self.launch == ZERO:
            return high
        return sum_terms(multiply_factors(Number(0.5), multiply_factors(m, Power(self.launch, 2))), high)

    @cached_property
    def squared(self) -> Expression:
        """Write the speed at the moment, m/s, and return its square."""
        moment = self.setting.query.moment
        if isinstance(moment, AtStart):
            return sum_of_squares([self.launch])
        if self.is_at_rest:
            return ZERO
        there = self.cosine
        if self._slackened is not None:
            return Power(self._slackened, 2)
        step, name = self.book.begin_step("energy"), self.book.fresh("v")
        gained = multiply_factors(
            multiply_factors(Number(2.0), multiply_factors(self.gravity, self.length)),
            sum_terms(there, -self.cosine_first),
        )
        square = sum_terms(sum_of_squares([self.launch]), gained)
        law = step.law(Power(name, 2), square)
        text = by_energy(self.setting, "speed", name, extreme=bool(self.extreme))
        step.add_text(f"{text} {law}, so {step.result(name, Root(square), SPEED)}.")
        step.close()
        return Power(name, 2)

    @property
    def speed(self) -> Expression:
        """Return the speed at the moment, m/s."""
        return self.squared.base if isinstance(self.squared, Power) else ZERO

    @property
    def who(self) -> str:
        """Return the phrase for the swinging body, such as *the ball*."""
        return self.setting.display_name(self.body)
