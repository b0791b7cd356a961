"""The JSON schema of scene files, from the declarations of entities, bodies and connections."""

import inspect
import re
import types
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from annotated_types import Ge, Gt, Le, Len, Lt
from pydantic.fields import FieldInfo

from sim2reason.scenes.dsl.connection import CONNECTIONS, Connection
from sim2reason.scenes.dsl.entity import ENTITIES, NAME, Entity
from sim2reason.scenes.dsl.measures import Hidden, Measure
from sim2reason.scenes.dsl.model import Model, field_types
from sim2reason.scenes.dsl.scene import MAX_ENTITIES, World
from sim2reason.scenes.files.sections import TEXT, WAYS, directions, own_fields

DIALECT = "https://json-schema.org/draft/2020-12/schema"
Json = dict[str, Any]
KINDS = {"number": "a number", "integer": "a whole number", "array": "a list"}
BASIC: dict[object, Json] = {
    float: {"type": "number"},
    int: {"type": "integer"},
    bool: {"type": "boolean"},
    str: {"type": "string"},
    types.NoneType: {"type": "null"},
}
QUESTION: Json = {
    "type": ["object", "string"],
    "description": "What solve finds of the scene: a sentence, or what, of what, and when, as its options have it.",
    "required": ["find"],
    "additionalProperties": {"type": ["string", "number"]},
}
TITLE = r"^[A-Za-z][A-Za-z0-9_ ]{0,39}$"  # of a scene: its name, or a title
MASSES: Json = {
    "type": "object",
    "description": "The masses by their type, and what else the entity has.",
    "required": ["mass_values"],
    "properties": {"mass_values": {"type": "array"}},
}


@cache
def snake(name: str) -> str:
    """Return the snake-case name of a class: ``OnPlane`` becomes ``on_plane``."""
    return re.sub(r"(?<!^)(?=[A-Z])", "_", name).lower()


@cache
def holders(cls: type[Entity]) -> dict[str, dict[str, type[Model]]]:
    """Return the fields that hold a system of blocks, each with its allowed kinds."""
    kinds_by_field = {name: {snake(m.__name__): m for m in kind.models} for name, kind in field_types(cls).items()}
    return {
        name: kinds
        for name, kinds in kinds_by_field.items()
        if kinds and all("blocks" in field_types(model) for model in kinds.values())
    }


def is_many(annotation: Any) -> bool:
    """Return whether a field holds a tuple, which scene files write as a list."""
    origin = get_origin(annotation)
    if origin is tuple:
        return True
    inner = get_args(annotation)[:1] if origin is Annotated else get_args(annotation)
    return origin in (Annotated, Union, types.UnionType) and any(is_many(argument) for argument in inner)


def schema() -> Json:
    """Return the JSON schema of scene files.

    Returns:
        The schema, as plain JSON values, with the ranges, units and descriptions of all entities and connections.

    Examples:
        >>> import sim2reason
        >>> schema = sim2reason.schema()
        >>> schema["title"], schema["required"]
        ('sim2reason scene', ['scene'])
    """
    parts = _Definitions()
    entities = [_entity(cls, parts) for cls in ENTITIES.values()]
    scene = _object(
        {
            "name": {"type": "string", "pattern": TITLE, "description": "What the scene is called."},
            "entities": {"type": "array", "minItems": 1, "maxItems": MAX_ENTITIES, "items": {"oneOf": entities}},
            "connections": {"type": "array", "items": {"oneOf": [_connection(c, parts) for c in CONNECTIONS.values()]}},
            "world": parts.model(World),
            "glued": {
                "type": "array",
                "items": {"type": "string"},
                "description": "Addresses of bodies that are welded to what carries them.",
            },
        },
        required=["entities"],
    )
    return (
        {"$schema": DIALECT, "title": "sim2reason scene"}
        | _object({"scene": scene, "text": TEXT, "question": QUESTION}, required=["scene"])
        | {"$defs": parts.found}
    )


@dataclass(frozen=True, slots=True)
class Field:
    """The documentation of one field in a file: its schema and a description in words."""

    name: str
    schema: Json
    required: bool
    hidden: bool
    measure: Measure | None


def fields(cls: type[Model], parts: "_Definitions | None" = None) -> Iterator[Field]:
    """Yield the fields of a class, in the order of declaration."""
    for name, info in cls.model_fields.items():
        metadata = _metadata(info)
        measure = next((item for item in metadata if isinstance(item, Measure)), None)
        hidden = any(isinstance(item, Hidden) for item in metadata)
        yield Field(name, _field(info, parts or _Definitions()), info.is_required(), hidden, measure)


def _metadata(info: FieldInfo) -> list[object]:
    """Return the metadata of a field's annotation, including that inside of `X | None`."""
    inner = [item for argument in get_args(info.annotation) for item in getattr(argument, "__metadata__", ())]
    return [*info.metadata, *inner]


class _Definitions:
    """The definitions of bodies and parts in the schema, referred to by name."""

    def __init__(self) -> None:
        self.found: Json = {}

    def model(self, cls: type[Model], *, kind: bool = False) -> Json:
        """Return a reference to a class; with `kind`, its instances must name the class."""
        name = cls.__name__ + ("Kind" if kind else "")
        if name not in self.found:
            self.found[name] = {}  # it may hold itself
            known = list(fields(cls, self))
            own = {field.name: field.schema for field in known}
            needed = [field.name for field in known if field.required]
            kind_schema = {"kind": {"const": snake(cls.__name__)}} if kind else {}
            described = {"description": summary(cls)}
            self.found[name] = described | _object(kind_schema | own, required=[*kind_schema, *needed])
        return {"$ref": f"#/$defs/{name}"}


