"""Parts and entities: mechanisms of bodies with sentences that describe them and ports that join them."""

from collections.abc import Mapping
from functools import cache
from typing import Annotated, Any, ClassVar, Self, TypeVar, cast

from pydantic import ConfigDict, Field, SerializeAsAny, model_validator

from sim2reason.base.records import cached_property
from sim2reason.base.registry import Registry
from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.builder import Builder, Frame
from sim2reason.scenes.dsl.connection import InternalConnection
from sim2reason.scenes.dsl.model import Model, field_types
from sim2reason.scenes.dsl.ports import Attachment, Base, Chain, Mount, Pass, Port, SitePort, Stop, StringEnd
from sim2reason.scenes.dsl.template import Each, PartLines, Saying, Slot, Word, Wordings, paths, slots, variants
from sim2reason.scenes.dsl.units import SI, UnitSystem

PORT_TYPES = (Port, InternalConnection)


class Part(Model):
    """The base class of parts that several entities share: bodies with their own sentences and ports.

    The fields of a subclass declare its bodies and numbers. A class with a number that no line states cannot be
    defined: a TypeError names the number.

    Attributes:
        says: Lines that describe the part, as templates.
        words: Words that depend on the value of a field, by name.
        called: Name of the whole in sentences, as in *the electric field*; empty if no sentence mentions it.
        untold: Numbers that bodies may have but no line states.

    Examples:
        >>> from sim2reason.authoring import X, Z, Frame, Part, either
        >>> from sim2reason.scenes.bodies.blocks import Block
        >>> class Sliding(Part):
        ...     block: Block
        ...     says = (either("{block} lies on a smooth floor."),)
        ...     def build(self, room: Frame) -> None:
        ...         room.body("block", self.block.mass).rest(X, Z)
        >>> Sliding(block=Block(mass=2.0))
        Sliding(block=Block(mass=2.0))
    """

    model_config = ConfigDict(ignored_types=PORT_TYPES)
    says: ClassVar[tuple[Saying, ...]] = ()
    words: ClassVar[dict[str, Word]] = {}
    called: ClassVar[str] = (
        ""  # what a sentence about all of it calls it, *the electric field*; empty if none speaks of it
    )
    untold: ClassVar[frozenset[str]] = frozenset()  # numbers that bodies may have and that no line states

    @classmethod
    def __pydantic_init_subclass__(cls, **_: Any) -> None:
        """Check that the lines state every number and name no unknown one; TypeError otherwise."""
        if any(name == "says" or isinstance(member, PORT_TYPES) for name, member in vars(cls).items()):
            cls.untold = check_lines(cls)

    @model_validator(mode="after")
    def _tells_all(self) -> Self:
        for path in self.untold:
            name, _, field = path.rpartition(".")
            value = getattr(self, name) if name else self
            for member in value if isinstance(value, tuple) else (value,):  # type: ignore[reportUnknownVariableType]
                if getattr(member, field, None) is not None:  # type: ignore[reportUnknownArgumentType]
                    raise ValueError(f"{path}: no line of {type(self).__name__} tells it; leave it out")
        return self

    @classmethod
    def is_stated_by_word(cls, parameter: str, value: object) -> bool:
        """Return whether a special word in the lines, such as *smooth* for 0, already states a value of a parameter."""
        words = {name: word for name, word in cls.words.items() if word.parameter == parameter}
        lines = [line for saying in cls.says if not isinstance(saying, PartLines) for line in variants(saying)]
        used = {name for name in words for line in lines if all(f"{{{name}}}" in template for template in line)}
        return any(value in words[name].special for name in used)

    def build(self, room: Frame) -> None:
        """Add the bodies of the part and their possible motions to a mechanism, by the methods of `room`.

        Args:
            room: Frame of the room, or of the body that carries the part.
        """
        raise NotImplementedError


class Entity(Part):
    """The base class of entities: mechanisms that a scene file can name.

    The fields of a subclass declare its bodies and numbers, `says` the lines of its text, ports the places where
    connections join, and `build` its mechanics. Register the class with `entity`, so that files and texts find it.

    Attributes:
        units: System of units of the text; by default the SI.
        schematic: Whether a drawing may choose the lengths of strings and faces; by default it is to scale.
        clocked: Whether the text says what happens at t = 0, so that a start from rest is no release.
        tells_taut: Whether the lines say that strings are taut at the start.
        slackens: Whether a string within the entity may go slack and become taut again.

    Examples:
        >>> import sim2reason
        >>> from sim2reason.authoring import X, Z, Entity, Frame, either
        >>> from sim2reason.scenes.bodies.blocks import Block
        >>> class BlockOnFloor(Entity):
        ...     block: Block
        ...     says = (either("{block} lies on a smooth floor."),)
        ...     def build(self, room: Frame) -> None:
        ...         room.body("block", self.block.mass).rest(X, Z, speed=3.0)
        >>> scene = sim2reason.Scene(entities=({"name": "floor", "entity": BlockOnFloor(block=Block(mass=2.0))},))
        >>> float(sim2reason.simulate(scene, duration=2.0).state.q[-1, 0])
        6.0
    """

    units: ClassVar[UnitSystem] = SI  # system of units of the text
    schematic: ClassVar[bool] = False  # drawn with convenient lengths of strings and faces instead of to scale

    def horizon(self, gravity: float) -> float | None:
        """Return the duration for which to follow the motion, such as a period; None for the default.

        Args:
            gravity: Acceleration due to gravity of the scene, m/s².

        Returns:
            The duration in the units of the text, or None.
        """
        del gravity
        return None

    @property
    def clocked(self) -> bool:
        """Return whether the text states the motion at t = 0, so that a start from rest is no release."""
        return False

    @property
    def tells_taut(self) -> bool:
        """Return whether the lines say that strings are taut at the start."""
        return False

    @property
    def slackens(self) -> bool:
        """Return whether a string within the entity may go slack and become taut again."""
        return False


