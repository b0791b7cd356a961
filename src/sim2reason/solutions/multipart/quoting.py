"""References to equations of earlier parts, and the removal of equations that later parts do not use."""

import re
from collections.abc import Callable, Container, Iterator, Mapping, Sequence
from dataclasses import replace

from sim2reason.grading.parts import PART_LABELS
from sim2reason.solutions.multipart.names import LABEL, introduced_names, names_in_text, names_of
from sim2reason.solutions.multipart.recall import RECALLED_STEP_KIND, reduce_givens, renumber_steps, with_bases
from sim2reason.solutions.setting import join_words
from sim2reason.solutions.solution import Relation, Solution, Step

DEFINED = re.compile(r"(\(\d+\))(?: [A-Z](?:[^$()]|\$[^$]*\$)*?:)? \$([^$]+)\$")  # a heading may contain formulas
_INTEGRATED = re.compile(r"(?P<problem>.*Numerical integration until .*?,? gives )(?P<ends>\$.*)", re.DOTALL)
CONSEQUENCE_OPENING = "So "  # opening of a result that follows from the last equations
AS_IN_PART = "As in part ({}), "  # opening of a result whose equations an earlier part has solved
SENTENCE = re.compile(r"(?<=\.) (?=[A-Z(])")
_LIST = re.compile(r"(?P<noun>[A-Z][a-z]*?)s?: (?P<items>\$.*)\.")


def quote_earlier_parts(parts: Sequence[Solution]) -> list[Solution]:
    """Return the solutions of all parts as one text with unique equation labels and no repeated sentence.

    Integrated phases keep all their steps, unless there is but one. An initial-value problem that an earlier part
    states is not stated again.
    """
    stated_parts = _StatedParts()
    rewritten = [stated_parts.add_part(label, part) for label, part in zip(PART_LABELS, parts, strict=False)]
    texts = "\n".join(step.text for part in rewritten for step in part.steps)
    labels = dict.fromkeys(label for label, _ in DEFINED.findall(texts))
    names = {label: f"({number})" for number, label in enumerate(labels, start=1)}
    return [replace(part, steps=tuple(relabel(step, names) for step in part.steps)) for part in rewritten]


