"""Values told as multiples of the initial one, as *its speed has doubled*, with the number in place of the multiple."""

import re
from dataclasses import replace

from sim2reason.errors import TextError
from sim2reason.questions.following import FollowedMotion
from sim2reason.questions.posing import posed
from sim2reason.questions.structured import START, StructuredQuestion
from sim2reason.questions.words import Words

TIMES, GREATEST, AT_BURNOUT = " times that at start", " times the greatest", " times that at burnout"
_MULTIPLE = re.compile(
    rf"(?P<find>[a-z ]+?)(?: of (?P<of>.+))? = (?P<factor>[\d.]+)(?P<ref>{TIMES}|{GREATEST}|{AT_BURNOUT})"
)
SPEEDS = {"velocity": "speed", "angular velocity": "angular speed"}  # what greatest values are called by


def in_numbers(asked: StructuredQuestion, motion: FollowedMotion, words: Words) -> StructuredQuestion:
    """Return a question with the number, with its unit, that its moment tells as a multiple; others unchanged.

    Raises:
        TextError: there is no such quantity, or it is zero at the start.
    """
    found = _MULTIPLE.fullmatch(asked.when)
    if found is None:
        return asked
    find, of = found["find"], f" of {found['of']}" if found["of"] else ""
    if found["ref"] == GREATEST:
        initial = posed(StructuredQuestion(f"greatest {SPEEDS.get(find, find)}", found["of"] or ""), motion, words)
    else:
        when = "burned out" if found["ref"] == AT_BURNOUT else START
        initial = posed(StructuredQuestion(find, found["of"] or "", when), motion, words)
    value = initial.followed(motion).answer
    if not value:
        raise TextError("when", f"the {find} is zero at the start, or never greatest", "give a value")
    told = f"{find}{of} = {float(found['factor']) * value:.15g} {initial.unit(words)}"
    return replace(asked, when=told)
