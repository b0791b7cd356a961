"""Checks of static friction: a body that sticks or rolls needs at most µ_s N."""

from math import isinf

from sim2reason.solutions.algebra.elimination import solve_linear
from sim2reason.solutions.algebra.expressions import Expression, Symbol, multiply_factors
from sim2reason.solutions.algebra.fractions import reduced_quotient
from sim2reason.solutions.algebra.polynomials import NIL
from sim2reason.solutions.laws.dynamics import Dynamics
from sim2reason.solutions.laws.newton import Newton, Row
from sim2reason.solutions.setting import ProblemContext, capitalized
from sim2reason.solutions.writing.notation import ACCELERATION, NEWTONS
from sim2reason.solutions.writing.steps import SolutionBuilder, StepBuilder, record_inequality

FRICTION_LIMIT_RATIO = 1.0 + 1e-9  # largest ratio of the needed friction to µ_s N


def verify_sticking(dynamics: Dynamics) -> None:
    """Write, for each sticking body whose own law gives its friction, that this does not exceed its maximum."""
    mechanism, newton = dynamics.mechanism, dynamics.newton
    law_bodies = {mechanism.coordinates[row.number].body for group in dynamics.groups for row in group}
    law_bodies |= {carrier for body in law_bodies for carrier in carriers(dynamics, body)}
    for number, side in newton.slip_directions.items():
        face = mechanism.faces[number]
        if side or isinf(face.friction) or not law_bodies & {face.subject, *carriers(dynamics, face.subject)}:
            continue
        rows, _ = dynamics.laws([f"N{number}"])
        friction, normal = (force_from_one_law(dynamics, rows, f"{kind}{number}") for kind in "fN")
        if friction is not None and normal is not None:
            _write_comparison(dynamics, number, friction, normal)


def limit_of_friction(newton: Newton, face: int) -> Expression:
    """Return the greatest static friction µ_s N of a contact on which weights alone press."""
    normal = newton.normal(face).forces.terms_without((f"N{face}",)).scale(-1.0)
    return multiply_factors(newton.static_coefficient(face).expression(), normal.expression())


def _write_comparison(dynamics: Dynamics, number: int, friction: Expression, normal: Expression) -> None:
    """Write that the friction needed to stick is at most the greatest static friction."""
    book, body = dynamics.book, dynamics.mechanism.faces[number].subject
    friction = friction if book.value(friction) >= 0.0 else -friction
    most = multiply_factors(dynamics.newton.static_coefficient(number).expression(), normal)
    if book.in_symbols or book.value(friction) > FRICTION_LIMIT_RATIO * book.value(most):
        return
    if book.is_hidden(friction) or book.is_hidden(most):
        book.afterwards.append(lambda: _write_comparison(dynamics, number, friction, normal))
        return
    step = book.begin_step("verify")
    named = dynamics.names.get(f"f{number}", NIL).names() - book.values.keys()
    equations = friction_formulas(book, step, dynamics.setting.subscript_of(body), friction, most, *map(Symbol, named))
    who = f"{dynamics.setting.display_name(body)} does not slip"
    starts = [segment.start for segment in dynamics.setting.motion.segments]
    if any(dynamics.segment.start < start < dynamics.setting.time for start in starts):
        who = f"in this phase {who}"
    step.add_text(
        f"{capitalized(who)}: the friction required, {equations[0]}, "
        f"is within the limit of static friction, {equations[1]}."
    )
    step.close()


def tell_slipping_on(newton: Newton, setting: ProblemContext, book: SolutionBuilder, face: int) -> None:
    """Write that a body whose slip has stopped slips in the opposite direction from then on, with the reason."""
    body = setting.mechanism.faces[face].subject
    step, who, carrier = book.begin_step("verify"), setting.display_name(body), setting.mechanism.body[body].parent
    sentence = f"{who} slips in the opposite direction from then on, and the friction on it is reversed"
    if carrier is not None:
        direction = f"in the opposite direction relative to {setting.display_name(carrier)}"
        sentence = f"{who} slips {direction} from then on, and the friction between them is reversed"
    needed = required_friction(newton, setting, face)
    if needed is None:
        step.add_text(f"{capitalized(sentence)}.")
    elif book.in_symbols:
        step.add_text(f"By assumption {sentence}.")
    elif book.is_hidden(needed) or book.is_hidden(limit_of_friction(newton, face)):
        step.add_text(f"Assume that {sentence}.")
        book.afterwards.append(lambda: write_not_held(newton, setting, book, face, needed, ", so it slips, as assumed"))
    else:
        write_not_held(newton, setting, book, face, needed)
        step.add_text(f"So {sentence}.")
    step.close()


