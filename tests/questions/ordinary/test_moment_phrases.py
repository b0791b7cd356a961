"""Tests of moments such as *after a long time* and *2 s after the collision*, converted to numbers."""

from pathlib import Path

import pytest

from sim2reason.errors import TextError
from sim2reason.questions.following import simulate_scene
from sim2reason.questions.ordinary.moment_phrases import LONG, in_numbers
from sim2reason.questions.posing import pose_question
from sim2reason.questions.prompt import words_of
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.scenes.files import load
from sim2reason.text.prose.description import describe

SCENES = Path(__file__).parents[2] / "data" / "ordinary_scenes"


def answer(scene: str, asked: StructuredQuestion) -> float | None:
    """Return the answer to a question about a stored scene."""
    read = load(SCENES / f"{scene}.yaml")
    motion, words = simulate_scene(read), words_of(describe(read))
    return pose_question(in_numbers(asked, motion, words), motion, words).simulate_answer(motion).answer


def test_a_medium_stops_a_body_after_a_long_time() -> None:
    """The bead travels m v/b in all."""
    found = answer("braked_bead", StructuredQuestion("distance travelled", "the bead", LONG))
    assert found == pytest.approx(2.2 * 3.7 / 0.75, rel=1e-6)


def test_a_time_counts_from_a_collision() -> None:
    """A puck keeps its speed after the collision."""
    late = answer("bounced_pucks", StructuredQuestion("speed", "puck A", "2.0 s after collided"))
    assert late == pytest.approx(answer("bounced_pucks", StructuredQuestion("speed", "puck A", "collided")))


@pytest.mark.parametrize(
    ("scene", "asked"),
    [
        ("tight_orbit", StructuredQuestion("speed", "the planet", LONG)),
        ("braked_bead", StructuredQuestion("time", "", LONG)),
        ("light_pull_up", StructuredQuestion("speed", "block A", LONG)),
    ],
)
def test_what_never_settles_down_is_refused(scene: str, asked: StructuredQuestion) -> None:
    """A motion without a resisting medium does not settle, and no time is found *after a long time*."""
    with pytest.raises(TextError, match="nothing settles down"):
        answer(scene, asked)
