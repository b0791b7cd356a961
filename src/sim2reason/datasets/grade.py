"""Grading of responses to items and to rows of datasets."""

import json
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from itertools import groupby
from math import isnan
from typing import IO, NamedTuple, Protocol, cast, runtime_checkable

from pydantic import BaseModel, JsonValue, ValidationError

from sim2reason.base.settings import first_fault
from sim2reason.datasets.dataset import Dataset, quote_id
from sim2reason.datasets.plan import ALL_NAMES, Names
from sim2reason.errors import DatasetError
from sim2reason.generation.item import Answer, Item, grade_answer, unfolded
from sim2reason.grading import Outcome, Score, opened

__all__ = ["GradedResponse", "Response", "Tallies", "Tally", "grade", "grade_all", "line", "responses"]

MAX_DEPTH = 40  # levels of nested groups, lists and wrappers


@runtime_checkable
class ItemRow(Protocol):
    """A row of a table with values by column name: a mapping, or a pandas Series."""

    def keys(self) -> Iterable[object]:
        """Return the names of the columns."""
        ...

    def __getitem__(self, name: str, /) -> object:
        """Return the value of a column."""
        ...


class NamedRow(Protocol):
    """A row of a table as a named tuple, such as those from ``itertuples`` of pandas."""

    def _asdict(self) -> Mapping[str, object]:
        """Return the values by column."""
        ...


def row_answer(given: ItemRow | NamedRow) -> Answer:
    """Return the answer in a row; DatasetError if there is no readable one."""
    row = given if isinstance(given, ItemRow) else _unnamed(given)
    if not isinstance(row, ItemRow):
        raise DatasetError(f"{type(given).__name__} is no item; give an Item, or a row of a dataset")
    if "answer" not in set(row.keys()):
        raise DatasetError(f"a row without the column 'answer'; it has: {', '.join(map(str, row.keys()))[:200]}")
    try:
        return Answer.model_validate(unfolded(to_plain(row["answer"])))
    except ValidationError as error:
        fault = error.errors()[0]
        where, problem = ".".join(map(str, ("answer", *fault["loc"]))), fault["msg"]
    except ValueError as error:
        where, problem = "answer", f"no JSON: {error}"
    raise DatasetError(f"{where}: {problem}; give a row of a dataset as it was read")


def _unnamed(row: object) -> object:
    """Return a named tuple as a mapping; any other object unchanged."""
    names = None if isinstance(row, type) else getattr(row, "_asdict", None)
    return names() if callable(names) else row


def to_plain(value: object, depth: int = MAX_DEPTH) -> object:
    """Return a value of numpy, pandas or pyarrow as plain Python; a mapping with only empty values becomes None.

    Values nested deeper than any item's column are unchanged.
    """
    if not depth:
        return value
    for conversion in ("as_py", "tolist", "to_list"):  # a scalar of pyarrow; an array or a number; a Series of polars
        method = getattr(value, conversion, None)
        if callable(method):
            return to_plain(method(), depth - 1)
    if isinstance(value, Mapping):
        members = {
            str(key): to_plain(member, depth - 1) for key, member in cast("Mapping[object, object]", value).items()
        }
        return members if any(member is not None for member in members.values()) else None
    if isinstance(value, list | tuple):
        return [to_plain(member, depth - 1) for member in cast("Iterable[object]", value)]
    return None if isinstance(value, float) and isnan(value) else value


MAX_LINE_LENGTH = 2**27  # bytes
TOGETHER = 2000, 2**23  # responses graded together, at most, and bytes of their lines


class Response(BaseModel):
    """The response of a policy to the item `id`: a text, or messages; further fields are ignored.

    In a file, a list of texts counts as several responses.
    """

    id: str
    response: JsonValue


class GradedResponse(NamedTuple):
    """A response with its score, and the recipe and kind by which results are grouped."""

    response: Response
    score: Score
    recipe: str
    kind: str


def grade(
    item: Item | ItemRow | NamedRow,
    response: object,
    *,
    lenient: bool = False,
    partial: bool = False,
    thinking_opened: bool = False,
) -> Score:
    r"""Grade a response to a problem.

    A number is right within the tolerance of the item, in its unit or converted to it; a formula is right if it has the
    values of the reference formula. In place of a sign a response may give a direction in the words of the prompt.

    Args:
        item: An item, or a row of a dataset as `datasets`, pandas (a named tuple, too), polars or pyarrow return it.
            Only its answer is used.
        response: The whole text of the response, or a list of messages, of which the last counts.
        lenient: Whether to take the last number if there is no box; for evaluation, never for a reward. It does not
            apply to formulas, nor to problems with several parts.
        partial: Whether a response to a problem with several parts earns the share of the parts that are right; by
            default it must have all of them right.
        thinking_opened: Whether the prompt ended within the thinking, as with some chat templates; then nothing before
            the end of the thinking counts.

    Returns:
        The score, with a reward from 0 to 1, the outcome, and the reason in words.

    Raises:
        DatasetError: The row has no readable answer.

    Examples:
        >>> import sim2reason
        >>> problem = sim2reason.item("pulley", "easy")
        >>> score = sim2reason.grade(problem, r"So the answer is \boxed{123 m/s^2}.")
        >>> score.reward, score.outcome.value
        (0.0, 'wrong')
    """
    answer = item.answer if isinstance(item, Item) else row_answer(item)
    reply = opened(response) if thinking_opened else response
    return grade_answer(answer, reply, lenient=lenient, partial=partial)


