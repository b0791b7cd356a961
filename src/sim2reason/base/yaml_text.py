"""The YAML subset of scene files: strict parsing with line numbers, and canonical writing.

Mappings, lists, numbers, words and quoted strings only. Anchors, tags, merges and the other YAML 1.1 spellings of
numbers, dates and booleans are refused, so that all YAML readers agree on a file.
"""

import json
import re
from collections.abc import Iterator
from typing import Any, NoReturn

from yaml import SafeLoader, YAMLError
from yaml.events import (
    AliasEvent,
    MappingEndEvent,
    MappingStartEvent,
    ScalarEvent,
    SequenceEndEvent,
    StreamEndEvent,
)

from sim2reason.errors import SceneError

try:
    from yaml.cyaml import CParser as Parser  # type: ignore[reportAttributeAccessIssue,reportUnknownVariableType]  # it has no stubs
except ImportError:  # PyYAML was built without libyaml: the same events, fifteen times slower
    Parser = SafeLoader

Plain = dict[str, "Plain"] | list["Plain"] | str | float | int | bool | None
Lines = dict[str, int]
"""The line, from 1 on, of every value by its path in the file."""

MAX_BYTES = 65_536
MAX_DEPTH = 16
MAX_NODES = 4_000
MAX_DIGITS = 40  # the longest repr of a float has 24 characters
MAX_FLOW_WIDTH = 100  # characters; a mapping of scalars up to this width is written on one line

NUMBER = re.compile(r"[-+]?(?:0|[1-9][0-9]*)(\.[0-9]+)?([eE][-+]?[0-9]+)?", re.ASCII)
"""The spelling of numbers that means the same to all readers: 012 and 1:30 do not."""
_WORD = re.compile(r"[A-Za-z][A-Za-z0-9_.]*", re.ASCII)
_FORBIDDEN = re.compile("[^\t\n\r\x20-\x7e\x85\xa0-\ud7ff\ue000-\ufefe\uff00-\ufffd\U00010000-\U0010ffff]")
TRUTH = {"true": True, "false": False, "null": None}
"""The words that are values, to readers of YAML 1.1 and 1.2 alike."""
LETTERS = {"y", "n"}  # which YAML 1.1 takes for true and false, but hardly any reader or writer: y is an axis
_AMBIGUOUS = {"y", "n", "yes", "no", "on", "off", *TRUTH, "~", "=", "<<"}  # when not exactly true, false or null


def quote_value(value: object) -> str:
    """Return a value as one line of text for an error message, shortened if long."""
    text = json.dumps(value, ensure_ascii=True, default=str)
    return text if len(text) <= 40 else f"{text[:37]}..."


def parse(text: str, lines: Lines | None = None) -> Plain:
    """Parse a text into dicts, lists and scalars; SceneError names the path, the line and the remedy.

    `lines`, if given, is filled with the line numbers by path. Limits are checked before any object is built.
    """
    if len(text) > MAX_BYTES or len(text.encode("utf-8", "replace")) > MAX_BYTES:
        raise SceneError("the file", f"it has more than {MAX_BYTES} bytes", "give a smaller scene")
    if match := _FORBIDDEN.search(text):
        line = text.count("\n", 0, match.start()) + 1
        raise SceneError(f"line {line}", f"it holds the character U+{ord(match[0]):04X}", "take it out")
    try:
        return _Reader(text, lines).document()
    except YAMLError as error:
        raise _refusal(error) from None
    except RecursionError:  # PyYAML's pure parser calls itself
        raise _depth_error("the file") from None


def _refusal(error: YAMLError) -> SceneError:
    """Return the SceneError for a YAML syntax error, with its line."""
    mark = getattr(error, "problem_mark", None)
    location = f"line {mark.line + 1}" if mark is not None else "the file"
    problem = " ".join(str(getattr(error, "problem", None) or error).split())
    if "nesting depth" in problem:
        return _depth_error(location)
    return SceneError(location, f"this is not YAML: {problem}", "mend the indentation and the punctuation")


def _depth_error(location: str) -> SceneError:
    return SceneError(location, "it is nested too deeply", f"use at most {MAX_DEPTH} levels")


