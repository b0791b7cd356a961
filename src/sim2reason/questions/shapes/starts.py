"""Shapes whose question states the initial motion."""

import re
from collections.abc import Iterator

import numpy as np

from sim2reason.questions.shapes import Draft, PromptShape, shape
from sim2reason.questions.shapes.parts.units import (
    begins_plainly,
    lowered,
    one_of,
    raised,
    splits,
    text_of,
    units,
    without_assumptions,
)
from sim2reason.text.prose.closings import RESTS, TAUT, is_single_body
from sim2reason.text.prose.description import Description

CLAUSES = (
    "If the motion starts from rest{taut}, ",
    "Assuming that the motion starts from rest{taut}, ",
    "Given that the motion starts from rest{taut}, ",
)
ALL = "If everything is released from rest{taut}, "
_TAUT = "|".join(re.escape(taut) for taut in sorted(TAUT, key=len, reverse=True))
_CLAUSE = re.compile("|".join(re.escape(c).replace(r"\{taut\}", f"(?:{_TAUT})") for c in (ALL, *CLAUSES)))
_ENDING = re.compile(f"({_TAUT}), $")


@shape
class ReleaseInQuestion(PromptShape):
    """The release in the question: “If everything is released from rest with all strings taut, what is …?”."""

    name = "release_in_question"
    share = 1.5

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Return the prompt for a text whose closing says that everything starts from rest; None for others."""
        rests = [sentence for sentence in description.sentences if sentence in RESTS]
        clause = one_of(CLAUSES if is_single_body(description.scene) else (ALL, *CLAUSES), rng)
        again = f" {clause.partition(' ')[0].lower()} " in question  # one condition would hang on another
        if len(rests) != 1 or again or not begins_plainly(question):
            return None
        rest = [sentence for sentence in description.sentences if sentence != rests[0]]
        return text_of([*rest, clause.replace("{taut}", RESTS[rests[0]]) + lowered(question)])

    def drafts(self, text: str) -> Iterator[Draft]:
        """Yield drafts with the question's clause on the start as a sentence before the scene's closing assumptions."""
        for story, question in splits(units(text)):
            clause = _CLAUSE.match(question)
            if clause is None:
                continue
            taut = ending[1] if (ending := _ENDING.search(clause.group())) else ""
            facts, closings = without_assumptions(story)
            said = [*facts, f"The motion starts from rest{taut}.", *closings]
            yield Draft(text_of(said), raised(question[clause.end() :]))


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
        if not facts or description.role(facts[-1]) != "start" or facts[-1] in RESTS:
            return None
        return text_of([*facts[:-1], *closings, FRONT + lowered(facts[-1]), question])

    def drafts(self, text: str) -> Iterator[Draft]:
        """Yield drafts with the sentence *Suppose that …* as a plain one before the scene's closing assumptions."""
        for story, question in splits(units(text)):
            if story and story[-1].startswith(FRONT):
                facts, closings = without_assumptions(story[:-1])
                yield Draft(text_of([*facts, raised(story[-1].removeprefix(FRONT)), *closings]), question)
