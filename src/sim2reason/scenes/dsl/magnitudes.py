"""Plausible ranges of stated numbers, of answers, and of combinations of numbers.

A number outside its range is physically valid, but unusual in a textbook. Ranges are of absolute values, and
zero is always plausible. Numbers without a range are not judged.
"""

from collections.abc import Iterator, Mapping

from sim2reason.scenes.dsl.body import Matter
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import Elastic, Mechanism
from sim2reason.scenes.dsl.scene import Scene

Span = tuple[float, float]
"""The least and the greatest plausible absolute value."""

STATED: Mapping[tuple[str, str], Span] = {
    # name and unit of a measure
    ("mass", "kg"): (0.02, 2000.0),
    ("mass", "mg"): (0.5, 20.0),
    ("mass", "Msun"): (1e-7, 10.0),
    ("pulley mass", "kg"): (0.05, 20.0),
    ("charge", "uC"): (1e-3, 10.0),
    ("length", "m"): (0.05, 5.0),
    ("natural length", "m"): (0.05, 2.0),
    ("radius", "m"): (0.02, 2.0),
    ("inner radius", "m"): (0.01, 1.0),
    ("hole radius", "m"): (0.01, 0.5),
    ("offset", "m"): (0.01, 0.5),
    ("thickness", "m"): (0.005, 0.5),
    ("width", "m"): (0.01, 1.0),
    ("height", "m"): (0.02, 50.0),
    ("distance", "m"): (0.05, 5.0),
    ("strain", "m"): (0.01, 0.5),
    ("position", "m"): (0.0, 10.0),
    ("fixed end", "m"): (0.0, 3.0),
    ("position of a wall", "m"): (0.0, 10.0),
    ("position", "au"): (0.0, 50.0),
    ("radius", "km"): (200.0, 3000.0),
    ("gravity", "m/s^2"): (0.05, 25.0),
    ("angle", "deg"): (2.0, 360.0),
    ("deflection", "deg"): (2.0, 175.0),
    ("elevation", "deg"): (2.0, 90.0),
    ("bearing", "deg"): (2.0, 180.0),
    ("phase", "deg"): (2.0, 180.0),
    ("tilt", "deg"): (2.0, 85.0),
    ("speed", "m/s"): (0.05, 30.0),
    ("velocity", "m/s"): (0.0, 30.0),
    ("velocity", "au/yr"): (0.0, 25.0),
    ("exhaust speed", "km/s"): (0.3, 5.5),
    ("burn rate", "kg/s"): (0.2, 100.0),
    ("angular velocity", "rad/s"): (0.2, 60.0),
    ("angular frequency", "rad/s"): (0.2, 60.0),
    ("friction", ""): (0.03, 1.2),
    ("static friction", ""): (0.03, 1.5),
    ("restitution", ""): (0.1, 1.0),
    ("force", "N"): (0.1, 1000.0),
    ("stiffness", "N/m"): (5.0, 5000.0),
    ("damping constant", "N*s/m"): (0.05, 50.0),
    ("electric field", "N/C"): (0.1, 1e6),
    ("magnetic field", "T"): (1e-3, 5.0),
    ("field strength", "N/C"): (0.1, 1e6),
    ("field strength", "T"): (1e-3, 5.0),
    ("growth", "N/(C s)"): (0.01, 1e5),
    ("gradient", "N/(C m)"): (0.01, 1e5),
    ("gradient", "T/m"): (1e-3, 10.0),
    ("dipole strength", "T m^3"): (0.01, 10.0),
    ("drag", "uN s/m"): (0.01, 10.0),
    ("drag", "uN s^2/m^2"): (0.01, 10.0),
}
BENCH: Mapping[str, Span] = {
    # answers about what happens on a bench or in a yard, by their canonical unit
    "kg": (0.02, 2000.0),
    "mg": (0.5, 20.0),
    "uC": (1e-3, 10.0),
    "m": (2e-3, 100.0),
    "m/s": (5e-3, 60.0),
    "m/s^2": (5e-3, 500.0),
    "s": (5e-3, 60.0),
    "Hz": (0.02, 50.0),
    "rad/s": (5e-3, 200.0),
    "rad/s^2": (5e-3, 2000.0),
    "N": (0.01, 5000.0),
    "J": (1e-3, 2e4),
    "N*s": (5e-3, 5000.0),
    "kg*m/s": (5e-3, 5000.0),
    "N/m": (5.0, 5000.0),
    "uN": (0.01, 1e4),
    "uJ": (0.01, 1e4),
    "uN*s": (0.01, 1e4),
    "mg*m/s": (0.01, 1e4),
}
FLIGHT: Mapping[str, Span] = {
    # the same about rockets
    "kg": (10.0, 1e5),
    "m": (1.0, 3e7),
    "km": (0.01, 3e4),
    "m/s": (0.5, 2e4),
    "km/s": (0.3, 20.0),
    "m/s^2": (0.01, 500.0),
    "s": (0.05, 1e4),
    "N": (10.0, 1e7),
    "J": (1e3, 1e13),
    "N*s": (10.0, 1e9),
    "kg*m/s": (10.0, 1e9),
}
DENSITIES: Mapping[Matter, Span] = {
    "solid": (100.0, 12000.0),  # kg/m³: from cork to lead
    "planet": (800.0, 6000.0),  # from ice to rock rich in iron
}
MAX_PLANET_MASS_RATIO = 1e-3  # fraction of the mass of its star: a heavier planet would move the star noticeably
STRETCH_SPAN: Span = (0.5, 1.5)  # plausible lengths of a spring, as fractions of its natural length


