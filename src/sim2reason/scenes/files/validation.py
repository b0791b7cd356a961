"""Validation of scene files: limit of size, errors with path, problem and remedy, and alternative spellings."""

import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from sim2reason.base.records import format_count
from sim2reason.base.yaml_text import MAX_BYTES, Lines, Plain, parse, quote_value
from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.entity import Entity
from sim2reason.scenes.dsl.model import Model, field_types
from sim2reason.scenes.files.schema import fields, holders, snake, words

_PATH = re.compile(r"[^\n\0{\[]*\.(?:yaml|yml|json)")


def source_text(source: str | Path) -> str:
    """Return a scene's text, given directly or read from a file up to the size limit; errors as in `load`."""
    if isinstance(source, str) and not _PATH.fullmatch(source):
        return source
    with Path(source).open("rb") as file:
        return decode_file(file.read(MAX_BYTES + 1))


def decode_file(data: bytes) -> str:
    """Return the text of a file's bytes; raise SceneError if they are too many or not UTF-8."""
    if len(data) > MAX_BYTES:
        raise SceneError("the file", f"it has more than {MAX_BYTES} bytes", "give a smaller scene")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        raise SceneError(f"line {line}", "the file is not UTF-8", "save it as UTF-8") from None


PROBLEMS: Mapping[str, str] = {
    "missing": "it is missing",
    "greater_than": "{input} is not greater than {gt}",
    "greater_than_equal": "{input} is less than {ge}",
    "less_than": "{input} is not less than {lt}",
    "less_than_equal": "{input} is more than {le}",
    "finite_number": "{input} is not finite",
    "float_type": "{input} is not a number",
    "int_type": "{input} is not a whole number",
    "too_short": "{input} has {actual_length} members, and at least {min_length} are needed",
    "too_long": "{input} has {actual_length} members, and at most {max_length} are possible",
    "literal_error": "{input} is not possible",
    "string_pattern_mismatch": "{input} is no name",
}
NAMING = "give a name of at most 40 small letters, digits and _, with a letter first"
_SUBPATH = re.compile(r"([a-z_]+(?:\.[a-z0-9_]+)*): (.*)", re.DOTALL)


def add_line_number(place: str, text: str) -> str:
    """Return a path in a scene file with its line number, found by parsing the text again."""
    lines: Lines = {}
    parse(text, lines)
    known = place
    while known and known not in lines:
        known = known[: max(known.rfind("."), known.rfind("["), 0)]
    return f"{place} (line {lines.get(known, 1)})"


def explain_error(cls: type[Model], error: ValidationError, location: str) -> SceneError:
    """Return a SceneError for the first error in a value of `cls` at `location`, with the number of further errors."""
    details = error.errors(include_url=False)
    first = details[0]
    where = location + "".join(f"[{step}]" if isinstance(step, int) else f".{step}" for step in first["loc"])
    if first["type"] == "value_error":
        return _own(str(first["msg"]).removeprefix("Value error, "), where)
    more = f" (and {format_count(len(details) - 1, 'more mistake')} here)" if len(details) > 1 else ""
    return SceneError(where, _problem(first) + more, _remedy(cls, first))


def _own(message: str, location: str) -> SceneError:
    """Return the error of a validator's message, which may begin with a path and end with a remedy."""
    if match := _SUBPATH.fullmatch(message):
        steps, message = match.groups()
        location += "".join(f"[{step}]" if step.isdigit() else f".{step}" for step in steps.split("."))
    problem, _, remedy = message.partition("; ")
    return SceneError(location, problem, remedy or "mend it")


def _problem(detail: ErrorDetails) -> str:
    context: dict[str, Any] = dict(detail.get("ctx", {}))
    value: Any = detail["input"]
    label = "the list" if isinstance(value, tuple) else quote_value(value)
    text = PROBLEMS.get(detail["type"])
    return text.format(input=label, **context) if text else f"{label}: {detail['msg'].lower()}"


def _remedy(cls: type[Model], detail: ErrorDetails) -> str:
    if detail["type"] == "string_pattern_mismatch":
        return NAMING
    name = detail["loc"][0] if detail["loc"] else ""
    wanted = next((words(field.schema) for field in fields(cls) if field.name == name), "")
    models = field_types(cls)[str(name)].models if detail["type"] == "missing" else ()
    if len(models) == 1:
        needed = [key for key, field in models[0].model_fields.items() if field.is_required()]
        wanted = f"a mapping, such as {{{', '.join(f'{key}: …' for key in needed)}}}" if needed else "a mapping"
    return f"give {wanted}" if wanted else "mend it"


HANGING = "Mass"
MASS_TYPE, MASS_VALUES = "mass_type", "mass_values"
MAX_NAME_LENGTH = 40  # largest number of characters of a name


@dataclass(frozen=True, slots=True)
class CanonicalParameters:
    """Parameters in the canonical spelling, with the original paths of moved values."""

    parameters: Plain
    places: dict[str, str]

    def in_file(self, place: str) -> str:
        """Return the path in the file of a value, given its path in the canonical parameters."""
        for new, old in self.places.items():
            if place == new or place.startswith((f"{new}.", f"{new}[")):
                return old + place.removeprefix(new).removesuffix(".mass")
        return place


