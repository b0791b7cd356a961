"""Helpers of prompt shapes."""
