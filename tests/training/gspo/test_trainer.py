"""Tests of dynamic sampling with a tiny model, in one process and in two."""

import importlib
import json
import random
import signal
import subprocess
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from sim2reason.errors import TrainingError
from sim2reason.training.gspo import StepLog, last_checkpoint, make_trainer
from sim2reason.training.models import Checkpoint
from sim2reason.training.optimization import Lora
from sim2reason.training.run_files import read_cursor

pytest.importorskip("trl")

import torch
from transformers import TrainerCallback

from gspo_run import REWARDS, Numbers, Thing, settings, trainer
from gspo_told import check_groups, learned, lines, without_times

pytestmark = pytest.mark.filterwarnings("ignore::DeprecationWarning", "ignore::FutureWarning", "ignore::UserWarning")


def trained(model: Path, out: Path, stream: Thing, *rewards: str, **settings: Thing) -> Thing:
    found = trainer(model, out, stream, rewards, **settings)
    found.train()
    return found


def test_one_process_learns_from_unequal_rewards_only(model: Path, tmp_path: Path) -> None:
    stream = Numbers()
    found = trained(model, tmp_path, stream, "parity", steps=4, microbatch=2)
    check_groups(tmp_path, 4, 4, 1)
    records = StepLog(tmp_path).read()
    assert [record.step for record in records] == [1, 2, 3, 4]
    assert all(record.groups == 4 and record.rounds >= 1 for record in records)
    assert sum(record.prompts for record in records) == records[-1].prompts_consumed == stream.next
    assert sum(record.zero_variance for record in records) > 0
    assert stream.handed == list(range(stream.next))
    assert found.state.global_step == 8
    for record in records:
        times = record.seconds
        parts = times.generation + times.reward + times.drawing + times.logprobs + times.update
        assert 0 < parts <= times.step


def test_the_log_agrees_with_what_was_answered(model: Path, tmp_path: Path) -> None:
    trained(model, tmp_path, Numbers(), "parity", steps=3)
    record = StepLog(tmp_path).read()[0]
    assert record.pass_rate == record.reward
    assert 0 < record.pass_rate < 1
    assert 1 <= record.completion_tokens <= 6
    assert 0 < record.truncated < 1
    assert record.clip_low + record.clip_high > 0
    assert record.kl > 0
    assert record.learning_rate == 1e-3
    items = sum(len(ids) for group in learned(tmp_path, 4) if group.step == 1 for ids in group.completions)
    assert lines(tmp_path / "learned-0.jsonl")[0]["items"] == items


def test_two_processes_learn_from_different_prompts(run: Callable[..., str], tmp_path: Path) -> None:
    given = {"processes": 2, "rewards": ["parity"]}
    run("two", settings={"steps": 3, "save_every": 2}, **given)
    out = tmp_path / "two/out"
    check_groups(out, 4, 4, 2)
    records = StepLog(out).read()
    assert [record.step for record in records] == [1, 2, 3]
    assert handed(tmp_path / "two", 0) == list(range(records[-1].prompts_consumed))
    assert handed(tmp_path / "two", 1) == []
    assert sum(record.prompts for record in records) == records[-1].prompts_consumed
    for one, other in zip(*(lines(out / f"learned-{rank}.jsonl") for rank in (0, 1)), strict=True):
        assert one["items"] == other["items"] == sum(len(ids) for line in (one, other) for ids in line["completions"])
    run("two", settings={"steps": 4, "save_every": 2}, resume=True, **given)
    assert handed(tmp_path / "two", 0)[0] == records[-1].prompts_consumed
    assert [record.step for record in StepLog(out).read()] == [1, 2, 3, 4]


def handed(folder: Path, rank: int) -> list[int]:
    return json.loads((folder / f"handed-{rank}.json").read_text())


