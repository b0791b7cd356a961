"""Completions of the model during training: their log-probabilities, and groups of them for the batch of a step."""

# torch and trl are an extra and ship no types to an environment without them:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from collections.abc import Sequence
from copy import deepcopy
from typing import Any, TypeAlias

from sim2reason.base.records import cached_property
from sim2reason.errors import TrainingError
from sim2reason.evaluation.policies.decoding import Decoder, check_recordable
from sim2reason.training.extras import library

__all__ = ["Group", "Rollouts", "cut", "filler", "join", "moved", "score"]


Tensor: TypeAlias = Any
Group: TypeAlias = dict[str, Tensor]
"""What TRL keeps for the completions of one prompt, without columns that are padding for all of them."""

PROMPT = {"prompt_ids", "prompt_mask"}  # (completions, tokens), padded on the left
COMPLETION = {  # (completions, tokens), padded on the right
    "completion_ids",
    "completion_mask",
    "old_per_token_logps",
    "ref_per_token_logps",
    "sampling_per_token_logps",
}
ROW = {"advantages", "importance_sampling_ratio"}  # one number per completion
BATCH = {"num_items_in_batch"}  # one number for the batch, computed again


def cut(output: dict[str, Tensor], number: int, generations: int) -> Group:
    """Return the completions of one prompt, the `number`-th of this process, as a group cut from TRL's batch.

    Raises:
        TrainingError: TRL keeps something that `join` could not put together, such as pictures.
    """
    unknown = output.keys() - PROMPT - COMPLETION - ROW - BATCH
    if unknown:
        raise TrainingError(f"TRL keeps {', '.join(sorted(unknown))} for completions, which cannot be resampled here")
    rows = slice(number * generations, (number + 1) * generations)
    prompt = max(int(output["prompt_mask"][rows].sum(dim=1).max()), 1)
    completion = max(int(output["completion_mask"][rows].sum(dim=1).max()), 1)
    group: Group = {}
    for name in sorted(output.keys() - BATCH):
        tensor = output[name][rows]
        group[name] = (
            tensor[:, -prompt:] if name in PROMPT else tensor[:, :completion] if name in COMPLETION else tensor
        )
    return group


def filler(size: int, token: int, device: object) -> Group:
    """Return a group that fills a batch without affecting the loss: a prompt and completions of one token each."""
    torch = library("torch")
    ids = torch.full((size, 1), token, device=device)
    nothing = torch.zeros(size, 1, device=device)
    group: Group = dict.fromkeys(COMPLETION, nothing)
    group |= {"prompt_ids": ids, "prompt_mask": torch.ones_like(ids)}
    group |= {"completion_ids": ids, "completion_mask": torch.zeros_like(ids)}
    return group | {"advantages": nothing[:, 0], "importance_sampling_ratio": torch.ones_like(nothing)}


def join(groups: Sequence[Group], token: int) -> dict[str, Tensor]:
    """Return several groups of completions as one batch, padded with `token` to the longest prompt and completion."""
    torch = library("torch")
    batch: dict[str, Tensor] = {}
    for name in sorted(set[str](groups[0]).intersection(*groups)):  # fillers have all names, groups what TRL needs
        parts = [group[name] for group in groups]
        if name not in ROW:
            width = max(part.shape[1] for part in parts)
            fill = token if name.endswith("_ids") else 0
            parts = [_padded(part, width, fill, left=name in PROMPT) for part in parts]
        batch[name] = torch.cat(parts)
    return batch


def _padded(part: Tensor, width: int, fill: int, *, left: bool) -> Tensor:
    missing = width - part.shape[1]
    return library("torch.nn.functional").pad(part, (missing, 0) if left else (0, missing), value=fill)


def moved(group: Group, device: object) -> Group:
    """Return a group of completions on another device."""
    return {name: tensor.to(device) for name, tensor in group.items()}


