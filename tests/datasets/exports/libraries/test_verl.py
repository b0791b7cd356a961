"""Tests of verl without a GPU: the experiment's configuration, its rows, its reward, the start of a run."""

import asyncio
import os
import pickle
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml

from sim2reason.generation.item import Item

verl = pytest.importorskip("verl", reason="make test-exports")
EXPERIMENT = Path(__file__).parents[4] / "experiments/verl"
SIZES = sorted(path.stem for path in (EXPERIMENT / "size").glob("*.yaml"))
SETTINGS = [EXPERIMENT / "gspo.yaml", *(EXPERIMENT / "size").glob("*.yaml")]
DRAWN = "items: 40\nrecipe: [pulley, springs]\ndifficulty: easy\nseed: 3\nmaker: fake_makers:with_answers\n"
PAPER = {
    "trainer.total_training_steps": 200,
    "data.train_batch_size": 32,
    "data.max_prompt_length": 2048,
    "data.max_response_length": 16384,
    "algorithm.adv_estimator": "grpo",
    "algorithm.filter_groups.enable": True,
    "algorithm.filter_groups.metric": "reward",
    "algorithm.filter_groups.max_num_gen_batches": 10,
    "actor_rollout_ref.rollout.n": 16,
    "actor_rollout_ref.rollout.temperature": 1.0,
    "actor_rollout_ref.actor.policy_loss.loss_mode": "gspo",
    "actor_rollout_ref.actor.loss_agg_mode": "seq-mean-token-mean",
    "actor_rollout_ref.actor.clip_ratio_low": 0.0003,
    "actor_rollout_ref.actor.clip_ratio_high": 0.0004,
    "actor_rollout_ref.actor.use_kl_loss": True,
    "actor_rollout_ref.actor.kl_loss_coef": 0.001,
    "actor_rollout_ref.actor.optim.lr": 1e-6,
    "actor_rollout_ref.actor.optim.lr_warmup_steps": 10,
    "actor_rollout_ref.actor.optim.weight_decay": 0.1,
    "actor_rollout_ref.actor.optim.clip_grad": 1.0,
}


def composed(name: str, *overrides: str) -> object:
    """Return a configuration of the experiment, or verl's own."""
    from hydra import compose, initialize_config_dir

    theirs = Path(verl.__file__).parent / "trainer/config"
    with initialize_config_dir(str(theirs if name == "ppo_trainer" else EXPERIMENT), version_base=None):
        return compose(name, overrides=[f"hydra.searchpath=[file://{theirs}]", *overrides])


def configured(folder: Path, *overrides: str) -> object:
    """Return the configuration that train.sh uses, with the problems of a folder."""
    files = f"data.train_files={folder / 'train.parquet'}", f"data.val_files={folder / 'test.parquet'}"
    reward = f"reward.custom_reward_function.path={folder / 'reward.py'}"
    cache = f"+data.cache_dir={folder / 'cache'}"
    return composed("gspo", *files, reward, cache, "data.max_prompt_length=4096", *overrides)


def leaves(settings: dict[str, Any], place: str = "") -> Iterator[str]:
    for name, value in settings.items():
        if isinstance(value, dict):
            yield from leaves(value, f"{place}{name}.")
        else:
            yield place + name


def unknown(settings: dict[str, Any], schema: object) -> list[str]:
    """Return the keys that verl's configuration lacks, which hydra adds silently from a file."""
    from omegaconf import OmegaConf

    plain = OmegaConf.to_container(schema)
    known = set(leaves(plain))
    return [key for key in leaves(settings) if key not in known]


@pytest.fixture(scope="module")
def letters() -> object:
    """Build a tokenizer whose tokens are bytes."""
    from tokenizers import Tokenizer, decoders, models, pre_tokenizers
    from transformers import PreTrainedTokenizerFast

    alphabet = sorted(pre_tokenizers.ByteLevel.alphabet())
    pieces = Tokenizer(models.BPE(vocab={"<pad>": 0, **{c: n for n, c in enumerate(alphabet, 1)}}, merges=[]))
    pieces.pre_tokenizer, pieces.decoder = pre_tokenizers.ByteLevel(add_prefix_space=False), decoders.ByteLevel()
    tokenizer = PreTrainedTokenizerFast(tokenizer_object=pieces, pad_token="<pad>", eos_token="<pad>")
    tokenizer.chat_template = "{% for message in messages %}{{ message.content }}{% endfor %}"
    return tokenizer


