"""Numbers of a scene that a question can name by words alone: *the mass of block A*, *the coefficient of friction*."""

from collections import Counter
from collections.abc import Mapping

from sim2reason.scenes.dsl.model import Parameter
from sim2reason.scenes.dsl.scene import Scene

OF_BODIES = frozenset({"mass", "radius", "length", "height", "stiffness", "hole radius", "inner radius", "pulley mass"})
"""What is said of a body: *the radius of the disc*."""
OF_SCENES = {
    "coefficient of friction": "the coefficient of friction",
    "coefficient of static friction": "the coefficient of static friction",
    "coefficient of kinetic friction": "the coefficient of kinetic friction",
    "coefficient of restitution": "the coefficient of restitution",
    "force": "the applied force",
    "speed": "the initial speed",
    "height": "the initial height",
    "exhaust speed": "the exhaust speed",
    "burn rate": "the burn rate",
    "magnetic field": "the magnetic field",
    "electric field": "the electric field",
    "elevation": "the launch angle",
}
"""What a text says once, by the name of its measure or by its noun."""
CHARGE = "magnitude of the charge"
SLOPES = frozenset({"plane", "slope", "incline"})


def named_numbers(scene: Scene, mentions: Mapping[str, str]) -> Mapping[str, str]:
    """By address, the phrases for all numbers that have one of their own; what two could be called is left out."""
    phrases = {
        parameter.path: phrase
        for parameter in scene.parameters
        if parameter.value and not parameter.hidden and (phrase := _phrase(scene, parameter, mentions))
    }
    count = Counter(phrases.values())
    return {path: phrase for path, phrase in phrases.items() if count[phrase] == 1}


def _phrase(scene: Scene, parameter: Parameter, mentions: Mapping[str, str]) -> str:
    measure, owner = parameter.measure, parameter.path.rpartition(".")[0]
    noun, said = measure.noun, mentions.get(owner, "") if owner in scene.bodies else ""
    if said and noun in OF_BODIES:
        return f"the {noun.removeprefix('pulley ')} of {said}"
    if said and noun == CHARGE:
        return f"the charge of {said}"
    if said.removeprefix("the ") in SLOPES and measure.name in ("angle", "tilt"):
        return f"the angle of inclination of {said}"
    return "" if owner == "world" else OF_SCENES.get(measure.name, OF_SCENES.get(noun, ""))
