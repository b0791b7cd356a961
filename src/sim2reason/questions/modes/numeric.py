"""The numeric mode: every number is given, and a number is asked for."""

import numpy as np

from sim2reason.questions import KINDS, MODES, Question, Words
from sim2reason.questions.phrasing import chosen
from sim2reason.questions.targets import targets
from sim2reason.simulation.trace import Trace

SHARES = {"state": 0.18, "start": 0.25, "event": 0.35, "time_to_event": 0.22}  # at most 30 % states in the end


def numeric(trace: Trace, words: Words, kind: str, rng: np.random.Generator) -> Question | None:
    """A question of a kind (by default drawn by quota) about a motion, or None if it offers none."""
    asked = kind or _drawn(rng)
    offered = targets(trace.mechanism, words.mentions)
    ask = KINDS[asked].draw(trace, words, offered, rng)
    if ask is None:
        return None
    answer = ask.answer(trace)
    if answer is None or not np.isfinite(answer):
        return None
    noun = next((phrase for phrase, target in offered.items() if target == ask.target), "")
    shapes = KINDS[asked].shapes(ask, words, noun)
    text = chosen(shapes, rng)
    target = ask.target
    sign = target.sense.positive if target is not None and target.sense is not None else ""
    return Question("numeric", ask, text[0].upper() + text[1:], answer, target.unit if target else "s", sign)


def _drawn(rng: np.random.Generator) -> str:
    names = sorted({*KINDS} & {*SHARES})
    weights = np.array([SHARES[name] for name in names])
    return names[int(rng.choice(len(names), p=weights / weights.sum()))]


MODES.add("numeric", numeric)
