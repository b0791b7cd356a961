"""What was assumed of friction is verified: what sticks, or rolls, needs no more than µN."""

from math import isinf

from sim2reason.solutions.algebra.elimination import solved
from sim2reason.solutions.algebra.expressions import Expression, Symbol, multiplied
from sim2reason.solutions.algebra.fractions import over
from sim2reason.solutions.algebra.polynomials import NIL
from sim2reason.solutions.laws.dynamics import Dynamics
from sim2reason.solutions.laws.newton import Newton, Row
from sim2reason.solutions.setting import Setting, capital
from sim2reason.solutions.writing.comparing import exceeds
from sim2reason.solutions.writing.steps import Book, Writing
from sim2reason.solutions.writing.unit_latex import NEWTONS

LIMIT = 1.0 + 1e-9


def verify_sticking(dynamics: Dynamics) -> None:
    """A step for each body that sticks where its law alone says which friction that takes; nothing rests on it."""
    mechanism, newton = dynamics.mechanism, dynamics.newton
    spoken = {mechanism.coordinates[row.number].body for group in dynamics.groups for row in group}
    spoken |= {carrier for body in spoken for carrier in carriers(dynamics, body)}
    for number, side in newton.rough.items():
        face = mechanism.faces[number]
        if side or isinf(face.friction) or not spoken & {face.subject, *carriers(dynamics, face.subject)}:
            continue
        rows, _ = dynamics.laws([f"N{number}"])
        friction, normal = (found_alone(dynamics, rows, f"{kind}{number}") for kind in "fN")
        if friction is not None and normal is not None:
            _tell(dynamics, number, friction, normal)


def limit_of_friction(newton: Newton, face: int) -> Expression:
    """Return µN, where weights alone press on the face."""
    normal = newton.normal(face).forces.without((f"N{face}",)).scaled(-1.0)
    return multiplied(newton.coefficient(face).expression(), normal.expression())


def _tell(dynamics: Dynamics, number: int, friction: Expression, normal: Expression) -> None:
    book, body = dynamics.book, dynamics.mechanism.faces[number].subject
    friction = friction if book.value(friction) >= 0.0 else -friction
    most = multiplied(dynamics.newton.coefficient(number).expression(), normal)
    if book.is_hidden(friction) or book.is_hidden(most) or book.value(friction) > LIMIT * book.value(most):
        return
    step = book.open("verify")
    named = dynamics.names.get(f"f{number}", NIL).names() - book.values.keys()
    said = told_friction(book, step, dynamics.setting.mark(body), friction, most, *map(Symbol, named))
    who = capital(dynamics.setting.called(body))
    step.say(
        f"{who} does not slip: the friction required, {said[0]}, is within the limit of static friction, {said[1]}."
    )
    step.close()


def tell_slipping_on(newton: Newton, setting: Setting, book: Book, face: int) -> None:
    """Write that a body slips the other way from now on, and why, with numbers if nothing else holds it."""
    body = setting.mechanism.faces[face].subject
    step, who = book.open("verify"), capital(setting.called(body))
    said = f"{who} slips in the opposite direction from then on, and the friction on it is reversed"
    needed = holding(newton, setting, face)
    if needed is None:
        step.say(f"{said}.")
    else:
        friction, most = needed, limit_of_friction(newton, face)
        friction = friction if book.value(friction) >= 0.0 else -friction
        exceeds(book, step, friction, most)
        told = told_friction(book, step, setting.mark(body), friction, most)
        grip = "roll without slipping" if newton.alone(face) is None else "stay at rest"
        step.say(f"To {grip} {setting.called(body)} would need the friction {told[0]}, more than {told[1]}.")
        step.say(f"{said}.")
    step.close()


def holding(newton: Newton, setting: Setting, face: int) -> Expression | None:
    """Return the friction for a lone body to stick (its load) or to roll (I/(I + m R²) of it); else None."""
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
    return over(load * turning, mass + turning) if len(hinges) == 1 else None


def told_friction(
    book: Book, step: Writing, mark: str, friction: Expression, most: Expression, named: Symbol | None = None
) -> list[str]:
    """Return the formulas of the friction that is needed, unless it is `named` already a new name, and the greatest."""
    names = [named or book.fresh("f", mark), book.fresh(r"f_{\text{max}}", mark)]
    for name, held in zip(names, (friction, most), strict=True):
        book.observed[name.name] = book.value(held)
    return [step.verified(name, held, NEWTONS) for name, held in zip(names, (friction, most), strict=True)]


def found_alone(dynamics: Dynamics, rows: list[Row], name: str) -> Expression | None:
    """A force, from a law in which all else has a value by now; None if there is none."""
    named = dynamics.names.get(name)
    if named is not None and named.names() <= dynamics.book.values.keys():
        return named.expression()
    for row in rows:
        zero = row.zero.put({key: held for key, held in dynamics.names.items() if key != name})
        others = zero.names() - {name}
        if name in zero.names() and others <= dynamics.book.values.keys():
            return solved(zero, name)
    return None


def carriers(dynamics: Dynamics, body: str) -> list[str]:
    """Return what carries a body, the nearest first."""
    found, step = list[str](), dynamics.mechanism.body[body].parent
    while step is not None:
        found.append(step)
        step = dynamics.mechanism.body[step].parent
    return found
