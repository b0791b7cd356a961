"""Tests of rockets, planets, charges, balls and bobs: texts, files and agreement of both engines."""

import re

import pytest

from lone_entities import drawn
from sim2reason.errors import TextError
from sim2reason.scenes.files import dump, load
from sim2reason.simulation.scenes import certify
from sim2reason.testing.checks.texts import optional_sentences
from sim2reason.text.parsing import parse_scene
from sim2reason.text.prose import describe

NAMES = ("EmEntity", "Pendulum", "Projectile", "RocketEntity", "SolarSystem")
DRAWS = [10, pytest.param(50, marks=pytest.mark.slow)]
CERTIFIED = 10


@pytest.mark.parametrize("draws", DRAWS)
@pytest.mark.parametrize("name", NAMES)
def test_they_come_back_from_their_text_and_from_their_file(name: str, draws: int) -> None:
    """Numbers are printed exactly, and the text has only one meaning."""
    for seed in range(draws):
        scene = drawn(name, seed)
        assert load(dump(scene)) == scene
        text = describe(scene, seed).text
        assert parse_scene(text).scene.entities[0].entity == scene.entities[0].entity, text
        assert not re.search(r"[\[{]|\bentity\b|None|[a-z]_[a-z]{2}|[1-9]\.\d{3}", text), text


@pytest.mark.slow  # testing/test_entities cuts the sentences of every entity
@pytest.mark.parametrize("name", NAMES)
def test_no_sentence_can_be_spared(name: str) -> None:
    """Without any one sentence, the text is refused or describes another scene.

    Sentences that only some questions need are exempt.
    """
    for seed in range(8):
        scene = drawn(name, seed)
        description = describe(scene, seed)
        sentences, spared = description.sentences, optional_sentences(description)
        for cut in (number for number, sentence in enumerate(sentences) if sentence not in spared):
            text = " ".join(sentences[:cut] + sentences[cut + 1 :]).replace(" \n\n", "\n\n").replace("\n\n ", "\n\n")
            try:
                understood = parse_scene(text.strip()).scene
            except TextError:
                continue
            assert understood.entities[0].entity != scene.entities[0].entity, sentences[cut]


@pytest.mark.parametrize("name", NAMES)
def test_both_engines_find_the_same_motion(name: str) -> None:
    """The engines agree up to the end of the motion, or until a bouncing ball comes to rest."""
    for seed in range(CERTIFIED):
        scene = drawn(name, seed)
        trace, certificate = certify(scene)
        assert certificate.reason in ("", "crowd", "limit"), (seed, certificate)
        assert certificate.stable_until > 0.5 * min(scene.horizon, trace.stable_until)
        assert max(certificate.agreement.values()) < 1e-4
