"""Tests that later parts neither verify the same motion again nor introduce a symbol again."""

from plain_scenes import row
from sim2reason.questions import Query, Target
from sim2reason.questions.moments.turning_points import Halted
from sim2reason.solutions.multipart import unify_names
from sim2reason.solutions.multipart.quoting import quote_earlier_parts
from sim2reason.solutions.multipart.recall import recall_results
from worked import derived, solution_text


def test_a_time_refers_to_the_turning_points_of_an_earlier_part() -> None:
    """All half oscillations take π/ω: neither the turning points nor the introduction of x are repeated."""
    scene = row((1.8,), (132.0,), "right", friction=0.32, strain=0.2)
    trolley = next(body.name for body in scene.mechanism.bodies if body.mass)
    place = derived(scene, Query("event", Target("displacement", trolley), Halted(trolley)))
    time = derived(scene, Query("time_to_event", None, Halted(trolley)))
    first, second = unify_names([place, time])
    later = recall_results(second, [("a", first)], whole=True)
    _, told = quote_earlier_parts([first, later])
    assert "What was verified of this motion in part (a) holds here, too." in told.text
    assert "Let $x$ be the displacement" not in told.text
    assert "next comes to rest at" not in told.text
    assert "half oscillations take the same time" in told.text


def test_a_symbol_is_introduced_only_for_what_a_part_uses() -> None:
    """The acceleration a of slab B is introduced in part (a); part (c) only uses a_1 and introduces it itself."""
    text = solution_text("incline-hard-multipart-301921-3")
    last = text[text.index("(c) Given") :]
    assert "Let $a_1$ be the acceleration of slab A" in last
    assert "Let $a$ be" not in last
    assert "The number of a phase, as a subscript" not in text


def test_subscripts_that_count_phases_are_explained_without_a_phase_being_called_so_before() -> None:
    text = solution_text("rolling-medium-multipart-301926-1")
    assert "This goes on for a time $t_1$, until the tube stops sliding" in text
    assert "The number of a phase, as a subscript, marks accelerations and forces in that phase" in text
