"""Oblique collisions of discs in a plane, and checks of the side of its start on which a body is."""

from collections.abc import Sequence

from sim2reason.scenes.dsl.vectors import dot, subtract_triples
from sim2reason.solutions.algebra.expressions import (
    ZERO,
    Expression,
    Number,
    Symbol,
    multiply_factors,
    ratio,
    sum_terms,
)
from sim2reason.solutions.algebra.functions import Power, Root, sum_formulas, sum_of_squares
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.collisions.flights import Impact
from sim2reason.solutions.collisions.impacts import Impacts
from sim2reason.solutions.setting import capitalized, join_words
from sim2reason.solutions.writing.lexicon import DualValue
from sim2reason.solutions.writing.notation import IMPULSE, METRES, SECONDS, SPEED, latex
from sim2reason.solutions.writing.steps import StepBuilder, record_inequality

RESTITUTION = "Conservation of momentum and restitution along this line"
INELASTIC = "Conservation of momentum, and no relative velocity along this line after the inelastic collision,"


class Flights(Impacts):
    """The free flights of all bodies and their collisions, those of discs included."""

    def discs_meet(self, impact: Impact) -> Symbol:
        """Return the time at which the distance of the centres equals the sum of the radii."""
        return _meet(self, impact)

    def approach(self, impact: Impact) -> tuple[dict[str, Symbol], Symbol]:
        """Write once, and return, the unit vector along the line of centres, by axis, and the approach velocity."""
        if impact.number not in self.approaches:
            self.approaches[impact.number] = _approach(self, impact)
        return self.approaches[impact.number]

    def closing(self, impact: Impact) -> Expression:
        """Return the signed relative velocity along the normal just before a collision."""
        if self.mechanism.meetings[impact.meeting].normal is None:
            return self.approach(impact)[1]
        return super().closing(impact)

    def discs_part(self, impact: Impact) -> dict[int, Polynomial]:
        """Return the velocities after a collision of discs, m/s, by coordinate."""
        return _part(self, impact)


def _meet(flights: Impacts, impact: Impact) -> Symbol:
    """Write when discs at relative position X and velocity u touch: (u² t + X·u)² + (X×u)² = u² d²."""
    X, u, since, _ = _relative(flights, impact)
    if (axis := _only_axis(u)) is not None:
        return _meet_along(flights, impact, axis)
    book, distance = flights.book, _distance(flights, impact)
    step, t = book.begin_step("impact time"), book.fresh("t")
    squared_distance: Expression = ZERO
    for x, w in zip(X, u, strict=True):
        squared_distance = sum_terms(squared_distance, Power(sum_terms(x, multiply_factors(w, t)), 2))
    law = step.derived(squared_distance, Power(distance, 2))
    speeds = sum_of_squares(u)
    along = sum_formulas(multiply_factors(x, w) for x, w in zip(X, u, strict=True))
    pair = flights.pair_mark(impact.bodies, flights.latest(impact)[1])
    p, q = book.fresh("p", pair), book.fresh("q", pair)
    definitions = [
        step.result(p, speeds, latex("m^2/s^2"), law=True),
        step.result(q, along, latex("m^2/s"), law=True),
    ]
    aside: Expression = ZERO
    if len(X) > 1:  # |X|² |u|² = (X·u)² + (X×u)²: q² − p |X|² would lose digits in a grazing collision
        c = book.fresh("c", pair)
        definitions.append(step.result(c, X[0] * u[1] - X[1] * u[0], latex("m^2/s"), law=True))
        aside = Power(c, 2)
    square = multiply_factors(p, Power(distance, 2))
    quadratic = step.law(sum_terms(Power(sum_terms(multiply_factors(p, t), q), 2), aside), square)
    formula = ratio(sum_terms(-q, -Root(sum_terms(square, -aside))), p)
    step.add_text(
        f"{flights.collision_clause(impact)} when {law}. With {join_words(definitions)}, "
        f"this multiplied by ${p.latex()}$ is {quadratic}."
    )
    step.add_text(f"The earlier root is {step.result(t, formula, SECONDS)}{flights.counted_from(impact, since)}.")
    step.close()
    return flights.time_since_start(since, t)


