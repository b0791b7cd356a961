"""HTML page of answers side by side: each problem with the first response of every policy."""

from collections.abc import Iterator, Mapping, Sequence
from html import escape

from sim2reason.evaluation.benchmarks import BenchmarkItem
from sim2reason.evaluation.benchmarks.runs.folder import RunFolder
from sim2reason.evaluation.benchmarks.runs.outcomes import SampleOutcome
from sim2reason.evaluation.policies.samples.journal import finished

__all__ = ["answers_page"]

MOST_ITEMS = 100  # of each benchmark
LONGEST = 20_000  # characters of a response
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
    yield HEAD.format(most=MOST_ITEMS)
    for benchmark, held in outcomes.items():
        policies = list(dict.fromkeys(outcome.policy for outcome in held))
        first = {(outcome.policy, outcome.id): outcome for outcome in held if outcome.sample == 0}
        items = folder.items(benchmark)[:MOST_ITEMS]
        texts = {policy: _texts(folder, policy, benchmark, {item.id for item in items}) for policy in policies}
        yield f"<h2>{escape(benchmark)}</h2>\n"
        for item in items:
            yield from _item(item, policies, first, texts)
    yield "</html>\n"


def _texts(folder: RunFolder, policy: str, benchmark: str, wanted: set[str]) -> dict[str, str]:
    """Return a policy's first responses to the wanted problems."""
    samples = finished(folder.samples(policy, benchmark))
    return {s.id: s.completion.whole[:LONGEST] for s in samples if s.sample == 0 and s.id in wanted}


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
        said = escape(texts[policy].get(item.id, ""))
        why = f" <i>{escape(outcome.why)}</i>" if outcome.why else ""
        yield (
            f'<td class="{outcome.ending}"><b>{outcome.ending}</b>: {escape(outcome.parsed)}{why}'
            f"<details><summary>what it said</summary><pre>{said}</pre></details></td>"
        )
    yield "</tr></table>\n"