def test_a_killed_run_goes_on_as_one_that_was_not(
    launch: Callable[..., "subprocess.Popen[str]"], run: Callable[..., str], tmp_path: Path
) -> None:
    given = {"settings": {"steps": 10, "save_every": 2}, "rewards": ["parity"], "pause": 0.02}
    run("whole", **given)
    out = tmp_path / "cut/out"
    with launch("cut", **given) as process:
        killed(process, out, step=random.randint(1, 8))
    (out / "learned-0.jsonl").unlink()
    at = last_checkpoint(out)
    done = 0 if at is None else read_cursor(at).step
    run("cut", resume=True, **given)
    expected, found = (lines(tmp_path / name / "out/log.jsonl") for name in ("whole", "cut"))
    assert [without_times(line) for line in found] == [without_times(line) for line in expected], f"from {at}"
    told = lines(tmp_path / "whole/out/learned-0.jsonl")
    assert lines(out / "learned-0.jsonl") == told[done:]
    before = expected[done - 1]["prompts_consumed"] if done else 0
    assert handed(tmp_path / "cut", 0) == handed(tmp_path / "whole", 0)[before:]


def killed(process: "subprocess.Popen[str]", out: Path, step: int) -> None:
    """Kill a run at a random moment soon after its log has a step."""
    log, until = StepLog(out), time.monotonic() + 120
    while not any(record.step >= step for record in log.read()):
        assert process.poll() is None, process.communicate()[0][-4000:]
        assert time.monotonic() < until
        time.sleep(0.002)
    time.sleep(random.uniform(0.0, 0.15))
    process.send_signal(signal.SIGKILL)
    process.communicate()
    assert process.returncode == -signal.SIGKILL


