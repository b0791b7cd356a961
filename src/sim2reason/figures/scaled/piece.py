"""What is drawn to scale as one piece of an arranged drawing: strings run to its ports."""

from sim2reason.figures.paths import PathKnot
from sim2reason.figures.pieces import DrawingPlan, Piece
from sim2reason.figures.scaled.setting import Setting
from sim2reason.figures.scaled.sketch import scaled
from sim2reason.figures.shapes import LineShape, Sketch, outline
from sim2reason.figures.vectors import Polygon, hull


class ScaledPiece(Piece):
    """A group of entities whose shape is not changed by the layout."""

    def __init__(self, name: str, plan: DrawingPlan, group: frozenset[str]) -> None:
        """Draw it once, however often it is placed."""
        super().__init__(name, plan)
        self.setting = Setting(plan, group)
        self.picture = scaled(self.setting)
        solid = (s for s in self.picture.shapes if not isinstance(s, LineShape) or s.weight != "hair")
        self.outlines = [found for shape in solid if len(found := hull(outline(shape))) > 1]

    def anchor(self, knot: PathKnot, way: complex, *, second: bool) -> complex:
        """The port's site, or where the strand comes out of the body there."""
        return self.setting.edge(knot.leaves if second else knot.arrives, way)

    def hulls(self) -> list[Polygon]:
        """Every shape of it."""
        return self.outlines

    def sketch(self) -> Sketch:
        """The drawing to scale."""
        return self.picture
