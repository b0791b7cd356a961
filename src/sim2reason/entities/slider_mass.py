"""A carriage on a horizontal rail, with a hinge for what hangs from it."""

from sim2reason.authoring import End, Entity, Frame, Mount, X, either, entity, scale
from sim2reason.bodies.carriage import Carriage


@entity
class SliderMass(Entity):
    """The rail guides the carriage and holds it up and down."""

    carriage: Carriage

    says = (
        either(
            "{carriage} slides freely along a straight horizontal rail.",
            "a straight horizontal rail carries {carriage}, which slides on it without friction.",
            "{carriage} is free to slide along a smooth, straight and horizontal rail.",
        ),
    )
    pivot = Mount(sites=("hub",), place="{carriage}")
    left = End(
        sites=("left_eye",),
        tied="{carriage}",
        leaves="runs along the rail to the left",
        arrives="reaches {carriage} along the rail, from the left",
    )
    right = End(
        sites=("right_eye",),
        tied="{carriage}",
        leaves="runs along the rail to the right",
        arrives="reaches {carriage} along the rail, from the right",
    )

    def build(self, room: Frame) -> None:
        """The carriage at the origin."""
        carriage = room.body("carriage", self.carriage.mass).slide(X)
        carriage.site("hub").site("left_eye", faces=scale(-1.0, X)).site("right_eye", faces=X)
