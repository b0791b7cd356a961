"""The entities of scenes, in modules by theme."""

from sim2reason.scenes.dsl.entity import ENTITIES

__all__ = ["ENTITIES"]
