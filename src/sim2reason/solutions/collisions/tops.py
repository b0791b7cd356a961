"""The top of the path of a body in free flight, or where it is at rest: extreme values there, and how far it is."""

from dataclasses import replace

from sim2reason.questions import KINDS, Query
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.functionals.parts.extreme import Extreme
from sim2reason.questions.kinds.parts.stretch_kind import StretchQuery
from sim2reason.questions.moments.turning_points import HighestPoint
from sim2reason.questions.targets import Target
from sim2reason.solutions.algebra.expressions import ZERO, Number, added, multiplied, ratio
from sim2reason.solutions.algebra.functions import Power
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.collisions.flights import ALIGNED
from sim2reason.solutions.collisions.impacts import Impacts
from sim2reason.solutions.setting import Setting, capital
from sim2reason.solutions.writing.comparing import exceeds
from sim2reason.solutions.writing.unit_latex import METRES

AT_TOP = frozenset({"greatest height", "least speed"})
SAME = 1e-6  # relative: the value at the top is the extreme one


def at_top(setting: Setting) -> Setting | None:
    """Return the question about the value at the top of the path; None if that is not the extreme value asked for."""
    query, study = setting.query, setting.study
    if not isinstance(query, StretchQuery) or query.functional not in AT_TOP:
        return None
    functional, moment = FUNCTIONALS[query.functional], HighestPoint(query.name)
    assert isinstance(functional, Extreme)
    asked = Query("event", Target(functional.quantity.name, query.name, functional.sense), moment)
    time = study.time(moment)
    if time is None or time > setting.time:
        return None
    value, extreme = KINDS["event"].answer(asked, study), KINDS[query.kind].answer(query, study)
    if value is None or extreme is None or abs(value - extreme) > SAME * abs(extreme):
        return None
    return replace(setting, query=asked)


def tell_top(flights: Impacts, body: str) -> None:
    """Write which velocity is zero at the highest point of the path of a body."""
    falls = [k for k in flights.coordinates(body) if flights.acceleration(k)]
    step, book, leg = flights.book.open("moment"), flights.book, flights.leg(body, flights.count(body, None))
    zero = f"at the highest point of the path the {_velocity(flights, body, falls[0]) if falls else 'velocity'} is zero"
    if falls and leg.after is not None and not book.in_symbols:
        rising = leg.speeds[falls[0]].expression()
        if not book.is_hidden(rising):
            exceeds(book, step, rising, ZERO)
        zero = f"after {flights.collision(leg.after)}, {flights.setting.called(body)} still rises; {zero}"
    step.say(f"{capital(zero)}.")
    step.close()


def height_at_rest(flights: Impacts, body: str, k: int, *, top: bool) -> Polynomial:
    """Write how far a body has come along a coordinate where it turns back: v² = 2 a s, without the time."""
    number, a = flights.count(body, None), flights.acceleration(k)
    leg = flights.leg(body, number)
    before, v = flights.place(body, number, k, None), leg.speeds[k].expression()
    step, name = flights.book.open("distance"), flights.book.fresh("s", flights.setting.mark(body))
    double = multiplied(Number(2.0), a.expression())
    law = step.law(added(Power(v, 2), multiplied(double, name)), ZERO)
    formula = ratio(-Power(v, 2), double)
    where = "At the highest point of the path" if top else "There"
    zero = f"{where} the {_velocity(flights, body, k)} is zero"
    if leg.after is not None:
        zero = f"{zero}. Let ${name.name}$ be its displacement in this direction since {flights.collision(leg.after)}"
    step.say(f"{zero}{'; then' if leg.after is not None else ', so'} {law} and {step.result(name, formula, METRES)}.")
    step.close()
    return before + Polynomial.of(name)


def _velocity(flights: Impacts, body: str, k: int) -> str:
    """Return which velocity a coordinate has, in words."""
    coordinate, who = flights.mechanism.coordinates[k], flights.setting.called(body)
    if coordinate.axis[2] > 1.0 - ALIGNED:
        return f"vertical velocity of {who}"
    plane = len(flights.mechanism.body[body].coordinates) > 1
    return f"velocity of {who} along {coordinate.label}" if plane else f"velocity of {who}"
