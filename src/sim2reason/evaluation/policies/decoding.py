"""Batched decoding by a causal transformers model with a fixed-size cache and CUDA graphs.

A small model on a GPU is limited by kernel launches: the pass for one more token takes a hundred or more kernels of
microseconds. On a CUDA device such a pass is recorded once as a graph, and replayed for each token. It reads the
weights in place, so it remains valid when they are updated in place.
"""

# transformers and torch are an extra, and ship no types to an environment without them:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from collections.abc import Callable, Collection
from contextlib import AbstractContextManager, nullcontext
from importlib import import_module
from typing import Any, TypeAlias

from sim2reason.errors import PolicyError

__all__ = ["Decoder", "check_recordable"]


Tensor: TypeAlias = Any
LENGTH_MULTIPLE = 16  # cache lengths are multiples of it, which the attention kernels need for masks
CHECK_EVERY = 16  # tokens between two checks whether all rows have ended, which synchronize the device
WARMUP_PASSES = 2  # before recording, because libraries initialise themselves in the first pass
ATTENTION, LAYER = "sdpa", "StaticLayer"


def check_recordable(config: Any) -> None:  # noqa: ANN401 - of transformers
    """Raise PolicyError for a model whose layers need several attention masks, as with sliding windows."""
    layers = import_module("transformers").StaticCache(config=config, max_cache_len=LENGTH_MULTIPLE).layers
    if others := {type(layer).__name__ for layer in layers} - {LAYER}:
        raise PolicyError(f"cuda_graphs: the model has layers with a {', '.join(sorted(others))}; leave it out")
    if config._attn_implementation != ATTENTION:  # noqa: SLF001 - transformers tells it nowhere else
        raise PolicyError(f"cuda_graphs: goes with attention {ATTENTION}, not {config._attn_implementation}")  # noqa: SLF001


