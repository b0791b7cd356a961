"""The conformance kit: checks of entity classes on random scenes, with findings in words.

    from sim2reason.testing import check_entity

    def test_my_entity_conforms():
        check_entity(MyEntity)

`check_entity` raises, with everything that it found; `conformance` gives the same as a report.
"""

from collections.abc import Iterable, Iterator
from traceback import extract_tb

from sim2reason.errors import ConformanceError, DrawError
from sim2reason.scenes.dsl.entity import Entity
from sim2reason.testing.checks import CHECKS, Check, check
from sim2reason.testing.report import Finding, Report
from sim2reason.testing.specimens import Specimen, Specimens, specimen

__all__ = [
    "CHECKS",
    "Check",
    "ConformanceError",
    "Finding",
    "Report",
    "Specimen",
    "Specimens",
    "check",
    "check_entity",
    "conformance",
    "specimen",
]

SEEDS = range(6)
DRAWING_CHECK = "drawn"  # the check's name for scenes that cannot be drawn


def check_entity(
    cls: type[Entity],
    *,
    seeds: Iterable[int] = SEEDS,
    checks: Iterable[str] | None = None,
    skip: Iterable[str] = (),
    deep: bool = False,
) -> None:
    """Check that an entity class conforms to the contract of entities.

    Random scenes are drawn from the declarations of the class, one for each seed: each optional part is present half of
    the time, and ports are connected to other entities. The checks then test, among other things, that the text states
    all numbers on which answers depend and is read back, that both engines agree, that energy and momentum balance, and
    that ablations, drawings and questions work. The class must be registered with `entity`, since files and texts find
    it by its name. With the defaults it takes 2 to 5 s.

    Args:
        cls: The entity class.
        seeds: Seeds of the scenes.
        checks: Names of the checks, which ``sim2reason.list("checks")`` returns; by default all.
        skip: Names of checks to skip.
        deep: Whether each check looks at all scenes; with ``seeds=range(40)`` this takes a minute.

    Raises:
        ConformanceError: The class does not conform. It is an AssertionError, whose message has all findings, each with
            the scene, what was expected and a remedy.
        UnknownNameError: There is no such check.

    Examples:
        >>> import sim2reason
        >>> from sim2reason.testing import check_entity
        >>> scene = sim2reason.sample("incline", "easy")
        >>> check_entity(type(scene.entities[0].entity), seeds=[0], checks=["symbols"])
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
    """Run the checks of `check_entity`, and return a report instead of raising an error."""
    seeds, left_out = tuple(seeds), set(skip)
    names = tuple(name for name in (CHECKS if checks is None else tuple(checks)) if name not in left_out)
    made = [CHECKS[name] for name in names]
    members: list[Specimen] = []
    findings: list[Finding] = []
    for seed in seeds:
        drawn = _drawn(cls, seed)
        if isinstance(drawn, Specimen):
            members.append(drawn)
        else:
            findings.append(drawn)
    specimens = Specimens(cls, tuple(members), deep)
    for each in made if members else ():
        findings.extend(_caught(each.name, each.findings(specimens)))
    return Report(cls.__name__, names, seeds, tuple(findings))


def _drawn(cls: type[Entity], seed: int) -> Specimen | Finding:
    """Draw a scene of the class; return a finding if that fails."""
    expected = "random scenes can be drawn from what the class declares"
    try:
        return specimen(cls, seed)
    except DrawError as error:
        return Finding(
            DRAWING_CHECK,
            expected,
            str(error),
            "give every number a Range, and bound ranges that exclude each other",
            seed,
        )
    except Exception as error:  # noqa: BLE001 - whatever a stranger's class raises is a finding
        return Finding(DRAWING_CHECK, expected, _describe_error(error), REMEDY, seed)


REMEDY = "raise SceneError, or let a validator refuse the values, where something can not be"


def _caught(name: str, findings: Iterator[Finding]) -> Iterator[Finding]:
    """Yield the findings of a check, and a finding for an exception of the class."""
    try:
        yield from findings
    except Exception as error:  # noqa: BLE001 - the same
        yield Finding(name, "no exception but those of sim2reason.errors", _describe_error(error), REMEDY)


def _describe_error(error: Exception) -> str:
    last = extract_tb(error.__traceback__)[-1]
    return f"{type(error).__name__}: {error} (raised in {last.filename}, line {last.lineno})"
