"""Tests of grading whole files, with the adapter for items and the command."""

import json
from collections.abc import Iterator
from pathlib import Path

import pytest
from click.testing import CliRunner

from fake_makers import steady
from sim2reason.cli import main
from sim2reason.cli.evaluation import grade_command
from sim2reason.datasets.build import build
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.grade import GradedResponse, Response, Tallies, grade, grade_all, line, responses
from sim2reason.datasets.plan import Config
from sim2reason.errors import DatasetError
from sim2reason.generation.item import Item
from sim2reason.generation.request import Request


@pytest.fixture
def item() -> Item:
    made = steady(Request("pulley", "easy", "numeric", 0, 1)).item
    assert made is not None
    return made


@pytest.fixture
def data(tmp_path: Path) -> Path:
    config = Config(items=8, recipes=("pulley",), difficulties=("easy",), maker="fake_makers:steady")
    build(tmp_path / "data", config, workers=1)
    return tmp_path / "data"


@pytest.fixture
def said(tmp_path: Path, data: Path) -> Path:
    """Write responses that are right, in another unit, in a wrong unit and without a box, two items of each."""
    answers = [r"\boxed{%r}", r"\boxed{%r \text{ kg m/s}^2}", r"\boxed{%r \text{ m}}", "%r"]
    lines = [
        json.dumps({"id": item.id, "response": answers[i % 4] % item.answer.value, "sample": 0})
        for i, item in enumerate(Dataset(data))
    ]
    (tmp_path / "said.jsonl").write_text("\n".join(lines) + "\n\n", encoding="utf-8")
    return tmp_path / "said.jsonl"


def read(path: Path) -> list[Response]:
    with path.open("rb") as file:
        return list(responses(file, str(path)))


def test_a_list_of_texts_is_as_many_responses_and_a_list_of_messages_one(tmp_path: Path) -> None:
    messages = [{"role": "user", "content": "?"}, {"role": "assistant", "content": r"\boxed{1}"}]
    held = [[r"\boxed{1}", r"\boxed{2}", "none"], messages, []]
    path = tmp_path / "said.jsonl"
    path.write_text("\n".join(json.dumps({"id": "a", "response": each}) for each in held), encoding="utf-8")
    assert [found.response for found in read(path)] == [*held[0], messages, []]


def test_thinking_that_the_prompt_opened_is_no_answer(item: Item, data: Path, tmp_path: Path) -> None:
    cut_off = rf"We get \boxed{{{item.answer.value!r}}}, but"
    assert grade(item, cut_off).reward
    assert grade(item, cut_off, thinking_opened=True).outcome == "no answer"
    assert grade(item, f"{cut_off} yes.</think>{cut_off}", thinking_opened=True).reward
    first = next(iter(Dataset(data)))
    path = tmp_path / "said.jsonl"
    path.write_text(json.dumps({"id": first.id, "response": rf"\boxed{{{first.answer.value!r}}}"}), encoding="utf-8")
    arguments = ["grade", str(data), "--responses", str(path), "--json"]
    for more, paid in ([], 1.0), (["--thinking-opened"], 0.0):
        assert json.loads(CliRunner().invoke(main, [*arguments, *more]).stdout)[0]["reward"] == paid


def test_an_item_is_graded_in_its_unit_and_tolerance(item: Item) -> None:
    value = item.answer.value
    assert grade(item, rf"\boxed{{{value!r}}}").reward
    assert grade(item, rf"\boxed{{{value / 1000!r}\text{{ kN}}}}").reward
    assert not grade(item, rf"\boxed{{{value!r}\text{{ kN}}}}").reward
    assert not grade(item, f"{value!r} N").reward
    assert grade(item, f"{value!r} N", lenient=True).reward
    strict = item.model_copy(update={"answer": item.answer.model_copy(update={"tolerance": 0.001})})
    assert not grade(strict, rf"\boxed{{{1.01 * value!r}}}").reward


def test_tallies_by_recipe_and_kind(item: Item) -> None:
    tallies = Tallies()
    for text in (rf"\boxed{{{item.answer.value!r}}}", r"\boxed{0}", ""):
        tallies.add(GradedResponse(Response(id=item.id, response=text), grade(item, text), item.recipe, item.kind))
    rows = list(tallies)
    assert [(row.by, row.name) for row in rows] == [("all", ""), ("recipe", "pulley"), ("kind", "state")]
    assert all(row.responses == 3 and row.reward == pytest.approx(1 / 3) for row in rows)
    assert rows[0].outcomes == {
        "correct": 1, "wrong": 1, "wrong unit": 0, "no answer": 1, "unreadable": 0, "too long": 0,
    }  # fmt: skip
    assert list(Tallies()) == []


def test_the_command_writes_scores_and_a_summary(data: Path, said: Path, tmp_path: Path) -> None:
    scores = tmp_path / "scores.jsonl"
    result = CliRunner().invoke(grade_command, [str(data), "--responses", str(said), "-o", str(scores)])
    assert result.exit_code == 0, result.output
    assert "wrong unit" in result.output
    assert "0.500" in result.output
    lines = [json.loads(line) for line in scores.read_text(encoding="utf-8").splitlines()]
    assert [line["outcome"] for line in lines[:4]] == ["correct", "correct", "wrong unit", "no answer"]
    assert set(lines[0]) == {"id", "reward", "outcome", "parsed", "why"}


def test_the_command_speaks_json(data: Path, said: Path) -> None:
    result = CliRunner().invoke(grade_command, [str(data), "--responses", str(said), "--json", "--lenient"])
    rows = json.loads(result.output)
    assert rows[0]["by"] == "all"
    assert rows[0]["reward"] == 0.75
    assert sum(rows[0]["outcomes"].values()) == rows[0]["responses"] == 8


