"""TRL's GRPO trainer with a prompt stream, dynamic sampling, cursors in checkpoints and a step log.

It overrides private methods of TRL 1.16, and refuses other minor versions.
"""

# torch, trl and transformers are an extra and ship no types to an environment without them:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUntypedBaseClass=false
# pyright: reportUnknownArgumentType=false

import logging
from collections.abc import Sequence
from math import ceil
from pathlib import Path
from typing import Any, TypeAlias

from sim2reason.errors import TrainingError
from sim2reason.training.extras import library
from sim2reason.training.gspo.rollouts import Group, Rollouts, cut, filler, join, moved, score
from sim2reason.training.gspo.sampling import FilledStep, Meter, ProcessRank, RoundRewards, balance, collapse, fill
from sim2reason.training.gspo.settings import Drawn, GSPOSettings, PromptStream, Row, draw
from sim2reason.training.run_files import (
    Cursor,
    StepLog,
    checkpoint_folder,
    last_checkpoint,
    mark,
    read_cursor,
    remove_later,
    unmark,
)

__all__ = ["BetweenUpdates", "GSPOTrainer"]


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


SUPPORTED = "1.16"
Tensor: TypeAlias = Any

logger = logging.getLogger(__name__)
trl, torch = library("trl"), library("torch")
accelerate_utils = library("accelerate.utils")
if trl.__version__.split(".")[:2] != SUPPORTED.split("."):
    raise TrainingError(
        f"trl {trl.__version__} is installed, and the trainer overrides private methods of {SUPPORTED}; "
        f"install it with: pip install 'trl=={SUPPORTED}.*'"
    )


