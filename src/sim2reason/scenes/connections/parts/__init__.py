"""Base classes shared by several connections."""
