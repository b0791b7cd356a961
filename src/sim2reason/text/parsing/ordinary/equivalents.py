"""The library's sentences that are equivalent or most similar to those of a text in ordinary English."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import islice, product

from sim2reason.scenes.dsl.measures import join_unit
from sim2reason.scenes.dsl.model import field_types
from sim2reason.scenes.dsl.scene import World
from sim2reason.scenes.dsl.units import to_coherent_unit
from sim2reason.text.parsing.ordinary.content import (
    Content,
    Form,
    WrittenNumber,
    content,
    forms,
    reword_textbook_sentence,
)
from sim2reason.text.parsing.ordinary.lexicon import NOUNS
from sim2reason.text.prose.closings import CLOSINGS, REST_SENTENCES, is_assumption

MIN_SIMILARITY = 0.2  # share of common words of two sentences from which one is suggested for the other
MAX_SENTENCE_LENGTH = 600  # characters of a sentence that is compared with the library's
NUMBER_WEIGHT = 1.0  # weight of a number, compared with a word
_SYMBOL = re.compile(r"\$[^$\n]{1,40}\$")


def equivalent_forms(sentence: str) -> list[Form]:
    """Return the library's sentences that say the same as a user's, those with the same letters of bodies first."""
    user_content = content(sentence)
    return sorted(
        (form for form in forms() if _equal(user_content, form)),
        key=lambda form: form.content.letters != user_content.letters,
    )


@cache
def _by_core() -> dict[frozenset[str], list[Form]]:
    forms_by_core: dict[frozenset[str], list[Form]] = {}
    for form in forms():
        forms_by_core.setdefault(_core(form.content), []).append(form)
    return forms_by_core


def _core(sentence_content: Content) -> frozenset[str]:
    """Return the words of a sentence that all equivalent library sentences share, as the key for finding these."""
    return sentence_content.facts - NOUNS - {"rough"}


def find_nearest_form(sentence: str) -> str | None:
    """Return the most similar sentence of the library, with the user's numbers filled in; None if none is similar."""
    if len(sentence) > MAX_SENTENCE_LENGTH:
        return None
    user_content = content(sentence)
    ranked = max(forms(), key=lambda form: _likeness(user_content, form), default=None)
    return (
        fill_form(ranked, user_content)
        if ranked is not None and _likeness(user_content, ranked) >= MIN_SIMILARITY
        else None
    )


def fill_form(form: Form, user_content: Content) -> str:
    """Return a sentence of the library with the numbers of a user's sentence; symbols without a number remain."""
    values = iter(_values(form, user_content))
    return _SYMBOL.sub(lambda symbol: next(values) or symbol[0], form.text)


def _values(form: Form, user_content: Content) -> Iterator[str | None]:
    """Yield, for each number of a library sentence, the user's matching number, or None if several may match.

    Numbers correspond if they are of the same kind, such as two masses, and in order.
    """
    left = list(enumerate(user_content.numbers))
    kinds = [to_coherent_unit(unit)[0] for unit in form.units]
    for index, (unit, kind) in enumerate(zip(form.units, kinds, strict=True)):
        alone = kinds.count(kind) == 1 and sum(number.is_bare == kind for _, number in left) == 1
        chosen = next((each for each in left if each[1].is_bare == kind), None)
        if chosen is None or not (alone or _certain(user_content, chosen[0], form.content, index)):
            yield None
            continue
        left.remove(chosen)
        yield _number_text(chosen[1], unit)


def _certain(user_content: Content, mine: int, other: Content, theirs: int) -> bool:
    """Return whether two numbers certainly correspond: beside the same word, or in a list of bodies."""
    listed = (
        user_content.letters == other.letters or f"#{mine - 1}# #{mine}#" in " ".join(user_content.words) or mine == 0
    )
    return bool(user_content.words_beside(mine) & other.words_beside(theirs)) or (
        listed and any(map(_is_letter, other.words_beside(theirs)))
    )


def _is_letter(word: str) -> bool:
    return len(word) == 1


def _number_text(number: WrittenNumber, unit: str) -> str:
    return join_unit(number.in_unit(unit).replace("-", "\N{MINUS SIGN}"), unit)


def _likeness(user_content: Content, form: Form) -> float:
    mine, other = user_content.facts, form.content.facts
    kinds, units = (
        [number.is_bare for number in user_content.numbers],
        [to_coherent_unit(unit)[0] for unit in form.units],
    )
    shared = _common(kinds, units)
    either = len(mine | other) + NUMBER_WEIGHT * (len(kinds) + len(units) - shared)
    return (len(mine & other) + NUMBER_WEIGHT * shared) / either if either else 0.0


def _common(some: Sequence[str], others: Sequence[str]) -> int:
    return sum(min(some.count(kind), others.count(kind)) for kind in set(some))


