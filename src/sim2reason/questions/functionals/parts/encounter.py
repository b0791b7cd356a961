"""How questions speak of one collision, of two bodies that they name or of one with what is fixed."""

from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.bounces import Bounced
from sim2reason.questions.moments.collisions import Collided
from sim2reason.questions.spoken import ordinal
from sim2reason.questions.words import Words


def encounter(moment: Moment, words: Words, name: str) -> tuple[str, ...]:
    """As in: in their second collision, when A hits the ground for the second time.

    Empty for a moment that is not just after one of `name`.
    """
    if not (isinstance(moment, Collided | Bounced) and moment.after and moment.name == name):
        return ()
    if isinstance(moment, Bounced):
        return moment.does(words).phrases(moment.subject(words), moment.number)
    number = moment.count(words)
    if number is None:
        return ("in their collision", "when they collide", "in the collision of the two")
    which = ordinal(number)
    return (
        f"in their {which} collision",
        f"when they collide for the {which} time",
        f"in the {which} collision of the two",
    )
