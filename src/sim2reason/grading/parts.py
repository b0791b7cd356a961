r"""Answers of several parts in one box, each after its label: ``\boxed{(a) 2.1; (b) 3.4}``."""

import re
from collections.abc import Callable, Sequence
from typing import Final

from sim2reason.grading.extract import boxed
from sim2reason.grading.score import Outcome, Refused, Score

__all__ = ["PART_LABELS", "parts"]

PART_LABELS: Final = "abcdefgh"
"""The letters of parts, in their order."""

_FONT: Final = r"\\(?:text|textbf|textrm|textit|mathrm|mathbf|mathit|mathsf|mbox)\s*\{"
_PLAIN: Final = rf"\(\s*([{PART_LABELS}])\s*\)\s*[:.]?"
_LABEL: Final = re.compile(_PLAIN)
_INNER: Final = re.compile(rf"\(\s*{_FONT}\s*([{PART_LABELS}])\s*\}}\s*\)")
"""A label whose letter alone is in a font."""
_RUN: Final = re.compile(rf"({_FONT})([^{{}}]*)\}}")
"""A text in a font, without groups in it."""
_BETWEEN: Final = r"(?:[;,&~\s]|\\\\(?:\[\d+pt\])?|\\[,;:! ]|\\q?quad\b|\\newline\b)"
_AND: Final = rf"(?:and\b|{_FONT}\s*[;,.]?\s*(?:and)?\s*\}})"
_BEFORE: Final = re.compile(rf"^(?:{_BETWEEN})+")
_BEHIND: Final = re.compile(rf"(?:{_BETWEEN}|{_AND})+$")
_LINES: Final = re.compile(
    r"\s*\\begin\{(aligned|array|gathered|cases|matrix|split)\}(?:\{[lcr| ]*\})?(?P<rows>.*)\\end\{\1\}\s*", re.DOTALL
)

Grader = Callable[[str], Score]
"""Grades the content of a box, which it is given in a box of its own."""


def parts(response: object, graders: Sequence[Grader], *, partial: bool = False) -> Score:
    """Grade a box with labelled answers to several parts, each with its own grader.

    The answers may be in any order, each after its label. A repeated label, an unknown one, or text before the first
    label makes the whole box unreadable; a part without a label has no answer.

    Args:
        response: the whole text, as all graders take it.
        graders: one for each part, in the order of their labels.
        partial: pay the share of the right parts; by default nothing is paid unless all are right.
    """
    labels = PART_LABELS[: len(graders)]
    try:
        answers = _answers(boxed(response), labels)
    except Refused as refused:
        return refused.score
    scores = tuple(_graded(answers.get(label), grader) for label, grader in zip(labels, graders, strict=True))
    return _together(labels, scores, partial=partial)


def _graded(answer: str | None, grader: Grader) -> Score:
    if answer is None or not answer:
        return Score.of(Outcome.NO_ANSWER, None, "the box holds no answer to it")
    if not _is_balanced(answer):
        return Score.of(Outcome.UNREADABLE, None, "its braces reach beyond it")
    return grader(rf"\boxed{{{answer}}}")


def _together(labels: str, scores: tuple[Score, ...], *, partial: bool) -> Score:
    """Return all parts as one score: correct if all are, else the outcome of the first part that is not."""
    failed = [score for score in scores if score.outcome is not Outcome.CORRECT]
    outcome = failed[0].outcome if failed else Outcome.CORRECT
    share = (len(scores) - len(failed)) / len(scores)
    parsed = "; ".join(f"({label}) {_shown(score.parsed)}" for label, score in zip(labels, scores, strict=True))
    why = "; ".join(f"({label}) {score.why}" for label, score in zip(labels, scores, strict=True))
    return Score(share if partial or not failed else 0.0, outcome, parsed, why, scores)


def _shown(parsed: float | str | None) -> str:
    if parsed is None:
        return "nothing"
    return parsed if isinstance(parsed, str) else f"{parsed:g}"


def _answers(content: str, labels: str) -> dict[str, str]:
    """Return the text after each label, by label."""
    text = _RUN.sub(_parted, _INNER.sub(r"(\1)", _in_rows(content)))
    matches = list(_LABEL.finditer(text))
    answers: dict[str, str] = {}
    if not matches or _BEFORE.sub("", text[: matches[0].start()]):
        wanted = "; ".join(f"({label}) …" for label in labels)
        raise Refused(Outcome.UNREADABLE, f"the box does not begin with a label, as in {wanted}")
    ends = [*(match.start() for match in matches[1:]), len(text)]
    for match, end in zip(matches, ends, strict=True):
        label = match[1]
        if label in answers or label not in labels:
            why = "occurs twice" if label in answers else "belongs to no part"
            raise Refused(Outcome.UNREADABLE, f"the label ({label}) {why}")
        answers[label] = _BEFORE.sub("", _BEHIND.sub("", text[match.end() : end]))
    return answers


def _in_rows(content: str) -> str:
    """Return the content of a box; if it is a LaTeX array, only its rows."""
    match = _LINES.fullmatch(content)
    return match["rows"].replace("&", " ") if match else content


def _parted(run: re.Match[str]) -> str:
    """Return a text command split at the labels in it, so that each label is separate."""
    pieces = _LABEL.split(run[2])
    if len(pieces) == 1:
        return run[0]
    trimmed = [_BEHIND.sub("", piece) if n < len(pieces) - 1 else piece for n, piece in enumerate(pieces)]
    texts = [f"{run[1]}{piece}}}" if piece.strip() else "" for piece in trimmed[::2]]
    return texts[0] + "".join(f"({label}){text}" for label, text in zip(pieces[1::2], texts[1:], strict=True))


def _is_balanced(text: str) -> bool:
    """Return whether all braces in the text are matched."""
    depth = 0
    for brace in re.findall(r"(?<!\\)[{}]", text):
        depth += 1 if brace == "{" else -1
        if depth < 0:
            return False
    return depth == 0
