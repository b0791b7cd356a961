"""Tests that the example entity in CONTRIBUTING.md works as written."""

import re
import subprocess
import sys
from pathlib import Path

PAGE = Path(__file__).parents[1] / "CONTRIBUTING.md"
LONGEST = 60  # lines, as the page promises

TRY = """

from math import cos, radians, sin

import sim2reason
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.simulation.certify import RECORDED

for friction, mass in ((0.0, 0.0), (0.2, 0.6)):
    parts = dict(plane=Plane(angle=30.0, friction=friction), block=Block(mass=2.0), load=Block(mass=3.0))
    made = BlockOverEdge(**parts, pulley=FixedPulley(mass=mass))
    scene = Scene(entities=(Named(name="edge", entity=made),))
    trace, certificate = sim2reason.certify(scene, duration=0.5)
    assert certificate.stable_until == 0.5, certificate.reason
    assert sim2reason.load(sim2reason.dump(scene)) == scene
    for seed in range(6):
        assert sim2reason.parse_scene(sim2reason.describe(scene, seed).text).scene.entities[0].entity.load.mass == 3.0
    slope = radians(30.0)
    drive = 3.0 - 2.0 * (sin(slope) + friction * cos(slope))
    expected = 9.8 * drive / (2.0 + 3.0 + mass / 2.0)  # Newton for both blocks, M/2 for the turning disc
    at = [c.name for c in trace.mechanism.coordinates].index("edge.block.slide")
    assert abs(trace.state.a[0, at] / expected - 1.0) < 1e-9, (trace.state.a, expected)
print("fine")
"""


def example() -> str:
    """Return the Python block of the page."""
    found = re.search(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    assert found is not None
    return found[1]


def test_it_keeps_its_promise_of_length() -> None:
    """The heading promises about 60 lines."""
    assert len(example().splitlines()) <= LONGEST


def test_it_can_be_told_read_simulated_and_saved(tmp_path: Path) -> None:
    """a = g(m₂ − m₁(sin θ + µ cos θ))/(m₁ + m₂ + M/2).

    The example runs in a separate process, since it adds an entity to the registry.
    """
    script = tmp_path / "block_over_edge.py"
    script.write_text(example() + TRY, encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "-W", "error", str(script)], capture_output=True, text=True, timeout=120, check=False
    )
    assert done.stdout.strip() == "fine", done.stderr


def test_the_way_of_an_item_leads_past_files_that_exist() -> None:
    """Every path in the table of steps exists in this package."""
    table = PAGE.read_text(encoding="utf-8").split("## The way of an item")[1].split("\n## ")[0]
    paths = re.findall(r"`([a-z0-9_/]+(?:\.py|/))`", table)
    assert len(paths) > 12
    for path in paths:
        assert (PAGE.parent / "src" / "sim2reason" / path).exists(), path
