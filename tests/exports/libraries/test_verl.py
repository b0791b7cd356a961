"""verl, as far as it goes without a GPU: its configuration, its dataset, its loader of rewards, its reward manager."""

import asyncio
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from sim2reason.datasets.item import Item

verl = pytest.importorskip("verl", reason="make test-exports")
GSPO = (
    "algorithm.adv_estimator=grpo",
    "actor_rollout_ref.actor.policy_loss.loss_mode=gspo",
    "actor_rollout_ref.actor.loss_agg_mode=seq-mean-token-mean",
    "actor_rollout_ref.rollout.n=8",
)


def configured(folder: Path) -> object:
    """verl's own configuration with what the folder's README says."""
    from hydra import compose, initialize_config_dir

    reward = f"reward.custom_reward_function.path={folder / 'reward.py'}"
    files = f"data.train_files={folder / 'train.parquet'}", f"data.val_files={folder / 'test.parquet'}"
    named = "reward.custom_reward_function.name=compute_score"
    with initialize_config_dir(str(Path(verl.__file__).parent / "trainer/config"), version_base=None):
        return compose("ppo_trainer", overrides=[*files, reward, named, *GSPO])


def letters() -> object:
    """A tokenizer whose tokens are bytes."""
    from tokenizers import Tokenizer, decoders, models, pre_tokenizers
    from transformers import PreTrainedTokenizerFast

    alphabet = sorted(pre_tokenizers.ByteLevel.alphabet())
    pieces = Tokenizer(models.BPE(vocab={"<pad>": 0, **{c: n for n, c in enumerate(alphabet, 1)}}, merges=[]))
    pieces.pre_tokenizer, pieces.decoder = pre_tokenizers.ByteLevel(add_prefix_space=False), decoders.ByteLevel()
    tokenizer = PreTrainedTokenizerFast(tokenizer_object=pieces, pad_token="<pad>")
    tokenizer.chat_template = "{% for message in messages %}{{ message.content }}{% endfor %}"
    return tokenizer


def test_its_dataset_and_its_reward_manager_take_every_row(
    exported: Callable[[str], Path],
    items: dict[str, Item],
    right: Callable[[Item], str],
    wrong: Callable[[Item], Iterator[str]],
    tmp_path: Path,
) -> None:
    import numpy as np
    import torch
    from omegaconf import open_dict
    from verl import DataProto
    from verl.experimental.reward_loop.reward_manager.naive import NaiveRewardManager
    from verl.trainer.ppo.reward import get_custom_reward_fn
    from verl.utils.dataset.rl_dataset import RLHFDataset

    config, tokenizer = configured(exported("verl")), letters()
    with open_dict(config):
        config.data.cache_dir, config.data.max_prompt_length = str(tmp_path / "cache"), 4096
    compute_score = get_custom_reward_fn(config)

    def scored(manager: NaiveRewardManager, row: dict[str, object], text: str) -> float:
        ids = torch.tensor([tokenizer(text)["input_ids"]])
        tensors = {"responses": ids, "attention_mask": torch.ones_like(ids)}
        columns = {name: np.array([row[name]], dtype=object) for name in ("data_source", "reward_model", "extra_info")}
        data = DataProto.from_dict(tensors=tensors, non_tensors=columns)
        return manager.loop.run_until_complete(manager.run_single(data))["reward_score"]

    seen = set()
    loop = asyncio.new_event_loop()
    asyncio.set_event_loop(loop)
    manager = NaiveRewardManager(config, tokenizer, compute_score)
    manager.loop = loop
    for files in (config.data.train_files, config.data.val_files):
        data = RLHFDataset(files, tokenizer, config.data)
        for number in range(len(data)):
            row = data[number]
            item = items[row["extra_info"]["id"]]
            seen.add(item.id)
            assert row["index"] == number
            assert list(row["raw_prompt"]) == [{"role": "user", "content": item.prompt}]
            assert scored(manager, row, right(item)) == 1.0
            assert [scored(manager, row, said) for said in wrong(item)] == [0.0] * len(item.distractors)
    loop.close()
    assert seen == set(items)


def test_the_page_is_true(follow: Callable[[str], None]) -> None:
    follow("verl")
