"""Scene files: strict YAML, its JSON schema, and the page that documents the format."""

from sim2reason.scenes.files.mapping import GivenScene, SceneLike, as_scene, dump, given_scene, load, loads, to_plain
from sim2reason.scenes.files.sections import Wording, read_question, read_wording
from sim2reason.scenes.files.validation import decode_file

__all__ = [
    "GivenScene",
    "SceneLike",
    "Wording",
    "as_scene",
    "decode_file",
    "dump",
    "given_scene",
    "load",
    "loads",
    "read_question",
    "read_wording",
    "to_plain",
]
