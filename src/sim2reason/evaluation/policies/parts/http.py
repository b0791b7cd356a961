"""One request over HTTP, bounded in time and size; it follows no redirection, which could carry a key elsewhere."""

import time
from collections.abc import Mapping
from dataclasses import dataclass
from http.client import HTTPException, HTTPResponse
from typing import Final
from urllib.request import HTTPErrorProcessor, Request, build_opener

__all__ = ["NoReply", "Reply", "post"]

MAX_BODY: Final = 64 * 2**20
CHUNK: Final = 2**16


@dataclass(frozen=True, slots=True)
class Reply:
    """What a server answered, whatever its status."""

    status: int
    body: bytes
    retry_after: float | None = None
    """For how long the server asks to be left alone, s."""


@dataclass(frozen=True, slots=True)
class NoReply:
    """Why nothing, or nothing whole, came back."""

    reason: str


class _AnyStatus(HTTPErrorProcessor):
    """Hands every reply on as it is: errors are data here, and redirections are not followed."""

    def http_response(self, request: Request, response: HTTPResponse) -> HTTPResponse:
        """Return the same."""
        del request
        return response

    https_response = http_response


def post(url: str, body: bytes, headers: Mapping[str, str], timeout: float) -> Reply | NoReply:
    """Send `body` as JSON. At most `timeout` seconds pass between two signs of life, and about as many in all.

    The reason for no reply is the kind of the error alone: its text may hold what was sent.
    """
    deadline = time.monotonic() + timeout
    request = Request(url, body, {"Content-Type": "application/json", "User-Agent": "sim2reason", **headers})  # noqa: S310
    try:
        with build_opener(_AnyStatus).open(request, timeout=timeout) as response:
            found = _read(response, deadline)
            if isinstance(found, str):
                return NoReply(found)
            return Reply(response.status, found, _seconds(response.headers.get("Retry-After")))
    except TimeoutError:
        return NoReply(f"no answer within {timeout:g} s")
    except (OSError, HTTPException, ValueError) as error:
        cause = getattr(error, "reason", None)
        if isinstance(cause, TimeoutError):
            return NoReply(f"no answer within {timeout:g} s")
        return NoReply(f"no connection ({type(cause if isinstance(cause, Exception) else error).__name__})")


def _read(response: HTTPResponse, deadline: float) -> bytes | str:
    """Return the whole body, or why not."""
    parts: list[bytes] = []
    size = 0
    while part := response.read1(CHUNK):
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
