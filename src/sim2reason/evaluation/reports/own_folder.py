"""The folder of a result: a new one, or that of an earlier result of the same kind; never one of something else."""

from pathlib import Path

from sim2reason.errors import EvaluationError

__all__ = ["own_folder"]


def own_folder(out: Path, result: str) -> None:
    """Make the folder; EvaluationError if it holds something, and no file of the name `result` among that."""
    out.mkdir(parents=True, exist_ok=True)
    if not (out / result).is_file() and (strangers := sorted(path.name for path in out.iterdir())):
        raise EvaluationError(f"{out}: holds {strangers[0]} and no {result}; choose a new folder")