def _meet_along(flights: Impacts, impact: Impact, axis: int) -> Symbol:
    """Write the time at which discs touch whose relative velocity is along one axis: x + u t = ±√(d² − y²)."""
    X, u, since, labels = _relative(flights, impact)
    book, distance = flights.book, _distance(flights, impact)
    step, t = book.begin_step("impact time"), book.fresh("t")
    x = book.fresh(labels[axis], flights.pair_mark(impact.bodies, flights.latest(impact)[1]))
    known = step.result(x, X[axis], METRES, law=True)
    reach: Expression = distance
    if len(X) > 1 and X[1 - axis] != ZERO:
        reach = Root(sum_terms(Power(distance, 2), -Power(X[1 - axis], 2)))
    moved = sum_terms(x, multiply_factors(u[axis], t))
    law = step.law(sum_of_squares((moved, *X[:axis], *X[axis + 1 :])), Power(distance, 2))
    formula = ratio(sum_terms(_ahead(flights, u[axis], reach), -x), u[axis])
    who = flights.setting.bodies_phrase(list(impact.bodies))
    step.add_text(f"The relative velocity is along the {labels[axis]} axis. With {known}, {who} meet when {law}.")
    step.add_text(f"The earlier root is {step.result(t, formula, SECONDS)}{flights.counted_from(impact, since)}.")
    step.close()
    return flights.time_since_start(since, t)


def _only_axis(u: Sequence[Expression]) -> int | None:
    """Return the index of the only axis with relative velocity; None if there are several."""
    moving = [number for number, w in enumerate(u) if w != ZERO]
    return moving[0] if len(moving) == 1 else None


def _ahead(flights: Impacts, velocity: Expression, size: Expression) -> Expression:
    """Return a magnitude with the sign opposite to that of a relative velocity, as a formula."""
    return size if flights.book.value(velocity) < 0.0 else -size


def _distance(flights: Impacts, impact: Impact) -> Expression:
    """Return the sum of the radii of two discs."""
    return flights.setting.lexicon.formula_for(lambda m: m.meetings[impact.meeting].distance).expression()


def _relative(flights: Impacts, impact: Impact) -> tuple[list[Expression], list[Expression], Symbol | None, list[str]]:
    """Return a pair's relative position and velocity at the start of the later flight, that time and the axes."""
    if impact.number in flights.relative:
        return flights.relative[impact.number]
    legs, latest = flights.latest(impact)
    since = flights.collision_time(latest) if latest is not None else None
    one, other = impact.bodies
    lexicon = flights.setting.lexicon
    places = [subtract_triples(f.center(other).place, f.center(one).place) for f in flights.frames]
    components: list[tuple[str, Polynomial, Polynomial]] = []
    for i, j in zip(flights.coordinates(one), flights.coordinates(other), strict=True):
        axes = lexicon.mechanism.coordinates[i].axis, lexicon.twin.coordinates[i].axis
        along = [float(dot(separation, axis)) for separation, axis in zip(places, axes, strict=True)]
        separation = lexicon.read(DualValue(*along))
        separation = (
            separation
            + flights.displacement(other, legs[other], j, since)
            - flights.displacement(one, legs[one], i, since)
        )
        w = flights.velocity(other, legs[other], j, since) - flights.velocity(one, legs[one], i, since)
        if flights.acceleration(i) - flights.acceleration(j):
            raise ValueError("discs that are accelerated differently")
        if separation or w:  # axes without relative position and velocity are omitted
            components.append((flights.mechanism.coordinates[i].label, separation, w))
    step = flights.book.begin_step("relative")
    if any(flights.acceleration(i) for i in flights.coordinates(one)):
        who = capitalized(flights.setting.bodies_phrase([body.name for body in flights.mechanism.bodies if body.mass]))
        step.add_text(
            f"{who} have the same acceleration, so their relative velocities are constant between collisions."
        )
    X, u, definitions = _named(flights, step, components, flights.pair_mark(impact.bodies, latest))
    labels = [label for label, *_ in components]
    who = [flights.setting.display_name(body) for body in impact.bodies]
    when = f"just after {flights.collision(latest)}" if latest is not None else "at t = 0"
    what = "Position and velocity" if any(x != ZERO for x in X) else "Velocity"
    step.add_text(f"{what} of {who[1]} relative to {who[0]} {when}: {join_words(definitions)}.")
    step.close()
    flights.relative[impact.number] = (X, u, since, labels)
    return X, u, since, labels


