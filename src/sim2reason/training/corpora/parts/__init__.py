"""Helpers shared by corpora: reading and mixing of rows, tokenization, arithmetic solutions."""
