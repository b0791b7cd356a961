"""Reading and writing of scene files: `load` reads what `dump` writes as an equal scene; the bytes never vary.

    scene:
      entities:
      - {name: hook, type: FixedSupport}
      …
      connections:
      - tendon: [{entity: …, direction: …}, {entity: …, direction: …}]

Files are untrusted input: every fault is one SceneError with the path in the file, the line and the remedy.
"""

from difflib import get_close_matches
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple, NoReturn, Protocol, TypeVar, runtime_checkable

from pydantic import ValidationError

from sim2reason.base.registry import similar_names
from sim2reason.base.yaml_text import Plain, parse, quote_value, write
from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.entity import ENTITIES, Entity, Named
from sim2reason.scenes.dsl.model import Model, field_types
from sim2reason.scenes.dsl.scene import Scene, World
from sim2reason.scenes.files.schema import is_many, snake
from sim2reason.scenes.files.sections import (
    Wording,
    own_values,
    pairs_to_plain,
    parse_question,
    parse_wording,
    paths,
    read_pair,
)
from sim2reason.scenes.files.validation import (
    add_line_number,
    canonical_parameters,
    check_position,
    explain_error,
    parameters_outside,
    plain_name,
    source_text,
)

M = TypeVar("M", bound=Model)
SCENE_KEYS = ("name", "entities", "connections", "world", "glued")
ENTITY_KEYS = ("name", "type", "position", "parameters")


def load(source: str | Path) -> Scene:
    """Read a scene from YAML text or from a file.

    Args:
        source: The path of a file, or the text itself. A string of one line that ends in .yaml, .yml or .json is a
            path.

    Returns:
        The scene; its mechanism can be built.

    Raises:
        SceneError: The text is invalid; the message names the path in the file, the line and a remedy.
        OSError: The file cannot be read.

    Examples:
        >>> import sim2reason
        >>> scene = sim2reason.load('''
        ... scene:
        ...   entities:
        ...   - name: ramp
        ...     type: TwoSideMassPlane
        ...     parameters: {plane: {angle: 30.0, friction: 0.2}, blocks: [{mass: 2.0}]}
        ... ''')
        >>> scene
        <Scene 'scene': ramp TwoSideMassPlane>
        >>> sim2reason.load(sim2reason.dump(scene)) == scene
        True
    """
    return loads(source_text(source))


def loads(text: str) -> Scene:
    """Read a scene from YAML text, never from a path; errors as in `load`."""
    data = parse(text)
    try:
        return _scene(data)
    except SceneError as error:
        raise SceneError(add_line_number(error.place, text), error.problem, error.remedy) from None


def dump(scene: Scene, wording: Wording | None = None) -> str:
    """Return a scene as YAML text, which `load` reads as an equal scene.

    Args:
        scene: The scene.
        wording: Wording of the problem about the scene, from which figures take their names; by default none is
            written.

    Returns:
        The YAML text; the same scene always gives the same text. Absent optional parts are left out.

    Examples:
        >>> import sim2reason
        >>> scene = sim2reason.parse_scene("A 2 kg block is released from rest on a frictionless 30-degree incline.")
        >>> print(sim2reason.dump(scene.scene))
        scene:
          name: scene
          entities:
          - name: e1
            type: TwoSideMassPlane
            parameters:
              plane: {angle: 30.0, friction: 0.0}
              blocks:
              - {mass: 2.0}
          world: {gravity: 9.8}
        <BLANKLINE>
    """
    classes = {named.name: type(named.entity) for named in scene.entities}
    entities: list[Plain] = [_entity_to_plain(named) for named in scene.entities]
    connections: list[Plain] = []
    for connection in scene.connections:
        first, *others = pairs_to_plain(connection, classes)
        own = {name: to_plain(value) for name, value in own_values(connection).items()}
        connections.append({connection.key: first, **own})
        connections.extend({connection.key: pair} for pair in others)
    body: dict[str, Plain] = {"name": scene.name, "entities": entities}
    if connections:
        body["connections"] = connections
    body["world"] = to_plain(scene.world)
    if scene.glued:
        body["glued"] = list(scene.glued)
    text: dict[str, Plain] = {"text": wording.plain} if wording is not None else {}
    return write({"scene": body, **text})


def _entity_to_plain(named: Named) -> dict[str, Plain]:
    entry: dict[str, Plain] = {"name": named.name, "type": type(named.entity).__name__}
    parameters = to_plain(named.entity)
    return entry | ({"parameters": parameters} if parameters else {})


def to_plain(value: Any, *, kind: bool = False) -> Plain:
    """Return a value as in a scene file; with `kind`, including the name of its class."""
    if isinstance(value, tuple):
        return [to_plain(member, kind=kind) for member in value]  # type: ignore[reportUnknownVariableType]
    if not isinstance(value, Model):
        return value
    mapping: dict[str, Plain] = {"kind": snake(type(value).__name__)} if kind else {}
    for name, slot in _slots(type(value)).items():
        field_value = getattr(value, name)
        if field_value not in (None, ()) or field_value != slot.default:
            mapping[name] = to_plain(field_value, kind=len(slot.models) > 1)
    return mapping


