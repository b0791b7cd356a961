"""Search for the library's sentences that are equivalent or most similar to a sentence."""

import re
from collections.abc import Iterator, Sequence
from functools import cache

from sim2reason.scenes.dsl.measures import join_unit
from sim2reason.scenes.dsl.units import coherent
from sim2reason.text.parsing.ordinary.content import Content, Form, WrittenNumber, content, forms
from sim2reason.text.parsing.ordinary.vocabulary import NOUNS

MIN_SIMILARITY = 0.2  # share of common words of two sentences from which one is suggested for the other
MAX_SENTENCE_LENGTH = 600  # characters of a sentence that is compared with the library's
NUMBERS = 1.0  # weight of a number, compared with a word
_SYMBOL = re.compile(r"\$[^$\n]{1,40}\$")


def equivalent_forms(sentence: str) -> list[Form]:
    """Return the library's sentences that say the same as a user's, those with the same letters of bodies first."""
    said = content(sentence)
    return sorted(
        (form for form in forms() if _equal(said, form)), key=lambda form: form.content.letters != said.letters
    )


@cache
def _by_core() -> dict[frozenset[str], list[Form]]:
    found: dict[frozenset[str], list[Form]] = {}
    for form in forms():
        found.setdefault(_core(form.content), []).append(form)
    return found


def _core(said: Content) -> frozenset[str]:
    """Return the words of a sentence that all equivalent library sentences share, as the key for finding these."""
    return said.facts - NOUNS - {"rough"}


def nearest(sentence: str) -> str | None:
    """Return the most similar sentence of the library, with the user's numbers filled in; None if none is similar."""
    if len(sentence) > MAX_SENTENCE_LENGTH:
        return None
    said = content(sentence)
    ranked = max(forms(), key=lambda form: _likeness(said, form), default=None)
    return fill_form(ranked, said) if ranked is not None and _likeness(said, ranked) >= MIN_SIMILARITY else None


def fill_form(form: Form, said: Content) -> str:
    """Return a sentence of the library with the numbers of a user's sentence; symbols without a number remain."""
    values = iter(_values(form, said))
    return _SYMBOL.sub(lambda symbol: next(values) or symbol[0], form.text)


def _values(form: Form, said: Content) -> Iterator[str | None]:
    """Yield, for each number of a library sentence, the user's matching number, or None if several may match.

    Numbers correspond if they are of the same kind, such as two masses, and in order.
    """
    left = list(enumerate(said.numbers))
    kinds = [coherent(unit)[0] for unit in form.units]
    for index, (unit, kind) in enumerate(zip(form.units, kinds, strict=True)):
        alone = kinds.count(kind) == 1 and sum(number.bare == kind for _, number in left) == 1
        chosen = next((each for each in left if each[1].bare == kind), None)
        if chosen is None or not (alone or _certain(said, chosen[0], form.content, index)):
            yield None
            continue
        left.remove(chosen)
        yield _number_text(chosen[1], unit)


def _certain(said: Content, mine: int, other: Content, theirs: int) -> bool:
    """Return whether two numbers certainly correspond: beside the same word, or in a list of bodies."""
    listed = said.letters == other.letters or f"#{mine - 1}# #{mine}#" in " ".join(said.words) or mine == 0
    return bool(said.beside(mine) & other.beside(theirs)) or (listed and any(map(_is_letter, other.beside(theirs))))


def _is_letter(word: str) -> bool:
    return len(word) == 1


def _number_text(number: WrittenNumber, unit: str) -> str:
    return join_unit(number.in_unit(unit).replace("-", "\N{MINUS SIGN}"), unit)


def _likeness(said: Content, form: Form) -> float:
    mine, other = said.facts, form.content.facts
    kinds, units = [number.bare for number in said.numbers], [coherent(unit)[0] for unit in form.units]
    shared = _common(kinds, units)
    either = len(mine | other) + NUMBERS * (len(kinds) + len(units) - shared)
    return (len(mine & other) + NUMBERS * shared) / either if either else 0.0


def _common(some: Sequence[str], others: Sequence[str]) -> int:
    return sum(min(some.count(kind), others.count(kind)) for kind in set(some))


def _equal(said: Content, form: Form) -> bool:
    """Return whether two sentences are equivalent: same words, same order of bodies, matching numbers."""
    other = form.content
    kinds, units = [number.bare for number in said.numbers], [coherent(unit)[0] for unit in form.units]
    if sorted(kinds) != sorted(units) or not (_agree(said, other) or _of_one(said, other)):
        return False
    if said.letters != other.letters and (said.letters or not _introduced(form)):
        return False
    return all(kinds.count(kind) == 1 or _in_turn(said, other, kinds, units, kind) for kind in set(kinds))


def _agree(said: Content, other: Content) -> bool:
    """Return whether two sentences have the same words; *rough* may be missing if the friction is stated."""
    return said.facts in (other.facts, other.facts - {"rough"}) and said.order == other.order


def _of_one(said: Content, other: Content) -> bool:
    """Return whether two sentences have the same words, except for one noun, such as *block*, in only one of them."""
    mine, theirs = said.facts & NOUNS, other.facts & NOUNS
    if said.letters or other.letters or len(mine) + len(theirs) != 1:
        return False
    without = [tuple(word for word in each.order if word not in NOUNS) for each in (said, other)]
    return said.facts - mine == other.facts - theirs and without[0] == without[1]


def _introduced(form: Form) -> bool:
    """Return whether each body's letter in a library sentence occurs once, beside a number, which introduces it."""
    beside = {word for index in range(len(form.units)) for word in form.content.beside(index)}
    return len(set(form.content.letters)) == len(form.content.letters) and beside.issuperset(form.content.letters)


def _in_turn(said: Content, other: Content, kinds: list[str], units: list[str], kind: str) -> bool:
    """Return whether numbers of the same quantity match in order: beside the same words, or letters of bodies."""
    pairs = zip(_of_kind(kinds, kind), _of_kind(units, kind), strict=True)
    return all(_alike(said.beside(mine), other.beside(theirs)) for mine, theirs in pairs)


def _alike(mine: frozenset[str], theirs: frozenset[str]) -> bool:
    return any(map(_is_letter, theirs)) or bool(mine & theirs)


def _of_kind(kinds: list[str], kind: str) -> list[int]:
    return [index for index, found in enumerate(kinds) if found == kind]
