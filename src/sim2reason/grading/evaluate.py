r"""Reference formulas as functions of their symbols, read by the parser of responses."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from sim2reason.grading import arithmetic
from sim2reason.grading.arithmetic import Node
from sim2reason.grading.parser import parse
from sim2reason.grading.score import Refused
from sim2reason.grading.sides import flattened, statement
from sim2reason.grading.spelling import spelled
from sim2reason.grading.tokens import canonical, tokenize

__all__ = ["CompiledFormula", "compiled"]


@dataclass(frozen=True, slots=True)
class CompiledFormula:
    """A parsed formula, for repeated evaluation."""

    symbols: tuple[str, ...]
    """Those of its table that stand in it, as the table spells them."""
    _names: Mapping[str, str]
    _node: Node

    def value(self, point: Mapping[str, float]) -> float | None:
        """Return the value at `point`, which binds all `symbols`; None if it is not a finite real number."""
        return arithmetic.value(self._node, {self._names[name]: point[name] for name in self.symbols})


def compiled(latex: str, symbols: Collection[str]) -> CompiledFormula:
    r"""Parse a formula in the given `symbols`, in any spelling (``\mu_k``, ``mu_k``).

    Raises:
        ValueError: it is no formula in these symbols.
    """
    names = {name: canonical(name) for name in symbols}
    try:
        tokens = statement(flattened(tokenize(spelled(latex.strip()), frozenset(names.values())))).value
        node, taken, _ = parse(tokens, unit_follows=False)
    except Refused as refused:
        raise ValueError(f"{latex!r}: {refused}") from refused
    if taken != len(tokens):
        raise ValueError(f"{latex!r}: only its first {taken} of {len(tokens)} tokens are a formula")
    used = {token.text for token in tokens if token.kind == "symbol"}
    return CompiledFormula(tuple(name for name in names if names[name] in used), names, node)
