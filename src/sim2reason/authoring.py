"""Public names for authors of entities; `sim2reason.scenes.authoring` documents them."""

from collections.abc import Iterable
from typing import TYPE_CHECKING

from sim2reason.scenes import authoring as _names
from sim2reason.scenes.authoring import *  # noqa: F403 - the names in its __all__
from sim2reason.scenes.bodies import BODIES as _BODIES

if TYPE_CHECKING:  # at run time `__getattr__` finds them in the registry
    from sim2reason.scenes.bodies.blocks import *  # noqa: F403
    from sim2reason.scenes.bodies.charges import *  # noqa: F403
    from sim2reason.scenes.bodies.eccentric_bodies import *  # noqa: F403
    from sim2reason.scenes.bodies.oscillators import *  # noqa: F403
    from sim2reason.scenes.bodies.round_bodies import *  # noqa: F403
    from sim2reason.scenes.bodies.simple_machines import *  # noqa: F403
    from sim2reason.scenes.bodies.space import *  # noqa: F403  # pyright: ignore[reportGeneralTypeIssues] - `pi` again

__doc__ = f"""{_names.__doc__}
Bodies are also names of this module: all that ``sim2reason list bodies`` shows, as in
``from sim2reason.authoring import Block, Plane``. They are imported when first used.
"""
__all__: list[str] = []
__all__ += _names.__all__


def __getattr__(name: str) -> object:
    """Return the registered body of a name, which may be one of an installed package."""
    if not name.startswith("_") and name in _BODIES:
        return _BODIES[name]
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}; for bodies see: sim2reason list bodies")


def __dir__() -> Iterable[str]:
    """Return the public names."""
    return sorted([*__all__, *_BODIES])