def write_not_held(
    newton: Newton, setting: ProblemContext, book: SolutionBuilder, face: int, needed: Expression, therefore: str = ""
) -> None:
    """Write that the friction needed to stay at rest or to roll exceeds the greatest static friction."""
    step, most = book.begin_step("verify"), limit_of_friction(newton, face)
    friction = needed if book.value(needed) >= 0.0 else -needed
    record_inequality(book, step, friction, most)
    step.add_text(f"{_needed_words(newton, setting, step, book, face, (friction, most))}{therefore}.")
    step.close()


def _needed_words(
    newton: Newton,
    setting: ProblemContext,
    step: StepBuilder,
    book: SolutionBuilder,
    face: int,
    forces: tuple[Expression, Expression],
) -> str:
    """Return a clause that the friction needed to stay at rest or to roll exceeds the greatest static friction."""
    subject = setting.mechanism.faces[face].subject
    mark, who = setting.subscript_of(subject), setting.display_name(subject)
    if newton.single_slip_coordinate(face) is not None:
        equations = friction_formulas(book, step, mark, *forces)
        return f"To stay at rest, {who} would need the friction {equations[0]}, more than {equations[1]}"
    (k,) = [j for j in newton.slip(face) if setting.mechanism.coordinates[j].kind == "hinge"]
    heavy = newton.mass(subject) + newton.turning(k, k)
    load = (
        newton.mass(subject)
        * newton.gravity
        * newton.along(subject, _slip_coordinate(setting, subject), (0.0, 0.0, -1.0))
    )
    pull, name = reduced_quotient(load, heavy), book.fresh("a", r"\text{roll}")
    x, y, z = setting.mechanism.coordinates[_slip_coordinate(setting, subject)].axis
    sign = 1.0 if book.value(pull) >= 0.0 else -1.0
    direction = setting.direction_words((sign * x, sign * y, sign * z))
    rolls = f"{step.verified(name, pull if sign > 0.0 else -pull, ACCELERATION)} {direction}"
    equations = friction_formulas(book, step, mark, *forces)
    clause = (
        f"{who} would move like a mass of ${heavy.expression().latex()}$, including the moment of inertia divided by"
    )
    clause = f"Rolling without slipping, {clause} the square of the radius, with the acceleration {rolls}"
    return f"{clause}. This takes the friction {equations[0]}, more than {equations[1]}"


def _slip_coordinate(setting: ProblemContext, body: str) -> int:
    """Return the coordinate along which a body slides."""
    m = setting.mechanism
    return next(m.number[c.name] for c in m.body[body].coordinates if c.kind == "slide")


def required_friction(newton: Newton, setting: ProblemContext, face: int) -> Expression | None:
    """Return the friction with which a single body sticks (its load) or rolls (load · I/(I + m R²)); else None."""
    mechanism, subject = setting.mechanism, setting.mechanism.faces[face].subject
    ways = [mechanism.number[c.name] for c in mechanism.body[subject].coordinates if c.kind == "slide"]
    if len(mechanism.bodies) > 1 or mechanism.lines or mechanism.forces or len(ways) != 1:
        return None
    mass, (k,) = newton.mass(subject), ways
    load = mass * newton.gravity * newton.along(subject, k, (0.0, 0.0, -1.0))
    hinges = [j for j in newton.slip(face) if j != k]
    if not hinges:
        return load.expression()
    turning = newton.turning(hinges[0], hinges[0])
    return reduced_quotient(load * turning, mass + turning) if len(hinges) == 1 else None


def friction_formulas(
    book: SolutionBuilder,
    step: StepBuilder,
    mark: str,
    friction: Expression,
    most: Expression,
    named: Symbol | None = None,
) -> list[str]:
    """Return the equations of the needed and of the greatest friction; `named` is the needed one's symbol, if any."""
    names = [named or book.fresh("f", mark), book.fresh(r"f_{\text{max}}", mark)]
    return [step.verified(name, force, NEWTONS) for name, force in zip(names, (friction, most), strict=True)]


def force_from_one_law(dynamics: Dynamics, rows: list[Row], name: str) -> Expression | None:
    """Return a force or acceleration from a law without other unknowns; None if no such law exists."""
    named = dynamics.names.get(name)
    if named is not None:
        named = named if named.names() <= dynamics.book.values.keys() else named.substitute(dynamics.bound)
        if named.names() <= dynamics.book.values.keys():
            return named.expression()
    for row in rows:
        zero = row.zero.substitute({key: polynomial for key, polynomial in dynamics.names.items() if key != name})
        others = zero.names() - {name}
        if name in zero.names() and others <= dynamics.book.values.keys():
            return solve_linear(zero, name)
    return None


def carriers(dynamics: Dynamics, body: str) -> list[str]:
    """Return the bodies that carry a body, the nearest first."""
    bodies, step = list[str](), dynamics.mechanism.body[body].parent
    while step is not None:
        bodies.append(step)
        step = dynamics.mechanism.body[step].parent
    return bodies