def _named(
    flights: Impacts, step: StepBuilder, components: Sequence[tuple[str, Polynomial, Polynomial]], pair: str
) -> tuple[list[Expression], list[Expression], list[str]]:
    """Return names of nonzero relative coordinates and velocities, with the equations that define them.

    The coordinate along the only axis of the relative velocity gets no name: only the collision time depends on it.
    """
    X, u, definitions = list[Expression](), list[Expression](), list[str]()
    along = _only_axis([w.expression() for _, _, w in components])
    for number, (label, separation, w) in enumerate(components):
        for base, index, part, unit, known in (
            (label, pair, separation, METRES, X),
            ("u", f"{label},{pair}", w, SPEED, u),
        ):
            known.append(part.expression())
            if part and not (number == along and known is X):
                name = flights.book.fresh(base, index)
                definitions.append(step.result(name, known[-1], unit, law=True))
                known[-1] = name
    return X, u, definitions


def _approach(flights: Impacts, impact: Impact) -> tuple[dict[str, Symbol], Symbol]:
    """Write the unit vector along the line of centres, by axis, and the negative relative velocity along it."""
    book, number = flights.book, flights.collision_number(impact)
    _, u, _, labels = _relative(flights, impact)
    parts, when = _normal(flights, impact)
    step = book.begin_step("normal")
    n = {label: book.fresh("n", ",".join(part for part in (label, number) if part)) for label in labels}
    across = [label for label, w in zip(labels, u, strict=True) if w == ZERO]
    components = {label: part for label, part in zip(labels, parts, strict=True) if label not in across}
    step.add_text(
        f"{when} {join_words([step.result(n[label], part, '', law=True) for label, part in components.items()])}."
    )
    approach = book.fresh("u", r"\text{n}" + (f",{number}" if number else ""))
    along = sum_formulas(multiply_factors(w, m) for w, m in zip(u, n.values(), strict=True))
    step.add_text(f"The relative velocity along the line is {step.result(approach, along, SPEED, law=True)}.")
    step.close()
    for label in across:  # needed only for velocities after the collision
        name, part = n[label], parts[labels.index(label)]
        book.add_step("normal", f"The {label} component of the unit vector is", name, part)
    return n, approach


def _normal(flights: Impacts, impact: Impact) -> tuple[list[Expression], str]:
    """Return the components of the unit vector along the line of centres, and the words before them.

    If the relative velocity is along one axis, no time is needed: the offset y gives sin φ = y/d.
    """
    X, u, since, labels = _relative(flights, impact)
    distance, axis = _distance(flights, impact), _only_axis(u)
    if axis is not None and len(X) > 1:
        aside = ratio(X[1 - axis], distance)
        parts = [aside, aside]
        parts[axis] = _ahead(flights, u[axis], Root(sum_terms(Number(1.0), -Power(aside, 2))))
        other = X[1 - axis].latex()
        known = f"The relative velocity is along the {labels[axis]} axis, so ${other}$ does not change. "
        vector = f"the unit vector along the line of centres has the {labels[axis]} component"
        return parts, f"{known}At {flights.collision(impact)} {vector}"
    time = flights.collision_time(impact)
    span = time if since is None else flights.time_between(since, time)
    parts = [ratio(sum_terms(x, multiply_factors(w, span)), distance) for x, w in zip(X, u, strict=True)]
    return parts, "The unit vector along the line of centres is then"


