"""Source from which pip installed this library, which is on no package index."""

import json
from importlib.metadata import PackageNotFoundError, distribution
from typing import Any

__all__ = ["requirement"]

NAME = "sim2reason"
UNKNOWN = f"# {NAME}: write here the path of a clone of its repository"


def requirement() -> str:
    """Return the requirements line by which pip installs the library from its source; a comment if that is unknown."""
    try:
        origin: dict[str, Any] = json.loads(distribution(NAME).read_text("direct_url.json") or "{}")
    except PackageNotFoundError:
        return UNKNOWN
    url, version = origin.get("url", ""), origin.get("vcs_info")
    if not url:
        return UNKNOWN
    return f"{NAME} @ {version['vcs']}+{url}@{version['commit_id']}" if version else f"{NAME} @ {url}"
