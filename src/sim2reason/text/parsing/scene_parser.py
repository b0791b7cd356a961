"""Parser of scene texts: all parses of a text, each verified by rendering it again."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

import numpy as np

from sim2reason.errors import SceneError, TextError, UnsupportedError
from sim2reason.scenes.dsl.connection import CONNECTIONS, Connection, Leg, Link, ParsedSentence
from sim2reason.scenes.dsl.entity import ENTITIES, Entity, outer_ports
from sim2reason.scenes.dsl.ports import Pass
from sim2reason.scenes.dsl.scene import MAX_ENTITIES, Scene, World
from sim2reason.scenes.dsl.template import Topic
from sim2reason.text.parsing.equivalence import Signature, signature
from sim2reason.text.parsing.lines import entity_lines, free_legs, may_begin, must_end_at
from sim2reason.text.parsing.matcher import NONE_GIVEN, Matcher
from sim2reason.text.parsing.ordinary.equivalents import find_nearest_form, first_unknown_sentence, recast_text
from sim2reason.text.parsing.ordinary.textbook import LibraryText, find_superfluous_sentence, library_texts
from sim2reason.text.parsing.parse_state import ParsedConnection, ParseState, build_scene
from sim2reason.text.parsing.sentences import MissingClosingError, missing_closings, prove, quoted, split_pieces
from sim2reason.text.prose.closings import CLOSINGS

MAX_READINGS = 200
ASKS = r"\boxed"  # the last sentence of every prompt contains this
IS_PROMPT = "read a text that asks something with sim2reason.parse_prompt"
MAX_PRESUMED_CLOSINGS = 3  # closings that a text in ordinary English may omit
CONNECTION_ENDS = 2  # of a connection
TRIAL_FRACTIONS = 0.6, 0.3, 0.8, 0.1, 0.9, 0.0, 1.0, 1.5, 2.5, 6.0
"""Of the way through the range of an unknown, and on beyond it: where a scene may fit together."""


@dataclass(frozen=True)
class ParsedScene:
    """A scene parsed from a text, with the names in the text.

    Attributes:
        scene: The scene; a number that the text leaves open has some value in its range.
        mentions: Names of bodies in the text, such as *block A*, by address.
        unknown: Symbols, in LaTeX without dollars, of numbers that the text leaves open, by address.
        without: Topics that the text does not cover.
        names: Addresses by name; if bodies without letters share a name, that of the first.
    """

    scene: Scene
    mentions: dict[str, str]
    unknown: dict[str, str] = field(default_factory=dict[str, str])
    without: frozenset[Topic] = frozenset()  # topics on which the text says nothing; its scene has some start then

    def __repr__(self) -> str:
        """Return the scene in one line, with the symbols of unknown numbers."""
        unknown = f", unknown {', '.join(self.unknown.values())}" if self.unknown else ""
        return f"<ParsedScene: {repr(self.scene)[1:-1]}{unknown}>"

    def __str__(self) -> str:
        """Return the scene in several lines, with the names of bodies in the text."""
        return "\n".join([str(self.scene), *(f"  {address} is {name}" for address, name in self.mentions.items())])

    @property
    def names(self) -> dict[str, str]:
        """Return addresses by name; the first body's address if bodies without letters share a name."""
        return {name: address for address, name in reversed(self.mentions.items())}


