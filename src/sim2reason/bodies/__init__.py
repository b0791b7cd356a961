"""The bodies that entities are made of, one file each."""

from sim2reason.dsl.body import BODIES

__all__ = ["BODIES"]
