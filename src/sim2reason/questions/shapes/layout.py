"""Shapes that differ in the order of the parts of a problem, and the division of a prompt into sentences."""

import re
from collections.abc import Iterator, Sequence

import numpy as np

from sim2reason.questions.shapes import Draft, PromptShape, shape
from sim2reason.text.prose.closings import REST_SENTENCES, TAUT, is_assumption, is_single_body
from sim2reason.text.prose.description import Description
from sim2reason.text.prose.phrases import paragraphs

_END = re.compile(r"(?:(?<=[.?])|(?<=[.?]\)))\s+(?=[A-Z(])")
MAX_QUESTION_SENTENCES = 2  # greatest number of sentences of a question
ASKS = re.compile(r"(?:What|How|By how much|Find|Determine|Calculate)\b")


def units(text: str) -> list[str]:
    """Split a text into its sentences and tables, in order."""
    parts: list[str] = []
    for block in re.split(r"\n\n+", text.strip()):
        parts.extend([f"\n\n{block}\n\n"] if is_table(block) else _END.split(block.strip()))
    return [unit for unit in parts if unit]


def is_table(text: str) -> bool:
    """Return whether a piece of a prompt is a table in Markdown rather than a sentence."""
    return text.lstrip().startswith("|")


def join_units(parts: Sequence[str]) -> str:
    """Return sentences and tables joined into one text."""
    return paragraphs(parts)


def iter_splits(parts: Sequence[str]) -> Iterator[tuple[list[str], str]]:
    """Yield splits of a prompt into the story and the question at its end, of one sentence or more."""
    for count in range(1, min(MAX_QUESTION_SENTENCES, len(parts) - 1) + 1):
        if not any(map(is_table, parts[-count:])):
            yield list(parts[:-count]), join_units(parts[-count:])


def begins_plainly(question: str) -> bool:
    """Return whether a question begins with an interrogative or imperative word, so that a clause can precede it."""
    return ASKS.match(question) is not None


def lower_initial(sentence: str) -> str:
    """Return a sentence without its initial capital, for use after a clause; letters that name bodies stay."""
    return sentence if re.match(r"[A-Z]\b(?! [a-z])", sentence) else sentence[0].lower() + sentence[1:]


def raise_initial(sentence: str) -> str:
    """Return a sentence with an initial capital."""
    return sentence[:1].upper() + sentence[1:]


def one_of(options: Sequence[str], rng: np.random.Generator) -> str:
    """Return one of several wordings, with exactly one random draw."""
    return options[int(rng.random() * len(options))]


def without_assumptions(parts: Sequence[str]) -> tuple[list[str], list[str]]:
    """Return a story without its closing general assumptions, and those assumptions."""
    count = len(parts)
    while count and is_assumption(parts[count - 1]):
        count -= 1
    return list(parts[:count]), list(parts[count:])


def assumptions(description: Description) -> list[str]:
    """Return the closing general assumptions of a text."""
    sentences = list(description.sentences)
    count = len(sentences)
    while count and description.role(sentences[count - 1]) == "assumption":
        count -= 1
    return sentences[count:]


@shape
class AssumptionsInBracket(PromptShape):
    """Assumptions in brackets: “How far apart are the pucks at t = 0.71 s? (All collisions are elastic.)”."""

    name = "assumptions_in_bracket"
    share = 0.85

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Return the prompt for a text that ends with general assumptions; None for others."""
        del rng
        closings = assumptions(description)
        facts = description.sentences[: len(description.sentences) - len(closings)]
        return join_units([*facts, question, f"({join_units(closings)})"]) if closings and facts else None

    def drafts(self, text: str) -> Iterator[Draft]:
        """Yield drafts of the usual order, with the bracketed assumptions moved from the end to before the question."""
        before, opens, inside = text.removesuffix(".)").rpartition(" (")
        if not (opens and text.endswith(".)")):
            return
        for story, question in iter_splits(units(before)):
            yield Draft(join_units([*story, f"{inside}."]), question)


@shape
class AssumptionsLast(PromptShape):
    """Assumptions at the end: “How fast is block A moving? Friction at pulleys is negligible. Take g = 9.8 m/s².”."""

    name = "assumptions_last"

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Return the prompt for a text that ends with general assumptions; None for others."""
        del rng
        facts, closings = without_assumptions(description.sentences)
        return join_units([*facts, question, *closings]) if closings and facts else None

    def drafts(self, text: str) -> Iterator[Draft]:
        """Yield drafts of the usual order, with the closing assumptions moved from the end to before the question."""
        remaining, closings = without_assumptions(units(text))
        for story, question in iter_splits(remaining) if closings else ():
            yield Draft(join_units([*story, *closings]), question)


GRAVITY_SENTENCES = (
    "Take g = {g} here.",
    "In this problem g = {g}.",
    "The acceleration of free fall is taken as g = {g}.",
    "Let the acceleration of free fall be g = {g}.",
    "Take the acceleration of free fall as g = {g}.",
)
USUAL_GRAVITY_SENTENCE = "Take g = {g}."
_TOLD = re.compile(r"\bg = (\S.{0,20})\.$")
_FRONT = re.compile("|".join(re.escape(front).replace(r"\{g\}", r"(\S.{0,20}?)") for front in GRAVITY_SENTENCES))


