"""All checks of one entity class."""

from collections.abc import Iterable, Iterator
from traceback import extract_tb

from sim2reason.dsl.entity import Entity
from sim2reason.errors import DrawError
from sim2reason.testing.checks import CHECKS
from sim2reason.testing.report import Finding, Report
from sim2reason.testing.specimens import Specimen, Specimens, specimen

SEEDS = range(6)
DRAWN = "drawn"  # the name under which a scene that can't be had is told


def check_entity(
    cls: type[Entity],
    *,
    seeds: Iterable[int] = SEEDS,
    checks: Iterable[str] | None = None,
    skip: Iterable[str] = (),
    deep: bool = False,
) -> None:
    """Hold an entity class to everything that the library promises of entities.

    Random scenes are drawn from what the class declares, one for each of `seeds`; everything optional is there half
    of the time, and its ports are closed by what other entities and connections declare. On them are made the
    `checks` named, by default all but those to `skip` (``sim2reason list checks`` shows them): the text says all that
    answers depend on, and is read back; no sentence and no number can be left out; no two givens share a symbol; both
    engines agree; energy and momentum balance with what acts; the mirror image and the scene in other units move
    alike; hidden numbers do not matter, and each range does; ablations work; it is drawn, plotted and asked about.

    The class must be entered by `@entity`, since files and texts find it by its name. It takes 2 to 5 s; with `deep`,
    which looks at all scenes in every check, and say ``range(40)`` for seeds, a minute.

    Raises:
        ConformanceError: something does not hold; an AssertionError, whose message tells every finding with the
            scene's file, what was expected, what was found and a remedy.
        UnknownNameError: no such check.
    """
    conformance(cls, seeds=seeds, checks=checks, skip=skip, deep=deep).raise_for_findings()


def conformance(
    cls: type[Entity],
    *,
    seeds: Iterable[int] = SEEDS,
    checks: Iterable[str] | None = None,
    skip: Iterable[str] = (),
    deep: bool = False,
) -> Report:
    """The same as `check_entity`, as a report that does not raise; UnknownNameError for a check that is not known."""
    seeds, left_out = tuple(seeds), set(skip)
    names = tuple(name for name in (CHECKS if checks is None else tuple(checks)) if name not in left_out)
    made = [CHECKS[name] for name in names]
    members: list[Specimen] = []
    findings: list[Finding] = []
    for seed in seeds:
        found = _drawn(cls, seed)
        if isinstance(found, Specimen):
            members.append(found)
        else:
            findings.append(found)
    specimens = Specimens(cls, tuple(members), deep)
    for each in made if members else ():
        findings.extend(_caught(each.name, each.findings(specimens)))
    return Report(cls.__name__, names, seeds, tuple(findings))


def _drawn(cls: type[Entity], seed: int) -> Specimen | Finding:
    """A scene of the class, or why there is none."""
    expected = "random scenes can be drawn from what the class declares"
    try:
        return specimen(cls, seed)
    except DrawError as error:
        return Finding(
            DRAWN, expected, str(error), "give every number a Range, and bound ranges that exclude each other", seed
        )
    except Exception as error:  # noqa: BLE001 - whatever a stranger's class raises is a finding
        return Finding(DRAWN, expected, _told(error), REMEDY, seed)


REMEDY = "raise SceneError, or let a validator refuse the values, where something can not be"


def _caught(name: str, findings: Iterator[Finding]) -> Iterator[Finding]:
    """The findings of a check; one more if it was stopped by an exception that only the class can have raised."""
    try:
        yield from findings
    except Exception as error:  # noqa: BLE001 - the same
        yield Finding(name, "no exception but those of sim2reason.errors", _told(error), REMEDY)


def _told(error: Exception) -> str:
    last = extract_tb(error.__traceback__)[-1]
    return f"{type(error).__name__}: {error} (raised in {last.filename}, line {last.lineno})"
