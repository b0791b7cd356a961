"""Matching of templates against sentences: possible end positions, with the facts that each match states."""

from collections.abc import Iterator, Mapping
from functools import cache

from sim2reason.errors import TextError
from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.connection import Connection
from sim2reason.scenes.dsl.entity import Part
from sim2reason.scenes.dsl.measures import Measure, join_unit
from sim2reason.scenes.dsl.template import COUNT_WORDS, Slot, Word, slots
from sim2reason.text.parsing.parse_state import (
    MAX_MEMBERS,
    NUMBER,
    SYMBOL,
    DeclaredType,
    ParseState,
    canonical_addresses,
    declared_type,
    join_address,
    part_word,
    possible_units,
)
from sim2reason.text.prose.phrases import BODIES, introductions, join_body_names

MAX_STEPS = 200_000
NONE_GIVEN: Mapping[str, str] = {}

Match = tuple[int, ParseState]
"""Where a match ends, and what was read until there."""


@cache
def _fixed(template: str) -> tuple[str, ...]:
    """Return the fixed words of a template between its slots, without their first letters (capitals may differ)."""
    return tuple(slot.text[1:] for slot in slots(template) if slot.kind == "text")


class Matcher:
    """A matcher of templates against the sentences of one text, with a limit on the number of steps."""

    def __init__(self, pieces: tuple[str, ...], given: Mapping[str, str] = NONE_GIVEN) -> None:
        """Store the sentences and tables, and `given`, the values of symbols by their LaTeX."""
        self.pieces = pieces
        self.given = given
        self.reach = 0
        self._steps = 0
        self._fitting: dict[tuple[int, str], bool] = {}

    def sentence(self, place: int, template: str, owner: str, state: ParseState) -> Iterator[ParseState]:
        """Yield the parse states after a template of the part at `owner` matches a whole sentence."""
        if self.contains_fixed_words(place, template):
            text = self.pieces[place]
            for end, then in self.template(text, 0, template, owner, state):
                if end == len(text):
                    self.reach = max(self.reach, place + 1)
                    yield then

    def contains_fixed_words(self, place: int, template: str) -> bool:
        """Return whether all fixed words of a template occur in a sentence; a cheap test before matching."""
        if (place, template) not in self._fitting:
            fits = place < len(self.pieces) and all(words in self.pieces[place] for words in _fixed(template))
            self._fitting[place, template] = fits
        return self._fitting[place, template]

    def literal(self, text: str, at: int, wanted: str) -> int | None:
        """Return the end of `wanted` if it occurs at index `at`, else None; capitals may differ at the start."""
        self._steps += 1
        if self._steps > MAX_STEPS:
            raise TextError("text", "it can be read in too many ways", "give the text of one scene")
        if at == 0:
            wanted = wanted[:1].upper() + wanted[1:]
        return at + len(wanted) if text.startswith(wanted, at) else None

    def template(
        self, text: str, at: int, template: str, owner: str, state: ParseState, *, start: bool = True
    ) -> Iterator[Match]:
        """Yield the matches of a template at index `at`; `start` means that it begins a sentence."""
        yield from self._slots(text, at, slots(template), owner, state, at if start else -1)

    def _slots(
        self, text: str, at: int, rest: tuple[Slot, ...], owner: str, state: ParseState, begin: int
    ) -> Iterator[Match]:
        if not rest:
            yield at, state
            return
        for end, then in self._slot(text, at, rest[0], owner, state, start=at == begin):
            yield from self._slots(text, end, rest[1:], owner, then, begin)

    def _slot(self, text: str, at: int, slot: Slot, owner: str, state: ParseState, *, start: bool) -> Iterator[Match]:
        if slot.kind == "text":
            yield from self._match_literal(text, at, slot.text, state)
        elif slot.kind == "count":
            yield from self._count(text, at, join_address(owner, slot.path), state)
        elif slot.kind == "plural":
            yield from self._plural(text, at, join_address(owner, slot.path), state)
        elif slot.kind in ("agree", "some"):
            yield from self._forms(text, at, slot, owner, state, start=start)
        elif slot.kind == "member":
            yield from self._member(text, at, slot, owner, state, start=start)
        else:
            word = part_word(state, owner, slot.path)
            if word is not None:
                yield from self._word(text, at, word, owner, state, start=start)
                return
            for address, then in canonical_addresses(join_address(owner, slot.path), state):
                yield from self.match_at(text, at, address, then, start=start)

    def _match_literal(self, text: str, at: int, wanted: str, state: ParseState) -> Iterator[Match]:
        end = self.literal(text, at, wanted)
        if end is not None:
            yield end, state

    def _count(self, text: str, at: int, address: str, state: ParseState) -> Iterator[Match]:
        low, high = state.size_range(address)
        for count in range(low, high + 1):
            then = state.with_count(address, count, count)
            if then is not None:
                yield from self._match_literal(text, at, COUNT_WORDS[count], then)

    def _plural(self, text: str, at: int, address: str, state: ParseState) -> Iterator[Match]:
        kinds = [kind for kind in declared_type(state, address).models if issubclass(kind, Body)]
        for kind in kinds:
            for noun in _nouns(kind, state):
                yield from self._match_literal(text, at, f"{noun}s", state.with_noun(kind, noun))
        if len(kinds) > 1:
            yield from self._match_literal(text, at, BODIES, state)

    def _forms(self, text: str, at: int, slot: Slot, owner: str, state: ParseState, *, start: bool) -> Iterator[Match]:
        """Yield the matches of a slot whose text depends on a count: one, two or more members, or none."""
        address, fewest = join_address(owner, slot.path), 1 if slot.kind == "agree" else 0
        several = (
            ((slot.two, 2, 2), (slot.many, 3, MAX_MEMBERS))
            if slot.two != slot.many
            else ((slot.many, fewest + 1, MAX_MEMBERS),)
        )
        for form, low, high in ((slot.one, fewest, fewest), *several):
            then = state.with_count(address, low, high)
            if then is not None:
                yield from self.template(text, at, form, owner, then, start=start)

    def _member(self, text: str, at: int, slot: Slot, owner: str, state: ParseState, *, start: bool) -> Iterator[Match]:
        members = join_address(owner, slot.text)
        for index in range(state.size_range(members)[1]):
            address = f"{members}.{index}"
            then = state.with_value(join_address(owner, slot.path), index)
            if then is not None and address in state.letters:
                yield from self._match_literal(text, at, state.mention(address, full=start), then)

    def match_at(self, text: str, at: int, address: str, state: ParseState, *, start: bool = False) -> Iterator[Match]:
        """Yield the matches of the value at an address: a number, a word, a body or a list of bodies."""
        thing = declared_type(state, address)
        if thing.measure is not None:
            yield from self.number(text, at, address, thing.measure, state)
        elif thing.choices:
            for choice in thing.choices:
                then = state.with_value(address, choice)
                if then is not None:
                    yield from self._match_literal(text, at, choice, then)
        elif thing.word is not None:
            yield from self._word(text, at, thing.word, address.rpartition(".")[0], state)
        elif thing.several:
            yield from self._list(text, at, address, thing, state, start=start)
        else:
            yield from self._mention(text, at, address, thing, state, start=start)

    def number(self, text: str, at: int, address: str, measure: Measure, state: ParseState) -> Iterator[Match]:
        """Yield the matches of a number with its unit, or of a symbol; a contradicting value gives no match."""
        symbol = SYMBOL.match(text, at) if text.startswith("$", at) else None
        if symbol and symbol[1] not in self.given:
            unknown = state.with_value(address, symbol.group())
            if unknown is not None:
                yield symbol.end(), unknown
            return
        source, begin = (self.given.get(symbol[1], ""), 0) if symbol else (text, at)
        match = NUMBER.match(source, begin)
        if match is None:
            return
        for unit, value in possible_units(match.group(), measure.unit):
            end = self.literal(source, match.end(), join_unit("", unit))
            if symbol and end is not None:
                end = symbol.end() if end == len(source) else None
            then = state.with_value(address, value)
            if end is not None and then is not None:
                yield end, then

    def _word(
        self, text: str, at: int, word: Word, owner: str, state: ParseState, *, start: bool = False
    ) -> Iterator[Match]:
        """Yield the matches of a word: a special one, such as *smooth*, fixes a number; the default one fixes none."""
        address = join_address(owner, word.parameter)
        known, choices = state.values.get(address), declared_type(state, address).choices
        if (known is None or known not in word.special) and not (choices and all(c in word.special for c in choices)):
            yield from self._told(text, at, word.otherwise, owner, state, start=start)
        for value, special in word.special.items():
            then = state.with_value(address, value)
            if then is not None:
                yield from self._told(text, at, special, owner, then, start=start)

    def _told(
        self, text: str, at: int, template: str, owner: str, state: ParseState, *, start: bool
    ) -> Iterator[Match]:
        if owner in state.kinds and issubclass(state.kinds[owner], Part | Connection):
            yield from self.template(text, at, template, owner, state, start=start)
        else:
            yield from self._match_body_slot(text, at, slots(template), owner, state)

    def _mention(
        self, text: str, at: int, address: str, thing: DeclaredType, state: ParseState, *, start: bool
    ) -> Iterator[Match]:
        if address in state.letters:
            yield from self._match_literal(text, at, state.mention(address, full=start), state)
        elif state.values.get(address, 0.0) is not None:  # it was not said to be absent
            for kind in thing.models:
                if issubclass(kind, Body):
                    yield from self._introduction(text, at, address, kind, state)

    def _introduction(self, text: str, at: int, address: str, kind: type[Body], state: ParseState) -> Iterator[Match]:
        """Yield the matches of a body's first mention, with the next letter of its series or without a letter."""
        letters = state.next_letters(kind)
        for noun in _nouns(kind, state):
            again = state.knows_noun(noun)
            named = state.with_noun(kind, noun)
            if letters is not None:
                then = named.introduced(address, kind, letters[0])
                for number, template in enumerate(kind.named):
                    yield from self._match_body_slot(text, at, slots(template), address, then.with_choice(number))
            if not state.series(kind):
                then = named.introduced(address, kind, "")
                for number, template in enumerate(introductions(kind, again=again)):
                    yield from self._match_body_slot(text, at, slots(template), address, then.with_choice(number))

    def _match_body_slot(
        self, text: str, at: int, rest: tuple[Slot, ...], address: str, state: ParseState
    ) -> Iterator[Match]:
        if not rest:
            yield at, state
            return
        slot = rest[0]
        if slot.kind == "text":
            matches = self._match_literal(text, at, slot.text, state)
        elif slot.path == "letter":
            matches = self._match_literal(text, at, state.letters[address], state)
        elif slot.path == "noun":
            matches = self._match_literal(text, at, state.nouns[state.body(address)], state)
        else:
            matches = self.match_at(text, at, f"{address}.{slot.path}", state)
        for end, then in matches:
            yield from self._match_body_slot(text, end, rest[1:], address, then)

    def _list(
        self, text: str, at: int, address: str, thing: DeclaredType, state: ParseState, *, start: bool
    ) -> Iterator[Match]:
        """Yield the matches of a list of bodies: one alone, several with the plural noun, known ones by letters."""
        low, high = state.size_range(address)
        one = state.with_count(address, 1, 1)
        if one is not None:
            yield from self.match_at(text, at, f"{address}.0", one, start=start)
        if f"{address}.0" in state.letters:
            if low == high > 1:
                yield from self._known(text, at, [f"{address}.{index}" for index in range(high)], state, start=start)
            return
        for kind in thing.models:
            if issubclass(kind, Body) and kind.listed:
                for noun in _nouns(kind, state):
                    for end, then in self._match_literal(text, at, f"{noun}s ", state.with_noun(kind, noun)):
                        yield from self._items(text, end, address, kind, then, 0)
                    if kind.alike:
                        yield from self._alike(text, at, address, kind, state.with_noun(kind, noun))

    def _alike(self, text: str, at: int, address: str, kind: type[Body], state: ParseState) -> Iterator[Match]:
        """Yield the matches of a new list of bodies with equal numbers: A and B (… each)."""
        low, high = state.size_range(address)
        for count in range(max(low, 2), high + 1):
            members, letters = [f"{address}.{index}" for index in range(count)], state.next_letters(kind, count)
            then = state.with_count(address, count, count)
            if letters is None or then is None:
                continue
            for member, letter in zip(members, letters, strict=True):
                then = then.introduced(member, kind, letter)
            names = join_body_names(state.nouns[kind], letters, full=True)
            for end, named in self._match_literal(text, at, f"{names} ", then):
                for after, described in self._match_body_slot(text, end, slots(kind.alike), members[0], named):
                    shared = described.shared(members, kind.stated_parameters(kind.alike))
                    if shared is not None:
                        yield after, shared

    def _known(self, text: str, at: int, members: list[str], state: ParseState, *, start: bool) -> Iterator[Match]:
        letters = [state.letters[address] for address in members]
        yield from self._match_literal(
            text, at, join_body_names(state.nouns[state.body(members[0])], letters, full=start), state
        )

    def _items(
        self, text: str, at: int, address: str, kind: type[Body], state: ParseState, index: int, *, last: bool = False
    ) -> Iterator[Match]:
        """Yield the matches of the members of a new list from `index` on: A (…), B (…) and C (…)."""
        letters = state.next_letters(kind)
        if letters is None or index >= MAX_MEMBERS:
            return
        here = f"{address}.{index}"
        for end, then in self._match_body_slot(
            text, at, slots(kind.listed), here, state.introduced(here, kind, letters[0])
        ):
            if last:
                counted = then.with_count(address, index + 1, index + 1)
                if counted is not None:
                    yield end, counted
                continue
            for comma, ends in ((", ", False), (" and ", True)):
                for after, again in self._match_literal(text, end, comma, then):
                    yield from self._items(text, after, address, kind, again, index + 1, last=ends)


def _nouns(kind: type[Body], state: ParseState) -> tuple[str, ...]:
    return (state.nouns[kind],) if kind in state.nouns else kind.nouns
