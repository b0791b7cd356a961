"""Sledges: a package of a third party."""
