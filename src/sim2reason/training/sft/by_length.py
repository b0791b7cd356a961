"""Rows in an order in which those of a batch are about equally long, so that little is computed for padding."""

# torch is an extra:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUntypedBaseClass=false

from collections.abc import Iterator, Sequence
from functools import cache

import numpy as np

from sim2reason.generation.random_scenes import generator
from sim2reason.training.extras import External, library

__all__ = ["batches_by_length", "sampler_by_length"]

AMONG = 50  # batches whose rows are sorted together: more of them, less padding and a less random order


def batches_by_length(lengths: Sequence[int], batch: int, seed: int, epoch: int) -> list[int]:
    """The places of all rows, batch by batch: a pure function. Batches come in random order, a smaller one last."""
    rng, held = generator("length", seed, epoch), np.asarray(lengths)
    order = rng.permutation(len(held))
    stretches = np.split(order, range(AMONG * batch, len(order), AMONG * batch))
    near = np.concatenate([each[np.argsort(held[each], kind="stable")] for each in stretches])
    whole = len(near) - len(near) % batch
    shuffled = rng.permutation(near[:whole].reshape(-1, batch))
    return [*shuffled.ravel().tolist(), *near[whole:].tolist()]


def sampler_by_length(lengths: Sequence[int], batch: int, seed: int) -> External:
    """Return what torch's loaders take: the same order in each run, another in each pass."""
    return _sampler()(lengths, batch, seed)


@cache
def _sampler() -> External:
    """Return the class, made when torch is there."""

    class ByLength(library("torch.utils.data").Sampler):
        def __init__(self, lengths: Sequence[int], batch: int, seed: int) -> None:
            self.lengths, self.batch, self.seed, self.epoch = lengths, batch, seed, 0

        def set_epoch(self, epoch: int) -> None:
            """Called before each pass."""
            self.epoch = epoch

        def __len__(self) -> int:
            return len(self.lengths)

        def __iter__(self) -> Iterator[int]:
            return iter(batches_by_length(self.lengths, self.batch, self.seed, self.epoch))

    return ByLength
