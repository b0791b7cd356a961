"""The initial direction of an oscillation from rest, and verification that its strings stay taut."""

from sim2reason.solutions.algebra.expressions import ZERO, Symbol
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.laws.newton import Row
from sim2reason.solutions.oscillations.linear_motion import LinearMotion
from sim2reason.solutions.oscillations.linear_way import LinearWay
from sim2reason.solutions.oscillations.relative_motion import RelativeMotion
from sim2reason.solutions.setting import capital
from sim2reason.solutions.writing.comparing import exceeds
from sim2reason.solutions.writing.steps import Writing
from sim2reason.solutions.writing.unit_latex import ACCELERATION, NEWTONS


def tell_first_move(way: LinearWay, motion: LinearMotion | RelativeMotion) -> None:
    """State the initial direction of a motion from rest without friction, by the net force at the start."""
    (i,), book = motion.free, way.book
    if isinstance(motion, RelativeMotion) or any(motion.laws.rough.values()) or way.first(i):
        return
    load, who = motion.load(i), way.who(i)
    forward = load.value(motion.givens) > 0.0
    size, towards = (load if forward else load.scaled(-1.0)).factored(), way.towards(i, forward=forward)
    step = book.open("verify")
    if book.is_hidden(size):
        step.say(f"{capital(who)} first moves {towards}.")
    else:
        net = book.fresh("F", "0")
        book.know(net.name, book.value(size))
        told = step.verified(net, size, NEWTONS)
        step.say(f"The net force along the motion at the start, {told}, sets {who} in motion {towards}.")
        _tell_taut(way, motion, step, net)
    step.close()


def _tell_taut(way: LinearWay, motion: LinearMotion, step: Writing, net: Symbol) -> None:
    """Verify that strings stay taut: find the least tension from the law of one body at the greatest acceleration."""
    held = [(line, row) for line in range(len(motion.laws.lines)) if (row := _law(motion, line)) is not None]
    (i,), book = motion.free, way.book
    mass = motion.mass(i, i).factored()
    if not held or book.is_hidden(mass):
        return
    most = book.fresh("a", r"\text{max}")
    book.know(most.name, book.value(net / mass))
    least = {line: _least(motion, line, row, most) for line, row in held}
    if any(book.is_hidden(tension.expression()) for tension in least.values()):
        return
    told = step.verified(most, net / mass, ACCELERATION)
    step.say(f"The acceleration is greatest at the turning points, {told}.")
    for line, row in held:
        tension = least[line].factored()
        if book.value(tension) <= 0.0:
            continue
        name = book.fresh("T", r"\text{min}")
        book.know(name.name, book.value(tension))
        exceeds(book, step, tension, ZERO)
        body = way.setting.called(motion.mechanism.coordinates[row.number].body)
        told = step.verified(name, tension, NEWTONS)
        step.say(f"So the tension of the string that pulls {body} is at least {told}, and it stays taut.")


def _law(motion: LinearMotion, line: int) -> Row | None:
    """Return Newton's law of a body with a weight on which one taut string acts alone."""
    for k in motion.ratios:
        row = motion.laws.newton(k)
        names = {name for name in row.zero.names() if name[0] in "TNSf" and name[1:].isdigit()}
        if names == {f"T{line}"} and motion.ratios[k] and row.forces.without(names):
            return row
    return None


def _least(motion: LinearMotion, line: int, row: Row, most: Symbol) -> Polynomial:
    """Return the smallest tension that this law gives with accelerations up to `most` of what is free."""
    found: list[Polynomial] = []
    for sign in (1.0, -1.0):
        known = {f"q{k}": Polynomial.of(most).scaled(sign * motion.ratio(k, motion.free[0])) for k in motion.ratios}
        bound = (row.forces - row.inertia).put(known)
        part = bound.coefficient(f"T{line}").number or 1.0
        found.append(bound.without((f"T{line}",)).scaled(-1.0 / part))
    return min(found, key=lambda held: held.value(motion.givens | {most.name: 1e-6}))
