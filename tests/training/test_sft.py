"""Tests of supervised fine-tuning: valid and invalid configurations, and tiny runs that learn, end and resume."""

import json
import os
import signal
import subprocess
import sys
import time
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest

from sim2reason.errors import DatasetError, MissingExtraError, TrainingError, UnknownNameError
from sim2reason.training import train
from sim2reason.training.sft.config import FineTuning, SftFolder, build_fine_tuning
from sim2reason.training.sft.run import NEEDED, train_sft
from sim2reason.training.sft.trainer import batches_by_length

installed = pytest.mark.skipif(not all(map(find_spec, NEEDED)), reason="needs the libraries of the extra [train]")
TINY = {"kind": "scratch", "layers": 1, "width": 32, "heads": 2, "vocabulary": 300, "context": 128}
Settings = dict[str, Any]


@pytest.fixture
def settings(tmp_path: Path) -> Settings:
    """Return the settings of a run of six steps of eight rows."""
    rows = tmp_path / "rows.jsonl"
    lines = ({"prompt": f"How much is {n} and {n}? ", "completion": rf"\boxed{{{2 * n}}}"} for n in range(10, 42))
    rows.write_text("".join(f"{json.dumps(line)}\n" for line in lines))
    return {
        "out": str(tmp_path / "run"),
        "model": TINY,
        "corpora": [{"kind": "jsonl", "file": str(rows)}],
        "steps": 6,
        "batch": 8,
        "learning_rate": 3e-3,
        "save_every": 2,
        "log_every": 1,
        "device": "cpu",
    }


def log(out: object) -> list[dict[str, float]]:
    return [json.loads(line) for line in (Path(str(out)) / "log.jsonl").read_text().splitlines()]


def weights(out: object) -> bytes:
    return (Path(str(out)) / "model/model.safetensors").read_bytes()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"out": None}, "out: "),
        ({"steps": None}, "give either steps or epochs"),
        ({"epochs": 1.0}, "give either steps or epochs"),
        ({"steps": 0}, "steps: "),
        ({"steps": 10**12}, "steps: "),
        ({"steps": None, "epochs": float("inf")}, "epochs: "),
        ({"batch": 0}, "batch: "),
        ({"micro_batch": 3}, "micro_batch: 3 does not divide the batch of 8"),
        ({"learning_rate": float("nan")}, "learning_rate: "),
        ({"learning_rate": -1}, "learning_rate: "),
        ({"decay": 2}, "decay: "),
        ({"optimizer": "sgd"}, "optimizer: "),
        ({"optimizer": "muon", "lora": {}}, "leave lora out"),
        ({"lora": {"rank": 0}}, "lora.rank: "),
        ({"lora": {"targets": []}}, "lora.targets"),
        ({"seed": 2**32}, "seed: "),
        ({"model": {"kind": "scratch", "width": "wide"}}, "model.width: "),
        ({"model": {}}, "model.kind: give one of"),
        ({"model": "tiny"}, "model: "),
        ({"corpora": []}, "corpora: "),
        ({"corpora": [{}]}, "corpora[0].kind: give one of"),
        ({"corpora": [3]}, "corpora.0: "),
        ({"corpora": {"kind": "jsonl"}}, "corpora: "),
        ({"packing": True}, "packing: no such setting"),
        ({"precision": "float16"}, "precision: "),
    ],
)
def test_what_makes_no_sense_is_one_line_with_its_place(settings: Settings, change: Settings, message: str) -> None:
    with pytest.raises(TrainingError) as raised:
        build_fine_tuning({**settings, **change})
    assert message in str(raised.value)
    assert "\n" not in str(raised.value)


def test_a_file_is_named_before_the_place(settings: Settings, tmp_path: Path) -> None:
    path = tmp_path / "config.yaml"
    path.write_text(json.dumps({**settings, "model": {"kind": "scrach"}}))
    with pytest.raises(UnknownNameError, match=r"config\.yaml: .*did you mean: scratch"):
        build_fine_tuning(path)
    path.write_text(json.dumps(settings))
    assert build_fine_tuning(path) == build_fine_tuning(settings)
    assert build_fine_tuning(path, tmp_path / "other").out == tmp_path / "other"
    with pytest.raises(UnknownNameError, match=r"no such method of training: 'dpo'; there are: .*sft"):
        train("dpo", settings)


