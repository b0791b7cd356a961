"""Settings of a run of reinforcement learning that takes seconds: a warm start, three steps, held-out problems."""

from pathlib import Path
from typing import Any

PROBLEMS = {"name": "rolling", "recipe": "rolling", "difficulty": "easy", "kinds": ["state"]}


def settings(out: Path, **changed: object) -> dict[str, Any]:
    corpora = [
        {"kind": "arithmetic", "problems": {**PROBLEMS, "seed": 1}, "items": 6, "rows_each": 4},
        {"kind": "drills", "items": 20},
    ]
    model = {"kind": "scratch", "layers": 1, "width": 32, "heads": 2, "vocabulary": 700, "context": 256}
    gspo = {"steps": 3, "prompts": 4, "generations": 4, "minibatches": 2, "max_completion_tokens": 12, "save_every": 1}
    return {
        "out": str(out),
        "held_out": {"problems": {**PROBLEMS, "seed": 3}, "items": 4},
        "warm_start": {"model": model, "corpora": corpora, "steps": 4, "device": "cpu"},
        "problems": [{"kind": "fresh", **PROBLEMS, "seed": 2}],
        "prefetch": {"workers": 0},
        "reward": "random",
        "gspo": {**gspo, "learning_rate": 1e-4, "gradient_checkpointing": False},
    } | changed
