"""Samples of a policy: requested by several threads, and written to disk when finished."""

from sim2reason.errors import PolicyError

__all__ = ["NoAnswerError"]


class NoAnswerError(PolicyError):
    """An error for a request without an answer, while others may succeed."""