def _equal(user_content: Content, form: Form) -> bool:
    """Return whether two sentences are equivalent: same words, same order of bodies, matching numbers."""
    other = form.content
    kinds, units = (
        [number.is_bare for number in user_content.numbers],
        [to_coherent_unit(unit)[0] for unit in form.units],
    )
    if sorted(kinds) != sorted(units) or not (_agree(user_content, other) or _of_one(user_content, other)):
        return False
    if user_content.letters != other.letters and (user_content.letters or not _introduced(form)):
        return False
    return all(kinds.count(kind) == 1 or _in_turn(user_content, other, kinds, units, kind) for kind in set(kinds))


def _agree(user_content: Content, other: Content) -> bool:
    """Return whether two sentences have the same words; *rough* may be missing if the friction is stated."""
    return user_content.facts in (other.facts, other.facts - {"rough"}) and user_content.order == other.order


def _of_one(user_content: Content, other: Content) -> bool:
    """Return whether two sentences have the same words, except for one noun, such as *block*, in only one of them."""
    mine, theirs = user_content.facts & NOUNS, other.facts & NOUNS
    if user_content.letters or other.letters or len(mine) + len(theirs) != 1:
        return False
    without = [tuple(word for word in each.order if word not in NOUNS) for each in (user_content, other)]
    return user_content.facts - mine == other.facts - theirs and without[0] == without[1]


def _introduced(form: Form) -> bool:
    """Return whether each body's letter in a library sentence occurs once, beside a number, which introduces it."""
    beside = {word for index in range(len(form.units)) for word in form.content.words_beside(index)}
    return len(set(form.content.letters)) == len(form.content.letters) and beside.issuperset(form.content.letters)


def _in_turn(user_content: Content, other: Content, kinds: list[str], units: list[str], kind: str) -> bool:
    """Return whether numbers of the same quantity match in order: beside the same words, or letters of bodies."""
    pairs = zip(_of_kind(kinds, kind), _of_kind(units, kind), strict=True)
    return all(_alike(user_content.words_beside(mine), other.words_beside(theirs)) for mine, theirs in pairs)


def _alike(mine: frozenset[str], theirs: frozenset[str]) -> bool:
    return any(map(_is_letter, theirs)) or bool(mine & theirs)


def _of_kind(kinds: list[str], kind: str) -> list[int]:
    return [index for index, other in enumerate(kinds) if other == kind]


MAX_FORMS = 4  # forms of a sentence that are tried
MAX_TEXTS = 24  # rewritten texts that are tried
FIRST_LETTER = "A"
LAST_POSITION = 1.0  # relative position of the last sentence of a text
PRESUMED_CLOSINGS = re.compile("g|start with .*taut|room|.*pulleys? and room.*|room on faces")
"""Closings that people leave out: the usual g, pulleys without friction, strings that are taut, room to move."""

_REST = "It is released from rest."
_RELEASED_SOMEWHERE = re.compile(r"(?: is| are) (?:released|let go) from rest(?= (?:on|at|from|with)\b)")
_RELEASED_WITH = re.compile(r"(?:The|A) \w+ is (?:released|let go) from rest with the (string|rod) at (.*)")
_APART = re.compile(r"(?:;|,? and|, which|, where|,)(?: then)? ")
_SURFACE = r"(?:slope|incline|ramp|hill|plane|floor|table|ground|surface)"
_UNSAYABLE = re.compile(
    rf"\?$|\b(?:kg|g|kilograms?|grams?) {_SURFACE}\b|\b{_SURFACE} (?:of|with) (?:a )?mass\b", re.IGNORECASE
)
"""Sentences that are not translated: questions, and those that give a fixed surface a mass, as if it were a body."""
_ENDS = re.compile(r"^(?:it |they )?(?:is|are) ")


@dataclass(frozen=True, slots=True)
class RewrittenText:
    """A user's text rewritten in the library's sentences, and whether the user's text implies a start from rest."""

    sentences: tuple[str, ...]
    from_rest: bool
    added: tuple[str, ...] = ()

    @property
    def is_complete(self) -> bool:
        """Return whether the added sentences include the start from rest, if the original text states this start."""
        return not self.from_rest or any(name.startswith("rest") for name in self.added)

    def adding(self, name: str) -> "RewrittenText | None":
        """Return the text with a named closing sentence added; None if the original neither states nor presumes it."""
        if not (PRESUMED_CLOSINGS.fullmatch(name) or (self.from_rest and name.startswith("rest"))):
            return None
        named_closing = next(closing for closing in CLOSINGS if closing.name == name)
        measure = field_types(World)["gravity"].measure
        usual = measure.say(World().gravity) if measure is not None else ""
        wording = named_closing.wordings[0].replace("{world.gravity}", usual)
        later = [index for index, sentence in enumerate(self.sentences) if _comes_after(sentence, name)]
        at = later[0] if later else len(self.sentences)
        sentences = (*self.sentences[:at], wording[:1].upper() + wording[1:], *self.sentences[at:])
        return RewrittenText(sentences, self.from_rest, (*self.added, name))


