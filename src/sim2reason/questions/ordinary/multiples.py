"""Values told as multiples of the initial one, as *its speed has doubled*, with the number in place of the multiple."""

import re
from dataclasses import replace

from sim2reason.errors import TextError
from sim2reason.questions.following import FollowedMotion
from sim2reason.questions.posing import posed
from sim2reason.questions.structured import START, StructuredQuestion
from sim2reason.questions.words import Words

TIMES, GREATEST = " times that at start", " times the greatest"
_MULTIPLE = re.compile(rf"(?P<find>[a-z ]+) of (?P<of>.+) = (?P<factor>[\d.]+)(?P<ref>{TIMES}|{GREATEST})")
SPEEDS = {"velocity": "speed", "angular velocity": "angular speed"}  # what greatest values are called by


def in_numbers(asked: StructuredQuestion, motion: FollowedMotion, words: Words) -> StructuredQuestion:
    """Return a question with the number, with its unit, that its moment tells as a multiple; others unchanged.

    Raises:
        TextError: there is no such quantity, or it is zero at the start.
    """
    found = _MULTIPLE.fullmatch(asked.when)
    if found is None:
        return asked
    find = found["find"]
    if found["ref"] == GREATEST:
        initial = posed(StructuredQuestion(f"greatest {SPEEDS.get(find, find)}", found["of"]), motion, words)
    else:
        initial = posed(StructuredQuestion(find, found["of"], START), motion, words)
    value = initial.followed(motion).answer
    if not value:
        raise TextError("when", f"the {find} is zero at the start, or never greatest", "give a value")
    told = f"{found['find']} of {found['of']} = {float(found['factor']) * value:.15g} {initial.unit(words)}"
    return replace(asked, when=told)
