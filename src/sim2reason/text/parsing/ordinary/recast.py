"""Rewriting of a text in ordinary English into equivalent sentences of the library."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice, product

from sim2reason.scenes.dsl.model import field_types
from sim2reason.scenes.dsl.scene import World
from sim2reason.text.parsing.ordinary.content import Content, Form, content, reworded
from sim2reason.text.parsing.ordinary.nearest import MAX_SENTENCE_LENGTH, equivalent_forms, fill_form
from sim2reason.text.parsing.ordinary.vocabulary import NOUNS
from sim2reason.text.prose.closings import CLOSINGS, RESTS, is_assumption

CHOICES = 4  # forms of a sentence that are tried
MAX_TEXTS = 24  # rewritten texts that are tried
FIRST_LETTER = "A"
LAST = 1.0  # relative position of the last sentence of a text
PRESUMED = re.compile("g|start with .*taut|room|.*pulleys? and room.*|room on faces")
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

    said: tuple[str, ...]
    from_rest: bool
    added: tuple[str, ...] = ()

    @property
    def is_complete(self) -> bool:
        """Return whether the added sentences include the start from rest, if the original text states this start."""
        return not self.from_rest or any(name.startswith("rest") for name in self.added)

    def adding(self, name: str) -> "RewrittenText | None":
        """Return the text with a named closing sentence added; None if the original neither states nor presumes it."""
        if not (PRESUMED.fullmatch(name) or (self.from_rest and name.startswith("rest"))):
            return None
        found = next(closing for closing in CLOSINGS if closing.name == name)
        measure = field_types(World)["gravity"].measure
        usual = measure.say(World().gravity) if measure is not None else ""
        told = found.wordings[0].replace("{world.gravity}", usual)
        later = [index for index, sentence in enumerate(self.said) if _comes_after(sentence, name)]
        at = later[0] if later else len(self.said)
        said = (*self.said[:at], told[:1].upper() + told[1:], *self.said[at:])
        return RewrittenText(said, self.from_rest, (*self.added, name))


def first_unknown_sentence(said: Sequence[str]) -> int | None:
    """Return the index of the first sentence without an equivalent form in the library; None if all have one."""
    return next((index for index, sentence in enumerate(_unlettered(said)) if _forms(sentence) is None), None)


def recast(said: Sequence[str]) -> Iterator[RewrittenText]:
    """Yield equivalent texts in the library's sentences, in the order of the text and in the usual order."""
    found = [_forms(sentence) for sentence in _unlettered(said)]
    if not all(each is not None for each in found):
        return
    clauses = [clause for each in found for clause in each or ()]
    nouns = frozenset[str]().union(*(content(sentence).facts & NOUNS for sentence in said))
    told = [_of_these(clause, nouns)[:CHOICES] for clause in clauses if clause]
    for chosen in islice(product(*told), MAX_TEXTS):
        from_rest = len(told) < len(clauses)
        yield RewrittenText(tuple(text for text, _ in chosen), from_rest)
        usual = sorted(chosen, key=lambda each: each[1])
        if usual != list(chosen):
            yield RewrittenText(tuple(text for text, _ in usual), from_rest)


def _of_these(told: list[tuple[str, float]], nouns: frozenset[str]) -> list[tuple[str, float]]:
    """Return the library's sentences that name only bodies of the text, or all of them if each names other bodies."""
    return [each for each in told if nouns.issuperset(content(each[0]).facts & NOUNS)] or told


def _unlettered(said: Sequence[str]) -> Sequence[str]:
    """Return the sentences without the letter A, as in *block A*, if it is the only letter of a body."""
    if max(map(len, said)) > MAX_SENTENCE_LENGTH or {
        letter for sentence in said for letter in content(sentence).letters
    } != {FIRST_LETTER}:
        return said
    return [re.sub(rf"(?<=[a-z]) {FIRST_LETTER}\b", "", sentence) for sentence in said]


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
        found = [_known(part) for part in parts]
        if all(each is not None for each in found):
            return [each for each in found if each is not None]
    return None


def _known(sentence: str) -> list[tuple[str, float]] | None:
    """Return the library's sentences for a clause of the user's text, each with its usual relative position.

    None means that the library has no sentence for the clause; the list is empty for *it starts from rest*.
    """
    forms = equivalent_forms(sentence)
    if any(form.text in RESTS for form in forms):
        return []
    said = content(sentence)
    lettered = dict.fromkeys(form.content.letters for form in forms)
    first = [next(form for form in forms if form.content.letters == letters) for letters in sorted(lettered)]
    told = [(_lettered(fill_form(form, said), form, said), form.place) for form in dict.fromkeys((*first, *forms))]
    usual = reworded(sentence)
    return ([(usual, LAST / 2)] if usual else told) or None


def _lettered(text: str, form: Form, said: Content) -> str:
    """Return a library sentence; its only letter of a body is replaced by A if the user's sentence has none."""
    if said.letters or len(form.content.letters) != 1:
        return text
    return re.sub(rf"\b{form.content.letters[0]}\b", FIRST_LETTER, text, count=1)


def _splits(sentence: str) -> Iterator[list[str]]:
    """Yield the two halves of a sentence for each *and* or comma where it can be split; none if it is too long."""
    if len(sentence) > MAX_SENTENCE_LENGTH:
        return
    if _RELEASED_SOMEWHERE.search(sentence):
        yield [_RELEASED_SOMEWHERE.sub(" is", sentence, count=1), _REST]
        held = _RELEASED_WITH.fullmatch(sentence)
        if held is not None:
            yield [f"The {held[1]} is at {held[2]}", _REST]
    for found in _APART.finditer(sentence):
        rest = sentence[found.end() :]
        rest = f"It {rest}" if _ENDS.match(rest) else rest
        yield [f"{sentence[: found.start()]}.", rest[:1].upper() + rest[1:]]