def parse_scene(
    text: str,
    rng: np.random.Generator | None = None,
    given: Mapping[str, str] = NONE_GIVEN,
    *,
    startless: bool = False,
) -> ParsedScene:
    """Parse a text that describes a scene.

    The text may use the sentences of the library, as written by `describe`, or ordinary English. In ordinary English
    each sentence must have an equivalent sentence of the library, or the whole text must match one of the kinds of
    scenes in ``sim2reason.list("textbook_scenes")``. Parses with equal motions and names count as one.

    Args:
        text: The text, without a question.
        rng: Generator from which numbers are drawn that texts never state; by default one with the seed 0.
        given: Number with its unit for each symbol, in LaTeX without dollars, that the text has in place of a number.
        startless: Whether the text may omit initial positions and velocities, as some questions do.

    Returns:
        The scene with the names of its bodies.

    Raises:
        TextError: The text describes no scene, or several; the message has the nearest sentence of the library.

    Examples:
        >>> import sim2reason
        >>> parsed = sim2reason.parse_scene("A 2 kg block is released from rest on a frictionless 30-degree incline.")
        >>> parsed
        <ParsedScene: Scene 'scene': e1 TwoSideMassPlane>
        >>> parsed.names
        {'the plane': 'e1.plane', 'the block': 'e1.blocks.0'}
    """
    rng = rng if rng is not None else np.random.default_rng(0)
    sentences = split_pieces(text)
    readings = _parse_library_text(sentences, rng, given, startless=startless)
    if len(readings.scenes) == 1:
        return readings.scenes[0]
    plain = readings.stuck_at is not None and not startless and not given
    parsed = _in_ordinary_english(sentences, rng) if plain else None
    if parsed is not None:
        return parsed
    translations = library_texts(text) if plain else []
    parsed_scenes = [
        each for translation in translations if not translation.missing for each in _parsed(translation, rng)
    ]
    if len(parsed_scenes) == 1:
        return parsed_scenes[0]
    stuck = find_superfluous_sentence(sentences) or readings.stuck_at or 0
    raise _sent_on(text, _with_missing(_with_nearest(stuck, sentences), translations) if plain else readings.error())


@dataclass(frozen=True)
class _Parses:
    """The verified parses of a text, and the errors of rejected parses with counts of missing closing sentences."""

    scenes: list[ParsedScene]
    refused_error: list[tuple[int, TextError]]
    matcher: Matcher

    @property
    def missing_closing(self) -> list[str]:
        """Return the names of the closing sentences, such as *rest*, without which parses were rejected."""
        return list(
            dict.fromkeys(error.name for _, error in self.refused_error if isinstance(error, MissingClosingError))
        )

    @property
    def stuck_at(self) -> int | None:
        """Return the index of the first sentence that no parse matches; None if some parse matches all."""
        reach = self.matcher.reach
        return reach if not self.scenes and not self.refused_error and reach < len(self.matcher.pieces) else None

    def error(self) -> TextError:
        """Return the error that explains why there is not exactly one parse."""
        if self.scenes:
            one, other = (_described(reading.scene) for reading in self.scenes[:2])
            return TextError("text", f"it tells two scenes: {one}; or {other}", "say more")
        if self.refused_error:
            return min(self.refused_error, key=lambda each: each[0])[1]  # of the reading of which least is missing
        if self.stuck_at is None:
            return TextError("text", "it ends before all is told", "give the whole text of one scene")
        return _unread(self.stuck_at, self.matcher.pieces[self.stuck_at])


def _in_ordinary_english(sentences: tuple[str, ...], rng: np.random.Generator) -> ParsedScene | None:
    """Return the scene of a text in ordinary English via the library's sentences; None if that fails."""
    for first in recast_text(sentences):
        waiting = [first]
        for rewritten in waiting:  # grows as it is walked through
            readings = _parse_library_text(rewritten.sentences, rng, NONE_GIVEN)
            if len(readings.scenes) == 1 and rewritten.is_complete:
                return readings.scenes[0]
            if len(rewritten.added) < MAX_PRESUMED_CLOSINGS:
                more = (rewritten.adding(name) for name in readings.missing_closing)
                waiting.extend(text for text in more if text is not None and text not in waiting)
    return None


def _parsed(translation: LibraryText, rng: np.random.Generator) -> list[ParsedScene]:
    """Parse a translated text; the list is empty if a number is out of range, such as a slope of 95°."""
    return _parse_library_text(split_pieces(translation.text), rng, NONE_GIVEN).scenes


