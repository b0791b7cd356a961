"""Main clauses in any word order, with one quantity, at most one subject, and otherwise only filler words."""

import re
from collections.abc import Iterator, Mapping

from sim2reason.questions.ordinary.vocabulary import WORDS, pattern

FILLERS = {
    *re.split(" ", WORDS["AUX"]),
    *re.split(
        " ", "what which find determine calculate compute give how large big great strong much value magnitude size"
    ),
    *re.split(" ", "of in on that for with at then have get reach reaches attain attains acquire acquires possess"),
    *re.split(" ", "experience experiences undergo undergoes feel feels act acts acting exerted exert exerts"),
}
"""Words that say nothing beside a quantity and what has it."""
ORDER = {"initial": "initial", "GREATEST": "greatest", "LEAST": "least", "final": "final"}
FRAMES: Mapping[str, str] = {
    "": "what is {quantity}{of}",
    "initial": "what is initial {quantity}{of}",
    "final": "what is final {quantity}{of}",
    "greatest": "what is greatest {quantity}{of}",
    "least": "what is least {quantity}{of}",
}
"""By what qualifies a quantity, the plain order of words."""
_QUANTITY, _SUBJECT, _ASKS = pattern("QUANTITY"), re.compile(r"@\d+@"), re.compile(r"\b(?:what|which|find|how)\b")


def plainly_ordered(question: str) -> Iterator[str]:
    """Yield the plain word order of a clause that has one quantity, at most one subject, and otherwise only fillers."""
    quantities = re.findall(rf"(?<![\w-])(?:{_QUANTITY.pattern})(?![\w-])", question)
    subjects = _SUBJECT.findall(question)
    if len(quantities) != 1 or len(set(subjects)) > 1 or _ASKS.search(question) is None:
        return
    rest = _SUBJECT.sub(" ", question.replace(quantities[0], " ", 1)).replace("'s", " ").replace(",", " ")
    found = ""
    for told, name in ORDER.items():
        rest, count = re.subn(rf"\b{pattern(told).pattern}\b", " ", rest)
        if count and (found or count > 1):
            return
        found = name if count else found
    if not set(rest.split()) - FILLERS:
        of = f" of {subjects[0]}" if subjects else ""
        yield FRAMES[found].format(quantity=quantities[0], of=of)
