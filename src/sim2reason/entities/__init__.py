"""The entities that scenes are made of, in modules by theme."""

from sim2reason.dsl.entity import ENTITIES

__all__ = ["ENTITIES"]
