"""One run of reinforcement learning, from configuration to trained model, with resumption."""

# TRL, transformers and torch are an extra:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from collections.abc import Callable, Generator, Mapping
from contextlib import contextmanager
from datetime import timedelta
from pathlib import Path
from typing import Literal

from sim2reason.base.atomic_files import lock_work_folder
from sim2reason.training.extras import External, disable_cudnn_attention, library, require, silence_library
from sim2reason.training.gspo import make_trainer
from sim2reason.training.models import Checkpoint, uses_chat_template
from sim2reason.training.problem_stream import ProblemStream, prefetching
from sim2reason.training.processes import AdvanceCallback, BeginCallback, is_launched, run_in_processes
from sim2reason.training.rewards import reward_function
from sim2reason.training.rl.config import (
    ReinforcementLearning,
    TrainingFolder,
    TrainingResult,
    build_reinforcement_learning,
)
from sim2reason.training.sft.config import FineTuning
from sim2reason.training.sft.run import prepare_sft, train_sft

__all__ = ["NEEDED", "Stage", "prepare_rl", "train_rl"]

NEEDED = "torch", "transformers", "accelerate", "datasets", "trl"
Stage = Literal["data", "warm-start"]
"""Of what comes before reinforcement learning."""
PATIENCE = timedelta(days=1)  # how long processes wait for the first one, which may have many problems to make


def train_rl(
    config: Path | str | Mapping[str, object] | ReinforcementLearning,
    out: Path | None = None,
    *,
    begun: BeginCallback = lambda phase, steps: None,  # noqa: ARG005 - names say what is told
    advance: AdvanceCallback = lambda _: None,
) -> TrainingResult:
    """Train by a YAML file or settings; `out` overrides the output folder.

    An interrupted run continues from its last checkpoint with the next prompt; a finished one returns its result.
    Several processes are started here if configured; each process started by accelerate or torchrun calls this
    function. `begun` receives the name and the number of steps of each phase, `advance` the numbers of newly finished
    steps.

    Raises:
        TrainingError: a configuration, corpus or folder that cannot be used.
        MissingExtraError: a library of the extra [train], or one that the settings name, is missing.
        DatasetError: another run is writing in the folder, or a dataset is damaged.
    """
    settings = build_reinforcement_learning(config, out)
    _run_in_all_processes(_train, settings, begun, advance)
    result = TrainingFolder(settings.out).result()
    assert result is not None
    return result


def prepare_rl(
    config: Path | str | Mapping[str, object] | ReinforcementLearning,
    out: Path | None = None,
    *,
    until: Stage = "warm-start",
    begun: BeginCallback = lambda phase, steps: None,  # noqa: ARG005 - names say what is told
    advance: AdvanceCallback = lambda _: None,
) -> Path:
    """Run the steps before reinforcement learning, with the arguments of `train_rl`.

    *data* covers the held-out problems, and the rows and model of a warm start: work without a GPU. *warm-start*
    includes the warm start itself. `train_rl` continues in the returned folder.

    Raises:
        TrainingError, MissingExtraError, DatasetError: as `train_rl` does.
    """
    settings = build_reinforcement_learning(config, out)
    _run_in_all_processes(_prepare_data if until == "data" else _prepare, settings, begun, advance)
    return settings.out


def _run_in_all_processes(
    work: Callable[[ReinforcementLearning, BeginCallback, AdvanceCallback], object],
    settings: ReinforcementLearning,
    begun: BeginCallback,
    advance: AdvanceCallback,
) -> None:
    """Run a step in the configured number of processes, unless several were already started."""
    require(*NEEDED, *settings.libraries)
    if settings.processes > 1 and not is_launched():
        run_in_processes(settings.processes, work, settings, begun, advance)
    else:
        work(settings, begun, advance)


@contextmanager
def _entered(settings: ReinforcementLearning) -> Generator[tuple[TrainingFolder, External]]:
    """Return a context with the folder of the run, claimed by the main process, and accelerate's state."""
    torch = library("torch")
    disable_cudnn_attention()
    state = library("accelerate").PartialState(cpu=not torch.accelerator.is_available(), timeout=PATIENCE)
    settings.check_shares(state.num_processes)
    folder = TrainingFolder(settings.out)
    if not state.is_main_process:
        with silence_library():
            yield folder, state
        return
    with lock_work_folder(folder.path), silence_library():
        folder.claim(settings)
        yield folder, state


