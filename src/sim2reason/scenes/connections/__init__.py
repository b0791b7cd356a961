"""Connections between the ports of entities."""

from sim2reason.scenes.dsl.connection import CONNECTIONS

__all__ = ["CONNECTIONS"]
