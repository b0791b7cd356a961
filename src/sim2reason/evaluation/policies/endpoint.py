"""Policies behind an OpenAI-compatible endpoint: vLLM, llama.cpp, or any provider.

It uses only the standard library: no request is logged, and evaluation needs no further package. A request asks for one
choice, since some endpoints answer n = 3 with one; k samples are k requests with k seeds. The parser of replies allows
for known defects of endpoints.
"""

import json
import os
import re
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Final, Literal, Self, cast
from urllib.parse import urlsplit

from annotated_types import Ge, Gt, Le
from pydantic import Field, FiniteFloat, JsonValue, PrivateAttr, field_validator, model_validator

from sim2reason.base.records import cached_property
from sim2reason.errors import PolicyError
from sim2reason.evaluation.policies import POLICIES, Completion, Finish, Policy, SampleRequest
from sim2reason.evaluation.policies.network import (
    PRINTABLE,
    VARIABLE,
    NoReply,
    Reply,
    Secret,
    delay,
    post,
    read_secret,
)
from sim2reason.evaluation.policies.samples import NoAnswerError

__all__ = ["Endpoint", "Fault", "read"]

MAX_MESSAGE_LENGTH: Final = 200  # characters of an endpoint's error message
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
    payload = _json(reply.body)
    if payload is None:
        return Fault("status 200 with a page that is no JSON object", "again")
    if payload.get("error"):
        return Fault(f"status 200 with an error{_error_message(payload, hidden)}", "again")
    choices = payload.get("choices")
    first = cast("list[object]", choices)[0] if isinstance(choices, list) and choices else None
    if not isinstance(first, dict):
        return Fault("status 200 without a choice", "again")
    return _completion(cast("dict[str, Any]", first), payload.get("usage"), hidden)


def _completion(choice: Mapping[str, Any], usage: object, hidden: Callable[[str], str]) -> Completion | Fault:
    message: object = choice.get("message")
    if not isinstance(message, dict):
        return Fault("status 200 with a choice without a message", "again")
    fields = cast("dict[str, object]", message)
    content, refusal = _text(fields.get("content")), _text(fields.get("refusal"))
    finish: Finish = "refused" if refusal else FINISHES.get(str(choice.get("finish_reason")), "unknown")
    counts = cast("dict[str, object]", usage) if isinstance(usage, dict) else {}
    return Completion(
        text=hidden(_replace_surrogates(content or refusal)),
        finish=finish,
        thinking=hidden(_replace_surrogates(_text(fields.get("reasoning_content")) or _text(fields.get("reasoning")))),
        prompt_tokens=_count(counts.get("prompt_tokens")),
        completion_tokens=_count(counts.get("completion_tokens")),
    )


def _refusal(reply: Reply, hidden: Callable[[str], str]) -> Completion | Fault:
    """Return what an endpoint's error status means: a fault, or a completion for a prompt that is too long."""
    payload = _json(reply.body) or {}
    message = _error_message(payload, hidden)
    if reply.status in BUSY:
        return Fault(f"status {reply.status}{message}", "again", reply.retry_after)
    if reply.status in REFUSES_KEY:
        return Fault(f"status {reply.status}: it refuses the key, or the lack of one; see key_from", "stop")
    if reply.status in REFUSES_PROMPT and any(mark in json.dumps(payload).lower() for mark in _CONTEXT):
        return Completion(text="", finish="overflow")
    if 300 <= reply.status < 400:
        return Fault(f"status {reply.status}: it sends us elsewhere; give the final address as url", "stop")
    return Fault(f"status {reply.status}{message}; {_remedy(reply.status, message)}", "stop")


def _remedy(status: int, message: str) -> str:
    """Return advice on settings after an endpoint rejected a request."""
    remedies = [remedy for field, remedy in _FIELDS.items() if status in REFUSES_PROMPT and re.search(field, message)]
    return remedies[0] if remedies else "see url, model and extra" if status in REFUSES_PROMPT else "see url and model"


def _error_message(payload: Mapping[str, object], hidden: Callable[[str], str]) -> str:
    """Return the endpoint's error message after a colon."""
    text = _reason(payload.get("error", payload.get("message", payload.get("detail"))))
    line = " ".join(hidden(_replace_surrogates(text)).split())[:MAX_MESSAGE_LENGTH]
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
    nested = next((fields[name] for name in ("message", "msg", "detail") if fields.get(name)), "")
    location = fields.get("loc", fields.get("param"))
    parts = (
        cast("list[object]", location)
        if isinstance(location, list)
        else [location]
        if isinstance(location, str)
        else []
    )
    message = _reason(nested, depth - 1)
    named = ".".join(str(part) for part in parts if part != "body")
    return f"{named}: {message}" if named and not re.search(rf"\b{re.escape(named)}\b", message) else message


def _json(body: bytes) -> dict[str, object] | None:
    try:
        payload = json.loads(body)
    except (ValueError, RecursionError):
        return None
    return cast("dict[str, object]", payload) if isinstance(payload, dict) else None


def _text(content: object) -> str:
    """Return a text, or the joined texts of a list of parts; empty for anything else."""
    if isinstance(content, str):
        return content
    if isinstance(content, list):
        parts = cast("list[object]", content)
        return "".join(_text(cast("dict[str, object]", part).get("text")) for part in parts if isinstance(part, dict))
    return ""


