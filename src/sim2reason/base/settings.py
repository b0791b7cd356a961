"""Settings from a YAML file: strict parsing, with errors that do not repeat secrets."""

from collections.abc import Callable, Hashable, Iterator, Mapping
from pathlib import Path
from typing import Any, Final, TypeVar, cast, get_args

from pydantic import BaseModel, ValidationError
from yaml import AliasEvent, MappingNode, MarkedYAMLError, Node, SafeLoader, ScalarNode, YAMLError, load

from sim2reason.base.registry import Registry, similar_names
from sim2reason.base.yaml_text import NUMBER, TRUTH
from sim2reason.errors import EvaluationError, Sim2ReasonError, UnknownNameError

__all__ = ["build_each", "build_member", "configuration", "first_fault", "read_settings", "validate_with"]

T = TypeVar("T")


def validate_with(check: Callable[[T], object], value: T) -> T:
    """Return the value if `check` accepts it; for validators, errors of the library become ValueError."""
    try:
        check(value)
    except Sim2ReasonError as error:
        raise ValueError(str(error)) from None
    return value


PROBLEMS: Final = {
    "extra_forbidden": "no such setting",
    "missing": "is missing",
    "greater_than": "must be greater than {gt}",
    "greater_than_equal": "must be at least {ge}",
    "less_than": "must be less than {lt}",
    "less_than_equal": "must be at most {le}",
    "finite_number": "must be a finite number",
    "literal_error": "must be {expected}",
    "too_short": "needs at least {min_length} item(s)",
    "string_too_short": "must have at least {min_length} characters",
    "string_too_long": "must have at most {max_length} characters",
    **dict.fromkeys(("int_type", "int_parsing", "int_from_float"), "must be an integer"),
    **dict.fromkeys(("float_type", "float_parsing"), "must be a number"),
    **dict.fromkeys(("bool_type", "bool_parsing"), "must be true or false"),
    **dict.fromkeys(("string_type", "path_type"), "must be a text"),
    **dict.fromkeys(("list_type", "tuple_type"), "must be a list"),
    **dict.fromkeys(("dict_type", "model_type", "model_attributes_type"), "must be a mapping of names to values"),
}
"""Error messages by pydantic's error type; values of the error's context replace the names in braces."""


def first_fault(error: ValidationError, model: type[BaseModel] | None = None) -> str:
    """Return the first validation error in one line: the setting and its fault.

    With the `model` that was validated, the error for an unknown setting suggests similar or lists all known settings.
    """
    detail = error.errors(include_url=False, include_input=False)[0]
    location = detail["loc"]
    where = ".".join(map(str, location)) or "all of it"
    message = (
        PROBLEMS[detail["type"]].format_map(detail.get("ctx", {})) if detail["type"] in PROBLEMS else detail["msg"]
    )
    known = _settings_at(model, location[:-1]) if detail["type"] == "extra_forbidden" else []
    if known:
        near = similar_names(str(location[-1]).lower(), known)
        message += f"; did you mean: {', '.join(near)}" if near else f"; there are: {', '.join(known)}"
    return f"{where}: {message.removeprefix('Value error, ')}"


def _settings_at(model: type[BaseModel] | None, location: tuple[int | str, ...]) -> list[str]:
    """Return the names of the settings at a location inside a model; none if it leads to no model."""
    for part in location:
        if isinstance(part, str) and model is not None:
            field = model.model_fields.get(part)
            model = None if field is None else next(_models_in(field.annotation), None)
    return [] if model is None else list(model.model_fields)


