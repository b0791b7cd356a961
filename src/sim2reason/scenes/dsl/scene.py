"""Scenes: entities, connections and a world, as one immutable value."""

from collections.abc import Mapping
from typing import Any, Self, cast

from pydantic import SerializeAsAny, model_validator

from sim2reason.base.records import abridge, cached_property, format_count
from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.addresses import changes_numbers_alone, idle_fields, lookup, with_values, without_idle_fields
from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.connection import Connection, Joint, Link
from sim2reason.scenes.dsl.defaults import horizon, place_entities, within_oscillations
from sim2reason.scenes.dsl.entity import Entity, Name, Named, Part, internal_connections, outer_ports, port_stops
from sim2reason.scenes.dsl.measures import Gravity
from sim2reason.scenes.dsl.mechanism import GRAVITY, Mechanism
from sim2reason.scenes.dsl.model import Model, Parameter, field_names, parameters, replace_valid, replace_validated
from sim2reason.scenes.dsl.ports import Pass, Port, Stop, reversed_stops, travelled
from sim2reason.scenes.dsl.units import UnitSystem

MAX_ENTITIES = 8


class World(Model):
    """The surroundings of a scene: its gravity."""

    gravity: Gravity = GRAVITY


class Scene(Model):
    """A physical system: named entities, the connections between their ports, and the world.

    A scene is immutable, and checked when it is made. Numbers, bodies and connections have addresses, such as
    ``ramp.block.mass``, which `value`, `having` and `without` take.

    Attributes:
        name: Name of the scene.
        entities: The entities with their names; 1 to 8.
        connections: Strings, rods, springs and so on between ports of entities.
        world: Gravity, in m/s².
        glued: Addresses of bodies that are welded to their carriers.
        joints: All connections by address, including those within entities.
        builder: The builder that contains all parts, from which the positions of sites can be read.
        units: System of units of the text and of the mechanism.
        horizon: Default duration of a simulation, in the unit of time of the text.
        mechanism: The mechanism that engines simulate; SceneError if the parts do not fit together or nothing can move.
        starts_from_rest: Whether nothing moves at t = 0 and the text may speak of a release.
        bodies: All bodies that the text can mention, by address.
        parameters: All declared numbers with their addresses and meanings.

    Examples:
        >>> import sim2reason
        >>> scene = sim2reason.load('''
        ... scene:
        ...   entities:
        ...   - name: ramp
        ...     type: TwoSideMassPlane
        ...     parameters: {plane: {angle: 30.0, friction: 0.2}, blocks: [{mass: 2.0}]}
        ... ''')
        >>> scene.value("ramp.plane.angle")
        30.0
        >>> print(scene.having("world.gravity", 1.6))
        Scene 'scene'
          ramp: TwoSideMassPlane, plane.angle = 30°, plane.friction = 0.20, blocks.0.mass = 2.0 kg
          world: World, gravity = 1.6 m/s²
    """

    name: Name = "scene"
    entities: tuple[Named, ...]
    connections: tuple[SerializeAsAny[Connection], ...] = ()
    world: World = World()
    glued: tuple[str, ...] = ()

    @model_validator(mode="after")
    def _fits(self) -> Self:
        names = [named.name for named in self.entities]
        if not 1 <= len(names) <= MAX_ENTITIES:
            raise SceneError("entities", f"there are {len(names)}", f"give 1 to {MAX_ENTITIES}")
        for index, name in enumerate(names):
            if name in (*names[:index], "world", *self._named_connections()):  # addresses of numbers begin with these
                problem = "two entities are" if name in names[:index] else "an entity and the world or a string are"
                raise SceneError(f"entities.{index}.name", f"{problem} called {name!r}", "rename one")
        self._check_links()
        self._check_forest()
        for address in self.glued:
            known = self.builder.bodies
            if address not in known:
                raise SceneError(
                    "glued", f"nothing that could move is at {address!r}", f"there are: {', '.join(known)}"
                )
        return self

    def _check_links(self) -> None:
        """Check that every link leads to a port, no port is used twice, and no required port is open."""
        used: set[tuple[str, str]] = set()
        for number, connection in enumerate(self.connections):
            for index, link in enumerate(connection.links):
                location = f"connections.{number}"
                ports = outer_ports(type(self.entity(link.entity, location)))
                if link.port not in ports:
                    known = ", ".join(ports) or "none"
                    raise SceneError(location, f"{link.entity!r} has no port {link.port!r}", f"its ports: {known}")
                if not connection.admits(ports[link.port], index, len(connection.links) - 1):
                    problem = f"a {connection.key} can not be joined to {link}, which is for other connections"
                    raise SceneError(location, problem, f"it takes a {connection.joins.__name__}")
                self._check_place(ports[link.port], link, location)
                if (link.entity, link.port) in used:
                    raise SceneError(location, f"port {link} is used twice", "use each port once")
                used.add((link.entity, link.port))
            self._check_order(connection, f"connections.{number}")
        for named in self.entities:
            for port, declared in outer_ports(type(named.entity)).items():
                if declared.required and (named.name, port) not in used:
                    raise SceneError(f"entities.{named.name}", f"its port {port!r} is open", "connect it to something")
            for field, port in idle_fields(named, used):
                problem = f"{field} only matters to what is joined to its port {port!r}, which is open"
                raise SceneError(f"entities.{named.name}", problem, f"leave {field} out, or connect the port")

    def _check_place(self, port: Port, link: Link, place: str) -> None:
        """Raise SceneError if optional fields of the entity exclude the port to which a link leads."""
        entity = self.entity(link.entity)
        if port.needs and getattr(entity, port.needs) is None:
            problem = f"{link} needs {port.needs}, which {link.entity!r} leaves out"
            raise SceneError(place, problem, f"give {port.needs}")
        if port.unless and getattr(entity, port.unless) is not None:
            problem = f"{port.unless} of {link.entity!r} has the place of {link}"
            raise SceneError(place, problem, f"leave {port.unless} out")

    def _check_order(self, connection: Connection, place: str) -> None:
        """Raise SceneError unless a connection ends only at ports for ends and passes only ports for passing."""
        last = len(connection.links) - 1
        if last < 1:
            raise SceneError(place, "it has fewer than two ends", "give it two")
        for index, link in enumerate(connection.links):
            passed = isinstance(outer_ports(type(self.entity(link.entity)))[link.port], Pass)
            if passed != (0 < index < last):
                problem = "can only be passed" if passed else "can't be passed"
                raise SceneError(place, f"{link} {problem}", "lead the string on" if passed else "end it there")
            if link.flipped and not passed:
                raise SceneError(place, f"{link} is an end and has no sides to flip", "leave flipped out")

    def _check_forest(self) -> None:
        """Check that connections form no ring, which would fix the positions of entities twice."""
        leader = {named.name: named.name for named in self.entities}

        def find(name: str) -> str:
            while leader[name] != name:
                name = leader[name]
            return name

        for number, connection in enumerate(self.connections):
            for one, other in zip(connection.links, connection.links[1:], strict=False):
                first, second = find(one.entity), find(other.entity)
                if first == second:
                    raise SceneError(f"connections.{number}", "the connections form a ring", "leave one of them out")
                leader[first] = second

    def entity(self, name: str, place: str = "entities") -> Entity:
        """Return the entity with this name.

        Args:
            name: Name of the entity.
            place: Path to name in the error.

        Returns:
            The entity.

        Raises:
            SceneError: There is no such entity.
        """
        for named in self.entities:
            if named.name == name:
                return named.entity
        raise SceneError(
            place, f"no entity is called {name!r}", f"there are: {', '.join(n.name for n in self.entities)}"
        )

    @cached_property
    def joints(self) -> dict[str, Joint]:
        """Return all connections by address, including those within entities."""
        all_joints: list[Joint] = []
        for named in self.entities:
            for name, inner in internal_connections(type(named.entity)).items():
                stops = [stop for port in inner.stops for stop in port_stops(named.entity, port, named.name)]
                all_joints.append(Joint(f"{named.name}.{name}", inner.made(), tuple(travelled(stops))))
        for number, connection in enumerate(self.connections, start=1):
            all_joints.append(
                Joint(f"{connection.key}_{number}", connection, tuple(path_stops(self, connection.links)))
            )
        return {joint.name: joint for joint in all_joints}

    @cached_property
    def builder(self) -> Builder:
        """Return the builder that contains all parts, from which the positions of sites can be read."""
        builder = Builder((0.0, 0.0, -self.world.gravity), self.glued, self.units)
        paths = [(connection, self.joints[name].stops) for name, connection in self._named_connections().items()]
        place_entities(self.entities, paths, builder)
        for joint in self.joints.values():
            joint.build(builder)
        return builder

    @property
    def units(self) -> UnitSystem:
        """Return the units of the text and the mechanism; SceneError if the entities have several systems."""
        systems = {named.entity.units for named in self.entities}
        if len(systems) > 1:
            names = " and ".join(sorted(units.name for units in systems))
            raise SceneError("entities", f"some speak in {names} units", "let entities of one scene share their units")
        return systems.pop()

    @property
    def horizon(self) -> float:
        """Return the default duration of a simulation, in the unit of time of the text."""
        duration = horizon((named.entity for named in self.entities), self.world.gravity)
        return within_oscillations(duration, self.mechanism)

    @cached_property
    def mechanism(self) -> Mechanism:
        """Return the mechanism for engines; SceneError if parts do not fit together or nothing can move."""
        built = self.builder.finish()
        if not built.coordinates:
            location = "glued" if self.glued else "entities"
            raise SceneError(location, "nothing in this scene can move", "leave something free to move")
        return built

    @property
    def starts_from_rest(self) -> bool:
        """Return whether nothing moves at t = 0 and the text may speak of a release."""
        clocked = any(named.entity.clocked for named in self.entities)
        return not clocked and all(coordinate.speed == 0.0 for coordinate in self.mechanism.coordinates)

    def check(self) -> None:
        """Build the mechanism; SceneError if the parts do not fit together or nothing can move."""
        _ = self.mechanism

    @cached_property
    def bodies(self) -> dict[str, Body]:
        """Return all bodies that the text can mention, by address, including those of strings."""
        all_bodies: dict[str, Body] = {}
        for named in self.entities:
            all_bodies.update(_bodies(named.entity, named.name))
        for joint in self.joints.values():
            all_bodies.update(joint.brings(self.builder))
        return all_bodies

    @cached_property
    def parameters(self) -> tuple[Parameter, ...]:
        """Return all declared numbers with their addresses (``ramp.block.mass``) and meanings."""
        entities = [p for named in self.entities for p in parameters(named.entity, named.name)]
        own = [p for name, connection in self._named_connections().items() for p in parameters(connection, name)]
        return (*entities, *own, *parameters(self.world, "world"))

    def value(self, path: str) -> Any:
        """Return the value at an address.

        Args:
            path: Address of a number, a body, an entity or a connection, such as ``ramp.block.mass`` or
                ``world.gravity``.

        Returns:
            The value; of an absent optional part, None.

        Raises:
            SceneError: There is no such address.
        """
        head, _, rest = path.partition(".")
        holder = self.world if head == "world" else self._named_connections().get(head) or self.entity(head, path)
        return lookup(holder, rest) if rest else holder

    def __repr__(self) -> str:
        """Return the name, the entities with their types and the number of connections on one line."""
        entities = ", ".join(f"{named.name} {type(named.entity).__name__}" for named in self.entities)
        joined = f"; {format_count(len(self.connections), 'connection')}" if self.connections else ""
        return f"<Scene {self.name!r}: {abridge(f'{entities}{joined}', 140)}>"

    def __str__(self) -> str:
        """Return a line for each entity with its numbers, for each connection, and for the world."""
        lines = [f"Scene {self.name!r}", *(f"  {_line(named.entity, named.name)}" for named in self.entities)]
        for name, connection in self._named_connections().items():
            lines.append(f"  {_line(connection, name)}, {' - '.join(map(str, connection.links))}")
        lines.append(f"  {_line(self.world, 'world')}")
        return "\n".join([*lines, *([f"  glued: {', '.join(self.glued)}"] if self.glued else [])])

    def _named_connections(self) -> dict[str, Connection]:
        return {f"{connection.key}_{number}": connection for number, connection in enumerate(self.connections, 1)}

    def having(self, path: str, value: object) -> "Scene":
        """Return the scene with another value at an address.

        Args:
            path: The address.
            value: The new value, in the unit that the field declares.

        Returns:
            A new scene.

        Raises:
            SceneError: There is no such address, or the new scene is impossible.
            ValidationError: The value is out of range.
        """
        return self.having_all({path: value})

    def having_all(self, values: Mapping[str, object]) -> "Scene":
        """Return the scene with other values at several addresses, validated once, when all are set.

        Args:
            values: New values by address.
        """
        world, connections = self.world, self._named_connections()
        entities = {named.name: named for named in self.entities}  # those that stay share what is known of them
        changes: dict[str, dict[str, object]] = {}
        for path, value in values.items():
            head, _, rest = path.partition(".")
            changes.setdefault(head, {})[rest] = value
        replace = replace_validated if self.glued or not changes_numbers_alone(entities, changes) else replace_valid
        for head, news in changes.items():
            if head == "world":
                world = with_values(world, news)
            elif head in connections:
                connections[head] = with_values(connections[head], news)
            else:
                current = entities[head].entity if head in entities else self.entity(head, f"{head}.{next(iter(news))}")
                entities[head] = Named(name=head, entity=with_values(current, news))
        return replace(self, world=world, entities=tuple(entities.values()), connections=tuple(connections.values()))

    def without(self, address: str) -> "Scene":
        """Return the scene without an entity, an optional part, or a member of a variable-length part.

        A string that passed the entity goes on to its next stop; a string that ended there is removed.

        Args:
            address: Address of the entity or part.

        Returns:
            A new scene.

        Raises:
            SceneError: There is no such address, or the scene is impossible without it.
        """
        if "." in address:
            self.value(address)
            return self.having(address, None)
        self.entity(address)
        kept = tuple(named for named in self.entities if named.name != address)
        connections: list[Connection] = []
        for connection in self.connections:
            ends = (connection.links[0].entity, connection.links[-1].entity)
            links = tuple(link for link in connection.links if link.entity != address)
            if address not in ends and len(links) > 1:
                connections.append(replace_validated(connection, links=links))
        kept = without_idle_fields(kept, (connection.links for connection in connections))
        return replace_validated(self, entities=kept, connections=tuple(connections))

    def gluing(self, *addresses: str) -> "Scene":
        """Return the scene with bodies welded to their carriers.

        Args:
            addresses: Addresses of the bodies.

        Returns:
            A new scene.

        Raises:
            SceneError: An address is not that of a movable body.
        """
        return replace_validated(self, glued=tuple(sorted({*self.glued, *addresses})))


