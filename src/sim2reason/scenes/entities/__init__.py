"""The entities that scenes are made of, in modules by theme."""

from sim2reason.scenes.dsl.entity import ENTITIES

__all__ = ["ENTITIES"]
