"""Scenes as files: strict YAML in the paper's shape, its JSON schema, and the page that tells the format."""

from sim2reason.scene_files.mapping import decoded, dump, load, loads, told

__all__ = ["decoded", "dump", "load", "loads", "told"]
