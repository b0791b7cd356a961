"""A rigid body, made of several, that swings from what carries its axle."""

from sim2reason.authoring import Base, Mount, either, entity
from sim2reason.entities.parts.assembly import WeldedArm


@entity
class RigidPendulum(WeldedArm):
    """Pieces welded to a light arm that hangs from another entity."""

    says = (
        either(
            "{arm} can turn in a vertical plane about a horizontal axle.",
            "about a horizontal axle {arm} swings in a vertical plane.",
            "a horizontal axle carries {arm}, which turns on it in a vertical plane.",
        ),
        *WeldedArm.LINES,
    )
    tip = Mount(sites=("tip",), place="the far end of {arm}", needs="reach")
    axle = Base(held="{arm}", required=True)
