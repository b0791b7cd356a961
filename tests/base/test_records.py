"""Tests of values that are computed when they are first read."""

from dataclasses import dataclass, field

import pytest

from sim2reason.base.records import cached_property
from sim2reason.scenes.dsl.model import Model


@dataclass(frozen=True)
class Square:
    side: float
    read: list[float] = field(default_factory=list[float])

    @cached_property
    def area(self) -> float:
        self.read.append(self.side)
        return self.side**2

    @cached_property
    def none(self) -> float:
        self.read.append(self.side)
        raise ValueError("it has none")


class Disc(Model):
    radius: float

    @cached_property
    def size(self) -> list[float]:
        return self._sizes

    @cached_property
    def _sizes(self) -> list[float]:
        return [2.0 * self.radius]


def test_it_is_worked_out_once_for_each() -> None:
    one, other = Square(2.0), Square(3.0)
    assert [one.area, one.area, other.area] == [4.0, 4.0, 9.0]
    assert (one.read, other.read) == ([2.0], [3.0])
    assert isinstance(Square.area, cached_property)


def test_what_fails_is_tried_again() -> None:
    one = Square(2.0)
    for _ in range(2):
        with pytest.raises(ValueError, match="none"):
            _ = one.none
    assert one.read == [2.0, 2.0]


def test_a_frozen_model_keeps_it_and_is_equal_without() -> None:
    disc = Disc(radius=1.0)
    assert disc.size is disc.size
    assert disc == Disc(radius=1.0)
    assert disc.model_dump() == {"radius": 1.0}
    assert not Disc.__private_attributes__  # pydantic takes neither for anything of its own
