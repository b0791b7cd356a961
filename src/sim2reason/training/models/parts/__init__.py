"""Helpers shared by models: loading of checkpoints, and construction of tokenizers."""
