"""From a scene to its text: names, wordings, tables, and what is said at the end."""

from sim2reason.text.prose.description import Description, describe

__all__ = ["Description", "describe"]
