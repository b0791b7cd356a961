"""Hidden numbers do not matter."""

from collections.abc import Iterator
from typing import cast

import numpy as np

from sim2reason.scenes.dsl.model import Model, Parameter, field_types
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.testing.answers import differences
from sim2reason.testing.checks import Check, check
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import Specimens
from sim2reason.testing.variants import changed, studied

DRAWS = 3


@check
class HiddenNumbersCheck(Check):
    """Numbers marked `Hidden` change no answer while both motions are described."""

    name = "hidden numbers"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Draw all of them anew, and ask again."""
        for found in specimens.moving:
            rng = np.random.default_rng([found.seed, 7])
            hidden = [p for p in found.scene.parameters if p.hidden and p.value is not None]
            for _ in range(DRAWS if hidden else 0):
                numbers = {parameter.path: _redrawn(found.scene, parameter, rng) for parameter in hidden}
                other = studied(changed(found.scene, numbers), found.scene.horizon)
                difference = next(differences(found, other), None) if other is not None else None
                if difference is not None:
                    said = ", ".join(f"{path} = {value:g}" for path, value in numbers.items())
                    yield found.finding(
                        self.name,
                        "the same answers whatever the hidden numbers are",
                        f"with {said}, {difference.text}",
                        "say the number, or build so that nothing depends on it",
                    )
                    break


def _redrawn(scene: Scene, parameter: Parameter, rng: np.random.Generator) -> float:
    """Another value from what the field declares, or up to twice as large where it declares nothing."""
    owner, _, name = parameter.path.rpartition(".")
    held = field_types(type(cast("Model", scene.value(owner))))[name]
    value = parameter.value or 1.0
    low, high = (held.drawn.low, held.drawn.high) if held.drawn is not None else (value, 2.0 * value)
    return float(rng.uniform(low, high))