def score(trainer: Any, batch: dict[str, Tensor]) -> None:  # noqa: ANN401 - ours, which imports this module
    """Add to a batch the log-probabilities of its completions under the generating and the reference policy.

    TRL computes them for all completions; here the selection of groups is already known.
    """
    torch, model = library("torch"), trainer.model
    ids, mask = (torch.cat([batch[f"prompt_{each}"], batch[f"completion_{each}"]], dim=1) for each in ("ids", "mask"))
    given = (ids, mask, batch["completion_ids"].shape[1], trainer.args.per_device_train_batch_size)
    plain = library("trl.models.utils").disable_gradient_checkpointing
    with torch.no_grad(), plain(model, trainer.args.gradient_checkpointing_kwargs):
        batch["old_per_token_logps"] = trainer.logps(model, *given)
        if trainer.beta and trainer.ref_model is not None:
            batch["ref_per_token_logps"] = trainer.logps(trainer.ref_model, *given)
        elif trainer.beta:  # adapters: the model without them, or with a copy of those that it came with
            bare = trainer.accelerator.unwrap_model(model)
            reference = "ref" if "ref" in bare.peft_config else None
            with library("trl.trainer.utils").use_adapter(bare, adapter_name=reference):
                batch["ref_per_token_logps"] = trainer.logps(model, *given)


class Rollouts:
    """The generator of completions for a trainer."""

    def __init__(self, trainer: Any) -> None:  # noqa: ANN401 - of TRL
        """Store an initialised TRL trainer; PolicyError if its model's passes cannot be recorded."""
        check_recordable(trainer.model.config)
        self._trainer = trainer

    @cached_property
    def _models(self) -> tuple[Any, Any]:
        """Return the trained model, and the one that generates: a bfloat16 copy if computations use that type.

        Autocasting instead would produce keys and values of two types, and cast all weights for each token.
        """
        trained = self._trainer.accelerator.unwrap_model(self._trainer.model)
        if not self._trainer.args.bf16:
            return trained, trained
        torch, config = library("torch"), deepcopy(trained.config)  # the type that is asked for is written into it
        with torch.random.fork_rng(devices=[]):  # what is sampled does not hang on when a copy was made
            copied = library("transformers").AutoModelForCausalLM.from_config(config, dtype=torch.bfloat16)
        return trained, copied.to(trained.device)

    @cached_property
    def _decoder(self) -> Decoder:
        return Decoder(self._models[1])

    def __call__(self, prompts: Sequence[Sequence[int]]) -> list[list[int]]:
        """Return the tokens of a completion for each prompt, including the end token."""
        torch, trainer = library("torch"), self._trainer
        self._refresh()
        width, pad = max(map(len, prompts)), trainer._tokenizer.pad_token_id  # noqa: SLF001 - TRL's own
        rows = [[pad] * (width - len(prompt)) + list(prompt) for prompt in prompts]
        mask = [[0] * (width - len(prompt)) + [1] * len(prompt) for prompt in prompts]
        ids, mask = (torch.tensor(each, device=trainer.accelerator.device) for each in (rows, mask))
        ends = frozenset(trainer.eos_token_ids)
        completions = self._decoder(ids, mask, trainer.max_completion_length, self._sampled, ends).tolist()
        return [_cut(tokens, ends) for tokens in completions]

    def _refresh(self) -> None:
        """Copy the trained weights to the model that generates completions."""
        trained, answering = self._models
        if answering is not trained:
            with library("torch").no_grad():
                for mine, theirs in zip(answering.parameters(), trained.parameters(), strict=True):
                    mine.copy_(theirs)

    def _sampled(self, logits: Tensor) -> Tensor:
        """Return a random token for each row of logits, by comparison of exponential random variables."""
        rates = (logits / self._trainer.temperature).softmax(dim=1)
        return (rates / library("torch").empty_like(rates).exponential_()).argmax(dim=1)


def _cut(tokens: list[int], ends: frozenset[int]) -> list[int]:
    """Return the tokens of a completion up to its first end token, inclusive."""
    end = next((position for position, token in enumerate(tokens) if token in ends), len(tokens))
    return tokens[: end + 1]
