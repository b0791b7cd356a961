"""Public names for authors of entities; `sim2reason.scenes.authoring` documents them."""

from sim2reason.scenes import authoring as _names
from sim2reason.scenes.authoring import *  # noqa: F403 - the names in its __all__

__doc__ = _names.__doc__
__all__: list[str] = []
__all__ += _names.__all__