def test_steps_follow_from_epochs_and_a_batch_is_dealt_to_devices(settings: Settings) -> None:
    found = build_fine_tuning({**settings, "steps": None, "epochs": 2.5, "batch": 12})
    assert [found.steps_of(rows) for rows in (1, 12, 13, 60)] == [3, 3, 5, 13]
    assert found.accumulated(1) == (12, 1)
    assert found.accumulated(3) == (4, 1)
    assert found.model_copy(update={"micro_batch": 2}).accumulated(2) == (2, 3)
    with pytest.raises(TrainingError, match="can't be dealt to 5 devices"):
        found.accumulated(5)
    with pytest.raises(TrainingError, match="does not divide the 3 rows of each of 4 devices"):
        found.model_copy(update={"micro_batch": 2}).accumulated(4)


def test_what_decides_the_weights_has_its_kinds_and_no_paths_of_ours(settings: Settings) -> None:
    found = build_fine_tuning(settings).decisive
    assert found["model"]["kind"] == "scratch"
    assert found["corpora"][0]["kind"] == "jsonl"
    assert not set(found) & FineTuning.operational


def test_a_missing_library_is_named_with_its_extra(settings: Settings, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in NEEDED:
        monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(MissingExtraError, match=r"pip install .*'torch"):
        train_sft(settings)
    assert not Path(settings["out"]).exists()


def test_batches_hold_rows_that_are_about_equally_long() -> None:
    lengths = [*range(10, 20)] * 30 + [100] * 7
    found = batches_by_length(lengths, 4, seed=0, epoch=0)
    assert sorted(found) == [*range(307)]
    batches = [[lengths[place] for place in found[start : start + 4]] for start in range(0, 304, 4)]
    assert sum(max(batch) - min(batch) for batch in batches) <= 2 * (20 - 10) + 90  # once around in each stretch
    assert [min(batch) for batch in batches] != sorted(min(batch) for batch in batches)
    assert found == batches_by_length(lengths, 4, seed=0, epoch=0)
    assert len({tuple(batches_by_length(lengths, 4, seed, epoch)) for seed, epoch in ((0, 0), (0, 1), (1, 0))}) == 3
    assert sorted(batches_by_length([5, 6, 7], 8, 0, 0)) == [0, 1, 2]


@installed
def test_a_run_by_length_goes_on_as_one_that_was_not_broken_off(settings: Settings, tmp_path: Path) -> None:
    """There are sixteen rows per pass, so the run is resumed in the second pass."""
    settings |= {"by_length": True, "steps": 9, "batch": 8}
    train_sft(settings)
    broken = {**settings, "out": str(tmp_path / "broken")}

    def stop(_: int, calls: list[int] = []) -> None:  # noqa: B006 - counts its calls
        calls.append(0)
        if len(calls) == 8:  # the first tells how many steps are done at the start
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        train_sft(broken, advance=stop)
    train_sft(broken)
    assert weights(broken["out"]) == weights(settings["out"])


@installed
def test_no_attention_of_cudnn_is_used(settings: Settings) -> None:
    import torch

    torch.backends.cuda.enable_cudnn_sdp(enabled=True)
    assert torch.backends.cuda.cudnn_sdp_enabled()
    train_sft({**settings, "steps": 1})
    assert not torch.backends.cuda.cudnn_sdp_enabled()


@installed
@pytest.mark.parametrize("optimizer", ["adamw", "muon"])
def test_it_learns_and_loads_like_any_checkpoint(settings: Settings, optimizer: str) -> None:
    from sim2reason.training.models import build_model

    begun, done = list[tuple[str, int]](), list[int]()
    settings |= {"steps": 30, "optimizer": optimizer, "batch": 32, "save_every": 100, "decay": 0.3}
    found = train_sft(settings, begun=lambda *told: begun.append(told), advance=done.append)
    lines = log(settings["out"])
    assert [line["step"] for line in lines] == list(range(1, 31))
    assert lines[-1]["loss"] < 0.5 * lines[0]["loss"]
    assert found.loss == lines[-1]["loss"]
    assert lines[0]["loss"] == pytest.approx(5.7, abs=0.3)  # about log 300: it knows nothing yet
    assert all(line["tokens_per_second"] > 0.0 for line in lines)
    assert lines[20]["learning_rate"] == lines[0]["learning_rate"] > lines[25]["learning_rate"]
    assert (begun, sum(done)) == ([("fine-tuning", 30)], 30)
    assert (found.rows, found.steps, found.left_out) == (32, 30, {})
    model = build_model({"kind": "pretrained", "model": str(Path(settings["out"]) / found.model)})
    assert model.load([], Path()).model.num_parameters() == found.parameters
    assert not list((Path(settings["out"]) / "model").glob("*.bin"))
    assert train_sft(settings, advance=done.append) == found
    assert sum(done) == 30


@installed
def test_only_completions_are_learned_whatever_their_prompts_say(settings: Settings) -> None:
    """The loss of each step is that of the completions alone, recomputed here from the model before training."""
    import torch

    settings |= {"steps": 1, "batch": 32, "learning_rate": 1e-9, "micro_batch": 8}
    train_sft(settings)
    from sim2reason.training.corpora.rows import encode_rows
    from sim2reason.training.models.checkpoints import Checkpoint

    folder = SftFolder(Path(settings["out"]))
    loaded = Checkpoint(str(folder.initial)).load()
    total, count = 0.0, 0
    for row in encode_rows(folder.rows(), loaded.tokenizer, chat=False):
        tokens = torch.tensor([row.prompt + row.completion])
        with torch.no_grad():
            chances = torch.log_softmax(loaded.model(tokens).logits[0, :-1], dim=1)
        said = chances[range(len(chances)), tokens[0, 1:]][len(row.prompt) - 1 :]
        assert len(said) == len(row.completion)
        total, count = total - float(said.sum()), count + len(said)
    assert log(settings["out"])[0]["loss"] == pytest.approx(total / count, rel=1e-4)


@installed
def test_the_loss_is_that_of_trl(settings: Settings, monkeypatch: pytest.MonkeyPatch) -> None:
    ours = train_sft({**settings, "micro_batch": 4})
    monkeypatch.setattr("sim2reason.training.sft.trainer.SMALL", 0)
    theirs = train_sft({**settings, "micro_batch": 4, "out": f"{settings['out']}-trl"})
    assert ours.loss == pytest.approx(theirs.loss, rel=1e-4)


@installed
def test_micro_batches_do_not_change_what_is_learned(settings: Settings) -> None:
    whole, parts = train_sft(settings), train_sft({**settings, "micro_batch": 2, "out": f"{settings['out']}-parts"})
    assert whole.loss == pytest.approx(parts.loss, rel=1e-4)


@installed
@pytest.mark.parametrize("change", [{"optimizer": "muon"}, {"lora": {"rank": 4, "dropout": 0.1}}], ids=str)
def test_a_run_that_is_broken_off_ends_in_the_same_weights(settings: Settings, change: Settings) -> None:
    if "lora" in change:
        pytest.importorskip("peft")
    settings |= change
    broken = {**settings, "out": f"{settings['out']}-broken"}

    def stop(steps: int) -> None:
        done.append(steps)
        if sum(done) == 5:
            raise KeyboardInterrupt

    done = list[int]()
    with pytest.raises(KeyboardInterrupt):
        train_sft(broken, advance=stop)
    folder = SftFolder(Path(broken["out"]))
    assert folder.checkpoint() == folder.checkpoints / "checkpoint-4"
    torn = folder.checkpoints / "checkpoint-6"
    torn.mkdir()
    (torn / "trainer_state.json").write_text("{")
    with folder.log.path.open("a") as file:
        file.write('{"step": 5, "lo')
    (Path(settings["corpora"][0]["file"])).rename(f"{settings['out']}.rows")  # it is not read again
    advanced = list[int]()
    again = train_sft({**broken, "save_every": 3}, advance=advanced.append)
    assert advanced == [4, 1, 1]
    (Path(f"{settings['out']}.rows")).rename(settings["corpora"][0]["file"])
    whole = train_sft(settings)
    assert again == whole
    assert weights(broken["out"]) == weights(settings["out"])
    for mine, theirs in zip(log(broken["out"]), log(settings["out"]), strict=True):
        assert {**mine, "tokens_per_second": 0} == {**theirs, "tokens_per_second": 0}


@installed
def test_it_goes_on_after_a_kill(settings: Settings, tmp_path: Path) -> None:
    settings |= {"steps": 150, "save_every": 5, "log_every": 50}
    (tmp_path / "config.yaml").write_text(json.dumps(settings))
    command = [sys.executable, "-m", "sim2reason", "train", "sft", str(tmp_path / "config.yaml")]
    run = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=dict(os.environ))
    folder = SftFolder(Path(settings["out"]))
    for _ in range(1200):
        if folder.checkpoint() or run.poll() is not None:
            break
        time.sleep(0.05)
    run.send_signal(signal.SIGKILL)
    run.communicate()
    last = folder.checkpoint()
    assert last is not None
    assert not (folder.path / "result.json").exists()
    step = int(last.name.partition("-")[2])
    assert 5 <= step < 150
    advanced = list[int]()
    train_sft({**settings, "save_every": 500}, advance=advanced.append)
    assert advanced[0] == step
    assert sum(advanced) == 150


