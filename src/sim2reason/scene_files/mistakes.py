"""What pydantic finds wrong with foreign numbers, said as the rest of a file's errors are: place, problem, remedy."""

import re
from collections.abc import Mapping
from typing import Any

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from sim2reason.dsl.model import Model
from sim2reason.errors import SceneError
from sim2reason.scene_files.schema import fields, words
from sim2reason.scene_files.yaml_text import shown

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


def explained(cls: type[Model], error: ValidationError, place: str) -> SceneError:
    """The first mistake in a value of `cls` at `place`, and how many more there are."""
    details = error.errors(include_url=False)
    first = details[0]
    where = place + "".join(f"[{step}]" if isinstance(step, int) else f".{step}" for step in first["loc"])
    if first["type"] == "value_error":
        return _own(str(first["msg"]).removeprefix("Value error, "), where)
    more = f" (and {len(details) - 1} more mistakes here)" if len(details) > 1 else ""
    return SceneError(where, _problem(first) + more, _remedy(cls, first))


def _own(message: str, place: str) -> SceneError:
    """A validator's message: it may begin with where, and end with what to do."""
    if found := _SUBPATH.fullmatch(message):
        steps, message = found.groups()
        place += "".join(f"[{step}]" if step.isdigit() else f".{step}" for step in steps.split("."))
    problem, _, remedy = message.partition("; ")
    return SceneError(place, problem, remedy or "mend it")


def _problem(detail: ErrorDetails) -> str:
    context: dict[str, Any] = dict(detail.get("ctx", {}))
    held: Any = detail["input"]
    said = "the list" if isinstance(held, tuple) else shown(held)
    text = PROBLEMS.get(detail["type"])
    return text.format(input=said, **context) if text else f"{said}: {detail['msg'].lower()}"


def _remedy(cls: type[Model], detail: ErrorDetails) -> str:
    if detail["type"] == "string_pattern_mismatch":
        return NAMING
    name = detail["loc"][0] if detail["loc"] else ""
    wanted = next((words(field.schema) for field in fields(cls) if field.name == name), "")
    return f"give {wanted}" if wanted else "mend it"
