"""A weld: one entity is fixed rigidly to a point of another."""

from typing import ClassVar

from sim2reason.scenes.connections.pivot import Carried
from sim2reason.scenes.dsl.connection import Look, connection
from sim2reason.scenes.dsl.template import Wordings, either


@connection
class Weld(Carried):
    """A rigid joint between a point of one entity and the base of another."""

    key: ClassVar[str] = "weld"
    stiff: ClassVar[bool] = True
    look: ClassVar[Look] = "weld"

    says: ClassVar[Wordings] = either(
        "{b} is fixed rigidly to {a}.",
        "{b} is welded to {a}.",
        "a rigid joint holds {b} fast to {a}.",
    )
