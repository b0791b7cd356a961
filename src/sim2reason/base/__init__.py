"""Foundations without physics: registries, lazy imports, optional packages, strict YAML, atomic files."""
