"""Helpers shared by several recipes."""
