"""Physics problems as a v1 taskset of verifiers."""

from sim2reason_problems.taskset import Sim2ReasonTaskset

__all__ = ["Sim2ReasonTaskset"]
