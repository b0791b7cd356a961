"""The numeric mode: every number is given, and a number is asked for."""

import numpy as np

from sim2reason.questions import KINDS, MODES, Kind, Question, Study, Words
from sim2reason.questions.phrasing import chosen, sentence
from sim2reason.questions.targets import targets


def numeric(study: Study, words: Words, kind: str, rng: np.random.Generator) -> Question | None:
    """A question of a kind (by default drawn by share) about a motion, or None if it offers none."""
    asked = KINDS[kind] if kind else _drawn(rng)
    offered = targets(words)
    query = asked.draw(study, words, offered, rng)
    if query is None:
        return None
    answer = asked.answer(query, study)
    if answer is None or not np.isfinite(answer):
        return None
    target = query.target
    shapes = asked.shapes(query, words, offered[target] if target is not None else None)
    sign = target.sense.positive if target is not None and target.sense is not None else ""
    unit = words.units.spell(asked.measured(query).unit)
    return Question("numeric", query, sentence(chosen(shapes, rng)), answer, unit, sign)


def _drawn(rng: np.random.Generator) -> Kind:
    kinds = list(KINDS.values())
    shares = np.array([kind.share for kind in kinds])
    return kinds[int(rng.choice(len(kinds), p=shares / shares.sum()))]


MODES.add("numeric", numeric)
