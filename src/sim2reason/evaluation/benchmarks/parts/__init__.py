"""What loaders of benchmarks share."""
