"""Tests that an entity of another package, installed with an entry point, appears everywhere."""

import json
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from packages import SOURCE, environment, installed

Run = Callable[..., str]


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return installed(tmp_path_factory.mktemp("third_party"))


def python(site: Path, code: str, *arguments: str) -> str:
    command = [sys.executable, "-c", code, *arguments]
    done = subprocess.run(
        command, capture_output=True, text=True, check=False, timeout=120, env=environment(site), cwd=site.parent
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture
def run(site: Path) -> Run:
    shutil.copy(SOURCE / "scene.yaml", site.parent)
    return lambda *arguments: python(site, "from sim2reason.cli import main; main()", *arguments)


def test_it_is_listed_and_in_the_schema(run: Run) -> None:
    listed = json.loads(run("list", "entities", "--json"))["entities"]
    assert {"name": "HorseAndSledge"}.items() <= next(e for e in listed if e["name"] == "HorseAndSledge").items()
    assert "HorseAndSledge" in run("schema")
    assert "HorseAndSledge" in run("schema", "--page")


def test_it_is_described_simulated_and_asked_about(run: Run) -> None:
    text = run("describe", "scene.yaml")
    assert "horse" in text
    assert "4.0 kg" in text
    assert json.loads(run("simulate", "scene.yaml", "--engine", "both", "--json"))
    asked = json.loads(run("ask", "scene.yaml", "-n", "3", "--json"))
    assert len(asked) == 3
    acceleration = 9.0 / 4.0 - 0.1 * 9.8  # Newton, with kinetic friction
    found = [each["answer"]["value"] for each in asked if each["asked"]["quantity"] == "acceleration"]
    assert all(abs(answer / acceleration - 1.0) < 1e-9 for answer in found)


def test_it_is_drawn_and_plotted(run: Run, site: Path) -> None:
    run("figure", "scene.yaml", "-o", "scene.svg")
    run("plot", "scene.yaml", "-o", "motion.svg")
    for name in ("scene.svg", "motion.svg"):
        assert "<svg" in (site.parent / name).read_text()


def test_its_recipe_gives_scenes(run: Run) -> None:
    assert "type: HorseAndSledge" in run("sample", "--recipe", "sledges", "--difficulty", "easy", "--seed", "3")


@pytest.mark.slow
def test_its_recipe_gives_items(run: Run) -> None:
    run("generate", "out", "--items", "3", "--recipe", "sledges", "--difficulty", "easy", "--seed", "0")
    assert run("show", "out", "-n", "3").count("horse") >= 3


CONFORMS = """
import sim2reason
from sim2reason.scenes.dsl.entity import ENTITIES
from sim2reason.testing import check_entity
from sim2reason.scenes.dsl.choices import connections_for_port

cls = ENTITIES["HorseAndSledge"]
check_entity(cls, seeds=range(2))
scene = sim2reason.load(open("scene.yaml").read())
assert sim2reason.load(sim2reason.dump(scene)) == scene
assert sim2reason.parse_scene(sim2reason.describe(scene, 3).text).scene.entities[0].entity == cls(
    load={"mass": 4.0}, draught=9.0, friction=0.1
)
trace, certificate = sim2reason.certify(scene)
assert certificate.stable_until == scene.horizon, certificate
hook = connections_for_port(ENTITIES["FixedSupport"], "end")
assert any(cls in option.partners for option in hook), "others can be tied to it"
print("fine")
"""


def test_it_conforms_is_read_back_and_certified(site: Path, run: Run) -> None:
    del run
    assert python(site, CONFORMS).strip() == "fine"