class _Slot(NamedTuple):
    """The values that a field of a model can hold."""

    models: dict[str, type[Model]]  # by kind
    many: bool
    optional: bool
    default: object


@cache
def _slots(cls: type[Model]) -> dict[str, _Slot]:
    kinds = field_types(cls)
    slots: dict[str, _Slot] = {}
    for name, info in cls.model_fields.items():
        many, models = is_many(info.annotation), {snake(model.__name__): model for model in kinds[name].models}
        slots[name] = _Slot(models, many, kinds[name].optional and not many, info.default)
    return slots


def _scene(data: Plain) -> Scene:
    if isinstance(data, dict) and "scene" not in data and (misplaced := next((k for k in SCENE_KEYS if k in data), "")):
        _refuse_key(misplaced, "let the file begin with the line scene: and indent all that is there below it")
    top = _mapping(data, "scene", ("scene", "text", "question"), root=True)
    _ = parse_wording(top.get("text", {})), parse_question(top.get("question", {}))
    body = _mapping(top.get("scene"), "scene", SCENE_KEYS)
    entities = tuple(_entity(entry, f"scene.entities[{i}]") for i, entry in enumerate(_list(body, "entities")))
    classes = _classes(entities)
    pairs = [read_pair(e, f"scene.connections[{i}]", classes) for i, e in enumerate(_list(body, "connections"))]
    connection_paths = list(paths(pairs))
    connections = tuple(_made(path.kind, path.own, path.first, {"links": path.links}) for path in connection_paths)
    world = _made(World, body.get("world", {}), "scene.world")
    glued = _glued(body)
    places = {f"{c.key}_{i + 1}": connection_paths[i].first for i, c in enumerate(connections)}
    try:
        scene = Scene(
            name=plain_name(body.get("name", "scene")),  # type: ignore[arg-type]  # pydantic says what is wrong with it
            entities=entities,
            connections=connections,
            world=world,
            glued=glued,
        )
        _ = scene.mechanism
    except ValidationError as error:
        raise explain_error(Scene, error, "scene") from None
    except SceneError as error:
        raise SceneError(_file_place(error.place, entities, places), error.problem, error.remedy) from None
    return scene


def _entity(entry: Plain, location: str) -> Named:
    for key in sorted(parameters_outside(entry, _types()) - set(ENTITY_KEYS)):
        _refuse_key(f"{location}.{key}", f"move it below the key parameters: parameters: {{{key}: …}}")
    fields = _mapping(entry, location, ENTITY_KEYS)
    for key in ("name", "type"):
        if not isinstance(fields.get(key), str):
            problem = f"it is {quote_value(fields[key])}, not a word" if key in fields else "it is missing"
            raise SceneError(f"{location}.{key}", problem, "give each entity a name and a type")
    cls = _class(str(fields["type"]), f"{location}.type")
    if "position" in fields:
        check_position(fields["position"], f"{location}.position")
    spelled = canonical_parameters(cls, fields.get("parameters", {}), f"{location}.parameters")
    try:
        entity = _made(cls, spelled.parameters, f"{location}.parameters")
    except SceneError as error:
        raise SceneError(spelled.in_file(error.place), error.problem, error.remedy) from None
    try:
        return Named(name=str(fields["name"]), entity=entity)
    except ValidationError as error:
        raise explain_error(Named, error, location) from None


def _classes(entities: tuple[Named, ...]) -> dict[str, type[Entity]]:
    classes: dict[str, type[Entity]] = {}
    for index, named in enumerate(entities):
        if named.name in classes:
            raise SceneError(f"scene.entities[{index}].name", f"two entities are called {named.name}", "rename one")
        classes[named.name] = type(named.entity)
    return classes


def _types() -> dict[str, type[Entity]]:
    """Return entity classes by every name allowed in files: ``FixedSupport`` and ``fixed_support``."""
    return {snake(name): cls for name, cls in ENTITIES.items()} | dict(ENTITIES)


def _class(name: str, location: str) -> type[Entity]:
    known = _types()
    if name not in known:
        near = similar_names(name, known)
        remedy = f"did you mean: {', '.join(near)}" if near else "run: sim2reason list entities"
        raise SceneError(location, f"there is no type {quote_value(name)}", remedy)
    return known[name]


def _made(cls: type[M], data: Plain, location: str, given: dict[str, object] | None = None) -> M:
    """Return a model from its data in a file and other known fields."""
    slots = _slots(cls)
    fields = _mapping(data, location, tuple(name for name in slots if name not in (given or {})))
    values: dict[str, object] = {name: _value(slots[name], v, f"{location}.{name}") for name, v in fields.items()}
    try:
        return cls(**values, **(given or {}))
    except ValidationError as error:
        raise explain_error(cls, error, location) from None


