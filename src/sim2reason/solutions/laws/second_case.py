"""The second of two cases told briefly: laws that repeat those of the first under new names are not set up again."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace

from sim2reason.solutions.multipart.renaming import TOKEN
from sim2reason.solutions.setting import joined
from sim2reason.solutions.solution import Step
from sim2reason.solutions.writing.steps import Book

LABEL = re.compile(r"\(\d+\)")
PIECE = re.compile(rf"{LABEL.pattern}|{TOKEN.pattern}")
KEPT = "verify", "solve"  # kinds of steps that are told again, under new names
FEW = 20  # words, of which it is not worth while to leave out fewer


def shorten_second_case(book: Book, begun: int) -> None:
    """Say that the laws are the same in place of the steps from `begun` on that set them up once more."""
    first, second, names = book.steps[:begun], book.steps[begun:], dict[str, str]()
    repeated = _repeated(book, first, second, names)
    if sum(len(step.text.split()) for step in repeated) < FEW:
        return
    rest = [step for step in second if step not in repeated]
    used = {match[0] for step in rest for match in TOKEN.finditer(step.text)}
    known = {name for step in first for name in step.gives} | book.stated.keys()
    new = {name: old for name, old in names.items() if name in used - known and name != old}
    labels, told = _labels(first, rest, names), _same_laws(new)
    for number, step in enumerate(second):
        text = ("" if step is not repeated[0] else told) if step in repeated else _relabelled(step.text, labels)
        gives = tuple(labels.get(name, name) for name in step.gives) if step not in repeated else step.gives
        book.steps[begun + number] = replace(step, text=text, gives=gives)


def _same_laws(names: Mapping[str, str]) -> str:
    """Return the sentence that the laws are the same, with what stands in them in place of what."""
    said = [f"${new}$ in place of ${old}$" for new, old in names.items()]
    return f"The laws are the same as before{f', with {joined(said)}' if said else ''}."


def _repeated(book: Book, first: Sequence[Step], second: Sequence[Step], names: dict[str, str]) -> list[Step]:
    """Return the steps that set up a law of the first case again, and add their new names, each with its old one."""
    found: list[Step] = []
    for step in second:
        valued = any(name in book.values for name in step.gives)
        for other in first if not valued and step.kind not in KEPT else ():
            pairs = _renaming(step.text, other.text)
            if pairs is not None and all(names.get(new, old) == old for new, old in pairs.items()):
                names |= pairs
                found.append(step)
                break
    return found


def _renaming(text: str, other: str) -> dict[str, str] | None:
    """Return the names, and labels, of another text by those of a text that differs in nothing else; else None."""
    pieces, others = [PIECE.findall(held) and [m[0] for m in PIECE.finditer(held)] for held in (text, other)]
    if PIECE.split(text)[:: PIECE.groups + 1] != PIECE.split(other)[:: PIECE.groups + 1]:
        return None
    found: dict[str, str] = {}
    for new, old in zip(pieces, others, strict=True):
        if found.setdefault(new, old) != old:
            return None
    return found


def _labels(first: Sequence[Step], rest: Sequence[Step], names: Mapping[str, str]) -> dict[str, str]:
    """Return new labels of equations: those of the first case for laws that are not told again, else the next ones."""
    told = max((int(label[1:-1]) for step in first for label in LABEL.findall(step.text)), default=0)
    found = {new: old for new, old in names.items() if LABEL.fullmatch(new)}
    for step in rest:
        for label in LABEL.findall(step.text):
            if label not in found and int(label[1:-1]) > told:
                found[label] = f"({told + 1 + sum(1 for new in found.values() if int(new[1:-1]) > told)})"
    return found


def _relabelled(text: str, labels: Mapping[str, str]) -> str:
    parts = text.split("$")
    parts[::2] = [LABEL.sub(lambda match: labels.get(match[0], match[0]), part) for part in parts[::2]]
    return "$".join(parts)
