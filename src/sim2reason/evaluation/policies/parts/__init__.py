"""Helpers shared by policies: secrets, HTTP requests, endpoint replies, delays and budgets."""
