"""Which parts of a scene are drawn together, and which of them to scale."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from sim2reason.figures.pieces import PIECES
from sim2reason.scenes.dsl.ports import StringPort
from sim2reason.scenes.dsl.scene import Scene


@dataclass(frozen=True, slots=True)
class Component:
    """Entities and connections that hold together: `arranged` by name, and others to scale, group by group.

    What a group holds, connections between its entities included, is drawn in one piece.
    """

    arranged: frozenset[str]
    groups: tuple[frozenset[str], ...]

    def home(self) -> Mapping[str, str]:
        """By entity that is drawn to scale the name of its piece."""
        return {name: min(group) for group in self.groups for name in group}


def components(scene: Scene) -> list[Component]:
    """Return all components of a scene, in the order of its entities."""
    joined = {f"{c.key}_{n}": [link.entity for link in c.links] for n, c in enumerate(scene.connections, start=1)}
    entities = [named.name for named in scene.entities]
    return [_component(scene, owners) for owners in _clusters([*entities, *joined], joined)]


def _component(scene: Scene, owners: frozenset[str]) -> Component:
    """Arranged, to scale, or both: then strings run from what is to scale to what is arranged."""
    scaled = {name for name in owners if _is_entity(scene, name) and not _can_be_arranged(scene, name)}
    if not scaled:
        return Component(owners, ())
    rigid = {name: _ends(scene, name) for name in owners if name in scene.joints and not _is_string(scene, name)}
    carried = any(not held <= scaled and scene.joints[name].connection.carries for name, held in rigid.items())
    if scaled == {name for name in owners if _is_entity(scene, name)} or carried:
        return Component(frozenset(), (owners,))
    inner = {name: sorted(held) for name, held in rigid.items() if held <= scaled}
    groups = _clusters([*sorted(scaled), *inner], inner)
    return Component(owners - frozenset[str]().union(*groups), tuple(groups))


def _is_entity(scene: Scene, name: str) -> bool:
    return any(named.name == name for named in scene.entities)


def _can_be_arranged(scene: Scene, name: str) -> bool:
    """Whether an entity says that its lengths don't matter, and all its bodies have a look that can be arranged."""
    bodies = [body for address, body in scene.bodies.items() if address.startswith(f"{name}.")]
    return scene.entity(name).schematic and all(type(body.look) in PIECES for body in bodies)


def _is_string(scene: Scene, name: str) -> bool:
    return issubclass(scene.joints[name].connection.joins, StringPort)


def _ends(scene: Scene, name: str) -> frozenset[str]:
    return frozenset(link.entity for link in scene.joints[name].connection.links)


def _clusters(names: Iterable[str], joined: Mapping[str, Iterable[str]]) -> list[frozenset[str]]:
    """Names in groups: each key of `joined` with all that it holds together."""
    leader = {name: name for name in names}
    for name, held in joined.items():
        for other in held:
            old, new = leader[other], leader[name]
            leader = {each: new if head == old else head for each, head in leader.items()}
    heads = dict.fromkeys(leader.values())
    return [frozenset(name for name, held in leader.items() if held == head) for head in heads]
