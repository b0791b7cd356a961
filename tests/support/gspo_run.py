"""Run of GSPO on a tiny random model, in this process or by torchrun, with a log of its batches.

python gspo_run.py FOLDER '{"settings": {...}, "rewards": ["parity"], ...}'
"""

import json
import sys
import time
import warnings
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, TypeAlias

Thing: TypeAlias = Any  # of libraries that ship no types here
Tokens: TypeAlias = Sequence[Sequence[int]]

HOPELESS = 3  # one prompt of so many has no right completion


class Numbers:
    """Endless or finite stream of prompts, each with one number."""

    cpu_seconds = 0.0

    def __init__(self, length: int | None = None, *, mixed: bool = False, pause: float = 0.0) -> None:
        self.length, self.mixed, self.pause = length, mixed, pause
        self.next = 0
        self.handed: list[int] = []
        self.observed: list[tuple[int, list[float]]] = []

    def next_prompts(self, count: int) -> list[dict[str, Any]]:
        end = self.next + count if self.length is None else min(self.next + count, self.length)
        found = list(range(self.next, end))
        self.handed += found
        time.sleep(self.pause)
        self.next = end
        return [self.row(number) for number in found]

    def row(self, number: int) -> dict[str, Any]:
        text = f"{number}" + "?" * (1 + number % 5)  # of several lengths
        row: dict[str, Any] = {"prompt": text, "number": number}
        if self.mixed:
            row |= {"ground_truth": "odd"} if number % 2 else {"other": "even"}
        return row

    def observe(self, row: Mapping[str, Any], rewards: Sequence[float]) -> None:
        self.observed.append((row["number"], list(rewards)))

    def state(self) -> int:
        return self.next

    def restore(self, state: Thing) -> None:
        self.next = state


def parity(number: Sequence[int], completion_ids: Tokens, **_: Thing) -> list[float]:
    """Return 1 for an even sum of tokens and 0 for an odd one, and 0 for all hopeless prompts."""
    return [
        float(sum(ids) % 2 == 0 and which % HOPELESS != 0) for ids, which in zip(completion_ids, number, strict=True)
    ]


def never(completion_ids: Tokens, **_: Thing) -> list[float]:
    return [0.7 for _ in completion_ids]


def first(number: Sequence[int], completion_ids: Tokens, **_: Thing) -> list[float]:
    """Return 1 for an even sum of tokens of the first two prompts, and 0 for all others."""
    return [float(sum(ids) % 2 == 0 and which < 2) for ids, which in zip(completion_ids, number, strict=True)]


def of_ground_truth(completion_ids: Tokens, ground_truth: Sequence[str | None], **_: Thing) -> list[float | None]:
    return [float(sum(ids) % 2) if right else None for ids, right in zip(completion_ids, ground_truth, strict=True)]


def of_others(completion_ids: Tokens, other: Sequence[str | None], **_: Thing) -> list[float | None]:
    return [float(sum(ids) % 2) / 2 if right else None for ids, right in zip(completion_ids, other, strict=True)]


REWARDS = {each.__name__: each for each in (parity, never, first, of_ground_truth, of_others)}


def tiny_model(folder: Path, heads: int = 2) -> Path:
    """Write a Qwen2 of two layers with a token for each byte, and return its folder."""
    import torch
    from tokenizers import Tokenizer, decoders, models, pre_tokenizers
    from transformers import PreTrainedTokenizerFast, Qwen2Config, Qwen2ForCausalLM

    letters = sorted(pre_tokenizers.ByteLevel.alphabet())
    vocabulary = {letter: number for number, letter in enumerate([*letters, "<|end|>", "<|pad|>"])}
    tokenizer: Any = Tokenizer(models.BPE(vocabulary, []))
    tokenizer.pre_tokenizer = pre_tokenizers.ByteLevel(add_prefix_space=False)
    tokenizer.decoder = decoders.ByteLevel()
    fast = PreTrainedTokenizerFast(tokenizer_object=tokenizer, eos_token="<|end|>", pad_token="<|pad|>")
    fast.save_pretrained(folder)
    torch.manual_seed(0)
    shape = {"hidden_size": 32, "intermediate_size": 64, "num_hidden_layers": 2, "num_attention_heads": heads}
    ends = {"eos_token_id": 256, "pad_token_id": 257, "bos_token_id": None}
    model = Qwen2ForCausalLM(
        Qwen2Config(vocab_size=258, num_key_value_heads=heads, tie_word_embeddings=True, **shape, **ends)
    )
    with torch.no_grad():
        model.model.embed_tokens.weight[256] *= 20.0  # some completions end before the greatest length
    model.save_pretrained(folder)
    return folder


def settings(**changed: Thing) -> Thing:
    from sim2reason.training.gspo import GSPOSettings

    given = {
        "steps": 3,
        "prompts": 4,
        "generations": 4,
        "minibatches": 2,
        "max_completion_tokens": 6,
        "learning_rate": 1e-3,
        "warmup_steps": 0,
        "save_every": 1000,
        "gradient_checkpointing": False,
    }
    return GSPOSettings.model_validate(given | changed)


def trainer(model: Path, out: Path, stream: Thing, rewards: Sequence[str], **changed: Thing) -> Thing:
    """Return a trainer that logs the batch of each step in `out`."""
    from transformers import AutoTokenizer

    from sim2reason.training.gspo import make_trainer

    tokenizer = AutoTokenizer.from_pretrained(model)
    found = make_trainer(model, tokenizer, stream, [REWARDS[name] for name in rewards], settings(**changed), out)
    batch = found._batch

    def told(filled: Thing) -> Thing:
        learned = batch(filled)
        tell(found, learned, out / f"learned-{found.accelerator.process_index}.jsonl")
        return learned

    found._batch = told
    return found


def tell(trainer: Thing, batch: Thing, path: Path) -> None:
    """Append a line with a batch: prompts, tokens of completions, advantages."""
    shown = {
        "step": trainer.state.global_step // trainer.settings.minibatches + 1,
        "prompts": [
            trainer.processing_class.decode(ids[mask.bool()])
            for ids, mask in zip(batch["prompt_ids"], batch["prompt_mask"], strict=True)
        ],
        "completions": [
            ids[mask.bool()].tolist()
            for ids, mask in zip(batch["completion_ids"], batch["completion_mask"], strict=True)
        ],
        "advantages": batch["advantages"].tolist(),
        "items": int(batch["num_items_in_batch"]),
    }
    with path.open("a") as file:
        file.write(json.dumps(shown) + "\n")


def main() -> None:
    warnings.simplefilter("ignore")
    folder, given = Path(sys.argv[1]), json.loads(sys.argv[2])
    stream = Numbers(given.get("length"), pause=given.get("pause", 0.0))
    run = trainer(Path(given["model"]), folder / "out", stream, given["rewards"], **given["settings"])
    run.train(resume_from_checkpoint=given.get("resume"))
    run.accelerator.end_training()  # or a process that ends first may break the other's connection
    (folder / f"handed-{run.accelerator.process_index}.json").write_text(json.dumps(stream.handed))


if __name__ == "__main__":
    main()
