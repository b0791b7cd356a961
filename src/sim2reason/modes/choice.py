"""The choice mode: a numeric question with options, which the wrong answers give to which slips lead."""

from sim2reason.modes.numeric import Numeric
from sim2reason.questions import ParsedQuestion, Study, Words, mode


@mode
class Choice(Numeric):
    """Which of several numbers is it?"""

    name = "choice"
    offers_options = True

    def parsed(self, text: str, study: Study, words: Words) -> ParsedQuestion | None:
        """None: without its options it is a numeric question, and is read as one."""
        del text, study, words
        return None
