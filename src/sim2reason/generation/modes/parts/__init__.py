"""Helpers shared by the modes."""
