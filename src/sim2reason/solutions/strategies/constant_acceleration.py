"""Constant acceleration: Newton's laws, then v = v₀ + a t and its kin, stage by stage."""

from collections.abc import Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.questions.moments.contacts import StoppedSlipping
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.times import AtStart, AtTime
from sim2reason.questions.moments.turning_points import Stopped
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.engines.exact.motion import Segment
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, total
from sim2reason.solutions.laws.directions import verify_farther, verify_remaining
from sim2reason.solutions.laws.dynamics import Dynamics
from sim2reason.solutions.laws.newton import Newton
from sim2reason.solutions.laws.stage import End, Stage
from sim2reason.solutions.laws.stage_part import StagePart, verify_still_sliding, write_stage_arcs
from sim2reason.solutions.laws.sticking import tell_slipping_on
from sim2reason.solutions.laws.straight_way import COMPONENT_ATOL, StraightMotion
from sim2reason.solutions.setting import ProblemContext, capitalized
from sim2reason.solutions.strategies import Strategy, missing_goal, strategy, varying_acceleration
from sim2reason.solutions.writing.notation import METRES, NEWTONS, SECONDS
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

MOMENTS = (AtStart, AtTime, Moved, Stopped, StoppedSlipping)


@strategy
class ConstantAcceleration(Strategy):
    """The strategy for bodies on straight lines whose accelerations change only as contacts stick or slip."""

    name = "constant acceleration"
    cost = 1.0
    kinds = frozenset({"start", "state", "event", "time_to_event", "sum"})

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that the strategy cannot apply to a mechanism; empty if it may apply."""
        return varying_acceleration(mechanism)

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        if unknown := missing_goal(setting, MOMENTS):
            return unknown
        if "collision" in setting.earlier_event_kinds:
            return "there are collisions"
        return ""

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write Newton's laws and the kinematics of each stage, and return the symbol of the answer."""
        model = _Staged(setting, book)
        if model.goal is not None and (model.goal.throughout or model.goal.turns):
            draft = _Staged(setting, book.copy())
            draft.write()
            model.redundant_coordinates = draft.unused
        return model.write()


