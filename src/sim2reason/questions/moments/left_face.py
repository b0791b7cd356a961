"""The instant at which a body leaves the face on which it moves."""

from dataclasses import dataclass

from sim2reason.quantities.subjects.contacts import Contacts
from sim2reason.questions.moments import MOMENTS
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

    def does(self, words: Words) -> Verb:
        """As in: loses contact with the dome."""
        surface = words.fills(self.of, self.name)["surface"]
        return Verb(self.verb.told.format(surface=surface), self.verb.asked.format(surface=surface))
