"""From a scene to its text: names, wordings, tables, and what is said at the end."""

from sim2reason.dsl.telling.speaker import Telling, tell

__all__ = ["Telling", "tell"]