class GSPOTrainer(trl.GRPOTrainer):
    """TRL's trainer for prompts of a stream; `make_trainer` constructs it."""

    def __init__(self, stream: PromptStream, settings: GSPOSettings, **given: Any) -> None:  # noqa: ANN401 - TRL's own
        """Initialise TRL's trainer with a placeholder dataset of one step's length."""
        self.stream, self.settings = stream, settings
        self.prompts_consumed = 0
        self._meter = Meter()
        self._answered: Tensor = None
        self._later = False
        self.short = self.exhausted = False
        rows = {"prompt": [""] * settings.prompts}
        super().__init__(train_dataset=library("datasets").Dataset.from_dict(rows), **given)
        self._rollouts = Rollouts(self) if settings.cuda_graphs else None
        self.step_log = StepLog(Path(self.args.output_dir))
        self.add_callback(BetweenUpdates(self))

    @property
    def place(self) -> ProcessRank:
        """Return the rank of this process and the number of processes."""
        return ProcessRank(self.accelerator.process_index, self.accelerator.num_processes)

    def _send_telemetry(self) -> None:
        """Send nothing."""

    # drawing and answering

    def _generate_and_score_completions(self, inputs: list[Row]) -> dict[str, Tensor]:
        """Return the batch of a step, filled from the stream; `inputs` are placeholders."""
        if not self.model.training:
            return super()._generate_and_score_completions(inputs)
        self._meter.begin()
        metrics = self._metrics["train"]
        before = {name: len(entries) for name, entries in metrics.items()}
        first = ceil(self.settings.first_round * self.settings.prompts)
        filled = fill(self, self.place, self.settings.prompts, self.settings.rounds, first)
        self.prompts_consumed += filled.read
        if not self.prompts_consumed:
            raise TrainingError("the stream of prompts is empty")
        collapse(metrics, before, filled.sizes)
        batch = self._batch(filled)
        self._meter.update(filled)
        return batch

    def draw(self, count: int) -> Drawn:
        """Return the next prompts, which the first process reads for all.

        All processes receive all rows and take their slices, so that prompts are used in the stream's order with any
        number of processes.
        """
        with self._meter.time("drawing"):
            drawn: Any = None
            fault: Exception | None = None
            if self.accelerator.is_main_process:
                try:
                    drawn = draw(self.stream, count, self._fits)
                except Exception as error:  # noqa: BLE001 - whatever it is, the others must not wait for ever
                    fault = error
            payload: list[Any] = [drawn, None if fault is None else f"{type(fault).__name__}: {fault}"[:1000]]
            accelerate_utils.broadcast_object_list(payload, from_process=0)
        if fault is not None:
            raise fault
        if payload[1] is not None:
            raise TrainingError(f"the first process could draw no prompts: {payload[1]}")
        return payload[0]

    def observe(self, row: Row, rewards: Sequence[float]) -> None:
        """Report rewards to the stream, in the first process only."""
        if self.accelerator.is_main_process:
            self.stream.observe(row, rewards)

    def _fits(self, row: Row) -> bool:
        """Return whether a prompt is short enough."""
        return len(self._tokenize_prompts([row["prompt"]])[0][0]) <= self.settings.max_prompt_tokens

    def answer(self, rows: Sequence[Row]) -> RoundRewards:
        """Generate and score completions of this process's prompts with TRL."""
        size = self.settings.generations
        self._later = self._defers
        try:
            output = super()._generate_and_score_completions([dict(row) for row in rows for _ in range(size)])
        finally:
            self._later = False
        parts, weights = self._answered, self.reward_weights.to(self._answered.device)
        if parts.isinf().any():
            raise TrainingError("a reward function gave an infinite reward")
        # the sum that TRL's advantages are made of; NaN where no reward function has an opinion
        total = (parts * weights).nansum(dim=1).masked_fill(parts.isnan().all(dim=1), float("nan"))
        return RoundRewards(total.view(-1, size).tolist(), lambda number: cut(output, number, size))

    def _batch(self, filled: FilledStep) -> dict[str, Tensor]:
        """Return the batch of a step from the selected groups, equally many per process, filled with placeholders.

        Placeholders have no completion to train on. The loss is a mean over completions, so it is scaled to a mean over
        the real ones; all minibatches have the same fraction of placeholders.
        """
        token = self._tokenizer.pad_token_id
        wanted, selected = self.settings.prompts, len(filled.owners)
        groups = self._exchanged(filled)
        self.short, self.exhausted = selected < wanted, filled.exhausted
        if self.short:
            self._warn_short(filled)
            empty = filler(self.settings.generations, token, self.accelerator.device)
            groups += [empty] * (wanted // self.place.world - len(groups))
        batch = join(groups, token)
        if self._defers:
            score(self, batch)
        batch["num_items_in_batch"] = self.accelerator.gather(batch["completion_mask"].sum()).sum()
        batch["loss_scale"] = torch.tensor(wanted / max(selected, 1), device=self.accelerator.device)
        return batch

    def _exchanged(self, filled: FilledStep) -> list[Group]:
        """Return the groups of completions that this process trains on, after an exchange with other processes."""
        places, rank = balance(filled.owners, self.place.world), self.place.rank
        groups = {number: group for number, group in filled.own.items() if places[number] == rank}
        if places != filled.owners:
            leaving = [(number, moved(filled.own[number], "cpu")) for number in filled.own.keys() - groups.keys()]
            for number, group in accelerate_utils.gather_object(leaving):
                if places[number] == rank:
                    groups[number] = moved(group, self.accelerator.device)
        return [groups[number] for number in sorted(groups)]

    def _warn_short(self, filled: FilledStep) -> None:
        """Warn of a step with fewer groups of unequal rewards than wanted."""
        if self.accelerator.is_main_process:
            why = "the stream of prompts has ended" if filled.exhausted else f"{len(filled.sizes)} rounds are used up"
            selected = len(filled.owners)
            then = "" if selected else "; the weights stay as they are"
            message = "step %d learns from %d of %d groups: %s, and all rewards of each other group were equal%s"
            logger.warning(message, self._step_now + 1, selected, self.settings.prompts, why, then)

    @property
    def _step_now(self) -> int:
        """Return the number of finished steps."""
        return self.state.global_step // self.settings.minibatches

    # what TRL does, timed

    def _generate(self, prompts: list[Any]) -> Any:  # noqa: ANN401 - TRL's own
        with self._meter.time("generation"):
            return super()._generate(prompts)

    def _generate_single_turn(self, prompt_ids: list[list[int]], *given: Any, **named: Any) -> Any:  # noqa: ANN401 - TRL's own
        """Return the tokens of completions, and None for log-probabilities, in TRL's format."""
        if self._rollouts is None:
            return super()._generate_single_turn(prompt_ids, *given, **named)
        return self._rollouts(prompt_ids), None

    def _calculate_rewards(self, *given: Any) -> Tensor:  # noqa: ANN401 - TRL's own
        """Return the rewards of all completions by each reward function, (completions, functions), NaN for None."""
        with self._meter.time("reward"):
            self._answered = super()._calculate_rewards(*given)
        return self._answered

    def _get_per_token_logps_and_entropies(self, model: object, input_ids: Tensor, *given: Any, **named: Any) -> Any:  # noqa: ANN401 - TRL's own
        if torch.is_grad_enabled():
            return super()._get_per_token_logps_and_entropies(model, input_ids, *given, **named)
        if self._later:
            width = given[1] if len(given) > 1 else named["logits_to_keep"]
            return torch.zeros(len(input_ids), width, device=input_ids.device), None, None
        with self._meter.time("logprobs"):
            return super()._get_per_token_logps_and_entropies(model, input_ids, *given, **named)

    def logps(self, *given: Any) -> Tensor:  # noqa: ANN401 - TRL's own
        """Return the log-probabilities of the tokens of completions, zero after the end of each."""
        return self._get_per_token_logps_and_entropies(*given)[0]

    @property
    def _defers(self) -> bool:
        """Return whether log-probabilities are computed only for selected groups, not for all completions.

        TRL needs them immediately to correct for vLLM's rounding.
        """
        return not (self.use_vllm and self.vllm_importance_sampling_correction)

    def _compute_loss(self, model: object, inputs: dict[str, Tensor]) -> Tensor:
        loss = super()._compute_loss(model, inputs)
        if "loss_scale" not in inputs:  # evaluation
            return loss
        if self.short:  # fillers are never clipped, and count in no share
            for name in ("low_mean", "high_mean", "region_mean"):
                self._metrics["train"][f"clip_ratio/{name}"][-1] *= inputs["loss_scale"].item()
        return loss * inputs["loss_scale"]

    def _get_grad_norm(self, model: object, grad_norm: Any = None) -> Any:  # noqa: ANN401 - transformers' own
        norm = super()._get_grad_norm(model, grad_norm=grad_norm)
        if norm is not None:
            self._meter.grad_norms.append(float(norm))
        return norm

    # logs and checkpoints

    def log(self, logs: dict[str, float], start_time: float | None = None) -> None:
        """Add the metrics of a step to TRL's log, and write the record of the step."""
        if not (self.model.training and "loss" in logs):
            super().log(logs, start_time)
            return
        self._meter.made(self.stream.cpu_seconds)
        logs |= self._meter.flat() | {"prompts_consumed": self.prompts_consumed}
        super().log(logs, start_time)
        at = {"step": self._step_now, "updates": self.state.global_step, "consumed": self.prompts_consumed}
        record = self._meter.record(self.state.log_history[-1], **at)  # everywhere, so that all stop if it cannot be
        if self.accelerator.is_main_process:
            self.step_log.add(record)

    def train(self, resume_from_checkpoint: Any = None, **given: Any) -> Any:  # noqa: ANN401 - transformers' own
        """Train, or continue from a checkpoint; True selects the last complete one, if any.

        Raises:
            TrainingError: the checkpoint is not whole or was made with another number of minibatches, or the folder
                holds a run that got further.
        """
        out = Path(self.args.output_dir)
        if resume_from_checkpoint is True:
            resume_from_checkpoint = last_checkpoint(out)
        folder = Path(resume_from_checkpoint) if resume_from_checkpoint else None
        cursor = None if folder is None else read_cursor(folder)
        if cursor is not None:
            self._restore(cursor)
        self.accelerator.wait_for_everyone()  # all have read, before anything is removed
        if self.accelerator.is_main_process:
            remove_later(out, cursor)
            self.step_log.rewind(0 if cursor is None else cursor.step)
        self.accelerator.wait_for_everyone()
        return super().train(resume_from_checkpoint=None if folder is None else str(folder), **given)

    def _restore(self, cursor: Cursor) -> None:
        if cursor.updates != cursor.step * self.settings.minibatches:
            raise TrainingError(
                f"the checkpoint after {cursor.updates} updates was made with another number of minibatches; "
                "keep that number, or begin in another folder"
            )
        self.prompts_consumed = cursor.prompts_consumed
        if self.accelerator.is_main_process:
            self.stream.restore(cursor.stream)

    def _save_checkpoint(self, model: object, trial: object) -> None:
        """Save transformers' files, then the cursor, which marks the checkpoint as complete."""
        folder = checkpoint_folder(Path(self.args.output_dir), self.state.global_step)
        if self.accelerator.is_main_process:
            unmark(folder)
        super()._save_checkpoint(model, trial)
        self.accelerator.wait_for_everyone()
        if self.accelerator.is_main_process:
            updates, read = self.state.global_step, self.prompts_consumed
            state = self.stream.state()
            mark(folder, Cursor(step=self._step_now, updates=updates, prompts_consumed=read, stream=state))
