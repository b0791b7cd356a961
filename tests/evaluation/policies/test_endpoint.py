"""Tests of an endpoint policy against a local server with the known faults of endpoints."""

import threading
import time
import traceback
from pathlib import Path
from typing import Any

import pytest

from faulty_endpoint import FAULTS, KEY, Said, answer, serving
from sim2reason.errors import PolicyError
from sim2reason.evaluation.policies import Completion, SampleRequest, build_policy
from sim2reason.evaluation.policies.endpoint import Endpoint
from sim2reason.evaluation.policies.network import delay
from sim2reason.evaluation.policies.samples import NoAnswerError

REQUEST = SampleRequest("a", 0, "How fast?", 5)


@pytest.fixture(autouse=True)
def key(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOME_KEY", KEY)


def policy(url: str, **settings: object) -> tuple[Endpoint, list[float]]:
    made = build_policy({"kind": "endpoint", "name": "p", "url": url, "model": "m", "key_from": "SOME_KEY", **settings})
    assert isinstance(made, Endpoint)
    waits: list[float] = []
    made._sleep = waits.append
    return made, waits


def asked(said: Said, **settings: object) -> Completion:
    with serving(lambda *_: said) as server:
        return policy(server.url, **settings)[0].complete([REQUEST])[0]


def test_a_request_says_what_is_wanted_and_asks_for_one_choice() -> None:
    with serving(lambda *_: Said(answer("9.8"))) as server:
        made, waits = policy(server.url, system="Be brief.", extra={"top_k": 3}, sampling={"temperature": 0.5})
        found = made.complete([REQUEST])[0]
    assert (found.text, found.finish, found.prompt_tokens, found.completion_tokens) == ("9.8", "stop", 11, 7)
    assert waits == []
    (sent,) = server.requests
    assert sent == {
        "model": "m",
        "messages": [{"role": "system", "content": "Be brief."}, {"role": "user", "content": "How fast?"}],
        "temperature": 0.5,
        "max_tokens": 4096,
        "seed": 5,
        "top_k": 3,
    }


@pytest.mark.parametrize("fault", list(FAULTS))
def test_a_fault_that_may_pass_is_asked_again_later(fault: str) -> None:
    with serving(lambda n, _, key: FAULTS[fault](key) if n < 2 else Said(answer("yes"))) as server:
        made, waits = policy(server.url)
        assert made.complete([REQUEST])[0].text == "yes"
    assert len(server.requests) == 3
    asked = 3.0 if fault == "busy" else None
    assert waits == [delay(0, 5, asked), delay(1, 5, asked)]


@pytest.mark.parametrize("fault", list(FAULTS))
def test_a_fault_that_stays_leaves_the_sample_open_and_names_no_key(fault: str) -> None:
    with (
        serving(lambda _, __, key: FAULTS[fault](key)) as server,
        pytest.raises(NoAnswerError, match="no answer after 3 attempts") as raised,
    ):
        policy(server.url, attempts=3)[0].complete([REQUEST])
    assert len(server.requests) == 3
    assert KEY not in "".join(traceback.format_exception(raised.value))
    assert "\n" not in str(raised.value)


@pytest.mark.parametrize("status", [401, 403, 404, 400, 302, 418])
def test_what_no_patience_mends_stops_the_run_and_names_no_key(status: int) -> None:
    with (
        serving(lambda _, __, key: Said({"error": {"message": f"bad key {key}"}}, status, {"Location": "/"})) as server,
        pytest.raises(PolicyError, match=f"status {status}") as raised,
    ):
        policy(server.url)[0].complete([REQUEST])
    assert len(server.requests) == 1
    assert not isinstance(raised.value, NoAnswerError)
    told = "".join(traceback.TracebackException.from_exception(raised.value, capture_locals=True).format())
    assert KEY not in told


def test_an_endpoint_that_refuses_a_seed_can_be_asked_without_one() -> None:
    with serving(lambda *_: Said(answer("9.8"))) as server:
        policy(server.url, send_seed=False)[0].complete([REQUEST])
    assert "seed" not in server.requests[0]


@pytest.mark.parametrize(
    ("body", "said"),
    [
        (
            {"detail": [{"loc": ["body", "seed"], "msg": "Extra inputs are not permitted", "type": "extra"}]},
            r"status 422: seed: Extra inputs are not permitted; set send_seed: false",
        ),
        (
            {"message": {"detail": [{"loc": ["body", "n"], "msg": "no"}]}, "object": "error"},
            r"status 422: n: no; see url",
        ),
        (
            {"error": {"message": "Use 'max_completion_tokens' instead.", "param": "max_tokens"}},
            r"max_tokens: Use .*max_completion_tokens' instead\.; set length_field",
        ),
        ({"error": {"message": "temperature must be 1"}}, r"set sampling: \{temperature: null\}"),
    ],
)
def test_why_a_request_is_refused_is_shown_with_what_to_set(body: dict[str, Any], said: str) -> None:
    with serving(lambda *_: Said(body, 422)) as server, pytest.raises(PolicyError, match=said):
        policy(server.url)[0].complete([REQUEST])


def test_an_answer_that_echoes_the_key_is_kept_without_it() -> None:
    with serving(lambda _, __, key: Said(answer(f"your key is {key}", reasoning_content=f"hm, {key}"))) as server:
        found = policy(server.url)[0].complete([REQUEST])[0]
    assert (found.text, found.thinking) == ("your key is ***", "hm, ***")
    assert found.whole == "<think>hm, ***</think>your key is ***"


@pytest.mark.parametrize(
    ("said", "text", "finish", "tokens"),
    [
        (answer(None), "", "stop", 7),
        (answer(None, "length", reasoning_content="so"), "", "length", 7),
        (answer("a", "length"), "a", "length", 7),
        (answer("a", "content_filter"), "a", "refused", 7),
        (answer(None, refusal="I can't."), "I can't.", "refused", 7),
        (answer("a", None), "a", "unknown", 7),
        (answer([{"type": "text", "text": "a"}, {"type": "text", "text": "b"}, 3]), "ab", "stop", 7),
        (answer("\ud800"), "?", "stop", 7),
        ({**answer("a"), "usage": None}, "a", "stop", None),
        ({**answer("a"), "usage": {"completion_tokens": "many"}}, "a", "stop", None),
        ({**answer("a"), "choices": [*answer("a")["choices"], *answer("b")["choices"]]}, "a", "stop", 7),
    ],
)
def test_answers_of_all_sorts_are_read(said: dict[str, Any], text: str, finish: str, tokens: int | None) -> None:
    found = asked(Said(said))
    assert (found.text, found.finish, found.completion_tokens) == (text, finish, tokens)


def test_a_prompt_beyond_the_context_is_an_end_and_no_error() -> None:
    said = {"error": {"code": 400, "message": "the request exceeds the available context size"}}
    assert asked(Said(said, 400)).finish == "overflow"


def test_a_silent_server_and_no_server_are_no_answer() -> None:
    end = threading.Event()

    def silent(*_: object) -> Said:
        end.wait(10.0)
        return Said()

    with serving(silent) as server:
        made, _ = policy(server.url, timeout=0.2, attempts=1)
        with pytest.raises(NoAnswerError, match=r"no answer within 0\.2 s"):
            made.complete([REQUEST])
        end.set()
    with pytest.raises(NoAnswerError, match="no connection"):
        made.complete([REQUEST])


def test_no_more_requests_are_in_flight_than_allowed(tmp_path: Path) -> None:
    from sim2reason.evaluation.policies.journal import SampleJournal
    from sim2reason.evaluation.policies.samples import ask, requests_for

    def slow(*_: object) -> Said:
        time.sleep(0.02)
        return Said(answer("yes"))

    with serving(slow) as server, SampleJournal(tmp_path / "j.jsonl") as journal:
        made, _ = policy(server.url, requests_in_flight=3)
        done = ask(made, requests_for([(str(n), "?") for n in range(10)], 2, 0), journal)
    assert done.finished_now == len(server.requests) == 20
    assert 1 < server.busiest <= 3
    assert len({sent["seed"] for sent in server.requests}) == 20


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"url": "ftp://a/b"}, "url: is no address"),
        ({"url": "http://a:99999/v1"}, "url: is no address"),
        ({"url": "http://a:0/v1"}, "url: is no address"),
        ({"url": "http://[::1/v1"}, "url: is no address"),
        ({"url": "http://a/v1\r\nX-Key: sk-1"}, "url: is no address: it has blanks, line feeds"),
        ({"url": "http://a/v1 "}, "url: is no address: it has blanks, line feeds"),
        ({"url": "http://user:sk-1@a/v1"}, "url: holds more than a plain address"),
        ({"key_from": "sk-live-abc"}, "key_from: is the name of an environment variable"),
        ({"api_key": "sk-live-abc"}, "api_key: no such setting"),
        ({"extra": {"n": 3}}, "extra.n has a setting of its own"),
        ({"sampling": {"temperature": -1}}, "sampling.temperature"),
        ({"model": None}, "model"),
        ({"requests_in_flight": 0}, "requests_in_flight"),
    ],
)
def test_settings_are_checked_in_one_line_that_repeats_no_value(settings: dict[str, object], message: str) -> None:
    with pytest.raises(PolicyError) as raised:
        policy("http://a/v1", **settings) if "url" not in settings else policy(str(settings["url"]))
    assert message in str(raised.value)
    assert "\n" not in str(raised.value)
    assert "sk-" not in "".join(traceback.format_exception(raised.value))


