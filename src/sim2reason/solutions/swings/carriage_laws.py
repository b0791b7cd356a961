"""A swing on a carriage: position, velocities, accelerations and forces.

Momentum along the rail and energy give the motion, Newton's law the rest: see Morin, Introduction to Classical
Mechanics, chapters 5 and 6, and Landau and Lifshitz, Mechanics, section 5, problem 2. A constant pull along the rail
accelerates all bodies: in the frame with this acceleration, momentum is conserved and inertial forces do work.
"""

from sim2reason.base.records import cached_property
from sim2reason.questions.moments.angles import Deflected
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Power, Root, sum_of_squares
from sim2reason.solutions.swings.carriage_angle import TWO, CarriageAngle
from sim2reason.solutions.writing.notation import (
    ACCELERATION,
    ANGULAR_ACCELERATION,
    ANGULAR_SPEED,
    METRES,
    NEWTONS,
    SPEED,
)

HALF = Number(0.5)


class CarriageLaws(CarriageAngle):
    """The laws of a swing on a carriage, written as needed."""

    # ---- the motion

    @cached_property
    def rate(self) -> Expression:
        """Write the angular speed of the arm, rad/s, and return it."""
        if self.begins or self.is_at_rest:
            return ZERO
        return self._moving[0]

    @cached_property
    def speed(self) -> Expression:
        """Write the speed of the carriage, m/s, opposite to that of the arm along the rail, and return it."""
        if self.begins or self.is_at_rest:
            return ZERO
        self.unloaded()
        return self._moving[1]

    @cached_property
    def _moving(self) -> tuple[Symbol, Symbol]:
        """Write conservation of momentum and energy, and return the angular speed and the carriage speed."""
        c, book, there = self.carriage, self.book, self.cosine
        drift = self._drift
        step, turns, runs = book.begin_step("energy"), book.fresh(r"\omega"), book.fresh("V")
        fallen, ahead = there - self.cosine_first, self.signed_sine - self.sine_first
        work = self.moment * self.gravity * fallen
        work = work - self.moment * drift * ahead
        worth = self.gravity * fallen - drift * ahead
        square = TWO * c.total_mass * worth / (self.length * self.effective_inertia)
        if not self.is_single_body:
            square = TWO * self.moment * c.total_mass * worth / self.effective_inertia
        momentum, energy = self._conservation_sides(turns, runs)
        kept, energy_law = step.law(*momentum), step.law(energy, work)
        step.add_text(*self._named(turns, runs))
        inertial = " with the work of the pull and of the inertial forces" if drift != ZERO else ""
        step.add_text(
            f"The momentum along the rail stays zero, {kept}, and energy is conserved{inertial}: {energy_law}. Together"
        )
        solved = step.result(turns, Root(square), ANGULAR_SPEED)
        formula = self.moment * turns * there / c.total_mass
        if self.is_single_body and self.sine == ZERO:
            formula = self.mass * Root(TWO * self.length * worth / (c.total_mass * c.sliding_mass))
        step.add_text(f"{solved} and {step.result(runs, formula, SPEED)}.")
        step.close()
        return turns, runs

    def _named(self, turns: Symbol, runs: Symbol) -> tuple[str, ...]:
        """Return sentences that name the angular speed and the carriage speed, and give the velocities of the arm."""
        c, lowest = self.carriage, self.angle == ZERO
        who = (
            self.setting.display_name(self.arm.bodies[0])
            if self.is_single_body
            else f"the centre of mass of {self.swings}"
        )
        seen = "in the frame with this acceleration, " if self._drift != ZERO else ""
        beyond = isinstance(self.setting.query.moment, Deflected) and self.moment_angle < 0.0
        side = f", {self.swings} being on the other side of the vertical" if beyond else ""
        where = f"When {who} is at the lowest point" if lowest else f"At this moment{side}"
        lead = f"{where}, {seen}let {self.swings} turn at ${turns.name}$ and {c.noun} move at ${runs.name}$."
        if not self.is_single_body:
            return lead, f"The horizontal velocity of {who} relative to {c.noun} is opposite to ${runs.name}$."
        along = (self.length * turns * self.cosine).latex()
        across = (
            "" if self.sine == ZERO else f" and the vertical component ${(self.length * turns * self.sine).latex()}$"
        )
        velocity = f"the horizontal velocity ${along}$" if not across else f"the horizontal component ${along}${across}"
        return (
            lead,
            f"The velocity of {who} relative to {c.noun} has {velocity}, and {c.noun} moves the opposite way."
            if across
            else f"Relative to {c.noun}, {who} has {velocity}; {c.noun} moves the opposite way.",
        )

    def _conservation_sides(self, turns: Symbol, runs: Symbol) -> tuple[tuple[Expression, Expression], Expression]:
        """Return both sides of the conservation of momentum, and the kinetic energy."""
        c, along = self.carriage, turns * self.cosine
        if self.is_single_body:
            ahead = self.length * along - runs
            squared = sum_of_squares([ahead, self.length * turns * self.sine])
            moving = HALF * c.sliding_mass * Power(runs, 2) + HALF * self.mass * squared
            return (c.sliding_mass * runs, self.mass * ahead), moving
        crossed = self.moment * along * runs
        plain = HALF * c.total_mass * Power(runs, 2) + HALF * self.arm.inertia * Power(turns, 2)
        return (c.total_mass * runs, self.moment * along), plain - crossed

    @cached_property
    def _drift(self) -> Expression:
        """Write the acceleration of the common centre of mass due to strings along the rail, m/s², and return it."""
        if self.driving_force == ZERO:
            return ZERO
        lead = "The force along the rail gives the common centre of mass the acceleration"
        text, name = " ".join([*self._hanging(), lead]), self.book.fresh("a", "0")
        return self.book.add_step("frame", text, name, self.driving_force / self.carriage.total_mass, ACCELERATION)

    @cached_property
    def place(self) -> Expression:
        """Write the forward displacement of the carriage, m, and return it."""
        if self.begins:
            return ZERO
        self.unloaded()
        if self.angle != ZERO and self._far is not None:
            return self._far
        over = self.sine_first - self.signed_sine if self.angle != -self.initial_angle else TWO * self.sine_first
        formula = self.moment * over / self.carriage.total_mass
        text = "The common centre of mass does not move along the rail, so the displacement of "
        text += f"{self.carriage.noun} is"
        return self.book.add_step("place", text, self.book.fresh("x"), formula, METRES)

    # ---- how that changes

    @cached_property
    def radial_pull(self) -> Expression:
        """Return the force in the rod per unit mass, m/s², for an unaccelerated carriage."""
        plain = self.gravity * self.cosine
        return plain + self.length * sum_of_squares([self.rate])

    @cached_property
    def rod(self) -> Symbol:
        """Return the force in the rod of a single small body, N."""
        return self._pulled[0]

    @cached_property
    def _pulled(self) -> tuple[Symbol, Expression]:
        """Write the force in the rod, N, and the acceleration of the carriage, m/s²; return both."""
        name, book, c = self.book.fresh("T"), self.book, self.carriage
        pull, mass = self.radial_pull, self.mass
        who = self.setting.display_name(self.arm.bodies[0])
        if self.sine == ZERO:
            text = f"By Newton's second law along {self.swings} for {who}, in the frame of {c.noun},"
            return book.add_step("rod", text, name, mass * pull, NEWTONS), ZERO
        step, a = book.begin_step("rod"), book.fresh("a", r"\text{c}")
        pulled = self.driving_force + name * self.signed_sine
        along = step.law(name, mass * (pull - a * self.signed_sine))
        rail = step.law(c.sliding_mass * a, pulled)
        step.add_text(*self._hanging())
        step.add_text(f"Let ${name.name}$ be the force in {self.swings} and ${a.name}$ the acceleration of {c.noun}")
        step.add_text(f"{c.way}, which causes an inertial force in its frame. Along {self.swings}, for {who}: {along}.")
        step.add_text("Along the rail, for")
        over = c.sliding_mass * pull - self.driving_force * self.signed_sine
        step.add_text(f"{c.noun}: {rail}. Together {step.result(name, mass * over / self.effective_inertia, NEWTONS)}")
        step.add_text(f"and {step.result(a, pulled / c.sliding_mass, ACCELERATION)}.")
        step.close()
        return name, a

    @cached_property
    def carriage_acceleration(self) -> Expression:
        """Write the forward acceleration of the carriage, m/s², and return it."""
        if self.sine == ZERO and self.driving_force == ZERO:
            return ZERO
        if not self.is_single_body:
            return self._turned_up[1]
        if self.sine != ZERO:
            return self._pulled[1]
        lead = (
            f"The force in {self.swings} has no component along the rail, so the acceleration of {self.carriage.noun}"
        )
        text = " ".join([*self._hanging(), f"{lead} {self.carriage.way} is"])
        name = self.book.fresh("a", r"\text{c}")
        return self.book.add_step("newton", text, name, self.driving_force / self.carriage.sliding_mass, ACCELERATION)

    @cached_property
    def angular_acceleration(self) -> Expression:
        """Write the angular acceleration of the arm towards the lowest point, rad/s², and return it."""
        if not self.is_single_body:
            return self._turned_up[0] if self.sine != ZERO or self.driving_force != ZERO else ZERO
        a = self.carriage_acceleration
        back = a * self.cosine
        formula = (self.gravity * self.signed_sine + back) / self.length
        if self.book.value(formula) == 0.0:
            return ZERO
        counted = f"the angular acceleration of {self.swings}, {self.carriage.turning}, is"
        text = f"Along the circle, with weight and inertial force, {counted}"
        return self.book.add_step("growth", text, self.book.fresh(r"\alpha"), formula, ANGULAR_ACCELERATION)

    @cached_property
    def _turned_up(self) -> tuple[Symbol, Symbol]:
        """Write the angular acceleration of an arm and the acceleration of its carriage; return both."""
        c, book, s, inertia = self.carriage, self.book, self.moment, self.arm.inertia
        step, turns, a = book.begin_step("torque"), book.fresh(r"\alpha"), book.fresh("a", r"\text{c}")
        bent = sum_of_squares([self.rate]) * self.signed_sine
        net_force = self.driving_force + s * bent
        weight = self.gravity * self.signed_sine
        rail = step.law(c.total_mass * a, self.driving_force + s * (turns * self.cosine + bent))
        torque = step.law(inertia * turns, s * (weight + a * self.cosine))
        step.add_text(*self._hanging())
        step.add_text(f"Let ${turns.name}$ be the angular acceleration of {self.swings}, {c.turning}, and ${a.name}$")
        step.add_text(f"the acceleration of {c.noun} {c.way}. Along the rail, with all masses: {rail}.")
        step.add_text("About the axle, with the inertial")
        over = s * (c.total_mass * weight + self.cosine * net_force)
        step.add_text(
            f"force: {torque}. Together {step.result(turns, over / self.effective_inertia, ANGULAR_ACCELERATION)}"
        )
        formula = (net_force + s * turns * self.cosine) / c.total_mass
        step.add_text(f"and {step.result(a, formula, ACCELERATION)}.")
        step.close()
        return turns, a
