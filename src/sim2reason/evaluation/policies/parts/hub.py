"""Access to the Hugging Face Hub, and the transformers library without progress bars."""

from collections.abc import Callable, Generator
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from typing import Any, Literal
from warnings import catch_warnings, filterwarnings

from sim2reason.base.optional import optional

__all__ = ["explained", "loading", "out_of_reach", "quiet"]

# huggingface_hub is an extra:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false


PATIENCE = 10.0  # s
SHOWN = 200  # characters of the library's error message


def out_of_reach(name: str, kind: Literal["model", "dataset"], revision: str | None = None) -> bool:
    """Return whether the Hub is unreachable, so that only the local cache is available.

    Any reply counts as reachable. ValueError if the name is invalid on the Hub.
    """
    hub: Any = import_module("huggingface_hub")
    errors: Any = import_module("huggingface_hub.errors")
    try:
        hub.HfApi().repo_info(name, repo_type=kind, revision=revision, timeout=PATIENCE)
    except errors.HfHubHTTPError:
        return False
    except errors.HFValidationError:
        raise ValueError("no such folder, and no name that the hub could have") from None
    except Exception:  # noqa: BLE001 - the library raises what its transport does
        return True
    return False


def loading(path: str, revision: str | None = None) -> dict[str, Any]:
    """Return the arguments of `from_pretrained` that restrict it to local files if the Hub is unreachable.

    Raises:
        ValueError: there is neither such a folder nor such a name.
        FileNotFoundError: there is no such folder, the hub is out of reach, and the model is not kept here.
    """
    if Path(path).exists() or not out_of_reach(path, "model", revision):
        return {"revision": revision}
    hub: Any = import_module("huggingface_hub")
    if not isinstance(hub.try_to_load_from_cache(path, "config.json", revision=revision), str):
        raise FileNotFoundError("no such folder, and the hub cannot be reached")
    return {"revision": revision, "local_files_only": True}


@contextmanager
def explained(path: str, error: Callable[[str], Exception]) -> Generator[None]:
    """Convert the library's loading errors in the block to the given `error` with one line."""
    try:
        yield
    except (OSError, ValueError, ImportError) as found:
        why = " ".join(str(found).split())[:SHOWN]
        raise error(f"no model could be loaded from {path!r}: {why}") from None


@contextmanager
def quiet() -> Generator[None, None, None]:
    """Suppress the library's progress bars and warnings while the block runs; errors are still raised.

    Also suppressed is a warning that peft 0.21 causes in transformers 5.23. MissingExtraError without the library.
    """
    logging = optional("transformers", "train").utils.logging
    verbosity, bars = logging.get_verbosity(), logging.is_progress_bar_enabled()
    logging.set_verbosity_error()
    logging.disable_progress_bar()
    try:
        with catch_warnings():
            filterwarnings("ignore", message="`is_gradient_checkpointing` is deprecated", category=FutureWarning)
            yield
    finally:
        logging.set_verbosity(verbosity)
        if bars:
            logging.enable_progress_bar()