@installed
def test_adapters_are_merged_and_kept(settings: Settings) -> None:
    pytest.importorskip("peft")
    found = train_sft({**settings, "lora": {"rank": 2, "targets": ["q_proj", "v_proj"]}})
    out = Path(settings["out"])
    assert (out / "adapter/adapter_config.json").is_file()
    from sim2reason.training.models.checkpoints import Checkpoint

    before, after = (Checkpoint(str(out / each)).load().model for each in ("initial", "model"))
    assert after.num_parameters() == before.num_parameters() == found.parameters
    held = dict(before.named_parameters())
    changed = {name.split(".")[-2] for name, value in after.named_parameters() if not value.equal(held[name])}
    assert changed == {"q_proj", "v_proj"}


@installed
def test_long_rows_are_counted_and_left_out(settings: Settings) -> None:
    path = Path(settings["corpora"][0]["file"])
    with path.open("a") as file:
        for prompt, completion in (("zx" * 99, "1"), ("?", "qj" * 30), ("vw" * 30, "kq" * 30)):
            file.write(f"{json.dumps({'prompt': prompt, 'completion': completion})}\n")
    settings |= {"max_completion_tokens": 40, "steps": 1, "model": {**TINY, "vocabulary": 258}}
    found = train_sft(settings)
    assert found.left_out == {"completion too long": 2, "longer than the context": 1}
    assert found.rows == 32
    with pytest.raises(TrainingError, match="no row is within the limits"):
        train_sft({**settings, "max_prompt_tokens": 1, "max_completion_tokens": 1, "out": f"{settings['out']}-none"})


