"""Verification of worked solutions, from their data and from their text alone."""