class _Staged(StraightMotion):
    """A motion in stages of constant acceleration.

    For each stage, `redundant_coordinates` has the coordinates whose acceleration is unused.
    """

    redundant_coordinates: Sequence[AbstractSet[int]] = ()

    @property
    def unused(self) -> list[AbstractSet[int]]:
        """Return, by stage, the coordinates whose accelerations were computed but not used."""
        moved = [step for step in self.book.steps if step.kind in ("time", "velocity", "distance", "answer")]
        used = {name for step in moved for relation in step.relations for name in relation.symbols()}
        return [
            {k for s in stage.dynamics.shared if s.symbol.name not in used and len(s.sense) == 1 for k in s.sense}
            for stage in self.stages
        ]

    def write(self) -> str:
        """Write all relevant stages and the answer, and return the answer's symbol."""
        if self.target is None or self.goal is None:
            return self._whole_time().name
        answer = self.goal.write(self.target, self).name
        verify_still_sliding(self.stages)
        return answer

    @property
    def newton(self) -> Newton:
        """Return Newton's laws of the last stage."""
        return self.stages[-1].dynamics.newton

    def rate(self, kind: str, k: int) -> Polynomial:
        """Return the acceleration, velocity or displacement of a coordinate at the end of the last stage."""
        stage = self.stages[-1]
        return {"a": stage.acceleration, "v": stage.velocity, "s": stage.place}[kind](k)

    @property
    def motion_parts(self) -> Sequence[StagePart]:
        """Return the stages as parts of the motion."""
        return [StagePart(self, stage, stage.dynamics) for stage in self.stages]

    def write_arcs(self, body: str) -> None:
        """Write the angle turned by a body, stage by stage."""
        if (k := self.hinge(body)) is not None and not self.stages[-1].uniform:
            write_stage_arcs(self.book, self.stages, k)

    def force(self, kind: str, name: str) -> Symbol:
        """Write the force that is asked for, if necessary, and return its symbol."""
        force_key, solved_key = self._force
        polynomial = self.stages[-1].dynamics.names.get(solved_key)
        if polynomial is None:
            raise UnsolvedError(f"{name} has no {kind} here")
        symbol = Symbol(next(iter(polynomial.names())))
        if force_key == solved_key:
            return symbol
        step, friction = self.book.begin_step("friction"), self.book.fresh("f", self.setting.subscript_of(name))
        formula = (self.newton.coefficient(int(solved_key[1:])) * Polynomial.from_expression(symbol)).expression()
        step.add_text(f"It slides, so {step.result(friction, formula, NEWTONS, law=True)}.")
        step.close()
        return friction

    @cached_property
    def _force(self) -> tuple[str, str]:
        """Return the names of the force asked for and of the one computed: for sliding friction the normal force."""
        return self._force_in(self.segments[-1])

    def _force_in(self, segment: Segment) -> tuple[str, str]:
        if self.goal is None or self.target is None:
            return "", ""
        force_key = self.goal.force(self.target, self.setting)
        slides = force_key[:1] == "f" and Newton(self.setting.lexicon, segment).slip_directions[int(force_key[1:])] != 0
        if self.goal.throughout and force_key[:1] == "f" and not slides:
            return force_key, ""  # what sticks dissipates nothing
        return force_key, f"N{force_key[1:]}" if slides else force_key

    def _goal_of(self, segment: Segment, *, last: bool) -> list[str]:
        """Return a list with the name of the force that a stage must compute for the answer; without one, empty."""
        solved_key = self._force_in(segment)[1] if last or (self.goal is not None and self.goal.throughout) else ""
        return [solved_key] if solved_key else []

    # ---- stages

    @cached_property
    def relevant_coordinates(self) -> list[int]:
        """Return the coordinates whose motion the quantity or the moment of the question depends on."""
        moment = self.query.moment
        timed = self.uses in ("v", "s")
        bodies = [moment.name] if timed and isinstance(moment, Moved | Stopped) else []
        slips = self._slipping(moment.name) if timed and isinstance(moment, StoppedSlipping) else []
        return sorted({*self.asked_coordinates(), *self.moving(bodies), *slips})

    def _slipping(self, body: str) -> list[int]:
        """Return the coordinates along which a body slides on its face."""
        return [self.mechanism.number[name] for name, _ in self.mechanism.contacts[body].slip]

    @cached_property
    def segments(self) -> list[Segment]:
        """Return the segments at which relevant accelerations or forces change; if no motion matters, the last one."""
        all_of_them = [s for s in self.setting.motion.segments if s.start < self.setting.time or s.start == 0.0]
        if self.uses not in ("v", "s"):
            return all_of_them[-1:]
        relevant = all_of_them[:1]
        for segment in all_of_them[1:]:
            moved = any(abs(segment.a[k] - relevant[-1].a[k]) > COMPONENT_ATOL for k in self.relevant_coordinates)
            if moved or self._pulls(segment) != self._pulls(relevant[-1]):
                relevant.append(segment)
        return relevant

    def _pulls(self, segment: Segment) -> tuple[str, float]:
        """Return name and magnitude in a segment of the force whose work or impulse is asked for; "" and 0 if none."""
        if self.goal is None or not self.goal.throughout:
            return "", 0.0
        name = self._force_in(segment)[1]
        return name, round(Newton(self.setting.lexicon, segment).values[name], 9) if name else 0.0

    @cached_property
    def stages(self) -> list[Stage]:
        """Return all stages, each with the final state of the stage before."""
        completed_stages: list[Stage] = []
        pairs = zip(self.segments, self.segments[1:], strict=False)
        stops = [self._stopping(now, after) for now, after in pairs]
        for number, segment in enumerate(self.segments):
            last = number == len(self.segments) - 1
            until = self.setting.time if last else self.segments[number + 1].start
            before = completed_stages[-1] if completed_stages else None
            later = {k for stop in stops[number:] for k in (stop.coordinate, *stop.slip)}
            handed = sorted({*self.relevant_coordinates, *later})
            speeds = {k: before.relative("v", k) for k in handed} if before else self.first_speeds
            places = {k: before.relative("s", k) for k in self.relevant_coordinates} if before else {}
            end = self._end(completed_stages, places) if last else stops[number]
            if before is not None and before.end.turned is not None:
                newton = Newton(self.setting.lexicon, segment)
                tell_slipping_on(newton, self.setting, self.book, before.end.turned)
            stage = Stage(self.setting, self.book, segment, until - segment.start, end, speeds, places)
            spare = set[int]() if not last else {*self.relevant_coordinates} - {*self._enough(stage)}
            spare |= {*(self.redundant_coordinates[number] if self.redundant_coordinates else ())}
            goals = [f"q{k}" for k in sorted(({*handed} - spare) | {*end.slip})]
            forces = self._goal_of(segment, last=last)
            resting = not forces and all(abs(segment.found.a[k]) < COMPONENT_ATOL for k in speeds)
            stage.uniform = resting and before is not None and not stage.dynamics.carrier_coordinates
            stage.reach([*goals, *forces])
            completed_stages.append(stage)
        return completed_stages

    def _enough(self, stage: Stage) -> list[int]:
        """Return the coordinates whose motion in the last stage gives the answer and the end of the stage."""
        moment = self.query.moment
        bodies = list(self.goal.bodies(self.target)) if self.goal is not None and self.target is not None else []
        timed = self.uses in ("v", "s") and isinstance(moment, Moved | Stopped)
        hinges = [k for body in bodies if (k := self.hinge(body)) is not None]
        coordinates = [*hinges, *self.moving([moment.name] if timed and isinstance(moment, Moved | Stopped) else [])]
        coordinates += self._slipping(moment.name) if isinstance(moment, StoppedSlipping) else []
        slips = self.goal is not None and self.goal.throughout and self._force[0][:1] == "f"
        for body in bodies:
            coordinates += self.moving([body]) if slips else stage.dynamics.sufficient_coordinates(self.moving([body]))
        lines = self.goal.lines(self.target) if self.goal is not None and self.target is not None else ()
        return [*coordinates, *(k for name in lines for k in self.stretching(name))]

    def body_coordinates(self, body: str) -> list[int]:
        """Return the coordinates of a body's motion in the last stage, without those of a carrier below the body."""
        return self.stages[-1].dynamics.sufficient_coordinates(self.moving([body]))

    def _end(self, before: list[Stage], places: Mapping[int, Polynomial]) -> End:
        """Return the end condition of the last stage, by the moment of the question."""
        moment = self.query.moment
        if isinstance(moment, AtTime):
            return self._at_time(moment, before)
        if isinstance(moment, Moved):
            k, *_ = self.moving([moment.name])
            name = self.book.fresh("d")
            self.book.state_given(name.name, moment.value, METRES)
            there = self.setting.motion.state(np.array([self.setting.time])).q[0, k]
            displacement = Polynomial.from_expression(name).scale(1.0 if there > 0.0 else -1.0) - places.get(k, NIL)
            if before:
                verify_farther(
                    self.book, displacement, (name, places.get(k, NIL)), self.setting.display_name(moment.name)
                )
            return End(None, k, displacement, f"When {moment.told(self.setting.words, f'${name.name}$')},")
        if isinstance(moment, Stopped):
            k, *_ = self.moving([moment.name])
            return End(None, k, None, f"{capitalized(self.setting.display_name(moment.name))} comes to rest when")
        if isinstance(moment, StoppedSlipping):
            return self._slips_no_more(moment.name, self.segments[-1])
        return End()

    def _slips_no_more(self, body: str, segment: Segment) -> End:
        """Return the end condition of a stage at which a body stops slipping on the surface below it."""
        slips = self._slipping(body)
        if len(slips) == 1:
            carried = Dynamics(self.setting, self.book, segment).carrier_coordinates
            if slips[0] not in carried:
                return End(None, slips[0], None, self._stops(body))
            j, sign = carried[slips[0]]
            slip = {slips[0]: Polynomial.from_expression(1.0), j: Polynomial.from_expression(-sign)}
            return End(None, slips[0], None, self._stops(body), slip)
        face = list(self.mechanism.contacts).index(body)
        what = f"{capitalized(self.setting.display_name(body))} begins to roll without slipping when"
        return End(None, slips[0], None, what, Newton(self.setting.lexicon, self.segments[0]).slip(face))

    def _stops(self, body: str) -> str:
        """Return a clause such as *Block A comes to rest when* or *Block A stops sliding on plank B when*."""
        carrier = self.mechanism.body[body].parent
        what = f"stops sliding on {self.setting.display_name(carrier)}" if carrier else "comes to rest"
        return f"{capitalized(self.setting.display_name(body))} {what} when"

    def _at_time(self, moment: AtTime, before: list[Stage]) -> End:
        name = self.book.fresh("t")
        self.book.state_given(name.name, moment.after, SECONDS)
        if not before or self.uses not in ("v", "s"):
            return End(name)
        formula = (
            Polynomial.from_expression(name) - total(Polynomial.from_expression(stage.time) for stage in before)
        ).expression()
        left = self.book.add_step("time", "The remaining time is", self.book.fresh("t"), formula, SECONDS)
        verify_remaining(self.book, left, formula, name.name)
        return End(left)

    def _whole_time(self) -> Symbol:
        """Write the total duration of all stages, s, and return its symbol."""
        times = [stage.time for stage in self.stages]
        if len(times) == 1:
            return times[0]
        formula = total(Polynomial.from_expression(time) for time in times).expression()
        return self.book.add_step("time", "The total time is", self.book.fresh("t"), formula, SECONDS)

    def _stopping(self, now: Segment, after: Segment) -> End:
        """Return the end condition of a stage: the slip velocity that becomes zero between two segments."""
        faces = [face for face in self.mechanism.faces if face.friction > 0.0]
        for face, side, later in zip(faces, now.found.mode.rubbing, after.found.mode.rubbing, strict=True):
            if side and later != side:
                stop = self._slips_no_more(face.subject, now)
                return self._reversal_condition(stop, face.subject) if later else stop
        raise UnsolvedError("something changes on the way that is neither sliding nor sticking")

    def _reversal_condition(self, stop: End, body: str) -> End:
        """Return the end condition `stop`, worded for a body that then slips in the opposite direction."""
        who, carrier = self.setting.display_name(body), self.mechanism.body[body].parent
        relative = f" relative to {self.setting.display_name(carrier)}" if carrier else ""
        what = f"{capitalized(who)} is momentarily at rest{relative}"
        if len(self._slipping(body)) > 1:
            what = f"The point of contact of {who} is momentarily at rest"
        return replace(stop, what=f"{what} when", turned=list(self.mechanism.contacts).index(body))
