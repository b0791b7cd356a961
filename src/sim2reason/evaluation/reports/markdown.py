"""A report as a page of Markdown."""

from collections.abc import Iterable, Iterator, Mapping, Sequence

from pydantic import JsonValue

from sim2reason.evaluation.benchmarks.runs.folder import RunRecord
from sim2reason.evaluation.benchmarks.runs.outcomes import Ending
from sim2reason.evaluation.reports.results import Result

__all__ = ["page", "table"]

MARKS = str.maketrans({"|": r"\|", "\n": " ", "\r": " ", "<": "&lt;", "`": "'"})


def table(head: Sequence[str], rows: Iterable[Sequence[object]]) -> Iterator[str]:
    """Yield the lines of a Markdown table with escaped cells."""
    yield f"| {' | '.join(head)} |"
    yield f"|{' --- |' * len(head)}"
    for row in rows:
        yield f"| {' | '.join(str(cell).translate(MARKS) for cell in row)} |"


def page(record: RunRecord, results: Sequence[Result], pictures: Sequence[str], notes: Sequence[str] = ()) -> str:
    """Return the whole page of a report."""
    return "\n".join([*_head(results, notes), *_settings(record), *_groups(results), *_pictures(pictures), ""])


def _head(results: Sequence[Result], notes: Sequence[str]) -> Iterator[str]:
    yield "# Evaluation"
    yield ""
    yield "Accuracy in per cent with its 95 % interval, each problem counting alike (mean@k for k samples a problem)."
    yield "Intervals: Wilson's for one sample a problem, else a bootstrap over problems. pass@k is without bias."
    yield ""
    head = ["benchmark", "policy", "problems", "k", "mean@k", "pass@k", "mean tokens", "missing"]
    yield from table(head, (_row(result) for result in results))
    yield ""
    yield from (f"**{note}**\n" for note in notes)
    if any(result.judged for result in results):
        judged = sum(result.judged for result in results)
        yield f"A judge ruled on {judged} responses that the rules did not find right.\n"
    yield "## How responses ended"
    yield ""
    ends = [str(ending) for ending in Ending]
    rows = ([r.benchmark, r.policy, r.responses, *(r.endings[ending] for ending in Ending)] for r in results)
    yield from table(["benchmark", "policy", "responses", *ends], rows)
    yield ""


def _row(result: Result) -> list[object]:
    k = max(result.pass_at, default=1)
    passed = f"{100 * result.pass_at[k]:.1f} (k = {k})" if result.pass_at else ""
    tokens = "not counted" if result.tokens is None else f"{result.tokens:.0f}"
    shown = result.accuracy.shown
    return [result.benchmark, result.policy, result.items, result.samples, shown, passed, tokens, result.missing]


def _settings(record: RunRecord) -> Iterator[str]:
    yield "## Settings"
    yield ""
    yield f"Seed {record.seed}; sim2reason {record.versions.get('sim2reason', '?')}."
    yield ""
    policies = ([name, _model(plan.settings), _sampling(plan.settings)] for name, plan in record.policies.items())
    yield from table(["policy", "model", "sampling"], policies)
    yield ""
    rows = ([name, plan.items, plan.samples, plan.data[:16]] for name, plan in record.benchmarks.items())
    yield from table(["benchmark", "problems", "k", "hash of the data"], rows)
    yield ""


def _model(settings: Mapping[str, JsonValue]) -> str:
    return f"{settings.get('model', '')} {settings.get('url', '')}".strip()


def _sampling(settings: Mapping[str, JsonValue]) -> str:
    found = settings.get("sampling")
    pairs = found.items() if isinstance(found, dict) else ()
    return ", ".join(f"{name} {value}" for name, value in pairs if value is not None)


def _groups(results: Sequence[Result]) -> Iterator[str]:
    """Yield a table for each benchmark and tag, a column for each policy."""
    for benchmark in dict.fromkeys(result.benchmark for result in results):
        held = [result for result in results if result.benchmark == benchmark]
        for tag in sorted({tag for result in held for tag in result.groups}):
            values = sorted({value for result in held for value in result.groups.get(tag, {})})
            if len(values) < 2:
                continue
            yield f"## {benchmark}, by {tag}"
            yield ""
            rows = ([value, _count(held, tag, value), *(_share(r, tag, value) for r in held)] for value in values)
            yield from table([tag, "problems", *(result.policy for result in held)], rows)
            yield ""


def _count(results: Sequence[Result], tag: str, value: str) -> int:
    return max(r.groups[tag][value].items for r in results if value in r.groups.get(tag, {}))


def _share(result: Result, tag: str, value: str) -> str:
    group = result.groups.get(tag, {}).get(value)
    return "" if group is None else group.accuracy.shown


def _pictures(names: Sequence[str]) -> Iterator[str]:
    for name in names:
        yield f"![{name.partition('.')[0]}]({name})"
        yield ""
