"""Labels of equations: each stands for one equation of a text, whatever phases or cases it has."""

from dataclasses import dataclass


@dataclass
class Labels:
    """A counter of equation labels."""

    used: int = 0

    def next(self) -> str:
        """Return the next number in parentheses; letters are labels of the parts of a problem."""
        self.used += 1
        return f"({self.used})"
