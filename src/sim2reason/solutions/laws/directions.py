"""Directions of motion: checks that a body slides as assumed, or that it has turned back or has not."""

from collections.abc import Callable, Sequence
from math import isinf

from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Quotient, Symbol, multiply_factors, sum_terms
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.algebra.root_finding import substitute_all
from sim2reason.solutions.laws.dynamics import Dynamics
from sim2reason.solutions.laws.newton import Row
from sim2reason.solutions.laws.sticking import (
    carriers,
    force_from_one_law,
    limit_of_friction,
    required_friction,
    write_not_held,
)
from sim2reason.solutions.setting import capitalized, join_words
from sim2reason.solutions.writing.arrangement import SOLVE_KIND
from sim2reason.solutions.writing.notation import ACCELERATION, METRES, SECONDS, SPEED
from sim2reason.solutions.writing.steps import SolutionBuilder, StepBuilder, record_inequality


def earlier_turn_words(book: SolutionBuilder, step: StepBuilder, begun: Expression, a: Symbol, time: Symbol) -> str:
    """Return words such as *, before t*, added to a sentence about a velocity that becomes zero before a time."""
    formula = Quotient(-begun, a)
    record_inequality(book, step, time, formula)
    if book.is_hidden(formula):
        return f", before ${time.name}$"
    name = book.fresh("t", r"\text{turn}")
    return f", after {step.verified(name, formula, SECONDS)}, which is less than ${time.name}$"


def later_words(book: SolutionBuilder, step: StepBuilder, formula: Expression, time: Symbol) -> str:
    """Return *only after t_turn = ..., which is more than t*, for a time in s, and record the comparison."""
    record_inequality(book, step, formula, time)
    equation = step.verified(book.fresh("t", r"\text{turn}"), formula, SECONDS)
    return f"only after {equation}, which is more than ${time.name}$"


def write_later_turning(book: SolutionBuilder, begun: Expression, a: Symbol, time: Symbol | None) -> None:
    """Write that a decreasing velocity becomes zero only after a time, if the time is known."""
    formula = Quotient(-begun, a)
    if time is None or book.is_hidden(formula) or book.is_hidden(time) or not book.value(formula) > 0.0:
        return
    step = book.begin_step("verify")
    step.add_text(f"It would turn back {later_words(book, step, formula, time)}, so this is the distance.")
    step.close()


def write_first_passage(book: SolutionBuilder, begun: Expression, a: Symbol, time: Symbol, who: str) -> None:
    """Write that a body is at a place for the first time at a given time, as its velocity is still positive."""
    if book.in_symbols:
        return
    formula = sum_terms(begun, multiply_factors(a, time))
    step, name = book.begin_step("verify"), book.fresh("v")
    record_inequality(book, step, formula, ZERO)
    equation = step.verified(name, formula, SPEED)
    step.add_text(
        f"At ${time.name}$ the velocity is {equation} and still positive, so {who} is there for the first time."
    )
    step.close()


def verify_remaining(book: SolutionBuilder, left: Symbol, formula: Expression, until: str) -> None:
    """Schedule a check for the end of the text that earlier stages end before an instant; none for known numbers."""

    def write() -> None:
        step = book.begin_step("verify")
        record_inequality(book, step, left, ZERO)
        equation = step.verified(left, formula, SECONDS)
        step.add_text(f"Indeed {equation} is positive, so the earlier motion ends before ${until}$.")
        step.close()

    _in_the_end(book, left, write)


def verify_farther(book: SolutionBuilder, remaining: Polynomial, covers: tuple[Symbol, Polynomial], who: str) -> None:
    """Write, or schedule for the end of the text, that the earlier stages do not cover a whole distance.

    `remaining` is the remaining distance; `covers` has the distance and the displacement so far.
    """
    rest, (distance, displacement) = remaining.expression(), covers

    def write() -> None:
        step, name = book.begin_step("verify"), book.fresh("s", r"\text{rest}")
        left = book.magnitude(rest)
        record_inequality(book, step, left, ZERO)
        step.add_text(
            f"Indeed {step.verified(name, left, METRES)} is positive, so the distance is covered only after this."
        )
        step.close()

    _in_the_end(book, rest, write)
    covered = (
        displacement.expression()
        if book.value(displacement.expression()) > 0.0
        else displacement.scale(-1.0).expression()
    )
    if displacement and not book.in_symbols and not book.is_hidden(rest):
        step = book.begin_step("verify")
        record_inequality(book, step, distance, covered)
        step.add_text(
            f"As ${covered.latex()} < {distance.latex()}$, {who} covers the distance ${distance.latex()}$ only later."
        )
        step.close()


