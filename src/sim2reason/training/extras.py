"""Libraries of the extra [train], imported when first needed."""

from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec
from typing import Any

from sim2reason.base.optional import optional
from sim2reason.errors import MissingExtraError
from sim2reason.evaluation.policies.network import silence_library

__all__ = [
    "EXTRA",
    "External",
    "disable_cudnn_attention",
    "is_main_process",
    "library",
    "require",
    "silence_library",
    "versions",
]

EXTRA = "train"
SEPARATE_EXTRAS = "vllm", "wandb"  # each in an extra of its own, because few runs need it
LIBRARIES = "sim2reason", "torch", "transformers", "trl", "accelerate", "peft"
External = Any
"""A value of a class of such a library: their types hold only where they are installed."""


def library(name: str) -> External:
    """Import and return a library; MissingExtraError, with the install command, if it is missing."""
    return optional(name, EXTRA)


def require(*names: str) -> None:
    """Check that all named libraries are installed; MissingExtraError if one is missing."""
    for name in names:
        if find_spec(name) is None:
            raise MissingExtraError(name, name if name in SEPARATE_EXTRAS else EXTRA)


def disable_cudnn_attention() -> None:
    """Disable cuDNN attention in torch, whose gradients may be NaN on Hopper GPUs since torch 2.11.

    They occur with a mask and 64 tokens beyond a multiple of 128 (pytorch issue 196678). This ended one of six runs of
    reinforcement learning on an H200, in its second step.
    """
    library("torch").backends.cuda.enable_cudnn_sdp(enabled=False)  # a flag, with or without a GPU


def versions() -> dict[str, str]:
    """Return the versions of the installed libraries that affect training."""
    installed = dict[str, str]()
    for name in LIBRARIES:
        try:
            installed[name] = version(name)
        except PackageNotFoundError:
            continue
    return installed


def is_main_process() -> bool:
    """Return whether this is the only process of a run, or the first of several."""
    return bool(library("accelerate").PartialState().is_main_process)