@pytest.mark.parametrize(
    ("where", "settings"),
    [
        ("model", {"model": KEY}),
        ("system", {"system": f"Your key is {KEY}."}),
        ("extra", {"extra": {"headers": [{"Authorization": f"Bearer {KEY}"}]}}),
        ("extra", {"extra": {KEY: 1}}),
        ("url", {"url": f"http://a/{KEY}/v1"}),
    ],
)
def test_settings_that_hold_the_key_are_refused_without_showing_it(where: str, settings: dict[str, Any]) -> None:
    with pytest.raises(PolicyError, match=f"{where} holds the key that is in the variable SOME_KEY") as raised:
        policy(**{"url": "http://a/v1", **settings})
    assert KEY not in "".join(traceback.format_exception(raised.value))
    assert "\n" not in str(raised.value)


def test_without_a_key_settings_may_hold_anything(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOME_KEY", " ")
    assert policy("http://a/v1", system="Be brief.")[0].system == "Be brief."
    assert policy("http://a/v1", key_from=None, system=KEY)[0].system == KEY


@pytest.mark.parametrize("held", ["", "two words", "line\nfeed", "ключ"])
def test_a_key_that_no_header_can_hold_is_refused_by_its_variable(held: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOME_KEY", held)
    with pytest.raises(PolicyError, match="variable SOME_KEY") as raised:
        policy("http://127.0.0.1:9/v1")[0].complete([REQUEST])
    assert not held or held not in str(raised.value)


def test_waits_grow_are_spread_and_are_the_same_every_time() -> None:
    waits = [delay(n, 3) for n in range(12)]
    assert waits == [delay(n, 3) for n in range(12)]
    assert all(0.5 * min(2.0**n, 60.0) <= wait <= min(2.0**n, 60.0) for n, wait in enumerate(waits))
    assert len({delay(3, seed) for seed in range(50)}) == 50
    assert delay(0, 3, 20.0) == 20.0
    assert delay(0, 3, 1e9) == 300.0
