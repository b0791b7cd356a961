"""Objects in a question that a scene does not have."""

import re

from sim2reason.scenes.dsl.body import BODIES
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.text.prose.description import describe

SETTING = frozenset(
    ["circle", "ground", "half-plane", "plane", "rectangle", "space", "start", "strip", "table", "track"]
)
"""Nouns that sentences about any scene may have."""


def missing_object(sentence: str, scene: Scene) -> str:
    """Return a clause that names an object of a sentence that the scene lacks; empty if there is none."""
    asked, told = _words(sentence), _words(describe(scene).text)
    present = {noun for body in scene.bodies.values() for noun in body.nouns}
    nouns = {noun for body in BODIES.values() for noun in body.nouns} - SETTING - present
    missing = sorted(noun for noun in nouns if noun in asked and noun not in told)
    return f"the scene has no {missing[0]}" if missing else ""


def _words(text: str) -> set[str]:
    """Return the words of a text, without the s of plurals."""
    return {word.removesuffix("s") for word in re.findall(r"[a-z-]+", text.lower())}
