"""Grading responses to items: where the grader, which takes plain values, meets datasets."""

import json
from collections import Counter
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple, cast

from pydantic import BaseModel, JsonValue, ValidationError

from sim2reason.datasets.item import Answer, Item
from sim2reason.errors import DatasetError
from sim2reason.grading import Outcome, Score, formula, number

__all__ = ["Response", "Tally", "grade", "grade_answer", "line", "responses", "tallies"]


class Response(BaseModel):
    """What a policy said about the item `id`: a text, messages, or what is no answer; further fields are left alone."""

    id: str
    response: JsonValue


def grade(item: Item, response: object, *, lenient: bool = False) -> Score:
    """The score of `response` to `item`, in the item's unit and within its tolerance; a formula at its bindings.

    A direction in place of a sign is read by the item's words for what is positive. `lenient` takes the last number
    where there is no box: for evaluation, never for a reward. No formula is so taken.
    """
    return grade_answer(item.answer, response, lenient=lenient)


def grade_answer(answer: Answer, response: object, *, lenient: bool = False) -> Score:
    """The same for whoever holds the answer alone, as the rows of exports do."""
    if answer.formula is not None:
        held = answer.formula
        return formula(response, held.latex, held.points, symbols=held.symbols, positive=answer.sign)
    return number(
        response, answer.value, answer.unit, tolerance=answer.tolerance, positive=answer.sign, lenient=lenient
    )


def responses(path: Path) -> Iterator[Response]:
    """The responses in a file of JSON lines ``{id, response}``; DatasetError names a line that is none."""
    with path.open("rb") as file:
        for count, text in enumerate(file, start=1):
            if not text.strip():
                continue
            try:
                yield Response.model_validate(_whole(json.loads(text)))
            except ValidationError as error:
                problem = "; ".join(f"{'.'.join(map(str, fault['loc']))} {fault['msg']}" for fault in error.errors())
                raise DatasetError(f"{path}:{count}: {problem.strip()}; a line is {{id, response}}") from error
            except (ValueError, RecursionError) as error:
                raise DatasetError(f"{path}:{count}: no JSON: {error}; a line is {{id, response}}") from error


def _whole(read: object) -> object:
    """What was read, with a mark for each half of a surrogate pair that stands alone, since no file can hold it."""
    if isinstance(read, str):
        return read.encode(errors="replace").decode() if not read.isascii() else read
    if isinstance(read, list):
        return [_whole(part) for part in cast("list[object]", read)]
    if isinstance(read, dict):
        return {_whole(key): _whole(part) for key, part in cast("dict[object, object]", read).items()}
    return read


def line(response: Response, score: Score) -> str:
    """One line of a file of scores."""
    fields = {
        "id": response.id,
        "reward": score.reward,
        "outcome": score.outcome,
        "parsed": score.parsed,
        "why": score.why,
    }
    return json.dumps(fields, ensure_ascii=False)


class Tally(NamedTuple):
    """The grades of one group: all, or those of one recipe or kind."""

    by: str
    name: str
    responses: int
    reward: float
    outcomes: dict[Outcome, int]


def tallies(graded: Iterable[tuple[Item, Score]]) -> list[Tally]:
    """How many responses came out how: over all, then by recipe and by kind, in alphabetical order."""
    counts: dict[tuple[str, str], Counter[Outcome]] = {}
    for item, score in graded:
        for group in (("all", ""), ("recipe", item.recipe), ("kind", item.kind)):
            counts.setdefault(group, Counter())[score.outcome] += 1
    order = sorted(counts, key=lambda group: (("all", "recipe", "kind").index(group[0]), group[1]))
    return [_tally(*group, counts[group]) for group in order]


def _tally(by: str, name: str, count: Counter[Outcome]) -> Tally:
    total = count.total()
    return Tally(by, name, total, count[Outcome.CORRECT] / total, {outcome: count[outcome] for outcome in Outcome})