def first_unknown_sentence(sentences: Sequence[str]) -> int | None:
    """Return the index of the first sentence without an equivalent form in the library; None if all have one."""
    return next((index for index, sentence in enumerate(_unlettered(sentences)) if _forms(sentence) is None), None)


def recast_text(sentences: Sequence[str]) -> Iterator[RewrittenText]:
    """Yield equivalent texts in the library's sentences, in the order of the text and in the usual order."""
    sentence_clauses = [_forms(sentence) for sentence in _unlettered(sentences)]
    if not all(each is not None for each in sentence_clauses):
        return
    clauses = [clause for each in sentence_clauses for clause in each or ()]
    nouns = frozenset[str]().union(*(content(sentence).facts & NOUNS for sentence in sentences))
    options = [_of_these(clause, nouns)[:MAX_FORMS] for clause in clauses if clause]
    for chosen in islice(product(*options), MAX_TEXTS):
        from_rest = len(options) < len(clauses)
        yield RewrittenText(tuple(text for text, _ in chosen), from_rest)
        usual = sorted(chosen, key=lambda each: each[1])
        if usual != list(chosen):
            yield RewrittenText(tuple(text for text, _ in usual), from_rest)


def _of_these(options: list[tuple[str, float]], nouns: frozenset[str]) -> list[tuple[str, float]]:
    """Return the library's sentences that name only bodies of the text, or all of them if each names other bodies."""
    return [each for each in options if nouns.issuperset(content(each[0]).facts & NOUNS)] or options


def _unlettered(sentences: Sequence[str]) -> Sequence[str]:
    """Return the sentences without the letter A, as in *block A*, if it is the only letter of a body."""
    if max(map(len, sentences)) > MAX_SENTENCE_LENGTH or {
        letter for sentence in sentences for letter in content(sentence).letters
    } != {FIRST_LETTER}:
        return sentences
    return [re.sub(rf"(?<=[a-z]) {FIRST_LETTER}\b", "", sentence) for sentence in sentences]


def _comes_after(sentence: str, name: str) -> bool:
    """Return whether a sentence belongs after the closing sentence called `name`; *g = …* is always last."""
    last = re.search(r"\bg = ", sentence) is not None
    return is_assumption(sentence) and (last or name.startswith(("rest", "start")))


def _forms(sentence: str) -> list[list[tuple[str, float]]] | None:
    """Return the library's wordings of each clause of a sentence; None if one of the clauses has none."""
    if _UNSAYABLE.search(sentence):
        return None
    known = _known(sentence)
    if known is not None:
        return [known]
    for parts in _splits(sentence):
        wordings = [_known(part) for part in parts]
        if all(each is not None for each in wordings):
            return [each for each in wordings if each is not None]
    return None


def _known(sentence: str) -> list[tuple[str, float]] | None:
    """Return the library's sentences for a clause of the user's text, each with its usual relative position.

    None means that the library has no sentence for the clause; the list is empty for *it starts from rest*.
    """
    forms = equivalent_forms(sentence)
    if any(form.text in REST_SENTENCES for form in forms):
        return []
    user_content = content(sentence)
    lettered = dict.fromkeys(form.content.letters for form in forms)
    first = [next(form for form in forms if form.content.letters == letters) for letters in sorted(lettered)]
    wordings = [
        (_lettered(fill_form(form, user_content), form, user_content), form.position)
        for form in dict.fromkeys((*first, *forms))
    ]
    usual = reword_textbook_sentence(sentence)
    return ([(usual, LAST_POSITION / 2)] if usual else wordings) or None


def _lettered(text: str, form: Form, user_content: Content) -> str:
    """Return a library sentence; its only letter of a body is replaced by A if the user's sentence has none."""
    if user_content.letters or len(form.content.letters) != 1:
        return text
    return re.sub(rf"\b{form.content.letters[0]}\b", FIRST_LETTER, text, count=1)


def _splits(sentence: str) -> Iterator[list[str]]:
    """Yield the two halves of a sentence for each *and* or comma where it can be split; none if it is too long."""
    if len(sentence) > MAX_SENTENCE_LENGTH:
        return
    if _RELEASED_SOMEWHERE.search(sentence):
        yield [_RELEASED_SOMEWHERE.sub(" is", sentence, count=1), _REST]
        released = _RELEASED_WITH.fullmatch(sentence)
        if released is not None:
            yield [f"The {released[1]} is at {released[2]}", _REST]
    for match in _APART.finditer(sentence):
        rest = sentence[match.end() :]
        rest = f"It {rest}" if _ENDS.match(rest) else rest
        yield [f"{sentence[: match.start()]}.", rest[:1].upper() + rest[1:]]
