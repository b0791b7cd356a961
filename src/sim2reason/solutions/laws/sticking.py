"""What was assumed of friction is verified: what sticks, or rolls, needs no more than µN."""

from math import isinf

from sim2reason.solutions.algebra.elimination import solved
from sim2reason.solutions.algebra.expressions import Expression, multiplied
from sim2reason.solutions.laws.dynamics import Dynamics
from sim2reason.solutions.laws.newton import Row
from sim2reason.solutions.setting import capital
from sim2reason.solutions.writing.unit_latex import NEWTONS

LIMIT = 1.0 + 1e-9


def verify_sticking(dynamics: Dynamics) -> None:
    """A step for each body that sticks where its law alone says which friction that takes; nothing rests on it."""
    mechanism, newton = dynamics.mechanism, dynamics.newton
    spoken = {mechanism.coordinates[row.number].body for group in dynamics.groups for row in group}
    for number, side in newton.rough.items():
        face = mechanism.faces[number]
        if side or isinf(face.friction) or not spoken & {face.subject, *_carriers(dynamics, face.subject)}:
            continue
        rows, _ = dynamics.laws([f"N{number}"])
        friction, normal = (_alone(dynamics, rows, f"{kind}{number}") for kind in "fN")
        if friction is not None and normal is not None:
            _tell(dynamics, number, friction, normal)


def _tell(dynamics: Dynamics, number: int, friction: Expression, normal: Expression) -> None:
    book, body = dynamics.book, dynamics.mechanism.faces[number].subject
    friction = friction if book.value(friction) >= 0.0 else -friction
    most = multiplied(dynamics.newton.coefficient(number).expression(), normal)
    if book.is_hidden(friction) or book.is_hidden(most) or book.value(friction) > LIMIT * book.value(most):
        return
    step, mark = book.open("verify"), dynamics.setting.mark(body)
    names = [book.fresh(base, mark) for base in ("f", r"f_{\text{max}}")]
    for name, held in zip(names, (friction, most), strict=True):
        book.observed[name.name] = book.value(held)
    said = [step.verified(n, held, NEWTONS) for n, held in zip(names, (friction, most), strict=True)]
    who = capital(dynamics.setting.called(body))
    step.say(
        f"{who} does not slip: the friction required, {said[0]}, is within the limit of static friction, {said[1]}."
    )
    step.close()


def _alone(dynamics: Dynamics, rows: list[Row], name: str) -> Expression | None:
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


def _carriers(dynamics: Dynamics, body: str) -> list[str]:
    found, step = list[str](), dynamics.mechanism.body[body].parent
    while step is not None:
        found.append(step)
        step = dynamics.mechanism.body[step].parent
    return found