def is_outside(value: float, span: Span) -> bool:
    """Return whether an absolute value lies outside a range; zero never does."""
    return value != 0.0 and not span[0] <= abs(value) <= span[1]


def implausible_numbers(scene: Scene) -> Iterator[str]:
    """Yield a message with address for each implausible number of a scene."""
    for parameter in scene.parameters:
        span = STATED.get((parameter.measure.name, parameter.measure.unit))
        if parameter.value is None or parameter.hidden or span is None:
            continue
        if is_outside(parameter.value, span):
            yield f"{parameter.path} is {parameter.measure.say(parameter.value)}"
    for path, body in scene.bodies.items():
        if body.density is not None and is_outside(body.density, DENSITIES[body.matter]):
            yield f"{path} has a density of {body.density:.3g} kg/m\N{SUPERSCRIPT THREE}"
    yield from _heavy_planets(scene.mechanism)
    yield from implausible_spring_lengths(natural_lengths(scene), scene.mechanism, _lengths(scene.mechanism))


def _heavy_planets(mechanism: Mechanism) -> Iterator[str]:
    for pull in mechanism.attractions:
        a, b = mechanism.body[pull.a], mechanism.body[pull.b]
        fixed, moving = (a, b) if b.coordinates else (b, a)
        if not fixed.coordinates and moving.mass > MAX_PLANET_MASS_RATIO * fixed.mass:
            yield f"{moving.name} has {moving.mass / fixed.mass:.2g} of the mass of {fixed.name}, which stays fixed"


def natural_lengths(scene: Scene) -> dict[str, float]:
    """Return the natural lengths of springs that a scene states, m, by the name of the spring."""
    named_parameters = ((parameter.path.rpartition(".")[0], parameter) for parameter in scene.parameters)
    return {name: p.value for name, p in named_parameters if p.measure.name == "natural length" and p.value is not None}


def implausible_spring_lengths(
    natural: Mapping[str, float], mechanism: Mechanism, lengths: Mapping[str, Span]
) -> Iterator[str]:
    """Yield a message for each spring that becomes too short or too long, given natural lengths and ranges, m.

    `lengths` are the least and the greatest length that each has, m. A spring that only pushes may be left behind, and
    a cord that only pulls may go slack.
    """
    for name, own in natural.items():
        line = mechanism.line.get(name)
        if line is None or not isinstance(line.law, Elastic) or name not in lengths:
            continue
        smallest, greatest = (length / own for length in lengths[name])
        if line.law.side <= 0.0 and smallest < STRETCH_SPAN[0]:
            yield f"{name} is squeezed to {smallest:.2g} of its natural length"
        if line.law.side >= 0.0 and greatest > STRETCH_SPAN[1]:
            yield f"{name} is stretched to {greatest:.2g} of its natural length"


def _lengths(mechanism: Mechanism) -> dict[str, Span]:
    frames = initial_frames(mechanism)
    return {
        line.name: (length := float(frames.length(line)), length)
        for line in mechanism.lines
        if isinstance(line.law, Elastic) and line.circle is None
    }
