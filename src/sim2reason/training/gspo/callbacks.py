"""Callbacks of the trainer between updates, for incomplete batches and the end of the stream."""

# transformers is an extra and ships no types to an environment without it:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUntypedBaseClass=false

from typing import Any

from sim2reason.training.extras import library

__all__ = ["BetweenUpdates"]


class BetweenUpdates(library("transformers").TrainerCallback):
    """Callbacks of transformers' training loop for a `GSPOTrainer`."""

    def __init__(self, trainer: Any) -> None:  # noqa: ANN401 - ours, which imports this module
        """Store the trainer, whose state tells short steps and an exhausted stream."""
        self.trainer = trainer

    def on_pre_optimizer_step(self, *_: object, **__: object) -> None:
        """Exempt weights with zero gradients from the update, which momentum and decay would otherwise change."""
        if self.trainer.short:
            for weights in self.trainer.model.parameters():
                if weights.grad is not None and not weights.grad.any():
                    weights.grad = None

    def on_step_end(self, _: object, state: Any, control: Any, **__: object) -> None:  # noqa: ANN401 - transformers' own
        """Stop the run, and save a checkpoint, after the step in which the prompt stream ended."""
        if self.trainer.exhausted and state.global_step % self.trainer.settings.minibatches == 0:
            control.should_training_stop = control.should_save = True
