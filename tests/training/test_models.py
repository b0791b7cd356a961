"""Tests of models: valid and invalid settings, and a tiny model that everything loads from its folder."""

import os
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

from sim2reason.errors import MissingExtraError, TrainingError, UnknownNameError
from sim2reason.evaluation.policies import SampleRequest, build_policy
from sim2reason.generation.item_search import sample
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions.difficulty import DIFFICULTIES
from sim2reason.text.prose.description import describe
from sim2reason.training.models import build_model, language_models

needed = ("torch", "transformers", "tokenizers", "accelerate")
installed = pytest.mark.skipif(not all(map(find_spec, needed)), reason="needs the libraries of the extra [train]")
TINY = {"kind": "scratch", "layers": 2, "width": 32, "heads": 2, "vocabulary": 400, "context": 256}


def texts() -> list[str]:
    """Return texts of problems of all recipes, and a text that is in none of them."""
    scenes = [sample(recipe, difficulty, seed=2) for recipe in RECIPES for difficulty in DIFFICULTIES]
    return [
        *(describe(scene, 3).text for scene in scenes),
        "a=9.8*sin29=4.75; v=\\sqrt{6.27}=2.50\n\\boxed{-2.5}",
    ]


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({}, "model.kind: give one of pretrained, scratch"),
        ({"kind": 3}, "model.kind"),
        ({"kind": "scratch", "layers": 0}, "model.layers"),
        ({"kind": "scratch", "layers": 10**9}, "model.layers"),
        ({"kind": "scratch", "width": 30, "heads": 4}, "width: 30 is no multiple of 8"),
        ({"kind": "scratch", "vocabulary": 5}, "model.vocabulary"),
        ({"kind": "scratch", "alone": "x" * 1000}, "model.alone"),
        ({"kind": "scratch", "seed": -1}, "model.seed"),
        ({"kind": "scratch", "depth": 3}, "model.depth: no such setting"),
        ({"kind": "pretrained"}, "model.model: is missing"),
        ({"kind": "pretrained", "model": "m", "precision": "int4"}, "model.precision"),
        ({"kind": "pretrained", "model": "m", "trust_remote_code": True}, "no such setting"),
    ],
)
def test_what_makes_no_sense_is_said_with_its_place(settings: dict[str, object], message: str) -> None:
    with pytest.raises(TrainingError) as raised:
        build_model(settings)
    assert message in str(raised.value)
    assert "\n" not in str(raised.value)


def test_an_unknown_kind_is_said_with_what_is_near() -> None:
    with pytest.raises(UnknownNameError, match="did you mean: scratch"):
        build_model({"kind": "scrach"})


