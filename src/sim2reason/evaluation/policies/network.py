"""Network access of policies: HTTP requests with limits, retries and a key, and the Hugging Face Hub.

Requests have limits on time and size. The transformers library is used without progress bars.
"""

# huggingface_hub is an extra:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

import os
import re
import time
from collections.abc import Callable, Generator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from http.client import HTTPException, HTTPResponse
from importlib import import_module
from pathlib import Path
from random import Random
from typing import Any, Final, Literal
from urllib.parse import quote
from urllib.request import HTTPErrorProcessor, Request, build_opener
from warnings import catch_warnings, filterwarnings

from pydantic import JsonValue

from sim2reason.base.optional import optional
from sim2reason.errors import PolicyError

__all__ = [
    "PRINTABLE",
    "VARIABLE",
    "NoReply",
    "Reply",
    "Secret",
    "delay",
    "explain_errors",
    "loading_arguments",
    "out_of_reach",
    "post",
    "read_secret",
    "silence_library",
]

FIRST, LONGEST, ASKED = 1.0, 60.0, 300.0  # s: first and longest delay, and longest one that a server may request
DELAY_FACTOR: Final = 2.0  # factor between successive delays


def delay(attempt: int, seed: int, retry_after: float | None = None) -> float:
    """Return how long to wait after a request has failed for the `attempt`-th time, counted from zero, s.

    It doubles up to a minute, minus a fraction of up to one half determined by `seed` and `attempt`; at least as long
    as the server `retry_after`, up to five minutes.
    """
    most = min(FIRST * DELAY_FACTOR ** min(attempt, 30), LONGEST)
    share = Random(f"{seed}:{attempt}").uniform(0.5, 1.0)  # noqa: S311 - spreads requests, guards nothing
    return max(most * share, min(retry_after or 0.0, ASKED))


VARIABLE: Final = re.compile(r"[A-Za-z_][A-Za-z0-9_]{0,79}")
HIDDEN: Final = "***"
PRINTABLE: Final = re.compile(r"[!-~]+")
"""What a header and an address may have: no blanks, and no letters beyond ASCII."""


class Secret:
    """A text that no representation shows; empty if no key is needed."""

    __slots__ = ("_text",)

    def __init__(self, text: str = "") -> None:
        """Store the key."""
        self._text = text

    def __repr__(self) -> str:
        """Return a fixed text, so that tracebacks do not show the key."""
        return f"Secret({HIDDEN})"

    def headers(self) -> dict[str, str]:
        """Return the header with the key, or no header without one."""
        return {"Authorization": f"Bearer {self._text}"} if self._text else {}

    def hidden(self, text: str) -> str:
        """Return `text` with the key masked, also in its URL-encoded form."""
        for spelling in self._spellings:
            text = text.replace(spelling, HIDDEN)
        return text

    def occurs_in(self, value: JsonValue) -> bool:
        """Return whether the key occurs in a text, or in any text or name within a list or object."""
        match value:
            case str():
                return any(spelling in value for spelling in self._spellings)
            case list():
                return any(map(self.occurs_in, value))
            case dict():
                return any(self.occurs_in(name) or self.occurs_in(each) for name, each in value.items())
            case _:
                return False

    @property
    def _spellings(self) -> set[str]:
        """Return the key in plain and URL-encoded form."""
        return {self._text, quote(self._text, safe="")} - {""}


def read_secret(variable: str | None, environment: Mapping[str, str] = os.environ) -> Secret:
    """Return the key in an environment variable; PolicyError, with only the variable's name, if it is invalid."""
    if variable is None:
        return Secret()
    key = environment.get(variable, "").strip()
    if not key:
        raise PolicyError(f"the environment variable {variable} holds no key; set it, or leave key_from out")
    if not PRINTABLE.fullmatch(key):  # else http.client would show it in its complaint
        raise PolicyError(f"the key in the environment variable {variable} has blanks or signs that no header may have")
    return Secret(key)


MAX_BODY: Final = 64 * 2**20
CHUNK_SIZE: Final = 2**16


@dataclass(frozen=True, slots=True)
class Reply:
    """A server's reply with any status."""

    status: int
    body: bytes
    retry_after: float | None = None
    """For how long the server asks to be left alone, s."""


@dataclass(frozen=True, slots=True)
class NoReply:
    """The reason for a missing or incomplete reply."""

    reason: str


class _AnyStatus(HTTPErrorProcessor):
    """A response handler that accepts every status, and follows no redirections."""

    def http_response(self, request: Request, response: HTTPResponse) -> HTTPResponse:
        """Return the response unchanged."""
        del request
        return response

    https_response = http_response


