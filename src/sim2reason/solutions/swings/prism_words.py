"""Sentences about a prism that tips over its edges: its shape, and the position of its axis at landings."""

from collections.abc import Sequence

from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Number
from sim2reason.solutions.algebra.functions import Call, Power
from sim2reason.solutions.writing.comparing import record_inequality
from sim2reason.solutions.writing.steps import SolutionBuilder
from sim2reason.solutions.writing.unit_latex import JOULES

HALF = Number(0.5)


def shape_words(who: str, sides: int, turn: Expression) -> str:
    """Return the words before the moment of inertia of a regular prism about its axis."""
    return (
        "About one of its corners the moment of inertia of a uniform triangle is its mass times one sixth of the sum "
        "of three terms: the squares of the two sides that meet there, and their product times the cosine of the angle "
        f"between them. Lines from the axis to the edges divide {who} into {sides} equal triangles, with the angle "
        f"${turn.latex()}$ at the axis, so its moment of inertia about that is"
    )


def sinking_words(radius: Expression, half: Expression, slope: Expression) -> str:
    """Return a clause about the distance by which the axis sinks from one landing to the next."""
    if slope == ZERO:
        return "When the next edge lands, the axis is as high as before"
    way = Number(2.0) * radius * Call("sin", half) * Call("sin", slope)
    moves = "the axis moves by one side of the base along the plane"
    return f"Until the next edge lands, {moves} and sinks by ${way.latex()}$"


def landing_words(speed: Expression, turn: Expression, law: str) -> str:
    """Return the sentences before the conservation of angular momentum about a new edge."""
    fast, angle = speed.latex(), turn.latex()
    said = f"Just before, the axis has the speed ${fast}$, at the angle ${angle}$ to its direction just after."
    return f"{said} Angular momentum about the new edge is conserved: {law},"


def angle_words(half: Expression, angle: Expression) -> str:
    """Return the sentence that gives the angle of the line from edge to axis with the vertical."""
    return (
        "At the start, and whenever an edge lands, the line from the lower edge to the axis is turned uphill by "
        f"${half.latex()}$ from the perpendicular to the plane. At the moment asked about, its angle with the "
        f"vertical is ${angle.latex()}$, positive downhill."
    )


def velocities_words(turned: Expression, *, highest: bool, landed: bool) -> str:
    """Return the sentences that give the angle between the initial and final velocities of the axis.

    `turned` is the final angle turned, since the last landing if the prism has `landed`; `highest` states that the axis
    is then at the top, before any landing.
    """
    angle = f"${turned.latex()}$"
    how = f"Since the start it has turned by {angle}"
    if landed:
        how = f"Just after each landing it has its first direction again; since the last it has turned by {angle}"
    elif highest:
        how = f"At the start it makes the angle {angle} with the vertical, and in the end it is vertical"
    line = "The velocity of the axis is perpendicular to the line from the lower edge to it."
    return f"{line} {how}, so this is the angle between the initial and the final velocity."


def tell(book: SolutionBuilder, sentence: str) -> None:
    """Write a step that only contains a given sentence, on which no result depends."""
    step = book.begin_step("extreme")
    step.add_text(sentence)
    step.close()


def verify_tops(
    book: SolutionBuilder, rates: Sequence[Expression], inertia: Expression, weight: Expression, begins: Expression
) -> None:
    """Schedule the verification that the axis passes over every edge from which another one is reached.

    The last of the `rates` is that after the last landing: its edge is included if the energy suffices to pass it.
    """
    if book.in_symbols or len(rates) < 2 or book.value(begins) >= 0.0:
        return

    def write() -> None:
        top = weight * (ONE - Call("cos", begins))
        over = book.value(HALF * inertia * Power(rates[-1], 2)) > book.value(top)
        least = min(rates if over else rates[:-1], key=book.value)
        energy = HALF * inertia * (Power(least, 2))
        step, names = book.begin_step("verify"), [book.fresh("K", r"\text{min}"), book.fresh("U", r"\text{top}")]
        record_inequality(book, step, energy, top)
        told = [step.verified(name, held, JOULES) for name, held in zip(names, (energy, top), strict=True)]
        edges, landing = ("each edge", "a landing") if over else ("each edge before the last", "an earlier landing")
        step.add_text(
            f"The axis passes over {edges}, since the least kinetic energy at the start or just after {landing},"
        )
        step.add_text(f"{told[0]}, exceeds the energy {told[1]} by which it rises.")
        step.close()

    book.afterwards.append(write)
