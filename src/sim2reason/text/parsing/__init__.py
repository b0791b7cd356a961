"""Parsing of texts into scenes: the templates of bodies, entities and connections are matched against sentences.

Parsing has two stages. `Matcher` and the other modules match templates against the sentences in the order in which the
`Writer` renders them, and propose candidate scenes; some may be wrong. `proof` then renders each candidate with the
matched wordings and accepts it only if this reproduces the text exactly. Hence every accepted scene has this text, and
a text without one sentence is never parsed as the same scene.
"""

from sim2reason.text.parsing.matcher import NONE_GIVEN
from sim2reason.text.parsing.scene_parser import ParsedScene, parse_scene

__all__ = ["NONE_GIVEN", "ParsedScene", "parse_scene"]
