from pathlib import Path

import pytest

from sim2reason.datasets.build import build
from sim2reason.datasets.plan import Config


@pytest.fixture(scope="session")
def problems(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build more than a hundred problems with every kind of answer, in three shards and two splits."""
    out = tmp_path_factory.mktemp("exports") / "problems"
    config = Config(
        items=120,
        recipes=("pulley", "springs"),
        difficulties=("easy",),
        split={"train": 0.7, "test": 0.3},
        shard=50,
        maker="fake_makers:with_answers",
    )
    build(out, config, workers=1)
    return out
