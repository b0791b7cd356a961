"""Completions of the model during training, and their log-probabilities."""

from collections.abc import Sequence
from copy import deepcopy
from typing import Any, TypeAlias

from sim2reason.base.records import cached_property
from sim2reason.evaluation.policies.parts.decoding import Decoder, check_recordable
from sim2reason.training.extras import library

__all__ = ["Rollouts", "score"]

# torch and trl are an extra and ship no types to an environment without them:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false


Tensor: TypeAlias = Any


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


# torch and trl are an extra and ship no types to an environment without them:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false


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
        found = self._decoder(ids, mask, trainer.max_completion_length, self._sampled, ends).tolist()
        return [_cut(tokens, ends) for tokens in found]

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
    end = next((place for place, token in enumerate(tokens) if token in ends), len(tokens))
    return tokens[: end + 1]
