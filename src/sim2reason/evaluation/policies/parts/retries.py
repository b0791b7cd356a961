"""How long to wait before an endpoint is asked again: ever longer, never all at once, the same every time."""

from random import Random
from typing import Final

__all__ = ["delay"]

FIRST, LONGEST, ASKED = 1.0, 60.0, 300.0  # s: the first wait, the longest of ours, the longest that a server may ask
WORTH_IT: Final = 2.0  # the factor from one wait to the next


def delay(attempt: int, seed: int, asked: float | None = None) -> float:
    """Seconds to wait after the `attempt`-th failure, counted from zero.

    It doubles up to a minute, less a part of up to a half that hangs on `seed` and `attempt` alone; at least as long
    as the server `asked`, up to five minutes.
    """
    most = min(FIRST * WORTH_IT ** min(attempt, 30), LONGEST)
    share = Random(f"{seed}:{attempt}").uniform(0.5, 1.0)  # noqa: S311 - spreads requests, guards nothing
    return max(most * share, min(asked or 0.0, ASKED))
