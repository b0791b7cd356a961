"""Where prompts come from: a stream with a cursor, which one process reads for all."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol

from pydantic import JsonValue

from sim2reason.errors import TrainingError

__all__ = ["Drawn", "PromptStream", "draw"]

OVERLONG = 100  # prompts that may be passed over for one that is wanted, before a stream counts as unfit
PICTURES = {"image", "images", "environment"}  # columns that TRL would act on

Row = dict[str, Any]


class PromptStream(Protocol):
    """Prompts, finitely many or endless, in an order that is the same for every reader and every reading.

    A row is a dictionary with *prompt*, a text or a list of messages, and whatever rewards read: *ground_truth*, *id*,
    *source*. All other columns reach the reward functions, with None where a row lacks them.
    """

    @property
    def cpu_seconds(self) -> float:
        """CPU time that other processes have spent on rows so far; how long this one waits is measured as it waits."""
        ...

    def next_prompts(self, count: int) -> Sequence[Mapping[str, Any]]:
        """The next `count` rows; fewer say that there are no more."""
        ...

    def observe(self, row: Mapping[str, Any], rewards: Sequence[float]) -> None:
        """Be told the rewards of a row's completions, in the order of the rows; a curriculum may follow them."""
        ...

    def state(self) -> JsonValue:
        """The cursor: what `restore` needs so that the next row is the one after those handed out."""
        ...

    def restore(self, state: JsonValue) -> None:
        """Go where a state was taken."""
        ...


@dataclass
class Drawn:
    """What one process drew for all."""

    rows: list[Row] = field(default_factory=list[Row])
    read: int = 0
    """Rows that the stream gave, with those that were passed over."""
    exhausted: bool = False


def draw(stream: PromptStream, count: int, fits: Callable[[Row], bool]) -> Drawn:
    """The next `count` rows that fit, or as many as there are, all with the same columns.

    Raises:
        TrainingError: a row has no prompt or has pictures, texts and messages are mixed, or hardly a prompt fits.
    """
    drawn = Drawn()
    while len(drawn.rows) < count and not drawn.exhausted:
        wanted = count - len(drawn.rows)
        found = [dict(row) for row in stream.next_prompts(wanted)]
        if len(found) > wanted:
            raise TrainingError(f"a stream of prompts gave {len(found)} rows where {wanted} were asked for")
        drawn.exhausted = len(found) < wanted
        drawn.read += len(found)
        drawn.rows += [row for row in found if _checked(row) and fits(row)]
        if drawn.read - len(drawn.rows) > OVERLONG * count:
            raise TrainingError(
                f"only {len(drawn.rows)} of {drawn.read} prompts are short enough; raise max_prompt_tokens"
            )
    if len({isinstance(row["prompt"], str) for row in drawn.rows}) > 1:
        raise TrainingError("some prompts are texts and some are messages; give all of them in one form")
    columns = sorted({name for row in drawn.rows for name in row})
    drawn.rows = [{name: row.get(name) for name in columns} for row in drawn.rows]
    return drawn


def _checked(row: Row) -> bool:
    prompt = row.get("prompt")
    if not isinstance(prompt, str | list) or not prompt:
        raise TrainingError(f"a row without a prompt, with the columns {', '.join(map(str, row))}"[:200])
    if PICTURES & row.keys():
        raise TrainingError(f"a row with the column {min(PICTURES & row.keys())!r}: prompts here are text alone")
    return True
