"""Benchmark files, local or on the Hugging Face Hub, verified by their hash and read as rows."""

# pyarrow ships no types:
# pyright: reportMissingTypeStubs=false, reportUnknownMemberType=false, reportUnknownVariableType=false

import json
from io import BytesIO
from pathlib import Path
from typing import Any, Final, cast

from pydantic import BaseModel, ConfigDict

from sim2reason.base.atomic_files import checksum
from sim2reason.base.optional import optional
from sim2reason.errors import EvaluationError
from sim2reason.evaluation.policies.parts.hub import out_of_reach

__all__ = ["HubFile", "Row", "fetched", "rows"]

LARGEST: Final = 2**30  # bytes
Row = dict[str, Any]


class HubFile(BaseModel):
    """A file of a dataset on the Hugging Face hub."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    repository: str
    path: str
    revision: str = "main"


def fetched(file: HubFile) -> Path:
    """Return the path of a file in the Hub's local cache, after downloading it if necessary.

    Raises:
        MissingExtraError: the library is missing.
        EvaluationError: the hub gives no such file.
    """
    hub = optional("huggingface_hub", "eval")
    try:
        kept = out_of_reach(file.repository, "dataset", file.revision)
        found = hub.hf_hub_download(
            file.repository, file.path, repo_type="dataset", revision=file.revision, local_files_only=kept
        )
    except Exception as error:  # noqa: BLE001 - the library raises what its transport does
        why = type(error).__name__
        raise EvaluationError(f"hub: no {file.path} of {file.repository} at {file.revision} ({why})") from None
    return Path(found)


def rows(path: Path, sha256: str | None = None) -> list[Row]:
    """Return the rows of a file with the suffix .json, .jsonl or .parquet.

    Raises:
        EvaluationError: it is missing, too large, of another hash, or no list of objects.
    """
    if not path.is_file():
        raise EvaluationError(f"{path}: no such file; say where the benchmark lies")
    if path.stat().st_size > LARGEST:
        raise EvaluationError(f"{path}: more than {LARGEST // 2**20} MiB; give the benchmark's file alone")
    found = checksum(path)
    if sha256 is not None and found != sha256.lower():
        raise EvaluationError(f"{path}: its SHA-256 is {found}, not the expected one; is it another version?")
    read = {".json": _json, ".jsonl": _lines, ".parquet": _parquet}.get(path.suffix)
    if read is None:
        raise EvaluationError(f"{path}: no format that is known here; give a .json, .jsonl or .parquet file")
    try:
        held = read(path.read_bytes())
    except (ValueError, RecursionError, OSError) as error:
        raise EvaluationError(f"{path}: not readable: {' '.join(str(error).split())[:200]}") from None
    if not isinstance(held, list) or not all(isinstance(row, dict) for row in cast("list[object]", held)):
        raise EvaluationError(f"{path}: holds no list of objects")
    return cast("list[Row]", held)


def _json(content: bytes) -> object:
    return _writable(content, json.loads(content))


def _lines(content: bytes) -> object:
    return _writable(content, [json.loads(line) for line in content.decode().split("\n") if line.strip()])


def _writable(content: bytes, held: object) -> object:
    """Return the parsed value; ValueError for unpaired surrogates, which no file can contain."""
    if b"\\ud" in content.lower():
        json.dumps(held, ensure_ascii=False).encode()
    return held


def _parquet(content: bytes) -> object:
    from pyarrow import parquet  # noqa: PLC0415 - heavy

    # threads let go of what Python holds a moment late, and abort a Python that ends meanwhile
    return cast("Any", parquet).ParquetFile(BytesIO(content), pre_buffer=False).read(use_threads=False).to_pylist()
