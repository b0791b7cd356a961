"""Parsing of texts into scenes: the templates of bodies, entities and connections are matched against sentences.

Reading goes in two steps. `Matcher` and its friends go through the sentences in the order in which the
`Writer` says them and propose every scene that could have been meant; they may propose too much. `proof`
then tells each proposed scene again with the very choices that were read: it counts only if every
sentence comes out letter by letter, none missing and none to spare. So whatever is read is a scene that
has this text, and a text with a sentence cut is never read as the same scene.
"""

from sim2reason.text.parsing.matcher import NONE_GIVEN
from sim2reason.text.parsing.scene_parser import ParsedScene, parse_scene

__all__ = ["NONE_GIVEN", "ParsedScene", "parse_scene"]
