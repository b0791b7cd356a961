"""A key that is used and never shown."""

import os
import re
from collections.abc import Mapping
from typing import Final
from urllib.parse import quote

from pydantic import JsonValue

from sim2reason.errors import PolicyError

__all__ = ["PRINTABLE", "VARIABLE", "Secret", "from_environment"]

VARIABLE: Final = re.compile(r"[A-Za-z_][A-Za-z0-9_]{0,79}")
HIDDEN: Final = "***"
PRINTABLE: Final = re.compile(r"[!-~]+")
"""What a header and an address may have: no blanks, and no letters beyond ASCII."""


class Secret:
    """A text that no representation shows; empty where no key is needed."""

    __slots__ = ("_text",)

    def __init__(self, text: str = "") -> None:
        """Keep `text`."""
        self._text = text

    def __repr__(self) -> str:
        """Tell nothing: locals of a traceback are shown so."""
        return f"Secret({HIDDEN})"

    def headers(self) -> dict[str, str]:
        """Return the header that carries the key, if there is one."""
        return {"Authorization": f"Bearer {self._text}"} if self._text else {}

    def hidden(self, text: str) -> str:
        """`text` with the key made unreadable wherever it stands, also as an address would spell it."""
        for spelling in self._spellings:
            text = text.replace(spelling, HIDDEN)
        return text

    def stands_in(self, value: JsonValue) -> bool:
        """Return whether the key stands anywhere in a text, or in the texts and names of a list or an object."""
        match value:
            case str():
                return any(spelling in value for spelling in self._spellings)
            case list():
                return any(map(self.stands_in, value))
            case dict():
                return any(self.stands_in(name) or self.stands_in(each) for name, each in value.items())
            case _:
                return False

    @property
    def _spellings(self) -> set[str]:
        """As it is, and as an address would have it."""
        return {self._text, quote(self._text, safe="")} - {""}


def from_environment(variable: str | None, environment: Mapping[str, str] = os.environ) -> Secret:
    """Return the key that the variable holds; PolicyError, which names the variable alone, if none could be sent."""
    if variable is None:
        return Secret()
    key = environment.get(variable, "").strip()
    if not key:
        raise PolicyError(f"the environment variable {variable} holds no key; set it, or leave key_from out")
    if not PRINTABLE.fullmatch(key):  # else http.client would show it in its complaint
        raise PolicyError(f"the key in the environment variable {variable} has blanks or signs that no header may have")
    return Secret(key)