NAME = r"^[a-z][a-z0-9_]{0,39}$"
Name = Annotated[str, Field(pattern=NAME)]


class Named(Model):
    """An entity and its name in a scene."""

    name: Name
    entity: SerializeAsAny[Entity]

    @cached_property
    def alone(self) -> Builder:
        """Return a builder with this entity alone, computed once and shared by scenes that differ in other entities."""
        builder = Builder()
        self.entity.build(builder.room(self.name))
        return builder


E = TypeVar("E", bound=Entity)
ENTITIES: Registry[type[Entity]] = Registry("entities", package="sim2reason.scenes.entities")


def entity(cls: type[E]) -> type[E]:
    """Register an entity class under its name.

    Args:
        cls: The class.

    Returns:
        The same class.

    Raises:
        ValueError: Another class has the name.

    Examples:
        >>> import sim2reason
        >>> from sim2reason.authoring import X, Z, Entity, Frame, either, entity
        >>> from sim2reason.scenes.bodies.blocks import Block
        >>> @entity
        ... class BlockOnFloor(Entity):
        ...     block: Block
        ...     says = (either("{block} lies on a smooth floor."),)
        ...     def build(self, room: Frame) -> None:
        ...         room.body("block", self.block.mass).rest(X, Z)
        >>> "BlockOnFloor" in [member.name for member in sim2reason.list("entities")["entities"]]
        True
    """
    return ENTITIES.add(cls.__name__, cls)


@cache
def declared_ports(cls: type[Part]) -> Mapping[str, Port]:
    """Return the ports that a class declares, by name, in the order of declaration."""
    members = {name: member for base in reversed(cls.__mro__) for name, member in vars(base).items()}
    return {name: member for name, member in members.items() if isinstance(member, Port)}


@cache
def internal_connections(cls: type[Part]) -> Mapping[str, InternalConnection]:
    """Return the connections inside an entity, by name."""
    return {name: member for name, member in vars(cls).items() if isinstance(member, InternalConnection)}


@cache
def outer_ports(cls: type[Part]) -> Mapping[str, Port]:
    """Return the ports open to connections: those not used inside the entity or by a chain."""
    declared = declared_ports(cls)
    used = {stop for inner in internal_connections(cls).values() for stop in inner.stops}
    used |= {stop for port in declared.values() if isinstance(port, Chain) for stop in port.stops}
    return {name: port for name, port in declared.items() if name not in used}


def port_stops(part: Part, name: str, address: str, *, flipped: bool = False) -> list[Stop]:
    """Return the stops of the port `name` of a part: one, or several from the inside out for a chain of ports."""
    head, _, rest = name.partition(".")
    if rest:
        return port_stops(getattr(part, head), rest, f"{address}.{head}", flipped=flipped)
    port = declared_ports(type(part))[name]
    if isinstance(port, Chain):
        return [stop for inner in port.stops for stop in port_stops(part, inner, address)]
    assert isinstance(port, SitePort)
    return [Stop(address, port, flipped)]


def check_lines(cls: type[Part]) -> frozenset[str]:
    """Check that the lines state all numbers; return the names of those that may remain unstated, as bodies lack them.

    Raise TypeError if the lines of the class do not state all other declared numbers.
    """
    required = {name for name, port in declared_ports(cls).items() if port.required}
    chained = {inner for name in required for inner in getattr(declared_ports(cls)[name], "stops", ())}
    roped = {stop for inner in internal_connections(cls).values() for stop in inner.stops}
    stated: set[str] = set()
    for saying in cls.says:
        if isinstance(saying, Each | PartLines) and saying.field not in cls.model_fields:
            raise TypeError(f"{cls.__name__}: a line for each {saying.field!r}, which is not declared")
        stated |= _stated_by_line(cls, saying)
    for name, port in declared_ports(cls).items():
        clause_numbers = _clauses(cls, port)
        if name in required | chained | roped:
            stated |= clause_numbers
    unsaid = {path for path in declared_numbers(cls) if path not in stated}
    spared = frozenset(path for path in unsaid if _is_spared(cls, path))
    unsaid -= spared
    if unsaid:
        raise TypeError(f"{cls.__name__}: no line tells {', '.join(sorted(unsaid))}")
    return spared


