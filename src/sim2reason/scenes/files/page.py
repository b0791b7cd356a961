"""Generation of ``docs/scene-format.md`` from the same declarations as the schema."""

from collections.abc import Iterator
from typing import cast

from sim2reason.base.yaml_text import MAX_BYTES, MAX_DEPTH, MAX_NODES
from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.connection import CONNECTIONS
from sim2reason.scenes.dsl.entity import ENTITIES, Entity, Part, outer_ports
from sim2reason.scenes.dsl.measures import show_unit
from sim2reason.scenes.dsl.model import Model, field_types
from sim2reason.scenes.dsl.ports import Attachment, Base, End, Mount, Pass, Port
from sim2reason.scenes.dsl.scene import World
from sim2reason.scenes.files.schema import Field, fields, is_many, snake, summary, words
from sim2reason.scenes.files.sections import directions, own_fields

HEAD = f"""\
# Scene files

This page is written by `sim2reason schema --page -o docs/scene-format.md`; the JSON schema by `sim2reason schema`.

```yaml
scene:
  name: two_sides
  entities:
  - name: fixed
    type: MassWithFixedPulley
    parameters:
      system:
        kind: hanging
        blocks:
        - {{mass: 2.0}}
      pulley: {{mass: 0.0}}
  - name: lower_pulley
    type: MassWithReverseMovablePulley
    parameters:
      pulley: {{mass: 0.5}}
      load: {{mass: 3.0}}
  - {{name: hook, type: FixedSupport}}
  connections:
  - tendon:
    - {{entity: fixed, direction: tail}}
    - {{entity: lower_pulley, direction: left}}
  - tendon:
    - {{entity: lower_pulley, direction: right}}
    - {{entity: hook, direction: end}}
  world: {{gravity: 9.8}}
  glued: []
```

- A scene has a `name`, 1 to 8 `entities`, `connections`, a `world`, and `glued`, the addresses of bodies that are
  welded to what carries them (`fixed.system.blocks.0`). Only `entities` is required.
- Beside the `scene`, a file may say how a problem tells it, under `text`: `wording`, the seed of its text, on which
  names depend; `symbols`, the addresses of numbers for which it says symbols, as of what it asks for; and `without`,
  topics on which it says nothing. `sim2reason figure` then names things as the problem does, and shows no more than it.
- The `type` of an entity is its class, as `FixedSupport` or as `fixed_support`. A part that can be of several kinds
  says its `kind`.
- A `tendon` joins two ends, each an `entity` and a `direction`. A pulley that the string passes is entered once by each
  of its two sides; the pairs that meet there are one string. `connecting_point` tells sides apart whose names a class
  uses twice: `direction: under, connecting_point: left`. What is true of a whole string stands beside one of its pairs.
- Numbers are written plainly, `12`, `0.5` or `1.5e-3`, and words without quotes. Anchors, tags, keys given twice,
  infinities and the other spellings of YAML 1.1 (`yes`, `1_000`, `0x10`, `1:30`, dates) are refused. A file has at most
  {MAX_BYTES} bytes, {MAX_DEPTH} levels and {MAX_NODES} values.
- Three other spellings are read: a `position: [x, y, z]` of an entity, which is for looks only; `mass_type: Mass` (or a
  kind) with `mass_values: [10]` for the blocks of a mass system, the pulley then being light unless it is given; and
  `inner_to_outer` or `outer_to_inner` as the direction of an entity's only open end. A scene may have a title,
  `Pulley System`, for a name.
- What `load` reads, `dump` writes back equal, always in the same bytes.
- Numbers marked *hidden* are never told and matter to no answer: they give the motion room.
"""


def format_page() -> str:
    """Return the text of the page that documents the format of scene files, ``docs/scene-format.md``."""
    return "\n".join([HEAD, *_page()]) + "\n"


