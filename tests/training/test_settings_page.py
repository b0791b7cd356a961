"""Tests that the tables of settings in docs/training.md agree with the classes of the settings."""

import re
from pathlib import Path
from typing import cast

import pytest
from pydantic import BaseModel

from sim2reason.training.gspo.settings import GSPOSettings, VllmSettings
from sim2reason.training.models.language_models import Pretrained, Scratch
from sim2reason.training.optimization import Lora
from sim2reason.training.problem_stream import Curriculum
from sim2reason.training.rl.config import HeldOut, Prefetch, ReinforcementLearning
from sim2reason.training.sources import build_source
from sim2reason.training.sources.problems import Fresh

PAGE = (Path(__file__).parents[2] / "docs/training.md").read_text(encoding="utf-8")
SECTIONS = {
    "": ReinforcementLearning,
    "curriculum.": Curriculum,
    "gspo.": GSPOSettings,
    "gspo.lora.": Lora,
    "gspo.vllm.": VllmSettings,
}


def table(title: str) -> dict[str, str]:
    """Return the defaults by setting in the table whose first column has a title."""
    lines = PAGE.partition(f"| {title} | default | meaning |\n| --- | --- | --- |\n")[2].partition("\n\n")[0]
    cells = [re.split(r"(?<!\\) \| ", line.strip("| ")) for line in lines.splitlines()]
    return {name.strip("`"): default.strip("`") for name, default, _ in cells}


def written(value: object) -> str:
    """Return a default as the page writes it."""
    if value is None or value in ((), {}):
        return "none"
    if isinstance(value, BaseModel):
        return f"{{{', '.join(f'{name}: {written(each)}' for name, each in value)}}}"
    if isinstance(value, tuple):
        return f"[{', '.join(map(str, cast('tuple[object, ...]', value)))}]"
    return str(value).lower() if isinstance(value, bool) else str(value)


def defaults(model: type[BaseModel], prefix: str = "") -> dict[str, str]:
    """Return the defaults of a class of settings by name; a dash marks required ones."""
    return {
        f"{prefix}{name}": "–" if field.is_required() else written(field.get_default(call_default_factory=True))
        for name, field in model.model_fields.items()
    }


def test_reinforcement_learning() -> None:
    expected = {name: text for prefix, model in SECTIONS.items() for name, text in defaults(model, prefix).items()}
    assert table("setting") == {**expected, "gspo": "as below"}


@pytest.mark.parametrize(("kind", "model"), [("pretrained", Pretrained), ("scratch", Scratch), ("fresh", Fresh)])
def test_models_and_sources(kind: str, model: type[BaseModel]) -> None:
    assert table(f"setting of `{{kind: {kind}}}`") == defaults(model)


def test_held_out_problems_and_prefetching() -> None:
    row = next(line for line in PAGE.splitlines() if line.startswith("| `held_out` |"))
    shown = dict(re.findall(r"`(\w+)` \((\d+)\)", row))
    assert {"problems": "–", **shown} == defaults(HeldOut)
    assert f"| `prefetch` | `{written(Prefetch())}` |" in PAGE


def test_a_dataset_folder_in_the_mixture_is_spelled_as_shown(tmp_path: Path) -> None:
    assert "{kind: benchmark, name: own, benchmark: {kind: synthetic, dataset: FOLDER}}" in PAGE
    own = {"kind": "benchmark", "name": "own", "benchmark": {"kind": "synthetic", "dataset": str(tmp_path)}}
    assert build_source(own, "problems[0]").name == "own"