def _replace_surrogates(text: str) -> str:
    """Return the text with unpaired surrogates replaced, because UTF-8 files cannot contain them."""
    return text.encode(errors="replace").decode()


def _count(value: object) -> int | None:
    return value if isinstance(value, int) and not isinstance(value, bool) and value >= 0 else None


OURS = {"model", "messages", "n", "stream", "seed", "temperature", "top_p", "max_tokens", "max_completion_tokens"}


@POLICIES.register("endpoint")
class Endpoint(Policy):
    """A model behind an OpenAI-compatible endpoint."""

    url: str
    """Up to and without ``/chat/completions``, as in ``http://127.0.0.1:8000/v1``."""
    model: str
    key_from: str | None = None
    """The environment variable that holds the key."""
    system: str = ""
    """A message before the prompt."""
    timeout: Annotated[FiniteFloat, Gt(0.0), Le(86_400.0)] = 600.0
    """For one answer, s."""
    attempts: Annotated[int, Ge(1), Le(100)] = 6
    """How often one sample is asked for before it is left open."""
    requests_in_flight: Annotated[int, Ge(1), Le(1024)] = 8
    length_field: Literal["max_tokens", "max_completion_tokens"] = "max_tokens"
    """What the endpoint calls the limit on a response."""
    send_seed: bool = True
    """Whether requests have a seed; some endpoints refuse one. Without it, no sample can be drawn again."""
    extra: dict[str, JsonValue] = Field(default_factory=dict[str, JsonValue])
    """Further fields of each request, such as ``chat_template_kwargs``; they are written down with the results."""

    operational: ClassVar[frozenset[str]] = Policy.operational | {
        "url",  # a server comes back elsewhere; what it serves is named by `model`
        "timeout",
        "attempts",
        "requests_in_flight",
        "key_from",
    }

    _sleep: Callable[[float], object] = PrivateAttr(default_factory=lambda: time.sleep)

    @field_validator("url")
    @classmethod
    def _plain(cls, value: str) -> str:
        if not PRINTABLE.fullmatch(value):  # urlsplit would take a line feed out in silence
            raise ValueError("is no address: it has blanks, line feeds or letters beyond ASCII; write it without them")
        try:
            parts = urlsplit(value)
            port = parts.port
        except ValueError:  # brackets that do not match, or a port beyond 65535
            parts, port = urlsplit(""), 0
        if parts.scheme not in {"http", "https"} or not parts.hostname or port == 0:
            raise ValueError("is no address; give one that begins with http:// or https://, with a port up to 65535")
        if "@" in parts.netloc or parts.query or parts.fragment:
            raise ValueError("holds more than a plain address; a key belongs into the variable that key_from names")
        return value.rstrip("/").removesuffix("/chat/completions")

    @field_validator("key_from")
    @classmethod
    def _variable(cls, value: str | None) -> str | None:
        if value is not None and not VARIABLE.fullmatch(value):
            raise ValueError("is the name of an environment variable, such as OPENAI_API_KEY, never the key itself")
        return value

    @model_validator(mode="after")
    def _nothing_twice(self) -> Self:
        if twice := sorted(OURS & self.extra.keys()):
            raise ValueError(f"extra.{twice[0]} has a setting of its own")
        return self

    @model_validator(mode="after")
    def _no_key(self) -> Self:
        """Reject settings that contain the key itself, because settings are recorded and shown."""
        key = Secret() if self.key_from is None else Secret(os.environ.get(self.key_from, "").strip())
        for name, value in self.model_dump(mode="json", exclude={"key_from"}).items():
            if key.occurs_in(value):
                raise ValueError(f"{name} holds the key that is in the variable {self.key_from}; take it out there")
        return self

    @property
    def in_flight(self) -> int:
        """Return `requests_in_flight`."""
        return self.requests_in_flight

    @cached_property
    def _key(self) -> Secret:
        return read_secret(self.key_from)

    def check(self) -> None:
        """Read the key; the endpoint itself may start later."""
        _ = self._key

    def complete(self, requests: Sequence[SampleRequest]) -> Sequence[Completion]:
        """Return the completions one after another, with increasing delays between retries."""
        return [self._complete(request) for request in requests]

    def _complete(self, request: SampleRequest) -> Completion:
        body, key = self._body(request), self._key
        last = Fault("", "again")
        for attempt in range(self.attempts):
            if attempt:
                self._sleep(delay(attempt - 1, request.seed, last.wait))
            outcome = read(post(f"{self.url}/chat/completions", body, key.headers(), self.timeout), key.hidden)
            if isinstance(outcome, Completion):
                return outcome
            if outcome.what == "stop":
                raise PolicyError(f"policy {self.name!r} at {self.url}: {outcome.reason}")
            last = outcome
        raise NoAnswerError(
            f"policy {self.name!r} at {self.url}: no answer after {self.attempts} attempts; the last was {last.reason}"
        )

    def _body(self, request: SampleRequest) -> bytes:
        system = [{"role": "system", "content": self.system}] if self.system else []
        drawn = {"temperature": self.sampling.temperature, "top_p": self.sampling.top_p}
        fields = {
            "model": self.model,
            "messages": [*system, {"role": "user", "content": request.prompt}],
            **{name: value for name, value in drawn.items() if value is not None},
            self.length_field: self.sampling.max_tokens,
            **({"seed": request.seed} if self.send_seed else {}),
            **self.extra,
        }
        return json.dumps(fields).encode()
