"""Training by the name of a method, as the command line has them."""

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
    """Train by a method, ``rl``, ``sft`` or ``study``, as a YAML file, or settings, say: ``train METHOD CONFIG``.

    `out` stands for the folder that they name. `begun` is told what comes next and how many steps it has,
    `advance` how many more are done. The same call goes on where a run was broken off.

    Raises:
        UnknownNameError: no such method.
        TrainingError: a configuration, a model, a corpus or a folder that cannot be used.
        MissingExtraError: a library of the extra [train] is missing.
    """
    if method not in METHODS:
        raise UnknownNameError(f"no such method of training: {method[:80]!r}; there are: {', '.join(METHODS)}")
    module, _, function = METHODS[method].partition(":")
    return getattr(import_module(f"sim2reason.training.{module}"), function)(config, out, begun=begun, advance=advance)
