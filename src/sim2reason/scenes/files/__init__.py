"""Scene files: strict YAML, its JSON schema, and the page that documents the format."""

from sim2reason.scenes.files.mapping import GivenScene, SceneLike, dump, given_scene, load, loads, scene_of, to_plain
from sim2reason.scenes.files.sections import Wording, question_of, wording_of
from sim2reason.scenes.files.validation import decoded

__all__ = [
    "GivenScene",
    "SceneLike",
    "Wording",
    "decoded",
    "dump",
    "given_scene",
    "load",
    "loads",
    "question_of",
    "scene_of",
    "to_plain",
    "wording_of",
]
