"""Weights that a sentence names in place of forces, such as *twice its weight*, as numbers with units."""

import re
from dataclasses import replace

import numpy as np

from sim2reason.dsl.scene import Scene
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.questions.ordinary.hearing import Heard
from sim2reason.questions.ordinary.whatif.supposed_rows import MULTIPLES
from sim2reason.questions.words import Words

_MULTIPLE = f"(?P<mult>{'|'.join(MULTIPLES)}|#\\d+# times)"
_WEIGHT = re.compile(
    rf"\b(?P<be>be|is|become|reach|equal|with) (?:just |exactly |only |equal to )*(?:{_MULTIPLE} )?"
    r"(?:(?P<own>@\d+@ 's|its|ball 's) (?:own )?weight|weight of (?P<of>@\d+@|ball))\b"
)
_CHANGES = re.compile(r"\b(?:mass|heavy|heavier|g|gravity)\b")


def with_weights(heard: Heard, scene: Scene, words: Words) -> Heard:
    """Return a sentence with a number in newtons for each weight that it names; none if it asks for a mass or for g."""
    found = _WEIGHT.search(heard.text)
    if found is None or _CHANGES.search(heard.text) or scene.units.spell("N") != "N":
        return heard
    token = re.search(r"@\d+@", found["own"] or found["of"] or "")
    bodies = words.called(Bodies())
    said = heard.subject(token[0]) if token is not None else next(iter(bodies.values())) if len(bodies) == 1 else ""
    name = next((name for name, phrase in bodies.items() if phrase == said), "")
    if not name:
        return heard
    weight = words.mechanism.body[name].mass * float(np.linalg.norm(words.mechanism.gravity))
    value = f"{_factor(found['mult'] or '', heard) * weight:.15g} N"
    text = f"{heard.text[: found.start()]}{found['be']} #{len(heard.numbers)}#{heard.text[found.end() :]}"
    return replace(heard, text=text, numbers=(*heard.numbers, value))


def _factor(said: str, heard: Heard) -> float:
    if said.startswith("#"):
        return float(heard.number(said.partition(" ")[0]).partition(" ")[0])
    return next((value for told, value in MULTIPLES.items() if re.fullmatch(told, said)), 1.0)
