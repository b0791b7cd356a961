"""The question that a scene file asks, in parts."""

from sim2reason.errors import SceneError
from sim2reason.scene_files.yaml_text import Plain, parse, shown


def question_of(text: str) -> dict[str, Plain] | None:
    """What a scene file asks under the key ``question``, part by part; None if it asks nothing.

    Raises:
        SceneError: it is no mapping.
    """
    data = parse(text)
    return parts_from(data["question"]) if isinstance(data, dict) and "question" in data else None


def parts_from(data: Plain) -> dict[str, Plain]:
    """What stands under ``question``; which parts there are, the reader of questions knows."""
    if not isinstance(data, dict):
        raise SceneError("question", f"it is {shown(data)}, not a mapping", "give it parts, such as find, of and when")
    return data
