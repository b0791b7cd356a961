"""Base classes and helpers of misconceptions."""
