"""One drawing to scale, from its parts."""

from sim2reason.dsl.body import Globe, PulleyWheel, Slender, Tabletop, Unseen
from sim2reason.figures.pieces import around
from sim2reason.figures.scaled import bodies
from sim2reason.figures.scaled.arrows import deflections, heights, speeds, spins
from sim2reason.figures.scaled.axes import axes
from sim2reason.figures.scaled.fields import fields
from sim2reason.figures.scaled.grounds import grounds
from sim2reason.figures.scaled.lines import lines
from sim2reason.figures.scaled.pushes import pushes
from sim2reason.figures.scaled.setting import Setting
from sim2reason.figures.scaled.stated import stated
from sim2reason.figures.shapes import SIZE, SMALL, Arc, LineShape, Shape, Sketch, Wanted, dot_at, outline, width
from sim2reason.figures.vectors import box
from sim2reason.quantities.subjects.paths import rim_of

WHEEL = 0.16  # units, the least radius of a pulley
ELSEWHERE = (Slender, Unseen, Globe, Tabletop)  # drawn where the mechanism shows them, not at a place of their own


def scaled(setting: Setting) -> Sketch:
    """Entities and connections, drawn to scale in one piece."""
    found, front = Sketch(), Sketch()
    found.extend(fields(setting))
    found.extend(axes(setting))
    found.extend(grounds(setting))
    found.extend(lines(setting, front))
    for address, body in setting.bodies.items():
        if isinstance(body.look, PulleyWheel):
            found.extend(_pulley(setting, address))
        elif address not in setting.drawn and not isinstance(body.look, ELSEWHERE) and setting.stands(address):
            found.extend(bodies.body(setting, address, setting.along(address)))
    found.extend(front)
    found.extend(deflections(setting))
    found.extend(stated(setting))
    found.extend(pushes(setting))
    found.extend(speeds(setting))
    found.extend(spins(setting))
    found.extend(heights(setting))
    _strangers(setting, found)
    _legend(setting, found)
    return found


def _pulley(setting: Setting, address: str) -> Sketch:
    """A wheel between the two points of its rim, with its axle and its name."""
    sides = rim_of(setting.mechanism, address)
    if sides is None:
        return Sketch()
    left, right = (setting.site(site) for site in sides)
    middle, radius = 0.5 * (left + right), max(WHEEL, 0.5 * abs(right - left))
    look = setting.bodies[address].look
    solid = isinstance(look, PulleyWheel) and look.solid
    shapes: list[Shape] = [Arc(middle, radius, fill="disc" if solid else ""), dot_at(middle, 0.05)]
    text = setting.plan.caption(address)
    size = SIZE if text == setting.plan.name(address) else SMALL
    setting.drawn.add(address)
    return Sketch(shapes, [Wanted(text, around(middle, radius + 0.1, width(text, size), start=1 + 1j), address, size)])


def _strangers(setting: Setting, found: Sketch) -> None:
    """What a text names and nothing above has drawn, below everything else."""
    left, low, _, _ = box([point for shape in found.shapes for point in outline(shape)] or [0j])
    named = {wanted.subject for wanted in found.labels if wanted.name}
    missing = [a for a, body in setting.bodies.items() if body.letters and a not in named]
    missing += [a for a, body in setting.bodies.items() if body.look is None and a not in named and a not in missing]
    for number, address in enumerate(missing):
        found.extend(bodies.stranger(setting, address, complex(left + 1.0 + 2.4 * number, low - 0.9)))


def _legend(setting: Setting, found: Sketch) -> None:
    """The scale of the velocities, below the right end of everything."""
    if setting.legend is None:
        return
    long, text = setting.legend
    left, low, right, _ = box(point for shape in found.shapes for point in outline(shape))
    low = min([low, *(wanted.places[0].imag for wanted in found.labels)])
    start = complex(max(left, right - long - 0.3 - width(text, SMALL)), low - 0.55)
    found.shapes.append(LineShape((start, start + long), "thin", arrow=True))
    found.labels.append(Wanted(text, (start + long + 0.2 + 0.5 * width(text, SMALL),), "", SMALL, name=False))