class _StatedParts:
    """A record of the equations, labels and sentences of earlier parts."""

    def __init__(self) -> None:
        self._labels: dict[str, str] = {}  # by equation, in LaTeX
        self._parts: dict[str, str] = {}  # the part of each label, or of an equation without one
        self._sentences: set[str] = set()
        self._problems: dict[str, str] = {}  # the part of each initial-value problem

    def add_part(self, label: str, part: Solution) -> Solution:
        """Return a part without sentences of earlier parts, and add its own sentences to the record."""
        names = self._relabelled(label, part.steps)
        steps = [relabel(step, names) for step in part.steps]
        several = part.phases and any(step.integration is not None for step in steps)
        kept = steps if several else self._without([self._integrated(label, step) for step in steps], part.values)
        used = with_bases(names_of(kept), part)
        for step in kept:
            texts = [step.text, *SENTENCE.split(step.text), *_items(step.text)]
            self._sentences |= {
                text for text in texts if used.issuperset(introduced_names(text)) or step.kind != "names"
            }
            for relation in step.relations:
                self._parts.setdefault(relation.latex(), label)
        return replace(part, steps=renumber_steps(kept))

    def _relabelled(self, part: str, steps: Sequence[Step]) -> dict[str, str]:
        """Return new labels by old ones: the known label of an equation stated before, else the next number."""
        names: dict[str, str] = {}
        for label, formula in (pair for step in steps for pair in DEFINED.findall(step.text)):
            if formula not in self._labels:
                self._labels[formula] = f"({len(self._labels) + 1})"
                self._parts[self._labels[formula]] = part
            names[label] = self._labels[formula]
        return names

    def _without(self, steps: Sequence[Step], values: Container[str]) -> list[Step]:
        """Return steps without statements of earlier parts; repeated equations that are used are cited."""
        dropped = [step for step in steps if self._is_said(step, values)]
        left = [step for step in steps if step not in dropped]
        labels = {label for step in left for label in cited_labels(step.text)}
        left = [self._shorter(self._solved_again(step), labels) for step in left]
        if dropped == [] and [step.text for step in left] == [step.text for step in steps]:
            return [*steps]
        quoted = [*self._quoted(dropped, left)]
        rest = [step for step in left if step.kind != "givens"]
        used = names_in_text(" ".join(step.text for step in (*quoted, *rest)))
        given = [reduce_givens(step, used) for step in left if step.kind == "givens"]
        recalled = [step for step in rest if step.kind == RECALLED_STEP_KIND]
        return [*given, *recalled, *quoted, *(step for step in rest if step.kind != RECALLED_STEP_KIND and step.text)]

    def _solved_again(self, step: Step) -> Step:
        """Add *As in part (a)* to a step that solves the same equation as an earlier part; other steps unchanged."""
        first = self._parts.get(step.relations[0].latex()) if step.relations else None
        if first is None or not step.text.startswith(CONSEQUENCE_OPENING):
            return step
        return replace(step, text=f"{AS_IN_PART.format(first)}{step.text.removeprefix(CONSEQUENCE_OPENING)}")

    def _integrated(self, part: str, step: Step) -> Step:
        """Reduce the text of an integration to its results if an earlier part has integrated the same equations."""
        match = _INTEGRATED.fullmatch(step.text) if step.integration is not None else None
        if match is None or (first := self._problems.setdefault(match["problem"], part)) == part:
            return step
        return replace(step, text=f"The numerical integration of part ({first}) also gives {match['ends']}")

    def _is_said(self, step: Step, values: Container[str]) -> bool:
        """Return whether a step without results repeats the text of an earlier part."""
        results = any(name in values for name in step.gives)
        return not results and step.kind not in ("givens", RECALLED_STEP_KIND) and step.text in self._sentences

    def _shorter(self, step: Step, used: set[str]) -> Step:
        """Return a step without repeated sentences and without equations that no step cites."""
        sentences = SENTENCE.split(step.text)
        if step.kind == "names":
            kept = [new_sentence for sentence in sentences if (new_sentence := self._new(sentence))]
            return replace(step, text=" ".join(kept))
        labels = [match[1] if (match := DEFINED.match(sentence)) else "" for sentence in sentences]
        if not all(labels) or not self._sentences & {*sentences}:
            return step
        idle = used.isdisjoint(labels)
        new = [(s, label) for s, label in zip(sentences, labels, strict=True) if s not in self._sentences]
        kept = [sentence for sentence, label in new if idle or label in used]
        text = " ".join(kept)
        return replace(step, text=text, relations=tuple(r for r in step.relations if r.latex() in text))

    def _new(self, sentence: str) -> str:
        """Return a sentence without introductions of symbols that earlier parts contain; empty if nothing is left."""
        return (
            ""
            if sentence in self._sentences
            else shorten_symbol_list(sentence, lambda item: item not in self._sentences)
        )

    def _quoted(self, dropped: Sequence[Step], left: Sequence[Step]) -> Iterator[Step]:
        """Yield, for each earlier part whose equations the steps `left` use, a step that cites these equations."""
        text = " ".join(step.text for step in left)
        defined = {label for label, _ in DEFINED.findall(text)}
        labels = [*dict.fromkeys(label for label in LABEL.findall(text) if label not in defined)]
        by_label = {label: r for step in dropped for label, r in _quoted_equations(step)}
        needed = {need for step in left for need in step.needs}
        names = names_in_text(" ".join([text, *(by_label[label].latex() for label in labels if label in by_label)]))
        laws = [r for step in dropped if step.id in needed for r in step.relations if r not in by_label.values()]
        again = {relation.latex() for step in left for relation in step.relations}  # given in numbers by these steps
        laws = [r for r in laws if names.issuperset(r.left.symbols()) and r.latex() not in again]
        for part in sorted({*self._parts.values()}):
            own = [label for label in labels if self._parts.get(label) == part]
            plain = [r for r in laws if self._parts.get(r.latex()) == part]
            if own or plain:
                relations = (*(by_label[label] for label in own if label in by_label), *plain)
                yield Step(-1, "equations", _citation_text(part, own, plain), relations, tuple(own), ())


def shorten_symbol_list(sentence: str, kept: Callable[[str], bool]) -> str:
    """Return a sentence with a list of introduced symbols, reduced to the `kept` items; empty if no item is kept."""
    match = _LIST.fullmatch(sentence)
    if match is None:
        return sentence
    items = match["items"].split("; ")
    new = [item for item in items if kept(item)]
    if new == items:
        return sentence
    return f"{match['noun']}{'s' if len(new) > 1 else ''}: {'; '.join(new)}." if new else ""


def _citation_text(part: str, labels: Sequence[str], plain: Sequence[Relation]) -> str:
    named = join_words(sorted(labels, key=lambda label: int(label[1:-1]))) if labels else ""
    numbered = f"equation{'s' if len(labels) > 1 else ''} {named}" if labels else ""
    cited = [each for each in (numbered, *(relation.latex() for relation in plain)) if each]
    return f"As in part ({part}), {join_words(cited)} hold{'s' if len(labels) + len(plain) == 1 else ''}."