def grade_all(
    data: Dataset,
    given: Iterable[Response],
    *,
    split: Names = ALL_NAMES,
    lenient: bool = False,
    partial: bool = False,
    thinking_opened: bool = False,
) -> Iterator[GradedResponse]:
    """Yield responses with their scores in order; few are in memory at a time.

    Responses to problems of other splits are skipped. DatasetError names an unknown id or split, or states that no
    response is to a problem of these splits.
    """
    splits, passed_over, matched = data.splits(split), False, False
    for _, some in groupby(_numbered(given), key=lambda pair: pair[0]):
        batch = [response for _, response in some]
        rows = data.rows_of({response.id for response in batch}, "recipe", "kind", "answer")
        for response in batch:
            row = rows.get(response.id)
            if row is None:
                raise DatasetError(f"{quote_id(response.id)} is no item of {data.path}; give the dataset it is from")
            if row["split"] not in splits:
                passed_over = True
                continue
            matched = True
            score = grade(row, response.response, lenient=lenient, partial=partial, thinking_opened=thinking_opened)
            yield GradedResponse(response, score, row["recipe"], row["kind"])
    if passed_over and not matched:
        raise DatasetError(f"{data.path}: no response is to a problem of {' or '.join(splits)}; give another --split")


def _numbered(given: Iterable[Response]) -> Iterator[tuple[int, Response]]:
    """Yield each response with the number of the batch in which it is graded."""
    group, count, size = 0, 0, 0
    for response in given:
        count, size = count + 1, size + len(str(response.response))
        yield group, response
        if count >= TOGETHER[0] or size >= TOGETHER[1]:
            group, count, size = group + 1, 0, 0


def responses(file: IO[bytes], name: str) -> Iterator[Response]:
    """Yield the responses in JSON lines ``{id, response}``; DatasetError, with the file's `name`, if invalid."""
    any_response = False
    for count, text in enumerate(iter(lambda: file.readline(MAX_LINE_LENGTH), b""), start=1):
        if len(text) == MAX_LINE_LENGTH:
            raise DatasetError(f"{name}:{count}: more than {MAX_LINE_LENGTH} bytes; a line is {{id, response}}")
        if text.strip():
            any_response = True
            yield from _each(_response(text, f"{name}:{count}"))
    if not any_response:
        raise DatasetError(f"{name}: holds no response; give a line {{id, response}} for each")


def _each(line: Response) -> Iterator[Response]:
    """Yield the responses on a line of a responses file: each text in a list, or the messages of one conversation."""
    response = line.response
    if isinstance(response, list) and response and all(isinstance(text, str) for text in response):
        yield from (line.model_copy(update={"response": text}) for text in response)
    else:
        yield line


def _response(text: bytes, location: str) -> Response:
    try:
        return Response.model_validate(_replace_surrogates(json.loads(text)))
    except ValidationError as error:
        raise DatasetError(f"{location}: {first_fault(error)}; a line is {{id, response}}") from error
    except (ValueError, RecursionError) as error:
        raise DatasetError(f"{location}: no JSON: {error}; a line is {{id, response}}") from error


def _replace_surrogates(read: object) -> object:
    """Return a JSON value with unpaired surrogates replaced, since no file can contain them."""
    if isinstance(read, str):
        return read.encode(errors="replace").decode() if not read.isascii() else read
    if isinstance(read, list):
        return [_replace_surrogates(part) for part in cast("list[object]", read)]
    if isinstance(read, dict):
        return {
            _replace_surrogates(key): _replace_surrogates(part)
            for key, part in cast("dict[object, object]", read).items()
        }
    return read


def line(response: Response, score: Score) -> str:
    """Return one line of a file of scores."""
    fields: dict[str, object] = {
        "id": response.id,
        "reward": score.reward,
        "outcome": score.outcome,
        "parsed": score.parsed,
        "why": score.why,
    }
    if score.parts:
        fields["parts"] = [{"reward": part.reward, "outcome": part.outcome} for part in score.parts]
    return json.dumps(fields, ensure_ascii=False)


class Tally(NamedTuple):
    """The number, mean reward and outcomes of the responses of one group: all, one recipe or one kind."""

    by: str
    name: str
    responses: int
    reward: float
    outcomes: dict[Outcome, int]


class Tallies:
    """Counts of outcomes and sums of rewards over responses: of all, by recipe and by kind."""

    def __init__(self) -> None:
        """Start without counts."""
        self._counts: dict[tuple[str, str], Counter[Outcome]] = {}
        self._paid: dict[tuple[str, str], float] = {}

    def add(self, found: GradedResponse) -> None:
        """Count one response in each of its groups."""
        for group in (("all", ""), ("recipe", found.recipe), ("kind", found.kind)):
            self._counts.setdefault(group, Counter())[found.score.outcome] += 1
            self._paid[group] = self._paid.get(group, 0.0) + found.score.reward

    def __iter__(self) -> Iterator[Tally]:
        """Yield the tallies of all, then by recipe and by kind, in alphabetical order."""
        order = sorted(self._counts, key=lambda group: (("all", "recipe", "kind").index(group[0]), group[1]))
        return (_tally(*group, self._counts[group], self._paid[group]) for group in order)


def _tally(by: str, name: str, count: Counter[Outcome], paid: float) -> Tally:
    total = count.total()
    return Tally(by, name, total, paid / total, {outcome: count[outcome] for outcome in Outcome})