def _models_in(annotation: object) -> Iterator[type[BaseModel]]:
    """Yield the model classes inside a type such as `Lora | None` or `tuple[HeldOut, ...]`."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield annotation
    for argument in get_args(annotation):
        yield from _models_in(argument)


# PyYAML's stubs leave nodes and events untyped:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false


MAX_BYTES: Final = 2**20
_TEXT: Final = "tag:yaml.org,2002:str"
Fault = type[Sim2ReasonError]
M = TypeVar("M", bound=BaseModel)


class _Plain(SafeLoader):
    """A YAML loader without aliases, duplicate keys, and values that YAML 1.1 and 1.2 read differently.

    YAML 1.1 reads 012 as 10, 1:30 as 90 and *on* as true; such values are refused, as in scene files.
    """

    def compose_node(self, parent: Node | None, index: Any) -> Node | None:  # noqa: ANN401 - the library's own
        if self.check_event(AliasEvent):
            raise YAMLError("an alias; write the value itself")
        return super().compose_node(parent, index)

    def construct_object(self, node: Node, deep: bool = False) -> Any:  # noqa: ANN401, FBT001, FBT002 - the library's own
        if not isinstance(node, ScalarNode) or node.style is not None or not node.value:
            return super().construct_object(node, deep)
        text = node.value
        if text in TRUTH:
            return TRUTH[text]
        if number := NUMBER.fullmatch(text):
            return int(text) if number[1] is None and number[2] is None else float(text)
        if node.tag != _TEXT:
            problem = (
                "a value that readers of YAML differ on; write 12, 0.5, 1.5e-3, true, false, null, or a text in quotes"
            )
            raise MarkedYAMLError(problem=problem, problem_mark=node.start_mark)
        return super().construct_object(node, deep)

    def construct_mapping(self, node: MappingNode, deep: bool = False) -> dict[Hashable, Any]:  # noqa: FBT001, FBT002
        names = [getattr(key, "value", None) for key, _ in node.value]
        if twice := sorted({str(name) for name in names if names.count(name) > 1}):
            raise YAMLError(f"{twice[0]!r} stands twice in one place")
        return super().construct_mapping(node, deep)


def read_settings(path: Path) -> dict[str, object]:
    """Return the mapping in a YAML file; EvaluationError, without contents of the file, if it is not a mapping."""
    with path.open("rb") as file:
        content = file.read(MAX_BYTES + 1)
    if len(content) > MAX_BYTES:
        raise EvaluationError(f"{path}: more than {MAX_BYTES} bytes; a configuration is shorter")
    try:
        mapping = load(content.decode(), _Plain)  # noqa: S506 - a SafeLoader
    except (YAMLError, UnicodeDecodeError, RecursionError, ValueError) as error:
        mark = getattr(error, "problem_mark", None)
        line = f", line {mark.line + 1}" if mark is not None else ""
        why = " ".join(str(getattr(error, "problem", None) or error).split())[:200]
        raise EvaluationError(f"{path}{line}: this is not YAML that we read: {why}") from None
    if not isinstance(mapping, dict) or not all(isinstance(key, str) for key in cast("dict[object, object]", mapping)):
        raise EvaluationError(f"{path}: holds no settings; write NAME: VALUE in each line")
    return cast("dict[str, object]", mapping)


def build_member(registry: Registry[type[M]], settings: Mapping[str, object], location: str, fault: Fault) -> M:
    """Build the member that settings describe: `kind` is its registered name, the rest are its settings.

    Raises:
        Sim2ReasonError: of the class `fault`, a setting that is unknown, missing or makes no sense, with its place.
        UnknownNameError: no such kind; the message begins with the location.
    """
    kind, rest = settings.get("kind"), {key: value for key, value in settings.items() if key != "kind"}
    if not isinstance(kind, str):
        raise fault(f"{location}.kind: give one of {', '.join(registry)}")
    try:
        member = registry[kind]
    except UnknownNameError as error:
        raise UnknownNameError(f"{location}.kind: {error}") from None
    try:
        return member.model_validate(rest)
    except ValidationError as error:
        raise fault(f"{location}.{first_fault(error, member)}") from None


def build_each(given: object, built: Callable[[Mapping[str, object], str], T], location: str) -> object:
    """Return the objects built from each mapping of a list; return any other value unchanged."""
    if not isinstance(given, list):
        return given
    rows = enumerate(cast("list[object]", given))
    return tuple(
        built(cast("Mapping[str, object]", each), f"{location}[{number}]") if isinstance(each, Mapping) else each
        for number, each in rows
    )


def configuration(
    config: Path | str | Mapping[str, object],
    out: Path | None,
    built: Callable[[dict[str, object]], T],
    fault: Fault,
    model: type[BaseModel],
) -> T:
    """Return the object built from a YAML file or from settings; `out` overrides their output folder.

    `model` is the class of settings that `built` validates; errors take the names of settings from it.

    Raises:
        Sim2ReasonError: of the class `fault`, a setting that is unknown, missing or makes no sense; and what `built`
            raises, with the file's name before it.
        EvaluationError: a file that is no YAML.
    """
    prefix = "" if isinstance(config, Mapping) else f"{config}: "
    settings = dict(config) if isinstance(config, Mapping) else read_settings(Path(config))
    if out is not None:
        settings["out"] = out
    try:
        return built(settings)
    except ValidationError as error:
        raise fault(f"{prefix}{first_fault(error, model)}") from None
    except Sim2ReasonError as error:
        error.args = (f"{prefix}{error}", *error.args[1:])
        raise
