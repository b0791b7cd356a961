"""Tests of ``sim2reason solve`` on an item by its id, and on questions about a scene in a file."""

import json
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from sim2reason.cli import main
from sim2reason.datasets.grade import grade
from sim2reason.datasets.items import item

FLOOR = """scene:
  name: floor
  entities:
  - name: floor
    type: TwoSideMassPlane
    parameters: {plane: {angle: 0.0, friction: 0.05}, blocks: [{mass: 1.0}], speed: 5.0}
"""


def call(*args: object) -> Result:
    return CliRunner().invoke(main, ["solve", *map(str, args)])


@pytest.fixture
def scene(tmp_path: Path) -> Path:
    """Return the path of a file with a scene."""
    path = tmp_path / "scene.yaml"
    path.write_text(item("incline", "easy", seed=3, index=0).scene)
    return path


@pytest.mark.parametrize(
    ("recipe", "mode", "index", "units"),
    [("hybrid", "reverse", 0, "SI"), ("hybrid", "symbolic", 0, "SI"), ("incline", "numeric", 4, "mixed")],
)
def test_a_problem_of_an_id_is_told_and_its_solution_is_graded_right(
    recipe: str, mode: str, index: int, units: str
) -> None:
    problem = item(recipe, "easy", mode, index=index, units=units)
    told = call("--id", problem.id)
    assert told.exit_code == 0, told.output
    assert told.output.startswith(problem.prompt)
    assert grade(problem, told.output.removeprefix(problem.prompt)).reward == 1.0


def test_an_answer_in_other_units_is_converted_at_the_end() -> None:
    """The answer is converted in the last step, with 1 J = 10⁷ erg."""
    solution = call("--id", "incline-medium-numeric-0-3-cgs").output
    usual = call("--id", "incline-medium-numeric-0-3").output
    assert r"Q \approx \boxed{4.13}\ \text{J}$" in usual
    assert "Given, in SI units: $" in solution
    assert r"\ \text{J} \approx \boxed{4.13 \times 10^{7}}\ \text{erg}$" in solution


def test_in_symbols_no_number_is_said_that_the_problem_does_not_say() -> None:
    told = call("--id", "pulley-easy-symbolic-0-1").output.partition(r"\boxed{}.")[2]
    assert r"\boxed{" in told
    assert r"\text{" not in told
    assert not any(part.isdigit() for part in told.replace(",", ".").split("."))


def test_a_scene_in_a_file_with_a_question_and_with_one_that_is_drawn(scene: Path) -> None:
    drawn = call(scene, "--seed", 3)
    assert drawn.exit_code == 0, drawn.output
    assert "Answer: $" in drawn.output
    question = drawn.output.partition("\n")[0].rpartition(". ")[2]
    given = call(scene, "--question", question, "--seed", 3)
    assert given.exit_code == 0, given.output
    assert given.output == drawn.output


def test_json_has_the_steps_with_their_relations() -> None:
    told = call("--id", "pulley-easy-numeric-0-5", "--json")
    found = json.loads(told.output)
    assert found["strategy"] == "constant acceleration"
    assert found["answer"] == pytest.approx(5.372973, rel=1e-4)
    assert [step["id"] for step in found["steps"]] == list(range(len(found["steps"])))
    for step in found["steps"]:
        assert all(number < step["id"] for number in step["needs"])
        assert all(relation in found["text"] for relation in step["relations"] if step["kind"] == "newton")


@pytest.mark.parametrize(
    ("args", "said"),
    [
        (("--id", "nobody"), "is no id; one looks like pulley-easy-numeric-0-4"),
        (("--id", "pulley-easy-numeric-0-4-0123abcd"), "see: sim2reason explain DATASET --id"),
        (("--id", "pulley-easy-numeric-0-4-cgsx"), "no such units: 'cgsx'"),
        (("--id", "pully-easy-numeric-0-4"), "pully"),
        (("--id", "pulley-easy-numerical-0-4"), "numerical"),
        (("--id", "pulley-simple-numeric-0-4"), "simple"),
        (("no-such-file.yaml",), "no-such-file.yaml"),
        (("pulley-easy-numeric-0-4",), "sim2reason solve --id pulley-easy-numeric-0-4"),
    ],
)
def test_what_makes_no_sense_is_one_line(args: tuple[str, ...], said: str) -> None:
    told = call(*args)
    assert told.exit_code == 2
    assert told.output.count("\n") == 1, told.output
    assert said in told.output


