"""Tests that every registered entity passes the conformance kit."""

import pytest

from sim2reason.scenes.dsl.entity import ENTITIES
from sim2reason.testing import check_entity

COSTLY = ("questions", "masking")
"""Checks of one scene in the usual tests, questions about every third entity; others look at two scenes of each."""


@pytest.mark.parametrize("seeds", [range(2), pytest.param(range(4), marks=pytest.mark.slow)], ids=len)
@pytest.mark.parametrize("name", list(ENTITIES))
def test_it_conforms(name: str, seeds: range) -> None:
    check_entity(ENTITIES[name], seeds=seeds, skip=COSTLY)


@pytest.mark.parametrize("name", list(ENTITIES))
def test_nothing_in_its_text_can_be_left_out(name: str) -> None:
    check_entity(ENTITIES[name], seeds=range(1), checks=["masking"])


@pytest.mark.parametrize("name", list(ENTITIES)[::3])
def test_it_is_asked_about(name: str) -> None:
    """`test_registries` checks the texts of each entity."""
    check_entity(ENTITIES[name], seeds=range(1), checks=["questions"])


@pytest.mark.slow
@pytest.mark.parametrize("name", list(ENTITIES))
def test_what_is_costly_conforms(name: str) -> None:
    check_entity(ENTITIES[name], seeds=range(4), checks=COSTLY)


@pytest.mark.slow
@pytest.mark.parametrize("name", list(ENTITIES))
def test_it_conforms_on_many_scenes(name: str) -> None:
    check_entity(ENTITIES[name], seeds=range(4, 6), deep=True)
