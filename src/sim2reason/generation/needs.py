"""What the solutions of ordered items may need: by default little more than elementary means.

Each request draws for itself whether its item may need a computer, so that an item hangs on its own coordinates alone.
"""

from sim2reason.generation.random_scenes import generator
from sim2reason.generation.request import Request
from sim2reason.questions.need import ELEMENTARY, EVERY, NEEDS, Need

SHARE = 0.08
"""Of the requests that may be filled by items which need more than `ELEMENTARY`; not all of them are."""
SIMPLE = frozenset(need for need in Need if need <= ELEMENTARY)


def allowed(request: Request) -> frozenset[Need]:
    """Return what the item of a request may need: what is ordered, else a draw by `SHARE`."""
    if request.needs:
        return frozenset(NEEDS[name] for name in request.needs)
    if request.unfiltered:
        return EVERY
    asked = request.recipe, request.difficulty, request.mode, request.seed, request.index
    return EVERY if generator(*asked, "needs").random() < SHARE else SIMPLE