def relabel(step: Step, names: Mapping[str, str]) -> Step:
    """Return a step with new equation labels, in its text and among its results."""
    parts = step.text.split("$")
    parts[::2] = [LABEL.sub(lambda match: names.get(match[0], match[0]), part) for part in parts[::2]]
    return replace(step, text="$".join(parts), gives=tuple(names.get(name, name) for name in step.gives))


def cited_labels(text: str) -> list[str]:
    """Return the equation labels that a text cites."""
    begun = {match.start(1) for match in DEFINED.finditer(text)}
    return [match[0] for match in LABEL.finditer(text) if match.start() not in begun]


def _items(text: str) -> list[str]:
    """Return the items, such as introductions of symbols, of the sentences in a text that are lists."""
    matches = (_LIST.fullmatch(sentence) for sentence in SENTENCE.split(text))
    return [item for match in matches if match is not None for item in match["items"].split("; ")]


def _quoted_equations(step: Step) -> Iterator[tuple[str, Relation]]:
    """Yield the label and the relation of each labelled equation of a step."""
    by_formula = {relation.latex()[1:-1]: relation for relation in step.relations}
    yield from ((label, by_formula[formula]) for label, formula in DEFINED.findall(step.text) if formula in by_formula)


_HEADING = re.compile(r"(?:In numbers|With numbers for the coefficients): ")  # of one equation, and of those after it
_UNLABELLED = frozenset(("constraint", "combine"))  # kinds of steps of one equation each


def without_unused(solution: Solution, accepted: Callable[[Solution], bool]) -> Solution:
    """Return a solution without the equations that it does not cite and that the check does not need.

    A solution that recalls no earlier result is returned unchanged.
    """
    if not any(step.kind == RECALLED_STEP_KIND for step in solution.steps):
        return solution
    steps = solution.steps
    while (shorter := _shorter(steps, lambda trial: accepted(replace(solution, steps=trial)))) != steps:
        steps = shorter
    reduced = replace(solution, steps=_tidied(steps))
    return reduced if accepted(reduced) else solution


def _shorter(steps: tuple[Step, ...], accepted: Callable[[tuple[Step, ...]], bool]) -> tuple[Step, ...]:
    """Return the steps without unused equations, starting from the last step.

    The text does not state which equations those in numbers use; if some remain, all before them remain as well.
    """
    for index in reversed(range(len(steps))):
        headed = _HEADING.match(steps[index].text)
        if headed and any(DEFINED.search(step.text) for step in steps[index + 1 :]):
            break
        for equation in reversed(_stated_equations(steps[index])):
            others = (*steps[:index], *steps[index + 1 :])
            if any(label in cited_labels(step.text) for step in others for label, _ in DEFINED.findall(equation)):
                continue
            trial = (*steps[:index], _without(steps[index], equation), *steps[index + 1 :])
            steps = trial if accepted(trial) else steps
        if headed and steps[index].text:
            break
    return steps


def _stated_equations(step: Step) -> list[str]:
    """Return the equations, as sentences with labels, of a step from which single equations may be left out."""
    sentences = SENTENCE.split(_HEADING.sub("", step.text))
    return sentences if step.kind in _UNLABELLED or all(map(DEFINED.match, sentences)) else []


def _without(step: Step, equation: str) -> Step:
    """Return a step without one of its equations; its text may then be empty."""
    text = " ".join(each for each in _stated_equations(step) if each != equation)
    return replace(step, text=text, relations=tuple(r for r in step.relations if r.latex() in text))


def _tidied(steps: Sequence[Step]) -> tuple[Step, ...]:
    """Drop steps without text and unused given numbers and symbols, and number steps and equations anew."""
    left = [step for step in steps if step.text]
    rest = [step for step in left if step.kind not in ("givens", "names")]
    used = names_in_text(" ".join(step.text for step in rest)) | {*names_of(rest)}
    left = [_in_use(step, used) for step in left]
    labels = dict.fromkeys(label for step in left for label, _ in DEFINED.findall(step.text))
    names = {label: f"({number})" for number, label in enumerate(labels, start=1)}
    return renumber_steps([relabel(step, names) for step in left if step.text])


def _in_use(step: Step, used: frozenset[str]) -> Step:
    """Reduce a step that lists given numbers or introduces symbols to the names in use; other steps unchanged."""
    if step.kind == "givens":
        return reduce_givens(step, used)
    if step.kind != "names":
        return step
    sentences = (
        shorten_symbol_list(each, lambda item: not used.isdisjoint(introduced_names(item)))
        for each in SENTENCE.split(step.text)
    )
    return replace(step, text=" ".join(sentence for sentence in sentences if sentence))