@pytest.fixture
def described(tmp_path: Path) -> Path:
    path = tmp_path / "problems.yaml"
    path.write_text(DRAWN)
    return path


@pytest.fixture
def foreign(tmp_path: Path) -> Path:
    """Write rows in the format of DAPO-Math-17k, with one additional column."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    rows = [
        {
            "data_source": "math_dapo",
            "prompt": [{"role": "user", "content": f"What is {n} + 1? End with: Answer: $Answer"}],
            "ability": "MATH",
            "reward_model": {"style": "rule-lighteval/MATH_v2", "ground_truth": str(n + 1)},
            "extra_info": {"index": f"row {n}"},
            "level": n,
        }
        for n in range(12)
    ]
    pq.write_table(pa.Table.from_pylist(rows), tmp_path / "dapo.parquet")
    return tmp_path / "dapo.parquet"


@pytest.mark.parametrize("path", SETTINGS, ids=lambda path: path.stem)
def test_every_key_of_ours_is_verls(path: Path) -> None:
    settings = yaml.safe_load(path.read_text())
    settings.pop("defaults", None)
    schema = composed("ppo_trainer")
    assert list(leaves(settings))
    assert unknown(settings, schema) == []
    for key in leaves(settings):
        *sections, last = key.split(".")
        spoiled: dict[str, Any] = {last + "s": 1}
        for section in reversed(sections):
            spoiled = {section: spoiled}
        assert unknown(spoiled, schema) == [key + "s"]


@pytest.mark.parametrize("size", SIZES)
def test_it_composes_in_each_size_and_verl_finds_it_valid(size: str, tmp_path: Path) -> None:
    from omegaconf import OmegaConf
    from verl.trainer.ppo.utils import need_critic, need_reference_policy
    from verl.utils.config import omega_conf_to_dataclass, validate_config

    config = configured(tmp_path, f"size={size}", "data.max_prompt_length=2048")
    assert {key: OmegaConf.select(config, key) for key in PAPER} == PAPER
    assert size.upper() in config.actor_rollout_ref.model.path
    assert need_reference_policy(config)
    assert not need_critic(config)
    validate_config(config, need_reference_policy(config), use_critic=False)
    for part in (config.algorithm, config.actor_rollout_ref.rollout, config.actor_rollout_ref.actor):
        omega_conf_to_dataclass(part)
    rollout, actor = config.actor_rollout_ref.rollout, config.actor_rollout_ref.actor
    longest = config.data.max_prompt_length + config.data.max_response_length
    assert longest <= rollout.max_model_len
    assert longest <= actor.ppo_max_token_len_per_gpu * actor.fsdp_config.ulysses_sequence_parallel_size
    assert config.trainer.n_gpus_per_node % rollout.tensor_model_parallel_size == 0
    assert config.data.train_batch_size % actor.ppo_mini_batch_size == 0


def test_the_sizes_are_the_papers() -> None:
    assert SIZES == ["14b", "30b-a3b", "32b", "3b", "7b"]


@pytest.mark.parametrize(
    ("ratio", "advantage", "clipped"),
    [(1.0003, 1.0, False), (1.0005, 1.0, True), (0.9998, -1.0, False), (0.9996, -1.0, True), (1.2, -1.0, False)],
)
def test_the_loss_clips_the_ratio_of_a_sequence_where_the_paper_does(
    tmp_path: Path, ratio: float, advantage: float, *, clipped: bool
) -> None:
    import torch
    from verl.trainer.ppo.core_algos import get_policy_loss_fn
    from verl.utils.config import omega_conf_to_dataclass

    actor = omega_conf_to_dataclass(configured(tmp_path).actor_rollout_ref.actor)
    old = torch.full((1, 4), -1.0)
    new = (old + torch.tensor(ratio).log()).requires_grad_()
    loss = get_policy_loss_fn(actor.policy_loss.loss_mode)
    found, _ = loss(old, new, torch.full((1, 4), advantage), torch.ones(1, 4), actor.loss_agg_mode, actor)
    (gradient,) = torch.autograd.grad(found, new)
    assert bool((gradient == 0).all()) is clipped


def scored(manager: object, row: dict[str, Any], text: str) -> float:
    """Return the score that verl's reward manager gives to a response."""
    import numpy as np
    import torch
    from verl import DataProto

    ids = torch.tensor([manager.tokenizer(text)["input_ids"]])
    tensors = {"responses": ids, "attention_mask": torch.ones_like(ids)}
    columns = {name: np.array([row[name]], dtype=object) for name in ("data_source", "reward_model", "extra_info")}
    data = DataProto.from_dict(tensors=tensors, non_tensors=columns)
    return manager.loop.run_until_complete(manager.run_single(data))["reward_score"]


