r"""Units as models write them, normalized to the spellings of the unit table.

Examples are ``newton-seconds``, ``kg.m/s``, ``Kg``, ``[m/s]``, ``m/s$^2$``, ``sec.``, ``rev/min`` and ``M_{\odot}``;
``ms^{-1}`` is per millisecond or metres per second, according to the requested dimension.
"""

import math
import re
from collections.abc import Iterator
from dataclasses import replace
from functools import lru_cache
from typing import Final

from sim2reason.grading.alphabet import SWITCHES, either
from sim2reason.grading.further_units import FURTHER
from sim2reason.scenes.dsl.units import Unit, UnitError, combined, parse_unit

__all__ = ["is_unit", "unit_in"]

_WRAPPERS: Final = rf"\\(?:{either('open', '{')}|operatorname\*)\s*(?=\{{)"
_SUN: Final = r"(?:\\odot(?![A-Za-z])|\\(?:text|rm)\s*\{?\s*[sS]un\s*\}?|[sS]un)"
_REWRITTEN: Final = tuple(
    (re.compile(pattern), replacement)
    for pattern, replacement in (
        (_WRAPPERS, r"\\text"),
        (rf"(?:\\text\s*\{{\s*M\s*\}}|(?<![A-Za-z])M)\s*(?:_\s*)?(?:\{{\s*{_SUN}\s*\}}|{_SUN})(?![A-Za-z])", " Msun "),
        (r"(?<![A-Za-z])solar[\s~]+mass(?:es)?(?![A-Za-z])", "Msun"),
        (rf"\\(?:{'|'.join((*SWITCHES, 'middle'))})(?![A-Za-z])", " "),
        (r"(?:\^|\*\*)\s*(?:\{\s*)?\\(?:text|mathrm)\s*\{\s*([-−–+]?[0-9])\s*\}(?:\s*\})?", r"^{\1}"),
        (r"(?:\^|\*\*)\s*\(\s*([-−–+]?[0-9])\s*\)", r"^{\1}"),
        (rf"[•∙]|\\(?:{either('times')})(?![A-Za-z])", "·"),
        (rf"\\(?:{either('fraction')})(?![A-Za-z])", r"\\frac"),
        (r"\{([^{}]{1,40})\\over(?![A-Za-z])([^{}]{1,40})\}", r"\\frac{\1}{\2}"),
        (r"(?:\\left\s*|\\big[lr]?\s*)?\[", "("),
        (r"(?:\\right\s*|\\big[lr]?\s*)?\]", ")"),
        (r"(?<=[A-Za-z]{3})\(s\)", "s"),
        (r"(?<=[A-Za-z0-9}])\s?[-‐‑]\s?(?=[A-Za-z])", "·"),
        (r"(?<=[A-Za-z0-9}])\.\s?(?=[A-Za-z\\])", "·"),
        (r"[.\s]+\Z|\.(?=\s*\}*\s*\Z)", ""),
        (r"(?<=[A-Za-z])(-?[1-4])(?![0-9])", r"^{\1}"),
        (r"(?<![A-Za-z])K[gG]s?(?![A-Za-z])|(?<![A-Za-z])kgs(?![A-Za-z])", "kg"),
        (r"(?<![A-Za-z])(sec|min|hr)s?\.", r"\1"),
        (r"(?<![A-Za-z])(min|deg|rad|yr)s(?![A-Za-z])", r"\1"),
        (r"(?<![A-Za-z])K(?=(?:J|N|W|V|Pa|Hz|eV|m)(?![A-Za-z]))", "k"),
        (r"(?<![A-Za-z])kmph(?![A-Za-z])|(?<![A-Za-z])kph(?![A-Za-z])", "km/h"),
        (r"\A((?:[\s~({]|\\[ ,;:!]|\\text(?![A-Za-z]))*)in(?=[\s~\\]+[^\s~\\(){}])", r"\1 "),
    )
)
_STRAY: Final = re.compile(r"(?:^|[\s}·*])1(?!\s*[/}])")
_TURNS: Final = re.compile(r"(?<![A-Za-z\\])(?:rpm|RPM|rps|revs?|revolutions?|rotations?|turns?)(?![A-Za-z])")
_TURNING: Final = {"rpm": "rad/min", "RPM": "rad/min", "rps": "rad/s"}
_SPLIT: Final = re.compile(r"(?<![A-Za-z\\])(kg|k?N|k?J|g)?(m)?(s)(?![A-Za-z])|(?<![A-Za-z\\])(kg|g)(m)(?![A-Za-z])")


@lru_cache(maxsize=1024)
def unit_in(text: str, asked: Unit | None) -> Unit:
    """Return the unit that `text` denotes; if ambiguous, the one comparable with `asked`.

    Raises `UnitError` if it is not a unit.
    """
    if _STRAY.search(text):
        raise UnitError("a number stands among units")
    first: Unit | None = None
    problem = UnitError(f"{text.strip()!r} is no unit")
    for spelling in _spellings(text):
        try:
            unit = _read(spelling)
        except UnitError as error:
            problem = error
            continue
        first = first or unit
        if asked is None or not asked.name or unit.factor_to(asked) is not None:
            return unit
    if first is None:
        raise problem
    return first


def _spellings(text: str) -> Iterator[str]:
    """Yield spellings of a unit: unchanged, as in the unit table, and with adjacent metres and seconds separated."""
    yield text
    plain = text
    for pattern, replacement in _REWRITTEN:
        plain = pattern.sub(replacement, plain)
    if plain != text:
        yield plain
    apart = _SPLIT.sub(lambda run: " ".join(part for part in run.groups() if part), plain)
    if apart != plain:
        yield apart


def _read(text: str) -> Unit:
    """Return a unit of the table, or one with a turn (2π rad) to the first power."""
    turns = _TURNS.findall(text)
    if not turns:
        return combined(text, FURTHER)
    radian, degree = (parse_unit(_TURNS.sub(angle, text)).factor for angle in ("rad", "deg"))
    if len(turns) > 1 or not math.isclose(radian, degree * math.degrees(1)):
        raise UnitError(f"{turns[0]!r} must stand alone, above the line and without a power")
    unit = parse_unit(_TURNS.sub(lambda turn: _TURNING.get(turn[0], "rad"), text))
    return replace(unit, name=unit.name.replace("rad", "rev", 1), factor=unit.factor * math.tau)


def is_unit(text: str) -> bool:
    """Return whether `text` is a unit."""
    try:
        unit_in(text, None)
    except UnitError:
        return False
    return True