class Decoder:
    """A decoder of prompts with one model, whose weights may change between two calls."""

    def __init__(self, model: Any) -> None:  # noqa: ANN401 - of transformers
        """Store the model; PolicyError for one whose layers need several attention masks, as with sliding windows."""
        check_recordable(model.config)
        self._model = model
        self._last_pass: _RecordedPass | None = None

    def __call__(
        self, ids: Tensor, mask: Tensor, count: int, choose: Callable[[Tensor], Tensor], ends: Collection[int]
    ) -> Tensor:
        """Return at most `count` tokens after each prompt, (rows, tokens); values after an end are arbitrary.

        `ids` and `mask` have the shape (rows, width), padded on the left; `choose` returns a token for each row of the
        logits, of shape (rows, vocabulary).
        """
        torch = import_module("torch")
        rows, training = len(ids), self._model.training
        ending = torch.tensor(sorted(ends), device=ids.device)
        ended, tokens = torch.zeros(rows, dtype=torch.bool, device=ids.device), list[Tensor]()
        self._model.eval()
        try:
            with torch.no_grad(), self._on_its_device():
                recorded = self._recorded(rows, ids.shape[1] + count)
                logits = recorded.prefill(ids, mask)
                while True:
                    tokens.append(choose(logits[:rows]))
                    ended |= (tokens[-1][:, None] == ending).any(dim=1)
                    if len(tokens) == count or (len(tokens) % CHECK_EVERY == 0 and bool(ended.all())):
                        return torch.stack(tokens, dim=1)
                    logits = recorded.step(tokens[-1])
        finally:
            self._model.train(training)

    def _on_its_device(self) -> AbstractContextManager[None]:
        """Return a context in which the model's device is the current one."""
        device = self._model.device
        return import_module("torch").cuda.device(device) if device.type == "cuda" else nullcontext()

    def _recorded(self, rows: int, length: int) -> "_RecordedPass":
        """Return a recorded pass for at least `rows` rows and `length` tokens: the last one, or a larger new one."""
        cached = self._last_pass
        if cached is None or cached.rows < rows or cached.length < length:
            rows, length = (rows, length) if cached is None else (max(rows, cached.rows), max(length, cached.length))
            self._last_pass = cached = None  # not two caches at once
            self._last_pass = cached = _RecordedPass(self._model, rows, -(-length // LENGTH_MULTIPLE) * LENGTH_MULTIPLE)
        return cached


class _RecordedPass:
    """A forward pass for one token per row, recorded as a CUDA graph with inputs and outputs at fixed addresses."""

    def __init__(self, model: Any, rows: int, length: int) -> None:  # noqa: ANN401 - of transformers
        self.rows, self.length = rows, length
        self._model, self._torch = model, import_module("torch")
        torch, device = self._torch, model.device
        self._cache = import_module("transformers").StaticCache(config=model.config, max_cache_len=length)
        self._token = torch.zeros(rows, 1, dtype=torch.long, device=device)
        self._position_ids = torch.zeros_like(self._token)
        self._cache_position = torch.zeros(1, dtype=torch.long, device=device)
        self._positions = torch.arange(length, device=device)
        self._visible = torch.zeros(rows, 1, 1, length, dtype=torch.bool, device=device)
        self._graph: Any = None
        self._logits: Tensor = None
        if device.type == "cuda":
            self._record()

    def prefill(self, ids: Tensor, mask: Tensor) -> Tensor:
        """Process the prompts' tokens, and return the logits of the token after each prompt, (rows, vocabulary)."""
        torch, width = self._torch, ids.shape[1]
        ids, mask = self._filled(ids), self._filled(mask.bool())
        self._cache.reset()
        position_ids = (mask.cumsum(dim=1) - 1).clamp(min=0)
        keys = torch.nn.functional.pad(mask, (0, self.length - width))
        query = self._positions[:width, None]
        # padding looks at itself: a softmax over nothing would be NaN, also for those that must not look at it
        visible = (query >= self._positions) & keys[:, None] | (query == self._positions)
        logits = self._forward(ids, visible[:, None], position_ids, logits_to_keep=1)
        self._visible.copy_(keys[:, None, None])
        self._position_ids.copy_(position_ids[:, -1:] + 1)
        self._cache_position.fill_(width)
        return logits

    def step(self, tokens: Tensor) -> Tensor:
        """Process one token of each of the first rows; return the logits of the next tokens."""
        self._token[: len(tokens), 0].copy_(tokens)
        if self._graph is None:
            return self._next()
        self._graph.replay()
        return self._logits

    def _filled(self, given: Tensor) -> Tensor:
        """Return the rows of a tensor padded to the recorded number of rows by repeating the last row."""
        return self._torch.cat([given, given[-1:].expand(self.rows - len(given), -1)])

    def _next(self) -> Tensor:
        self._visible.logical_or_(self._positions == self._cache_position)
        logits = self._forward(self._token, self._visible, self._position_ids)
        self._cache_position.add_(1)
        self._position_ids.add_(1)
        return logits

    def _forward(self, ids: Tensor, visible: Tensor, position_ids: Tensor, **given: int) -> Tensor:
        """Return the logits of the last token from the model class's own forward, without a trainer's wrappers."""
        run, named = type(self._model).forward, {"attention_mask": visible, "position_ids": position_ids}
        output = run(self._model, input_ids=ids, past_key_values=self._cache, use_cache=True, **named, **given)
        return output.logits[:, -1].float()

    def _record(self) -> None:
        cuda = self._torch.cuda
        self._next()  # here, and not aside: the cache is made in it, and is to lie in the memory of this stream
        side = cuda.Stream()
        side.wait_stream(cuda.current_stream())
        with cuda.stream(side):
            for _ in range(WARMUP_PASSES):
                self._next()
        cuda.current_stream().wait_stream(side)
        self._graph = cuda.CUDAGraph()
        with cuda.graph(self._graph, stream=side):
            self._logits = self._next()