def _is_spared(cls: type[Part], path: str) -> bool:
    """Return whether a number may remain unstated because its body usually does without it."""
    name, _, field = path.partition(".")
    models = field_types(cls)[name].models if field else ()
    return any(field in field_types(model) and field_types(model)[field].usual is False for model in models)


def _stated_by_line(cls: type[Part], saying: Saying) -> set[str]:
    """Return the numbers that a line states; TypeError if its wordings with the given optional number state fewer."""
    *without, stated = (_common(cls, templates) for templates in variants(saying))
    if isinstance(saying, Wordings) and saying.given and saying.given not in stated:
        raise TypeError(f"{cls.__name__}: a line is said so where {saying.given} is given, and does not tell it")
    for numbers in without:
        lost = (numbers - stated) & declared_numbers(cls)
        if lost:
            raise TypeError(f"{cls.__name__}: no line tells {', '.join(sorted(lost))} where another number is given")
    return stated


def field_parts(part: Part, field: str) -> dict[str, Part]:
    """Return the parts in a field, one or several, by path from the part that contains them."""
    value: Any = getattr(part, field)
    several = isinstance(value, tuple)
    members = cast("tuple[Any, ...]", value) if several else (value,)
    members_by_path = {f"{field}.{index}" if several else field: member for index, member in enumerate(members)}
    return {path: member for path, member in members_by_path.items() if isinstance(member, Part)}


def _clauses(cls: type[Part], port: Port) -> set[str]:
    """Return the numbers that every clause of a port states."""
    if isinstance(port, Pass):
        return _common(cls, (port.passes,))
    if isinstance(port, StringEnd):
        return _common(cls, (port.arrives, *((port.tied + port.leaves,) if port.can_begin else ())))
    phrase = port_phrase(port)
    return _common(cls, (phrase,)) if phrase else set()


def port_phrase(port: Port) -> str:
    """Return the phrase of a port for a connection that ends at the port; empty if the port has no phrase."""
    if isinstance(port, Attachment):
        return port.tied
    return port.place if isinstance(port, Mount) else port.held if isinstance(port, Base) else ""


def _common(cls: type[Part], templates: tuple[str, ...]) -> set[str]:
    number_sets = [set[str]().union(*(stated_numbers(cls, slot) for slot in slots(template))) for template in templates]
    return set[str].intersection(*number_sets) if number_sets else set()


def declared_numbers(cls: type[Part]) -> set[str]:
    """Return the numbers that the lines of a class itself must state, without those of its parts."""
    numbers: set[str] = set()
    for name, kind in field_types(cls).items():
        if (kind.measure is not None or kind.words) and not kind.hidden:
            numbers.add(name)
        for model in kind.models:
            if issubclass(model, Part):
                continue
            inner = field_types(model).items()
            numbers |= {
                f"{name}.{field}"
                for field, field_kind in inner
                if field_kind.measure is not None and not field_kind.hidden
            }
    return numbers


def stated_numbers(cls: type[Part], slot: Slot) -> set[str]:
    """Return the declared numbers that a placeholder (slot) of a template states; TypeError for an invalid path."""
    if slot.kind in ("text", "agree", "some", "count", "plural"):
        if slot.path and slot.path.split(".")[0] not in cls.model_fields:
            raise TypeError(f"{cls.__name__}: {slot.path!r} is not declared")
        return set()
    if slot.kind == "member":
        return {".".join(step for step in slot.path.split(".") if step != "*")}
    head, *rest = [step for step in slot.path.split(".") if step not in ("first", "last", "*")]
    if head in cls.words and not rest:
        return {cls.words[head].parameter} | _word_paths(cls.words[head]) | _common(cls, _texts(cls.words[head]))
    kind = field_types(cls).get(head)
    if kind is None:
        raise TypeError(f"{cls.__name__}: a line names {slot.path!r}, which is not declared")
    if (kind.measure is not None or kind.words) and not rest:
        return {head}
    numbers: set[str] = set()
    for model in kind.models:
        numbers |= _told_by_body(cls, head, model, rest, whole="first" not in slot.path and "last" not in slot.path)
    return numbers


def _texts(word: Word) -> tuple[str, ...]:
    """Return the texts of a word for its special values, and the one for all other values."""
    return (*word.special.values(), *((word.otherwise,) if word.otherwise else ()))


def _word_paths(word: Word) -> set[str]:
    return {path for text in _texts(word) for path in paths(text)}


def _told_by_body(cls: type[Part], head: str, model: type[Model], rest: list[str], *, whole: bool) -> set[str]:
    if issubclass(model, Body) and not rest:
        return {f"{head}.{name}" for name in model.stated_parameters(model.lone[0])} if whole and model.lone else set()
    if issubclass(model, Part):
        return set()
    if rest[0] in field_types(model):
        return {f"{head}.{rest[0]}"}
    if issubclass(model, Body) and rest[0] in model.words:
        return {f"{head}.{name}" for name in model.stated_parameters(f"{{{rest[0]}}}")}
    raise TypeError(f"{cls.__name__}: a line names {head}.{rest[0]}, which {model.__name__} does not have")
