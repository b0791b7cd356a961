"""Every registered entity, present and future, conforms."""

import pytest

from sim2reason.scenes.dsl.entity import ENTITIES
from sim2reason.testing import check_entity


@pytest.mark.parametrize("name", list(ENTITIES))
def test_it_conforms(name: str) -> None:
    check_entity(ENTITIES[name], seeds=range(4))


@pytest.mark.slow
@pytest.mark.parametrize("name", list(ENTITIES))
def test_it_conforms_on_many_scenes(name: str) -> None:
    check_entity(ENTITIES[name], seeds=range(4, 6), deep=True)
