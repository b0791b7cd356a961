"""Check that no sentence of a text denies what the scene has."""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from sim2reason.scenes.dsl.fields import Resistance
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.structure import weighs
from sim2reason.testing.checks import Check, check
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import Specimen, Specimens
from sim2reason.text.parsing.ordinary.textbook import AIRLESS


@dataclass(frozen=True, slots=True)
class Claim:
    """A claim that something is absent, in the words of texts, and the scenes that it is false of."""

    absent: str
    pattern: re.Pattern[str]
    is_false: Callable[[Scene], bool]


def _has_drag(scene: Scene) -> bool:
    return any(isinstance(force.law, Resistance) for force in scene.mechanism.forces)


def _has_friction(scene: Scene) -> bool:
    return any(face.friction > 0.0 for face in scene.mechanism.faces)


def _has_motion_at_the_start(scene: Scene) -> bool:
    return not scene.starts_from_rest


def _has_weight(scene: Scene) -> bool:
    return weighs(scene.mechanism)


_NEGLIGIBLE = r"(?:is|are|can be|may be) (?:negligible|neglected|ignored|absent)"
CLAIMS = (
    Claim(
        "resistance of a medium",
        re.compile("|".join((*AIRLESS, r"in (?:a )?vacuum")), re.IGNORECASE),
        _has_drag,
    ),
    Claim(
        "friction",
        re.compile(
            rf"friction {_NEGLIGIBLE}|(?:neglect|ignore) (?:all )?friction"
            r"|there is no friction(?! (?:at|in|between|on))|(?:all|the) surfaces are (?:smooth|frictionless)",
            re.IGNORECASE,
        ),
        _has_friction,
    ),
    Claim(
        "initial motion",
        re.compile(
            r"(?:everything|the system|the motion|the bodies|all bodies) (?:is|are|starts?|begins?) "
            r"(?:released from rest|from rest|held at rest)",
            re.IGNORECASE,
        ),
        _has_motion_at_the_start,
    ),
    Claim(
        "gravity",
        re.compile(
            rf"gravity {_NEGLIGIBLE}|(?:neglect|ignore) gravity|(?:no|without) gravity|weightless", re.IGNORECASE
        ),
        _has_weight,
    ),
)
"""Claims about a whole scene; a claim about one body, as *a smooth plane*, is a word of that body."""


@check
class ClaimsCheck(Check):
    """Check that no sentence says that something is absent which the scene has, such as the resistance of the air."""

    name = "claims"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Yield each sentence that denies what its scene has."""
        for found in specimens.members:
            yield from self._false_claims(found)

    def _false_claims(self, found: Specimen) -> Iterator[Finding]:
        for sentence in found.description.sentences:
            for claim in CLAIMS:
                if claim.pattern.search(sentence) and claim.is_false(found.scene):
                    expected = f"no sentence denies the {claim.absent} of the scene"
                    remedy = "say that sentence only where it is true, or leave out what it denies"
                    yield found.finding(self.name, expected, f"{sentence!r}", remedy)