def test_what_a_policy_said_may_be_anything(item: Item, tmp_path: Path) -> None:
    right = rf"\boxed{{{item.answer.value!r}}}"
    said = [right, [{"role": "assistant", "content": right}], None, 3, [], {"a": [None]}, "\ud800" + right, "\ud800"]
    path = tmp_path / "said.jsonl"
    path.write_text("".join(json.dumps({"id": item.id, "response": each}) + "\n" for each in said), encoding="utf-8")
    scored = [(response, grade(item, response.response)) for response in read(path)]
    assert [score.reward for _, score in scored] == [1, 1, 0, 0, 0, 0, 1, 0]
    assert all(line(*pair).encode() for pair in scored), "a half of a surrogate pair can be written to no file"


@pytest.mark.parametrize("bad", ["{", '{"id": "x"}', '{"id": 3, "response": "x"}', '["x"]', '{"response": "x"}'])
def test_a_bad_line_is_named(bad: str, tmp_path: Path) -> None:
    path = tmp_path / "said.jsonl"
    path.write_text('{"id": "x", "response": ""}\n' + bad + "\n", encoding="utf-8")
    with pytest.raises(DatasetError, match=r"said\.jsonl:2: .*a line is"):
        read(path)


def test_an_unknown_id_is_an_error(data: Path, said: Path) -> None:
    said.write_text(Response(id="nobody", response="").model_dump_json(), encoding="utf-8")
    result = CliRunner().invoke(grade_command, [str(data), "--responses", str(said)])
    assert isinstance(result.exception, DatasetError)
    assert "'nobody' is no item of" in str(result.exception)


def test_splits_are_graded_alone(tmp_path: Path) -> None:
    shares = {"train": 0.6, "test": 0.4}
    config = Config(items=20, recipes=("pulley",), difficulties=("easy",), maker="fake_makers:steady", split=shares)
    build(tmp_path / "data", config, workers=1)
    data, given = Dataset(tmp_path / "data"), tmp_path / "given.jsonl"
    lines = {name: [f'{{"id": "{item.id}", "response": ""}}' for item in data.items(name)] for name in shares}
    given.write_text("\n".join([*lines["train"], *lines["test"]]), encoding="utf-8")
    for name, mine in lines.items():
        args = [str(data.path), "--responses", str(given), "--split", name, "--json"]
        assert json.loads(CliRunner().invoke(grade_command, args).stdout)[0]["responses"] == len(mine) > 0
    given.write_text("\n".join(lines["train"]), encoding="utf-8")
    args = ["grade", str(data.path), "--responses", str(given), "--split"]
    for name, told in (
        ("test", "no response is to a problem of test; give another --split"),
        ("dev", "has no split 'dev'"),
    ):
        result = CliRunner().invoke(main, [*args, name])
        assert (result.exit_code, result.stderr.count("\n")) == (2, 1)
        assert told in result.stderr


def test_an_unknown_id_is_no_page(data: Path, said: Path) -> None:
    said.write_text(json.dumps({"id": "\ud800" + "x" * 1_000_000, "response": ""}), encoding="utf-8")
    result = CliRunner().invoke(main, ["grade", str(data), "--responses", str(said)])
    assert result.exit_code == 2
    assert len(result.stderr) < 300


@pytest.mark.parametrize("content", [b"\xff\xfe\x00binary", b"", b"\n\n", b"[1]"])
def test_a_file_without_responses_is_one_line(data: Path, tmp_path: Path, content: bytes) -> None:
    (tmp_path / "said.jsonl").write_bytes(content)
    result = CliRunner().invoke(main, ["grade", str(data), "--responses", str(tmp_path / "said.jsonl")])
    assert result.exit_code == 2
    assert result.stderr.count("\n") == 1
    assert "said.jsonl" in result.stderr


def test_dashes_are_standard_input_and_output(data: Path, said: Path) -> None:
    usual = CliRunner().invoke(main, ["grade", str(data), "--responses", str(said)])
    piped = CliRunner().invoke(main, ["grade", str(data), "--responses", "-", "-o", "-"], input=said.read_bytes())
    assert piped.exit_code == 0, piped.output
    assert piped.stderr == usual.stdout
    assert [json.loads(line)["id"] for line in piped.stdout.splitlines()] == [item.id for item in Dataset(data)]
    both = CliRunner().invoke(main, ["grade", str(data), "--responses", str(said), "-o", "-", "--json"])
    assert (both.exit_code, both.stderr.count("\n")) == (2, 1)


def test_responses_are_held_a_few_at_a_time(data: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Responses are graded in batches of bounded size and in order; each file is read once per batch."""
    monkeypatch.setattr("sim2reason.datasets.grade.TOGETHER", (3, 10**6))
    opened, names = Dataset(data), [item.id for item in Dataset(data)]
    given = (Response(id=names[k % 8], response=str(k)) for k in range(100))
    taken, out = 0, list[str]()

    def counted() -> Iterator[Response]:
        nonlocal taken
        for response in given:
            taken += 1
            yield response

    for found in grade_all(opened, counted()):
        out.append(str(found.response.response))
        assert taken <= len(out) + 3
    assert out == [str(k) for k in range(100)]


def test_a_failure_leaves_no_scores(data: Path, said: Path, tmp_path: Path) -> None:
    with said.open("a", encoding="utf-8") as file:
        file.write('{"id": "nobody", "response": ""}')
    result = CliRunner().invoke(main, ["grade", str(data), "--responses", str(said), "-o", str(tmp_path / "scores")])
    assert result.exit_code == 2
    assert sorted(path.name for path in tmp_path.iterdir()) == ["data", "said.jsonl"]
