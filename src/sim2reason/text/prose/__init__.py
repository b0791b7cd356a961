"""Rendering of scenes as text: names, wordings, tables and closing sentences."""

from sim2reason.text.prose.description import Description, describe

__all__ = ["Description", "describe"]