@shape
class GravityFirst(PromptShape):
    """The value of g first: “Take g = 9.8 m/s² here. Block A lies on …”."""

    name = "gravity_first"

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Return the prompt for a text that ends with the value of g; None for others."""
        front, *facts = one_of(GRAVITY_SENTENCES, rng), *description.sentences[:-1]
        match = _TOLD.search(description.sentences[-1])
        if match is None or description.role(description.sentences[-1]) != "assumption":
            return None
        return join_units([front.replace("{g}", match[1]), *facts, question])

    def drafts(self, text: str) -> Iterator[Draft]:
        """Yield drafts of the usual order, with the value of g moved from the front to the end of the scene's text."""
        first, *rest = units(text)
        match = _FRONT.fullmatch(first)
        number = next(filter(None, match.groups()), "") if match else ""
        for story, question in iter_splits(rest) if number else ():
            yield Draft(join_units([*story, USUAL_GRAVITY_SENTENCE.replace("{g}", number)]), question)


LABELS = (
    ("Situation: ", "Question: "),
    ("Set-up: ", "Task: "),
    ("Given: ", "Asked: "),
    ("Description: ", "Question: "),
)


@shape
class Labelled(PromptShape):
    """Labelled parts: “Situation: Block A lies on …” and, in a paragraph of its own, “Question: how fast …?”."""

    name = "labelled"
    share = 0.3

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Return the prompt, which suits every text."""
        scene, question_label = LABELS[int(rng.random() * len(LABELS))]
        return f"{scene}{description.text}\n\n{question_label}{question}"

    def drafts(self, text: str) -> Iterator[Draft]:
        """Yield the draft whose scene and question are the texts after their labels."""
        for scene, question_label in LABELS:
            story, heading, question = text.rpartition(f"\n\n{question_label}")
            if heading and story.startswith(scene):
                yield Draft(story.removeprefix(scene), question)


PARAGRAPH_BREAK = "\n\n"


@shape
class QuestionApart(PromptShape):
    """The usual order, with the question in a paragraph of its own."""

    name = "question_apart"
    share = 0.8

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Return the text with the question as its own paragraph; None after a table, which ends with an empty line."""
        del rng
        return None if is_table(description.sentences[-1]) else f"{description.text}{PARAGRAPH_BREAK}{question}"

    def drafts(self, text: str) -> Iterator[Draft]:
        """Yield the draft whose question is the last paragraph of the text."""
        story, between, question = text.rpartition(PARAGRAPH_BREAK)
        if between:
            yield Draft(story, question)


@shape
class SceneFirst(PromptShape):
    """The usual order: the scene with its general assumptions, then the question."""

    name = "scene_first"
    marked = False

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Return the prompt, which suits every text."""
        del rng
        return join_units([*description.sentences, question])

    def drafts(self, text: str) -> Iterator[Draft]:
        """Yield one draft with the last sentence as its question, and one with the last two sentences."""
        for story, question in iter_splits(units(text)):
            yield Draft(join_units(story), question)


CLAUSES = (
    "If the motion starts from rest{taut}, ",
    "Assuming that the motion starts from rest{taut}, ",
    "Given that the motion starts from rest{taut}, ",
)
RELEASE_ALL_CLAUSE = "If everything is released from rest{taut}, "
_TAUT = "|".join(re.escape(taut) for taut in sorted(TAUT, key=len, reverse=True))
_CLAUSE = re.compile(
    "|".join(re.escape(c).replace(r"\{taut\}", f"(?:{_TAUT})") for c in (RELEASE_ALL_CLAUSE, *CLAUSES))
)
_ENDING = re.compile(f"({_TAUT}), $")


@shape
class ReleaseInQuestion(PromptShape):
    """The release in the question: “If everything is released from rest with all strings taut, what is …?”."""

    name = "release_in_question"
    share = 1.5

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Return the prompt for a text whose closing says that everything starts from rest; None for others."""
        rests = [sentence for sentence in description.sentences if sentence in REST_SENTENCES]
        clause = one_of(CLAUSES if is_single_body(description.scene) else (RELEASE_ALL_CLAUSE, *CLAUSES), rng)
        again = f" {clause.partition(' ')[0].lower()} " in question  # one condition would hang on another
        if len(rests) != 1 or again or not begins_plainly(question):
            return None
        rest = [sentence for sentence in description.sentences if sentence != rests[0]]
        return join_units([*rest, clause.replace("{taut}", REST_SENTENCES[rests[0]]) + lower_initial(question)])

    def drafts(self, text: str) -> Iterator[Draft]:
        """Yield drafts with the question's clause on the start as a sentence before the scene's closing assumptions."""
        for story, question in iter_splits(units(text)):
            clause = _CLAUSE.match(question)
            if clause is None:
                continue
            taut = ending[1] if (ending := _ENDING.search(clause.group())) else ""
            facts, closings = without_assumptions(story)
            parts = [*facts, f"The motion starts from rest{taut}.", *closings]
            yield Draft(join_units(parts), raise_initial(question[clause.end() :]))


FRONT = "Suppose that "


@shape
class SupposedStart(PromptShape):
    """The initial motion after the scene: “Suppose that cart B is struck and starts off to the left at 0.47 m/s. …”."""

    name = "supposed_start"
    share = 1.2

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Return the prompt for a text whose last sentence before the assumptions states the start; None for others."""
        del rng
        facts, closings = without_assumptions(description.sentences)
        if not facts or description.role(facts[-1]) != "start" or facts[-1] in REST_SENTENCES:
            return None
        return join_units([*facts[:-1], *closings, FRONT + lower_initial(facts[-1]), question])

    def drafts(self, text: str) -> Iterator[Draft]:
        """Yield drafts with the sentence *Suppose that …* as a plain one before the scene's closing assumptions."""
        for story, question in iter_splits(units(text)):
            if story and story[-1].startswith(FRONT):
                facts, closings = without_assumptions(story[:-1])
                yield Draft(join_units([*facts, raise_initial(story[-1].removeprefix(FRONT)), *closings]), question)
