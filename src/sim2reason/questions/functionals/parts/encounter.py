"""How questions speak of one collision of two bodies that they name."""

from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.bounced import Bounced
from sim2reason.questions.moments.collided import Collided
from sim2reason.questions.spoken import ordinal
from sim2reason.questions.words import Words


def encounter(moment: Moment, words: Words, name: str) -> tuple[str, ...]:
    """As in: in their second collision; empty for a moment that is not just after one of `name`."""
    del words
    if not (isinstance(moment, Collided | Bounced) and moment.after and moment.name == name):
        return ()
    which = ordinal(moment.number)
    return (
        f"in their {which} collision",
        f"when they collide for the {which} time",
        f"in the {which} collision of the two",
    )
