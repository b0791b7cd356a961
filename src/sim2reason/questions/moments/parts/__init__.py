"""Base classes of moments."""
