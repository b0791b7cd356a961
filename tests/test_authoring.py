"""Tests of the public module for authors of entities."""

import pytest

from sim2reason import authoring
from sim2reason.scenes.bodies import BODIES


@pytest.mark.parametrize("name", list(BODIES))
def test_every_body_is_a_public_name(name: str) -> None:
    assert getattr(authoring, name) is BODIES[name]
    assert name in dir(authoring)
    assert name not in authoring.__all__  # no body hides another public name


def test_a_name_that_does_not_exist_is_reported() -> None:
    with pytest.raises(AttributeError, match=r"no attribute 'Crate'; for bodies see: sim2reason list bodies"):
        getattr(authoring, "Crate")  # noqa: B009 - a type checker would refuse the attribute
    assert not hasattr(authoring, "_Block")
