"""The bodies that entities are made of, in modules by theme."""

from sim2reason.scenes.dsl.body import BODIES

__all__ = ["BODIES"]