def _line(value: Model, name: str) -> str:
    """Return a name, the type of the value, and its numbers with addresses and units, without hidden ones."""
    shown = (p for p in parameters(value) if not p.hidden)
    numbers = (f"{p.path} = {p.measure.say(p.value)}" for p in shown if p.value is not None)
    return f"{name}: {', '.join((type(value).__name__, *numbers))}"


def _bodies(value: Model, address: str) -> dict[str, Body]:
    bodies: dict[str, Body] = {}
    for name in field_names(type(value)):
        field_value: Any = getattr(value, name)
        inside = isinstance(field_value, tuple)
        for index, member in enumerate(cast("tuple[Any, ...]", field_value) if inside else (field_value,)):
            where = f"{address}.{name}.{index}" if inside else f"{address}.{name}"
            if isinstance(member, Body):
                bodies[where] = member
            elif isinstance(member, Part):
                bodies.update(_bodies(member, where))
    return bodies


def path_stops(scene: Scene, links: tuple[Link, ...]) -> list[Stop]:
    """Return the stops of a path of links in the order of travel."""
    path: list[Stop] = []
    for index, link in enumerate(links):
        stops = port_stops(scene.entity(link.entity), link.port, link.entity, flipped=link.flipped)
        last = index == len(links) - 1
        path.extend(reversed_stops(stops) if last and index > 0 else stops)
    return path
