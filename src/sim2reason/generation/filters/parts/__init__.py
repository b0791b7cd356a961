"""Helpers shared by several filters."""
