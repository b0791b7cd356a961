"""Random mechanisms with varying equations of motion, in families, each a function of a seed.

Both engines are tested on them, and balances of energy and momentum. `tangle` combines all parts at random.
"""

from collections.abc import Callable

from curved_mechanisms.flying import balls, fields, planets
from curved_mechanisms.hanging import bent, bobs, hinged
from curved_mechanisms.on_faces import curves, rollers
from curved_mechanisms.sprung import chains, nets
from curved_mechanisms.tangled import tangle
from sim2reason.scenes.dsl.mechanism import Mechanism

__all__ = ["FAMILIES"]

FAMILIES: dict[str, Callable[[int], Mechanism]] = {
    "hinged": hinged,
    "bobs": bobs,
    "nets": nets,
    "chains": chains,
    "bent": bent,
    "rollers": rollers,
    "curves": curves,
    "balls": balls,
    "fields": fields,
    "planets": planets,
    "tangle": tangle,
}
