"""Tests of configurations of studies: arms change a base, seeds change sampling and problems."""

from pathlib import Path
from typing import Any

import pytest
import yaml

from short_run import settings
from sim2reason.errors import Sim2ReasonError
from sim2reason.training.study.config import Arm, TrainingStudy, build_study

ROOT = Path(__file__).parents[3]
STUDIES = sorted((ROOT / "experiments").rglob("*study*.yaml"))


def base() -> dict[str, Any]:
    return {name: value for name, value in settings(Path("run")).items() if name != "out"}


def study(**changed: object) -> TrainingStudy:
    arms = {"ours": {}, "other": {"reward": "format", "gspo": {"steps": 2}}}
    return build_study({"out": "study", "base": base(), "arms": arms, "seeds": [0, 7], **changed})


def test_an_arm_changes_what_it_names_and_nothing_else() -> None:
    found = study()
    ours, other = (found.configs[Arm(name, 0)] for name in ("ours", "other"))
    assert (ours.gspo.steps, other.gspo.steps) == (3, 2)
    assert other.gspo.prompts == ours.gspo.prompts
    assert {name for name, value in ours.decisive.items() if other.decisive[name] != value} == {"reward", "gspo"}


def test_what_has_a_kind_is_replaced_as_a_whole() -> None:
    model = {"kind": "scratch", "layers": 1, "width": 64, "heads": 2}
    found = study(arms={"wide": {"warm_start": {"model": model}}}).settings[Arm("wide", 0)]
    assert found["warm_start"]["model"] == model
    assert found["warm_start"]["corpora"] == base()["warm_start"]["corpora"]


def test_each_seed_samples_and_draws_anew_and_evaluates_on_the_same_problems() -> None:
    found = study()
    first, second = (found.configs[Arm("ours", seed)] for seed in (0, 7))
    assert (first.gspo.seed, second.gspo.seed) == (0, 7)
    assert first.decisive["problems"] != second.decisive["problems"]
    assert first.held_out == second.held_out
    assert first.warm_start == second.warm_start


def test_each_run_has_a_folder_of_its_own() -> None:
    found = study()
    assert [arm.run for arm in found.runs] == ["ours-0", "other-0", "ours-7", "other-7"]
    assert found.configs[Arm("other", 7)].out == Path("study/runs/other-7")


def test_an_arm_may_have_seeds_of_its_own() -> None:
    found = study(arms={"ours": {}, "once": {"reward": "format", "seeds": [3]}}, seeds=[0, 1])
    assert [arm.run for arm in found.runs] == ["ours-0", "ours-1", "once-3"]
    assert found.first("once").gspo.seed == 3


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"arms": {}}, "arms"),
        ({"seeds": [1, 1]}, "a seed stands twice"),
        ({"arms": {"a": {"seeds": []}}}, "at least 1 item"),
        ({"arms": {"a": {"seeds": ["x"]}}}, "must be an integer"),
        ({"arms": {"a/b": {}}}, "arms"),
        ({"arms": {"a": {"reward": "nothing"}}}, r"arms\.a: .*nothing"),
        ({"arms": {"a": {"gspo": {"stps": 1}}}}, r"arms\.a: .*stps"),
        ({"arms": {"a": {}, "b": {"held_out": {"items": 9}}}}, "other held-out problems"),
        ({"base": "nowhere.yaml"}, "nowhere"),
        ({"base": [1]}, "base"),
        ({"arms": {"a": {"problems": 3}}}, r"arms\.a: .*problems"),
    ],
)
def test_faults_name_their_place(changed: dict[str, object], message: str) -> None:
    with pytest.raises((Sim2ReasonError, FileNotFoundError), match=message):
        study(**changed)


@pytest.mark.parametrize("file", STUDIES, ids=lambda path: path.stem)
def test_each_study_can_be_read(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    found = build_study(yaml.safe_load(file.read_text("utf-8")))
    assert len(found.configs) == sum(len(found.seeds_of(name)) for name in found.arms)
