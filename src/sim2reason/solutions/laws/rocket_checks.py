"""Numerical checks of a rocket's position, and proofs that alternative motions are impossible."""

from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol, ratio
from sim2reason.solutions.algebra.functions import Call, Power
from sim2reason.solutions.laws.rocket import Burning
from sim2reason.solutions.writing.comparing import record_inequality
from sim2reason.solutions.writing.unit_latex import KILOGRAMS, METRES

HALF = Number(0.5)


def tell_in_the_air(rocket: Burning, velocity: Symbol, risen: Expression) -> None:
    """Write that a falling rocket with its engine off is still in the air, or that it cannot be falling.

    The latter is written if the empty mass is unknown: with that velocity, the rocket would never have lifted off.
    """
    book, u, g = rocket.book, rocket.exhaust, rocket.gravity.expression()
    if book.value(velocity) > 0.0:
        _exclude_falling(rocket, velocity, risen)
        return
    log, burning = Call("ln", ratio(rocket.full, rocket.dry)), (rocket.full - rocket.dry) / rocket.rate_of_burning
    height = (
        u * log * risen - u * (rocket.full / rocket.rate_of_burning) * log + u * burning - HALF * g * Power(risen, 2)
    )
    step, name = book.begin_step("verify"), book.fresh("h")
    record_inequality(book, step, height, ZERO)
    told = step.verified(name, height, METRES)
    step.add_text(
        f"{rocket.who} is falling then, but it is still in the air: by integration of its velocity, its height is"
    )
    step.add_text(f"{told}.")
    step.close()


def _exclude_falling(rocket: Burning, velocity: Symbol, risen: Expression) -> None:
    """Write that a rocket cannot have turned back."""
    book, dry, g = rocket.book, rocket.dry, rocket.gravity.expression()
    if not isinstance(dry, Symbol) or book.sought != dry.name or velocity.name not in book.stated:
        return
    would = rocket.full / Call("exp", (g * risen - velocity) / rocket.exhaust)
    if book.value(would) <= book.value(rocket.full):
        return
    step, name = book.begin_step("verify"), book.fresh(dry.name, r"\text{down}")
    record_inequality(book, step, would, rocket.full)
    told = step.verified(name, would, KILOGRAMS)
    step.add_text(f"If {rocket.name} moved down at this speed, its empty mass would be {told}, more than the mass")
    step.add_text(f"${rocket.full.latex()}$ at which it begins to rise.")
    step.close()


def exclude_burning(rocket: Burning, time: Symbol) -> None:
    """Write that a rocket with its engine still on would not be at the given distance.

    It applies to an unknown burning rate; the distance increases with this rate.
    """
    book, rate, query = rocket.book, rocket.rate_of_burning, rocket.query
    far = next((name for name, unit in book.units.items() if name in book.stated and unit == METRES), "")
    target = query.target.quantity if query.target is not None else ""
    unknown = isinstance(rate, Symbol) and book.sought == rate.name
    if not unknown or rocket.waits or not far or target not in ("displacement", "distance from start"):
        return
    log, fuel = Call("ln", ratio(rocket.first, rocket.dry)), rocket.first - rocket.dry
    most = rocket.exhaust * time - rocket.exhaust * rocket.dry * time / fuel * log
    if rocket.gravity:
        most = most - HALF * rocket.gravity.expression() * Power(time, 2)
    if book.value(most) >= book.values[far]:
        return
    step, name = book.begin_step("verify"), book.fresh("s", r"\text{max}")
    record_inequality(book, step, Symbol(far), most)
    told = step.verified(name, most, METRES)
    step.add_text(f"If the engine were still on at ${time.latex()}$, ${rate.latex()}$ would be at most")
    step.add_text(f"${(fuel / time).latex()}$, and {rocket.name} at most {told} from its start, less than ${far}$.")
    step.close()
