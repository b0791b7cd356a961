"""Answers of one run copied into another, whose model is the same under another path."""

import shutil
from pathlib import Path

from sim2reason.benchmarks.runs.folder import PROBLEMS, RUN, SAMPLES, PolicyPlan, RunFolder
from sim2reason.datasets.atomic_files import canonical, put_text

__all__ = ["copy_answers"]

PARTIAL = ".part"


def copy_answers(run: Path, out: Path, model: str, copied: str) -> None:
    """Begin in `out` a run with what policies of `model` have answered in `run`, as answers of its copy at `copied`.

    Nothing is begun if there are none. EvaluationError if there is no run.
    """
    found = RunFolder(run)
    policies = {name: plan for name, plan in found.record.policies.items() if plan.decisive.get("model") == model}
    if not policies:
        return
    partial = out.with_name(out.name + PARTIAL)
    shutil.rmtree(partial, ignore_errors=True)
    shutil.copytree(run / PROBLEMS, partial / PROBLEMS)
    for name in policies:
        if (run / SAMPLES / name).is_dir():
            shutil.copytree(run / SAMPLES / name, partial / SAMPLES / name)
    plans = {name: _of(plan, copied) for name, plan in policies.items()}
    record = found.record.model_copy(update={"policies": plans, "judge": None})
    put_text(partial / RUN, canonical(record.model_dump(mode="json")), partial)
    partial.rename(out)


def _of(plan: PolicyPlan, model: str) -> PolicyPlan:
    """The same policy of a model at another place."""
    settings, decisive = ({**held, "model": model} for held in (plan.settings, plan.decisive))
    return plan.model_copy(update={"settings": settings, "decisive": decisive})
