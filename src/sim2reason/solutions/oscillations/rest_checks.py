"""Comparisons with static friction for bodies on springs, at turning points and beside them."""

from collections.abc import Sequence

from sim2reason.solutions.algebra.expressions import ZERO, Expression
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.laws.sticking import told_friction
from sim2reason.solutions.oscillations.linear_motion import LinearMotion
from sim2reason.solutions.setting import Setting, capital
from sim2reason.solutions.writing.steps import Book, UnsolvedError
from sim2reason.solutions.writing.unit_latex import NEWTONS

LIMIT = 1.0 + 1e-9


class RestChecks:
    """A writer of comparisons of forces with the greatest static friction, in numbers; no result rests on them."""

    def __init__(self, setting: Setting, book: Book) -> None:
        """Take the setting, and the book into which comparisons are written."""
        self._setting, self._book = setting, book
        self._most = ""  # the symbol of the greatest static friction on what moves, once it is written

    # ---- of what moves

    def moves_on(self, motion: LinearMotion, number: int, said: str) -> bool:
        """Write that friction does not hold the system where places are counted from; `said` is what it does then.

        The place is the start or, if the `number` is not zero, that turning point. Return whether numbers are known.
        """
        return self._compare(motion, number, "exceeds", f"so {said}", moves=True)

    def stays(self, motion: LinearMotion, number: int) -> None:
        """Write that friction holds the system at a turning point, from which places are counted."""
        self._compare(motion, number, "is less than", "so it stays", moves=False)

    def _compare(self, motion: LinearMotion, number: int, than: str, so: str, *, moves: bool) -> bool:
        book, (i,) = self._book, motion.free
        friction = motion.friction(i)
        pull, most = (self._size(held) for held in (motion.load(i) - friction, friction))
        if book.is_hidden(pull) or book.is_hidden(most):
            return False
        if (book.value(pull) * LIMIT < book.value(most)) if moves else (book.value(pull) > LIMIT * book.value(most)):
            raise UnsolvedError("friction is not as strong as it should be")
        what = "The spring force"
        if motion.steady(i) - friction:
            what = "The net force without friction"
        elif len(motion.springs) > 1:
            what = "The net force of the springs"
        step, name = book.open("verify"), book.fresh("F", str(number))
        book.observed[name.name] = book.value(pull)
        told, limit = step.verified(name, pull, NEWTONS), f"${self._most}$"
        if not self._most:
            greatest = book.fresh("f", r"\text{max}")
            self._most, book.observed[greatest.name] = greatest.name, book.value(most)
            limit = f"the greatest static friction {step.verified(greatest, most, NEWTONS)}"
        step.say(f"{what} {'here' if number else 'at the start'}, {told}, {than} {limit}, {so}.")
        step.close()
        return True

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
        most, sizes = (motion.laws.coefficient(face) * motion.normal(face)).factored(), [*map(self._size, needed)]
        greatest = max(sizes, key=book.value)
        hidden = book.is_hidden(greatest) or book.is_hidden(most)
        if hidden or book.value(beyond) > LIMIT * book.value(greatest):
            return
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
