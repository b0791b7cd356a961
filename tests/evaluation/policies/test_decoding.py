"""Tests of generation with a cache of fixed size, against transformers."""

from collections.abc import Sequence
from importlib.util import find_spec
from typing import Any, TypeAlias

import pytest

from sim2reason.errors import PolicyError
from sim2reason.evaluation.policies.decoding import CHECK_EVERY, LENGTH_MULTIPLE, Decoder

Tensor: TypeAlias = Any
Model: TypeAlias = Any  # of transformers
pytestmark = pytest.mark.skipif(
    not all(map(find_spec, ("torch", "transformers"))), reason="needs the libraries of the extra [train]"
)
END = 50
WIDTHS = (3, 9, 5)
SHAPE = {
    "vocab_size": 51,
    "hidden_size": 32,
    "intermediate_size": 64,
    "num_hidden_layers": 2,
    "num_attention_heads": 4,
    "num_key_value_heads": 2,
}
devices = pytest.mark.parametrize("device", ["cpu", "cuda"])


def model_on(device: str, **changed: object) -> Model:
    """Build a Qwen3 of two layers."""
    import torch
    from transformers import Qwen3Config, Qwen3ForCausalLM

    if device == "cuda" and not torch.cuda.is_available():
        pytest.skip("needs a GPU")
    torch.manual_seed(0)
    given = {**SHAPE, "head_dim": 8, "tie_word_embeddings": True, "eos_token_id": END, "pad_token_id": 0, **changed}
    config = Qwen3Config(bos_token_id=None, **given)
    model = Qwen3ForCausalLM(config).to(device)
    with torch.no_grad():
        model.model.embed_tokens.weight *= 20.0  # far from ties
    return model


def prompts(device: str, widths: Sequence[int] = WIDTHS) -> tuple[Tensor, Tensor]:
    """Return prompts of several lengths, padded on the left, and their mask."""
    import torch

    draw = torch.Generator().manual_seed(sum(widths))
    ids = torch.zeros(len(widths), max(widths), dtype=torch.long)
    for row, width in zip(ids, widths, strict=True):
        row[-width:] = torch.randint(1, END, (width,), generator=draw)
    return ids.to(device), (ids > 0).long().to(device)


def greedy(logits: Tensor) -> Tensor:
    return logits.argmax(dim=1)


def generated(model: Model, ids: Tensor, mask: Tensor, count: int) -> Tensor:
    """Return the continuations that transformers generates, without an end token."""
    kept = {"do_sample": False, "max_new_tokens": count, "eos_token_id": None}
    return model.generate(input_ids=ids, attention_mask=mask, **kept)[:, ids.shape[1] :]


@devices
def test_greedy_tokens_are_those_of_transformers(device: str) -> None:
    model = model_on(device)
    ids, mask = prompts(device)
    found = Decoder(model)(ids, mask, 20, greedy, ())
    assert found.tolist() == generated(model, ids, mask, 20).tolist()


@devices
def test_batches_of_other_shapes_leave_nothing_behind(device: str) -> None:
    """Smaller batches reuse the cache, and larger ones enlarge it."""
    model = model_on(device)
    decoder = Decoder(model)
    for widths, count in (
        ((3, 9, 5), 20),
        ((4,), 7),
        ((2, 2), 20),
        ((6, 7, 8, 1, 12), 2 * LENGTH_MULTIPLE),
        ((3, 9, 5), 20),
    ):
        ids, mask = prompts(device, widths)
        assert decoder(ids, mask, count, greedy, ()).tolist() == generated(model, ids, mask, count).tolist()


@devices
def test_weights_that_were_updated_in_place_are_the_ones_that_answer(device: str) -> None:
    import torch

    model = model_on(device)
    decoder, (ids, mask) = Decoder(model), prompts(device)
    before = decoder(ids, mask, 20, greedy, ()).tolist()
    with torch.no_grad():
        for weight in model.parameters():
            weight.add_(0.3 * torch.randn_like(weight))
    after = decoder(ids, mask, 20, greedy, ()).tolist()
    assert after != before
    assert after == generated(model, ids, mask, 20).tolist()


@devices
def test_it_stops_soon_after_all_rows_have_ended(device: str) -> None:
    import torch

    model = model_on(device)
    ids, mask = prompts(device)
    told = list[int]()

    def choose(logits: Tensor) -> Tensor:
        told.append(len(logits))
        ends = torch.arange(len(logits), device=logits.device) < len(told)
        return torch.where(ends, END, logits.argmax(dim=1))

    found = Decoder(model)(ids, mask, 100, choose, {END})
    assert found.shape == (3, CHECK_EVERY)
    assert told == [3] * CHECK_EVERY
    assert found[:, 3].tolist() == [END] * 3


@devices
def test_training_goes_on_as_it_was(device: str) -> None:
    """Generation disables dropout and restores the model's mode, and gradients flow afterwards."""
    model = model_on(device, attention_dropout=0.5)
    ids, mask = prompts(device)
    expected = generated(model.eval(), ids, mask, 20).tolist()
    assert Decoder(model.train())(ids, mask, 20, greedy, ()).tolist() == expected
    assert model.training
    model(input_ids=ids, attention_mask=mask, labels=ids).loss.backward()
    assert all(weight.grad is not None for weight in model.parameters())


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        (
            {"layer_types": ["full_attention", "sliding_attention"], "sliding_window": 4, "use_sliding_window": True},
            "layers with a StaticSlidingWindowLayer",
        ),
        ({"attn_implementation": "eager"}, "goes with attention sdpa, not eager"),
    ],
)
def test_attention_that_is_masked_otherwise_is_refused(changed: dict[str, object], said: str) -> None:
    with pytest.raises(PolicyError, match=f"cuda_graphs: .*{said}"):
        Decoder(model_on("cpu", **changed))


def test_a_window_that_layers_do_not_tell_is_refused() -> None:
    from transformers import MistralConfig, MistralForCausalLM

    with pytest.raises(PolicyError, match="layers with a StaticSlidingWindowLayer"):
        Decoder(MistralForCausalLM(MistralConfig(sliding_window=8, **SHAPE)))
