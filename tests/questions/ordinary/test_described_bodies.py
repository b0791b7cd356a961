"""Tests of described bodies: the hanging block, the heavier one, the upper board."""

import pytest

from sim2reason.questions.ordinary.names import with_letters
from sim2reason.questions.prompt import words_of
from sim2reason.scenes.files import loads
from sim2reason.text.prose.description import describe

TABLE = """
scene:
  entities:
  - {name: table, type: TwoSideMassPlane, parameters: {plane: {angle: 0, friction: 0.1}, blocks: [{mass: 2}]}}
  - {name: load, type: HangingMass, parameters: {system: {blocks: [{mass: 1}]}}}
  connections: [{tendon: [{entity: table, direction: right}, {entity: load, direction: end}]}]
"""
PAIR = """
scene:
  entities:
  - name: machine
    type: MassWithFixedPulley
    parameters: {system: {kind: hanging, blocks: [{mass: 2}]}, pulley: {mass: 0}}
  - {name: load, type: HangingMass, parameters: {system: {blocks: [{mass: 2}]}}}
  connections: [{tendon: [{entity: machine, direction: tail}, {entity: load, direction: end}]}]
"""
PILE = """
scene:
  entities:
  - name: pile
    type: StackedMassPlane
    parameters:
      plane: {angle: 0, friction: 0}
      lower: {mass: 3}
      upper: {mass: 2}
      top: {mass: 1}
      friction: 0.3
      top_friction: 0.3
      speed: 1
"""


@pytest.mark.parametrize(
    ("scene", "told", "meant"),
    [
        (TABLE, "the hanging block", "load.system.blocks.0"),
        (TABLE, "the block on the table", "table.blocks.0"),
        (TABLE, "the heavier block", "table.blocks.0"),
        (TABLE, "the lighter of the two blocks", "load.system.blocks.0"),
        (PILE, "the bottom board", "pile.lower"),
        (PILE, "the middle board", "pile.upper"),
        (PILE, "the top board", "pile.top"),
    ],
)
def test_a_description_that_fits_one_body_names_it(scene: str, told: str, meant: str) -> None:
    """The description may give the support, the mass, or the position in a pile."""
    words = words_of(describe(loads(scene)))
    assert with_letters(f"How fast is {told} after 1 s?", words) == f"How fast is {words.mentions[meant]} after 1 s?"


@pytest.mark.parametrize(
    ("scene", "told"),
    [
        (PAIR, "the hanging block"),
        (PAIR, "the heavier block"),
        (PAIR, "the upper block"),
        (TABLE, "the upper block"),
        (TABLE, "the middle block"),
        (TABLE, "the hanging block A"),
        (PILE, "the heavier board"),
        (PILE, "the hanging board"),
    ],
)
def test_one_that_fits_none_or_several_is_left(scene: str, told: str) -> None:
    """Equal masses, two hanging blocks, and the heavier ones of three are ambiguous."""
    words = words_of(describe(loads(scene)))
    assert with_letters(f"How fast is {told} after 1 s?", words) == f"How fast is {told} after 1 s?"
