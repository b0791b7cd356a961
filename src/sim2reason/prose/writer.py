"""From a scene to its text: which wording, in which order, in whose voice."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from sim2reason.dsl.body import Body
from sim2reason.dsl.builder import Builder
from sim2reason.dsl.connection import Connection
from sim2reason.dsl.entity import Part, parts_at
from sim2reason.dsl.model import field_types, lookup
from sim2reason.dsl.scene import Scene
from sim2reason.dsl.template import (
    COUNT_WORDS,
    Each,
    PartLines,
    Role,
    Saying,
    Slot,
    Topic,
    Wordings,
    role_of,
    slots,
    topic_of,
    wordings,
)
from sim2reason.errors import SceneError
from sim2reason.prose.closings import closings
from sim2reason.prose.naming import Names, letters
from sim2reason.prose.phrases import BODIES, alike, canonical, paragraphs, resolved
from sim2reason.prose.tables import table
from sim2reason.prose.terms import Terms
from sim2reason.prose.voices import Voice, VoiceName, numeric, voice_of

TABLE_FROM = 3  # like bodies; two are always prose


@dataclass(frozen=True)
class Description:
    """A scene in words: its sentences in order, and what bodies and numbers are called in them."""

    scene: Scene
    sentences: tuple[str, ...]
    names: Names
    symbols: dict[str, str]
    roles: Mapping[str, Role] = field(default_factory=dict[str, Role])  # of sentences that are no mere facts
    told: tuple[str, ...] = ()  # the addresses of all numbers that are told, in the order of telling
    seed: int = 0
    voice: Voice = numeric
    without: frozenset[Topic] = frozenset()  # topics on which it says nothing
    dry: "Writer | None" = field(default=None, compare=False, repr=False)  # of the first pass, if it is known

    @property
    def text(self) -> str:
        """The sentences as one paragraph; a table stands on lines of its own."""
        return paragraphs(self.sentences)

    def role(self, sentence: str) -> Role:
        """What one of the sentences does in the text."""
        return self.roles.get(sentence, "fact")

    def voiced(self, voice: Voice) -> "Description":
        """The same sentences in another voice."""
        return self._written(voice, self.without)

    def leaving_out(self, topics: Collection[Topic]) -> "Description":
        """The same sentences without those on some topics."""
        return self._written(self.voice, topics) if topics else self

    def _written(self, voice: Voice, without: Collection[Topic]) -> "Description":
        """Written again: the first pass depends on nothing but the scene and the seed."""
        dry = self.dry if self.dry is not None else draft(self.scene, self.seed)[1]
        return written(dry, self.seed, voice, without)

    def mention(self, address: str) -> str:
        """How the text speaks of a body; SceneError for one that it does not mention."""
        if address not in self.scene.bodies:
            raise SceneError(address, "the text mentions no such body", "ask about one that it mentions")
        return self.names.mention(address, self.scene.bodies[address])


def describe(
    scene: Scene,
    seed: int = 0,
    voice: Voice | VoiceName = numeric,
    without: Collection[Topic] = (),
    *,
    hide: Collection[str] = (),
) -> Description:
    """The text of a scene; wordings depend on `seed` alone, so that all voices say the same sentences.

    `voice` is ``numeric``, ``symbolic``, or a function; of the numbers at the addresses in `hide` symbols are said. A
    first pass finds the order of mention, from which follow the letters; a second one writes, `without` what it is
    to leave out.

    Raises:
        SceneError: an address to hide at which no number is told.
    """
    return written(draft(scene, seed)[1], seed, voice_of(scene.parameters, voice, hide), without)


def written(dry: "Writer", seed: int = 0, voice: Voice = numeric, without: Collection[Topic] = ()) -> Description:
    """The second pass, after one by `dry`."""
    scene = dry.scene
    names = Names(letters(dry.introduced, scene.bodies), dry.names.nouns)
    final = Writer(scene, names, np.random.default_rng([seed, 2]), voice, tuple(dry.told), without)
    said, order, left_out = tuple(final.sentences()), tuple(final.told), frozenset(without)
    return Description(scene, said, names, final.symbols, final.roles, order, seed, voice, left_out, dry)


def draft(scene: Scene, seed: int = 0) -> "tuple[list[str], Writer]":
    """The sentences of the first pass, hardly longer than those of the text, and who wrote them."""
    nouns = _nouns(scene, np.random.default_rng([seed, 1]))
    writer = Writer(scene, Names(nouns=nouns), np.random.default_rng([seed, 2]), numeric)
    return writer.sentences(), writer


def _nouns(scene: Scene, rng: np.random.Generator) -> dict[type[Body], str]:
    """One noun for each class of bodies, the first one twice as often as any other."""
    classes = sorted({type(body) for body in scene.bodies.values()}, key=lambda held: held.__name__)
    return {held: held.nouns[max(0, int(rng.integers(-1, len(held.nouns))))] for held in classes}


class Writer(Terms):
    """Renders the sentences of one scene in one voice, remembering who was introduced."""

    def __init__(
        self,
        scene: Scene,
        names: Names,
        rng: np.random.Generator,
        voice: Voice,
        order: tuple[str, ...] = (),
        without: Collection[Topic] = (),
    ) -> None:
        """Nothing is introduced yet; `order` is that in which a first pass told the numbers.

        Sentences on topics that it is `without` stay unsaid.
        """
        super().__init__(scene, names, voice, order)
        self._rng, self._without = rng, without
        self.roles: dict[str, Role] = {}
        self._finished: list[str] = []

    @property
    def builder(self) -> Builder:
        """Where sites are, and which way strings must leave them."""
        return self.scene.builder

    def sentences(self) -> list[str]:
        """All sentences: for each string the lines of its new entities, then the string; last what holds for all."""
        told: list[str] = []
        done: set[str] = set()
        for name in self._string_order():
            joint = self.scene.joints[name]
            for entity in dict.fromkeys(stop.owner.split(".")[0] for stop in joint.stops):
                told.extend(self._lines(entity, done))
            if name.split(".")[0] not in done:  # connections inside entities are told with their lines
                told.append(self.finish(joint.describe(self)))
        for named in self.scene.entities:
            told.extend(self._lines(named.name, done))
        told.extend(self._closings())
        return told

    def _string_order(self) -> list[str]:
        """Connections, each after one that shares an entity with it, so that no tale begins twice."""
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
        """The lines of an entity, once: its parts' first, then its own, then the connections inside it."""
        if name in done:
            return []
        done.add(name)
        entity = self.scene.entity(name)
        told = self._part_lines(entity, name)
        for joint in self.scene.joints.values():
            if joint.name.startswith(f"{name}."):
                told.append(self.finish(joint.describe(self)))
        return told

    def _part_lines(self, part: Part, address: str) -> list[str]:
        placed = {saying.field for saying in part.says if isinstance(saying, PartLines)}
        first = [PartLines(field) for field in type(part).model_fields if field not in placed]
        return [line for saying in (*first, *part.says) for line in self._say(saying, part, address)]

    def _say(self, saying: Saying, part: Part, address: str) -> list[str]:
        if isinstance(saying, PartLines):
            inner = parts_at(part, saying.field).items()
            return [line for path, held in inner for line in self._part_lines(held, f"{address}.{path}")]
        template = self.choose(wordings(saying))
        if not isinstance(saying, Each):
            said = topic_of(saying) not in self._without and self.says_line(saying, template, part)
            return [self._as(role_of(saying), self.finish(self.render(template, address)))] if said else []
        members = getattr(part, saying.field)
        where = [f"{address}.{saying.field}.{index}" for index in range(len(members))]
        if len(members) >= TABLE_FROM and isinstance(members[0], Body) and alike(members):
            self.introduced.update(dict.fromkeys(where))
            return table(self, saying.table, where, members)
        return [self.finish(self.render(template.replace(".*", f".{index}"), address)) for index in range(len(members))]

    def says_line(self, saying: Saying, template: str, part: Part) -> bool:
        """Whether a line is said in one of its wordings: one on several members only where there are several."""
        several = saying.several if isinstance(saying, Wordings) else ""
        return (not several or len(getattr(part, several)) > 1) and self.is_said(template, part)

    def is_said(self, template: str, part: Part) -> bool:
        """Whether a sentence is said: not if it needs something absent, or a number that a word has told."""
        for slot in slots(template):
            if slot.kind != "path" or "*" in slot.path:
                continue
            word = type(part).words.get(slot.path)
            held = resolved(part, word.parameter if word is not None else slot.path)
            if held is None:
                return False
            if word is not None:
                continue
            owner, _, name = slot.path.rpartition(".")
            if not owner and type(part).told_by_word(name, held):
                return False
            body = resolved(part, owner) if owner else part
            if isinstance(body, Body) and name in field_types(type(body)) and body.told_by_word(name):
                return False
        return True

    def _closings(self) -> list[str]:
        """What holds for all; a g that is a symbol is named, not said to equal itself."""
        told: list[str] = []
        for found in closings(self.scene):
            if found.topic in self._without:
                self.pass_over(found.wordings)
                continue
            sentence = self.render(self.choose(found.wordings), "")
            said = self.render(found.of_symbol, "") if "g = $g$" in sentence else sentence
            told.append(self._as(found.role, self.finish(said)))
        return told

    def _as(self, role: Role, sentence: str) -> str:
        """A sentence whose role is kept."""
        if role != "fact":
            self.roles[sentence] = role
        return sentence

    def choose(self, options: tuple[str, ...]) -> str:
        """One of several wordings; always one draw, so that all voices stay in step."""
        return options[int(self._rng.random() * len(options))]

    def pass_over(self, options: tuple[str, ...]) -> None:
        """A sentence that is left out; one draw all the same, so that what follows is said as it is with it."""
        self.choose(options)

    def finish(self, sentence: str) -> str:
        """A rendered sentence with its capital."""
        self._finished.append(sentence[:1].upper() + sentence[1:])
        return self._finished[-1]

    @property
    def finished(self) -> tuple[str, ...]:
        """All earlier sentences."""
        return tuple(self._finished)

    def render(self, template: str, address: str, *, start: bool = True) -> str:
        """A template of the entity or part at `address`, introducing bodies at their first mention.

        Inside a sentence it is no `start`: there a body that is known goes by its letter alone.
        """
        text = ""
        for slot in slots(template):
            text += self._slot(slot, address, start=start and not text)
        return text

    def _slot(self, slot: Slot, address: str, *, start: bool) -> str:
        if slot.kind == "text":
            return slot.text
        part = self.scene.value(address) if address else self.scene
        if slot.kind in ("agree", "some", "count"):
            count = len(resolved(part, slot.path))
            return COUNT_WORDS[count] if slot.kind == "count" else self.render(slot.form(count), address, start=start)
        if slot.kind == "plural":
            members = resolved(part, slot.path)
            return f"{self.names.noun(members[0])}s" if alike(members) else BODIES
        if slot.kind == "member":
            return self.introduce(f"{address}.{slot.text}.{resolved(part, slot.path)}", start=start)
        return self._named(slot, part, address, start=start)

    def _named(self, slot: Slot, part: Any, address: str, *, start: bool) -> str:
        """What stands for a name in a template: a word, a choice, a number or a body."""
        words = type(part).words if isinstance(part, Part | Connection) else {}
        if slot.path in words:
            word = words[slot.path]
            return self.word(word, lookup(part, word.parameter), lambda inner: self.render(inner, address, start=start))
        if isinstance(choice := resolved(part, slot.path), str):
            return choice
        where = canonical(part, slot.path)
        return self.at(f"{address}.{where}" if address else where, start=start)
