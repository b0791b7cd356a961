"""Log-probabilities of a filled batch, as TRL computes them for each round."""

# torch and trl are an extra and ship no types to an environment without them:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from typing import Any, TypeAlias

from sim2reason.training.extras import library

__all__ = ["score"]

Tensor: TypeAlias = Any


def score(trainer: Any, batch: dict[str, Tensor]) -> None:  # noqa: ANN401 - ours, which imports this module
    """Add the log-probabilities of completions under the policy that wrote them, and under the reference.

    TRL computes them for all that is answered; here it is known which groups stay.
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
