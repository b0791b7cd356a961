"""The question in a scene file, given as a sentence or as a mapping."""

from sim2reason.base.yaml_text import Plain, parse, shown
from sim2reason.errors import SceneError


def question_of(text: str) -> dict[str, Plain] | str | None:
    """Return the question under a scene file's key ``question``, a sentence or its parts; None without this key.

    Raises:
        SceneError: the question is neither a sentence nor a mapping.
    """
    data = parse(text)
    return parts_from(data["question"]) if isinstance(data, dict) and "question" in data else None


def parts_from(data: Plain) -> dict[str, Plain] | str:
    """Return the value of the key ``question``; SceneError unless it is a sentence or a mapping, with any keys."""
    if not isinstance(data, dict | str) or data == "":
        remedy = "ask in a sentence, or give it parts, such as find, of and when"
        raise SceneError("question", f"it is {shown(data)}, neither a sentence nor a mapping", remedy)
    return data
