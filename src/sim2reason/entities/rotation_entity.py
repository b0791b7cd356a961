"""A rigid body, made of several, that swings about a fixed axle."""

from sim2reason.authoring import Mount, either, entity
from sim2reason.entities.parts.assembly import WeldedArm


@entity
class RotationEntity(WeldedArm):
    """Pieces welded to a light arm that turns about a fixed horizontal axle under gravity."""

    says = (
        either(
            "{arm} can turn without friction in a vertical plane about a fixed horizontal axle.",
            "about a fixed horizontal axle {arm} swings without friction in a vertical plane.",
            "a fixed horizontal axle carries {arm}, which turns on it without friction in a vertical plane.",
        ),
        *WeldedArm.LINES,
    )
    tip = Mount(sites=("tip",), place="the far end of {arm}", needs="reach")
