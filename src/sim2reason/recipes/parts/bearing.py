"""Which numbers of a drawn entity bear on what it does: found at once, before any motion is followed."""

from collections.abc import Callable, Iterator, Sequence
from typing import TypeVar

from pydantic import ValidationError

from sim2reason.dsl.addresses import changed
from sim2reason.dsl.model import Model, Parameter, parameters
from sim2reason.errors import SceneError

FACTORS, TURNS = (2.0, 0.5), (10.0, -10.0)  # a number is halved and doubled, an angle in degrees turned either way
LEAST = 0.12  # of a response: less may move a speed, which goes with a root, by less than its tolerance
V = TypeVar("V", bound=Model)


def idle(value: V, response: Callable[[V], Sequence[float]], least: float = LEAST) -> Iterator[str]:
    """The addresses of the numbers that move none of the responses of an entity by `least`, relative."""
    before = response(value)
    for number in parameters(value):
        if (
            number.value
            and not number.hidden
            and not any(
                abs(new - old) > least * abs(old)
                for other in _moved(value, number)
                for old, new in zip(before, response(other), strict=True)
            )
        ):
            yield number.path


def _moved(value: V, number: Parameter) -> Iterator[V]:
    """The same with a number halved and doubled, as far as it is valid then."""
    assert number.value is not None
    turned = number.measure.unit == "deg"
    for new in (number.value + turn for turn in TURNS) if turned else (number.value * factor for factor in FACTORS):
        try:
            yield changed(value, {number.path: new})
        except (ValidationError, SceneError):
            continue
