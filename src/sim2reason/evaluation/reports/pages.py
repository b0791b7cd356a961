"""Pages of a report: results in Markdown, and answers side by side in HTML.

The HTML page has each problem with the first response of every policy.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from html import escape

from pydantic import JsonValue

from sim2reason.evaluation.benchmarks import BenchmarkItem
from sim2reason.evaluation.benchmarks.runs.config import RunFolder, RunRecord
from sim2reason.evaluation.benchmarks.runs.run import Ending, SampleOutcome
from sim2reason.evaluation.policies.journal import read_finished
from sim2reason.evaluation.reports.results import Result

__all__ = ["answers_page", "page", "table"]

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
    sampling = settings.get("sampling")
    pairs = sampling.items() if isinstance(sampling, dict) else ()
    return ", ".join(f"{name} {value}" for name, value in pairs if value is not None)


def _groups(results: Sequence[Result]) -> Iterator[str]:
    """Yield a table for each benchmark and tag, a column for each policy."""
    for benchmark in dict.fromkeys(result.benchmark for result in results):
        benchmark_results = [result for result in results if result.benchmark == benchmark]
        for tag in sorted({tag for result in benchmark_results for tag in result.groups}):
            values = sorted({value for result in benchmark_results for value in result.groups.get(tag, {})})
            if len(values) < 2:
                continue
            yield f"## {benchmark}, by {tag}"
            yield ""
            rows = (
                [value, _count(benchmark_results, tag, value), *(_share(r, tag, value) for r in benchmark_results)]
                for value in values
            )
            yield from table([tag, "problems", *(result.policy for result in benchmark_results)], rows)
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


MAX_ITEMS = 100  # of each benchmark
MAX_RESPONSE_LENGTH = 20_000  # characters of a response
HEAD = """<!doctype html>
<html lang="en">
<meta charset="utf-8">
<title>Answers side by side</title>
<style>
body {{ font: 15px/1.45 sans-serif; margin: 2em auto; max-width: 110em; padding: 0 1em; }}
table {{ border-collapse: collapse; table-layout: fixed; width: 100%; }}
td, th {{ border: 1px solid #ccc; padding: .5em; text-align: left; vertical-align: top; }}
pre {{ margin: 0; overflow-wrap: anywhere; white-space: pre-wrap; }}
.correct {{ background: #e6f4e6; }} .partial {{ background: #fbf6dd; }}
</style>
<h1>Answers side by side</h1>
<p>The first sample of every policy to the first {most} problems of each benchmark.
What a model said is shown as it is.</p>
"""

Shown = Mapping[tuple[str, str], SampleOutcome]
"""First samples, by policy and problem."""


def answers_page(folder: RunFolder, outcomes: Mapping[str, Sequence[SampleOutcome]]) -> Iterator[str]:
    """Yield the page in pieces; `outcomes` are given by benchmark."""
    yield HEAD.format(most=MAX_ITEMS)
    for benchmark, samples in outcomes.items():
        policies = list(dict.fromkeys(outcome.policy for outcome in samples))
        first = {(outcome.policy, outcome.id): outcome for outcome in samples if outcome.sample == 0}
        items = folder.items(benchmark)[:MAX_ITEMS]
        texts = {policy: _texts(folder, policy, benchmark, {item.id for item in items}) for policy in policies}
        yield f"<h2>{escape(benchmark)}</h2>\n"
        for item in items:
            yield from _item(item, policies, first, texts)
    yield "</html>\n"


def _texts(folder: RunFolder, policy: str, benchmark: str, wanted: set[str]) -> dict[str, str]:
    """Return a policy's first responses to the wanted problems."""
    samples = read_finished(folder.samples(policy, benchmark))
    return {s.id: s.completion.whole[:MAX_RESPONSE_LENGTH] for s in samples if s.sample == 0 and s.id in wanted}


def _item(
    item: BenchmarkItem, policies: Sequence[str], first: Shown, texts: Mapping[str, Mapping[str, str]]
) -> Iterator[str]:
    yield f"<h3>{escape(item.id)}</h3>\n<pre>{escape(item.prompt)}</pre>\n"
    yield f"<p><b>Answer:</b> {escape(item.answer_text)}</p>\n<table><tr>"
    yield "".join(f"<th>{escape(policy)}</th>" for policy in policies)
    yield "</tr><tr>"
    for policy in policies:
        outcome = first.get((policy, item.id))
        if outcome is None:
            yield "<td>no answer yet</td>"
            continue
        response = escape(texts[policy].get(item.id, ""))
        why = f" <i>{escape(outcome.why)}</i>" if outcome.why else ""
        yield (
            f'<td class="{outcome.ending}"><b>{outcome.ending}</b>: {escape(outcome.parsed)}{why}'
            f"<details><summary>what it said</summary><pre>{response}</pre></details></td>"
        )
    yield "</tr></table>\n"