def parameters_outside(entry: Plain, types: Mapping[str, type[Entity]]) -> set[str]:
    """Return the keys of an entity's entry that its class has as parameters."""
    if not isinstance(entry, dict) or str(entry.get("type")) not in types:
        return set()
    return set(entry) & set(types[str(entry["type"])].model_fields)


def plain_name(name: Plain) -> Plain:
    """Return a title such as ``Pulley System`` as a name, ``pulley_system``; other values are unchanged."""
    if not isinstance(name, str):
        return name
    return re.sub(r"[^a-z0-9]+", "_", name.lower()).strip("_")[:MAX_NAME_LENGTH] if re.search(r"[A-Z ]", name) else name


def check_position(position: Plain, location: str) -> None:
    """Raise SceneError unless a position consists of three numbers, m; positions have no effect."""
    numbers = position if isinstance(position, list) else []
    if len(numbers) != 3 or not all(isinstance(n, int | float) and not isinstance(n, bool) for n in numbers):
        raise SceneError(location, f"it is {quote_value(position)}, not a place", "give three numbers, as [0, 2, 0]")


def canonical_parameters(cls: type[Entity], parameters: Plain, location: str) -> CanonicalParameters:
    """Return parameters with ``mass_type`` and ``mass_values`` replaced by the fields of the entity class."""
    if not isinstance(parameters, dict) or not {MASS_TYPE, MASS_VALUES} & set(parameters):
        return CanonicalParameters(parameters, {})
    systems = holders(cls)
    if not systems:
        key = MASS_VALUES if MASS_VALUES in parameters else MASS_TYPE
        raise SceneError(f"{location}.{key}", f"{cls.__name__} has no masses of a type", "give its own parameters")
    for name in systems:
        if name in parameters:
            raise SceneError(f"{location}.{name}", f"{MASS_VALUES} says the same", "give one of the two")
    own = {key: value for key, value in parameters.items() if key in field_types(cls)}
    beside = {key: value for key, value in parameters.items() if key not in (*own, MASS_TYPE, MASS_VALUES)}
    kinds = _shared(parameters.get(MASS_TYPE, HANGING), len(systems), f"{location}.{MASS_TYPE}")
    masses = _masses(parameters.get(MASS_VALUES), len(systems), f"{location}.{MASS_VALUES}")
    known = {key for models in systems.values() for model in models.values() for key in field_types(model)}
    places: dict[str, str] = {}
    for (name, models), kind, (mass_location, values) in zip(systems.items(), kinds, masses, strict=True):
        system = _system(models, kind, f"{location}.{MASS_TYPE}")
        fits = {key: value for key, value in beside.items() if key in system.keys or key not in known}
        own[name] = system.said | fits | {"blocks": _blocks(values)}
        places |= {f"{location}.{name}.blocks": mass_location, f"{location}.{name}": location}
    light: dict[str, Plain] = {name: {} for name in field_types(cls) if name == "pulley" and name not in own}
    return CanonicalParameters({**own, **light}, places)


def _blocks(masses: list[Plain]) -> Plain:
    return [{"mass": mass} for mass in masses]


def _shared(value: Plain, count: int, location: str) -> list[str]:
    """Return a kind for each of `count` systems of blocks, from one word for all or a list with one for each."""
    words = value if isinstance(value, list) else [value] * count
    if len(words) != count:
        raise SceneError(location, f"it has {len(words)} members for {count} systems", "give one word, or one for each")
    for word in words:
        if not isinstance(word, str):
            raise SceneError(location, f"it is {quote_value(word)}, not a word", f"write {HANGING}, or a kind")
    return [str(word) for word in words]


def _masses(value: Plain, count: int, location: str) -> list[tuple[str, list[Plain]]]:
    """Return the masses of each of `count` systems of blocks with their path in the file, from numbers or lists."""
    if not isinstance(value, list):
        problem = "it is missing" if value is None else f"it is {quote_value(value)}, not a list"
        raise SceneError(location, problem, "list the masses in kg, as [10] or [2.0, 3.0]")
    if count == 1:
        return [(location, value)]
    if len(value) != count:
        problem = f"it has {len(value)} members for {count} systems"
        raise SceneError(location, problem, "give each its mass or a list of masses, as [1.0, [2.0, 3.0]]")
    return [(f"{location}[{i}]", one if isinstance(one, list) else [one]) for i, one in enumerate(value)]


class _System(NamedTuple):
    """The kind of a system of blocks as written in a file, and its keys."""

    said: dict[str, Plain]
    keys: Collection[str]


def _system(models: dict[str, type[Model]], word: str, location: str) -> _System:
    kind = "hanging" if word == HANGING else snake(word)
    if kind not in models:
        raise SceneError(
            location, f"there is no type {quote_value(word)} here", f"give it one of: {HANGING}, {', '.join(models)}"
        )
    return _System({"kind": kind} if len(models) > 1 else {}, field_types(models[kind]))
