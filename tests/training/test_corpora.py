"""Tests of corpora: rows of datasets, samples and files, mixed by weight and tokenized."""

import json
from collections import Counter
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest

from sim2reason.datasets.generate import generate
from sim2reason.errors import DatasetError, TrainingError, UnknownNameError
from sim2reason.grading import Outcome
from sim2reason.training.corpora import Row, build_corpus
from sim2reason.training.corpora.rows import EncodedRow, Limits, apply_template, encode_rows, encoded_table, mix_corpora

installed = pytest.mark.skipif(
    not all(map(find_spec, ("torch", "transformers", "tokenizers", "accelerate"))),
    reason="needs the libraries of the extra [train]",
)

Tokenizer = Any  # of the transformers library


def lines(path: Path, count: int, name: str = "row") -> dict[str, object]:
    """Write a file of rows and return the settings of a corpus with it."""
    path.write_text("".join(f"{json.dumps({'q': f'{name} {n}?', 'a': f'{n}.'})}\n" for n in range(count)))
    return {"kind": "jsonl", "file": str(path), "prompt": "q", "completion": "a"}


FRESH = {"name": "drawn", "seed": 1}


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({}, "corpora[0].kind: give one of arithmetic, "),
        ({"kind": "jsonl"}, "corpora[0].file: is missing"),
        ({"kind": "jsonl", "file": "a", "weight": 0}, "corpora[0].weight"),
        ({"kind": "jsonl", "file": "a", "weight": float("nan")}, "corpora[0].weight"),
        ({"kind": "jsonl", "file": "a", "weight": 1e9}, "corpora[0].weight"),
        ({"kind": "jsonl", "file": "a", "limit": 0}, "corpora[0].limit"),
        ({"kind": "jsonl", "file": "a", "fields": "a"}, "corpora[0].fields: no such setting"),
        ({"kind": "worked"}, "give either dataset, a folder, or problems"),
        ({"kind": "worked", "problems": FRESH, "dataset": "a"}, "give either dataset, a folder, or problems"),
        ({"kind": "worked", "dataset": "a", "items": 9}, "items is of problems that are drawn; of a dataset say limit"),
        ({"kind": "worked", "problems": FRESH, "split": "train"}, "split is one of a dataset"),
        ({"kind": "worked", "problems": {"name": "a", "seed": -1}}, "corpora[0].problems.seed"),
    ],
)
def test_what_makes_no_sense_is_said_with_its_place(settings: dict[str, object], message: str) -> None:
    with pytest.raises(TrainingError) as raised:
        build_corpus(settings, "corpora[0]")
    assert message in str(raised.value)
    assert "\n" not in str(raised.value)


def test_an_unknown_kind_is_said_with_what_is_near() -> None:
    with pytest.raises(UnknownNameError, match="did you mean: worked"):
        build_corpus({"kind": "workd"})


def test_solutions_of_drawn_problems_stand_in_boxes_and_are_right() -> None:
    problems = {"name": "drawn", "seed": 3, "recipe": ["incline", "collision"], "difficulty": "easy"}
    settings = {"kind": "worked", "problems": problems, "items": 2}
    rows = list(build_corpus(settings).rows(Counter()))
    assert rows == list(build_corpus({**settings, "workers": 2}).rows(Counter()))
    assert len(rows) == 2
    assert all(r"\boxed{" in row.completion for row in rows)


def test_solutions_of_a_dataset_are_its_rows_and_grade_as_right(tmp_path: Path) -> None:
    from sim2reason.datasets.grade import grade

    data = generate(tmp_path / "a", items=4, recipe="collision", difficulty="easy", solutions=True, workers=1)
    left_out = Counter[str]()
    rows = list(build_corpus({"kind": "worked", "dataset": str(data.path)}).rows(left_out))
    held = {item.prompt: item for item in data}
    assert len(rows) + left_out["no worked solution"] == len(held) == 4
    assert rows
    assert {grade(held[row.prompt], row.completion).outcome for row in rows} == {Outcome.CORRECT}


def test_a_dataset_without_solutions_or_split_is_refused(tmp_path: Path) -> None:
    plain = generate(tmp_path / "b", items=2, recipe="pulley", maker="fake_makers:steady", workers=1)
    with pytest.raises(TrainingError, match="generate it with --solutions"):
        list(build_corpus({"kind": "worked", "dataset": str(plain.path)}).rows(Counter()))
    with pytest.raises(DatasetError):
        list(build_corpus({"kind": "worked", "dataset": str(tmp_path / "none")}).rows(Counter()))


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"{", "a.jsonl:1: no JSON"),
        (b"\n\n[1]\n", "a.jsonl:3: no object"),
        (b'{"q": 1, "a": "b"}', "its field 'q' is no text"),
        (b'{"q": "  ", "a": "b"}', "its field 'q' is no text"),
        (b'{"q": "b"}', "its field 'a' is no text"),
        (b"[" * 100_000, "a.jsonl:1: no JSON"),
        (b"\xff\xfe", "a.jsonl:1: no JSON"),
        (b"", "corpora[0]: no row to learn from in this jsonl; it is empty"),
    ],
)
def test_a_damaged_file_is_one_line_that_names_the_place(content: bytes, message: str, tmp_path: Path) -> None:
    path = tmp_path / "a.jsonl"
    path.write_bytes(content)
    with pytest.raises(TrainingError) as raised:
        mix_corpora([build_corpus({"kind": "jsonl", "file": str(path), "prompt": "q", "completion": "a"})], 0)
    assert message in str(raised.value)
    assert "\n" not in str(raised.value)


