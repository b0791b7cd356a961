"""The modes of problems."""
