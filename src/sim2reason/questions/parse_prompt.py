"""Prompts read back: which scene and which question a text means."""

import re
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from sim2reason.errors import TextError
from sim2reason.parsing import ParsedScene, parse_scene
from sim2reason.questions import MODES, Query, Reading, Study, Words
from sim2reason.questions.prompt import FORMATS, PLAIN_FORMATS, WHOLE
from sim2reason.questions.shapes import Draft, shapes_to_try
from sim2reason.questions.spoken_units import in_si, unit_in_si
from sim2reason.simulation.scenes import simulate

_UNIT = r"(\S{1,12})"
_FORMS = [
    *(re.compile(r"\s+" + re.escape(form.format(unit="UNIT")).replace("UNIT", _UNIT) + "$") for form in FORMATS),
    *(re.compile(rf"\s+{re.escape(form)}()$") for form in (*WHOLE, *PLAIN_FORMATS)),  # in no unit
]


@dataclass(frozen=True)
class ParsedPrompt:
    """What a prompt means: a scene, its motion, what is asked of it, the unit of the answer; and the prompt's shape."""

    reading: ParsedScene
    study: Study
    asked: Reading
    unit: str
    shape: str
    size: float = 1.0  # of its unit, in that of the SI

    @property
    def query(self) -> Query:
        """What is asked, or stated as a condition."""
        return self.asked.query

    @property
    def answer(self) -> float | None:
        """The answer that the text alone leads to, in its unit."""
        found = MODES[self.asked.mode].solution(self.asked, self.study, _words(self.reading))
        return found / self.size if found is not None else None


def parse_prompt(text: str, rng: np.random.Generator | None = None) -> ParsedPrompt:
    """Read a prompt: its scene is rebuilt from the words alone, hidden numbers drawn by `rng`, and simulated.

    Raises:
        TextError: the text means no scene, more than one, or asks nothing that this library asks.
    """
    form = next((match for pattern in _FORMS if (match := pattern.search(text))), None)
    if form is None:
        raise TextError("prompt", "its last sentence does not say how to answer", "end it with one of the known forms")
    refused: TextError | None = None
    for told in in_si(text[: form.start()]):
        for shape, draft in _drafts(told):
            try:
                return _understood(draft, form[1], shape, rng)
            except TextError as error:
                refused = error if refused is None or error.place == "prompt" else refused
    raise refused or TextError("prompt", "there is no question after the scene", "ask one in a sentence of its own")


def _drafts(text: str) -> Iterator[tuple[str, Draft]]:
    """All that a prompt may say, by the shape that it would have."""
    for shape in shapes_to_try():
        for draft in shape.drafts(text):
            yield shape.name, draft


def _understood(draft: Draft, unit: str, shape: str, rng: np.random.Generator | None) -> ParsedPrompt:
    """What a draft means; TextError for one that means nothing."""
    reading = parse_scene(draft.story, rng, draft.given)
    study = Study(reading.scene, simulate(reading.scene))
    asked = (mode.parsed(draft.question, study, _words(reading)) for mode in MODES.values())
    found = next((each for each in asked if each is not None), None)
    if found is None:
        raise TextError("prompt", f"no question is asked by {draft.question!r}", "ask in the words of the library")
    return ParsedPrompt(reading, study, found, unit, shape, unit_in_si(unit)[1])


def _words(reading: ParsedScene) -> Words:
    return Words.of(reading.scene, reading.mentions, reading.unknown)