@pytest.fixture
def manager(exported: Callable[[str], Path], letters: object) -> Iterator[Any]:
    """Yield verl's reward manager with the exported reward."""
    from verl.trainer.ppo.reward import get_custom_reward_fn, resolve_reward_manager_cls

    config = configured(exported("verl"))
    loop = asyncio.new_event_loop()
    asyncio.set_event_loop(loop)
    found = resolve_reward_manager_cls(config)(config, letters, get_custom_reward_fn(config))
    found.loop = loop
    yield found
    loop.close()


def test_stored_rows_are_loaded_and_paid_by_either_class(
    manager: object,
    items: dict[str, Item],
    right: Callable[[Item], str],
    wrong: Callable[[Item], Iterator[str]],
) -> None:
    from verl.utils.dataset.rl_dataset import RLHFDataset, get_dataset_class

    data_config, seen = manager.config.data, set()
    for files in (data_config.train_files, data_config.val_files):
        data = RLHFDataset(files, manager.tokenizer, data_config)
        same = get_dataset_class(data_config)(files, manager.tokenizer, data_config)
        assert len(data) == len(same)
        for number in range(len(data)):
            row = data[number]
            item = items[row["extra_info"]["id"]]
            seen.add(item.id)
            assert row["index"] == number
            assert list(row["raw_prompt"]) == [{"role": "user", "content": item.prompt}]
            assert {**same[number], "dummy_tensor": None} == {**row, "dummy_tensor": None}
            assert scored(manager, row, right(item)) == 1.0
            assert [scored(manager, row, said) for said in wrong(item)] == [0.0] * len(item.distractors)
    assert seen == set(items)


def test_drawn_rows_are_paid_too(manager: object, described: Path, right: Callable[[Item], str]) -> None:
    from verl.trainer.ppo.utils import create_rl_dataset

    from sim2reason.generation.make import make
    from sim2reason.generation.request import Request

    described.write_text("items: 6\nrecipe: [projectile, collision]\nmode: [numeric, symbolic]\nseed: 8\n")
    data = create_rl_dataset(str(described), manager.config.data, manager.tokenizer, None)
    for number in range(len(data)):
        row = data[number]
        item = make(Request.named(row["extra_info"]["id"])).item
        assert item is not None
        assert row["raw_prompt"] == [{"role": "user", "content": item.prompt}]
        assert scored(manager, row, right(item)) == 1.0
        assert scored(manager, row, "I give up.") == 0.0


def plain(batch: dict[str, Any]) -> dict[str, Any]:
    return {name: values.tolist() for name, values in batch.items()}


def loader(data: object, config: object, workers: int) -> object:
    """Build the data loader of verl's trainer with batches of 4, though filtered groups need batches of 1."""
    from torchdata.stateful_dataloader import StatefulDataLoader
    from verl.trainer.ppo.utils import create_rl_sampler
    from verl.utils.dataset.rl_dataset import collate_fn

    sampler = create_rl_sampler(config, data)
    return StatefulDataLoader(
        dataset=data, batch_size=4, num_workers=workers, drop_last=True, collate_fn=collate_fn, sampler=sampler
    )


@pytest.mark.filterwarnings("ignore")
def test_workers_processes_and_a_resumed_run_get_the_same_rows(
    described: Path, foreign: Path, letters: object, tmp_path: Path
) -> None:
    from verl.trainer.ppo.utils import create_rl_dataset

    described.write_text(f"{DRAWN}share: 0.5\n")
    config = configured(tmp_path).data
    data = create_rl_dataset([str(described), str(foreign)], config, letters, None)
    assert len(data) == 40
    alone = [plain(batch) for batch in loader(data, config, 0)]
    assert len(alone) == 10
    assert [plain(batch) for batch in loader(data, config, 2)] == alone
    assert [plain(batch) for batch in loader(pickle.loads(pickle.dumps(data)), config, 0)] == alone
    for batch in alone:
        assert sorted(batch["data_source"]) == ["math_dapo"] * 2 + ["sim2reason"] * 2
    begun = loader(data, config, 2)
    before = iter(begun)
    assert [plain(next(before)) for _ in range(3)] == alone[:3]
    resumed = loader(data, config, 2)
    resumed.load_state_dict(begun.state_dict())
    assert [plain(batch) for batch in resumed] == alone[3:]