class _Reader:
    """A reader that builds values from YAML events and enforces the limits."""

    def __init__(self, text: str, lines: Lines | None) -> None:
        self._parser: Any = Parser(text)
        self._lines = lines
        self._path: list[str] = []
        self._nodes = 0

    def document(self) -> Plain:
        """Return the only document of the stream."""
        self._parser.get_event()
        start = self._parser.get_event()
        if isinstance(start, StreamEndEvent):
            raise SceneError("the file", "it is empty", "begin with: scene:")
        if start.version or start.tags:
            self._refuse(start, "a %YAML or %TAG directive", "take it out")
        value = self._value(self._parser.get_event())
        self._parser.get_event()  # the end of the document
        event = self._parser.get_event()
        if not isinstance(event, StreamEndEvent):
            self._path = []
            self._refuse(event, "a second document begins here", "give one scene in one file")
        return value

    def _value(self, event: Any) -> Plain:
        self._nodes += 1
        if self._nodes > MAX_NODES:
            self._refuse(event, f"there are more than {MAX_NODES} values up to here", "give a smaller scene")
        if isinstance(event, AliasEvent) or event.anchor is not None:
            self._refuse(event, "there is an anchor or alias (& or *)", "write the value out")
        if event.tag is not None:
            self._refuse(event, f"there is a tag, {quote_value(event.tag)}", "take it out")
        if self._lines is not None:
            self._lines["".join(self._path)] = event.start_mark.line + 1
        if isinstance(event, ScalarEvent):
            return self._scalar(event)
        if len(self._path) >= MAX_DEPTH:
            self._refuse(event, "it is nested too deeply", f"use at most {MAX_DEPTH} levels")
        return self._mapping() if isinstance(event, MappingStartEvent) else self._list()

    def _mapping(self) -> dict[str, Plain]:
        mapping: dict[str, Plain] = {}
        while not isinstance(event := self._parser.get_event(), MappingEndEvent):
            key = self._key(event)
            if key in mapping:
                self._refuse(event, f"the key {quote_value(key)} stands here twice", "keep one of them")
            self._path.append(f".{key}" if self._path else key)
            mapping[key] = self._value(self._parser.get_event())
            self._path.pop()
        return mapping

    def _list(self) -> list[Plain]:
        entries: list[Plain] = []
        while not isinstance(event := self._parser.get_event(), SequenceEndEvent):
            self._path.append(f"[{len(entries)}]")
            entries.append(self._value(event))
            self._path.pop()
        return entries

    def _key(self, event: Any) -> str:
        self._nodes += 1
        if not isinstance(event, ScalarEvent) or event.anchor is not None or event.tag is not None:
            self._refuse(event, "a key is not a plain word", "write a key as: mass:")
        if event.value == "<<":
            self._refuse(event, "keys are merged with <<", "write the values out")
        key = event.value
        unclear = key.lower() in _AMBIGUOUS - LETTERS and not event.style
        if unclear or not _WORD.fullmatch(key) or len(key) > MAX_DIGITS:
            self._refuse(event, f"{quote_value(event.value)} can't be a key", "use the keys that the format has")
        return key

    def _scalar(self, event: ScalarEvent) -> Plain:
        text = event.value
        if event.style in ("'", '"'):
            return text
        if event.style in ("|", ">"):
            self._refuse(event, "there is a text over several lines (| or >)", "write it on one line, in quotes")
        if text in TRUTH:
            return TRUTH[text]
        if not text:
            self._refuse(event, "it has no value", "write one, or take the key out")
        if text[0] in "+-.0123456789":
            return self._number(event)
        if text.lower() in _AMBIGUOUS - LETTERS:
            self._refuse(event, f"{text} means true, false or nothing to some readers", f'write "{text}" in quotes')
        return text

    def _number(self, event: ScalarEvent) -> float | int:
        text = event.value
        match = NUMBER.fullmatch(text)
        if match is None:
            self._refuse(
                event, f"{quote_value(text)[1:-1]} is not a plain number", "write it as 12, 0.5, -3.0 or 1.5e-3"
            )
        if len(text) > MAX_DIGITS:
            self._refuse(event, f"this number has more than {MAX_DIGITS} characters", "write it as 1.5e-3")
        if match[1] is None and match[2] is None:
            return int(text)
        if abs(value := float(text)) == float("inf"):
            self._refuse(event, f"{text} is too large for a number", "give a finite one")
        return value

    def _refuse(self, event: Any, problem: str, remedy: str) -> NoReturn:
        line = event.start_mark.line + 1
        path = "".join(self._path)
        raise SceneError(f"{path} (line {line})" if path else f"line {line}", problem, remedy)


def write(value: Plain) -> str:
    """Return a value as YAML; equal values give equal texts, and every YAML reader restores the value."""
    return "".join(f"{line}\n" for line in _block(value))


def _block(value: Plain) -> Iterator[str]:
    """Yield the lines of a value; collections of scalars take one line."""
    flow = _flow(value)
    if flow is not None:
        yield flow
    elif isinstance(value, dict):
        for key, member in value.items():
            yield from _entry(f"{key}:", member)
    elif isinstance(value, list):
        for member in value:
            first, *rest = _block(member)
            yield f"- {first}"
            yield from (f"  {line}" for line in rest)


def _entry(head: str, member: Plain) -> Iterator[str]:
    """Yield the lines of a key and its value, on the same line or below; lists are not indented further."""
    first, *rest = _block(member)
    if _flow(member) is not None:
        yield f"{head} {first}"
        return
    indent = "" if isinstance(member, list) else "  "
    yield head
    yield from (f"{indent}{line}" for line in (first, *rest))


def _flow(value: Plain) -> str | None:
    """Return a scalar, or a short collection of scalars, in one line; None for anything else."""
    if not isinstance(value, dict | list):
        return _scalar_text(value)
    members = list(value.values()) if isinstance(value, dict) else value
    if any(isinstance(member, dict | list) for member in members):
        return None
    texts = [_scalar_text(member) for member in members]
    if isinstance(value, dict):
        text = "{" + ", ".join(f"{key}: {text}" for key, text in zip(value, texts, strict=True)) + "}"
    else:
        text = "[" + ", ".join(texts) + "]"
    return text if len(text) <= MAX_FLOW_WIDTH or not members else None


def _scalar_text(value: object) -> str:
    if isinstance(value, float):
        return _float_text(value)
    if isinstance(value, str):
        return value if _WORD.fullmatch(value) and value.lower() not in _AMBIGUOUS else json.dumps(value)
    return json.dumps(value)


def _float_text(value: float) -> str:
    """Return the repr of a float, with the decimal point that YAML 1.1 requires before an exponent."""
    text = repr(value)
    mantissa, e, exponent = text.partition("e")
    return f"{mantissa}.0e{exponent}" if e and "." not in mantissa else text
