"""Policies behind an OpenAI-compatible endpoint: vLLM, llama.cpp, or any provider.

It uses only the standard library: no request is logged, and evaluation needs no further package. A request asks for one
choice, since some endpoints answer n = 3 with one; k samples are k requests with k seeds.
"""

import json
import os
import time
from collections.abc import Callable, Sequence
from typing import Annotated, ClassVar, Literal, Self
from urllib.parse import urlsplit

from annotated_types import Ge, Gt, Le
from pydantic import Field, FiniteFloat, JsonValue, PrivateAttr, field_validator, model_validator

from sim2reason.base.records import cached_property
from sim2reason.errors import PolicyError
from sim2reason.evaluation.policies import POLICIES, Completion, Policy, SampleRequest
from sim2reason.evaluation.policies.parts.chat_answers import Fault, read
from sim2reason.evaluation.policies.parts.http import PRINTABLE, VARIABLE, Secret, delay, from_environment, post
from sim2reason.evaluation.policies.samples import NoAnswerError

__all__ = ["Endpoint"]

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
        return from_environment(self.key_from)

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
            found = read(post(f"{self.url}/chat/completions", body, key.headers(), self.timeout), key.hidden)
            if isinstance(found, Completion):
                return found
            if found.what == "stop":
                raise PolicyError(f"policy {self.name!r} at {self.url}: {found.reason}")
            last = found
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
