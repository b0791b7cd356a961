"""Evaluation of language models: policies, benchmarks and reports."""
