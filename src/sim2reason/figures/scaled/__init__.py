"""Drawings to scale: the geometry of a mechanism, seen along the direction in which nothing moves."""