def _parse_library_text(
    sentences: tuple[str, ...], rng: np.random.Generator, given: Mapping[str, str], *, startless: bool = False
) -> _Parses:
    """Return all parses of a text in the library's own sentences."""
    matcher = Matcher(sentences, given)
    parsed_scenes: dict[Signature, ParsedScene] = {}
    refused: list[tuple[int, TextError]] = []
    states = _Grammar(matcher).scenes(0, ParseState({"world": World}))
    for count, state in enumerate(state for state in states if startless or "start" not in state.without):
        if count == MAX_READINGS:
            raise TextError("text", "it can be read in too many ways", "give the text of one scene")
        for share in TRIAL_FRACTIONS if state.unknowns else TRIAL_FRACTIONS[:1]:
            lacking = 0
            try:
                scene = build_scene(state, rng, share)
                lacking = len(missing_closings(scene, state))
                prove(scene, state, sentences, given)
                parsed_scenes.setdefault(*_read(scene, state))
                break
            except TextError as error:
                refused.append((lacking, error))
            except (SceneError, UnsupportedError, ValueError) as error:
                refused.append((lacking, TextError("text", "it tells a scene that can not be", str(error))))
    return _Parses(list(parsed_scenes.values()), refused, matcher)


def _read(scene: Scene, state: ParseState) -> tuple[Signature, ParsedScene]:
    """Return a verified parse with the signature of its scene, which is equal for equivalent scenes."""
    names = {address: state.mention(address, full=True) for address in state.letters}
    unknown = {path: symbol.strip("$") for path, symbol in state.unknowns.items()}
    return signature(scene, names), ParsedScene(scene, names, unknown, state.without)


def _sent_on(text: str, error: TextError) -> TextError:
    """Return a text's parse error; if the text is a whole prompt, the error recommends `parse_prompt`."""
    return TextError(error.place, error.problem, IS_PROMPT) if ASKS in text else error


def _unread(index: int, sentence: str, near: str | None = None) -> TextError:
    """Return the error for a sentence that does not parse, with the most similar sentence of the library."""
    remedy = f"the nearest that is: {near!r}" if near else "say it in the words of the library, or leave it out"
    return TextError(f"sentence {index + 1}", f"{quoted(sentence)} is not understood", remedy)


def _with_nearest(stuck: int, sentences: tuple[str, ...]) -> TextError:
    """Return the error for an unparsable text; it quotes the first unknown sentence from index `stuck` on."""
    unlike = first_unknown_sentence(sentences[stuck:])
    rewritten = next(recast_text(sentences), None) if unlike is None else None
    if rewritten is not None:
        words = f"in the library's words: {' '.join(rewritten.sentences)}"
        return TextError("text", "its sentences make no scene together", words)
    index = stuck + (unlike or 0)
    return _unread(index, sentences[index], find_nearest_form(sentences[index]))


def _with_missing(error: TextError, translations: list[LibraryText]) -> TextError:
    """Return the error for an unparsable text; if only facts are missing, such as a mass, it names these facts."""
    if not translations or not all(translation.missing for translation in translations):
        return error
    lacks = ", ".join(min((translation.missing for translation in translations), key=len))
    return TextError(error.place, f"the text does not state {lacks}; {error.problem}", error.remedy)


def _described(scene: Scene) -> str:
    """Return the entities of a scene and their connections, in one line."""
    kinds = ", ".join(f"{named.name} a {type(named.entity).__name__}" for named in scene.entities)
    joined = ", ".join("-".join(map(str, connection.links)) for connection in scene.connections)
    return f"{kinds}{' joined by ' if joined else ''}{joined}"