def test_a_mixture_is_paid_by_the_rule_of_each_source(manager: object, described: Path, foreign: Path) -> None:
    from verl.trainer.ppo.utils import create_rl_dataset

    described.write_text(f"{DRAWN}share: 0.25\n")
    data = create_rl_dataset([str(described), str(foreign)], manager.config.data, manager.tokenizer, None)
    rows = [data[number] for number in range(len(data))]
    others = [row for row in rows if row["data_source"] == "math_dapo"]
    assert len(others) == 30
    for row in others[:5]:
        right = row["reward_model"]["ground_truth"]
        assert scored(manager, row, f"So.\nAnswer: {right}") == 1.0
        assert scored(manager, row, f"So.\nAnswer: {right}0") == 0.0
        assert scored(manager, row, "I give up.") == 0.0


def test_fewer_rows_can_be_asked_for(described: Path, letters: object, tmp_path: Path) -> None:
    from verl.trainer.ppo.utils import create_rl_dataset

    config = configured(tmp_path).data
    assert len(create_rl_dataset(str(described), config, letters, None, max_samples=8)) == 8
    assert len(create_rl_dataset(str(described), config, letters, None, max_samples=800)) == 40


def test_two_files_of_what_to_draw_are_refused(described: Path, letters: object, tmp_path: Path) -> None:
    from verl.trainer.ppo.utils import create_rl_dataset

    from sim2reason.errors import DatasetError

    with pytest.raises(DatasetError, match="more than one file of what to draw; give one"):
        create_rl_dataset([str(described)] * 2, configured(tmp_path).data, letters, None)


@pytest.fixture
def train(exported: Callable[[str], Path], tmp_path: Path) -> Callable[..., subprocess.CompletedProcess[str]]:
    """Return a function that calls train.sh, without a GPU, with further arguments and variables."""
    folder, path = exported("verl"), f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    environ = {"PATH": path, "CUDA_VISIBLE_DEVICES": "", "HF_HUB_OFFLINE": "1", "HF_HOME": str(tmp_path / "cache")}

    def call(*more: str, **variables: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [str(EXPERIMENT / "train.sh"), "3b", str(folder), *more],
            cwd=tmp_path,
            env=os.environ | environ | variables,
            capture_output=True,
            text=True,
            check=False,
            timeout=900,
        )

    return call


def test_the_command_mixes_stored_rows_in(
    train: Callable[..., subprocess.CompletedProcess[str]], foreign: Path, letters: object, tmp_path: Path
) -> None:
    from verl.trainer.ppo.utils import create_rl_dataset

    config = configured(tmp_path).data
    for variables, source in (({}, "sim2reason"), ({"STORED": str(foreign)}, "math_dapo")):
        done = train("--cfg", "job", "--package", "data", **variables)
        assert done.returncode == 0, done.stderr
        files = yaml.safe_load(done.stdout.split("# @package data", 1)[-1])["train_files"]
        data = create_rl_dataset(files, config, letters, None)
        assert len(data) == 2**20
        assert data[0]["data_source"] == source
        assert data[1]["data_source"] == "sim2reason"


def test_a_run_starts_and_stops_where_it_needs_gpus(
    train: Callable[..., subprocess.CompletedProcess[str]], letters: object, tmp_path: Path
) -> None:
    """The start command makes both datasets on a local Ray cluster and plans 200 steps, before it needs GPUs."""
    from transformers import Qwen2Config

    letters.save_pretrained(tmp_path / "tiny")
    Qwen2Config(vocab_size=257, architectures=["Qwen2ForCausalLM"]).save_pretrained(tmp_path / "tiny")
    done = train(f"actor_rollout_ref.model.path={tmp_path / 'tiny'}", "ray_kwargs.ray_init.num_cpus=16")
    said = done.stdout + done.stderr
    assert done.returncode != 0
    assert "All configuration checks passed" in said
    assert said.count("Using dataset class: LazyDataset") == 2
    assert "train dataset size: 1048576" in said
    assert "Total training steps: 200" in said
    assert "ValueError: Total available GPUs 0 is less than total desired GPUs 8" in said


def test_the_page_is_true(follow: Callable[[str], None]) -> None:
    follow("verl")
