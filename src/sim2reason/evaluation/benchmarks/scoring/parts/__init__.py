"""Helpers shared by scoring rules: answers, numbers, expressions, equations and lists."""
