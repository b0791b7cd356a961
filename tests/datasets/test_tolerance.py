"""Tests of the answer's tolerance: filters and grader use the requested one."""

from collections import Counter
from pathlib import Path

import numpy as np
import pytest

import sim2reason
from sim2reason.cli import options
from sim2reason.errors import DatasetError, DrawError
from sim2reason.generation.filters import Candidate, Verdict
from sim2reason.generation.item_search import sample
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.generation.request import Request
from sim2reason.questions import MODES
from sim2reason.questions.accuracy import MIN_TOLERANCE, TOLERANCE

STRICT = 0.01


def test_an_item_carries_what_was_ordered_and_is_graded_by_it() -> None:
    """The answer to three digits is within any allowed tolerance; an error of 1.2 % is not within 1 %."""
    usual, strict = (sim2reason.item(seed=3, index=1, tolerance=size) for size in (TOLERANCE, STRICT))
    assert (usual.answer.tolerance, strict.answer.tolerance) == (TOLERANCE, STRICT)
    for item, paid in ((usual, 1.0), (strict, 0.0)):
        assert sim2reason.grade(item, rf"\boxed{{{item.answer.value:.3g}}}").reward == 1.0
        assert sim2reason.grade(item, rf"\boxed{{{1.012 * item.answer.value:.6g}}}").reward == paid


def test_filters_judge_by_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every candidate has the requested tolerance."""
    seen: list[float] = []

    def heard(candidate: Candidate, *, witnessed: bool) -> Verdict:
        del witnessed
        seen.append(candidate.tolerance)
        return Verdict(keep=False, filter="degenerate")

    search = QuestionSearch(sample("pulley", seed=2), 0, tolerance=STRICT)
    monkeypatch.setattr(search, "_sift", heard)
    search.ask(MODES["numeric"], np.random.default_rng(0), Counter())
    assert set(seen) == {STRICT}


def test_its_id_is_its_own() -> None:
    """The request of an item is recovered from the item; its id alone does not contain the tolerance."""
    strict = sim2reason.item(seed=3, index=1, tolerance=STRICT)
    assert Request.of(strict) == Request("pulley", "medium", "numeric", 3, 1, tolerance=STRICT)
    assert Request("pulley", "medium", "numeric", 3, 1).id == "pulley-medium-numeric-3-1"
    with pytest.raises(DrawError, match="tolerance or needs do not stand in its id"):
        Request.named(strict.id)
    assert sim2reason.sample(seed=3, index=1, tolerance=STRICT).name


def test_a_dataset_keeps_it(tmp_path: Path) -> None:
    """The tolerance is in each item, in the manifest, and in the command on the card."""
    data = sim2reason.generate(tmp_path / "out", items=3, recipe="pulley", tolerance=0.02, workers=1)
    assert {item.answer.tolerance for item in data.items()} == {0.02}
    assert data.manifest.config.tolerance == 0.02
    assert "--tolerance 0.02" in (tmp_path / "out" / "README.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("size", [0.0, MIN_TOLERANCE / 2.0, 2.0 * TOLERANCE, float("nan")])
def test_what_is_none_is_refused(size: float, tmp_path: Path) -> None:
    """A tolerance above the paper's is not allowed; one too small for three digits would refuse right answers."""
    with pytest.raises(DrawError, match=r"^tolerance: .* from 0\.005 to 0\.05$"):
        sim2reason.item(tolerance=size)
    with pytest.raises(DatasetError, match=r"^tolerance: .* from 0\.005 to 0\.05$"):
        sim2reason.generate(tmp_path / "out", items=1, tolerance=size)


def test_the_command_line_has_the_same_ends() -> None:
    """The command line declares its own bounds, since --help must not import the library."""
    assert (options.STRICTEST, options.TOLERANCE) == (MIN_TOLERANCE, TOLERANCE)
