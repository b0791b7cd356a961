"""The choice mode: a numeric question with options, which the wrong answers give to which slips lead."""

from sim2reason.generation.modes.numeric import Numeric
from sim2reason.questions import KINDS, ParsedQuestion, Study, Words, mode
from sim2reason.questions.parse_question import parse_question


@mode
class Choice(Numeric):
    """Which of several numbers is it?"""

    name = "choice"
    offers_options = True

    def parsed(self, text: str, study: Study, words: Words) -> ParsedQuestion | None:
        """Parse a question that asks which of two candidates is first or greater; return None for any other."""
        own = [name for name, kind in KINDS.items() if kind.names_one]
        found = parse_question(text, study, words, own) if not words.symbolic else None
        return ParsedQuestion(self.name, found) if found is not None else None
