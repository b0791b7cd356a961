"""Automatic checks of the English of prompts; a physicist reads the rest.

The default tests read two prompts of each cell, the slow ones more than five hundred, whose words they count.
"""

import re
from collections import Counter
from dataclasses import dataclass
from statistics import median

import pytest

from cells import CELLS
from english import LETTER, NUMBER, STRING, VERB, Prose, digits, introduced, shape
from shared_items import SharedItems
from sim2reason.generation.item import Item

FEW = 2  # of each cell, in the usual tests
ITEMS, MORE = 6, 30  # of each cell, and of those whose sentences are counted: 558 in all
CEILING = {"easy": 250, "medium": 250, "hard": 400}
# words; easy ones had at most 90 until short questions with short answers were no problems any more (filters/few_laws),
# and 95 while the friction of a slope beside a pulley was too long to tell
TARGET = {"easy": (40, 97), "medium": (50, 150), "hard": (100, 250)}
FORMULA = 9  # words; sentences as short as "Take g = 9.8 m/s²." have the shape that they have in every book
MACHINES = ("pulley", "incline", "hybrid")  # in which weight acts, and friction is that of faces
TOLD_SHORT = (*MACHINES, "collision")  # solid bodies and planets take more words to tell
RUB = re.compile(r"[Bb]etween [A-Z] and [A-Z]")  # slabs on each other; what rubs on a plane makes it a rough one
QUOTA = {"what": 0.35, "find": 0.30, "how": 0.15, "determine": 0.12, "calculate": 0.08}


@dataclass(frozen=True)
class Sample:
    item: Item
    prose: Prose


COUNTS = {(recipe, difficulty): MORE if recipe in TOLD_SHORT else ITEMS for recipe, difficulty in CELLS}
BATCHES = [pytest.param(dict.fromkeys(CELLS, FEW), id="few"), pytest.param(COUNTS, id="many", marks=pytest.mark.slow)]
counted = pytest.mark.parametrize("batch", BATCHES[1:], indirect=True)  # with many prompts only


@pytest.fixture(scope="module", params=BATCHES)
def batch(request: pytest.FixtureRequest, numeric_items: SharedItems) -> list[Sample]:
    found = numeric_items.of_all(request.param)
    assert len(found) >= 0.99 * sum(request.param.values())
    return [Sample(item, Prose(item.prompt, item.shape)) for item in found]


def offenders(batch: list[Sample], pattern: str) -> list[str]:
    found = ((re.search(pattern, s.prose.plain), s.prose.plain) for s in batch)
    return [f"{match.group()!r} in {text}" for match, text in found if match]


@pytest.mark.parametrize(
    ("fault", "pattern"),
    [
        ("internal names", r"_(?![^$]*\$)|(?!m[CNT]\b)[a-z][A-Z]|\[|\]|\bentity\b|\bport\b|\bNone\b|\bnan\b"),
        ("zeros of a computer", r"(?<![\d.])0\.0+(?!\d)|\d\.\d*e[+-]?\d"),
        ("punctuation", r"[,;:]\.|,,|\.\.|  |\s[,.;?]|\(\s|\s\)|,;|\?\."),
        ("a hyphen for a minus", r"(?<![\w-])-\d"),
        ("a number without its space", r"\d(?:kg|m|s|N|J)\b"),
        ("a wrong article", r"(?:\ba|(?:^|\. )A) (?:(?!uni)[aeiou]|8|11 |18 )|\b[Aa]n [^aeiou\W]"),
        ("a word twice", r"\b([A-Za-z]+) \1\b"),
        ("stock phrases", r"\b(?:please|consider|following scenario|respectively|unless otherwise)\b|!"),
    ],
)
def test_no_prompt_has(batch: list[Sample], fault: str, pattern: str) -> None:
    assert not offenders(batch, pattern), fault


def test_numbers_have_three_significant_digits_at_most(batch: list[Sample]) -> None:
    assert not [(n, s.prose.body) for s in batch for n in NUMBER.findall(s.prose.body) if digits(n) > 3]


def test_no_sentence_is_said_twice(batch: list[Sample]) -> None:
    twice = [[x for x, n in Counter(s.prose.sentences).items() if n > 1 and "coefficient" not in x] for s in batch]
    assert not [found for found in twice if found]


def test_every_letter_is_introduced_and_used_again(batch: list[Sample]) -> None:
    for sample in batch:
        usual = f"{sample.prose.usual.story} {sample.prose.question}"
        text = re.sub(r"(?<=\d) (?:T|[mµ]?C|N/\(?C\S*)", " of that unit", usual)
        text = text.replace("G = 4π²", "the constant of gravitation is 4π²")
        text = re.sub(r"(^|[.\n] ?)A (?=[a-z])", r"\1a ", text)  # the article that begins a sentence
        letters = set(LETTER.findall(text)) - {"N", "J"}
        for letter in letters:
            assert introduced(letter, text), (letter, text)
        assert letters & set("BCDEFGH") <= set("BCDEFGH"[: len(letters & set("BCDEFGH"))]), text