def test_a_line_is_bounded_and_a_surrogate_is_marked(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "a.jsonl"
    path.write_text(json.dumps({"prompt": "\ud800?", "completion": "b" * 100}))
    settings = {"kind": "jsonl", "file": str(path)}
    assert next(build_corpus(settings).rows(Counter())).prompt == "??"
    monkeypatch.setattr("sim2reason.training.corpora.rows.LONGEST", 50)
    with pytest.raises(TrainingError, match="more than 50 bytes"):
        list(build_corpus(settings).rows(Counter()))
    with pytest.raises(TrainingError, match="no such file"):
        list(build_corpus({**settings, "file": str(tmp_path / "none")}).rows(Counter()))


def test_rows_stand_in_the_mix_as_often_as_they_weigh(tmp_path: Path) -> None:
    many, few = lines(tmp_path / "many.jsonl", 40, "many"), lines(tmp_path / "few.jsonl", 10, "few")
    corpora = [build_corpus({**many, "weight": 0.25}), build_corpus({**few, "weight": 2.5, "limit": 4})]
    found = mix_corpora(corpora, 1)
    assert [(each.kind, each.rows, each.taken) for each in found.corpora] == [("jsonl", 40, 10), ("jsonl", 4, 10)]
    counts = Counter(row.prompt for row in found.rows)
    assert len(found.rows) == 20
    assert sorted(counts[f"few {n}?"] for n in range(4)) == [2, 2, 3, 3]
    assert sum(count for name, count in counts.items() if name.startswith("many")) == 10
    assert found == mix_corpora(corpora, 1)
    assert found.rows != mix_corpora(corpora, 2).rows
    first = [row.prompt.split()[0] for row in found.rows]
    assert first != sorted(first)
    assert first != sorted(first, reverse=True)


def test_limits_name_what_is_too_long() -> None:
    row = EncodedRow([1] * 5, [2] * 7)
    assert row.excess(Limits(5, 7, 12)) == ""
    assert row.excess(Limits(4, 7, 12)) == "prompt too long"
    assert row.excess(Limits(5, 6, 12)) == "completion too long"
    assert row.excess(Limits(5, 7, 11)) == "longer than the context"
    assert (row.tokens, row.labels) == ([1] * 5 + [2] * 7, [-100] * 5 + [2] * 7)


@pytest.fixture(scope="module")
def tokenizer() -> Tokenizer:
    from sim2reason.training.models.language_models import train_tokenizer

    return train_tokenizer(["How fast is it? It is fast: 12 m/s.", "<|user|><|model|>"] * 9, 300)


@installed
def test_plain_rows_are_encoded_apart_and_ended_once(tokenizer: Tokenizer) -> None:
    rows = [Row("How fast is", " it? It is"), Row("12", "3<|end|>")]
    found = encode_rows(rows, tokenizer, chat=False)
    for row, tokens in zip(rows, found, strict=True):
        assert tokens.prompt == tokenizer(row.prompt)["input_ids"]
        assert tokenizer.decode(tokens.prompt) == row.prompt
        assert tokenizer.decode(tokens.completion) == row.completion.removesuffix("<|end|>") + "<|end|>"
        assert tokens.completion.count(tokenizer.eos_token_id) == 1
    assert encode_rows([], tokenizer, chat=False) == []


@installed
def test_a_table_holds_what_is_within_the_limits(tokenizer: Tokenizer, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sim2reason.training.corpora.rows.ROWS_PER_BATCH", 2)
    rows = [Row("How fast", " is it?"), Row("12" * 9, "1"), Row("1", "2"), Row("12" * 9, "3"), Row("3", "4" * 50)]
    found, left_out = encoded_table(rows, tokenizer, Limits(10, 20, 30), chat=False)
    held = encode_rows([rows[0], rows[2]], tokenizer, chat=False)
    assert found.to_pylist() == [
        {"input_ids": row.tokens, "labels": row.labels, "length": len(row.tokens)} for row in held
    ]
    assert left_out == {"prompt too long": 2, "completion too long": 1}
    empty, _ = encoded_table([], tokenizer, Limits(10, 20, 30), chat=False)
    assert (len(empty), empty.column_names) == (0, found.column_names)


@installed
@pytest.mark.parametrize("after", ["<|end|>\n", ""])
def test_messages_are_written_as_the_template_has_them(tokenizer: Tokenizer, after: str) -> None:
    tokenizer.chat_template = (
        "{% for m in messages %}{{ '<|' + m.role + '|>' + m.content + '"
        + after.replace("\n", "\\n")
        + "' }}{% endfor %}"
        "{% if add_generation_prompt %}<|assistant|>{% endif %}"
    )
    row = Row("How fast?", "12 m/s.")
    prompt, completion = apply_template(row, tokenizer)
    assert prompt == f"<|user|>How fast?{after}<|assistant|>"
    assert completion == f"12 m/s.{after.strip()}"
    found = encode_rows([row], tokenizer, chat=True)[0]
    assert tokenizer.decode(found.prompt + found.completion) == f"{prompt}12 m/s.<|end|>"


@installed
def test_a_template_that_drops_what_was_thought_drops_nothing_here(tokenizer: Tokenizer) -> None:
    tokenizer.chat_template = (
        "{% for m in messages %}{{ m.content.split('</think>')[-1] }}{% endfor %}"
        "{% if add_generation_prompt %}>{% endif %}"
    )
    assert apply_template(Row("How?", "<think>So.</think>12"), tokenizer) == ("How?>", "<think>So.</think>12")
