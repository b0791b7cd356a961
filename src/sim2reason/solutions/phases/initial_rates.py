"""Initial rates of the coordinates in the numbers of the text."""

from collections.abc import Sequence

from sim2reason.solutions.algebra.expressions import Expression
from sim2reason.solutions.writing.lexicon import Both, Lexicon, UnreadError
from sim2reason.solutions.writing.steps import UnsolvedError


def initial_rates(lexicon: Lexicon, senses: Sequence[float]) -> list[Expression]:
    """Return the initial rate of each coordinate, which counts in one of two `senses`, 1 or -1.

    Raises:
        UnsolvedError: the text gives one neither as a number nor by a simple function of numbers.
    """
    pairs = zip(lexicon.mechanism.coordinates, lexicon.twin.coordinates, senses, strict=True)
    return [_speed(lexicon, Both(sense * a.speed, sense * b.speed)) for a, b, sense in pairs]


def _speed(lexicon: Lexicon, speed: Both) -> Expression:
    """Return an initial rate in the numbers of the text; an angular one may be a speed over a length."""
    for length in (None, *lexicon.lengths):
        try:
            if length is None:
                return lexicon.read(speed).expression()
            return lexicon.read(speed * length).expression() / lexicon.read(length).expression()
        except UnreadError:
            continue
    raise UnsolvedError(f"the initial rate {speed.here:.6g} is no simple function of the numbers in the text")
