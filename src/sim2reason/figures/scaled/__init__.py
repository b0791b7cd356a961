"""Drawings to scale: what a mechanism's own geometry shows, seen along the direction in which nothing moves."""
