"""What joins the ports of entities, one file each."""

from sim2reason.dsl.connection import CONNECTIONS

__all__ = ["CONNECTIONS"]
