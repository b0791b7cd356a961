"""Checks of static friction: a body that sticks or rolls needs at most µ_s N."""

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
from sim2reason.solutions.writing.unit_latex import ACCELERATION, NEWTONS

LIMIT = 1.0 + 1e-9  # largest ratio of the needed friction to µ_s N


def verify_sticking(dynamics: Dynamics) -> None:
    """Write, for each sticking body whose own law gives the friction, that it does not exceed its maximum."""
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
    """Return the greatest static friction µ_s N of a contact on which weights alone press."""
    normal = newton.normal(face).forces.without((f"N{face}",)).scaled(-1.0)
    return multiplied(newton.static_coefficient(face).expression(), normal.expression())


def _tell(dynamics: Dynamics, number: int, friction: Expression, normal: Expression) -> None:
    """Write the comparison of the needed friction with its maximum."""
    book, body = dynamics.book, dynamics.mechanism.faces[number].subject
    friction = friction if book.value(friction) >= 0.0 else -friction
    most = multiplied(dynamics.newton.static_coefficient(number).expression(), normal)
    if book.in_symbols or book.value(friction) > LIMIT * book.value(most):
        return
    if book.is_hidden(friction) or book.is_hidden(most):
        book.afterwards.append(lambda: _tell(dynamics, number, friction, normal))
        return
    step = book.open("verify")
    named = dynamics.names.get(f"f{number}", NIL).names() - book.values.keys()
    said = told_friction(book, step, dynamics.setting.mark(body), friction, most, *map(Symbol, named))
    who = f"{dynamics.setting.called(body)} does not slip"
    starts = [segment.start for segment in dynamics.setting.motion.segments]
    if any(dynamics.segment.start < start < dynamics.setting.time for start in starts):
        who = f"in this phase {who}"
    step.say(f"{capital(who)}: the friction required, {said[0]}, is within the limit of static friction, {said[1]}.")
    step.close()


def tell_slipping_on(newton: Newton, setting: Setting, book: Book, face: int) -> None:
    """Write that a body slides the other way from now on, and why."""
    body = setting.mechanism.faces[face].subject
    step, who, carrier = book.open("verify"), setting.called(body), setting.mechanism.body[body].parent
    said = f"{who} slips in the opposite direction from then on, and the friction on it is reversed"
    if carrier is not None:
        way = f"in the opposite direction relative to {setting.called(carrier)}"
        said = f"{who} slips {way} from then on, and the friction between them is reversed"
    needed = holding(newton, setting, face)
    if needed is None:
        step.say(f"{capital(said)}.")
    elif book.in_symbols:
        step.say(f"By assumption {said}.")
    elif book.is_hidden(needed) or book.is_hidden(limit_of_friction(newton, face)):
        step.say(f"Assume that {said}.")
        book.afterwards.append(lambda: tell_not_held(newton, setting, book, face, needed, ", so it slips, as assumed"))
    else:
        tell_not_held(newton, setting, book, face, needed)
        step.say(f"So {said}.")
    step.close()


def tell_not_held(
    newton: Newton, setting: Setting, book: Book, face: int, needed: Expression, therefore: str = ""
) -> None:
    """State that the friction needed to stay at rest or to roll exceeds its maximum."""
    step, most = book.open("verify"), limit_of_friction(newton, face)
    friction = needed if book.value(needed) >= 0.0 else -needed
    exceeds(book, step, friction, most)
    step.say(f"{_needed_words(newton, setting, step, book, face, (friction, most))}{therefore}.")
    step.close()


def _needed_words(
    newton: Newton, setting: Setting, step: Writing, book: Book, face: int, forces: tuple[Expression, Expression]
) -> str:
    """Return a clause that the friction needed to stay at rest or to roll exceeds its maximum."""
    subject = setting.mechanism.faces[face].subject
    mark, who = setting.mark(subject), setting.called(subject)
    if newton.alone(face) is not None:
        told = told_friction(book, step, mark, *forces)
        return f"To stay at rest, {who} would need the friction {told[0]}, more than {told[1]}"
    (k,) = [j for j in newton.slip(face) if setting.mechanism.coordinates[j].kind == "hinge"]
    heavy = newton.mass(subject) + newton.turning(k, k)
    load = newton.mass(subject) * newton.gravity * newton.along(subject, _way(setting, subject), (0.0, 0.0, -1.0))
    pull, name = over(load, heavy), book.fresh("a", r"\text{roll}")
    x, y, z = setting.mechanism.coordinates[_way(setting, subject)].axis
    sign = 1.0 if book.value(pull) >= 0.0 else -1.0
    way = setting.towards((sign * x, sign * y, sign * z))
    rolls = f"{step.verified(name, pull if sign > 0.0 else -pull, ACCELERATION)} {way}"
    told = told_friction(book, step, mark, *forces)
    whole = (
        f"{who} would move like a mass of ${heavy.expression().latex()}$, including the moment of inertia divided by"
    )
    whole = f"Rolling without slipping, {whole} the square of the radius, with the acceleration {rolls}"
    return f"{whole}. This takes the friction {told[0]}, more than {told[1]}"


def _way(setting: Setting, body: str) -> int:
    """Return the coordinate along which a body slides."""
    m = setting.mechanism
    return next(m.number[c.name] for c in m.body[body].coordinates if c.kind == "slide")


def holding(newton: Newton, setting: Setting, face: int) -> Expression | None:
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
    return over(load * turning, mass + turning) if len(hinges) == 1 else None


def told_friction(
    book: Book, step: Writing, mark: str, friction: Expression, most: Expression, named: Symbol | None = None
) -> list[str]:
    """Return the formulas of the needed and the greatest friction; the needed one is omitted if already `named`."""
    names = [named or book.fresh("f", mark), book.fresh(r"f_{\text{max}}", mark)]
    return [step.verified(name, held, NEWTONS) for name, held in zip(names, (friction, most), strict=True)]


def found_alone(dynamics: Dynamics, rows: list[Row], name: str) -> Expression | None:
    """Return a force from a law in which all other values are known; None if there is none."""
    named = dynamics.names.get(name)
    if named is not None:
        named = named if named.names() <= dynamics.book.values.keys() else named.put(dynamics.bound)
        if named.names() <= dynamics.book.values.keys():
            return named.expression()
    for row in rows:
        zero = row.zero.put({key: held for key, held in dynamics.names.items() if key != name})
        others = zero.names() - {name}
        if name in zero.names() and others <= dynamics.book.values.keys():
            return solved(zero, name)
    return None


def carriers(dynamics: Dynamics, body: str) -> list[str]:
    """Return the bodies that carry a body, the nearest first."""
    found, step = list[str](), dynamics.mechanism.body[body].parent
    while step is not None:
        found.append(step)
        step = dynamics.mechanism.body[step].parent
    return found