def _part(flights: Flights, impact: Impact) -> dict[int, Polynomial]:
    """Write the velocities just after a collision: each changes only along the line of centres."""
    book, (n, approach) = flights.book, flights.approach(impact)
    one, other = impact.bodies
    m, k = (flights.mass(body).expression() for body in impact.bodies)
    e = flights.restitution(impact.meeting).expression()
    step, push = book.begin_step("impulse"), book.fresh("J", flights.collision_number(impact))
    reduced = ratio(multiply_factors(m, k), sum_terms(m, k))
    formula = -multiply_factors(multiply_factors(sum_terms(Number(1.0), e), reduced), approach)
    lead = f"{RESTITUTION if flights.restitution(impact.meeting) else INELASTIC} give the impulse"
    step.add_text(f"{lead} {step.result(push, formula, IMPULSE, law=True)}.")
    step.close()
    velocities = {i: flights.just_before(impact, body, i) for body in impact.bodies for i in flights.coordinates(body)}
    for body, mass, sign in ((one, m, -1.0), (other, k, 1.0)):
        for number in flights.coordinates(body):
            before, label = velocities[number], flights.mechanism.coordinates[number].label
            if label not in n:
                continue
            step, name = book.begin_step("after"), book.name_after_impact("v", flights.motion_subscript(body, number))
            change = multiply_factors(Number(sign), multiply_factors(ratio(push, mass), n[label]))
            formula = sum_terms(before.expression(), change)
            step.add_text(f"After the impact, {step.result(name, formula, SPEED, law=True)}.")
            step.close()
            velocities[number] = Polynomial.from_expression(name)
    return velocities


def write_nearer_side(flights: Flights, body: str, k: int, distance: Symbol) -> None:
    """Write that a body stays within a distance of its start until its last flight, and its direction after that.

    With unknown numbers it is written at the end; a symbolic problem assumes it.
    """
    book, number = flights.book, flights.count(body, None)
    ends = [flights.displacement(body, n, k, None).expression() for n in range(1, number + 1)]
    speed = flights.flight_of_body(body, number).speeds[k].expression()
    if book.in_symbols:
        return
    if any(map(book.is_hidden, (*ends, speed, distance))):
        book.afterwards.append(lambda: _write_distance_limit(flights, body, k, distance, (ends, speed)))
    else:
        _write_distance_limit(flights, body, k, distance, (ends, speed))


def _write_distance_limit(
    flights: Flights, body: str, k: int, distance: Symbol, motion: tuple[list[Expression], Expression]
) -> None:
    """Write that a body stays within a distance of its start until its last flight, and its direction then."""
    book, (ends, speed), leg = flights.book, motion, flights.flight_of_body(body, flights.count(body, None))
    assert leg.after is not None
    sizes = [-end if book.value(end) < 0.0 else end for end in ends if end != ZERO]
    farthest = max(sizes, key=book.value, default=ZERO)
    step, who, forward = book.begin_step("verify"), flights.setting.display_name(body), book.value(speed) > 0.0
    if farthest != ZERO:
        record_inequality(book, step, distance, farthest)
    record_inequality(book, step, *((speed, ZERO) if forward else (ZERO, speed)))
    x, y, z = flights.mechanism.coordinates[k].axis
    towards = flights.setting.direction_words((x, y, z) if forward else (-x, -y, -z))
    step.add_text(
        f"Until {flights.collision(leg.after)}, {who} is never as far as ${distance.latex()}$ from its start;"
    )
    alone = len(flights.mechanism.meetings) == 1 and flights.restitution(leg.after.meeting)
    parted = " The two do not meet again, as they move apart." if alone else ""
    step.add_text(f"then it moves {towards}.{parted}")
    step.close()
