"""Calls of a foreign library that may hang or raise."""

import time


def slow(text: str) -> str:
    """Return the text in upper case, hang, or raise."""
    if text == "hang":
        time.sleep(600.0)
    if text == "raise":
        raise RuntimeError(text)
    return text.upper()