def _in_the_end(book: SolutionBuilder, quantity: Expression, write: Callable[[], None]) -> None:
    """Schedule a check for the end of the text if the quantity checked depends on the question's unknown."""
    if book.is_hidden(quantity) and not book.in_symbols:
        book.afterwards.append(write)


FORCES = frozenset({"tension", "normal force", "friction force", "impulse of a tension", "work of a tension"})
"""Quantities that, if given, determine an acceleration together with its sign."""
SLIP_SPEED_ATOL = 1e-9  # m/s: smaller initial velocities of slip count as zero


def rubs_at_rest(dynamics: Dynamics, face: int) -> bool:
    """Return whether slipping surfaces are still at relative rest, so that accelerations decide the direction."""
    rates = dynamics.segment.v
    slip = dynamics.mechanism.faces[face].slip
    return abs(sum(float(rates[dynamics.mechanism.number[name]]) * radius for name, radius in slip)) < SLIP_SPEED_ATOL


def directions_of_friction(dynamics: Dynamics, rows: Sequence[Row]) -> list[str]:
    """Return sentences that give the directions of the friction forces in the laws."""
    used = {name for row in rows for name in row.zero.names()}
    ways: dict[str, list[str]] = {}
    sticking: list[str] = []
    for face, side in dynamics.newton.slip_directions.items():
        body = dynamics.mechanism.faces[face].subject
        if side and dynamics.newton.single_slip_coordinate(face) is None:
            continue  # round bodies: written with the point of contact
        if side and f"N{face}" in used:
            ways.setdefault(slip_direction_text(dynamics, face, -side), []).append(body)
        elif f"f{face}" in used:
            (force,) = dynamics.names[f"f{face}"].names()
            direction = slip_direction_text(dynamics, face, 1 if dynamics.values[f"f{face}"] >= 0.0 else -1)
            who = dynamics.setting.display_name(body)
            if dynamics.book.in_symbols:  # either direction is possible
                sticking.append(f"The static friction ${force}$ on {who} is counted as positive {direction}.")
            else:
                sticking.append(f"Static friction ${force}$ acts on {who} {direction}.")
    phrases = [f"on {dynamics.setting.bodies_phrase(bodies)} {direction}" for direction, bodies in ways.items()]
    bodies = [body for some in ways.values() for body in some]
    stacked = any(body.parent in bodies for body in dynamics.mechanism.bodies)  # contacts on both faces
    begin = "From the surface beneath, friction" if stacked else "Friction"
    return [*([f"{begin} acts {join_words(phrases)}."] if phrases else []), *sticking]


def verify_sliding(dynamics: Dynamics) -> None:
    """Write for each body that starts to slide why it slides in the assumed direction.

    With unknown numbers it is written at the end; in symbolic problems the text states it.
    """
    book = dynamics.book
    if book.in_symbols:
        return
    if book.hidden:
        book.afterwards.append(lambda: _write_sliding_reason(dynamics))
    else:
        _write_sliding_reason(dynamics)


def _write_sliding_reason(dynamics: Dynamics) -> None:
    """Write why each body that starts to slide does: it needs too much friction, or accelerates despite friction."""
    law_bodies = {dynamics.mechanism.coordinates[row.number].body for group in dynamics.groups for row in group}
    moved: dict[Expression, list[int]] = {}
    for number, side in dynamics.newton.slip_directions.items():
        face = dynamics.mechanism.faces[number]
        if not side or isinf(face.friction) or face.subject not in law_bodies or not rubs_at_rest(dynamics, number):
            continue
        needed = required_friction(dynamics.newton, dynamics.setting, number)
        if needed is None and (relative := _relative(dynamics, number)) is not None:
            moved.setdefault(relative, []).append(number)
        elif needed is not None and not dynamics.segment.start:
            _tell_not_held(dynamics, number, needed)
    for relative, faces in moved.items():
        _tell_accelerated(dynamics, relative, faces)