def test_a_question_that_asks_nothing_known_is_one_line(scene: Path) -> None:
    told = call(scene, "--question", "Why?")
    assert told.exit_code == 2
    assert told.output.count("\n") == 1
    assert "is not understood" in told.output


SLIDING = """
scene:
  name: floor
  entities:
  - name: floor
    type: TwoSideMassPlane
    parameters: {plane: {angle: 0.0, friction: 0.05}, blocks: [{mass: 2.0}], speed: 5.0}
"""


def test_a_question_in_parts_in_words_and_in_the_file(tmp_path: Path) -> None:
    """All three ask the same question; the answer, at about 10 s of motion, is not rounded."""
    path, asking = tmp_path / "scene.yaml", tmp_path / "asking.yaml"
    path.write_text(SLIDING)
    asking.write_text(SLIDING + "question: {find: time, when: stopped}\n")
    in_parts = call(path, "--find", "time", "--of", "floor.blocks.0", "--when", "stopped")
    assert in_parts.exit_code == 0, in_parts.output
    assert in_parts.stdout.endswith("From the motion: 10.2040816327 s\n")
    words = call(path, "--question", "How long after t = 0 does the block first come to rest?")
    assert words.output == in_parts.output == call(asking).output


def test_what_never_happens_is_told_with_its_reason(tmp_path: Path) -> None:
    """The exit code is 1, as for any question without an answer."""
    path = tmp_path / "scene.yaml"
    path.write_text(SLIDING)
    told = call(path, "--find", "velocity", "--when", "moved 26 m")
    assert told.exit_code == 1
    assert "no answer: it never happens: everything is at rest for good from 10.2041 s on" in told.stderr


def test_without_a_worked_solution_there_is_an_answer(tmp_path: Path) -> None:
    """A number of the scene that a given result determines has an answer, but no worked solution."""
    path = tmp_path / "scene.yaml"
    path.write_text(SLIDING)
    told = call(path, "--find", "floor.speed", "--when", "stopped", "--given", "displacement = 100 m", "--json")
    assert told.exit_code == 0
    assert json.loads(told.stdout)["from_motion"] == pytest.approx(98.0**0.5)


def test_a_part_that_means_nothing_is_one_line(tmp_path: Path) -> None:
    """The error names the part and the nearest names."""
    path = tmp_path / "scene.yaml"
    path.write_text(SLIDING)
    told = call(path, "--find", "velocty")
    assert told.exit_code == 2
    assert told.stderr == "sim2reason: find: there is no 'velocty'; did you mean: velocity\n"


@pytest.mark.parametrize("args", [(), ("--id", "pulley-easy-numeric-0-4", "scene.yaml")])
def test_it_wants_a_scene_or_an_id(args: tuple[str, ...]) -> None:
    told = call(*args)
    assert told.exit_code == 2
    assert "give a scene or an --id" in told.output


def test_a_question_in_ordinary_english_is_answered_and_told_back(scene: Path) -> None:
    """The output says how the command read the question."""
    told = call(scene, "--question", "How fast is the block moving after half a second?")
    assert told.exit_code == 0, told.output
    assert "Read as: How fast is the block moving at t = 0.50 s?" in told.output
    assert "From the motion: " in told.output


@pytest.mark.parametrize(
    ("option", "typed", "offered"),
    [("--of", "floor.bl", "floor.blocks.0"), ("--find", "velo", "velocity"), ("--when", "mov", "moved")],
)
def test_names_are_completed_from_the_scene(tmp_path: Path, option: str, typed: str, offered: str) -> None:
    """Click has not assigned the path of the scene while an option still lacks its value."""
    path = tmp_path / "floor.yaml"
    path.write_text(FLOOR)
    words = {"COMP_WORDS": f"sim2reason solve {path} {option} {typed}", "COMP_CWORD": "4"}
    told = CliRunner(env={"_SIM2REASON_COMPLETE": "bash_complete", **words}).invoke(main, [], prog_name="sim2reason")
    assert f"plain,{offered}" in told.stdout.split("\n")
