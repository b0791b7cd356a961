"""Connections between the ports of entities, one file each."""

from sim2reason.scenes.dsl.connection import CONNECTIONS

__all__ = ["CONNECTIONS"]
