"""The instant at which a body leaves the face on which it moves."""

from dataclasses import dataclass

from sim2reason.quantities.subjects.contacts import Contacts
from sim2reason.questions.moments import MOMENTS, Clause
from sim2reason.questions.moments.parts.occurrence import Occurrence
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.words import Words


@MOMENTS.register("left_face")
@dataclass(frozen=True, slots=True)
class LeftFace(Occurrence):
    """The instant at which a body loses contact with its face; the description ends there."""

    label = "lift-off"
    own = True
    kinds = ("lift",)
    of = Contacts()
    most = 0
    verb = Verb("loses contact with {surface}", "lose contact with {surface}")

    def _verb(self, words: Words) -> Verb:
        surface = words.fills(self.of, self.name)["surface"]
        return Verb(self.verb.told.format(surface=surface), self.verb.asked.format(surface=surface))

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: when the ball loses contact with the dome."""
        return self._verb(words).phrases(self.subject(words), None)

    def clause(self, words: Words) -> Clause | None:
        """As in: the ball loses contact with the dome."""
        return self._verb(words).clause(self.subject(words), None)
