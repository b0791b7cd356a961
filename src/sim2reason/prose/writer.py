"""From a scene to its text: which wording, in which order, in whose voice."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from sim2reason.dsl.body import Body
from sim2reason.dsl.builder import Builder
from sim2reason.dsl.connection import Connection
from sim2reason.dsl.entity import Part, parts_at
from sim2reason.dsl.model import Parameter, field_types, lookup, parameters
from sim2reason.dsl.scene import Scene
from sim2reason.dsl.template import COUNT_WORDS, Each, PartLines, Saying, Slot, Word, slots, wordings
from sim2reason.errors import SceneError
from sim2reason.prose.closings import closings
from sim2reason.prose.naming import Names, letters, listed, symbols
from sim2reason.prose.phrases import BODIES, alike, another, canonical, join, resolved
from sim2reason.prose.tables import table
from sim2reason.prose.voices import Voice, numeric

FREE_FALL = "The acceleration of free fall is $g$."
TABLE_FROM = 3  # like bodies; two are always prose


@dataclass(frozen=True)
class Description:
    """A scene in words: its sentences in order, and what bodies and numbers are called in them."""

    scene: Scene
    sentences: tuple[str, ...]
    names: Names
    symbols: dict[str, str]

    @property
    def text(self) -> str:
        """The sentences as one paragraph; a table stands on lines of its own."""
        return " ".join(self.sentences).replace(" \n\n", "\n\n").replace("\n\n ", "\n\n").strip()

    def mention(self, address: str) -> str:
        """How the text speaks of a body; SceneError for one that it does not mention."""
        if address not in self.scene.bodies:
            raise SceneError(address, "the text mentions no such body", "ask about one that it mentions")
        return self.names.mention(address, self.scene.bodies[address])


def describe(scene: Scene, seed: int = 0, voice: Voice = numeric) -> Description:
    """The text of a scene; wordings depend on `seed` alone, so that all voices say the same sentences.

    A first pass finds the order of mention, from which follow the letters; a second one writes.
    """
    _, dry = draft(scene, seed)
    names = Names(letters(dry.introduced, scene.bodies), dry.names.nouns)
    final = Writer(scene, names, np.random.default_rng([seed, 2]), voice)
    return Description(scene, tuple(final.sentences()), names, final.symbols)


def draft(scene: Scene, seed: int = 0) -> "tuple[list[str], Writer]":
    """The sentences of the first pass, hardly longer than those of the text, and who wrote them."""
    nouns = _nouns(scene, np.random.default_rng([seed, 1]))
    writer = Writer(scene, Names(nouns=nouns), np.random.default_rng([seed, 2]), numeric)
    return writer.sentences(), writer


def _nouns(scene: Scene, rng: np.random.Generator) -> dict[type[Body], str]:
    """One noun for each class of bodies, the first one twice as often as any other."""
    classes = sorted({type(body) for body in scene.bodies.values()}, key=lambda held: held.__name__)
    return {held: held.nouns[max(0, int(rng.integers(-1, len(held.nouns))))] for held in classes}


class Writer:
    """Renders the sentences of one scene in one voice, remembering who was introduced."""

    def __init__(self, scene: Scene, names: Names, rng: np.random.Generator, voice: Voice) -> None:
        """Nothing is introduced yet."""
        self.scene, self.names, self._rng, self._voice = scene, names, rng, voice
        self.introduced: dict[str, None] = {}
        self._finished: list[str] = []

    @property
    def builder(self) -> Builder:
        """Where sites are, and which way strings must leave them."""
        return self.scene.builder

    @cached_property
    def parameters(self) -> dict[str, Parameter]:
        """Every declared number by address, those of bodies that strings bring included."""
        found = {parameter.path: parameter for parameter in self.scene.parameters}
        for address, body in self.scene.bodies.items():
            found.update({parameter.path: parameter for parameter in parameters(body, address)})
        return found

    @cached_property
    def symbols(self) -> dict[str, str]:
        """The symbol of every number that is neither hidden nor absent nor said by a word."""
        said = [
            p for p in self.parameters.values() if not p.hidden and p.value is not None and not self._by_word(p.path)
        ]
        return symbols(said, self.scene.bodies, self.names)

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
            return [self.finish(self.render(template, address))] if self.is_said(template, part) else []
        members = getattr(part, saying.field)
        where = [f"{address}.{saying.field}.{index}" for index in range(len(members))]
        if len(members) >= TABLE_FROM and isinstance(members[0], Body) and alike(members):
            self.introduced.update(dict.fromkeys(where))
            return table(self, saying.table, where, members)
        return [self.finish(self.render(template.replace(".*", f".{index}"), address)) for index in range(len(members))]

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
        told = [self.finish(self.render(self.choose(found.wordings), "")) for found in closings(self.scene)]
        return [FREE_FALL if "g = $g$" in sentence else sentence for sentence in told]

    def choose(self, options: tuple[str, ...]) -> str:
        """One of several wordings; always one draw, so that all voices stay in step."""
        return options[int(self._rng.random() * len(options))]

    def finish(self, sentence: str) -> str:
        """A rendered sentence with its capital."""
        self._finished.append(sentence[:1].upper() + sentence[1:])
        return self._finished[-1]

    def has_said(self, words: str) -> bool:
        """Whether some words stand in an earlier sentence."""
        return any(words in sentence for sentence in self._finished)

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
            return self._mention(f"{address}.{slot.text}.{resolved(part, slot.path)}", start=start)
        return self._named(slot, part, address, start=start)

    def _named(self, slot: Slot, part: Any, address: str, *, start: bool) -> str:
        """What stands for a name in a template: a word, a choice, a number or a body."""
        words = type(part).words if isinstance(part, Part | Connection) else {}
        if slot.path in words:
            word = words[slot.path]
            return self._word(
                word, lookup(part, word.parameter), lambda inner: self.render(inner, address, start=start)
            )
        if isinstance(choice := resolved(part, slot.path), str):
            return choice
        where = canonical(part, slot.path)
        return self.at(f"{address}.{where}" if address else where, start=start)

    def _word(self, word: Word, value: Any, render: Callable[[str], str]) -> str:
        return render(word.text(value))

    def at(self, address: str, *, start: bool = False) -> str:
        """What the text has for an address: a number, a word of a body, a body, or a list of bodies."""
        if address in self.parameters:
            return self.number(address)
        owner, _, name = address.rpartition(".")
        if owner in self.scene.bodies and name in self.scene.bodies[owner].words:
            body = self.scene.bodies[owner]
            word = body.words[name]
            return self._word(word, getattr(body, word.parameter), lambda inner: self._of_body(inner, owner))
        if address in self.scene.bodies:
            return self._mention(address, start=start)
        members = [found for found in self.scene.bodies if found.rpartition(".")[0] == address]
        return self._list(members, start=start)

    def number(self, address: str) -> str:
        """A number in the voice of this text."""
        parameter = self.parameters[address]
        return self._voice(parameter, self.symbols.get(address, parameter.measure.symbol))

    def _by_word(self, path: str) -> bool:
        owner, _, name = path.rpartition(".")
        body = self.scene.bodies.get(owner)
        return body is not None and body.told_by_word(name)

    def _mention(self, address: str, *, start: bool) -> str:
        body = self.scene.bodies[address]
        if address in self.introduced:
            return self.names.mention(address, body, full=start)
        again = any(self.names.noun(self.scene.bodies[known]) == self.names.noun(body) for known in self.introduced)
        self.introduced[address] = None
        letter = self.names.letters.get(address, "")
        text = self._of_body(self.choose(body.named if letter else body.lone), address)
        return another(text) if again and not letter else text

    def _of_body(self, template: str, address: str) -> str:
        body = self.scene.bodies[address]
        text = ""
        for slot in slots(template):
            if slot.kind == "text":
                text += slot.text
            elif slot.path == "letter":
                text += self.names.letters.get(address, "")
            elif slot.path == "noun":
                text += self.names.noun(body)
            else:
                choice = getattr(body, slot.path, None)
                text += choice if isinstance(choice, str) else self.at(f"{address}.{slot.path}")
        return text

    def _list(self, members: list[str], *, start: bool) -> str:
        if len(members) == 1:
            return self._mention(members[0], start=start)
        noun = self.names.noun(first := self.scene.bodies[members[0]])
        letters = [self.names.letters.get(address, "") for address in members]
        if members[0] in self.introduced:
            return listed(noun, letters, full=start)
        self.introduced.update(dict.fromkeys(members))
        alike = {self._of_body(first.alike, address) for address in members}
        if first.alike and len(alike) == 1:
            return f"{listed(noun, letters, full=True)} {alike.pop()}"
        return f"{noun}s " + join([self._of_body(first.listed, address) for address in members])