class _Grammar:
    """The parser of the sentences of a text in order: entities with their strings, then closing sentences."""

    def __init__(self, matcher: Matcher) -> None:
        self._matcher = matcher
        self._silent = [kind for kind in ENTITIES.values() if any(self._unheard(ParseState({}), "e", kind))]

    def _unheard(self, state: ParseState, address: str, kind: type[Entity]) -> Iterator[ParseState]:
        """Yield the states with one more entity that has no sentences: only a string's sentence names its bodies."""
        here = state.with_kind(address, kind)._replace(entities=(*state.entities, address))
        for _, then in entity_lines(self._matcher, address, len(self._matcher.pieces), here):
            yield then

    def scenes(self, place: int, state: ParseState) -> Iterator[ParseState]:
        """Yield all parses of the sentences from index `place` on."""
        yield from self._entities(place, state)
        yield from self._strings(place, state)
        yield from self._closings(place, 0, state)

    def _entities(self, place: int, state: ParseState) -> Iterator[ParseState]:
        address = f"e{len(state.entities) + 1}"
        for kind in ENTITIES.values() if len(state.entities) < MAX_ENTITIES else ():
            if not may_begin(self._matcher, kind, place):
                continue
            here = state.with_kind(address, kind)
            here = here._replace(entities=(*state.entities, address), waiting=(*state.waiting, address))
            for after, then in entity_lines(self._matcher, address, place, here):
                if after > place and sum(must_end_at(then, waiting) for waiting in then.waiting) <= CONNECTION_ENDS:
                    yield from self.scenes(after, then)

    def _strings(self, place: int, state: ParseState) -> Iterator[ParseState]:
        for kind in CONNECTIONS.values():
            name = f"{kind.key}_{len(state.joined) + 1}"
            for parsed in kind.parse(name, place, state, self._matcher, self):
                then = _joined_on(name, kind, parsed)
                if then is not None:
                    yield from self.scenes(place + 1, then)

    def _closings(self, place: int, number: int, state: ParseState) -> Iterator[ParseState]:
        """Yield the parses of the closing sentences from number `number` on; each may be present or absent."""
        if place == len(self._matcher.pieces):
            yield state
            return
        for index, closing in enumerate(CLOSINGS[number:], start=number):
            for choice, wording in enumerate(closing.all_wordings):
                if not self._matcher.contains_fixed_words(place, wording):
                    continue
                here = state.with_choice(choice)._replace(closings=(*state.closings, closing.name))
                for then in self._matcher.sentence(place, wording, "", here):
                    yield from self._closings(place + 1, index + 1, then)

    def legs(self, kind: type[Connection], state: ParseState, links: tuple[Link, ...]) -> Iterator[Leg[ParseState]]:
        """Yield ports at which a connection may begin or continue, on parsed entities or new ones without sentences."""
        passed = {link.entity for link in links}
        for address in state.entities:
            if address not in passed:
                yield from free_legs(kind, state, address, first=not links)
        address = f"e{len(state.entities) + 1}"
        for silent in self._silent if len(state.entities) < MAX_ENTITIES else ():
            for then in self._unheard(state, address, silent):
                yield from free_legs(kind, then, address, first=not links)


def _joined_on(name: str, kind: type[Connection], parsed: ParsedSentence[ParseState]) -> ParseState | None:
    """Return the state with a connection added; None if the order of sentences contradicts its direction.

    The Writer renders the sentences of entities in the order of the links, but a string from the end that gives the
    better sentence; if the sentences are in the opposite order, the links are reversed.
    """
    state, links = parsed.state, parsed.links
    on = [link.entity for link in links if link.entity in state.waiting]
    if sorted(on) != sorted(state.waiting):
        return None
    if list(state.waiting) != on:
        if list(state.waiting) != on[::-1]:
            return None
        state = state.renamed(parsed.owned, parsed.owned[::-1])
        links = tuple(_turned(state, link) for link in reversed(links))
    return state._replace(waiting=(), joined=(*state.joined, ParsedConnection(name, kind, links)))


def _turned(state: ParseState, link: Link) -> Link:
    """Return a connection's link to a port for traversal from the connection's other end."""
    passed = isinstance(outer_ports(state.kind(link.entity, Entity))[link.port], Pass)
    return Link(entity=link.entity, port=link.port, flipped=link.flipped != passed)
