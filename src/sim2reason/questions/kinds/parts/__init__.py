"""Base classes of question kinds."""
