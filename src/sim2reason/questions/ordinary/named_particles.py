"""Names of particles that a mass tells, such as an electron, for what the text of a scene calls a bead."""

import re
from collections.abc import Mapping
from math import isclose

from sim2reason.dsl.units import parse_unit
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.questions.words import Words

NEAR = 0.01  # relative: how well a mass must fit, as texts round it
MASSES: Mapping[str, float] = {"electron": 9.1094e-31, "proton": 1.6726e-27}
"""The masses of particles, kg."""


def with_particles(text: str, words: Words) -> str:
    """Return a text that calls a particle, by whose name only one body can be meant, as the scene's text does."""
    factor = parse_unit(words.units.spell("kg")).factor_to(parse_unit("kg")) or 1.0
    for particle, mass in MASSES.items():
        fits = [
            said
            for name, said in words.called(Bodies()).items()
            if isclose(words.mechanism.body[name].mass * factor, mass, rel_tol=NEAR)
        ]
        if len(fits) == 1:
            text = re.sub(rf"\b(?:[Tt]he )?{particle}\b", fits[0], text)
    return text
