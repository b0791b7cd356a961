"""Tests that the repr of each public value is one short line, and its text a few lines for people."""

from collections.abc import Mapping

import pytest

import sim2reason
from sim2reason.authoring import Frame
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.testing import conformance

LONGEST = 220  # characters of a repr
WIDEST = 100  # characters in a line of an item without a table or a formula
ITEM = {"recipe": "pulley", "difficulty": "easy"}
NAMES = [
    "Answer",
    "Certificate",
    "Dataset",
    "Description",
    "EvaluationResult",
    "Explanation",
    "Exported",
    "Findings",
    "Frame",
    "FreshRows",
    "Item",
    "ItemFiles",
    "Mechanism",
    "ParsedPrompt",
    "ParsedScene",
    "Report",
    "Scene",
    "Score",
    "Solution",
    "SolutionRecord",
    "SolvedProblem",
    "State",
    "Stats",
    "Trace",
]


def frame() -> Frame:
    return Builder().room("lab").body("block", mass=2.0, at=(0.0, 0.0, 1.0))


@pytest.fixture(scope="module")
def values(tmp_path_factory: pytest.TempPathFactory) -> Mapping[str, object]:
    """Return one value of each public class and of each class that a public function returns."""
    folder = tmp_path_factory.mktemp("reprs")
    item = sim2reason.item(**ITEM, solutions=True)
    scene = sim2reason.sample("collision", "easy")
    trace, certificate = sim2reason.certify(scene)
    description = sim2reason.describe(scene)
    config = {
        "out": str(folder / "run"),
        "policies": [{"kind": "constant", "name": "one", "text": r"\boxed{1}"}],
        "benchmarks": [{"kind": "synthetic", "name": "ours", "dataset": str(folder / "problems")}],
    }
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("sim2reason.datasets.build.put_pictures", lambda *_: ())
        dataset = sim2reason.generate(folder / "problems", items=2, workers=1, **ITEM)
    return {
        "Answer": item.answer,
        "Certificate": certificate,
        "Dataset": dataset,
        "Description": description,
        "EvaluationResult": sim2reason.eval(config),
        "Explanation": sim2reason.explain(dataset, dataset[0].id),
        "Exported": sim2reason.export(dataset.path, folder / "exported", to="hf"),
        "Findings": sim2reason.verify(dataset),
        "Frame": frame(),
        "FreshRows": sim2reason.iterable(**ITEM),
        "Item": item,
        "ItemFiles": dataset["train"],
        "Mechanism": scene.mechanism,
        "ParsedPrompt": sim2reason.parse_prompt(item.prompt),
        "ParsedScene": sim2reason.parse_scene(description.text),
        "Report": conformance(type(scene.entities[0].entity), seeds=[0], checks=["symbols"]),
        "Scene": scene,
        "Score": sim2reason.grade(item, r"\boxed{1}"),
        "Solution": sim2reason.solve(item).solution,
        "SolutionRecord": item.solution,
        "SolvedProblem": sim2reason.solve(item),
        "State": trace.state,
        "Stats": sim2reason.stats(dataset),
        "Trace": trace,
    }


@pytest.mark.parametrize("name", NAMES)
def test_a_repr_is_one_short_line_that_names_the_class(name: str, values: Mapping[str, object]) -> None:
    text = repr(values[name])
    assert set(NAMES) == values.keys()
    assert type(values[name]).__name__ == name
    assert name in text or name == "ItemFiles"
    assert "\n" not in text
    assert len(text) <= LONGEST
    assert str(values[name]).strip()


@pytest.mark.parametrize("mode", ["numeric", "choice"])
def test_an_item_prints_its_coordinates_prompt_and_answer(mode: str) -> None:
    item = sim2reason.item("pulley", "easy", mode)
    first, blank, *lines, last = str(item).splitlines()
    assert first == f"{item.id} (pulley, easy, {mode})"
    assert not blank
    assert " ".join(" ".join(lines).split()) == " ".join(item.prompt.split())
    assert last == f"Answer: {item.answer.shown}"
    assert max(map(len, lines)) <= WIDEST


def test_a_scene_prints_its_numbers_with_addresses_and_units() -> None:
    scene = sim2reason.sample("incline", "easy")
    for parameter in scene.parameters:
        if not parameter.hidden and parameter.value is not None:
            address = parameter.path.partition(".")[2]
            assert f"{address} = {parameter.measure.say(parameter.value)}" in str(scene)


def test_a_trace_prints_its_events_and_why_it_ends() -> None:
    trace = sim2reason.simulate(sim2reason.sample("collision", "easy"), engine="both")
    lines = str(trace).splitlines()
    assert lines[0] == repr(trace)[1:-1]
    assert all(any(event.kind in line for line in lines) for event in trace.events)


def test_a_dataset_prints_its_counts(values: Mapping[str, object]) -> None:
    assert str(values["Dataset"]).splitlines()[1:] == [
        "  split: train 2",
        "  recipe: pulley 2",
        "  difficulty: easy 2",
        "  mode: numeric 2",
    ]


def test_a_record_shows_what_differs_from_its_defaults(values: Mapping[str, object]) -> None:
    item = values["Item"]
    assert isinstance(item, sim2reason.Item)
    assert repr(item.answer) == f"Answer(value={item.answer.value!r}, unit='m/s^2')"
    assert len(repr(item.provenance)) <= LONGEST