def _tell_not_held(dynamics: Dynamics, face: int, needed: Expression) -> None:
    """Write that the friction needed to stick or roll exceeds its maximum; nothing if it only reaches the maximum."""
    book, newton = dynamics.book, dynamics.newton
    most = limit_of_friction(newton, face)
    if abs(book.value(needed)) > book.value(most):
        slips = newton.single_slip_coordinate(face) is None
        moves = "slips" if slips else f"slides {slip_direction_text(dynamics, face, newton.slip_directions[face])}"
        write_not_held(newton, dynamics.setting, book, face, needed, f", so it {moves}")


def _tell_accelerated(dynamics: Dynamics, relative: Expression, faces: Sequence[int]) -> None:
    """Write that bodies accelerate relative to the surface under them in spite of friction."""
    book, setting = dynamics.book, dynamics.setting
    if not {*relative.symbols()} <= book.values.keys() or book.value(relative) <= 0.0:
        return
    bodies = [dynamics.mechanism.faces[face].subject for face in faces]
    step, under = book.begin_step("verify"), carriers(dynamics, bodies[0])
    _tell_carriers(dynamics, step, faces[0])
    free = _without_friction(dynamics, relative) if isinstance(relative, Symbol) else None
    if free is not None and book.value(free) > 0.0:
        record_inequality(book, step, free, ZERO)
        text = step.verified(book.fresh("a", r"\text{free}"), free, ACCELERATION)
        step.add_text(f"Without friction the acceleration would be {text}, which is positive; friction can only")
        step.add_text(f"reduce it, so {join_words(_slides(dynamics, faces))}.")
        step.close()
        return
    record_inequality(book, step, relative, ZERO)
    if isinstance(relative, Symbol):
        text = f"the acceleration ${relative.latex()}$"
    else:
        own = None if under else _unvalued(dynamics, faces[0])
        name = own or book.fresh("a", r"\text{rel}" if under else setting.subscript_of(bodies[0]))
        text = f"the {'relative ' if under else ''}acceleration {step.verified(name, relative, ACCELERATION)}"
    step.add_text(f"Even against friction {text} is positive, so {join_words(_slides(dynamics, faces))}.")
    step.close()


def _without_friction(dynamics: Dynamics, acceleration: Symbol) -> Expression | None:
    """Return the acceleration without friction if that with friction follows from a given speed or time; else None.

    Such an acceleration is positive for either direction of motion, so it does not prove the direction.
    """
    book, formula = dynamics.book, dynamics.book.formulas.get(acceleration.name)
    solved = any(step.kind == SOLVE_KIND and acceleration.name in step.gives for step in book.steps)
    target = dynamics.setting.target
    if formula is None or not solved or len(dynamics.shared) != 1 or (target and target.quantity in FORCES):
        return None
    if any(isinf(dynamics.mechanism.faces[face].friction) for face in dynamics.newton.slip_directions):
        return None  # an unlimited constraint may also act along the motion
    others = {name: book.formulas[name] for name in reversed(book.formulas) if name != acceleration.name}
    formula = substitute_all(formula, others)
    coefficients = (dynamics.newton.coefficient(face) for face in dynamics.newton.slip_directions)
    return substitute_all(formula, {name: ZERO for coefficient in coefficients for name in coefficient.names()})


def _unvalued(dynamics: Dynamics, face: int) -> Symbol | None:
    """Return the symbol of a slip acceleration that a string binds to another acceleration; else None."""
    slips = [*dynamics.newton.slip(face).items()]
    if len(slips) != 1:
        return None
    ((k, factor),) = slips
    signed_factor = factor.scale(dynamics.newton.slip_directions[face])
    acceleration = (signed_factor * dynamics.names.get(f"q{k}", NIL)).expression()
    return acceleration if isinstance(acceleration, Symbol) and acceleration.name in dynamics.bound else None


