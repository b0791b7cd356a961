"""One run of reinforcement learning, from a configuration to a trained model; the same call goes on where it ended."""

# TRL, transformers and torch are an extra:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from collections.abc import Mapping
from datetime import timedelta
from pathlib import Path

from sim2reason.datasets.atomic_files import working_in
from sim2reason.training.extras import External, library, quiet, require
from sim2reason.training.gspo import make_trainer
from sim2reason.training.models import Checkpoint, spoken_to
from sim2reason.training.prefetch import prefetching
from sim2reason.training.problem_stream import ProblemStream
from sim2reason.training.processes import Advance, Begun, in_processes, launched
from sim2reason.training.rewards import reward_function
from sim2reason.training.rl.config import ReinforcementLearning, reinforcement_learning_from
from sim2reason.training.rl.folder import Trained, TrainingFolder
from sim2reason.training.sft.run import train_sft

__all__ = ["NEEDED", "train_rl"]

NEEDED = "torch", "transformers", "accelerate", "datasets", "trl"
PATIENCE = timedelta(days=1)  # that processes wait for the first one, which may have many problems to make


def train_rl(
    config: Path | str | Mapping[str, object] | ReinforcementLearning,
    out: Path | None = None,
    *,
    begun: Begun = lambda phase, steps: None,  # noqa: ARG005 - names say what is told
    advance: Advance = lambda _: None,
) -> Trained:
    """Train as a YAML file, or settings, say; `out` stands for the folder that they name.

    A run that was broken off goes on from its last checkpoint with the next prompt; one that is finished gives its
    result. Several processes are started here if the configuration says so; each that accelerate or torchrun starts
    calls this. `begun` is told what comes next and how many steps it has, `advance` how many more are done.

    Raises:
        TrainingError: a configuration, corpus or folder that cannot be used.
        MissingExtraError: a library of the extra [train], or one that the settings name, is missing.
        DatasetError: another run is writing in the folder, or a dataset is damaged.
    """
    settings = reinforcement_learning_from(config, out)
    require(*NEEDED, *settings.libraries)
    if settings.processes > 1 and not launched():
        in_processes(settings.processes, _train, settings, begun, advance)
        found = TrainingFolder(settings.out).result()
        assert found is not None
        return found
    return _train(settings, begun, advance)


def _train(settings: ReinforcementLearning, begun: Begun, advance: Advance) -> Trained:
    """What one process does."""
    torch = library("torch")
    state = library("accelerate").PartialState(cpu=not torch.accelerator.is_available(), timeout=PATIENCE)
    settings.check_shares(state.num_processes)
    folder = TrainingFolder(settings.out)
    if not state.is_main_process:
        with quiet():
            return _run(settings, folder, state, begun, advance)
    with working_in(folder.path), quiet():
        folder.claim(settings)
        return _run(settings, folder, state, begun, advance)


def _run(
    settings: ReinforcementLearning, folder: TrainingFolder, state: External, begun: Begun, advance: Advance
) -> Trained:
    """Hold problems out, warm up, train."""
    done = folder.result()
    if done is not None:
        return done
    avoid = frozenset[str]()
    if settings.held_out:
        with state.main_process_first():
            avoid = folder.hold_out(settings.held_out, settings.prefetch.workers + 1)
    prefetch = settings.prefetch
    with prefetching(prefetch.workers if state.is_main_process else 0, prefetch.depth) as store:
        stream = ProblemStream(settings.problems, store, settings.curriculum, avoid)
        if state.is_main_process:
            stream.begin()
            if not folder.train.is_dir():
                stream.probe()  # a warm start may take hours before the first problem is asked for
        checkpoint = _checkpoint(settings, folder, avoid, begun, advance)
        return _trained(settings, folder, checkpoint, stream, begun, advance)


def _checkpoint(
    settings: ReinforcementLearning, folder: TrainingFolder, avoid: frozenset[str], begun: Begun, advance: Advance
) -> Checkpoint:
    """What is trained: the given one, or the result of the warm start."""
    warm = settings.warm_start
    if warm is None:
        assert settings.model is not None
        return settings.model.checkpoint((), folder.initial)
    sft = warm.model_copy(update={"out": folder.warm_start})
    train_sft(sft, avoid=avoid, begun=begun, advance=advance)
    return Checkpoint(str(folder.warm_start / "model"))


def _trained(
    settings: ReinforcementLearning,
    folder: TrainingFolder,
    checkpoint: Checkpoint,
    stream: ProblemStream,
    begun: Begun,
    advance: Advance,
) -> Trained:
    settings.gspo.check_context(checkpoint.context)
    tokenizer = checkpoint.tokenizer(padding_side="left")
    stream.chat = spoken_to(tokenizer, checkpoint.path, chat=settings.chat)
    rewards = [reward_function(settings.reward)]
    run = make_trainer(checkpoint, tokenizer, stream, rewards, settings.gspo, folder.train)
    begun("reinforcement learning", settings.gspo.steps)
    run.remove_callback(library("transformers").PrinterCallback)
    run.add_callback(_told(advance, settings.gspo.minibatches))
    run.train(resume_from_checkpoint=True)
    found = folder.finish(run, tokenizer, checkpoint)
    run.accelerator.wait_for_everyone()
    run.accelerator.end_training()
    return found


def _told(advance: Advance, minibatches: int) -> External:
    """Tell of each step that is done."""

    class Told(library("transformers").TrainerCallback):
        def on_train_begin(self, _: External, state: External, *__: External, **___: External) -> None:
            advance(state.global_step // minibatches)

        def on_step_end(self, _: External, state: External, *__: External, **___: External) -> None:
            if state.global_step % minibatches == 0:
                advance(1)

    return Told()