@installed
def test_a_folder_of_something_else_is_refused(settings: Settings, tmp_path: Path) -> None:
    train_sft({**settings, "steps": 1})
    with pytest.raises(TrainingError, match="holds a run with another setting of seed"):
        train_sft({**settings, "steps": 1, "seed": 1})
    with pytest.raises(TrainingError, match="holds a run with another setting of model"):
        train_sft({**settings, "steps": 1, "model": {**TINY, "layers": 2}})
    with pytest.raises(TrainingError, match=r"holds rows\.jsonl and is no run"):
        train_sft({**settings, "out": str(tmp_path)})
    for file in ("result.json", "sft.json"):
        (tmp_path / "run" / file).write_text("{}")
        with pytest.raises(TrainingError, match=f"{file}: damaged"):
            train_sft({**settings, "steps": 1})


@installed
def test_a_chat_template_is_asked_for_or_found(settings: Settings) -> None:
    with pytest.raises(TrainingError, match="has no chat template; set chat to false"):
        train_sft({**settings, "chat": True})


@installed
def test_one_run_at_a_time(settings: Settings) -> None:
    def another(*_: object) -> None:
        with pytest.raises(DatasetError, match="another run is writing here"):
            train_sft(settings)

    train_sft({**settings, "steps": 1}, begun=another)


@installed
@pytest.mark.parametrize("factor", [float("inf"), float("nan")])
def test_a_loss_that_is_no_number_ends_the_run(
    settings: Settings, factor: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    from sim2reason.training.sft import trainer

    true = trainer._loss
    monkeypatch.setattr(trainer, "_loss", lambda *args: true(*args) * factor)
    with pytest.raises(TrainingError, match=r"step 1: the loss is (nan|inf); give lower learning rates"):
        train_sft(settings)
    assert log(settings["out"]) == []
