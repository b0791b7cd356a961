"""Shapes with symbols in the text, and their values in a list or table."""

import re
from collections.abc import Iterator

import numpy as np

from sim2reason.questions.shapes import Draft, PromptShape, shape
from sim2reason.questions.shapes.layout import MAX_QUESTION_SENTENCES, is_table, iter_splits, join_units, one_of, units
from sim2reason.scenes.dsl.model import Parameter
from sim2reason.text.prose.description import Description, with_names, without_names
from sim2reason.text.prose.phrases import join
from sim2reason.text.prose.voices import Voice, symbolic

LIST_LEAD_INS = ("Data: ", "Numerical values: ", "Take ", "Use ", "Let ")
FEWEST, MOST = 2, 12  # range of the number of listed values
MAX_COMPONENTS = 6  # greatest number of vector components, as more belong in a table
_FORMULA = re.compile(r"ω = |\(\$[^$]+\$\) [xyzt]\b")  # in the letters of the text, which do not go with symbols
_COMPONENT = re.compile(r"[xyz](?:_.+)?|.+_(?:[xyz]|\{[xyz],.+\})")
_NUMBER = r"\$([^$]{1,40})\$ = ([^$]{1,30}?)"
_LIST = re.compile(rf"(?:{'|'.join(LIST_LEAD_INS)})((?:{_NUMBER}(?:, | and |\.$))+)")
_ITEM = re.compile(rf"{_NUMBER}(?:, (?=\$)| and (?=\$)|\.$)")


@shape
class NumbersListed(PromptShape):
    """Symbols and a list of values: “Block A of mass $m_A$ lies on … How fast is it? Data: $m_A$ = 2.0 kg, …”."""

    name = "numbers_listed"
    share = 0.35

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Return the prompt for a text without a table and with a suitable number of values; None for others."""
        lead, after = one_of(LIST_LEAD_INS, rng), rng.random() < 0.5
        marked = description.voiced(_symbols_for(description.voice))
        numbers = _numbers(description, marked)
        if numbers is None or any(map(is_table, marked.sentences)) or not FEWEST <= len(numbers) <= MOST:
            return None
        if sum(_COMPONENT.fullmatch(symbol) is not None for symbol in numbers) > MAX_COMPONENTS:
            return None
        named = with_names(marked)
        story = named.text
        if _FORMULA.search(story):
            return None
        if not after and named.sentences[-1].startswith(lead):
            lead = LIST_LEAD_INS[0]  # no two sentences in a row begin alike: let g = 9.8 m/s²
        listed = f"{lead}{join([f'${symbol}$ = {number}' for symbol, number in numbers.items()])}."
        return f"{story} {question} {listed}" if after else f"{story} {listed} {question}"

    def drafts(self, text: str) -> Iterator[Draft]:
        """Yield drafts whose given numbers are those of a list before or after the question; texts omit the list."""
        parts = units(text)
        for index in range(len(parts) - 1, len(parts) - 2 - MAX_QUESTION_SENTENCES, -1):
            given = _listed(parts[index]) if index > 0 else {}
            for story, question in iter_splits([*parts[:index], *parts[index + 1 :]]) if given else ():
                yield Draft(without_names(join_units(story)), question, given)


def _numbers(description: Description, marked: Description) -> dict[str, str] | None:
    """Return the stated numbers of a text by symbol; None if the question has another symbol for one."""
    numbers: dict[str, str] = {}
    parameters = {parameter.path: parameter for parameter in description.scene.parameters}
    for path in description.told:
        symbol, parameter = marked.symbols.get(path), parameters.get(path)
        if symbol is None or parameter is None or _stays(parameter):
            continue
        number = description.voice(parameter, description.symbols.get(path, ""))
        if number.startswith("$") and number != f"${symbol}$":
            return None  # the question speaks of it, too
        if not number.startswith("$"):
            numbers[symbol] = number
    return numbers


def _stays(parameter: Parameter) -> bool:
    """Return whether a number remains in the text: g and zero, which no list of data contains."""
    return parameter.path.startswith("world.") or parameter.value == 0.0


def _symbols_for(voice: Voice) -> Voice:
    """Return a voice that replaces numbers by symbols, except those that remain in the text."""

    def said(parameter: Parameter, symbol: str) -> str:
        return voice(parameter, symbol) if _stays(parameter) else symbolic(parameter, symbol)

    return said


def _listed(sentence: str) -> dict[str, str]:
    """Return the numbers of a list by symbol; none for any other sentence."""
    match = _LIST.fullmatch(sentence)
    return {item[1]: item[2] for item in _ITEM.finditer(match[1])} if match else {}


@shape
class TableLast(PromptShape):
    """The usual order, with the table moved to the end."""

    name = "table_last"
    share = 1.2

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Return the prompt for a text with one table; None for others."""
        del rng
        tables = [unit for unit in description.sentences if is_table(unit)]
        sentences = [unit for unit in description.sentences if not is_table(unit)]
        return join_units([*sentences, question, *tables]) if len(tables) == 1 else None

    def drafts(self, text: str) -> Iterator[Draft]:
        """Yield drafts with the final table moved into the scene's text, one draft for each possible position."""
        *parts, last = units(text)
        if is_table(last):
            for story, question in iter_splits(parts):
                for index in range(1, len(story) + 1):
                    yield Draft(join_units([*story[:index], last, *story[index:]]), question)
