"""Upload of a dataset's folder, unchanged, to the Hugging Face Hub."""

# huggingface_hub is an extra:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from pathlib import Path

from sim2reason.base.optional import optional
from sim2reason.datasets.findings import found
from sim2reason.errors import DatasetError

SHOWN = 300  # characters of an error message of the Hub's library
IGNORED = "**/.*", ".*"
"""What is of this machine alone."""


def push(path: Path, repository: str, *, private: bool, token: str | None, message: str) -> str:
    """Upload the dataset at `path` and return its address on the Hub, with the errors of `Dataset.push_to_hub`."""
    hub, errors = optional("huggingface_hub", "eval"), optional("huggingface_hub.errors", "eval")
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
