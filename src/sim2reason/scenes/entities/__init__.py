"""The entities of scenes, and the fields that act on charged beads, in modules by theme."""

from sim2reason.scenes.dsl.entity import ENTITIES
from sim2reason.scenes.entities.fields import FIELDS

__all__ = ["ENTITIES", "FIELDS"]
