"""Formula trees that are evaluated without the grader, written at random, and mutated."""

import math
import operator
import random
from collections.abc import Callable
from dataclasses import dataclass

NAMES = ["g", "h", "m_1", "m_2", "M", "v_0", "theta", "mu_k", "k"]
SPELLED = {
    "theta": [r"\theta", "θ", r"{\theta}"],
    "mu_k": [r"\mu_k", r"\mu_{k}", r"\mu_{\text{k}}", "μ_k"],
    "m_1": ["m_1", "m_{1}", "m₁"],
    "m_2": ["m_2", r"m_{\mathrm{2}}", "m_{2}"],
    "v_0": ["v_0", "v_{0}", "v₀"],
}
MEANING: dict[str, Callable[..., float]] = {
    "sum": operator.add,
    "difference": operator.sub,
    "product": operator.mul,
    "quotient": operator.truediv,
    "minus": operator.neg,
    "sqrt": math.sqrt,
    "sin": math.sin,
    "cos": math.cos,
    "exp": math.exp,
}
FUNCTION = [r"\{f}{p0}", "{f}{p0}", r"\{f}{{{s0}}}"]
FORMS = {  # s: a part as it is, p: the part in parentheses, n: the exponent
    "sum": ["{s0} + {p1}"],
    "difference": ["{s0}-{p1}"],
    "product": ["{p0}{p1}", r"{p0}\,{p1}", r"{p0}\cdot {p1}", "{p0}*{p1}", r"{p0} \times {p1}"],
    "quotient": [r"\frac{{{s0}}}{{{s1}}}", r"\dfrac{{{s0}}}{{{s1}}}", "({p0}/{p1})"],
    "power": ["{p0}^{{{n}}}", "{p0}^{{ {n} }}", "{p0}**{n}"],
    "minus": ["(-{p0})"],
    "sqrt": [r"\sqrt{{{s0}}}", "sqrt({s0})", "({s0})^{{1/2}}", r"({s0})^{{\frac12}}", "√({s0})"],
}


@dataclass(frozen=True)
class Tree:
    """Formula: a symbol by name, a number, or an operation on parts; a power has its exponent as number."""

    kind: str
    parts: tuple["Tree", ...] = ()
    name: str = ""
    number: float = 0.0

    def value(self, at: dict[str, float]) -> float:
        """Return the value of the formula for the symbols in `at`."""
        if self.kind == "number":
            return self.number
        if self.kind == "symbol":
            return at[self.name]
        parts = [part.value(at) for part in self.parts]
        return math.pow(parts[0], self.number) if self.kind == "power" else MEANING[self.kind](*parts)

    def nodes(self) -> list["Tree"]:
        """Return the node and all nodes below it."""
        return [self, *(node for part in self.parts for node in part.nodes())]

    def replaced(self, old: "Tree", new: "Tree") -> "Tree":
        """Return the formula with the very object `old` exchanged."""
        if self is old:
            return new
        return Tree(self.kind, tuple(part.replaced(old, new) for part in self.parts), self.name, self.number)

    def spell(self, rng: random.Random) -> str:
        """Return one of the many spellings of the formula."""
        if self.kind == "number":
            return f"{self.number:g}"
        if self.kind == "symbol":
            return rng.choice(SPELLED.get(self.name, [self.name]))
        words = {"f": self.kind, "n": f"{self.number:g}"}
        for index, part in enumerate(self.parts):
            spelled = part.spell(rng)
            frame = rng.choice([r"\left({}\right)", "({})", "[{}]"])
            words |= {f"s{index}": spelled, f"p{index}": frame.format(spelled)}
        return rng.choice(FORMS.get(self.kind, FUNCTION)).format(**words)


def leaf(kind: str, **fields: object) -> Tree:
    """Return a symbol or a number."""
    return Tree(kind, (), **fields)


def mutant(tree: Tree, rng: random.Random) -> Tree:
    """Return the tree with one sign, factor, exponent, symbol, term or constant changed."""
    node = rng.choice(tree.nodes())
    changes = [
        Tree("minus", (node,)),
        Tree("product", (leaf("number", number=rng.choice([2.0, 0.5, 10.0, 1.02, 0.98])), node)),
        Tree("power", (node,), number=rng.choice([2.0, 3.0, 0.5])),
    ]
    if node.kind == "symbol":
        changes.append(leaf("symbol", name=rng.choice([name for name in NAMES if name != node.name])))
    if node.kind == "number":
        changes.append(leaf("number", number=node.number * rng.choice([1.02, 0.98, 1.05, 0.9])))
    if node.kind in {"sum", "difference"}:
        changes.append(Tree("difference" if node.kind == "sum" else "sum", node.parts))
    if len(node.parts) == 2:
        changes += [*node.parts, Tree(node.kind, node.parts[::-1])]
    if node.kind == "power":
        changes.append(Tree("power", node.parts, number=node.number + 1))
    return tree.replaced(node, rng.choice(changes))


def values(tree: Tree, points: list[dict[str, float]]) -> list[float | None]:
    """Return the values at `points`, None where there is none."""
    found: list[float | None] = []
    for point in points:
        try:
            x = tree.value(point)
        except (ArithmeticError, ValueError):
            x = math.nan
        found.append(x if math.isfinite(x) else None)
    return found
