"""Training of language models: problems as prompts, models, corpora, rewards, and files of runs.

ProblemSource (settings) ↦ Problem ── PromptStream ── trainer ── Reward ↦ checkpoints, log, report

The libraries of deep learning, those of the extra ``train``, are loaded when a model is loaded or trained, never
when this package is imported.
"""

from collections.abc import Callable, Mapping
from importlib import import_module
from pathlib import Path
from typing import Any

from sim2reason.errors import UnknownNameError

__all__ = ["METHODS", "train"]

METHODS = {"rl": "rl.run:train_rl", "sft": "sft.run:train_sft", "study": "study.run:train_study"}
"""The function of each method, below this package."""


def train(
    method: str,
    config: Path | str | Mapping[str, object],
    out: Path | None = None,
    *,
    begun: Callable[[str, int], object] = lambda phase, steps: None,  # noqa: ARG005 - names say what is told
    advance: Callable[[int], object] = lambda _: None,
) -> Any:  # noqa: ANN401 - each method has a result of its own
    """Train a model with one of the methods of the library.

    The same call continues a run that was interrupted.

    Args:
        method: ``rl`` (reinforcement learning), ``sft`` (supervised fine-tuning) or ``study`` (several runs).
        config: A YAML file, or a mapping with its contents.
        out: Folder of the run; by default the folder in the configuration.
        begun: Callback that takes the name of the next phase and its number of steps.
        advance: Callback that takes the number of further steps that are finished.

    Returns:
        The result of the method.

    Raises:
        UnknownNameError: There is no such method.
        TrainingError: A configuration, model, corpus or folder is invalid.
        MissingExtraError: A package of the extra [train] is missing.

    Examples:
        >>> import sim2reason
        >>> sim2reason.train("sft", "sft.yaml")  # doctest: +SKIP
        >>> sim2reason.train("dpo", "dpo.yaml")
        Traceback (most recent call last):
        sim2reason.errors.UnknownNameError: no such method of training: 'dpo'; there are: rl, sft, study
    """
    if method not in METHODS:
        raise UnknownNameError(f"no such method of training: {method[:80]!r}; there are: {', '.join(METHODS)}")
    module, _, function = METHODS[method].partition(":")
    return getattr(import_module(f"sim2reason.training.{module}"), function)(config, out, begun=begun, advance=advance)
