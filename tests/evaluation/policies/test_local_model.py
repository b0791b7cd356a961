"""Tests of a tiny local model of random weights, and of the errors without its libraries."""

import shutil
import sys
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest

from sim2reason.errors import MissingExtraError, PolicyError
from sim2reason.evaluation.policies import SampleRequest, build_policy
from sim2reason.evaluation.policies.local_model import LocalModel

installed = pytest.mark.skipif(
    not all(map(find_spec, ("torch", "transformers", "tokenizers"))), reason="needs the libraries of the extra [train]"
)


def made(folder: Path | str, **settings: object) -> LocalModel:
    found = build_policy({"kind": "transformers", "name": "tiny", "model": str(folder), "device": "cpu", **settings})
    assert isinstance(found, LocalModel)
    return found


@pytest.mark.parametrize("missing", ["torch", "transformers"])
def test_a_missing_library_is_named_with_its_extra(missing: str, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("torch", "transformers"):
        if name == missing or find_spec(name) is None:
            monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(MissingExtraError, match=r"pip install .*'torch"):
        made("anything").complete([SampleRequest("a", 0, "How fast?", 1)])


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Save a Qwen2 of two layers with one token per byte."""
    import torch
    from tokenizers import Tokenizer, decoders, models, pre_tokenizers
    from transformers import PreTrainedTokenizerFast, Qwen2Config, Qwen2ForCausalLM

    path = tmp_path_factory.mktemp("model")
    letters = sorted(pre_tokenizers.ByteLevel.alphabet())
    vocabulary = {letter: number for number, letter in enumerate([*letters, "<|end|>"])}
    tokenizer: Any = Tokenizer(models.BPE(vocabulary, []))
    tokenizer.pre_tokenizer = pre_tokenizers.ByteLevel(add_prefix_space=False)
    tokenizer.decoder = decoders.ByteLevel()
    PreTrainedTokenizerFast(tokenizer_object=tokenizer, eos_token="<|end|>", pad_token="<|end|>").save_pretrained(path)
    torch.manual_seed(0)
    shape = {"hidden_size": 32, "intermediate_size": 64, "num_hidden_layers": 2, "num_attention_heads": 2}
    config = Qwen2Config(vocab_size=257, num_key_value_heads=2, eos_token_id=256, bos_token_id=None, **shape)
    Qwen2ForCausalLM(config).save_pretrained(path)
    return path


def requests(*seeds: int) -> list[SampleRequest]:
    return [SampleRequest("a", n, "How fast? " * (n + 1), seed) for n, seed in enumerate(seeds)]


@installed
def test_answers_hang_on_their_seeds_and_not_on_their_batch(folder: Path) -> None:
    tiny = made(folder, sampling={"max_tokens": 20})
    together = tiny.complete(requests(1, 2, 3))
    assert [found.text for found in together] == [tiny.complete([each])[0].text for each in requests(1, 2, 3)]
    assert [found.text for found in together] == [found.text for found in tiny.complete(requests(1, 2, 3))]
    assert tiny.complete(requests(4))[0].text != together[0].text
    assert all(1 <= (found.completion_tokens or 0) <= 20 for found in together)
    assert together[0].prompt_tokens == len("How fast? ")


@installed
@pytest.mark.parametrize("sampling", [{"temperature": 0.0}, {"temperature": 0.7, "top_p": 0.9}])
def test_answers_are_the_same_by_recorded_passes(folder: Path, sampling: dict[str, float]) -> None:
    asked = {"sampling": {"max_tokens": 40, **sampling}}
    plain, recorded = made(folder, **asked), made(folder, **asked, cuda_graphs=True)
    for seeds in ((1, 2, 3), (4,), (5, 6, 7, 8)):
        assert recorded.complete(requests(*seeds)) == plain.complete(requests(*seeds))


@installed
@pytest.mark.parametrize(("wish", "value"), [("repetition_penalty", 1.05), ("min_new_tokens", 1)])
def test_what_a_model_asks_of_generation_is_not_left_out(folder: Path, tmp_path: Path, wish: str, value: float) -> None:
    from transformers import GenerationConfig

    other = shutil.copytree(folder, tmp_path / "other")
    GenerationConfig(eos_token_id=256, **{wish: value}).save_pretrained(other)
    assert made(other).complete(requests(1))
    with pytest.raises(PolicyError, match=f"cuda_graphs: the model asks for {wish}; leave cuda_graphs out"):
        made(other, cuda_graphs=True).complete(requests(1))


@installed
def test_it_draws_from_the_model_s_distribution(folder: Path) -> None:
    """Pearson's χ² compares the first tokens of 2,000 samples with the softmax of the logits at that temperature."""
    import torch

    tiny = made(folder, sampling={"max_tokens": 1, "temperature": 0.05})
    tokenizer, model = tiny._load.tokenizer, tiny._load.model
    with torch.inference_mode():
        logits = model(**tokenizer("How fast?", return_tensors="pt")).logits[0, -1].double() / 0.05
    expected = torch.softmax(logits, 0) * 2000
    counts = torch.zeros(257, dtype=torch.double)
    for start in range(0, 2000, 500):
        batch = [SampleRequest("a", n, "How fast?", n) for n in range(start, start + 500)]
        processors = tiny._processors([request.seed for request in batch])
        scores = logits.float().repeat(500, 1) * 0.05
        for processor in processors:
            scores = processor(None, scores)
        counts += torch.bincount(scores.argmax(dim=1), minlength=257).double()
    often = expected >= 5.0
    found, wanted = counts[often], expected[often]
    square = float((((found - wanted) ** 2) / wanted).sum())
    free = int(often.sum())
    assert free > 3
    assert square < free + 5.0 * (2.0 * free) ** 0.5


@installed
def test_without_temperature_it_takes_the_likeliest(folder: Path) -> None:
    tiny = made(folder, sampling={"max_tokens": 8, "temperature": 0.0})
    assert len({found.text for found in tiny.complete(requests(1)) + tiny.complete(requests(2))}) == 1


@installed
def test_no_model_is_one_line(tmp_path: Path) -> None:
    with pytest.raises(PolicyError, match=r"no model could be loaded.*no such folder") as raised:
        made(tmp_path / "none").complete(requests(1))
    with pytest.raises(PolicyError, match=r"no model could be loaded.*no such folder"):
        made(tmp_path / "none").check()
    assert "\n" not in str(raised.value)


@installed
def test_a_model_is_loaded_without_a_bar(folder: Path, capfd: pytest.CaptureFixture[str]) -> None:
    made(folder, sampling={"max_tokens": 1}).complete(requests(1))
    assert capfd.readouterr() == ("", "")


@installed
@pytest.mark.parametrize("device", ["banana", "cuda:99", "meta", ""])
def test_no_such_device_is_one_line_that_lists_what_there_is(folder: Path, device: str) -> None:
    for asked in (LocalModel.check, lambda policy: policy.complete(requests(1))):
        with pytest.raises(PolicyError, match=f"no device {device!r}; there are: cpu"):
            asked(made(folder, device=device))
    made(folder).check()


@installed
def test_a_device_without_room_is_one_line(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import transformers

    def full(*_: object) -> None:
        raise RuntimeError("CUDA out of memory.\nTried to allocate 2 GiB")

    monkeypatch.setattr(transformers.Qwen2ForCausalLM, "to", full)
    with pytest.raises(PolicyError, match=r"can't be moved to cpu: CUDA out of memory\. Tried"):
        made(folder).complete(requests(1))
