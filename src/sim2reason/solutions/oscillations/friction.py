"""Positions of greatest speed, kinetic friction, and comparisons with static friction at turning points."""

from collections.abc import Sequence

from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.strings import NaturalLength
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.algebra.fractions import reduced_quotient
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.laws.directions import sliding_coordinates
from sim2reason.solutions.laws.sticking import friction_formulas
from sim2reason.solutions.oscillations.harmonic import HarmonicOscillation
from sim2reason.solutions.oscillations.linear_motion import LinearMotion
from sim2reason.solutions.oscillations.linear_way import LinearMotionModel
from sim2reason.solutions.oscillations.net_force import collect_stiffness, without_friction
from sim2reason.solutions.oscillations.single_way import OneCoordinateModel
from sim2reason.solutions.setting import ProblemContext, capitalized, join_words
from sim2reason.solutions.writing.notation import METRES, NEWTONS
from sim2reason.solutions.writing.steps import UnsolvedError, record_inequality

REST_TOLERANCE = 1e-6  # relative tolerance of times, and tolerance of positions in m


def continues_after_rest(setting: ProblemContext) -> bool:
    """Return whether the motion, by the engine, continues after it first comes to rest."""
    return any(0.0 < segment.start < setting.time * (1.0 - REST_TOLERANCE) for segment in setting.motion.segments)


def write_fastest_position(model: OneCoordinateModel, seen: float) -> Symbol:
    """Write the position of zero net force, m; UnsolvedError unless it is the position `seen` of greatest speed."""
    motion, name = model.motion, model.name
    (i,) = motion.free
    stiffness, load = motion.stiffness(i, i), motion.load(i)
    if not stiffness:
        raise UnsolvedError("it never is in balance")
    there = load.value(motion.givens) / stiffness.value(motion.givens)
    if abs(there - seen) > 1e-3 * max(abs(there), abs(seen), REST_TOLERANCE):
        raise UnsolvedError("the greatest value is not where forces balance")
    if not load:
        raise UnsolvedError("it begins in balance")
    step = model.book.begin_step("balance")
    gathered = collect_stiffness(load, stiffness)
    law = step.law(stiffness.expression() * name, gathered)
    if isinstance(motion, LinearMotion) and motion.friction(i) and continues_after_rest(model.setting):
        step.add_text(
            f"Friction makes each swing smaller than the one before, so {model.mover} is fastest in the first."
        )
    formula = reduced_quotient(load, stiffness) if gathered == load.expression() else gathered / stiffness.expression()
    step.add_text(f"The kinetic energy is greatest where the net force is zero: {law},")
    step.add_text(f"so {step.result(name, formula, METRES)}.")
    step.close()
    _tell_on_the_way(model, name)
    return name


def _tell_on_the_way(model: OneCoordinateModel, name: Symbol) -> None:
    """Verify that the body passes the position of greatest speed before the motion in question ends."""
    book, end = model.book, _end(model)
    if end is None or book.is_hidden(end) or book.is_hidden(name):
        return
    near, far = (-position if book.value(position) < 0.0 else position for position in (name, end))
    step, last = book.begin_step("verify"), book.fresh(name.name, r"\text{end}")
    record_inequality(book, step, far, near)
    equation = step.verified(last, end, METRES)
    spring = (
        model.setting.spring_phrases[model.query.moment.name] if isinstance(model.query.moment, NaturalLength) else ""
    )
    there = f"{spring} has its natural length, at {equation}" if spring else f"${name.name} = {end.latex()}$ is reached"
    step.add_text(f"This point is passed before {there}.")
    step.close()


def _end(model: OneCoordinateModel) -> Expression | None:
    """Return the position, m, at which the interval of the question ends; None if no position defines its end."""
    moment = model.query.moment
    if isinstance(moment, NaturalLength):
        return model.relaxed_place(moment.name)
    return model.moved_to(moment) if isinstance(moment, Moved) and isinstance(model.motion, LinearMotion) else None


def friction_words(model: LinearMotionModel, motion: LinearMotion) -> str:
    """Return the direction of kinetic friction in words, with the bodies unless only the mover of `motion` slides."""
    ways: dict[str, list[str]] = {}
    for face, side in motion.laws.slip_directions.items():
        pairs = [(k, radius) for k, radius in sliding_coordinates(motion.mechanism, face) if motion.ratios[k]]
        if side and pairs:
            k, radius = pairs[0]
            against = model.towards(k, forward=side * radius < 0.0)
            ways.setdefault(against, []).append(motion.mechanism.faces[face].subject)
    if [body for bodies in ways.values() for body in bodies] == [motion.mechanism.coordinates[motion.free[0]].body]:
        return next(iter(ways))
    return join_words([f"on {model.setting.bodies_phrase(bodies)} {against}" for against, bodies in ways.items()])


