"""Faults in the names of a solution with several parts; one that has any is not shown."""

from collections.abc import Iterator, Sequence

from sim2reason.grading.parts import LABELS
from sim2reason.solutions.multipart.quantities import SAME, agree, meanings, names_of
from sim2reason.solutions.multipart.recall import EARLIER
from sim2reason.solutions.solution import Solution
from sim2reason.solutions.writing.subscripts import split


def naming_fault(parts: Sequence[Solution]) -> str:
    """Return the first fault in the names of several parts, in words; empty if there is none.

    A name has one value and one meaning in all parts, and what is introduced in the same words has the same name. A
    result that a part recalls is one that the part from which it is recalled leads to, by the same name.
    """
    return next((fault for fault in (*_recalled(parts), *_doubled(parts), *_called_twice(parts))), "")


def _recalled(parts: Sequence[Solution]) -> Iterator[str]:
    """Yield faults: results that a part recalls from a part which does not have them."""
    for label, part in zip(LABELS, parts, strict=False):
        for step in part.steps:
            if step.kind != EARLIER:
                continue
            source = step.text.removeprefix("From part (").partition(")")[0]
            other = parts[LABELS.index(source)] if source and source in LABELS[: LABELS.index(label)] else None
            found = {name for held in (other.steps if other else ()) if held.kind != EARLIER for name in held.gives}
            for name in step.gives:
                if other is None or name not in found | {other.goal}:
                    yield f"part ({label}) takes {name} from part ({source}), which has no {name}"
                elif not _same(part, other, name):
                    yield f"part ({label}) takes {name} from part ({source}), where it has another value"


def _doubled(parts: Sequence[Solution]) -> Iterator[str]:
    """Yield faults: names that have different meanings in two parts."""
    known: dict[str, tuple[str, Solution, str]] = {}
    for label, part in zip(LABELS, parts, strict=False):
        if part.answer is None:
            continue
        words = meanings(part)
        for name in dict.fromkeys([*names_of(part.steps), part.goal]):
            first, other, meaning = known.setdefault(name, (label, part, words.get(name, "")))
            if name in part.values and name in other.values and not _same(part, other, name):
                yield f"{name} has one value in part ({first}) and another in part ({label})"
            if not agree(name, meaning, words.get(name, "")):
                yield f"{name} is {meaning!r} in part ({first}) and {words[name]!r} in part ({label})"
            if not meaning and name in words:
                known[name] = (label, part, words[name])


def _called_twice(parts: Sequence[Solution]) -> Iterator[str]:
    """Yield faults: quantities to which two parts give different names."""
    known: dict[tuple[str, str, str], tuple[str, set[str]]] = {}
    for label, part in zip(LABELS, parts, strict=False):
        own: dict[tuple[str, str, str], set[str]] = {}
        for name, words in meanings(part).items():
            if name in part.values:
                own.setdefault((split(name)[0], words, f"{part.values[name]:.9g}"), set()).add(name)
        for key, names in own.items():
            first, called = known.setdefault(key, (label, names))
            if called.isdisjoint(names):
                yield f"{min(called)} of part ({first}) is called {min(names)} in part ({label})"


def _same(part: Solution, other: Solution, name: str) -> bool:
    return abs(part.values[name] - other.values[name]) <= SAME * abs(other.values[name])