def _held_out(settings: ReinforcementLearning, folder: TrainingFolder, state: External) -> frozenset[str]:
    """Generate the held-out problems; return the prompts and hashes that training must avoid."""
    if not settings.held_out:
        return frozenset()
    with state.main_process_first():
        return folder.hold_out(settings.held_out, settings.prefetch.workers + 1)


def _prepare_data(settings: ReinforcementLearning, begun: BeginCallback, advance: AdvanceCallback) -> None:
    """Generate the held-out problems and the warm start's rows."""
    del begun, advance
    with _entered(settings) as (folder, state):
        avoid = _held_out(settings, folder, state)
        if settings.warm_start is not None:
            prepare_sft(_warm_start(settings.warm_start, folder), avoid=avoid)


def _prepare(settings: ReinforcementLearning, begun: BeginCallback, advance: AdvanceCallback) -> None:
    """Generate the held-out problems, and train the warm start."""
    with _entered(settings) as (folder, state):
        _checkpoint(settings, folder, _held_out(settings, folder, state), begun, advance)


def _train(settings: ReinforcementLearning, begun: BeginCallback, advance: AdvanceCallback) -> None:
    """Generate the held-out problems, train the warm start, then run reinforcement learning."""
    with _entered(settings) as (folder, state):
        if folder.result() is not None:
            return
        avoid, prefetch = _held_out(settings, folder, state), settings.prefetch
        with prefetching(prefetch.workers if state.is_main_process else 0, prefetch.depth) as store:
            stream = ProblemStream(settings.problems, store, settings.curriculum, avoid)
            if state.is_main_process:
                stream.begin()
                if not folder.train.is_dir():
                    stream.probe()  # a warm start may take hours before the first problem is asked for
            checkpoint = _checkpoint(settings, folder, avoid, begun, advance)
            _trained(settings, folder, checkpoint, stream, begun, advance)


def _checkpoint(
    settings: ReinforcementLearning,
    folder: TrainingFolder,
    avoid: frozenset[str],
    begun: BeginCallback,
    advance: AdvanceCallback,
) -> Checkpoint:
    """Return the model to train by reinforcement learning: the configured one, or the result of the warm start."""
    warm = settings.warm_start
    if warm is None:
        assert settings.model is not None
        return settings.model.checkpoint((), folder.initial)
    train_sft(_warm_start(warm, folder), avoid=avoid, begun=begun, advance=advance)
    return Checkpoint(str(folder.warm_start / "model"))


def _warm_start(given: FineTuning, folder: TrainingFolder) -> FineTuning:
    """Return the warm start's configuration with its folder inside the run."""
    return given.model_copy(update={"out": folder.warm_start})


def _trained(
    settings: ReinforcementLearning,
    folder: TrainingFolder,
    checkpoint: Checkpoint,
    stream: ProblemStream,
    begun: BeginCallback,
    advance: AdvanceCallback,
) -> None:
    settings.gspo.check_context(checkpoint.context)
    tokenizer = checkpoint.tokenizer(padding_side="left")
    stream.chat = uses_chat_template(tokenizer, checkpoint.path, chat=settings.chat)
    rewards = [reward_function(settings.reward)]
    run = make_trainer(checkpoint, tokenizer, stream, rewards, settings.gspo, folder.train)
    begun("reinforcement learning", settings.gspo.steps)
    run.remove_callback(library("transformers").PrinterCallback)
    run.add_callback(_told(advance, settings.gspo.minibatches))
    run.train(resume_from_checkpoint=True)
    folder.finish(run, tokenizer, checkpoint)
    run.accelerator.wait_for_everyone()
    run.accelerator.end_training()


def _told(advance: AdvanceCallback, minibatches: int) -> External:
    """Return a callback that reports each finished step."""

    class Told(library("transformers").TrainerCallback):
        def on_train_begin(self, _: External, state: External, *__: External, **___: External) -> None:
            advance(state.global_step // minibatches)

        def on_step_end(self, _: External, state: External, *__: External, **___: External) -> None:
            if state.global_step % minibatches == 0:
                advance(1)

    return Told()
