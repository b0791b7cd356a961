"""Scenes: their language, scene files, bodies, entities and connections."""
