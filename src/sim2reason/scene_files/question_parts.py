"""The question that a scene file asks, in parts."""

from sim2reason.errors import SceneError
from sim2reason.scene_files.yaml_text import Plain, parse, shown


def question_of(text: str) -> dict[str, Plain] | str | None:
    """What a scene file asks under the key ``question``, a sentence or part by part; None if it asks nothing.

    Raises:
        SceneError: it is neither.
    """
    data = parse(text)
    return parts_from(data["question"]) if isinstance(data, dict) and "question" in data else None


def parts_from(data: Plain) -> dict[str, Plain] | str:
    """What stands under ``question``; which parts there are, the reader of questions knows."""
    if not isinstance(data, dict | str) or data == "":
        remedy = "ask in a sentence, or give it parts, such as find, of and when"
        raise SceneError("question", f"it is {shown(data)}, neither a sentence nor a mapping", remedy)
    return data