def _slides(dynamics: Dynamics, faces: Sequence[int]) -> list[str]:
    """Return phrases with the sliding bodies and the directions in which these bodies slide."""
    ways: dict[tuple[str, str], list[str]] = {}
    for face in faces:
        body = dynamics.mechanism.faces[face].subject
        direction = slip_direction_text(dynamics, face, dynamics.newton.slip_directions[face])
        under = carriers(dynamics, body)
        on = f" on {dynamics.setting.display_name(under[0])}" if under else ""
        ways.setdefault((direction, on), []).append(body)
    called = dynamics.setting.bodies_phrase
    return [f"{called(who)} {'slides' if len(who) == 1 else 'slide'} {way}{on}" for (way, on), who in ways.items()]


def slip_direction_text(dynamics: Dynamics, face: int, sense: float) -> str:
    """Return the words for the direction in which a body slides at a contact."""
    slides = sliding_coordinates(dynamics.mechanism, face)
    return dynamics.moving(slides[0][0], 1 if sense * slides[0][1] > 0.0 else -1) if slides else ""


def _relative(dynamics: Dynamics, face: int) -> Expression | None:
    """Return the acceleration of slip at a contact, in its direction; None if it is unknown."""
    parts = _parts(dynamics, face)
    total: Expression = ZERO
    for _, factor, acceleration in parts or []:
        total = sum_terms(
            total, multiply_factors(factor.expression(), acceleration) if factor.number != 1.0 else acceleration
        )
    return total if parts is not None else None


def _parts(dynamics: Dynamics, face: int) -> list[tuple[int, Polynomial, Expression]] | None:
    """Return the coordinates that contribute to slip, with factors and accelerations; None if one is unknown."""
    rows, parts = _laws(dynamics), list[tuple[int, Polynomial, Expression]]()
    for k, part in dynamics.newton.slip(face).items():
        terms = [(k, 1.0)]
        if k in dynamics.carrier_coordinates:
            j, sign = dynamics.carrier_coordinates[k]
            terms.append((j, -sign))
        for n, factor in terms:
            if n in dynamics.frozen:
                continue
            acceleration = force_from_one_law(dynamics, rows, f"q{n}")
            if acceleration is None:
                return None
            parts.append((n, part.scale(factor * dynamics.newton.slip_directions[face]), acceleration))
    return parts


def _tell_carriers(dynamics: Dynamics, step: StepBuilder, face: int) -> None:
    """Write the accelerations of the bodies that carry a sliding body, unless they have names already."""
    book, parts = dynamics.book, _parts(dynamics, face) or []
    own = dynamics.mechanism.faces[face].subject
    for n, _, acceleration in parts if len(parts) > 1 else []:
        body = dynamics.mechanism.coordinates[n].body
        size = -acceleration if acceleration.negative else acceleration
        if body == own or not book.value(acceleration) or isinstance(size, Symbol):
            continue
        sense = 1 if book.value(acceleration) > 0.0 else -1
        name = book.fresh("a", dynamics.setting.subscript_of(body))
        equation = step.verified(name, acceleration if sense > 0 else -acceleration, ACCELERATION)
        step.add_text(f"{capitalized(dynamics.setting.display_name(body))} then has the acceleration {equation}")
        step.add_text(f"{dynamics.moving(n, sense)}.")


def _laws(dynamics: Dynamics) -> list[Row]:
    """Return all laws, with the normal forces due to weights alone substituted."""
    rows, _ = dynamics.laws([])
    pressed: dict[str, Polynomial] = {}
    for row in rows:
        name = f"N{row.number}"
        if row.kind == "normal" and not row.inertia:
            pressed[name] = row.forces.terms_without((name,)).scale(-1.0)
    return [Row(r.kind, r.number, r.forces.substitute(pressed), r.inertia) for r in rows if r.kind != "normal"]


def sliding_coordinates(m: Mechanism, face: int) -> list[tuple[int, float]]:
    """Return the coordinates along which a body slides at a contact, with their factors in the slip velocity."""
    pairs = [(m.number[name], factor) for name, factor in m.faces[face].slip]
    return [(k, factor) for k, factor in pairs if m.coordinates[k].kind == "slide"]