def summary(cls: type) -> str:
    """Return the first sentence of the docstring of a class."""
    return " ".join((inspect.getdoc(cls) or "").partition("\n\n")[0].split())


def _object(properties: Json, required: list[str] | None = None) -> Json:
    needed = list(properties) if required is None else required
    found: Json = {"type": "object", "additionalProperties": False, "properties": properties}
    return found | ({"required": needed} if needed else {})


def _field(info: FieldInfo, parts: _Definitions) -> Json:
    found = _constrained(_annotation(info.annotation, parts), info.metadata)
    if not info.is_required() and isinstance(info.default, float | int | str):
        found["default"] = info.default
    return found


def _annotation(annotation: Any, parts: _Definitions) -> Json:
    """Return the schema of a type; raise TypeError if files cannot contain it."""
    origin, arguments = get_origin(annotation), get_args(annotation)
    if annotation in BASIC:
        return dict(BASIC[annotation])
    if origin is Annotated:
        return _constrained(_annotation(arguments[0], parts), arguments[1:])
    if origin is Literal:
        return {"enum": list(arguments)}
    if origin in (Union, types.UnionType):
        models = [a for a in arguments if isinstance(a, type) and issubclass(a, Model)]
        return {"oneOf": [_member(a, parts, kind=len(models) > 1) for a in arguments]}
    return _tuple(arguments, parts) if origin is tuple else _member(annotation, parts)


def _tuple(arguments: tuple[Any, ...], parts: _Definitions) -> Json:
    if arguments[-1] is Ellipsis:
        return {"type": "array", "items": _annotation(arguments[0], parts)}
    items = [_annotation(argument, parts) for argument in arguments]
    return {"type": "array", "prefixItems": items, "minItems": len(items), "maxItems": len(items)}


def _member(annotation: Any, parts: _Definitions, *, kind: bool = False) -> Json:
    if isinstance(annotation, type) and issubclass(annotation, Model):
        kinds = annotation.variants()
        if kinds != (annotation,):
            return {"oneOf": [parts.model(each, kind=len(kinds) > 1) for each in kinds]}
        return parts.model(annotation, kind=kind)
    if annotation in BASIC or get_origin(annotation) is not None:
        return _annotation(annotation, parts)
    raise TypeError(f"a scene file can't hold {annotation!r}")


def _constrained(found: Json, metadata: Any) -> Json:
    """Return a schema with the limits and the description from an annotation."""
    for item in metadata:
        match item:
            case Gt(gt=limit):
                found["exclusiveMinimum"] = limit
            case Ge(ge=limit):
                found["minimum"] = limit
            case Lt(lt=limit):
                found["exclusiveMaximum"] = limit
            case Le(le=limit):
                found["maximum"] = limit
            case Len(min_length=low, max_length=high):
                found |= {"minItems": low} | ({"maxItems": high} if high is not None else {})
            case Measure(name=name, unit=unit):
                found["description"] = f"{name} in {unit}" if unit else name
            case _:
                pass
    return found


def _entity(cls: type[Entity], parts: _Definitions) -> Json:
    known = list(fields(cls, parts))
    parameters = _object({f.name: f.schema for f in known}, required=[f.name for f in known if f.required])
    properties: Json = {
        "name": {"type": "string", "pattern": NAME},
        "type": {"enum": [cls.__name__, snake(cls.__name__)]},
        "position": {"type": "array", "items": BASIC[float], "minItems": 3, "maxItems": 3},
        "parameters": {"anyOf": [parameters, MASSES]} if holders(cls) else parameters,
    }
    needed = ["name", "type", *(["parameters"] if "required" in parameters else [])]
    return {"description": summary(cls)} | _object(properties, required=needed)


def _connection(cls: type[Connection], parts: _Definitions) -> Json:
    own = {field.name: field.schema for field in fields(cls, parts) if field.name in own_fields(cls)}
    words = sorted(
        {word for entity in ENTITIES.values() for spelling in directions(entity) for word in spelling if word}
    )
    ways = {"enum": [*words, *WAYS]}
    end = _object(
        {"entity": {"type": "string"}, "direction": ways, "connecting_point": {"enum": words}},
        required=["entity", "direction"],
    )
    pair: Json = {"type": "array", "minItems": 2, "maxItems": 2, "items": end}
    return {"description": summary(cls)} | _object({cls.key: pair} | own, required=[cls.key])


def words(found: Json) -> str:
    """Return the schema of one field in words: ``a number in kg, greater than 0 and at most 1000000``."""
    if "enum" in found:
        return "one of: " + ", ".join(map(str, found["enum"]))
    if "oneOf" in found:
        return " or ".join(words(option) for option in found["oneOf"] if option.get("type") != "null")
    if "$ref" in found:
        return "keys of its own"
    kind = KINDS.get(found["type"], "a word")
    unit = found.get("description", "").partition(" in ")[2]
    limits = _limits(found)
    return kind + (f" in {unit}" if unit else "") + (f", {' and '.join(limits)}" if limits else "")


def _limits(found: Json) -> list[str]:
    """Return the limits of a number or a list, in words."""
    templates = {
        "exclusiveMinimum": "greater than {}",
        "minimum": "at least {}",
        "exclusiveMaximum": "less than {}",
        "maximum": "at most {}",
        "minItems": "of at least {}",
        "maxItems": "of at most {}",
    }
    return [text.format(f"{found[key]:.15g}") for key, text in templates.items() if found.get(key) is not None]
