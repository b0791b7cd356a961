"""Which parts of a mechanism a simplification can be about."""

from math import isfinite

from sim2reason.dsl.mechanism import Face, Mechanism


def wheels(mechanism: Mechanism) -> tuple[str, ...]:
    """The bodies that a string turns as it passes."""
    turned = {wheel.coordinate for line in mechanism.lines if line.circle is None for wheel in line.wheels}
    return tuple(c.body for c in mechanism.coordinates if c.name in turned)


def massive(mechanism: Mechanism) -> tuple[str, ...]:
    """The bodies with mass that are no wheels."""
    turned = wheels(mechanism)
    return tuple(body.name for body in mechanism.bodies if body.mass > 0.0 and body.name not in turned)


def others(mechanism: Mechanism) -> tuple[str, ...]:
    """The bodies with mass that matter to each other: none where only one of them can move, whatever is fixed."""
    found = massive(mechanism)
    moving = [name for name in found if _can_move(mechanism, name)]
    return found if len(moving) > 1 else tuple(name for name in found if name not in moving)


def _can_move(mechanism: Mechanism, name: str | None) -> bool:
    if name is None:
        return False
    body = mechanism.body[name]
    return bool(body.coordinates) or _can_move(mechanism, body.parent)


def carriers(mechanism: Mechanism) -> tuple[str, ...]:
    """The bodies that can move, and carry others: wedges, boxes, carts with something on them."""
    parents = {body.parent for body in mechanism.bodies} | {mechanism.site[name].body for name in _led(mechanism)}
    return tuple(body.name for body in mechanism.bodies if body.coordinates and body.mass and body.name in parents)


def _led(mechanism: Mechanism) -> set[str]:
    """The sites that lines pass on their way, as over a pulley."""
    return {site for line in mechanism.lines for site in line.through[1:-1]}


def solid(mechanism: Mechanism) -> list[str]:
    """The bodies with inertia about their centres of mass that can turn."""
    return [name for name in massive(mechanism) if any(mechanism.body[name].inertia) and _turns(mechanism, name)]


def _turns(mechanism: Mechanism, name: str) -> bool:
    """Whether it, or what carries it, has a hinge."""
    body = mechanism.body[name]
    if any(coordinate.kind == "hinge" for coordinate in body.coordinates):
        return True
    return body.parent is not None and _turns(mechanism, body.parent)


def rough(mechanism: Mechanism) -> list[Face]:
    """The faces on which something can slip against friction."""
    return [face for face in mechanism.faces if face.friction > 0.0 and isfinite(face.friction)]
