"""A question's sentence read back: the query that its words mean."""

from collections.abc import Collection

from sim2reason.questions import KINDS, Query, Study, Words
from sim2reason.questions.phrasing import sentence
from sim2reason.questions.spellings import plainly
from sim2reason.questions.targets import targets


def parse_question(text: str, study: Study, words: Words, kinds: Collection[str] | None = None) -> Query | None:
    """Return the query that a sentence expresses, found by trying all phrases of all kinds; None if none matches.

    Each kind reads numbers and names from the sentence. The rest must match the kind's `shapes` word for word, but
    numbers may be spelled in any usual way. Where `kinds` are named, only those are tried.
    """
    text, offered = sentence(plainly(text, words.units)), targets(words)
    heard = {target: noun for target, noun in offered.items() if noun.heard(text)}
    for kind in (found for name, found in KINDS.items() if kinds is None or name in kinds):
        for query in kind.parsed(text, study, words, heard):
            noun = offered[query.target] if query.target is not None else None
            if any(sentence(shape) == text for shape in (*kind.shapes(query, words, noun), *kind.former(query, words))):
                return query
    return None
