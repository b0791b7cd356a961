"""The bodies of entities, in modules by theme."""

from sim2reason.scenes.dsl.body import BODIES

__all__ = ["BODIES"]