def first_friction(model: LinearMotionModel, motion: LinearMotion) -> str:
    """Return a clause, without a full stop, about kinetic friction in motion that begins from rest."""
    acts = f"friction acts {friction_words(model, motion)}"
    return (
        f"Until {model.mover_phrase(motion.free[0])} first comes to rest, {acts}"
        if continues_after_rest(model.setting)
        else capitalized(acts)
    )


def swing_words(model: LinearMotionModel, oscillation: HarmonicOscillation, number: int) -> list[str]:
    """Return sentences about friction and motion in the half-oscillation `number`, counted from 0."""
    motion = oscillation.motion
    assert isinstance(motion, LinearMotion)
    who, acts = model.mover_phrase(motion.free[0]), friction_words(model, motion)
    half = "half an oscillation, symmetric about the point at which the net force is zero"
    if number:
        begun = model.initial_rate(motion.free[0]) and number == 1
        counted = f"let ${oscillation.name.name}$ be the displacement {model.towards(motion.free[0])} from here"
        return [
            f"Until it next comes to rest, friction acts {acts}; {counted}.",
            f"The motion is then {half}." if begun else "",
        ]
    description = half if not oscillation.first else "harmonic about the point at which the net force is zero"
    friction = f"constant friction{_size(motion)} acts {acts}"
    return [f"Until {who} first comes to rest, {friction}, so the motion is {description}."]


def _size(motion: LinearMotion) -> str:
    """Return the kinetic friction in LaTeX after a space; empty unless it acts on one body alone."""
    faces = [face for face, side in motion.laws.slip_directions.items() if side]
    if len(faces) != 1:
        return ""
    return f" ${(motion.laws.coefficient(faces[0]) * motion.normal(faces[0])).factored().latex()}$"


FRICTION_LIMIT_FACTOR = 1.0 + 1e-9


