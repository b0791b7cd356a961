"""Prompts read back: which scene and which question a text means."""

import re
from dataclasses import dataclass

import numpy as np

from sim2reason.errors import TextError
from sim2reason.parsing import ParsedScene, parse_scene
from sim2reason.questions import KINDS, Query, Study, Words
from sim2reason.questions.parse_question import parse_question
from sim2reason.questions.prompt import FORMATS, WHOLE
from sim2reason.simulation.scenes import simulate

_UNIT = r"(\S{1,12})"
_FORMS = [
    *(re.compile(r"\s" + re.escape(form.format(unit="UNIT")).replace("UNIT", _UNIT) + "$") for form in FORMATS),
    *(re.compile(rf"\s{re.escape(form)}()$") for form in WHOLE),  # in no unit
]


@dataclass(frozen=True)
class ParsedPrompt:
    """What a prompt means: a scene, its motion, what is asked of it, and the unit of the answer."""

    reading: ParsedScene
    study: Study
    query: Query
    unit: str

    @property
    def answer(self) -> float | None:
        """The answer that the text alone leads to."""
        return KINDS[self.query.kind].answer(self.query, self.study)


def parse_prompt(text: str, rng: np.random.Generator | None = None) -> ParsedPrompt:
    """Read a prompt: its scene is rebuilt from the words alone, hidden numbers drawn by `rng`, and simulated.

    Raises:
        TextError: the text means no scene, more than one, or asks nothing that this library asks.
    """
    form = next((match for pattern in _FORMS if (match := pattern.search(text))), None)
    if form is None:
        raise TextError("prompt", "its last sentence does not say how to answer", "end it with one of the known forms")
    parts = _split(text[: form.start()])
    if parts is None:
        raise TextError("prompt", "there is no question after the scene", "ask one in a sentence of its own")
    story, question = parts
    reading = parse_scene(story, rng)
    study = Study(reading.scene, simulate(reading.scene))
    words = Words.of(reading.scene, reading.mentions)
    query = parse_question(question, study, words)
    if query is None:
        raise TextError("prompt", f"no question is asked by {question!r}", "ask in the words of the library")
    return ParsedPrompt(reading, study, query, form[1])


def _split(text: str) -> tuple[str, str] | None:
    """The story, and the last sentence; a sentence begins with a capital after a full stop or a table."""
    starts = [match.end() for match in re.finditer(r"(?<=[.\n])\s+(?=[A-Z])", text)]
    return (text[: starts[-1]].rstrip(), text[starts[-1] :]) if starts else None