def _value(slot: _Slot, data: Plain, location: str) -> object:
    if not slot.many:
        return _parse_one(slot, data, location)
    if not isinstance(data, list):
        raise SceneError(
            location, f"it is {quote_value(data)}, not a list", "begin each member with a dash, or write [ ]"
        )
    return tuple(_parse_one(slot, member, f"{location}[{index}]") for index, member in enumerate(data))


def _parse_one(slot: _Slot, data: Plain, location: str) -> object:
    if not slot.models or (data is None and slot.optional):
        return data
    if len(slot.models) == 1:
        return _made(next(iter(slot.models.values())), data, location)
    kinds = ", ".join(slot.models)
    if not isinstance(data, dict):
        raise SceneError(location, f"it is {quote_value(data)}, not a mapping", f"write it with a kind: {kinds}")
    kind = data.get("kind")
    if not isinstance(kind, str) or kind not in slot.models:
        problem = f"there is no kind {quote_value(kind)}" if "kind" in data else "it does not say its kind"
        raise SceneError(f"{location}.kind", problem, f"give it one of: {kinds}")
    rest = {key: value for key, value in data.items() if key != "kind"}
    return _made(slot.models[kind], rest, location)


def _mapping(data: Plain, location: str, keys: tuple[str, ...], *, root: bool = False) -> dict[str, Plain]:
    """Return `data` if it is a mapping with known keys alone; raise SceneError otherwise."""
    listed = ", ".join(keys) or "none"
    if not isinstance(data, dict):
        problem = "it is missing" if data is None else f"it is {quote_value(data)}, not a mapping"
        raise SceneError(location, problem, f"give it these keys: {listed}")
    for key in data:
        if key not in keys:
            near = get_close_matches(key, keys, n=1)
            _refuse_key(key if root else f"{location}.{key}", f"did you mean: {near[0]}" if near else f"keys: {listed}")
    return data


def _refuse_key(location: str, remedy: str) -> NoReturn:
    raise SceneError(location, "there is no such key here", remedy)


def _list(body: dict[str, Plain], key: str) -> list[Plain]:
    data = body.get(key, [])
    if not isinstance(data, list):
        raise SceneError(f"scene.{key}", f"it is {quote_value(data)}, not a list", "begin each member with a dash")
    return data


def _glued(body: dict[str, Plain]) -> tuple[str, ...]:
    for index, address in enumerate(_list(body, "glued")):
        if not isinstance(address, str):
            raise SceneError(
                f"scene.glued[{index}]", f"it is {quote_value(address)}, not an address", "write: ramp.blocks.0"
            )
    return tuple(map(str, _list(body, "glued")))


def _file_place(location: str, entities: tuple[Named, ...], connections: dict[str, str]) -> str:
    """Return the path in the scene file of a value that an error names by its path in the scene."""
    head, *rest = location.split(".")
    if head in connections:
        return connections[head]
    if head in ("entities", "connections") and rest:
        if rest[0].isdigit() and head == "connections":
            return list(connections.values())[int(rest[0])]
        names = [named.name for named in entities]
        number = int(rest[0]) if rest[0].isdigit() else names.index(rest[0])
        return "".join([f"scene.entities[{number}]", *(f".{step}" for step in rest[1:])])
    names = [named.name for named in entities]
    if head in names:
        return f"scene.entities[{names.index(head)}]"
    return f"scene.{location}" if head in SCENE_KEYS else "scene"


@runtime_checkable
class AboutScene(Protocol):
    """An object with a scene or the scene's YAML text: an item, or a parsed text."""

    @property
    def scene(self) -> Scene | str:
        """Return the scene, or its YAML text."""
        ...


SceneLike = Scene | Path | str | AboutScene
"""A scene, the path of its file, its YAML text, an item about it, or a parsed text."""


class GivenScene(NamedTuple):
    """A scene, and the text of its file; the text is empty if there is none."""

    scene: Scene
    text: str = ""


def given_scene(source: SceneLike, function: str) -> GivenScene:
    """Return the scene passed to the public `function`, with the text of its file.

    Raises:
        TypeError: `source` is none of the types in `SceneLike`.
        SceneError, OSError: as in `load`.
    """
    if isinstance(source, Scene):
        return GivenScene(source)
    unwrapped = source.scene if isinstance(source, AboutScene) and not isinstance(source, type) else source
    if isinstance(unwrapped, Scene):
        return GivenScene(unwrapped)
    if isinstance(unwrapped, str | Path):
        text = source_text(unwrapped)
        return GivenScene(loads(text), text)
    raise TypeError(
        f"{function}() takes a scene, the path of its file, its YAML text or an item; "
        f"{type(source).__name__} is none of them"
    )


def as_scene(source: SceneLike, function: str) -> Scene:
    """Return the scene passed to the public `function`; errors as in `given_scene`."""
    return source if isinstance(source, Scene) else given_scene(source, function).scene
