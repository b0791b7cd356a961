"""Samples of a policy: asked for by several threads, and on disk as soon as they are finished."""

from sim2reason.errors import PolicyError

__all__ = ["NoAnswerError"]


class NoAnswerError(PolicyError):
    """A request that got no answer, while others may."""
