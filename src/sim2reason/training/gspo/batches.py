"""Groups extracted from a round of completions in TRL, and merged into the batch of a step."""

# torch is an extra and ships no types to an environment without it:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from collections.abc import Sequence
from typing import Any, TypeAlias

from sim2reason.errors import TrainingError
from sim2reason.training.extras import library

__all__ = ["Group", "cut", "filler", "join", "moved"]

Tensor: TypeAlias = Any
Group: TypeAlias = dict[str, Tensor]
"""What TRL keeps for the completions of one prompt, without columns that are padding for all of them."""

PROMPT = {"prompt_ids", "prompt_mask"}  # (completions, tokens), padded on the left
COMPLETION = {  # (completions, tokens), padded on the right
    "completion_ids",
    "completion_mask",
    "old_per_token_logps",
    "ref_per_token_logps",
    "sampling_per_token_logps",
}
ROW = {"advantages", "importance_sampling_ratio"}  # one number per completion
BATCH = {"num_items_in_batch"}  # one number for the batch, computed again


def cut(output: dict[str, Tensor], number: int, generations: int) -> Group:
    """Return the completions of one prompt, the `number`-th of this process, as a group cut from TRL's batch.

    Raises:
        TrainingError: TRL keeps something that `join` could not put together, such as pictures.
    """
    unknown = output.keys() - PROMPT - COMPLETION - ROW - BATCH
    if unknown:
        raise TrainingError(f"TRL keeps {', '.join(sorted(unknown))} for completions, which cannot be resampled here")
    rows = slice(number * generations, (number + 1) * generations)
    prompt = max(int(output["prompt_mask"][rows].sum(dim=1).max()), 1)
    completion = max(int(output["completion_mask"][rows].sum(dim=1).max()), 1)
    group: Group = {}
    for name in sorted(output.keys() - BATCH):
        held = output[name][rows]
        group[name] = held[:, -prompt:] if name in PROMPT else held[:, :completion] if name in COMPLETION else held
    return group


def filler(size: int, token: int, device: object) -> Group:
    """Return a group that fills a batch without affecting the loss: a prompt and completions of one token each."""
    torch = library("torch")
    ids = torch.full((size, 1), token, device=device)
    nothing = torch.zeros(size, 1, device=device)
    found: Group = dict.fromkeys(COMPLETION, nothing)
    found |= {"prompt_ids": ids, "prompt_mask": torch.ones_like(ids)}
    found |= {"completion_ids": ids, "completion_mask": torch.zeros_like(ids)}
    return found | {"advantages": nothing[:, 0], "importance_sampling_ratio": torch.ones_like(nothing)}


def join(groups: Sequence[Group], token: int) -> dict[str, Tensor]:
    """Return several groups of completions as one batch, padded with `token` to the longest prompt and completion."""
    torch = library("torch")
    batch: dict[str, Tensor] = {}
    for name in sorted(set[str](groups[0]).intersection(*groups)):  # fillers have all names, groups what TRL needs
        parts = [group[name] for group in groups]
        if name not in ROW:
            width = max(part.shape[1] for part in parts)
            fill = token if name.endswith("_ids") else 0
            parts = [_padded(part, width, fill, left=name in PROMPT) for part in parts]
        batch[name] = torch.cat(parts)
    return batch


def _padded(part: Tensor, width: int, fill: int, *, left: bool) -> Tensor:
    missing = width - part.shape[1]
    return library("torch.nn.functional").pad(part, (missing, 0) if left else (0, missing), value=fill)


def moved(group: Group, device: object) -> Group:
    """Return a group of completions on another device."""
    return {name: held.to(device) for name, held in group.items()}
