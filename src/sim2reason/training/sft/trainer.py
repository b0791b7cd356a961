"""Trainer of supervised fine-tuning with batches of rows of similar length."""

# TRL, transformers and torch are an extra:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUntypedBaseClass=false
# pyright: reportUnknownArgumentType=false

import json
import time
from collections.abc import Callable, Iterator, Sequence
from functools import cache
from math import isfinite
from pathlib import Path

import numpy as np

from sim2reason.errors import TrainingError
from sim2reason.generation.item_search import generator
from sim2reason.training.extras import External, library
from sim2reason.training.models import LoadedModel
from sim2reason.training.optimization import muon_with_adamw
from sim2reason.training.sft.config import FineTuning, SftFolder

__all__ = ["arguments", "batches_by_length", "sampler_by_length", "trainer"]


SORTED_BATCHES = 50  # batches sorted together: more of them mean less padding and a less random order


def batches_by_length(lengths: Sequence[int], batch: int, seed: int, epoch: int) -> list[int]:
    """Return the indices of all rows in batches of similar length; the order is random, an incomplete batch last."""
    rng, sizes = generator("length", seed, epoch), np.asarray(lengths)
    order = rng.permutation(len(sizes))
    stretches = np.split(order, range(SORTED_BATCHES * batch, len(order), SORTED_BATCHES * batch))
    near = np.concatenate([each[np.argsort(sizes[each], kind="stable")] for each in stretches])
    complete = len(near) - len(near) % batch
    shuffled = rng.permutation(near[:complete].reshape(-1, batch))
    return [*shuffled.ravel().tolist(), *near[complete:].tolist()]


def sampler_by_length(lengths: Sequence[int], batch: int, seed: int) -> External:
    """Return a torch sampler with the same order in each run, and a new one in each epoch."""
    return _sampler()(lengths, batch, seed)


@cache
def _sampler() -> External:
    """Return the sampler class, defined once torch is imported."""

    class ByLength(library("torch.utils.data").Sampler):
        def __init__(self, lengths: Sequence[int], batch: int, seed: int) -> None:
            self.lengths, self.batch, self.seed, self.epoch = lengths, batch, seed, 0

        def set_epoch(self, epoch: int) -> None:
            """Set the epoch before each pass."""
            self.epoch = epoch

        def __len__(self) -> int:
            return len(self.lengths)

        def __iter__(self) -> Iterator[int]:
            return iter(batches_by_length(self.lengths, self.batch, self.seed, self.epoch))

    return ByLength


SMALL = 2**15  # vocabulary size up to which all logits fit in memory
LOADER_PROCESSES = 2  # processes that assemble batches while a GPU computes
IGNORED_LABEL = -100
Advance = Callable[[int], object]


def arguments(config: FineTuning, checkpoints: Path, steps: int, devices: int) -> External:
    """Return the configuration in TRL's form."""
    torch = library("torch")
    micro, accumulated = config.accumulated(devices)
    cpu = config.device == "cpu" or not torch.cuda.is_available()
    bfloat16 = (
        not cpu and torch.cuda.is_bf16_supported() if config.precision == "auto" else config.precision == "bfloat16"
    )
    decayed = min(round(config.decay * steps), max(0, steps - config.warmup))
    return library("trl").SFTConfig(
        output_dir=str(checkpoints),
        use_cpu=cpu,
        bf16=bfloat16,
        max_steps=steps,
        per_device_train_batch_size=micro,
        gradient_accumulation_steps=accumulated,
        learning_rate=config.learning_rate,
        weight_decay=config.weight_decay,
        max_grad_norm=config.max_grad_norm,
        warmup_steps=config.warmup,
        lr_scheduler_type="warmup_stable_decay",
        lr_scheduler_kwargs={"num_decay_steps": decayed, "decay_type": "linear"},
        activation_checkpointing=config.gradient_checkpointing,  # its other name is on its way out
        save_strategy="steps",
        save_steps=config.save_every,
        save_total_limit=config.keep,
        logging_steps=config.log_every,
        logging_nan_inf_filter=False,
        report_to=["tensorboard"] if config.tensorboard else "none",
        seed=config.seed,
        data_seed=config.seed,
        max_length=None,  # rows are held to their limits before
        packing=False,
        dataloader_pin_memory=not cpu,
        dataloader_num_workers=0 if cpu else LOADER_PROCESSES,
        ddp_find_unused_parameters=False,
        disable_tqdm=True,
    )


