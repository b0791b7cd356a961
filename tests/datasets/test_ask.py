"""Questions about a scene that is given."""

from plain_scenes import swing
from sim2reason.datasets.ask import ask
from sim2reason.datasets.splits import problem


def test_variants_of_a_problem_only_fill_up() -> None:
    """Of a pendulum there are few problems: each comes before any of them has other numbers."""
    found = [problem(item) for item in ask(swing(), items=12, seed=2)]
    distinct = len(set(found))
    assert len(found) == 12
    assert 3 < distinct < len(found)
    assert len(set(found[:distinct])) == distinct
