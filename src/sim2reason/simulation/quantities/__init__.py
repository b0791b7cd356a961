"""Physical quantities that can be recorded, asked about and plotted, each a function of the state alone."""

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
    """A physical quantity of every subject of one kind, declared by class attributes.

    Identity:
        name, unit, symbol: the unit is canonical SI, the symbol one letter.
        of: the kind of subject to which the quantity belongs.
        vector: whether it has three components, in the axes of the world frame.
        along: whether its sign refers to a direction of its subject, as that of an extension to *stretched*.

    Phrases; a quantity without phrases is recorded, but never asked about. Templates name the subject by its
    slot, ``{body}``, and may use the extra placeholders of its kind, such as ``{ground}``:
        magnitude: the noun phrase of its size.
        signed: the noun phrase of its signed value; of a vector, that of a component, named by ``{component}``.
        how: a complete question with ``{when}``: *how fast is … 2 s after release?* It asks for the size, or for
            the signed value if there is no phrase for the size; with `over` it is used for intervals only.
        over: the noun phrase of its size over an interval, if that reads better than *since the start* at a moment.
        indirect: the same question as a clause: *how fast … is moving*.
        states: a statement that its size is ``{value}``: *… is moving at 2 m/s*.
        sense: the positive sense, if it does not depend on directions of the subject, as for an increase.
        center: whether it belongs to one point of its subject, the centre of mass of an extended body.

    Selection:
        weight: relative frequency among the quantities.
        drawn_by_recipes: whether recipes ask for it; if not, only users do.
        needs: properties that its subject must have and the text must state, such as ``mass``.
        given: whether the text gives its initial value.
        immediate: whether it can be nonzero at the start, and depends on more than the given numbers.
        timeless: whether it never changes, so that no question names a moment.
        from_start: whether it is measured from the initial position.

    Thresholds:
        floor: the certificate's smallest scale, in SI units; with `heavy` it is multiplied by the largest mass in kg.
        least: the smallest answer, in SI units.

    Plots:
        panel: the panel, which quantities of one unit may share; empty for none.
        pooled: whether the panel shows the sum over all subjects in the text instead of a curve for each.
        order: its rank in panels and among the quantities of a subject.
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
        """Validate the declaration of a subclass; raise TypeError if an attribute is missing or a template is wrong."""
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
            cls.evaluate = staticmethod(_cached_by_state(cls.name, cls.evaluate))  # type: ignore[method-assign]

    @classmethod
    def _check(cls, fact: str, beside: set[str]) -> None:
        """Raise TypeError unless the template `fact` has the placeholders of the subject and of `beside` alone."""
        template: str = getattr(cls, fact)
        used = {name for _, name, _, _ in Formatter().parse(template) if name is not None}
        wanted = {cls.of.slot, *beside}
        if template and used - cls.of.extras != wanted:
            raise TypeError(f"{cls.__name__}: {fact} names {sorted(used)}; it must name {sorted(wanted)}: {template!r}")

    @staticmethod
    @abstractmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the values at n instants, (n,), or (n, 3) for a vector in the axes of the world frame."""

    def subjects(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of all subjects that have the quantity, in the order of the mechanism."""
        return tuple(name for name in self.of.names(mechanism) if self.fits(mechanism, name))

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the subject `name` has the quantity; by default True."""
        del mechanism, name
        return True

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether questions may ask for the quantity of a subject, such as friction only on a rough face.

        By default True.
        """
        del mechanism, name
        return True

    def size_phrases(self, mechanism: Mechanism, name: str) -> tuple[str, str, str, str]:
        """Return the templates for the size of the quantity: by default `magnitude`, `how`, `indirect` and `states`."""
        del mechanism, name
        return self.magnitude, self.how, self.indirect, self.states

    def signed_along(self, sense: Sense, mechanism: Mechanism, name: str) -> str:
        """Return the template for the component along a sense; by default `signed` for every sense."""
        del sense, mechanism, name
        return self.signed

    def share(self, sense: Sense | None, mechanism: Mechanism, name: str) -> float:
        """Return the relative frequency of questions for the component along `sense`, or for the size if None."""
        del mechanism, name
        return sense.share if sense is not None else 1.0

    @property
    def summary(self) -> str:
        """Return the unit, symbol and kind of subject in one line."""
        return f"unit {self.unit}, symbol {self.symbol}, of {self.of.name}"


def _cached_by_state(name: str, evaluate: Callable[[State, str], Array]) -> Callable[[State, str], Array]:
    """Return a cached `evaluate`, computed once for each state, since several quantities share others."""

    @wraps(evaluate)
    def read(state: State, subject: str) -> Array:
        values = state.known.get((name, subject))
        if values is None:
            values = state.known[name, subject] = evaluate(state, subject)
        return values

    return read


Q = TypeVar("Q", bound=Quantity)
QUANTITIES: Registry[Quantity] = Registry("quantities", package="sim2reason.simulation.quantities")


def quantity(cls: type[Q]) -> type[Q]:
    """Register a quantity under its name."""
    QUANTITIES.add(cls.name, cls())
    return cls


def ordered() -> list[Quantity]:
    """Return all quantities, sorted by kind of subject and by order."""
    return sorted(QUANTITIES.values(), key=lambda entry: (entry.of.name, entry.order))
