"""Writer of the sentences of a scene: choice of wordings, order and voice."""

from collections.abc import Collection
from functools import cache
from typing import Any

import numpy as np

from sim2reason.scenes.dsl.addresses import lookup
from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.connection import Connection
from sim2reason.scenes.dsl.entity import Part, field_parts
from sim2reason.scenes.dsl.model import field_types
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.template import (
    COUNT_WORDS,
    Each,
    PartLines,
    Role,
    Saying,
    Slot,
    Topic,
    Wordings,
    line_role,
    line_topic,
    slots,
    wordings,
)
from sim2reason.text.prose.closings import Closing, closings
from sim2reason.text.prose.phrases import (
    BODIES,
    Names,
    canonical_path,
    referenced_object,
    same_class,
    sentence_templates,
    table,
)
from sim2reason.text.prose.voices import Terms, Voice

MIN_TABLE_BODIES = 3  # similar bodies from which on they form a table


class Writer(Terms):
    """A renderer of the sentences of one scene in one voice; it keeps track of introduced bodies."""

    def __init__(
        self,
        scene: Scene,
        names: Names,
        rng: np.random.Generator,
        voice: Voice,
        order: tuple[str, ...] = (),
        without: Collection[Topic] = (),
    ) -> None:
        """Prepare a text; `order` lists the addresses of numbers as a first rendering stated them.

        Sentences on the topics in `without` are omitted.
        """
        super().__init__(scene, names, voice, order)
        self._rng, self._without = rng, without
        self.roles: dict[str, Role] = {}
        self.topics = set[Topic]()  # of what is said
        self._left_out = set[Topic]()  # of lines that are not said
        self._finished: list[str] = []

    @property
    def builder(self) -> Builder:
        """Return the builder of the scene, which knows the points that strings pass and their directions there."""
        return self.scene.builder

    def sentences(self) -> list[str]:
        """Return all sentences: for each string its new entities and the string itself, then the closing sentences."""
        lines: list[str] = []
        done: set[str] = set()
        for name in self._string_order():
            joint = self.scene.joints[name]
            for entity in dict.fromkeys(stop.owner.split(".")[0] for stop in joint.stops):
                lines.extend(self._lines(entity, done))
            if name.split(".")[0] not in done:  # connections inside entities are told with their lines
                lines.append(self.finish(joint.describe(self)))
        for named in self.scene.entities:
            lines.extend(self._lines(named.name, done))
        lines.extend(self._closings())
        return lines

    def _string_order(self) -> list[str]:
        """Return the names of the connections, each after one that shares an entity with it where possible."""
        names = {named.name for named in self.scene.entities}
        waiting = [name for name in self.scene.joints if name.split(".")[0] not in names]
        order: list[str] = []
        reached: set[str] = set()
        while waiting:
            owners = {name: {stop.owner.split(".")[0] for stop in self.scene.joints[name].stops} for name in waiting}
            chosen = next((name for name in waiting if owners[name] & reached), waiting[0])
            waiting.remove(chosen)
            order.append(chosen)
            reached |= owners[chosen]
        return order

    def _lines(self, name: str, done: set[str]) -> list[str]:
        """Return the sentences of an entity on the first call: of its parts, its own, of its inner connections."""
        if name in done:
            return []
        done.add(name)
        entity = self.scene.entity(name)
        lines = self._part_lines(entity, name)
        for joint in self.scene.joints.values():
            if joint.name.startswith(f"{name}."):
                lines.append(self.finish(joint.describe(self)))
        return lines

    def _part_lines(self, part: Part, address: str) -> list[str]:
        sayings = (saying for saying in _sayings(type(part)) if not self._passes_over(saying, part))
        return [line for saying in sayings for line in self._say(saying, part, address)]

    def _passes_over(self, saying: Saying, part: Part) -> bool:
        """Return whether to omit an inapplicable sentence that scenes rarely need, without drawing a wording for it."""
        rare = isinstance(saying, Wordings) and saying.rare
        return rare and not self.says_line(saying, wordings(saying)[0], part)

    def _say(self, saying: Saying, part: Part, address: str) -> list[str]:
        if isinstance(saying, PartLines):
            inner = field_parts(part, saying.field).items()
            return [line for path, inner_part in inner for line in self._part_lines(inner_part, f"{address}.{path}")]
        template = self.choose(sentence_templates(saying, part))
        if not isinstance(saying, Each):
            topic = line_topic(saying)
            if not self.says_line(saying, template, part):
                return []
            if topic is not None and topic in self._without:
                self._left_out.add(topic)
                return []
            return [self._as(line_role(saying), self.finish(self.render(template, address)), topic)]
        members = getattr(part, saying.field)
        where = [f"{address}.{saying.field}.{index}" for index in range(len(members))]
        if len(members) >= MIN_TABLE_BODIES and isinstance(members[0], Body) and same_class(members):
            self.introduced.update(dict.fromkeys(where))
            return table(self, saying.table, where, members)
        return [self.finish(self.render(template.replace(".*", f".{index}"), address)) for index in range(len(members))]

    def says_line(self, saying: Saying, template: str, part: Part) -> bool:
        """Return whether a sentence applies to a part; a sentence about several bodies needs more than one."""
        several = saying.several if isinstance(saying, Wordings) else ""
        return (not several or len(getattr(part, several)) > 1) and self.is_said(template, part)

    def is_said(self, template: str, part: Part) -> bool:
        """Return whether a sentence applies: all values it needs are present, and no word already states its number."""
        for slot in slots(template):
            if slot.kind != "path" or "*" in slot.path:
                continue
            word = type(part).words.get(slot.path)
            value = referenced_object(part, word.parameter if word is not None else slot.path)
            if value is None:
                return False
            if word is not None:
                continue
            owner, _, name = slot.path.rpartition(".")
            if not owner and type(part).is_stated_by_word(name, value):
                return False
            body = referenced_object(part, owner) if owner else part
            if isinstance(body, Body) and name in field_types(type(body)) and body.is_stated_by_word(name):
                return False
        return True

    def _closings(self) -> list[str]:
        """Return the closing sentences; where g is a symbol, one names it instead of *g = g*."""
        lines: list[str] = []
        for closing in closings(self.scene):
            if self.leaves_out(closing):
                self.pass_over(closing.wordings)
                continue
            sentence = self.render(self.choose(closing.wordings), "")
            text = self.render(closing.symbolic_wording, "") if "g = $g$" in sentence else sentence
            lines.append(self._as(closing.role, self.finish(text), closing.topic))
        return lines

    def leaves_out(self, closing: Closing) -> bool:
        """Return whether to omit a closing sentence, because its topic or the description of the start is omitted."""
        return closing.topic in self._without or (closing.role == "start" and "start" in self._left_out)

    def _as(self, role: Role, sentence: str, topic: Topic | None) -> str:
        """Record the role and topic of a sentence, and return the sentence."""
        if topic is not None:
            self.topics.add(topic)
        if role != "fact":
            self.roles[sentence] = role
        return sentence

    def choose(self, options: tuple[str, ...]) -> str:
        """Return a random wording; it always draws once, so that all voices use the same sequence."""
        return options[int(self._rng.random() * len(options))]

    def pass_over(self, options: tuple[str, ...]) -> None:
        """Draw once for an omitted sentence, so that the wordings of later sentences do not change."""
        self.choose(options)

    def finish(self, sentence: str) -> str:
        """Return a rendered sentence with an initial capital."""
        self._finished.append(sentence[:1].upper() + sentence[1:])
        return self._finished[-1]

    @property
    def finished(self) -> tuple[str, ...]:
        """Return all earlier sentences."""
        return tuple(self._finished)

    def render(self, template: str, address: str, *, start: bool = True) -> str:
        """Render a template of the entity or part at `address`, introducing bodies at their first mention.

        Without `start` the template is inside a sentence, where an introduced body is named by its letter alone.
        """
        text, part = "", None
        for slot in slots(template):
            if slot.kind == "text":
                text += slot.text
                continue
            if part is None:
                part = self.scene.value(address) if address else self.scene
            text += self._slot(slot, part, address, start=start and not text)
        return text

    def _slot(self, slot: Slot, part: Any, address: str, *, start: bool) -> str:
        if slot.kind in ("agree", "some", "count"):
            count = len(referenced_object(part, slot.path))
            return COUNT_WORDS[count] if slot.kind == "count" else self.render(slot.form(count), address, start=start)
        if slot.kind == "plural":
            members = referenced_object(part, slot.path)
            return f"{self.names.noun(members[0])}s" if same_class(members) else BODIES
        if slot.kind == "member":
            return self.introduce(f"{address}.{slot.text}.{referenced_object(part, slot.path)}", start=start)
        return self._named(slot, part, address, start=start)

    def _named(self, slot: Slot, part: Any, address: str, *, start: bool) -> str:
        """Return the text of a name in a template: a word, a choice, a number or a body."""
        words = type(part).words if isinstance(part, Part | Connection) else {}
        if slot.path in words:
            word = words[slot.path]
            return self.word(word, lookup(part, word.parameter), lambda inner: self.render(inner, address, start=start))
        if isinstance(choice := referenced_object(part, slot.path), str):
            return choice
        where = canonical_path(part, slot.path)
        return self.at(f"{address}.{where}" if address else where, start=start)


@cache
def _sayings(kind: type[Part]) -> tuple[Saying, ...]:
    """Return the lines that describe a part of a class: first those of the parts in it that have no other place."""
    placed = {saying.field for saying in kind.says if isinstance(saying, PartLines)}
    held = (name for name, field in field_types(kind).items() if field.models and name not in placed)
    return (*map(PartLines, held), *kind.says)
