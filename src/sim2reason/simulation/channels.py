"""Channels of a motion: each is one quantity of one subject."""

from collections.abc import Iterator
from typing import NamedTuple

from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.quantities import QUANTITIES, Quantity


class Channel(NamedTuple):
    """A quantity, by its registered name, of one subject, such as a body or a part of a string."""

    subject: str
    quantity: str


def channels(mechanism: Mechanism) -> Iterator[tuple[Channel, Quantity]]:
    """Yield each channel of a mechanism with its quantity, in the order of the registry of quantities."""
    for name, quantity in QUANTITIES.items():
        for subject in quantity.subjects(mechanism):
            yield Channel(subject, name), quantity
