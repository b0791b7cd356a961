"""The events of a motion while it is simulated, and why it ends."""

from collections.abc import Iterable

from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.engines.exact.lengths import RowKind
from sim2reason.simulation.engines.exact.linear import Mode, RoughContact
from sim2reason.simulation.trace import EVENT_KINDS, Event

CROWD = 5e-3  # s; a body that is hit again, or a string that jerks again, sooner has too much happen at once
SAME = 8  # events back among which one is looked for that says the same
TIE = 1e-11  # s; events that are no further apart are simultaneous
BEGINS = {"string": "taut", "prop": "land", "foot": "land"}
STOPS = {"string": "slack", "prop": "leave", "foot": "leave"}
ORDER = {kind: place for place, kind in enumerate(EVENT_KINDS)}  # of simultaneous events


class EventLog:
    """Events, impacts by whom they struck, and the kind of the event that ended it all."""

    def __init__(self, mechanism: Mechanism) -> None:
        """Nothing has happened."""
        self._mechanism = mechanism
        self.events: list[Event] = []
        self.cut = ""
        self._hits: dict[str, tuple[float, tuple[str, ...]]] = {}  # the last hit of each body, or jerk of each row

    def record(self, time: float, kind: str, *subjects: str) -> None:
        """Record an event unless it is already recorded: a body may enter the regions of several forces at one instant.

        Collisions are always recorded, since two bodies that touch others may collide more than once at an instant.
        """
        event = Event(time, kind, subjects)
        if kind == "collision" or event not in self.events[-SAME:]:
            self.events.append(event)

    def end(self, time: float, kind: str, *subjects: str) -> None:
        """Note an event that ends the description."""
        self.record(time, kind, *subjects)
        self.cut = self.cut or kind

    def lift(self, time: float, contacts: Iterable[int]) -> None:
        """Bodies leave their faces: the end."""
        for number in contacts:
            self.end(time, "lift", self._mechanism.faces[number].subject)

    def struck(self, time: float, names: Iterable[str], subjects: tuple[str, ...]) -> None:
        """Remember an impact on bodies or rows."""
        self._hits |= dict.fromkeys(names, (time, subjects))

    def crowded(self, time: float, names: Iterable[str]) -> float | None:
        """Return when the impact was after which one of `names` is struck again too soon; None if none is.

        Two can do so by turns, without end.
        """
        recent = [self._hits[name] for name in names if name in self._hits]
        early = min((hit for hit in recent if TIE < time - hit[0] < CROWD), default=None)
        if early is None:
            return None
        self.events = [event for event in self.events if event.time <= early[0]]
        self.end(early[0], "crowd", *early[1])
        return early[0]

    def snapped(self, time: float, kinds: list[RowKind], rows: Iterable[int]) -> None:
        """Rows that were used up with a jerk."""
        for number in sorted(rows):
            self.record(time, BEGINS[kinds[number].kind], kinds[number].name)

    def changed(
        self, time: float, kinds: list[RowKind], modes: tuple[Mode, Mode], rows: set[int], *, first: bool
    ) -> None:
        """Rows that begin or cease to act between two modes, those in `rows` with a jerk."""
        before, after = modes
        for number, kind in enumerate(kinds):
            if kind.both:
                continue
            if number in rows or (after.acting[number] and not before.acting[number]):
                self.record(time, BEGINS[kind.kind], kind.name)
            elif before.acting[number] and not after.acting[number] and not first:
                self.record(time, STOPS[kind.kind], kind.name)

    def rubbed(self, time: float, grips: tuple[RoughContact, ...], modes: tuple[Mode, Mode]) -> None:
        """Contacts that begin to stick or to slip."""
        for grip, was, now in zip(grips, modes[0].rubbing, modes[1].rubbing, strict=True):
            if was != now:
                self.record(time, "slip" if now else "stick", self._mechanism.faces[grip.contact].subject)

    def sorted(self) -> tuple[Event, ...]:
        """Return all events in order of time."""
        return tuple(sorted(self.events, key=lambda event: (event.time, ORDER[event.kind])))
