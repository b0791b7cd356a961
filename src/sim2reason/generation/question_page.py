"""The page ``docs/questions.md``, written from the registries with an example of each member."""

from collections.abc import Iterator, Mapping

from sim2reason.generation.question_examples import AskedExample, examples, scenes
from sim2reason.questions import KINDS, MOMENTS
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.ordinary.vocabulary import MOTIONS
from sim2reason.questions.ordinary.vocabulary import QUANTITIES as CALLED
from sim2reason.questions.outcomes import OUTCOMES
from sim2reason.scenes.dsl.connection import CONNECTIONS
from sim2reason.scenes.dsl.entity import ENTITIES
from sim2reason.scenes.dsl.measures import show_unit
from sim2reason.scenes.dsl.mechanism import Coordinate
from sim2reason.scenes.files import dump
from sim2reason.scenes.files.schema import summary
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.text.parsing.ordinary.textbook import TEXTBOOK_SCENES

RECORDED = "*recorded in traces, not asked*"
COMMAND = "sim2reason schema --reference -o docs/questions.md"
HEAD = f"""\
# Questions

This page is written by `{COMMAND}`, from the registries of the library. Every example is of a small scene or of one
that a recipe draws; `sim2reason solve SCENE` takes both of its forms, and a file may have either under `question`.

A question has **parts**: what to `find`, `of` what, and `when`.

- `find`: a quantity, what a stretch of the motion adds up to, `time`, `period`, or the address of a number.
- `of`: what the text calls it, or its address; it may be left out where there is only one. Energies and masses are
  added up of `A + B`; `A or B` asks of which of two a quantity is greater, and by what factor.
- `when`: a moment by its name, with its subject before and its number after it; a time, `2 s`; `QUANTITY = VALUE`, the
  first time that it has that value (`QUANTITY of SUBJECT along AXIS = VALUE`, in full); `equilibrium`. `before` after
  a moment is the instant just before it. `time` of `MOMENT or MOMENT` asks which comes first, and how much earlier.
- `along`: a component, by its axis, or by what is positive; `its path`, for a body that moves along one line, and
  `its axle`, for one that turns about one axis.
- `given`: `QUANTITY = VALUE` that a number of the scene makes so; `QUANTITY = greatest`, or `least`. If several values
  of the number do, `QUANTITY = VALUE, least` takes the least of them, `greatest` the greatest.
- `change`: `ADDRESS = VALUE`, `ADDRESS × 2`, `BODY fixed`, or several of these with commas between them: the factor by
  which the change multiplies what is found. `ADDRESS = greatest` or `least` finds the extreme value that it can have,
  `ADDRESS = infinity` or `0` the value that it approaches as a mass grows or vanishes. `STRING removed at 1.5 s`, or
  `removed when` a moment comes, asks about the motion from then on without a string, a spring, a rod, a hand or a
  field, all of which may also be said to be `cut` or `switched off`: times and distances count from then on.
- `compare`: what a `change` tells: the `ratio` to what is found without it, the `difference` from that, or the `value`
  itself, as always after a removal. A number found by `given` is a `value` by default, and may be compared with the one
  of the scene, too.

A **sentence** is one writing of the same. Besides those of the tables, ordinary English is read: *How far does the
block slide before it stops?* A sentence with a word that is not understood, or with two readings whose answers differ,
or one that takes for granted what is not so, is refused, and the nearest questions are offered. `solve` says how a
sentence was read. A motion is followed until what is asked has happened; else the reason is said why it never does.
"""


def format_page() -> str:
    """Return the text of ``docs/questions.md``."""
    return "\n".join([HEAD, *_page()]) + "\n"


def _page() -> Iterator[str]:
    collected = examples()
    yield from _section(
        "Kinds of questions", "kind", {name: summary(type(kind)) for name, kind in KINDS.items()}, collected.kinds
    )
    units = {name: f"{quantity.of.name}, {_unit(quantity.unit)}" for name, quantity in QUANTITIES.items()}
    yield from _section("Quantities", "find", units, collected.quantities, "of, in")
    units = {name: f"{functional.of.name}, {_unit(functional.unit)}" for name, functional in FUNCTIONALS.items()}
    yield from _section("Over a stretch of the motion", "find", units, collected.functionals, "of, in")
    descriptions = {name: summary(cls) for name, cls in MOMENTS.items()}
    yield from _section("Moments", "when", descriptions, collected.moments)
    yield from _section("Outcomes", "when", {name: summary(cls) for name, cls in OUTCOMES.items()}, collected.outcomes)
    yield from _synonyms()
    yield from _textbook_scenes()
    yield from _coordinates()
    yield from _connections()


