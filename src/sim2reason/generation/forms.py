"""From a question that passed to the problem that a mode makes of it: as it is, with further parts, or with options."""

from collections import Counter
from dataclasses import replace

import numpy as np

from sim2reason.generation.certified import CertifiedQuestion
from sim2reason.generation.distractors import ENOUGH, distractors
from sim2reason.generation.item import Answer
from sim2reason.generation.options import options, options_of_two
from sim2reason.generation.part_search import PartSearch
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.questions import QuestionMode
from sim2reason.questions.difficulty import Difficulty

FEW_OPTIONS = "options: too few wrong answers"


def formed(
    found: CertifiedQuestion,
    search: QuestionSearch,
    mode: QuestionMode,
    difficulty: Difficulty,
    rng: np.random.Generator,
    refused: Counter[str],
    name: str,
) -> CertifiedQuestion | None:
    """Return the problem of a mode; None where the scene offers none, which is counted in `refused`.

    The order of options hangs on the `name` alone.
    """
    if mode.several:
        return PartSearch(search, mode, difficulty, rng, refused).around(found)
    if not mode.offers_options:
        return found
    question = found.question
    answer = Answer(value=question.answer, unit=question.unit, sign=question.sign, tolerance=found.candidate.tolerance)
    if found.candidate.kind.names_one:
        chosen = options_of_two(answer, distractors(found.candidate, found.description), name)
    else:
        chosen = options(answer, distractors(found.candidate, found.description, ENOUGH), name)
    if chosen is None:
        refused[FEW_OPTIONS] += 1
        return None
    return replace(found, options=chosen)
