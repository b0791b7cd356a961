"""Parsing of ordinary English: replacement of sentences by equivalent sentences of the library."""

from sim2reason.text.parsing.ordinary.textbook import TEXTBOOK_SCENES

__all__ = ["TEXTBOOK_SCENES"]
