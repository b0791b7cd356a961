"""A movable pulley is taken to move as far as the end of its string."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.mechanism import ConstantTension, Line, Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.simplifications.parts.hanging import carried, movable_pulleys
from sim2reason.questions.study import Study


@simplification
class PulleyAsStringEnd(ChangedMechanism):
    """A pulley in the bight of a string that is fixed at its end is taken to move as far as the string is drawn."""

    name = "pulley as string end"
    reason = "a movable pulley is taken to move as far as the end of its string, without the factor 2"
    sound_if_same = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The strings that run from a movable pulley to a fixed place, where they end."""
        del query
        return dict.fromkeys(line.whole for line in study.mechanism.strings if _ends_beyond(study.mechanism, line))

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With the string tied to the pulley, as if it were drawn up by one piece of it instead of two."""
        lines = (line if line.whole != subject else _tied(mechanism, line) for line in mechanism.lines)
        return replace(mechanism, lines=tuple(lines))


def _ends_beyond(mechanism: Mechanism, line: Line) -> str | None:
    """The movable pulley beyond which a line ends at a fixed place; None if there is none."""
    pulleys = movable_pulleys(mechanism)
    for end, before in (line.through[:2], line.through[:-3:-1]):
        name = carried(mechanism, mechanism.site[before].body)
        if mechanism.site[end].body is None and name in pulleys:
            return name
    return None


def _tied(mechanism: Mechanism, line: Line) -> Line:
    """A part of such a string, which ends at the pulley; one that is all beyond it pulls at nothing."""
    parts = (part for part in mechanism.lines if part.whole == line.whole)
    pulley = next(name for part in parts if (name := _ends_beyond(mechanism, part)))
    turned = {c.name for c in mechanism.coordinates if carried(mechanism, c.body) == pulley}
    free = replace(line, wheels=tuple(wheel for wheel in line.wheels if wheel.coordinate not in turned))
    if _ends_beyond(mechanism, line) is None:
        return free
    forth = mechanism.site[line.through[-1]].body is None
    through = line.through if forth else line.through[::-1]
    first = next(n for n, site in enumerate(through) if carried(mechanism, mechanism.site[site].body) == pulley)
    if not first:
        return replace(free, law=ConstantTension(0.0))
    kept = through[: first + 1]
    return replace(free, through=kept if forth else kept[::-1])
