"""Journal of finished samples: JSON lines, each synced to disk before the next step.

A kill can truncate only the last line; it is removed when the journal is opened, and its sample is requested again.
"""

import fcntl
import os
from collections.abc import Iterator
from hashlib import sha256
from pathlib import Path
from threading import Lock
from types import TracebackType
from typing import IO, Self

from pydantic import BaseModel, ConfigDict, ValidationError

from sim2reason.errors import EvaluationError
from sim2reason.evaluation.policies import Completion, SampleRequest

__all__ = ["FinishedSample", "SampleJournal", "prompt_hash", "read_finished"]

BLOCK_SIZE = 2**16  # bytes read at once in the search for the last line feed


class FinishedSample(BaseModel):
    """A finished response of a policy, stored as one line of a run's file of responses."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    id: str
    sample: int
    seed: int
    prompt: str
    """A hash of what was asked."""
    completion: Completion

    @property
    def key(self) -> tuple[str, int]:
        """Return the unique key of the line: id and sample number."""
        return self.id, self.sample


def prompt_hash(prompt: str) -> str:
    """Return the hash of a prompt that a journal stores."""
    return sha256(prompt.encode(errors="replace")).hexdigest()[:16]


def read_finished(path: Path) -> Iterator[FinishedSample]:
    """Yield the samples of a journal in order of completion; none if the file does not exist.

    Raises:
        EvaluationError: a line that is none, but for a torn last one, or the same sample twice.
    """
    if not path.is_file():
        return
    seen: set[tuple[str, int]] = set()
    with path.open("rb") as file:
        for count, line in enumerate(file, start=1):
            if not line.endswith(b"\n"):
                return
            sample = _sample(path, count, line)
            if sample.key in seen:
                raise EvaluationError(f"{path}:{count}: holds {sample.id} a second time; remove that line")
            seen.add(sample.key)
            yield sample


def _sample(path: Path, count: int, line: bytes) -> FinishedSample:
    try:
        return FinishedSample.model_validate_json(line)
    except ValidationError:
        raise EvaluationError(f"{path}:{count}: damaged; remove that line, and the sample is asked for again") from None


class SampleJournal:
    """A journal open for appending, locked against other processes."""

    def __init__(self, path: Path) -> None:
        """Open `path`, remove an incomplete last line, and read the finished samples.

        Raises:
            EvaluationError: another run has it open, or a line is damaged.
        """
        self.path = path
        path.parent.mkdir(parents=True, exist_ok=True)
        self._file: IO[bytes] = path.open("ab")
        self._lock = Lock()
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            self._cut()
            self._known = {sample.key: (sample.seed, sample.prompt) for sample in read_finished(path)}
        except BlockingIOError:
            self._file.close()
            raise EvaluationError(f"{path}: another run is writing here; wait for it") from None
        except EvaluationError:
            self._file.close()
            raise

    def _cut(self) -> None:
        """Remove everything after the last line feed."""
        size = complete_size = self.path.stat().st_size
        with self.path.open("rb") as file:
            while complete_size:
                start = max(0, complete_size - BLOCK_SIZE)
                file.seek(start)
                end = file.read(complete_size - start).rfind(b"\n") + 1
                complete_size = start + end
                if end:
                    break
        if complete_size < size:
            self._file.truncate(complete_size)
            os.fsync(self._file.fileno())

    def __enter__(self) -> Self:
        """Return the journal."""
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        """Close the file and release its lock, between two lines."""
        with self._lock:
            self._file.close()

    def __len__(self) -> int:
        """Return the number of finished samples."""
        return len(self._known)

    def holds(self, request: SampleRequest) -> bool:
        """Return whether a request is finished; EvaluationError if its prompt or seed differs."""
        known = self._known.get((request.id, request.sample))
        if known is not None and known != (request.seed, prompt_hash(request.prompt)):
            raise EvaluationError(f"{self.path}: {request.id} was asked in other words; choose a new folder")
        return known is not None

    def add(self, request: SampleRequest, completion: Completion) -> None:
        """Write a finished sample and sync it to disk; safe to call from several threads."""
        key, digest = (request.id, request.sample), prompt_hash(request.prompt)
        line = FinishedSample(
            id=request.id, sample=request.sample, seed=request.seed, prompt=digest, completion=completion
        ).model_dump_json()
        with self._lock:
            if key in self._known:
                raise ValueError(f"{request.id}: sample {request.sample} is finished already")
            self._file.write(f"{line}\n".encode(errors="replace"))
            self._file.flush()
            os.fsync(self._file.fileno())
            self._known[key] = (request.seed, digest)