def post(url: str, body: bytes, headers: Mapping[str, str], timeout: float) -> Reply | NoReply:
    """Send `body` as JSON, with a timeout of `timeout` seconds between data and roughly in total.

    The reason for a missing reply is only the kind of the error, whose text may contain what was sent.
    """
    deadline = time.monotonic() + timeout
    request = Request(url, body, {"Content-Type": "application/json", "User-Agent": "sim2reason", **headers})  # noqa: S310
    try:
        with build_opener(_AnyStatus).open(request, timeout=timeout) as response:
            content = _read(response, deadline)
            if isinstance(content, str):
                return NoReply(content)
            return Reply(response.status, content, _seconds(response.headers.get("Retry-After")))
    except TimeoutError:
        return NoReply(f"no answer within {timeout:g} s")
    except (OSError, HTTPException, ValueError) as error:
        cause = getattr(error, "reason", None)
        if isinstance(cause, TimeoutError):
            return NoReply(f"no answer within {timeout:g} s")
        return NoReply(f"no connection ({type(cause if isinstance(cause, Exception) else error).__name__})")


def _read(response: HTTPResponse, deadline: float) -> bytes | str:
    """Return the whole body, or the reason why it is incomplete."""
    parts: list[bytes] = []
    size = 0
    while part := response.read1(CHUNK_SIZE):
        parts.append(part)
        size += len(part)
        if size > MAX_BODY:
            return f"more than {MAX_BODY // 2**20} MiB"
        if time.monotonic() > deadline:
            return "an answer that never ends"
    if response.length:  # what was announced and did not come; read1 does not complain
        return "an answer that breaks off"
    return b"".join(parts)


def _seconds(text: str | None) -> float | None:
    return float(text) if text is not None and text.strip().isdecimal() and len(text) < 8 else None


HUB_TIMEOUT = 10.0  # s
MAX_MESSAGE_LENGTH = 200  # characters of the library's error message


def out_of_reach(name: str, kind: Literal["model", "dataset"], revision: str | None = None) -> bool:
    """Return whether the Hub is unreachable, so that only the local cache is available.

    Any reply counts as reachable. ValueError if the name is invalid on the Hub.
    """
    hub: Any = import_module("huggingface_hub")
    errors: Any = import_module("huggingface_hub.errors")
    try:
        hub.HfApi().repo_info(name, repo_type=kind, revision=revision, timeout=HUB_TIMEOUT)
    except errors.HfHubHTTPError:
        return False
    except errors.HFValidationError:
        raise ValueError("no such folder, and no name that the hub could have") from None
    except Exception:  # noqa: BLE001 - the library raises what its transport does
        return True
    return False


def loading_arguments(path: str, revision: str | None = None) -> dict[str, Any]:
    """Return the arguments of `from_pretrained` that restrict it to local files if the Hub is unreachable.

    Raises:
        ValueError: there is neither such a folder nor such a name.
        FileNotFoundError: there is no such folder, the hub is out of reach, and the model is not kept here.
    """
    if Path(path).exists() or not out_of_reach(path, "model", revision):
        return {"revision": revision}
    hub: Any = import_module("huggingface_hub")
    if not isinstance(hub.try_to_load_from_cache(path, "config.json", revision=revision), str):
        raise FileNotFoundError("no such folder, and the hub cannot be reached")
    return {"revision": revision, "local_files_only": True}


@contextmanager
def explain_errors(path: str, error: Callable[[str], Exception]) -> Generator[None]:
    """Raise `error`, with a message of one line, if the block fails to load the model at `path`."""
    try:
        yield
    except (OSError, ValueError, ImportError) as found:
        why = " ".join(str(found).split())[:MAX_MESSAGE_LENGTH]
        raise error(f"no model could be loaded from {path!r}: {why}") from None


@contextmanager
def silence_library() -> Generator[None, None, None]:
    """Suppress the library's progress bars and warnings while the block runs; errors are still raised.

    Also suppressed is a warning that peft 0.21 causes in transformers 5.23. MissingExtraError without the library.
    """
    logging = optional("transformers", "train").utils.logging
    verbosity, bars = logging.get_verbosity(), logging.is_progress_bar_enabled()
    logging.set_verbosity_error()
    logging.disable_progress_bar()
    try:
        with catch_warnings():
            filterwarnings("ignore", message="`is_gradient_checkpointing` is deprecated", category=FutureWarning)
            yield
    finally:
        logging.set_verbosity(verbosity)
        if bars:
            logging.enable_progress_bar()
