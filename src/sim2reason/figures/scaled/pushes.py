"""Constant forces on single bodies, with their sizes and directions where the text states them."""

from cmath import phase
from math import degrees, hypot

from sim2reason.dsl.body import Small
from sim2reason.dsl.fields import Push
from sim2reason.dsl.mechanism import Force
from sim2reason.dsl.vectors import scale
from sim2reason.figures.paths import owner_of
from sim2reason.figures.scaled.angles import corner_angle
from sim2reason.figures.scaled.lines import beside
from sim2reason.figures.scaled.setting import Setting, vector
from sim2reason.figures.shapes import SMALL, LineShape, Sketch, Wanted, width
from sim2reason.figures.vectors import RIGHT, unit

LONG, BASE = 1.3, 1.1  # units: an arrow, and the line from which its angle is counted
FLAT = 1e-6  # deg or units: none


def is_push(setting: Setting, force: Force) -> bool:
    """Return whether a force is constant in space and time and acts on a body without a charge."""
    look = setting.look(force.body)
    charged = isinstance(look, Small) and bool(look.mark)
    return isinstance(force.law, Push) and force.law.constant and force.region is None and not charged


def pushes(setting: Setting) -> Sketch:
    """Return an arrow for each constant force, from the body's rim, with the stated magnitude and angle."""
    found = Sketch()
    for force in setting.mechanism.forces:
        if setting.owns(force.body) and is_push(setting, force):
            _draw(setting, force, found)
    return found


def _draw(setting: Setting, force: Force, found: Sketch) -> None:
    law = force.law
    assert isinstance(law, Push)
    strength = vector(scale(law.profile.value, law.direction))
    way = setting.view.way(strength)
    if abs(way) <= FLAT * hypot(*strength):
        return
    out, name = unit(way), force.body
    start = setting.at(name) + setting.radius(name) * out
    found.shapes.append(LineShape((start, start + LONG * out), arrow=True))
    text = setting.stated(owner_of(name), setting.mechanism.units.spell("N"), hypot(*strength))
    if text:
        tip = start + (LONG + 0.15 + 0.5 * width(text, SMALL) * abs(out.real) + 0.2 * abs(out.imag)) * out
        places = (tip, *beside(start, start + LONG * out, text, SMALL))
        found.labels.append(Wanted(text, places, name, SMALL, name=False))
    for base in _bases(setting, name):
        turn = phase(out / base)
        angle = setting.once(owner_of(name), "deg", degrees(abs(turn))) if FLAT < degrees(abs(turn)) <= 90.0 else ""
        if angle:
            begin = degrees(phase(base))
            found.shapes.append(LineShape((start, start + BASE * base), "hair", dashed=True))
            found.extend(corner_angle(start, (begin, begin + degrees(turn)), angle, name))
            return


def _bases(setting: Setting, name: str) -> list[complex]:
    """Return the directions from which a force's angle is measured: the body's slides, then the horizontal."""
    slides = [c.axis for c in setting.mechanism.body[name].coordinates if c.kind == "slide"]
    ways = [unit(way) for axis in slides if abs(way := setting.view.way(axis)) > FLAT]
    return [sign * way for way in (*ways, RIGHT) for sign in (1.0, -1.0)]