def test_words_that_tell_of_forces_stand_only_where_they_belong(batch: list[Sample]) -> None:
    for sample in batch:
        text, recipe = sample.prose.plain, sample.item.recipe
        assert not ("light string" in text and recipe == "collision"), text
        assert text.count("g = 9.8") <= 1
        if recipe in MACHINES:
            assert "g = " in text, text
            told = (
                re.search(r"coefficient of friction|friction (?:on|between|have|has)", text, re.IGNORECASE) is not None
            )
            assert told == ("rough" in text or bool(RUB.search(text))), text
            assert "air resistance" not in text


def test_each_string_has_two_ends(batch: list[Sample]) -> None:
    ends = re.compile(
        r"\btied to\b|\bends (?:at|in)\b|\bat its far end\b|\bto\b|\breaches\b|\bjoins\b|\b[Ff]rom\b"
        r"|\b(?:by|on) a light string"
    )
    for sample in batch:
        for sentence in sample.prose.story:
            if STRING.search(sentence):
                several = re.search(r"\bjoins \w+s [A-Z]", sentence)  # blocks A (1.2 kg) and B (2.0 kg)
                assert several or len(ends.findall(sentence)) >= 2, sentence


def test_the_question_is_one_sentence_at_the_end(batch: list[Sample]) -> None:
    for sample in batch:
        question = sample.prose.question
        asks = VERB.findall(question)
        determined = re.match(r"(?:Determine|Find) (?:(?:by )?how|what)\b", question) is not None
        assert len(asks) == 1 + determined, question
        assert question.endswith("?") == (sample.prose.verb in ("what", "how") and not determined), question
        assert not any(VERB.search(sentence) for sentence in sample.prose.story), sample.prose.text


SIGNED = (
    "positive",
    "x component",
    "y component",
    "horizontal displacement",
    "vertical displacement",
    "gain in",
    "upward component",
    "rightward component",
)


def test_signs_are_defined_where_they_matter_and_nowhere_else(batch: list[Sample]) -> None:
    for sample in batch:
        question, item = sample.prose.question, sample.item
        told = any(word in question for word in SIGNED)
        assert told == bool(item.answer.sign), (question, item.answer.sign)
        assert item.answer.sign or item.answer.value > 0.0, question


@counted
@pytest.mark.parametrize("difficulty", list(TARGET))
def test_lengths_keep_to_their_targets(batch: list[Sample], difficulty: str) -> None:
    words = sorted(s.prose.words for s in batch if s.item.difficulty == difficulty and s.item.recipe in TOLD_SHORT)
    low, high = TARGET[difficulty]
    assert low <= median(words) <= high
    assert words[int(0.9 * len(words))] <= 1.2 * high
    assert words[-1] <= CEILING[difficulty]


@counted
def test_no_opening_is_worn_out(batch: list[Sample]) -> None:
    openings = Counter(" ".join(s.prose.plain.split()[:5]) for s in batch)
    opening, count = openings.most_common(1)[0]
    assert count <= 0.05 * len(batch), opening


@counted
@pytest.mark.parametrize("recipe", ["pulley", "incline", "hybrid", "collision"])
def test_no_sentence_shape_is_worn_out(batch: list[Sample], recipe: str) -> None:
    items = [s for s in batch if s.item.recipe == recipe]
    shapes = Counter(found for s in items for found in {shape(x) for x in (*s.prose.story, s.prose.question)})
    shapes = Counter({found: count for found, count in shapes.items() if len(found.split()) > FORMULA})
    found, count = shapes.most_common(1)[0]
    assert count <= 0.15 * len(items), found


@counted
def test_verbs_and_kinds_keep_their_quotas(batch: list[Sample]) -> None:
    verbs = Counter(s.prose.verb for s in batch)
    for verb, share in QUOTA.items():
        assert verbs[verb] / len(batch) == pytest.approx(share, abs=0.09), verbs
    assert sum(s.item.kind == "state" for s in batch) <= 0.3 * len(batch)


@counted
def test_every_shape_of_prompts_has_its_share(batch: list[Sample]) -> None:
    """No shape has more than a quarter of all prompts; `test_shapes` checks the shares within each recipe."""
    shapes = Counter(s.item.shape for s in batch)
    assert len(shapes) >= 6
    assert max(shapes.values()) <= 0.25 * len(batch), shapes