def _page() -> Iterator[str]:
    classes: dict[str, type[Model]] = {}
    yield "## Entities"
    for name, cls in ENTITIES.items():
        yield from _section(f"{name} · `{snake(name)}`", cls, classes)
        yield from _ports(cls)
    parts = {name: cls for name, cls in classes.items() if issubclass(cls, Part)}
    for title, chosen in (("Parts", parts), ("Bodies", {n: c for n, c in classes.items() if issubclass(c, Body)})):
        yield f"\n## {title}"
        for name, cls in sorted(chosen.items()):
            yield from _section(name, cls, classes)
    yield "\n## Connections"
    for name, cls in CONNECTIONS.items():
        yield from _section(f"`{name}`", cls, classes, only=own_fields(cls))
    yield "\n## World"
    yield from _table(World, classes)


def _section(
    title: str, cls: type[Model], classes: dict[str, type[Model]], only: list[str] | None = None
) -> Iterator[str]:
    yield f"\n### {title}\n\n{summary(cls)}"
    yield from _table(cls, classes, only)


def _table(cls: type[Model], classes: dict[str, type[Model]], only: list[str] | None = None) -> Iterator[str]:
    """Yield the lines of a table of the fields of a class; add the classes that the fields hold to `classes`."""
    known = [field for field in fields(cls) if only is None or field.name in only]
    if not known:
        return
    yield "\n| parameter | what | unit | valid | default |\n| --- | --- | --- | --- | --- |"
    for field in known:
        cells = (f"`{field.name}`", _what(cls, field, classes), _unit(field), _valid(field), _default(cls, field))
        yield f"| {' | '.join(cells)} |"


def _what(cls: type[Model], field: Field, classes: dict[str, type[Model]]) -> str:
    hidden = ", hidden" if field.hidden else ""
    if field.measure is not None:
        return f"{field.measure.name}, ${field.measure.symbol}${hidden}"
    models = field_types(cls)[field.name].models
    for model in models:
        if model.__name__ not in classes:
            classes[model.__name__] = model
            list(_table(model, classes))  # for the classes that it holds
    if not models:
        return "number of a member, from 0" if field.schema.get("type") == "integer" else ""
    many = is_many(cls.model_fields[field.name].annotation)
    if len(models) == 1:
        name = f"[{models[0].__name__}](#{models[0].__name__.lower()})"
        return f"list of {name}" if many else name
    kinds = " or ".join(f"[`kind: {snake(m.__name__)}`](#{m.__name__.lower()})" for m in models)
    return f"list of {kinds}" if many else kinds


def _unit(field: Field) -> str:
    return (show_unit(field.measure.unit) or "1") if field.measure is not None else ""


def _valid(field: Field) -> str:
    """Return the limits or the allowed words of a field, without facts in other columns."""
    text = words(field.schema)
    return text if text.startswith("one of: ") else text.partition(", ")[2]


def _default(cls: type[Model], field: Field) -> str:
    if field.required:
        return "required"
    default = cast("object", cls.model_fields[field.name].default)
    return "absent" if default is None else "none" if default == () else f"{default!s}"


def _ports(cls: type[Entity]) -> Iterator[str]:
    """Yield the lines of a table of an entity's directions, with the use of each port."""
    ports = outer_ports(cls)
    if not ports:
        return
    yield "\n| direction | port | must be used |\n| --- | --- | --- |"
    for (name, point), (port, _) in directions(cls).items():
        if not point:
            yield f"| `{name}` | {_use(ports[port], port)} | {'yes' if ports[port].required else 'no'} |"


def _use(port: Port, name: str) -> str:
    """Return the page's text on how connections use a port, which depends on the type of the port."""
    match port:
        case Pass():
            return f"side of `{name}`, which a string passes"
        case Mount():
            return "carries another entity, by a pivot or a weld"
        case Base():
            return "is carried, by a pivot or a weld"
        case End():
            return "end of a string, a spring or a rod"
        case Attachment():
            return "end of a spring or a rod"
        case _:
            return "end of a string"
