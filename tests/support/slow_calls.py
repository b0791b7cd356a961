"""What a foreign library may do to a process that calls it."""

import time


def slow(text: str) -> str:
    """Shout, hang or raise."""
    if text == "hang":
        time.sleep(600.0)
    if text == "raise":
        raise RuntimeError(text)
    return text.upper()
