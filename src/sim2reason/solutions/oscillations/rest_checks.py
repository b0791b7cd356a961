"""Comparisons with static friction for bodies on springs, at turning points and beside them."""

from collections.abc import Sequence

from sim2reason.solutions.algebra.expressions import ZERO, Expression
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.laws.sticking import told_friction
from sim2reason.solutions.oscillations.linear_motion import LinearMotion
from sim2reason.solutions.oscillations.linear_way import LinearWay
from sim2reason.solutions.oscillations.net_force import without_friction
from sim2reason.solutions.setting import capital
from sim2reason.solutions.writing.comparing import exceeds
from sim2reason.solutions.writing.steps import UnsolvedError
from sim2reason.solutions.writing.unit_latex import NEWTONS

LIMIT = 1.0 + 1e-9


class RestChecks:
    """A writer of comparisons of forces with the greatest static friction, in numbers; no result rests on them."""

    def __init__(self, way: LinearWay) -> None:
        """Take the way to an answer, into whose book comparisons are written."""
        self._way, self._setting, self._book = way, way.setting, way.book
        self._most = ""  # the symbol of the greatest static friction on what moves, once it is written

    # ---- of what moves

    def moves_on(self, motion: LinearMotion, number: int, said: str) -> bool:
        """Write that friction does not hold the system where places are counted from; `said` is what it does then.

        The place is the start or, if the `number` is not zero, that turning point. Return whether numbers are known;
        where they are not, it is written in the end.
        """
        where = "here" if number else "at the start"
        return self._compare(motion, number, where, ("exceeds", f"so {said}"), moves=True)

    def stays(self, motion: LinearMotion, number: int) -> None:
        """Write that friction holds the system at a turning point, from which places are counted."""
        said = "is less than", f"so {self._way.who(motion.free[0])} stays at rest"
        self._compare(motion, number, "here", said, moves=False)

    def hidden(self, motion: LinearMotion) -> bool:
        """Return whether one of the forces that are compared hangs on what is unknown."""
        return any(
            map(self._book.is_hidden, (without_friction(motion), motion.greatest_friction(motion.free[0]).factored()))
        )

    def _compare(self, motion: LinearMotion, number: int, where: str, said: tuple[str, str], *, moves: bool) -> bool:
        if self.hidden(motion):
            if not self._book.in_symbols:
                place = f"at ${motion.begin.expression().latex()}$" if number else where
                later = said[0], said[1] if not moves else "as was assumed"
                self._book.afterwards.append(lambda: self._tell(motion, number, place, later, moves=moves))
            return False
        self._tell(motion, number, where, said, moves=moves)
        return True

    def _tell(self, motion: LinearMotion, number: int, where: str, said: tuple[str, str], *, moves: bool) -> None:
        book, (i,) = self._book, motion.free
        friction = motion.friction(i)
        pull, most = without_friction(motion), self._size(motion.greatest_friction(i))
        forward = book.value(pull) > 0.0
        pull = pull if forward else without_friction(motion, sign=-1.0)
        if (book.value(pull) * LIMIT < book.value(most)) if moves else (book.value(pull) > LIMIT * book.value(most)):
            raise UnsolvedError("friction is not as strong as it should be")
        what = "spring force"
        if motion.steady(i) - friction:
            what = "net force without friction"
        elif len(motion.springs) > 1:
            what = "net force of the springs"
        step, name = book.open("verify"), book.fresh("F", str(number))
        told, limit = step.verified(name, pull, NEWTONS), f"${self._most}$"
        if not self._most:
            greatest = book.fresh("f", r"\text{max}")
            self._most = greatest.name
            limit = f"the greatest static friction {step.verified(greatest, most, NEWTONS)}"
        if moves:
            exceeds(book, step, pull, most)
        towards, (than, so) = self._way.towards(i, forward=forward), said
        step.say(f"The {what} {where} is {told} {towards}; it {than} {limit}, {so}.")
        step.close()

    def _size(self, held: Polynomial) -> Expression:
        formula = held.factored()
        return formula if self._book.value(formula) >= 0.0 else held.scaled(-1.0).factored()

    # ---- of what does not

    @staticmethod
    def resting(motion: LinearMotion) -> list[tuple[int, int]]:
        """Return the faces on which bodies do not move, each with the coordinate of its body."""
        sticks = ((face, motion.laws.alone(face)) for face, side in motion.laws.rough.items() if side == 0)
        return [(face, own) for face, own in sticks if own is not None and not motion.ratios[own]]

    def others_rest(self, motion: LinearMotion, places: Sequence[Expression], later: float) -> None:
        """Write of each body that friction holds against springs how much friction that takes at most.

        The free coordinate has been at the `places` and turns back next at the value `later`; springs pull hardest
        where it turns back.
        """
        for face, own in self.resting(motion):
            needed = [
                self._holding(motion, face, own, Polynomial.of(place) if place != ZERO else NIL) for place in places
            ]
            beyond = self._holding(motion, face, own, Polynomial.of(later))
            if beyond is not None:
                self._rests(motion, face, [held for held in needed if held is not None], self._size(beyond))

    def _rests(self, motion: LinearMotion, face: int, needed: Sequence[Polynomial], beyond: Expression) -> None:
        book = self._book
        most, sizes = (
            (motion.laws.static_coefficient(face) * motion.normal(face)).factored(),
            [*map(self._size, needed)],
        )
        greatest = max(sizes, key=book.value)
        hidden = book.is_hidden(greatest) or book.is_hidden(most)
        if book.value(beyond) > LIMIT * book.value(greatest):
            return
        if hidden:
            if not book.in_symbols:
                book.afterwards.append(lambda: self._tell_resting(motion, face, greatest, most))
            return
        self._tell_resting(motion, face, greatest, most)

    def _tell_resting(self, motion: LinearMotion, face: int, greatest: Expression, most: Expression) -> None:
        book = self._book
        if book.value(greatest) > LIMIT * book.value(most):
            raise UnsolvedError("friction could not hold what rests")
        body = motion.mechanism.faces[face].subject
        step, mark = book.open("verify"), self._setting.mark(body)
        told = told_friction(book, step, mark, greatest, most)
        step.say(
            f"{capital(self._setting.called(body))} stays at rest: the friction required is at most {told[0]}, within "
            f"the limit of static friction, {told[1]}."
        )
        step.close()

    def _holding(self, motion: LinearMotion, face: int, own: int, place: Polynomial) -> Polynomial | None:
        """Return the friction that holds a body while the free coordinate is at a place; None if strings pull, too."""
        laws, (i,) = motion.laws, motion.free
        row = laws.newton(own)
        known = {f"q{k}": NIL for k in motion.ratios}
        for n in motion.springs:
            extension = laws.strain(n) + place.scaled(motion.drawn(n, i))
            known[f"S{n}"] = laws.stiffness(n) * extension
        zero, name = row.zero.put(known), f"f{face}"
        others = {other for other in zero.names() - {name} if other[0] in "TNS" and other[1:].isdigit()}
        part = zero.coefficient(name).number
        return None if others or not part else zero.without((name,)).scaled(-1.0 / part)
