"""Scene files: strict YAML, its JSON schema, and the page that documents the format."""

from sim2reason.scenes.files.given import GivenScene, SceneLike, given_scene, scene_of
from sim2reason.scenes.files.mapping import dump, load, loads, to_plain
from sim2reason.scenes.files.question_parts import question_of
from sim2reason.scenes.files.source_text import decoded
from sim2reason.scenes.files.wording import Wording, wording_of

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
