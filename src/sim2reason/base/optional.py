"""Import of optional dependencies."""

from importlib import import_module
from typing import Any

from sim2reason.errors import MissingExtraError


def optional(module: str, extra: str = "") -> Any:  # noqa: ANN401 - a module whose types hold only where it is installed
    """Import an optional library and return its module.

    Raises:
        MissingExtraError: a library is not installed; the message names the packages of the `extra` that brings it.
    """
    try:
        return import_module(module)
    except ModuleNotFoundError as error:
        raise MissingExtraError(error.name or module, extra) from None
