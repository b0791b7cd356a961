"""One run of supervised fine-tuning, from configuration to trained model, with resumption."""

# TRL, transformers and torch are an extra:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

import shutil
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path

from sim2reason.base.atomic_files import lock_work_folder
from sim2reason.errors import TrainingError
from sim2reason.training.corpora import Row
from sim2reason.training.corpora.rows import Limits, encoded_table, format_reasons
from sim2reason.training.extras import External, disable_cudnn_attention, library, require, silence_library
from sim2reason.training.models import LoadedModel, uses_chat_template
from sim2reason.training.models.checkpoints import context_length
from sim2reason.training.sft.config import FineTuning, FineTuningResult, SftFolder, build_fine_tuning
from sim2reason.training.sft.trainer import arguments, trainer

__all__ = ["prepare_sft", "train_sft"]

NEEDED = "torch", "transformers", "accelerate", "datasets", "trl"


def train_sft(
    config: Path | str | Mapping[str, object] | FineTuning,
    out: Path | None = None,
    *,
    avoid: frozenset[str] = frozenset(),
    begun: Callable[[str, int], object] = lambda phase, steps: None,  # noqa: ARG005 - names say what is told
    advance: Callable[[int], object] = lambda _: None,
) -> FineTuningResult:
    """Fine-tune by a YAML file or settings; `out` overrides the output folder.

    An interrupted run continues from its last checkpoint, with the same final weights on the same machine; a finished
    one returns its result. On several devices, each process started by accelerate or torchrun calls this function. Rows
    whose prompt or fingerprint is in `avoid` are omitted. `begun` receives the name and the number of steps of each
    phase, `advance` the numbers of newly finished steps.

    Raises:
        TrainingError: a configuration, corpus or folder that cannot be used.
        MissingExtraError: a library of the extra [train] is missing.
        DatasetError: another run is writing in the folder, or a dataset is damaged.
    """
    settings = build_fine_tuning(config, out)
    require(*NEEDED, *settings.libraries)
    disable_cudnn_attention()
    state = library("accelerate").PartialState(cpu=settings.device == "cpu")
    settings.accumulated(state.num_processes)
    folder = SftFolder(settings.out)
    with _claimed_folder(folder, settings, main=state.is_main_process), silence_library():
        with state.main_process_first():
            done = folder.result()
            if done is None and state.is_main_process:
                folder.draw(settings, avoid)
                folder.rewind()
        if done is None:
            done = _trained(settings, folder, state, begun, advance)
        state.wait_for_everyone()
        return done


def prepare_sft(
    config: Path | str | Mapping[str, object] | FineTuning,
    out: Path | None = None,
    *,
    avoid: frozenset[str] = frozenset(),
) -> None:
    """Run the steps before training, which need no accelerator: rows, and a model from scratch.

    This saves time on a rented GPU machine; `train_sft` continues in the same folder. The errors are those of
    `train_sft`.
    """
    settings = build_fine_tuning(config, out)
    require(*NEEDED, *settings.libraries)
    state = library("accelerate").PartialState(cpu=settings.device == "cpu")
    folder, main = SftFolder(settings.out), state.is_main_process
    with _claimed_folder(folder, settings, main=main), silence_library():
        if main and folder.result() is None:
            folder.draw(settings, avoid)
        state.wait_for_everyone()
        if folder.result() is None:
            settings.model.checkpoint(_texts(folder.rows() if main else ()), folder.initial)
        state.wait_for_everyone()


@contextmanager
def _claimed_folder(folder: SftFolder, config: FineTuning, *, main: bool) -> Generator[None, None, None]:
    """Lock and claim the folder for a run while the block runs; do nothing in other processes than the main one."""
    if not main:
        yield
        return
    with lock_work_folder(folder.path):
        folder.claim(config)
        yield


def _trained(
    config: FineTuning,
    folder: SftFolder,
    state: External,
    begun: Callable[[str, int], object],
    advance: Callable[[int], object],
) -> FineTuningResult:
    """Train or continue, and save the result."""
    rows = folder.rows()
    loaded = config.model.load(_texts(rows), folder.initial)
    chat = uses_chat_template(loaded.tokenizer, loaded.path, chat=config.chat)
    encoded, left_out = encoded_table(rows, loaded.tokenizer, _limits(config, loaded), chat=chat)
    if not len(encoded):
        raise TrainingError(f"corpora: no row is within the limits of tokens; left out: {format_reasons(left_out)}")
    steps = config.steps_of(len(encoded))
    last = folder.checkpoint()
    if state.is_main_process:
        begun("fine-tuning", steps)
        advance(int(last.name.partition("-")[2]) if last else 0)
    settings = arguments(config, folder.checkpoints, steps, state.num_processes)
    run = trainer(config, settings, loaded, library("datasets").Dataset(encoded), folder, advance)
    run.train(resume_from_checkpoint=str(last) if last else None)
    parameters = _saved(run, loaded, folder, config)
    result = FineTuningResult(
        model=folder.model.name,
        parameters=parameters,
        rows=len(encoded),
        left_out=dict(sorted(left_out.items())),
        steps=steps,
        loss=_last_loss(run),
        corpora=folder.corpora(),
    )
    if state.is_main_process:
        folder.finish(result)
    return result


def _limits(config: FineTuning, loaded: LoadedModel) -> Limits:
    """Return the token limits of the configuration and of the model's context."""
    return Limits(config.max_prompt_tokens, config.max_completion_tokens, context_length(loaded.model.config))


def _texts(rows: Sequence[Row]) -> Iterator[str]:
    """Yield all texts that a model reads and writes."""
    return (text for row in rows for text in (row.prompt, row.completion))


def _saved(run: External, loaded: LoadedModel, folder: SftFolder, config: FineTuning) -> int:
    """Save the model with merged adapters and its tokenizer; return the number of parameters."""
    scratch = folder.path / "model.part"
    if config.lora is None:
        run.save_model(str(scratch))
        model = run.accelerator.unwrap_model(run.model)
    else:
        run.save_model(str(folder.adapter))
        model = run.accelerator.unwrap_model(run.model).merge_and_unload()
        if run.is_world_process_zero():
            model.save_pretrained(scratch)
    if run.is_world_process_zero():
        (scratch / "training_args.bin").unlink(missing_ok=True)  # a pickle, which nobody should have to trust
        loaded.tokenizer.save_pretrained(scratch)
        if folder.model.is_dir():
            shutil.rmtree(folder.model)  # of a run that was killed before its result was written
        scratch.rename(folder.model)
    return model.num_parameters()


def _last_loss(run: External) -> float:
    """Return the last logged loss; the mean of all steps if there are few."""
    lines = [line for line in run.state.log_history if "loss" in line or "train_loss" in line]
    last = next((line["loss"] for line in reversed(lines) if "loss" in line), lines[-1].get("train_loss"))
    return float(last)
