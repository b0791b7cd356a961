"""The transformers library without its bars and remarks."""

from collections.abc import Generator
from contextlib import contextmanager
from warnings import catch_warnings, filterwarnings

from sim2reason.optional import optional

__all__ = ["quiet"]


@contextmanager
def quiet() -> Generator[None, None, None]:
    """Keep the library's bars and remarks from standard error while the block runs; errors are still raised.

    So is what peft 0.21 provokes in transformers 5.23, an old name for a property. MissingExtraError without it.
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
