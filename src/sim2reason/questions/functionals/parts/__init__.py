"""Base classes and helpers of functionals."""
