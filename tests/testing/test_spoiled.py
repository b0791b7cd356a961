"""Tests that each check of the conformance kit finds the entity with that fault and describes it."""

import pytest

from plain_scenes import ramp
from sim2reason.scenes.dsl.entity import Entity
from sim2reason.scenes.files import dump, load
from sim2reason.testing import CHECKS, ConformanceError, Finding, check_entity, conformance, specimen
from sim2reason.testing.checks.texts import CLAIMS
from spoiled import (
    Airy,
    Alias,
    Bath,
    Brake,
    Constant,
    Couple,
    Crash,
    Curved,
    Indices,
    Lamp,
    Liar,
    Mood,
    Offset,
    Sled,
    Terse,
    Thin,
    Twin,
    Wind,
    registered,
)

SEEDS = range(3)

CAUGHT: dict[str, list[tuple[type[Entity], str]]] = {
    "ablations": [(Couple, "IndexError")],
    "agreement": [(Thin, "they do not on 3 of 3")],
    "claims": [(Airy, "denies the resistance of a medium")],
    "drawing": [(Bath, "no figure shows a body of the type Sponge")],
    "energy": [(Liar, "the work is")],
    "givens": [(Brake, "the friction under it.block")],
    "hidden numbers": [(Offset, "with it.offset = ")],
    "masking": [(Lamp, "the text is read as the same scene")],
    "mirror image": [(Mood, "in place of")],
    "momentum": [(Liar, "the impulse is")],
    "plots": [(Alias, "have no panel")],
    "questions": [(Alias, "there is only: none")],
    "ranges": [(Constant, "it is the same in"), (Lamp, "none of 3 scenes has one")],
    "round trip": [(Twin, "it tells two scenes")],
    "scaling": [(Wind, "in the old units")],
    "solutions": [(Curved, "is no simple function of the numbers in the text")],
    "symbols": [(Indices, "are both $F_1$")],
    "wordings": [(Terse, "2: 'on a smooth track")],
}


def found(cls: type[Entity], check: str) -> list[Finding]:
    others = (Sled,) if cls is Twin else ()
    with registered(cls, *others):
        return [finding for finding in conformance(cls, seeds=SEEDS, checks=[check]) if finding.check == check]


def test_every_check_has_an_entity_that_it_catches() -> None:
    assert set(CAUGHT) == set(CHECKS)


@pytest.mark.parametrize("check", list(CHECKS))
def test_what_has_no_fault_passes(check: str) -> None:
    assert not found(Sled, check)


@pytest.mark.parametrize(
    ("check", "cls", "says"), [(check, cls, says) for check, faults in CAUGHT.items() for cls, says in faults]
)
def test_a_fault_is_caught_and_told(check: str, cls: type[Entity], says: str) -> None:
    findings = found(cls, check)
    assert any(says in finding.text for finding in findings), findings
    for finding in findings:
        assert finding.expected
        assert finding.remedy
        assert finding.check == check


def test_what_can_not_be_drawn_is_a_finding_for_each_seed() -> None:
    with registered(Crash):
        report = conformance(Crash, seeds=SEEDS)
    assert [finding.seed for finding in report] == list(SEEDS)
    assert all("KeyError" in finding.found for finding in report)


def test_an_error_tells_all_findings_with_scenes() -> None:
    with registered(Wind), pytest.raises(ConformanceError) as caught:
        check_entity(Wind, seeds=SEEDS, checks=["scaling", "symbols"])
    text = str(caught.value)
    assert text.startswith("Wind: 9 findings, by 2 checks on 3 scenes")
    assert "type: Wind" in text
    assert "remedy: " in text
    assert isinstance(caught.value, AssertionError)


def test_an_entity_that_comes_later_is_known_to_files() -> None:
    """The entity is registered after the first file has been read."""
    load(dump(ramp()))
    with registered(Sled):
        scene = specimen(Sled, 0).scene
        assert load(dump(scene)) == scene


def test_checks_can_be_skipped() -> None:
    with registered(Wind):
        check_entity(Wind, seeds=range(1), checks=["scaling", "symbols"], skip=["scaling"])


@pytest.mark.parametrize(
    "sentence",
    [
        "There is no air drag.",
        "The drag of the air is negligible.",
        "Disregard air resistance.",
        "Air resistance plays no role.",
        "The ball falls in a vacuum.",
        "Air resistance may safely be neglected.",
    ],
)
def test_denials_of_the_air_are_known(sentence: str) -> None:
    (claim,) = (claim for claim in CLAIMS if claim.absent == "resistance of a medium")
    assert claim.pattern.search(sentence)
