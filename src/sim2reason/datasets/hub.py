"""Uploading a dataset to the Hugging Face hub, where its folder is read as it stands."""

# huggingface_hub is an extra:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from importlib import import_module
from pathlib import Path
from typing import Any

from sim2reason.datasets.findings import found
from sim2reason.errors import DatasetError, MissingExtraError

SHOWN = 300  # characters of what the hub's library says about an error
IGNORED = "**/.*", ".*"
"""What is of this machine alone."""


def push(path: Path, repository: str, *, private: bool, token: str | None, message: str) -> str:
    """Upload the dataset at a path as `Dataset.push_to_hub` does, and give its address; it raises what that does."""
    try:
        hub: Any = import_module("huggingface_hub")
        errors: Any = import_module("huggingface_hub.errors")
    except ImportError as error:
        raise MissingExtraError("huggingface_hub", "eval") from error
    if faults := found(path).faults:
        raise DatasetError(f"{path}: {faults[0]}; a damaged dataset is not uploaded: see sim2reason verify {path}")
    api = hub.HfApi(token=token)
    try:
        address = api.create_repo(repository, repo_type="dataset", private=private, exist_ok=True)
        api.upload_folder(
            folder_path=path,
            repo_id=address.repo_id,
            repo_type="dataset",
            commit_message=message,
            ignore_patterns=list(IGNORED),
        )
    except (errors.HfHubHTTPError, errors.HFValidationError, errors.LocalTokenNotFoundError, OSError) as error:
        why = " ".join(str(error).split())[:SHOWN]
        remedy = "check the name, and log in with: hf auth login"
        raise DatasetError(f"{repository}: the hub did not take the dataset: {why}; {remedy}") from None
    return str(address)
