"""The numeric mode: every number is given, and a number is asked for."""

import numpy as np

from sim2reason.questions import KINDS, MODES, Kind, Question, Study, Words
from sim2reason.questions.phrasing import chosen, sentence
from sim2reason.questions.targets import targets


def numeric(study: Study, words: Words, kind: str, rng: np.random.Generator) -> Question | None:
    """A question of a kind (by default any, drawn by share) about a motion, or None if it offers none."""
    found = (_asked(asked, study, words, rng) for asked in ([KINDS[kind]] if kind else _by_share(rng)))
    return next((question for question in found if question is not None), None)


def _asked(asked: Kind, study: Study, words: Words, rng: np.random.Generator) -> Question | None:
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


def _by_share(rng: np.random.Generator) -> list[Kind]:
    """All kinds, each the next one by its share among those that are left: most motions offer only some."""
    kinds = list(KINDS.values())
    shares = np.array([kind.share for kind in kinds])
    order = rng.choice(len(kinds), size=len(kinds), replace=False, p=shares / shares.sum())
    return [kinds[number] for number in order.tolist()]


MODES.add("numeric", numeric)