def trainer(
    config: FineTuning,
    arguments: External,
    loaded: LoadedModel,
    data: External,
    folder: SftFolder,
    advance: Advance,
) -> External:
    """Return a trainer of encoded rows; only the main process writes and reports steps to `advance`."""
    made = _trainer()(
        loaded.model,
        args=arguments,
        train_dataset=data,
        processing_class=loaded.tokenizer,
        peft_config=config.lora.config if config.lora else None,
    )
    if config.by_length:
        made.order = sampler_by_length(data["length"][:], arguments.per_device_train_batch_size, config.seed)
    made.rates = (config.muon_learning_rate, config.learning_rate) if config.optimizer == "muon" else None
    made.remove_callback(library("transformers").PrinterCallback)
    made.add_callback(_callback()(made, folder, advance))
    return made


class _Silent:
    """A mixin that disables TRL's model cards and telemetry."""

    def create_model_card(self, *args: object, **settings: object) -> None:
        """Write no model card."""

    def _send_telemetry(self) -> None:
        """Send nothing."""


@cache
def _trainer() -> External:
    """Return the trainer class, defined once TRL is imported."""

    class Trainer(_Silent, library("trl").SFTTrainer):
        """TRL's, with what this module says."""

        order: External = None  # of rows, where it is not random
        rates: tuple[float, float] | None = None  # of Muon and of AdamW; None for AdamW alone
        tokens: External = 0  # of completions and prompts that this process has read since the last log

        def __init__(self, *args: External, **settings: External) -> None:
            super().__init__(*args, **settings)
            self.small = self.model.config.get_text_config().vocab_size <= SMALL and not self.aux_loss_enabled

        def create_optimizer(self, model: External = None) -> External:
            if self.optimizer is None and self.rates is not None:
                self.optimizer = muon_with_adamw(model or self.model, *self.rates, self.args.weight_decay)
            return super().create_optimizer(model)

        def _get_train_sampler(self, train_dataset: External = None) -> External:
            return self.order or super()._get_train_sampler(train_dataset)

        def compute_loss(
            self,
            model: External,
            inputs: External,
            return_outputs: bool = False,  # noqa: FBT001, FBT002 - TRL's own signature
            num_items_in_batch: External = None,
        ) -> External:
            if model.training:
                self.tokens = self.tokens + inputs["attention_mask"].sum()
            if return_outputs or not self.small:
                return super().compute_loss(model, inputs, return_outputs, num_items_in_batch)
            return _loss(model, inputs, num_items_in_batch, _scale(self))

    return Trainer


def _scale(trainer: External) -> int:
    """Return the factor on a process's loss that makes up for the averaging of gradients over processes."""
    return trainer.accelerator.num_processes if trainer.args.average_tokens_across_devices else 1


def _loss(model: External, inputs: External, tokens: External, scale: int) -> External:
    """Return the cross-entropy of completions, nats: over all `tokens` of a step, or the mean of a batch."""
    labels = inputs["labels"][:, 1:]
    model_inputs = {name: inputs[name] for name in ("input_ids", "attention_mask")}
    logits = model(**model_inputs, use_cache=False).logits[:, :-1]
    mask = labels != IGNORED_LABEL
    torch = library("torch")
    total = torch.nn.functional.cross_entropy(logits[mask].float(), labels[mask], reduction="sum")
    if tokens is None:
        return total / mask.sum().clamp(min=1)
    return total * scale / torch.as_tensor(tokens).clamp(min=1)


@cache
def _callback() -> External:
    """Return the callback class, defined once transformers is imported."""

    class SftCallback(library("transformers").TrainerCallback):
        """A callback that writes the log, and marks complete checkpoints."""

        def __init__(self, owner: External, folder: SftFolder, advance: Advance) -> None:
            self.owner, self.folder, self.advance, self.since = owner, folder, advance, time.perf_counter()

        def on_train_begin(self, *_: External, **__: External) -> None:
            self.since = time.perf_counter()

        def on_step_end(self, _: External, state: External, *__: External, **___: External) -> None:
            if state.is_world_process_zero:
                self.advance(1)

        def on_log(self, args: External, state: External, *_: External, **held: External) -> None:
            logs: dict[str, float] = held.get("logs") or {}
            if not isfinite(logs.get("loss", 0.0)):
                raise TrainingError(
                    f"step {state.global_step}: the loss is {logs['loss']}; give lower learning rates, in a new folder"
                )
            if "loss" in logs and state.is_world_process_zero:
                now, tokens = time.perf_counter(), int(self.owner.tokens) * args.world_size
                line = {name: logs[name] for name in ("loss", "learning_rate", "grad_norm")}
                speed = round(tokens / max(now - self.since, 1e-9), 1)
                self.folder.log.add(json.dumps({"step": state.global_step, **line, "tokens_per_second": speed}))
                self.owner.tokens, self.since = 0, now

        def on_save(self, _: External, state: External, *__: External, **___: External) -> None:
            if state.is_world_process_zero:
                self.folder.whole(state.global_step)

    return SftCallback
