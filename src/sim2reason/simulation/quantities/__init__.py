"""What can be recorded, asked and plotted of a motion, each a function of the state alone."""

from abc import ABC, abstractmethod
from collections.abc import Callable
from functools import wraps
from string import Formatter
from typing import ClassVar, TypeVar

from sim2reason.base.registry import Registry
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.units import parse_unit
from sim2reason.simulation.quantities.subjects import Sense, Subject


class Quantity(ABC):
    """A quantity of every subject of one kind. All that the library knows of it stands on its class.

    What it is:
        name, unit, symbol: the unit is canonical SI, the symbol one letter.
        of: the kind of subject that it belongs to.
        vector: whether it has three components, in room coordinates.
        along: whether it is a number whose sign refers to a direction of its subject, as an extension's to *stretched*.

    How it is phrased; a quantity without words is recorded, but never asked. Templates name the subject by its
    slot, ``{body}``, and may use what it fills besides, such as ``{ground}``:
        magnitude: the noun phrase of its size.
        signed: that with a sign; of a vector it is a component, named by ``{component}``.
        how: a question of its own, with ``{when}``: *how fast is … 2 s after release?* It asks for the size, or for
            what has a sign where there is no phrase for the size; with `over` it is asked over a stretch alone.
        over: the noun phrase of its size over a stretch, where that reads better than *since the start* at a moment.
        indirect: the same as a clause: *how fast … is moving*.
        states: a statement that its size is ``{value}``: *… is moving at 2 m/s*.
        sense: what is positive, where that is not a matter of the subject's directions, as in an increase.
        center: whether it belongs to one point of its subject, the centre of mass of what has a size.

    When it is asked:
        weight: how often, compared with other quantities.
        drawn_by_recipes: whether recipes ask for it; if not, only people do.
        needs: what its subject must have and the text must say, such as ``mass``.
        given: whether the text gives it at the start.
        immediate: whether it can differ from zero at once, and hangs on more than what the text gives.
        timeless: whether it never changes, so that no question names a moment.
        from_start: whether it is measured from where the motion starts.

    How small is nothing:
        floor: the certificate's smallest scale, in SI units; with `heavy` it is that times the largest mass in kg.
        least: the smallest answer, in SI units.

    Where it is plotted:
        panel: the panel, which quantities of one unit may share; empty for none.
        pooled: whether the panel shows the sum over all of the text, not one curve for each.
        order: its place in panels and among what is asked of a subject.
    """

    name: ClassVar[str]
    unit: ClassVar[str]
    symbol: ClassVar[str]
    of: ClassVar[Subject]
    vector: ClassVar[bool] = False
    along: ClassVar[bool] = False
    magnitude: ClassVar[str] = ""
    over: ClassVar[str] = ""
    signed: ClassVar[str] = ""
    how: ClassVar[str] = ""
    indirect: ClassVar[str] = ""
    states: ClassVar[str] = ""
    sense: ClassVar[Sense | None] = None
    center: ClassVar[bool] = False
    weight: ClassVar[float] = 1.0
    drawn_by_recipes: ClassVar[bool] = True
    needs: ClassVar[tuple[str, ...]] = ()
    given: ClassVar[bool] = False
    immediate: ClassVar[bool] = False
    timeless: ClassVar[bool] = False
    from_start: ClassVar[bool] = False
    floor: ClassVar[float]
    heavy: ClassVar[bool] = False
    least: ClassVar[float] = 1e-3
    panel: ClassVar[str] = ""
    pooled: ClassVar[bool] = False
    order: ClassVar[int] = 100

    def __init_subclass__(cls) -> None:
        """Refuse a declaration that lacks a fact, or whose words do not fit; TypeError says what is amiss."""
        if cls.evaluate is Quantity.evaluate:
            return  # what several share
        missing = [fact for fact in ("name", "unit", "symbol", "of", "floor") if not hasattr(cls, fact)]
        if missing:
            raise TypeError(f"{cls.__name__}: it declares no {', '.join(missing)}")
        parse_unit(cls.unit)  # UnitError for a unit outside the table
        if not (cls.weight > 0.0 and cls.floor > 0.0):
            raise TypeError(f"{cls.__name__}: its weight {cls.weight} and its floor {cls.floor} must be positive")
        cls._check("magnitude", set())
        cls._check("signed", {"component"} if cls.vector else set())
        cls._check("how", {"when"})
        cls._check("indirect", set())
        cls._check("states", {"value"})
        if "evaluate" in vars(cls):
            cls.evaluate = staticmethod(_remembered(cls.name, cls.evaluate))  # type: ignore[method-assign]

    @classmethod
    def _check(cls, fact: str, beside: set[str]) -> None:
        """The placeholders of a template are the subject's and those `beside` it, all of them, and maybe its extras."""
        template: str = getattr(cls, fact)
        used = {name for _, name, _, _ in Formatter().parse(template) if name is not None}
        wanted = {cls.of.slot, *beside}
        if template and used - cls.of.extras != wanted:
            raise TypeError(f"{cls.__name__}: {fact} names {sorted(used)}; it must name {sorted(wanted)}: {template!r}")

    @staticmethod
    @abstractmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return its values at n instants: (n,), or (n, 3) of a vector, in room coordinates."""

    def subjects(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names that `evaluate` takes, in the order of the mechanism: those of its kind that fit."""
        return tuple(name for name in self.of.names(mechanism) if self.fits(mechanism, name))

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether a subject of its kind has the quantity; by default True."""
        del mechanism, name
        return True

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether it is worth asking of one subject, as friction is on a rough face; so by default."""
        del mechanism, name
        return True

    def size_phrases(self, mechanism: Mechanism, name: str) -> tuple[str, str, str, str]:
        """Return the templates for the size: by default `magnitude`, `how`, `indirect` and `states`."""
        del mechanism, name
        return self.magnitude, self.how, self.indirect, self.states

    def signed_along(self, sense: Sense, mechanism: Mechanism, name: str) -> str:
        """Return the template for the component along a sense; by default `signed`, whatever the sense."""
        del sense, mechanism, name
        return self.signed

    def share(self, sense: Sense | None, mechanism: Mechanism, name: str) -> float:
        """Return how often its component along a sense, or its size, is asked for, compared with one another."""
        del mechanism, name
        return sense.share if sense is not None else 1.0

    @property
    def summary(self) -> str:
        """Its facts in one line."""
        return f"unit {self.unit}, symbol {self.symbol}, of {self.of.name}"


def _remembered(name: str, evaluate: Callable[[State, str], Array]) -> Callable[[State, str], Array]:
    """Return the same, worked out once for each state: many quantities are read off a few others."""

    @wraps(evaluate)
    def read(state: State, subject: str) -> Array:
        found = state.known.get((name, subject))
        if found is None:
            found = state.known[name, subject] = evaluate(state, subject)
        return found

    return read


Q = TypeVar("Q", bound=Quantity)
QUANTITIES: Registry[Quantity] = Registry("quantities", package="sim2reason.simulation.quantities")


def quantity(cls: type[Q]) -> type[Q]:
    """Enter a quantity under its name."""
    QUANTITIES.add(cls.name, cls())
    return cls


def ordered() -> list[Quantity]:
    """Return all quantities by kind of subject, each kind's by their order."""
    return sorted(QUANTITIES.values(), key=lambda found: (found.of.name, found.order))
