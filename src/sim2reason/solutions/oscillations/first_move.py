"""The initial direction of an oscillation from rest."""

from sim2reason.solutions.oscillations.linear_motion import LinearMotion
from sim2reason.solutions.oscillations.linear_way import LinearWay
from sim2reason.solutions.oscillations.relative_motion import RelativeMotion
from sim2reason.solutions.setting import capital
from sim2reason.solutions.writing.unit_latex import NEWTONS


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
    step.close()
