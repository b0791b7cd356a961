"""All that can be read off a motion: a channel is one quantity of one subject."""

from collections.abc import Iterator
from typing import NamedTuple

from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.quantities import QUANTITIES, Quantity


class Channel(NamedTuple):
    """A quantity, by its registered name, of a body, string part or resting body."""

    subject: str
    quantity: str


def channels(mechanism: Mechanism) -> Iterator[tuple[Channel, Quantity]]:
    """Yield the channels of a mechanism, quantity by quantity in the order of their names."""
    for name, quantity in QUANTITIES.items():
        for subject in quantity.subjects(mechanism):
            yield Channel(subject, name), quantity
