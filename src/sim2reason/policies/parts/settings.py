"""Settings in a YAML file: read strictly, bounded, and refused in one line."""

# PyYAML's stubs leave nodes and events untyped:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from collections.abc import Hashable
from pathlib import Path
from typing import Any, Final, cast

from yaml import AliasEvent, MappingNode, Node, SafeLoader, YAMLError, load

from sim2reason.errors import EvaluationError

__all__ = ["settings_in"]

MAX_BYTES: Final = 2**20


class _Plain(SafeLoader):
    """No aliases, which could stand for more than fits in memory, and no key twice."""

    def compose_node(self, parent: Node | None, index: Any) -> Node | None:  # noqa: ANN401 - the library's own
        if self.check_event(AliasEvent):
            raise YAMLError("an alias; write the value itself")
        return super().compose_node(parent, index)

    def construct_mapping(self, node: MappingNode, deep: bool = False) -> dict[Hashable, Any]:  # noqa: FBT001, FBT002
        names = [getattr(key, "value", None) for key, _ in node.value]
        if twice := sorted({str(name) for name in names if names.count(name) > 1}):
            raise YAMLError(f"{twice[0]!r} stands twice in one place")
        return super().construct_mapping(node, deep)


def settings_in(path: Path) -> dict[str, object]:
    """What a YAML file says; EvaluationError, which repeats nothing but names of settings, if it is no mapping."""
    with path.open("rb") as file:
        content = file.read(MAX_BYTES + 1)
    if len(content) > MAX_BYTES:
        raise EvaluationError(f"{path}: more than {MAX_BYTES} bytes; a configuration is shorter")
    try:
        found = load(content.decode(), _Plain)  # noqa: S506 - a SafeLoader
    except (YAMLError, UnicodeDecodeError, RecursionError, ValueError) as error:
        mark = getattr(error, "problem_mark", None)
        line = f", line {mark.line + 1}" if mark is not None else ""
        why = " ".join(str(getattr(error, "problem", None) or error).split())[:120]
        raise EvaluationError(f"{path}{line}: this is not YAML that we read: {why}") from None
    if not isinstance(found, dict) or not all(isinstance(key, str) for key in cast("dict[object, object]", found)):
        raise EvaluationError(f"{path}: holds no settings; write NAME: VALUE in each line")
    return cast("dict[str, object]", found)