def test_steps_that_cannot_be_filled_leave_other_groups_out(
    model: Path, tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    trained(model, tmp_path, Numbers(), "first", steps=1, rounds=2)
    (record,) = StepLog(tmp_path).read()
    assert (record.rounds, record.prompts) == (2, 8)
    assert 1 <= record.groups <= 2
    (line,) = lines(tmp_path / "learned-0.jsonl")
    empty = [not ids for ids in line["completions"]]
    assert sum(empty) == (4 - record.groups) * 4
    assert all(not advantage for advantage, gone in zip(line["advantages"], empty, strict=True) if gone)
    assert f"learns from {record.groups} of 4 groups: 2 rounds are used up" in caplog.text


def test_the_loss_of_a_short_step_is_a_mean_over_what_is_learned(model: Path, tmp_path: Path) -> None:
    found = trainer(model, tmp_path, Numbers(), ["first"], rounds=2)
    found.current_gradient_accumulation_steps = 1
    found.model.train()
    batch = found._generate_and_score_completions([])
    kept = batch["completion_mask"].sum(dim=1) > 0
    assert 0 < kept.sum() < len(kept)
    alone = {name: value if value.ndim == 0 else value[kept] for name, value in batch.items()}
    with torch.no_grad():
        found.model.model.norm.weight *= 1.1
    expected = found._compute_loss(found.model, alone | {"loss_scale": torch.tensor(1.0)})
    clipped = [found._metrics["train"][f"clip_ratio/{name}"][-1] for name in ("low_mean", "high_mean")]
    assert sum(clipped) > 0
    assert found._compute_loss(found.model, batch).item() == pytest.approx(expected.item(), rel=1e-4)
    assert [found._metrics["train"][f"clip_ratio/{name}"][-1] for name in ("low_mean", "high_mean")] == (
        pytest.approx(clipped)
    )


def test_a_step_without_any_group_leaves_the_weights_alone(
    model: Path, tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    found = trainer(model, tmp_path, Numbers(), ["parity"], steps=3, rounds=1)
    rewards, found.reward_funcs = found.reward_funcs, [REWARDS["never"]]
    seen: list[Thing] = []

    class Watch(TrainerCallback):
        def on_step_end(self, *_: Thing, model: Thing, **__: Thing) -> None:
            seen.append(torch.cat([weights.detach().flatten() for weights in model.parameters()]))
            if len(seen) == 2:
                found.reward_funcs = rewards
            if len(seen) == 4:
                found.reward_funcs = [REWARDS["never"]]

    found.add_callback(Watch)
    start = torch.cat([weights.detach().flatten().clone() for weights in found.model.parameters()])
    found.train()
    assert torch.equal(seen[0], start)
    assert torch.equal(seen[1], start)
    assert not torch.equal(seen[2], start)
    assert torch.equal(seen[5], seen[3])
    records = StepLog(tmp_path).read()
    assert [record.groups == 0 for record in records] == [True, False, True]
    assert (records[0].zero_variance, records[0].reward, records[0].pass_rate) == (1.0, pytest.approx(0.7), 0.0)
    assert "the weights stay as they are" in caplog.text


def test_a_run_ends_with_its_stream(model: Path, tmp_path: Path) -> None:
    found = trained(model, tmp_path, Numbers(15), "parity", steps=50)
    records = StepLog(tmp_path).read()
    assert records[-1].prompts_consumed == 15
    assert len(records) < 15
    assert records[-1].groups < 4
    at = last_checkpoint(tmp_path)
    assert at is not None
    assert read_cursor(at).updates == found.state.global_step == 2 * len(records)


def test_an_empty_stream_is_an_error(model: Path, tmp_path: Path) -> None:
    with pytest.raises(TrainingError, match="the stream of prompts is empty"):
        trained(model, tmp_path, Numbers(0), "parity")


def test_rewards_of_two_datasets_take_turns(model: Path, tmp_path: Path) -> None:
    trained(model, tmp_path, Numbers(mixed=True), "of_ground_truth", "of_others", steps=2)
    groups = list(learned(tmp_path, 4))
    assert {group.number % 2 for group in groups} == {0, 1}
    for group in groups:
        rewards = [sum(ids) % 2 / (1 if group.number % 2 else 2) for ids in group.completions]
        assert len(set(rewards)) == 2
        best = [reward == max(rewards) for reward in rewards]
        assert [advantage > 0 for advantage in group.advantages] == best


def test_groups_that_no_reward_scores_are_left_out(model: Path, tmp_path: Path) -> None:
    trained(model, tmp_path, Numbers(mixed=True), "of_ground_truth", steps=1)
    assert all(group.number % 2 for group in learned(tmp_path, 4))
    (record,) = StepLog(tmp_path).read()
    assert record.zero_variance >= 0.5


def test_adapters_are_trained_against_the_model_without_them(model: Path, tmp_path: Path) -> None:
    found = trained(model, tmp_path, Numbers(), "parity", steps=2, lora=Lora(rank=2, alpha=4.0))
    check_groups(tmp_path, 4, 4, 1)
    names = [name for name, weights in found.model.named_parameters() if weights.requires_grad]
    assert names
    assert all("lora" in name for name in names)
    assert found.ref_model is None
    assert StepLog(tmp_path).read()[-1].kl > 0
    found.model.train()
    batch = found._generate_and_score_completions([])
    ids, mask = (torch.cat([batch[f"prompt_{each}"], batch[f"completion_{each}"]], 1) for each in ("ids", "mask"))
    width = batch["completion_ids"].shape[1]
    with found.model.disable_adapter(), torch.no_grad():
        bare = found._get_per_token_logps_and_entropies(found.model, ids, mask, width)[0]
    scored = batch["completion_mask"]
    assert torch.allclose(bare * scored, batch["ref_per_token_logps"] * scored, atol=1e-5)
    assert not torch.allclose(batch["old_per_token_logps"] * scored, batch["ref_per_token_logps"] * scored, atol=1e-4)


class Engine:
    """Substitute for TRL's vLLM engine on top of transformers, with slightly wrong probabilities."""

    def __init__(self, found: Thing) -> None:
        self.found, self.synced = found, 0

    def sync_weights(self) -> None:
        self.synced += 1

    def generate(self, prompts: Thing, **_: Thing) -> Thing:
        found = self.found
        found.use_vllm = False
        try:
            completions, _ = found._generate_single_turn(prompts, None, {}, found.num_generations)
        finally:
            found.use_vllm = True
        return prompts, completions, [[[-5.5 - 0.01 * (token % 2)] for token in ids] for ids in completions], None


def test_rollouts_of_vllm_are_resampled_with_their_corrections(model: Path, tmp_path: Path) -> None:
    found = trainer(model, tmp_path, Numbers(), ["parity"], steps=2)
    found.use_vllm, found._last_loaded_step, found.vllm_generation = True, -1, Engine(found)
    found.vllm_importance_sampling_mode = "sequence_mask"
    held: list[Thing] = []
    told = found._batch
    found._batch = lambda filled: held.append(told(filled)) or held[-1]
    found.train()
    check_groups(tmp_path, 4, 4, 1)
    assert found.vllm_generation.synced == 2
    for batch in held:
        mask = batch["completion_mask"]
        difference = ((batch["old_per_token_logps"] - batch["sampling_per_token_logps"]) * mask).sum(dim=1)
        ratio = difference.exp()
        kept = torch.where(ratio > 3.0, torch.zeros_like(ratio), ratio)
        assert torch.allclose(batch["importance_sampling_ratio"][:, 0], kept, rtol=1e-4)
        assert (kept > 0).any()


def test_log_probabilities_are_computed_for_the_groups_that_stay(model: Path, tmp_path: Path) -> None:
    found = trainer(model, tmp_path, Numbers(), ["parity"])
    scored: dict[str, int] = {}

    def count(name: str, each: Thing) -> None:
        score = each.forward

        def counted(*given: Thing, **named: Thing) -> Thing:
            scored[name] = scored.get(name, 0) + (len(named["input_ids"]) if named.get("fused_lm_head") else 0)
            return score(*given, **named)

        each.forward = counted

    count("policy", found.model)
    count("reference", found.ref_model)
    found.model.train()
    found._generate_and_score_completions([])
    assert found._meter.filled.answered > 4
    assert scored == {"policy": 16, "reference": 16}


def test_adapters_go_on_from_a_checkpoint(model: Path, tmp_path: Path) -> None:
    given: dict[str, Thing] = {"lora": Lora(rank=2), "save_every": 1}
    trained(model, tmp_path / "whole", Numbers(), "parity", steps=3, **given)
    trained(model, tmp_path / "cut", Numbers(), "parity", steps=2, **given)
    found = trainer(model, tmp_path / "cut", Numbers(), ["parity"], steps=3, **given)
    found.train(resume_from_checkpoint=True)
    whole, cut = (lines(tmp_path / name / "log.jsonl") for name in ("whole", "cut"))
    assert [without_times(line) for line in cut] == [without_times(line) for line in whole]


@pytest.mark.parametrize("precision", ["float32", "bfloat16"])
def test_rollouts_by_one_recorded_pass_go_on_as_they_were(model: Path, tmp_path: Path, precision: str) -> None:
    given: dict[str, Thing] = {"cuda_graphs": True, "save_every": 1, "precision": precision}
    trained(model, tmp_path / "whole", Numbers(), "parity", steps=3, **given)
    check_groups(tmp_path / "whole", 4, 4, 1)
    trained(model, tmp_path / "cut", Numbers(), "parity", steps=2, **given)
    found = trainer(model, tmp_path / "cut", Numbers(), ["parity"], steps=3, **given)
    found.train(resume_from_checkpoint=True)
    whole, cut = (lines(tmp_path / name / "log.jsonl") for name in ("whole", "cut"))
    assert [without_times(line) for line in cut] == [without_times(line) for line in whole]


def test_rollouts_by_one_recorded_pass_are_drawn_from_the_policy(model: Path, tmp_path: Path) -> None:
    """Pearson's χ² compares the first tokens of 4,000 completions with the softmax of the logits."""
    found = trainer(model, tmp_path, Numbers(), ["parity"], cuda_graphs=True, temperature=0.1)
    ids = found.processing_class("17?")["input_ids"]
    with torch.no_grad():
        logits = found.model(input_ids=torch.tensor([ids])).logits[0, -1].double() / 0.1
    expected = torch.softmax(logits, dim=0) * 4000
    drawn = found._rollouts([ids] * 4000)
    counts = torch.bincount(torch.tensor([tokens[0] for tokens in drawn]), minlength=258)
    common = expected >= 5
    observed = torch.cat([counts[common], counts[~common].sum()[None]]).double()
    wanted = torch.cat([expected[common], expected[~common].sum()[None]])
    statistic = float(((observed - wanted) ** 2 / wanted.clamp(min=1e-9)).sum())
    freedom = int(common.sum())
    assert freedom > 3
    assert statistic < freedom + 5 * (2 * freedom) ** 0.5
    assert {len(tokens) for tokens in drawn} <= set(range(1, 7))
    assert all(256 not in tokens[:-1] for tokens in drawn)


@pytest.mark.parametrize("other", ["lora", "vllm"])
def test_recorded_passes_stand_alone(other: str) -> None:
    with pytest.raises(ValueError, match="cuda_graphs: cannot be combined with vllm or lora"):
        settings(cuda_graphs=True, **{other: {}})


@pytest.mark.parametrize("lora", [None, Lora(rank=2)])
def test_what_is_trained_is_float32_under_bfloat16(model: Path, tmp_path: Path, lora: Thing) -> None:
    found = trained(model, tmp_path, Numbers(), "parity", steps=1, precision="bfloat16", lora=lora)
    kinds = {weights.dtype for weights in found.model.parameters() if weights.requires_grad}
    assert kinds == {torch.float32}
    frozen = {weights.dtype for weights in found.model.parameters() if not weights.requires_grad}
    assert frozen == (set() if lora is None else {torch.bfloat16})
    check_groups(tmp_path, 4, 4, 1)


def test_a_named_model_and_its_reference_are_loaded_as_they_are_told(model: Path, tmp_path: Path) -> None:
    from transformers import AutoTokenizer

    tokenizer, rewards = AutoTokenizer.from_pretrained(model), [REWARDS["parity"]]
    told = Checkpoint(str(model), "v1", "bfloat16", "eager")
    found = make_trainer(told, tokenizer, Numbers(), rewards, settings(beta=0.1), tmp_path)
    assert found.args.model_init_kwargs["revision"] == "v1"
    for loaded in (found.model, found.ref_model):
        assert (loaded.dtype, loaded.config._attn_implementation) == (torch.bfloat16, "eager")


def test_tensorboard_gets_what_the_log_gets(model: Path, tmp_path: Path) -> None:
    from tensorboard.backend.event_processing.event_accumulator import EventAccumulator

    trained(model, tmp_path, Numbers(), "parity", steps=2, report_to=("tensorboard",))
    (events,) = tmp_path.rglob("events.out.tfevents.*")
    found = EventAccumulator(str(events)).Reload()
    records = StepLog(tmp_path).read()
    for name, held in {"zero_variance": "zero_variance", "seconds/drawing": None, "kl": "kl", "loss": "loss"}.items():
        values = [event.value for event in found.Scalars(f"train/{name}")]
        expected = [getattr(record, held) if held else record.seconds.drawing for record in records]
        assert values == pytest.approx(expected, rel=1e-5)


@pytest.fixture
def wandb_steps(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[list[dict[str, float]]]:
    """Return the data that Weights & Biases is given at each step, in offline mode."""
    import wandb

    for name, value in {"WANDB_MODE": "offline", "WANDB_DIR": str(tmp_path), "WANDB_SILENT": "true"}.items():
        monkeypatch.setenv(name, value)
    steps, given = list[dict[str, float]](), wandb.Run.log

    def noted(run: Thing, data: dict[str, float], *rest: Thing, **others: Thing) -> None:
        steps.append(data)
        given(run, data, *rest, **others)

    monkeypatch.setattr(wandb.Run, "log", noted)
    yield steps
    wandb.finish()


def test_wandb_gets_what_the_log_gets(model: Path, tmp_path: Path, wandb_steps: list[dict[str, float]]) -> None:
    import wandb

    trained(model, tmp_path, Numbers(), "parity", steps=2, report_to=("wandb",))
    records = StepLog(tmp_path).read()
    for name in ("zero_variance", "kl", "loss"):
        found = [step[f"train/{name}"] for step in wandb_steps if f"train/{name}" in step]
        assert found == pytest.approx([getattr(record, name) for record in records], rel=1e-5)
        assert wandb.run.summary[f"train/{name}"] == pytest.approx(found[-1])
    assert [*tmp_path.rglob("run-*.wandb")]


def test_long_prompts_are_passed_over(model: Path, tmp_path: Path) -> None:
    stream = Numbers()
    trained(model, tmp_path, stream, "parity", steps=2, max_prompt_tokens=4)
    assert all(len(str(group.number)) + 1 + group.number % 5 <= 4 for group in learned(tmp_path, 4))
    records = StepLog(tmp_path).read()
    assert records[-1].prompts_consumed == stream.next > sum(record.prompts for record in records)


def test_a_model_in_memory_is_its_own_reference(model: Path, tmp_path: Path) -> None:
    from transformers import AutoModelForCausalLM, AutoTokenizer

    held = AutoModelForCausalLM.from_pretrained(model)
    with torch.no_grad():
        held.model.norm.weight += 0.5
    tokenizer = AutoTokenizer.from_pretrained(model)
    found = make_trainer(held, tokenizer, Numbers(), [REWARDS["parity"]], settings(), tmp_path)
    found.model.train()
    batch = found._generate_and_score_completions([])
    scored = batch["completion_mask"]
    assert torch.allclose(batch["old_per_token_logps"] * scored, batch["ref_per_token_logps"] * scored, atol=1e-5)


def test_a_stream_that_fails_says_why(model: Path, tmp_path: Path) -> None:
    class Broken(Numbers):
        def row(self, number: int) -> dict[str, Thing]:
            raise OSError(f"row {number} cannot be read")

    with pytest.raises(OSError, match="row 0 cannot be read"):
        trained(model, tmp_path, Broken(), "parity")


@pytest.mark.parametrize(
    ("changed", "said"), [({"microbatch": 4}, "into microbatches of 4"), ({"prompts": 5}, "into 2 minibatches")]
)
def test_settings_that_do_not_divide_are_refused(model: Path, tmp_path: Path, changed: Thing, said: str) -> None:
    with pytest.raises((TrainingError, ValueError), match=said):
        trainer(model, tmp_path, Numbers(), ["parity"], **{"generations": 3, "prompts": 4, **changed})


def test_another_number_of_minibatches_does_not_go_on(model: Path, tmp_path: Path) -> None:
    trained(model, tmp_path, Numbers(), "parity", steps=1)
    found = trainer(model, tmp_path, Numbers(), ["parity"], minibatches=4)
    with pytest.raises(TrainingError, match="another number of minibatches"):
        found.train(resume_from_checkpoint=True)


def test_a_run_does_not_begin_where_another_got_further(model: Path, tmp_path: Path) -> None:
    trained(model, tmp_path, Numbers(), "parity", steps=2, save_every=1)
    log = (tmp_path / "log.jsonl").read_bytes()
    found = trainer(model, tmp_path, Numbers(), ["parity"], steps=2, save_every=1)
    for begin in (None, tmp_path / "checkpoint-2"):
        with pytest.raises(TrainingError, match="holds a run up to checkpoint-4"):
            found.train(resume_from_checkpoint=begin)
    assert (tmp_path / "log.jsonl").read_bytes() == log
    (tmp_path / "checkpoint-4/cursor.json").unlink()
    stream = Numbers()
    found = trainer(model, tmp_path, stream, ["parity"], steps=2, save_every=1)
    found.train(resume_from_checkpoint=True)
    assert [record.step for record in StepLog(tmp_path).read()] == [1, 2]
    assert stream.handed[0] == StepLog(tmp_path).read()[0].prompts_consumed


def test_infinite_rewards_are_refused(model: Path, tmp_path: Path) -> None:
    found = trainer(model, tmp_path, Numbers(), ["parity"])
    found.reward_funcs = [lambda completion_ids, **_: [float("inf")] * len(completion_ids)]
    with pytest.raises(TrainingError, match="infinite reward"):
        found.train()


def test_a_run_that_diverges_stops(model: Path, tmp_path: Path) -> None:
    found = trainer(model, tmp_path, Numbers(), ["parity"], steps=3)
    told = found._batch

    def spoiled(filled: Thing) -> Thing:
        batch = told(filled)
        with torch.no_grad():
            found.model.model.norm.weight.fill_(float("nan"))
        return batch

    found._batch = spoiled
    with pytest.raises(TrainingError, match=r"step 1: .* is not finite: training has diverged"):
        found.train()


def test_another_version_of_trl_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    import trl

    from sim2reason.training.gspo import trainer as module

    monkeypatch.setattr(trl, "__version__", "1.17.0")
    with pytest.raises(TrainingError, match=r"trl 1\.17\.0 is installed.*pip install 'trl==1\.16"):
        importlib.reload(module)
