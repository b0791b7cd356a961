"""A scene in words, as whoever reads them needs it: sentences, names and symbols; a first pass finds their order."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field

import numpy as np

from sim2reason.dsl.body import Body
from sim2reason.dsl.scene import Scene
from sim2reason.dsl.template import Role, Topic
from sim2reason.errors import SceneError
from sim2reason.prose.naming import Names, letters
from sim2reason.prose.phrases import paragraphs
from sim2reason.prose.voices import Voice, VoiceName, numeric, voice_of
from sim2reason.prose.writer import Writer
from sim2reason.record import abridged
from sim2reason.scene_files import SceneLike, scene_of


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
    topics: frozenset[Topic] = frozenset()  # those on which it says something
    dry: Writer | None = field(default=None, compare=False, repr=False)  # of the first pass, if it is known

    @property
    def text(self) -> str:
        """The sentences as one paragraph; a table stands on lines of its own."""
        return paragraphs(self.sentences)

    @property
    def symbolic(self) -> tuple[str, ...]:
        """Return the addresses of the numbers that the text gives only as symbols, in its order."""
        own = {p.path: p for p in self.scene.parameters}
        said = [(own[path], self.symbols[path]) for path in self.told if path in own and path in self.symbols]
        return tuple(p.path for p, symbol in said if self.voice(p, symbol) != numeric(p, symbol))

    def __repr__(self) -> str:
        """Return the name of the scene and the beginning of the text."""
        return f"<Description of {self.scene.name!r}: {abridged(self.text)!r}>"

    def __str__(self) -> str:
        """Return the text of the description."""
        return self.text

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
    scene: SceneLike,
    seed: int = 0,
    voice: Voice | VoiceName = numeric,
    without: Collection[Topic] = (),
    *,
    hide: Collection[str] = (),
) -> Description:
    """Describe a scene in words; `seed` alone selects the wordings, so that all voices use the same sentences.

    `voice` is ``numeric``, ``symbolic``, or a function; the numbers at the addresses in `hide` appear as symbols. A
    first pass finds the order of mention, which determines the letters; a second pass writes the text and leaves out
    the topics in `without`.

    Raises:
        TypeError: `scene` is neither a scene nor the path of its file, its text or an item.
        SceneError: `hide` has an address at which the text tells no number.
    """
    scene = scene_of(scene, "describe")
    return written(draft(scene, seed)[1], seed, voice_of(scene.parameters, voice, hide), without)


def written(dry: Writer, seed: int = 0, voice: Voice = numeric, without: Collection[Topic] = ()) -> Description:
    """The second pass, after one by `dry`."""
    scene = dry.scene
    names = Names(letters(dry.introduced, scene.bodies), dry.names.nouns)
    final = Writer(scene, names, np.random.default_rng([seed, 2]), voice, tuple(dry.told), without)
    said, order, left_out = tuple(final.sentences()), tuple(final.told), frozenset(without)
    topics = frozenset(final.topics)
    return Description(scene, said, names, final.symbols, final.roles, order, seed, voice, left_out, topics, dry)


def draft(scene: Scene, seed: int = 0) -> tuple[list[str], Writer]:
    """The sentences of the first pass, hardly longer than those of the text, and who wrote them."""
    nouns = _nouns(scene, np.random.default_rng([seed, 1]))
    writer = Writer(scene, Names(nouns=nouns), np.random.default_rng([seed, 2]), numeric)
    return writer.sentences(), writer


def _nouns(scene: Scene, rng: np.random.Generator) -> dict[type[Body], str]:
    """One noun for each class of bodies, the first one twice as often as any other, and where that suits not all."""
    classes = sorted({type(body) for body in scene.bodies.values()}, key=lambda held: held.__name__)
    drawn = {held: held.nouns[max(0, int(rng.integers(-1, len(held.nouns))))] for held in classes}
    bodies = scene.bodies
    misnamed = {type(body) for body in bodies.values() if not body.suits(drawn[type(body)], bodies)}
    return {held: held.nouns[0] if held in misnamed else noun for held, noun in drawn.items()}
