"""Bodies that turn."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from sim2reason.dsl.constancy import turns_one_way
from sim2reason.dsl.mechanism import Mechanism
from sim2reason.quantities.subjects import Subject
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.paths import is_pulley_wheel, turning_axes


@dataclass(frozen=True)
class TurningBodies(Subject):
    """Every body that a hinge turns, its own or one of what carries it."""

    name, slot = "turning body", "body"
    extras = frozenset({"net"})

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """All that turn, wheels of pulleys among them."""
        return tuple(name for name in mechanism.body if turning_axes(mechanism, name))

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Those whose turning can be seen: not pulleys, nor bodies so small that they have no size."""
        seen = [name for name in self.names(mechanism) if name in mentions and not is_pulley_wheel(mechanism, name)]
        return {name: mentions[name] for name in seen if _has_size(mechanism, name)}

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Whether the body has it and the text says it at the body's address."""
        return Bodies().gives(need, mechanism, name, said)

    def fills(self, mechanism: Mechanism, name: str, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return *net* for the angle of a body that may reverse its rotation."""
        del mentions
        return {"net": "" if turns_one_way(mechanism, name) else "net "}


def _has_size(mechanism: Mechanism, name: str) -> bool:
    """Whether a body is no point: it has a moment of inertia, or it is light and its own hinge turns it."""
    body = mechanism.body[name]
    return any(body.inertia) or (body.mass == 0.0 and any(c.kind == "hinge" for c in body.coordinates))
