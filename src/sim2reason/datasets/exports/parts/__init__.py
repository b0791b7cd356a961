"""Helpers shared by all exports."""
