"""Parser of replies of OpenAI-compatible endpoints, including their known defects."""

import json
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Final, Literal, cast

from sim2reason.evaluation.policies import Completion, Finish
from sim2reason.evaluation.policies.parts.http import NoReply, Reply

__all__ = ["Fault", "read"]

SHOWN: Final = 200  # characters of an endpoint's error message
BUSY: Final = {408, 409, 425, 429, 500, 502, 503, 504, 520, 521, 522, 523, 524, 529}
REFUSES_KEY: Final = {401, 403}
REFUSES_PROMPT: Final = {400, 413, 422}
FINISHES: Final[dict[str, Finish]] = {
    "stop": "stop",
    "eos": "stop",
    "length": "length",
    "max_tokens": "length",
    "content_filter": "refused",
}
_FIELDS: Final = {
    r"\bseed\b": "set send_seed: false",
    r"\bmax_(?:completion_)?tokens\b": "set length_field to the other of max_tokens and max_completion_tokens",
    r"\btemperature\b": "set sampling: {temperature: null}",
    r"\btop_p\b": "set sampling: {top_p: null}",
}
"""What to set where an endpoint refuses a field, by the field."""
_CONTEXT: Final = ("context_length", "context length", "context size", "context window", "maximum context")


@dataclass(frozen=True, slots=True)
class Fault:
    """A failed reply: `again` if a retry may succeed, `stop` if no other request would succeed either."""

    reason: str
    what: Literal["again", "stop"]
    wait: float | None = None
    """For how long the server asks to be left alone, s."""


def read(reply: Reply | NoReply, hidden: Callable[[str], str]) -> Completion | Fault:
    """Return the completion in a reply, or its fault; `hidden` removes keys from recorded text."""
    if isinstance(reply, NoReply):
        return Fault(reply.reason, "again")
    if reply.status != 200:
        return _refusal(reply, hidden)
    found = _json(reply.body)
    if found is None:
        return Fault("status 200 with a page that is no JSON object", "again")
    if found.get("error"):
        return Fault(f"status 200 with an error{_said(found, hidden)}", "again")
    choices = found.get("choices")
    first = cast("list[object]", choices)[0] if isinstance(choices, list) and choices else None
    if not isinstance(first, dict):
        return Fault("status 200 without a choice", "again")
    return _completion(cast("dict[str, Any]", first), found.get("usage"), hidden)


def _completion(choice: Mapping[str, Any], usage: object, hidden: Callable[[str], str]) -> Completion | Fault:
    message: object = choice.get("message")
    if not isinstance(message, dict):
        return Fault("status 200 with a choice without a message", "again")
    fields = cast("dict[str, object]", message)
    said, refusal = _text(fields.get("content")), _text(fields.get("refusal"))
    finish: Finish = "refused" if refusal else FINISHES.get(str(choice.get("finish_reason")), "unknown")
    counts = cast("dict[str, object]", usage) if isinstance(usage, dict) else {}
    return Completion(
        text=hidden(_whole(said or refusal)),
        finish=finish,
        thinking=hidden(_whole(_text(fields.get("reasoning_content")) or _text(fields.get("reasoning")))),
        prompt_tokens=_count(counts.get("prompt_tokens")),
        completion_tokens=_count(counts.get("completion_tokens")),
    )


def _refusal(reply: Reply, hidden: Callable[[str], str]) -> Completion | Fault:
    """Return what an endpoint's error status means: a fault, or a completion for a prompt that is too long."""
    found = _json(reply.body) or {}
    said = _said(found, hidden)
    if reply.status in BUSY:
        return Fault(f"status {reply.status}{said}", "again", reply.retry_after)
    if reply.status in REFUSES_KEY:
        return Fault(f"status {reply.status}: it refuses the key, or the lack of one; see key_from", "stop")
    if reply.status in REFUSES_PROMPT and any(mark in json.dumps(found).lower() for mark in _CONTEXT):
        return Completion(text="", finish="overflow")
    if 300 <= reply.status < 400:
        return Fault(f"status {reply.status}: it sends us elsewhere; give the final address as url", "stop")
    return Fault(f"status {reply.status}{said}; {_remedy(reply.status, said)}", "stop")


def _remedy(status: int, said: str) -> str:
    """Return advice on settings after an endpoint rejected a request."""
    found = [remedy for field, remedy in _FIELDS.items() if status in REFUSES_PROMPT and re.search(field, said)]
    return found[0] if found else "see url, model and extra" if status in REFUSES_PROMPT else "see url and model"


def _said(found: Mapping[str, object], hidden: Callable[[str], str]) -> str:
    """Return the endpoint's error message after a colon."""
    text = _reason(found.get("error", found.get("message", found.get("detail"))))
    line = " ".join(hidden(_whole(text)).split())[:SHOWN]
    return f": {line}" if line else ""


def _reason(error: object, depth: int = 4) -> str:
    """Return the message of an endpoint's error, or the messages of several errors, each with the field concerned."""
    if isinstance(error, str):
        return error
    if isinstance(error, list) and depth:
        return "; ".join(filter(None, (_reason(each, depth - 1) for each in cast("list[object]", error)[:4])))
    if not isinstance(error, dict) or not depth:
        return ""
    fields = cast("dict[str, object]", error)
    held = next((fields[name] for name in ("message", "msg", "detail") if fields.get(name)), "")
    place = fields.get("loc", fields.get("param"))
    parts = cast("list[object]", place) if isinstance(place, list) else [place] if isinstance(place, str) else []
    said = _reason(held, depth - 1)
    named = ".".join(str(part) for part in parts if part != "body")
    return f"{named}: {said}" if named and not re.search(rf"\b{re.escape(named)}\b", said) else said


def _json(body: bytes) -> dict[str, object] | None:
    try:
        found = json.loads(body)
    except (ValueError, RecursionError):
        return None
    return cast("dict[str, object]", found) if isinstance(found, dict) else None


def _text(content: object) -> str:
    """Return a text, or the joined texts of a list of parts; empty for anything else."""
    if isinstance(content, str):
        return content
    if isinstance(content, list):
        parts = cast("list[object]", content)
        return "".join(_text(cast("dict[str, object]", part).get("text")) for part in parts if isinstance(part, dict))
    return ""


def _whole(text: str) -> str:
    """Return the text with unpaired surrogates replaced, because UTF-8 files cannot contain them."""
    return text.encode(errors="replace").decode()


def _count(value: object) -> int | None:
    return value if isinstance(value, int) and not isinstance(value, bool) and value >= 0 else None