class StaticFrictionChecks:
    """A writer of comparisons of forces with the greatest static friction; no result depends on them."""

    def __init__(self, way: LinearMotionModel) -> None:
        """Take the motion model of an answer, into whose builder comparisons are written."""
        self._model, self._setting, self._book = way, way.setting, way.book
        self._most = ""  # symbol of the greatest static friction on the moving body, once it is written

    # ---- of what moves

    def write_moves(self, motion: LinearMotion, number: int, said: str) -> bool:
        """Write that static friction cannot hold the body at a position, and the clause `said` about its next motion.

        The position is the start or, if `number` is not zero, that turning point. Return whether the forces are known;
        otherwise the comparison is written at the end.
        """
        where = "here" if number else "at the start"
        return self._compare(motion, number, where, ("exceeds", f"so {said}"), moves=True)

    def write_stays(self, motion: LinearMotion, number: int) -> None:
        """Write that static friction holds the body at the turning point with this number."""
        phrases = "is less than", f"so {self._model.mover_phrase(motion.free[0])} stays at rest"
        self._compare(motion, number, "here", phrases, moves=False)

    def is_force_hidden(self, motion: LinearMotion) -> bool:
        """Return whether the net force without friction, or the greatest static friction, depends on the unknown."""
        return any(
            map(self._book.is_hidden, (without_friction(motion), motion.greatest_friction(motion.free[0]).factored()))
        )

    def _compare(self, motion: LinearMotion, number: int, where: str, said: tuple[str, str], *, moves: bool) -> bool:
        if self.is_force_hidden(motion):
            if not self._book.in_symbols:
                location = f"at ${motion.begin.expression().latex()}$" if number else where
                later = said[0], said[1] if not moves else "as was assumed"
                self._book.afterwards.append(
                    lambda: self._write_comparison(motion, number, location, later, moves=moves)
                )
            return False
        self._write_comparison(motion, number, where, said, moves=moves)
        return True

    def _write_comparison(
        self, motion: LinearMotion, number: int, where: str, said: tuple[str, str], *, moves: bool
    ) -> None:
        book, (i,) = self._book, motion.free
        friction = motion.friction(i)
        pull, most = without_friction(motion), self._size(motion.greatest_friction(i))
        forward = book.value(pull) > 0.0
        pull = pull if forward else without_friction(motion, sign=-1.0)
        if (
            (book.value(pull) * FRICTION_LIMIT_FACTOR < book.value(most))
            if moves
            else (book.value(pull) > FRICTION_LIMIT_FACTOR * book.value(most))
        ):
            raise UnsolvedError("friction is not as strong as it should be")
        what = "spring force"
        if motion.steady(i) - friction:
            what = "net force without friction"
        elif len(motion.springs) > 1:
            what = "net force of the springs"
        step, name = book.begin_step("verify"), book.fresh("F", str(number))
        equation, limit = step.verified(name, pull, NEWTONS), f"${self._most}$"
        if not self._most:
            greatest = book.fresh("f", r"\text{max}")
            self._most = greatest.name
            limit = f"the greatest static friction {step.verified(greatest, most, NEWTONS)}"
        if moves:
            record_inequality(book, step, pull, most)
        towards, (than, so) = self._model.towards(i, forward=forward), said
        step.add_text(f"The {what} {where} is {equation} {towards}; it {than} {limit}, {so}.")
        step.close()

    def _size(self, held: Polynomial) -> Expression:
        formula = held.factored()
        return formula if self._book.value(formula) >= 0.0 else held.scale(-1.0).factored()

    # ---- of what does not

    @staticmethod
    def resting_faces(motion: LinearMotion) -> list[tuple[int, int]]:
        """Return the faces on which bodies do not move, each with the coordinate of its body."""
        sticks = (
            (face, motion.laws.single_slip_coordinate(face))
            for face, side in motion.laws.slip_directions.items()
            if side == 0
        )
        return [(face, own) for face, own in sticks if own is not None and not motion.ratios[own]]

    def others_rest(self, motion: LinearMotion, places: Sequence[Expression], later: float) -> None:
        """Write that static friction holds each resting body against its springs while another body oscillates.

        The free coordinate has turned back at the `places`, m, and turns back next at the value `later`; springs pull
        hardest at turning points.
        """
        for face, own in self.resting_faces(motion):
            needed = [
                self._holding(motion, face, own, Polynomial.from_expression(position) if position != ZERO else NIL)
                for position in places
            ]
            beyond = self._holding(motion, face, own, Polynomial.from_expression(later))
            if beyond is not None:
                self._rests(motion, face, [force for force in needed if force is not None], self._size(beyond))

    def _rests(self, motion: LinearMotion, face: int, needed: Sequence[Polynomial], beyond: Expression) -> None:
        book = self._book
        most, sizes = (
            (motion.laws.static_coefficient(face) * motion.normal(face)).factored(),
            [*map(self._size, needed)],
        )
        greatest = max(sizes, key=book.value)
        hidden = book.is_hidden(greatest) or book.is_hidden(most)
        if book.value(beyond) > FRICTION_LIMIT_FACTOR * book.value(greatest):
            return
        if hidden:
            if not book.in_symbols:
                book.afterwards.append(lambda: self._write_resting(motion, face, greatest, most))
            return
        self._write_resting(motion, face, greatest, most)

    def _write_resting(self, motion: LinearMotion, face: int, greatest: Expression, most: Expression) -> None:
        book = self._book
        if book.value(greatest) > FRICTION_LIMIT_FACTOR * book.value(most):
            raise UnsolvedError("friction could not hold what rests")
        body = motion.mechanism.faces[face].subject
        step, mark = book.begin_step("verify"), self._setting.subscript_of(body)
        equations = friction_formulas(book, step, mark, greatest, most)
        step.add_text(
            f"{capitalized(self._setting.display_name(body))} stays at rest: "
            f"the friction required is at most {equations[0]}, within "
            f"the limit of static friction, {equations[1]}."
        )
        step.close()

    def _holding(self, motion: LinearMotion, face: int, own: int, place: Polynomial) -> Polynomial | None:
        """Return the friction that holds a body at a value of the free coordinate; None if strings pull as well."""
        laws, (i,) = motion.laws, motion.free
        row = laws.newton(own)
        known = {f"q{k}": NIL for k in motion.ratios}
        for n in motion.springs:
            extension = laws.strain(n) + place.scale(motion.extension_ratio(n, i))
            known[f"S{n}"] = laws.stiffness(n) * extension
        zero, name = row.zero.substitute(known), f"f{face}"
        others = {other for other in zero.names() - {name} if other[0] in "TNS" and other[1:].isdigit()}
        part = zero.coefficient(name).number
        return None if others or not part else zero.terms_without((name,)).scale(-1.0 / part)
