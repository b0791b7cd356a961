"""Mechanisms whose equations change as they move, or whose constraints the library itself cannot keep."""
