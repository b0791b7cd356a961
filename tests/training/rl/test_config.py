"""Tests of configurations of reinforcement learning: strict reading, and errors that name the field."""

import re
from pathlib import Path
from typing import Any

import pytest
import yaml

from sim2reason.errors import Sim2ReasonError, TrainingError
from sim2reason.training.models.language_models import Pretrained
from sim2reason.training.rewards.answers import Random
from sim2reason.training.rl.config import build_reinforcement_learning
from sim2reason.training.sft.config import build_fine_tuning
from sim2reason.training.study.config import build_study

ROOT = Path(__file__).parents[3]
FRESH = {"kind": "fresh", "name": "ours", "seed": 1}
WARM = {"model": {"kind": "scratch"}, "corpora": [{"kind": "drills"}], "steps": 1}


def settings(**changed: object) -> dict[str, Any]:
    return {
        "out": "run",
        "model": {"kind": "pretrained", "model": "m"},
        "problems": [FRESH],
        "reward": "accuracy",
    } | changed


def test_the_least_configuration_has_the_paper_s_numbers() -> None:
    found = build_reinforcement_learning(settings())
    assert isinstance(found.model, Pretrained)
    gspo = found.gspo
    assert (gspo.steps, gspo.prompts, gspo.generations, gspo.learning_rate, gspo.rounds) == (200, 32, 16, 1e-6, 10)


def test_a_completion_leaves_room_for_the_prompt() -> None:
    gspo = build_reinforcement_learning(settings()).gspo
    gspo.check_context(32_768)
    with pytest.raises(TrainingError, match=r"gspo\.max_completion_tokens: 16384 .* context of 4096 tokens"):
        gspo.check_context(4096)


def test_a_control_is_one_key() -> None:
    found = build_reinforcement_learning(settings(reward={"kind": "random", "seed": 3}))
    assert isinstance(found.reward, Random)
    unfiltered = build_reinforcement_learning(settings(problems=[{**FRESH, "unfiltered": True}]))
    assert found.decisive != unfiltered.decisive


def test_where_a_run_lies_decides_nothing() -> None:
    one, other = build_reinforcement_learning(settings()), build_reinforcement_learning(settings(), Path("elsewhere"))
    assert other.out == Path("elsewhere")
    assert one.decisive == other.decisive


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"model": None}, "give either model or warm_start"),
        ({"reward": "acuracy"}, "acuracy"),
        ({"problems": []}, "problems"),
        ({"problems": [{**FRESH, "recipe": 3}]}, r"problems\[0\]\.recipe"),
        ({"problems": [{**FRESH, "recipe": "puley"}]}, r"problems\[0\]\.recipe: .*did you mean: pulley"),
        ({"problems": [{**FRESH, "difficulty": "harder"}]}, r"problems\[0\]\.difficulty: .*hard"),
        ({"problems": [{**FRESH, "modes": ["numerc"]}]}, r"problems\[0\]\.modes: .*did you mean: numeric"),
        ({"problems": [{**FRESH, "modes": []}]}, r"problems\[0\]\.modes: names none"),
        ({"problems": [{**FRESH, "units": "imperial"}]}, r"problems\[0\]\.units: .*imperial"),
        ({"problems": [{**FRESH, "weights": {"perod": 2.0}}]}, r"problems\[0\].*perod"),
        ({"held_out": {"problems": {"name": "h", "seed": 2, "recipe": "puley"}}}, r"held_out\.0\.problems\.recipe: "),
        ({"gspo": {"steps": 0}}, r"gspo\.steps"),
        ({"gspo": {"prompts": 3, "generations": 3}}, r"gspo\.minibatches: 9 completions a step"),
        ({"gspo": {"prompts": 4, "generations": 4, "microbatch": 3}}, r"gspo\.microbatch: .*microbatches of 3"),
        ({"processes": 3}, r"gspo\.prompts: 32 cannot be shared evenly by 3 processes"),
        ({"processes": 2, "gspo": {"prompts": 2, "generations": 3, "minibatches": 2}}, r"minibatches.* on 2 processes"),
        ({"processes": 2, "gspo": {"microbatch": 128}}, r"gspo\.microbatch: the 64 completions.* on 2 processes"),
        ({"processes": 4, "model": None, "warm_start": {**WARM, "batch": 6}}, r"warm_start\.batch: 6 rows"),
        ({"curriculum": {"floor": 0}}, r"curriculum\.floor"),
        ({"stps": 3}, "stps"),
        ({"held_out": {"problems": {"name": "h", "seed": 1}}}, "problems are trained on with this seed"),
        ({"held_out": [{"problems": {"name": "h", "seed": n}} for n in (2, 3)]}, "'h' stands twice"),
        ({"model": None, "warm_start": {"out": "x"}}, r"warm_start\.out"),
        ({"model": None, "warm_start": {"corpora": []}}, "model|corpora"),
    ],
)
def test_faults_name_their_place(changed: dict[str, object], message: str) -> None:
    with pytest.raises(Sim2ReasonError, match=message):
        build_reinforcement_learning(settings(**changed))


def test_a_file_that_is_missing() -> None:
    with pytest.raises(FileNotFoundError, match=r"nowhere\.yaml"):
        build_reinforcement_learning("nowhere.yaml")
    with pytest.raises(TrainingError):
        build_reinforcement_learning(settings(model="m"))


def test_the_configurations_of_the_page_can_be_read(monkeypatch: pytest.MonkeyPatch) -> None:
    page = (ROOT / "docs" / "training.md").read_text("utf-8")
    first, study, second = (
        yaml.safe_load(block) for block in re.findall(r"^```yaml\n(.*?)^```", page, re.DOTALL | re.MULTILINE)
    )
    assert build_reinforcement_learning(first).curriculum is not None
    assert len(build_fine_tuning(second).corpora) == 3
    monkeypatch.chdir(ROOT)
    assert len(build_study(study).runs) == 7
