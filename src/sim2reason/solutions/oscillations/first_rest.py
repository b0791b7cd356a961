"""When an oscillation that begins with a speed first comes to rest, and that another is not at rest sooner."""

from math import pi

from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import PI, Call
from sim2reason.solutions.laws.turning_back import later_words
from sim2reason.solutions.oscillations.harmonic import Harmonic
from sim2reason.solutions.oscillations.linear_way import LinearWay
from sim2reason.solutions.setting import capital
from sim2reason.solutions.writing.comparing import exceeds
from sim2reason.solutions.writing.steps import Book
from sim2reason.solutions.writing.unit_latex import METRES, SECONDS


def told_first_rest(way: LinearWay, held: Harmonic, span: float, name: Symbol) -> Symbol:
    """Write when the velocity is first zero, `span` seconds after the start, and give back the `name` of that time."""
    book, rate, begun, rest = way.book, held.rate, held.begun, held.rest
    step, phase = book.open("time"), rate * name
    velocity = rest * rate * Call("sin", phase) + held.first.expression() * Call("cos", phase)
    who, law = way.who(held.motion.free[0]), step.law(velocity, ZERO)
    step.say(f"{capital(who)} first comes to rest when its velocity, the derivative of the displacement")
    step.say(f"${held.swinging(phase).latex()}$, is zero: {law}, so {step.derived(Call('tan', phase), begun / -rest)}.")
    early = held.numbers[0] * span < 0.5 * pi
    sign = f"{rest.latex()} {'<' if book.value(rest) < 0.0 else '>'} 0"
    between = f"${phase.latex()}$ is {'less' if early else 'greater'} than ${(Number(0.5) * PI).latex()}$"
    formula = held.angle_of_turning(span) / rate
    found = step.result(name, formula, SECONDS)
    if not book.is_hidden(rest):
        step.say(f"As ${sign}$, {between}, and {found}.")
    elif book.in_symbols:
        plain = "-" not in book.formulas.get(rest.latex(), rest).latex().removeprefix("-")  # all terms of one sign
        lead = "As" if plain else "For"
        step.say(f"{lead} ${sign}$, {between}, and {found}.")
    else:
        step.say(f"Assume that ${sign}$; then {between}, and {found}.")
        book.afterwards.append(lambda: _tell_sign(way, rest, sign, (phase, early)))
    step.close()
    return name


def tell_beyond(way: LinearWay, held: Harmonic, turning: Expression, place: Expression, *, later: bool) -> None:
    """Write that a body would come to rest only beyond a place, so that friction is constant; in symbols, assume it.

    It comes to rest for the first time, or `later`.
    """
    book, step, who = way.book, way.book.open("verify"), way.who(held.motion.free[0])
    there = held.name.latex() if place == held.name else f"{held.name.latex()} = {place.latex()}"
    when = "next" if later else "first"
    if book.in_symbols:
        step.say(f"Assume that {who} gets to ${there}$ before it {when} comes to rest.")
        step.close()
        return
    name = book.fresh("s", r"\text{turn}") if later else book.fresh("x", "1")
    far, near = (-part if book.value(part) < 0.0 else part for part in (turning, place))
    exceeds(book, step, far, near)
    told = step.verified(name, turning, METRES)
    step.say(f"{capital(who)} would {when} come to rest at {told}, beyond ${there}$,")
    step.say("so friction is constant until then.")
    step.close()


def _tell_sign(way: LinearWay, rest: Expression, sign: str, reached: tuple[Expression, bool]) -> None:
    """Write that the net force is zero on the side that was assumed, as the phase `reached` requires."""
    step, (phase, early), right = way.book.open("verify"), reached, Number(0.5) * PI
    greater, less = (ZERO, rest) if way.book.value(rest) < 0.0 else (rest, ZERO)
    exceeds(way.book, step, greater, less)
    exceeds(way.book, step, *((right, phase) if early else (phase, right)))
    wrong = f"${phase.latex()}$ would be {'greater' if early else 'less'} than ${right.latex()}$"
    step.say(f"Indeed ${sign}$, as was assumed; on the other side of ${rest.latex()} = 0$, {wrong}.")
    step.close()


def tell_rest_only_later(book: Book, formula: Expression, left: Symbol, half: Symbol | None, *, again: bool) -> None:
    """Write that half an oscillation, of a `formula` or a known symbol `half`, takes longer than the time `left`."""
    if book.in_symbols:
        return
    if book.is_hidden(formula) or book.is_hidden(left):
        book.afterwards.append(lambda: tell_rest_only_later(book, formula, left, half, again=again))
        return
    step = book.open("verify")
    exceeds(book, step, left, ZERO)
    if half is not None:
        exceeds(book, step, half, left)
        step.rest_on(half.name)
        step.say(
            f"As ${left.name} < {half.name}$, it does not come to rest{' again' if again else ''} within this time."
        )
    else:
        rest = "next" if again else "first"
        step.say(f"It would {rest} come to rest {later_words(book, step, formula, left)}.")
    step.close()
