"""What is asked, without words."""

from dataclasses import dataclass

from sim2reason.questions.moments import Moment
from sim2reason.questions.targets import Target


@dataclass(frozen=True, slots=True)
class Query:
    """What a question asks: of its kind, about a quantity of a subject, at a moment; a kind may do without either."""

    kind: str
    target: Target | None = None
    moment: Moment | None = None

    @property
    def hides(self) -> str:
        """The address of the number that the text must leave unknown for it; empty, by default, for none."""
        return ""

    @property
    def subjects(self) -> tuple[str, ...]:
        """Names of everything that the query is about; by default of its subject."""
        return (self.subject,)

    @property
    def subject(self) -> str:
        """Return what it is about: the subject of its quantity, else the first that its moment speaks of."""
        if self.target is not None:
            return self.target.subject
        return next(iter(self.moment.subjects), "") if self.moment is not None else ""