@pytest.mark.parametrize("kind", [{"kind": "pretrained", "model": "nowhere"}, TINY])
def test_a_missing_library_is_named_with_its_extra(
    kind: dict[str, object], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in needed:
        monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(MissingExtraError, match=r"pip install .*'torch"):
        build_model(kind).load([], tmp_path / "model")


@installed
def test_the_tokenizer_is_lossless_and_keeps_digits_apart() -> None:
    known = texts()
    tokenizer = language_models.train_tokenizer(known, 600)
    assert len(tokenizer) == 600
    strange = [
        "",
        " ",
        "\n\n \t",
        "µ° 漢字 🧲 −×·²",
        "e\u0301 \u200b\u202e",
        "\x00\x7f",
        "<|end|> in a text",
        "12;34*5=-6/7+8",
    ]
    for text in known + strange:
        assert tokenizer.decode(tokenizer(text)["input_ids"]) == text
    pieces = [tokenizer.decode([number]) for number in range(2, 600)]
    assert not [piece for piece in pieces if len(piece) > 1 and set(piece) & set(language_models.ALONE)]
    assert any(" " in piece.strip() for piece in pieces)
    assert max(len(tokenizer(text)["input_ids"]) / len(text) for text in known[:-1]) < 0.6


@installed
def test_the_tokenizer_joins_what_it_may() -> None:
    joined = language_models.train_tokenizer(["t=12.5; t=12.5"] * 50, 300, alone="")
    assert len(joined("t=12.5; t=12.5")["input_ids"]) < 5


@installed
def test_a_model_is_the_same_each_time_and_other_with_another_seed(tmp_path: Path) -> None:
    import torch

    known = texts()
    before = torch.random.get_rng_state()
    first = build_model(TINY).load(known, tmp_path / "a")
    assert torch.equal(before, torch.random.get_rng_state())
    again = build_model(TINY).load(reversed(known), tmp_path / "b")
    other = build_model({**TINY, "seed": 1}).load(known, tmp_path / "c")
    weights = [dict(loaded.model.state_dict()) for loaded in (first, again, other)]
    assert all(torch.equal(weights[0][name], weights[1][name]) for name in weights[0])
    assert not all(torch.equal(weights[0][name], weights[2][name]) for name in weights[0])
    assert first.tokenizer.get_vocab() == again.tokenizer.get_vocab()
    assert first.model.num_parameters() < 100_000
    assert first.model.dtype == torch.float32


@installed
def test_bytes_hang_neither_on_the_process_nor_on_threads(tmp_path: Path) -> None:
    code = (
        "import sys\nfrom pathlib import Path\nfrom sim2reason.training.models import build_model\n"
        f"build_model({TINY}).load(['A block of mass 2.0 kg. ' * 3, 'How fast is it? ' * 2], Path(sys.argv[1]))"
    )
    for name, threads in (("a", "false"), ("b", "true")):
        env = {**os.environ, "TOKENIZERS_PARALLELISM": threads, "PYTHONHASHSEED": "random"}
        subprocess.run([sys.executable, "-c", code, str(tmp_path / name)], check=True, env=env, capture_output=True)
    for file in ("tokenizer.json", "model.safetensors", "config.json", "scratch.json"):
        assert (tmp_path / "a" / file).read_bytes() == (tmp_path / "b" / file).read_bytes()


@installed
def test_it_is_loaded_by_its_folder_like_any_checkpoint(tmp_path: Path) -> None:
    made = build_model(TINY).load(texts(), tmp_path / "model")
    assert made.path == str(tmp_path / "model")
    read = build_model({"kind": "pretrained", "model": made.path}).load([], tmp_path / "unused")
    assert not (tmp_path / "unused").exists()
    assert read.model.num_parameters() == made.model.num_parameters()
    sampling = {"max_tokens": 8}
    policy = build_policy(
        {"kind": "transformers", "name": "tiny", "model": made.path, "device": "cpu", "sampling": sampling}
    )
    prompt = texts()[0][:100]
    completion = policy.complete([SampleRequest("a", 0, prompt, 1)])[0]
    assert completion.prompt_tokens == len(made.tokenizer(prompt)["input_ids"])


@installed
def test_a_folder_is_gone_on_with_or_refused(tmp_path: Path) -> None:
    out = tmp_path / "model"
    (tmp_path / "model.part").mkdir()  # of a run that was killed
    build_model(TINY).load(["A block."], out)
    assert not (tmp_path / "model.part").exists()
    before = {path.name: path.read_bytes() for path in out.iterdir()}
    build_model(TINY).load(iter(()), out)
    assert {path.name: path.read_bytes() for path in out.iterdir()} == before
    with pytest.raises(TrainingError, match="of other settings"):
        build_model({**TINY, "layers": 1}).load(["A block."], out)
    (out / "scratch.json").write_text("{}")
    with pytest.raises(TrainingError, match="no model that was made here"):
        build_model(TINY).load(["A block."], out)


@installed
def test_no_checkpoint_is_one_line(tmp_path: Path) -> None:
    with pytest.raises(TrainingError, match="no model could be loaded") as raised:
        build_model({"kind": "pretrained", "model": str(tmp_path / "none")}).load([], tmp_path)
    assert "\n" not in str(raised.value)
