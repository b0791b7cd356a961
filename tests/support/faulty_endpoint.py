"""Local OpenAI-compatible endpoint with the typical faults of endpoints."""

import json
import sys
import threading
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

KEY = "sk-test-7Kq0secret/+=9"


def answer(text: object, finish: object = "stop", **message: object) -> dict[str, Any]:
    """Return a complete answer with its usage."""
    return {
        "choices": [
            {"index": 0, "message": {"role": "assistant", "content": text, **message}, "finish_reason": finish}
        ],
        "usage": {"prompt_tokens": 11, "completion_tokens": 7, "total_tokens": 18},
    }


@dataclass
class Said:
    """Response of the server to one request."""

    body: bytes | dict[str, Any] = b""
    status: int = 200
    headers: dict[str, str] = field(default_factory=dict[str, str])
    announced: int | None = None  # bytes, if not as many as there are


FAULTS: dict[str, Callable[[str], Said]] = {
    "html": lambda _: Said(b"<!doctype html><h1>Bad gateway</h1>", headers={"Content-Type": "text/html"}),
    "no choices": lambda _: Said({"choices": []}),
    "no message": lambda _: Said({"choices": [{"finish_reason": "stop"}]}),
    "error in 200": lambda key: Said({"error": {"message": f"upstream is down, key {key}"}}),
    "busy": lambda _: Said({"error": {"message": "slow down"}}, 429, {"Retry-After": "3"}),
    "broken": lambda key: Said(f"oops {key}".encode(), 500),
    "breaks off": lambda _: Said(b'{"choices": [{"mess', announced=4000),
    "no json": lambda _: Said(b'{"choices": [{'),
    "null": lambda _: Said(b"null"),
}
"""Faults after which it is worth asking again; each is told the key that came with the request."""

Behaviour = Callable[[int, dict[str, Any], str], Said]
"""What to do with the n-th request, its fields and the key that came with it."""


@dataclass
class Endpoint:
    """Running server."""

    url: str
    requests: list[dict[str, Any]] = field(default_factory=list[dict[str, Any]])
    busiest: int = 0


@contextmanager
def serving(behaviour: Behaviour) -> Generator[Endpoint, None, None]:
    """Serve on a free port within the context."""
    lock, running = threading.Lock(), [0]

    class Handler(BaseHTTPRequestHandler):
        def do_POST(self) -> None:
            fields = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
            with lock:
                number = len(endpoint.requests)
                endpoint.requests.append(fields)
                running[0] += 1
                endpoint.busiest = max(endpoint.busiest, running[0])
            try:
                said = behaviour(number, fields, self.headers.get("Authorization", "").removeprefix("Bearer "))
            finally:
                with lock:
                    running[0] -= 1
            body = said.body if isinstance(said.body, bytes) else json.dumps(said.body).encode()
            try:
                self.send_response(said.status)
                for name, value in said.headers.items():
                    self.send_header(name, value)
                self.send_header("Content-Length", str(said.announced or len(body)))
                self.end_headers()
                self.wfile.write(body)
            except (BrokenPipeError, ConnectionResetError):
                pass  # whoever asked was killed

        def log_message(self, format: str, *args: object) -> None:  # noqa: A002 - its name in the library
            del format, args

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    server.daemon_threads = True
    endpoint = Endpoint(f"http://127.0.0.1:{server.server_address[1]}/v1")
    thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.02}, daemon=True)
    thread.start()
    try:
        yield endpoint
    finally:
        server.shutdown()
        server.server_close()
        thread.join()


def _main(log: str) -> None:
    """Serve until killed, faults first and then answers, and append a line per complete answer to the file `log`.

    The first line printed is the address. The response depends on the prompt and on the number of earlier requests
    for it, so that every fault occurs and no request fails forever.
    """
    seen: dict[str, int] = {}
    lock, faults = threading.Lock(), [*FAULTS.values()]
    variants: list[Callable[[str], dict[str, Any]]] = [
        lambda _: answer(r"So \boxed{9.81}"),
        lambda key: answer(f"your key {key} is fine", "length"),
        lambda _: answer(None),
        lambda _: answer(None, refusal="I can't help with that."),
        lambda _: {**answer("no box"), "usage": None},
        lambda _: answer(r"\boxed{-1}"),
    ]

    def behaviour(_: int, fields: dict[str, Any], key: str) -> Said:
        name = f"{fields['messages'][-1]['content']} {fields['seed']}"
        with lock:
            times = seen[name] = seen.get(name, 0) + 1
        kind = sum(name.encode())
        if times <= kind % 3:
            return faults[(kind + times) % len(faults)](key)
        time.sleep(0.005)
        with lock, Path(log).open("a", encoding="utf-8") as file:
            file.write(json.dumps([fields["messages"][-1]["content"], fields["seed"]]) + "\n")
        return Said(variants[kind % len(variants)](key))

    with serving(behaviour) as endpoint:
        sys.stdout.write(f"{endpoint.url}\n")
        sys.stdout.flush()
        threading.Event().wait()


if __name__ == "__main__":
    _main(sys.argv[1])
