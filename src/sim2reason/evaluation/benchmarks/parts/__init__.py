"""Helpers shared by the loaders of benchmarks."""
