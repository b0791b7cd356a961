"""Verification of multi-part solutions from the text alone: each name has one meaning."""

import re

from sim2reason.grading.tokens import canonical
from sim2reason.testing.solutions.reading import FORMULA, read

PART = re.compile(r"^\((?P<label>[a-h])\) ", re.MULTILINE)
RECALL = re.compile(r"^From part \((?P<label>[a-h])\), (?P<results>.*)\.$", re.MULTILINE)
LABELLED = re.compile(r"(?<![^\s])(\(\d+\))(?: [A-Z][^$()]*)? \$([^$]+)\$")


def part_faults(text: str) -> list[str]:
    """Return the faults in the text of all parts, in words.

    A name that a part recalls must occur in the quoted part, with the same number; every equality of the whole text
    must hold with the first number of each name; a label must denote one equation.
    """
    body = text.partition("\n\nAnswers: ")[0]
    pieces = PART.split(body)[1:]
    parts = dict(zip(pieces[::2], pieces[1::2], strict=True))
    found = [fault for part in parts.values() for fault in _recalls(part, parts)]
    whole = read("\n\n".join(parts.values()))
    found += [f"does not hold: {broken}" for broken in whole.broken]
    found += [f"cannot be read: {unread}" for unread in whole.unread]
    equations: dict[str, str] = {}
    for label, formula in LABELLED.findall(body):
        if equations.setdefault(label, formula) != formula:
            found.append(f"{label} stands for two equations")
    return found


def _recalls(part: str, parts: dict[str, str]) -> list[str]:
    """Return faults of names that a part quotes from another part."""
    found: list[str] = []
    for recall in RECALL.finditer(part):
        source = parts.get(recall["label"], "")
        said = _numbers(RECALL.sub("", source))
        for name, number in _numbers(recall["results"]).items():
            if said.get(name) != number:
                found.append(f"part ({recall['label']}) does not say {name} = {number}")
    return found


def _numbers(text: str) -> dict[str, str]:
    """Return the names equated with numbers in a text, each with its last number as written."""
    found: dict[str, str] = {}
    for match in FORMULA.finditer(text):
        name, _, number = match[1].partition("=")
        try:
            found[canonical(name.strip())] = number.rpartition("=")[2].strip()
        except ValueError:
            continue
    return found
