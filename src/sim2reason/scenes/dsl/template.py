"""Sentences as data: text with slots, taken apart once and read by whoever writes or reads a problem.

{block}              a body, introduced with its numbers at its first mention
{blocks}             all of a variable-length part: blocks A (1.2 kg) and B (2.0 kg)
{blocks.last}        one of them: first, last, or * for each in turn
{plane.angle}        a number with its unit
{plane.uphill}       a word that depends on a number
{blocks:lies/lie}    the form for one and the form for several; or for one, for two and for more
{blocks:s}           what its members are called, in the plural: blocks
{blocks:#}           how many, as a word
{pairs?/ other}      the form for none and the form for any
{pairs.*.a>blocks}   the member of `blocks` whose index is the number at `pairs.*.a`
{letter} {noun}      inside a body's own introductions
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache
from typing import Literal

COUNT_WORDS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight")

Kind = Literal["text", "path", "agree", "some", "count", "plural", "member"]
Role = Literal["fact", "start", "assumption"]
"""The function of a sentence in a text: initial and general conditions may be placed separately in a prompt."""
Topic = Literal["axes", "slack", "start"]
"""The subject matter of a sentence that only some questions need; others omit it."""


@dataclass(frozen=True, slots=True)
class Slot:
    """One piece of a template, plain text or a placeholder; `path` is the address in the placeholder."""

    kind: Kind
    text: str = ""
    path: str = ""
    one: str = ""
    two: str = ""
    many: str = ""

    def form(self, count: int) -> str:
        """Return the form of the word (for one, two or more) that agrees with a count."""
        if self.kind == "some":
            return self.many if count else self.one
        return (self.one, self.two)[count - 1] if count in (1, 2) else self.many


@dataclass(frozen=True, slots=True)
class Word:
    """A word that depends on the value of a field, such as *smooth* for a friction of 0.

    Both templates are in the terms of the body. A value with a special word is stated by that word alone.

    Attributes:
        parameter: Name of the field.
        special: Templates by value.
        otherwise: Template for all other values.

    Examples:
        >>> from sim2reason.authoring import Word
        >>> surface = Word("friction", {0.0: "smooth"}, "rough")
        >>> surface.text(0.0), surface.text(0.3)
        ('smooth', 'rough')
    """

    parameter: str
    special: Mapping[float | str, str]
    otherwise: str = ""

    def text(self, value: float | str | None) -> str:
        """Return the template of the word for a value of the field; None means an absent value."""
        return self.special.get(value, self.otherwise) if value is not None else self.otherwise


@dataclass(frozen=True, slots=True)
class Wordings:
    """A sentence in alternative wordings, of which a seed selects one.

    With `several`, the sentence is used only if that variable-length part has two members or more; with a `topic`, only
    for a question to which it matters. If the optional number `given` is present, the wordings are `instead`.
    """

    wordings: tuple[str, ...]
    role: Role = "fact"
    several: str = ""
    topic: Topic | None = None
    given: str = ""
    instead: tuple[str, ...] = ()
    rare: bool = False  # unused sentences draw no wording, so that other wordings are unaffected

    def if_given(self, path: str, *wordings: str) -> "Wordings":
        """Return the sentence with other wordings if the optional number at `path` is given."""
        return replace(self, given=path, instead=wordings)


@dataclass(frozen=True, slots=True)
class Each:
    """A sentence for each member of a variable-length part; from three members on, a table of their numbers.

    `table` introduces the table, with {noun} of its rows and {columns}, the names of the numbers.
    """

    field: str
    wordings: tuple[str, ...]
    table: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class PartLines:
    """A placeholder for the lines of the part in a field; lines of parts without a placeholder come first."""

    field: str


Saying = str | Wordings | Each | PartLines


def either(*wordings: str) -> Wordings:
    """Return a sentence with alternative wordings.

    Args:
        *wordings: Templates of the sentence, of which a seed selects one.

    Returns:
        A line for `says` of an entity.

    Examples:
        >>> from sim2reason.authoring import either
        >>> line = either("{block} lies on {plane}.", "{block} rests on {plane}.")
        >>> len(line.wordings)
        2
    """
    return Wordings(wordings)


def rarely(*wordings: str) -> Wordings:
    """Return a rarely used sentence that does not affect the choice of other wordings while unused."""
    return Wordings(wordings, rare=True)


def among(field: str, *wordings: str) -> Wordings:
    """Return a sentence on the members of a part that is used only if there are several.

    A single member is described where a port names it.

    Args:
        field: Name of the field with the members.
        *wordings: Templates of the sentence, of which a seed selects one.

    Returns:
        A line for `says` of an entity.

    Examples:
        >>> from sim2reason.authoring import among
        >>> line = among("blocks", "{blocks} are stacked.")
        >>> line.several
        'blocks'
    """
    return Wordings(wordings, several=field)


def starting(*wordings: str, topic: Topic | None = None) -> Wordings:
    """Return a sentence on the start of the motion: the last line of an entity, which may follow *suppose that*.

    Args:
        *wordings: Templates of the sentence, of which a seed selects one.
        topic: Topic that matters to some questions only: ``axes``, ``slack`` or ``start``; by default none.

    Returns:
        A line for `says` of an entity.

    Examples:
        >>> from sim2reason.authoring import starting
        >>> starting("at t = 0 {block} moves to the right at {speed}.").role
        'start'
    """
    return Wordings(wordings, "start", topic=topic)


def placing(*wordings: str) -> Wordings:
    """Return a sentence on an initial position, which questions about small oscillations do not need.

    Args:
        *wordings: Templates of the sentence, of which a seed selects one.

    Returns:
        A line for `says` of an entity.

    Examples:
        >>> from sim2reason.authoring import placing
        >>> placing("initially {spring} is stretched by {strain}.").topic
        'start'
    """
    return Wordings(wordings, topic="start")


def defining_axes(*wordings: str) -> Wordings:
    """Return a sentence on the directions of axes that no other sentence mentions.

    Args:
        *wordings: Templates of the sentence, of which a seed selects one.

    Returns:
        A line for `says` of an entity.

    Examples:
        >>> from sim2reason.authoring import defining_axes
        >>> defining_axes("the x axis points to the right.").topic
        'axes'
    """
    return Wordings(wordings, topic="axes")


def assuming(*wordings: str) -> Wordings:
    """Return a sentence on an assumption that introduces no body; a prompt may place it after the question.

    Args:
        *wordings: Templates of the sentence, of which a seed selects one.

    Returns:
        A line for `says` of an entity.

    Examples:
        >>> from sim2reason.authoring import assuming
        >>> assuming("air resistance is negligible.").role
        'assumption'
    """
    return Wordings(wordings, "assumption")


def line_role(saying: Saying) -> Role:
    """Return the role of a line in a text: a fact, the start of the motion or an assumption."""
    return saying.role if isinstance(saying, Wordings) else "fact"


def line_topic(saying: Saying) -> Topic | None:
    """Return the topic of a line that only some questions need; None if all need it."""
    return saying.topic if isinstance(saying, Wordings) else None


def each(field: str, *wordings: str, table: tuple[str, ...] = ()) -> Each:
    """Return a sentence for each member of a part; from three members on, a table of their numbers.

    Args:
        field: Name of the field; a member is called ``{field.*}`` in the templates.
        *wordings: Templates of the sentence, of which a seed selects one.
        table: Templates that introduce the table, with ``{noun}`` for its rows and ``{columns}`` for the names of the
            numbers; by default there is no table.

    Returns:
        A line for `says` of an entity.

    Examples:
        >>> from sim2reason.authoring import each
        >>> each("pucks", "{pucks.*} moves at {pucks.*.speed}.").field
        'pucks'
    """
    return Each(field, wordings, table)


def lines_of(field: str) -> PartLines:
    """Return a placeholder that marks where the text of an entity states the lines of the parts in a field.

    Args:
        field: Name of the field.

    Returns:
        A line for `says` of an entity.

    Examples:
        >>> from sim2reason.authoring import lines_of
        >>> lines_of("system").field
        'system'
    """
    return PartLines(field)


def wordings(saying: Saying, *, given: bool = False) -> tuple[str, ...]:
    """Return the wordings of a sentence if the optional number that it depends on is `given`, or if it is absent.

    A place for the lines of parts has no wordings.
    """
    if isinstance(saying, PartLines):
        return ()
    if given and isinstance(saying, Wordings) and saying.given:
        return saying.instead
    return (saying,) if isinstance(saying, str) else saying.wordings


def variants(saying: Saying) -> tuple[tuple[str, ...], ...]:
    """Return the sets of wordings of a sentence: two if the sentence depends on an optional number, else one."""
    several = isinstance(saying, Wordings) and saying.given
    return (wordings(saying), wordings(saying, given=True)) if several else (wordings(saying),)


_PATH = re.compile(r"[a-z_0-9.*]+")


@cache
def slots(template: str) -> tuple[Slot, ...]:
    """Split a template into plain text and placeholders (slots); ValueError for a brace outside a slot.

    Forms of a slot may contain slots.
    """
    pieces: list[Slot] = []
    depth, begin = 0, 0
    for index, character in enumerate(template):
        if character == "{":
            if depth == 0:
                pieces.append(Slot("text", template[begin:index]))
                begin = index + 1
            depth += 1
        elif character == "}":
            depth -= 1
            if depth == 0:
                pieces.append(_slot(template[begin:index]))
                begin = index + 1
        if depth < 0:
            break
    if depth != 0:
        raise ValueError(f"a brace that belongs to no slot in {template!r}")
    pieces.append(Slot("text", template[begin:]))
    return tuple(slot for slot in pieces if slot.kind != "text" or slot.text)


def _slot(inside: str) -> Slot:
    match = _PATH.match(inside)
    if match is None:
        raise ValueError(f"not a slot: {{{inside}}}")
    path, rest = match.group(), inside[match.end() :]
    if not rest:
        return Slot("path", path=path)
    if rest == ":#":
        return Slot("count", path=path)
    if rest == ":s":
        return Slot("plural", path=path)
    if rest.startswith(">"):
        return Slot("member", rest[1:], path)
    if rest[0] in ":?" and "/" in rest:
        one, *several = _forms(rest[1:])
        if len(several) > 1 + (rest[0] == ":"):
            raise ValueError(f"too many forms: {{{inside}}}")
        return Slot("agree" if rest[0] == ":" else "some", path=path, one=one, two=several[0], many=several[-1])
    raise ValueError(f"not a slot: {{{inside}}}")


def _forms(text: str) -> list[str]:
    """Split the forms of a word, such as *is/are*, at slashes that are not within nested slots."""
    forms, depth = [""], 0
    for character in text:
        depth += (character == "{") - (character == "}")
        if character == "/" and depth == 0:
            forms.append("")
        else:
            forms[-1] += character
    return forms


def paths(template: str) -> tuple[str, ...]:
    """Return the addresses that a template mentions, in order."""
    return tuple(slot.path for slot in slots(template) if slot.path)
