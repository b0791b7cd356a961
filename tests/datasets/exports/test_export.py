"""Tests of an export's folder, written whole or not at all, reproducible, and without overwriting anything."""

import json
from pathlib import Path

import pyarrow.parquet as pq
import pytest

import sim2reason
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.exports import EXPORTS, Export, RowPosition
from sim2reason.datasets.exports.export import MARK, export
from sim2reason.errors import DatasetError, UnknownNameError
from sim2reason.generation.item import Item
from sim2reason.rewards import answered, boxed, score

TARGETS = list(EXPORTS)


def rows(folder: Path, to: str) -> list[dict[str, object]]:
    """Return all rows of an export."""
    pattern = EXPORTS[to].data.replace("{split}", "*")
    found: list[dict[str, object]] = []
    for path in sorted(folder.glob(pattern)):
        if path.suffix == ".parquet":
            found += pq.read_table(path).to_pylist()
        else:
            found += [json.loads(line) for line in path.read_text().splitlines()]
    return found


def content(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


@pytest.mark.parametrize("to", TARGETS)
def test_every_problem_is_a_row_or_counted_as_left_out(problems: Path, tmp_path: Path, to: str) -> None:
    steps: list[int] = []
    done = sim2reason.export(problems, tmp_path / "out", to=to, advance=steps.append)
    assert sum(done.rows.values()) + done.left_out == len(Dataset(problems)) == sum(steps)
    assert len(rows(tmp_path / "out", to)) == sum(done.rows.values()) > 0
    assert not done.left_out or EXPORTS[to].lacks


@pytest.mark.parametrize("to", TARGETS)
def test_the_same_dataset_gives_the_same_bytes(problems: Path, tmp_path: Path, to: str) -> None:
    export(problems, tmp_path / "one", to=to)
    export(problems, tmp_path / "two", to=to)
    assert content(tmp_path / "one") == content(tmp_path / "two")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["one", "two"]  # no folder of ours is left over


@pytest.mark.parametrize("to", TARGETS)
def test_the_folder_says_how_to_use_it_and_no_mark_is_left(problems: Path, tmp_path: Path, to: str) -> None:
    export(problems, tmp_path / "out", to=to)
    page = (tmp_path / "out" / "README.md").read_text()
    assert f"--to {to}`" in page
    for path, text in content(tmp_path / "out").items():
        if Path(path).suffix in {".md", ".yaml", ".toml", ".txt"}:
            assert not any(mark in text.decode() for mark in ("{split}", "{splits}", "{source}", "{license}")), path


def test_splits_are_chosen_by_name_and_evaluation_is_on_the_test_split(problems: Path, tmp_path: Path) -> None:
    done = export(problems, tmp_path / "one", to="inspect", split=["test"])
    assert list(done.rows) == ["test"]
    assert not (tmp_path / "one/data/train.jsonl").exists()
    export(problems, tmp_path / "both", to="lm-eval")
    assert 'test_split: "test"' in (tmp_path / "both/sim2reason.yaml").read_text()
    export(problems, tmp_path / "train", to="lm-eval", split="train")
    assert 'test_split: "train"' in (tmp_path / "train/sim2reason.yaml").read_text()


def test_what_is_there_is_never_overwritten(problems: Path, tmp_path: Path) -> None:
    (tmp_path / "out").mkdir()
    export(problems, tmp_path / "out", to="verl")  # an empty folder is a new one
    before = content(tmp_path)
    for to in ("verl", "hf"):
        with pytest.raises(DatasetError, match="nothing is overwritten; give a new folder"):
            export(problems, tmp_path / "out", to=to)
    (tmp_path / "file").write_text("mine")
    with pytest.raises(DatasetError, match="nothing is overwritten"):
        export(problems, tmp_path / "file", to="hf")
    assert content(tmp_path) == before | {"file": b"mine"}


@pytest.mark.parametrize("name", [".", "../here", "{absolute}"])
def test_the_current_folder_is_not_replaced(
    problems: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    """A shell in the current folder would be left in a deleted folder."""
    (tmp_path / "here").mkdir()
    monkeypatch.chdir(tmp_path / "here")
    out = name.format(absolute=tmp_path / "here")
    with pytest.raises(DatasetError, match=f"^{out}: is the folder that you are in.*give a new one in it$"):
        export(problems, out, to="hf")
    assert [path.name for path in tmp_path.rglob("*")] == ["here"]
    export(problems, "new", to="hf")
    assert MARK not in content(Path("new"))


def test_wrong_names_are_told_with_the_right_ones(problems: Path, tmp_path: Path) -> None:
    with pytest.raises(UnknownNameError, match="did you mean: verl"):
        export(problems, tmp_path / "out", to="vrl")
    with pytest.raises(DatasetError, match="has no split 'dev'; there is test, train"):
        export(problems, tmp_path / "out", to="verl", split=["dev"])
    with pytest.raises(DatasetError, match="give a folder that sim2reason generate has finished"):
        export(tmp_path, tmp_path / "out", to="verl")
    assert not list(tmp_path.iterdir())


class Broken(Export):
    """Export that fails at its fortieth row, as on a full disk."""

    name = "broken"

    def row(self, item: Item, place: RowPosition) -> dict[str, str]:
        if place.number == 40:
            raise OSError(28, "No space left on device")
        return {"id": item.id}


class Nothing(Export):
    """Export that fits no item."""

    name = "nothing"
    lacks = "it needs what no item has"

    def row(self, item: Item, place: RowPosition) -> None:
        del item, place


@pytest.fixture
def registered(monkeypatch: pytest.MonkeyPatch) -> None:
    """Register two exports of a third party, which add no files."""
    members = {**EXPORTS, "broken": Broken(), "nothing": Nothing()}
    monkeypatch.setattr(EXPORTS, "_members", members)


@pytest.mark.usefixtures("registered")
def test_an_export_that_fails_leaves_nothing(problems: Path, tmp_path: Path) -> None:
    with pytest.raises(OSError, match="No space left") as error:
        export(problems, tmp_path / "out", to="broken")
    assert error.value.filename
    with pytest.raises(DatasetError, match="holds no problem for nothing: it needs what no item has; give another"):
        export(problems, tmp_path / "out", to="nothing")
    assert not list(tmp_path.iterdir())


def test_what_a_kill_has_left_is_removed_by_the_next_run(problems: Path, tmp_path: Path) -> None:
    stale = tmp_path / ".out.export" / "data"
    stale.mkdir(parents=True)
    (stale / "other.jsonl").write_text("{}")
    (tmp_path / ".out.export" / MARK).touch()
    export(problems, tmp_path / "out", to="lm-eval")
    assert [path.name for path in tmp_path.iterdir()] == ["out"]
    assert MARK not in content(tmp_path / "out")
    assert sorted(path.name for path in (tmp_path / "out/data").iterdir()) == ["test.jsonl", "train.jsonl"]


@pytest.mark.parametrize("link", [False, True])
def test_a_folder_of_somebody_elses_beside_it_stays(problems: Path, tmp_path: Path, link: bool) -> None:
    mine = tmp_path / "mine" if link else tmp_path / ".out.export"
    mine.mkdir()
    if link:
        (tmp_path / ".out.export").symlink_to(mine)
    else:
        (mine / "notes.txt").write_text("mine")
    before = content(tmp_path)
    with pytest.raises(DatasetError, match="move it away or give another folder"):
        export(problems, tmp_path / "out", to="lm-eval")
    assert content(tmp_path) == before
    assert mine.is_dir()
    assert not (tmp_path / "out").exists()


def test_an_export_whose_splits_share_a_file_is_refused() -> None:
    with pytest.raises(ValueError, match=r"say \{split\} in its `data`"):
        EXPORTS.add("one file", type("One", (Broken,), {"data": "all.jsonl"})())


def test_parquet_is_written_in_batches_of_a_declared_schema(problems: Path, tmp_path: Path) -> None:
    export(problems, tmp_path / "out", to="verl")
    schema = pq.read_schema(tmp_path / "out/train.parquet")
    assert schema.names == ["data_source", "prompt", "ability", "reward_model", "extra_info"]
    numbers = [row["extra_info"]["index"] for row in pq.read_table(tmp_path / "out/train.parquet").to_pylist()]
    assert numbers == list(range(len(numbers)))


def test_rows_for_hugging_face_have_the_answer_the_worked_solution_and_the_licence(tmp_path: Path) -> None:
    """The column `solution` holds the worked solution, while rewards read the ground truth."""
    order = {"items": 3, "recipe": "pulley", "difficulty": "easy", "mode": ("numeric", "multipart"), "solutions": True}
    data = sim2reason.generate(tmp_path / "data", **order, license="cc-by-4.0", workers=1)
    export(tmp_path / "data", tmp_path / "out", to="hf")
    for item, row in zip(data, rows(tmp_path / "out", "hf"), strict=True):
        assert row["answer"] == answered(item)
        texts = [part.solution for part in item.parts] or [item.solution]
        assert all(text is not None and text.text in str(row["solution"]) for text in texts)
        assert score(str(row["ground_truth"]), boxed(str(row["answer"]))).reward == 1.0
    card = (tmp_path / "out/README.md").read_text()
    assert card.startswith("---\n")
    assert "\nlicense: cc-by-4.0\n" in card.split("---")[1]


def test_without_worked_solutions_that_column_is_empty(problems: Path, tmp_path: Path) -> None:
    export(problems, tmp_path / "out", to="hf")
    assert {row["solution"] for row in rows(tmp_path / "out", "hf")} == {None}


@pytest.mark.parametrize(
    ("origin", "line"),
    [
        ('{"url": "file:///a/b", "dir_info": {}}', "sim2reason @ file:///a/b"),
        (
            '{"url": "https://host/r.git", "vcs_info": {"vcs": "git", "commit_id": "0ab"}}',
            "sim2reason @ git+https://host/r.git@0ab",
        ),
        (None, "# sim2reason: write here the path of a clone of its repository"),
    ],
)
def test_a_server_installs_the_library_from_where_it_came(
    problems: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, origin: str | None, line: str
) -> None:
    class Installed:
        @staticmethod
        def read_text(name: str) -> str | None:
            assert name == "direct_url.json"
            return origin

    monkeypatch.setattr("sim2reason.datasets.exports.export.distribution", lambda _: Installed())
    export(problems, tmp_path / "out", to="nemo-gym")
    server = tmp_path / "out/resources_servers/sim2reason"
    assert (server / "requirements.txt").read_text() == f"nemo-gym\n{line}\n"
    assert "license: Apache 2.0\n" in (server / "configs/sim2reason.yaml").read_text()
