"""The entities that scenes are made of, one file each."""

from sim2reason.dsl.entity import ENTITIES

__all__ = ["ENTITIES"]