def _section(
    title: str,
    key: str,
    descriptions: Mapping[str, str],
    example_by_name: Mapping[str, AskedExample],
    what: str = "what",
) -> Iterator[str]:
    """Yield the lines of a table of a registry's members, each with its example if there is one."""
    yield from (f"## {title}", "", f"| `{key}` | {what} | in words | in parts |", "| --- | --- | --- | --- |")
    for name in sorted(descriptions):
        example = example_by_name.get(name, AskedExample("", ""))
        parts = f"`{example.parts}`" if example.parts else ""
        sentence = example.sentence or RECORDED
        yield f"| {name.replace('_', ' ')} | {_cell(descriptions[name])} | {_cell(sentence)} | {_cell(parts)} |"
    yield ""


def _cell(text: str) -> str:
    return text.replace("|", "\\|")


def _unit(unit: str) -> str:
    return show_unit(unit) or "a number"


def _synonyms() -> Iterator[str]:
    """Yield the lines of a table of ordinary English nouns and verbs for quantities and motions."""
    yield from ("## Words of ordinary English", "", "| what | how it may be called |", "| --- | --- |")
    for name, row in CALLED.items():
        yield f"| {name} | {', '.join(row.split('|'))} |"
    for name, row in MOTIONS.items():
        yield f"| to {name} | {', '.join(row.split())} |"
    yield ""


def _textbook_scenes() -> Iterator[str]:
    """Yield the lines of a list of scene kinds that are parsed in textbook language."""
    yield "## Scenes in the words of textbooks"
    yield ""
    yield "`sim2reason.parse_scene` reads the library's own texts, and these scenes in ordinary words, such as:"
    yield ""
    yield "> A 2 kg block is released from rest at the top of a frictionless incline of 30 degrees."
    yield ""
    yield "A text with words that it can't account for is refused; the error names facts that are missing."
    yield ""
    yield from (f"- {scene.summary}" for scene in TEXTBOOK_SCENES.values())
    yield ""


def _coordinates() -> Iterator[str]:
    """Yield the lines of a table of the coordinates in the columns of `trace.state.q`, by class of entity."""
    yield "## Coordinates of a trace"
    yield ""
    yield "`trace.state.q[:, n]` is the coordinate `scene.mechanism.coordinates[n]`, counted from where it starts, and"
    yield "`trace.state.v[:, n]` its rate. A slide counts metres along its axis, a hinge radians about it; the first of"
    yield "each class of entities in those scenes shows its own. `z` points up."
    yield from ("", "| entity | coordinate | counts | axis |", "| --- | --- | --- | --- |")
    rows_by_class: dict[str, list[str]] = {}
    for scene in scenes():
        for named in scene.entities:
            cls = type(named.entity).__name__
            own = [c for c in scene.mechanism.coordinates if c.name.startswith(f"{named.name}.")]
            rows = [f"| {cls} | {c.name.removeprefix(f'{named.name}.')} | {_counts(c)} | {_axis(c)} |" for c in own]
            rows_by_class[cls] = rows_by_class.get(cls) or rows
    yield from (row for rows in rows_by_class.values() for row in rows)
    none = sorted(cls.__name__ for cls in ENTITIES.values() if rows_by_class.get(cls.__name__) == [])
    yield from ("", f"Of their own these have none: {', '.join(none)}.", "")


def _counts(coordinate: Coordinate) -> str:
    return "m" if coordinate.kind == "slide" else "rad"


def _axis(coordinate: Coordinate) -> str:
    return f"({', '.join(f'{part + 0.0:.3g}' for part in coordinate.axis)})"


def _connections() -> Iterator[str]:
    """Yield the lines of an example of each connection, as a scene file states the connection."""
    yield from ("## Connections", "")
    for name in CONNECTIONS:
        lines = next((excerpt for scene in scenes() if (excerpt := _of_connection(dump(scene), name))), list[str]())
        yield from (f"### `{name}`", "", "```yaml", "connections:", *lines, "```", "")


def _of_connection(text: str, name: str) -> list[str]:
    """Return the lines of the first connection of a kind in a scene file; none if the file has no such connection."""
    lines = text.splitlines()
    start = next((n for n, line in enumerate(lines) if line.strip().startswith(f"- {name}:")), None)
    if start is None:
        return []
    indent = len(lines[start]) - len(lines[start].lstrip())
    ends = (n for n in range(start + 1, len(lines)) if not lines[n].startswith(" " * (indent + 1)))
    return [line[indent:] for line in lines[start : next(ends, len(lines))]]
