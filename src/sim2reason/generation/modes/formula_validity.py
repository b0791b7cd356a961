"""Validity of a formula: tests in scenes with other numbers, and the assumptions that a text must state."""

from collections.abc import Iterator, Sequence
from functools import partial
from itertools import chain, combinations

import numpy as np

from sim2reason.generation.modes.corners import Margin, counterexample, find_corner
from sim2reason.generation.modes.problem_formula import ProblemSymbol, Variation
from sim2reason.generation.modes.variations import Variations
from sim2reason.questions import Formula, SimulatedScene, Words
from sim2reason.questions.regimes import MAX_ASSUMPTIONS, Regime, regimes
from sim2reason.solutions.algebra.expressions import Expression
from sim2reason.solutions.closed_forms import MAX_LATEX_LENGTH, ClosedForm, ClosedFormError, simplified_form

TEST_POINTS = 8  # beside the scene's own numbers
NEAR_WIDTHS = (0.25, 0.08)  # relative distances of test scenes with the same regime
WIDE_LOG_FACTOR = 1.1  # logarithm of the factor (about 3) within which the formula must hold unless a regime is assumed
TRIES, ACROSS = 16, 4
ENGINE_RTOL = 1e-6  # relative deviation between formula and engine
MAX_COUNTEREXAMPLES = 4  # after which the search for assumptions gives up
STEP_ERROR_RTOL = 1e-3  # relative; larger deviations are not due to the engine's steps


class FormulaValidity:
    """Tests of a formula in scenes with other numbers, each of which is simulated when first needed."""

    def __init__(self, variations: Variations, factor: float) -> None:
        """Store the scenes with other numbers, and the factor from the engine's to the formula's unit of the answer."""
        self._variations, self._factor = variations, factor
        self._whole: tuple[Expression, ...] = ()  # the formula as its derivation left it: what cancels has signs, too
        self._signed = False  # whether the sign of the answer is asked for
        self._near: list[Variation] = []
        self._wide: list[Variation] = []
        self._more: Iterator[Variation] | None = None
        self._left = set[tuple[Regime, tuple[Regime, ...]]]()  # what was led out of, while what held
        self._unanswered: list[SimulatedScene] = []  # motions far from the scene's own in which there is no answer

    def of_scene(self, whole: Expression) -> bool:
        """Return whether a formula holds with the scene's own numbers, the cheapest test."""
        own = self._variations.own()
        self._near = [own] if own is not None and self._agrees(whole, own) else []
        return bool(self._near)

    def stated_formula(
        self, whole: Expression, rng: np.random.Generator, words: Words, *, signed: bool
    ) -> tuple[ClosedForm, tuple[Regime, ...]] | None:
        """Return the formula in its final form with the assumptions it needs; None if it disagrees with the engine.

        If no sign is requested and no few regimes fix the signs, absolute values stay between bars.
        """
        self._whole, self._signed = (whole,), signed
        if not self.near(whole, rng):
            return None
        try:
            closed_form = simplified_form(whole)
        except ClosedFormError:
            return None
        assumed = self.assumed(closed_form, rng, words)
        if assumed is None and self._wide and not signed:
            closed_form, assumed = self._sized(closed_form, rng, words)
        if assumed is None:
            return None
        closed_form = self._plainer(closed_form, assumed, rng, words)
        closed_form = closed_form.with_positive_factors([other.values for other in self._near])
        fits = all(self._agrees(closed_form.expression, other) for other in self._near)
        return (closed_form, assumed) if fits and len(closed_form.latex) <= MAX_LATEX_LENGTH else None

    def _sized(
        self, formula: ClosedForm, rng: np.random.Generator, words: Words
    ) -> tuple[ClosedForm, tuple[Regime, ...] | None]:
        """Return a formula for the magnitude, with bars only where the sign varies, and the assumptions it needs."""
        magnitude = formula.of_sizes([other.values for other in (*self._near, *self._wide)])
        assumed = self.assumed(magnitude, rng, words)
        if not assumed:
            return magnitude, assumed
        among = [other.values for other in (*self._near, *self._wide) if not self._violated_regimes(other, assumed)]
        plainer = formula.of_sizes(among)
        return (plainer if self.assumed(plainer, rng, words) == assumed else magnitude), assumed

    def near(self, formula: Expression, rng: np.random.Generator) -> bool:
        """Return whether a formula agrees with the exact engine in several scenes with slightly different numbers."""
        own = self._near[0]
        for width in NEAR_WIDTHS:
            nearby, missed = [own], 0
            for other in self._variations.drawn(rng, width, TRIES):
                if other is not None and other.story == own.story and self._agrees(formula, other):
                    nearby.append(other)
                else:
                    missed += 1
                if len(nearby) > TEST_POINTS:
                    self._near = nearby
                    return True
                if missed > TRIES - TEST_POINTS:
                    break  # too few are left
        return False

    def formula(self, found: ClosedForm, symbols: Sequence[ProblemSymbol]) -> Formula:
        """Return the formula with its symbols, units and tested values, as a question stores it."""
        own = [problem_symbol.symbol for problem_symbol in symbols if not problem_symbol.of_world]
        return Formula(
            found.latex,
            tuple(problem_symbol.symbol for problem_symbol in symbols),
            tuple(problem_symbol.unit for problem_symbol in symbols),
            tuple(tuple(each.values[problem_symbol.symbol] for problem_symbol in symbols) for each in self._near),
            tuple(each.answer * self._factor for each in self._near),
            tuple(symbol for symbol in own if symbol in found.symbols),
            tuple(symbol for symbol in own if symbol not in found.symbols),
        )

    def assumed(self, formula: ClosedForm, rng: np.random.Generator, words: Words) -> tuple[Regime, ...] | None:
        """Return the fewest assumptions, such as taut strings, that exclude all scenes in which the formula fails.

        Regimes that are always stated come first. After each choice a counterexample is sought.
        """
        for _ in range(MAX_COUNTEREXAMPLES):
            assumptions = self._chosen(formula, rng, words)
            if assumptions is None:
                return None
            missed = partial(self._missed, formula.expression, assumptions)
            other = counterexample(
                self._variations, formula.expression, missed, WIDE_LOG_FACTOR, assumptions, signed=self._signed
            )
            if other is None:
                return assumptions
            self._wide.append(other)
        return None

    def _chosen(self, formula: ClosedForm, rng: np.random.Generator, words: Words) -> tuple[Regime, ...] | None:
        """Return the fewest assumptions that exclude all known scenes in which the formula fails; None if no few do.

        Scenes are sought far from the original, and at the limits of the regimes: a string may go slack, or a sliding
        body stick, without a change of sign in the formula.
        """
        kept = self._shared(words)
        excluding: list[set[Regime]] = []
        for other in self._widely(formula.expression, rng):
            if not self._agrees(formula.expression, other):
                excluding.append(self._violated_regimes(other, kept))
                if not excluding[-1]:
                    return None
        chosen = self._fewest(kept, excluding)
        for regime in kept:  # that may be what matters
            matters = chosen is not None and (regime.unseen or any(regime in left for left in excluding))
            other = self._leaving(regime, chosen) if chosen is not None and matters else None
            if other is not None and not self._agrees(formula.expression, other):
                excluding.append(self._violated_regimes(other, kept))
                chosen = self._fewest(kept, excluding)
        return chosen

    def _fewest(self, kept: Sequence[Regime], excluding: Sequence[set[Regime]]) -> tuple[Regime, ...] | None:
        """Return the fewest assumptions with at least one of each given set, and with all that texts must state.

        Among equally few regimes, those are preferred that also exclude scenes without an answer that begin differently
        or leave a regime, because the text would otherwise seem to include them.
        """
        required = {each for each in kept if each.must_be_stated(self._near[0].study)}
        begun = [*excluding, *self._begun_otherwise(kept)]
        fitting = [some for some in _some(kept, max(MAX_ASSUMPTIONS, len(required) + 1)) if required.issubset(some)]
        for left in (begun, excluding):
            if not left and not required:
                return ()
            chosen = next((some for some in fitting if all(not each.isdisjoint(some) for each in left)), None)
            if chosen is not None:
                return chosen
        return None

    @staticmethod
    def _violated_regimes(other: Variation, kept: Sequence[Regime]) -> set[Regime]:
        """Return the assumptions that a scene does not satisfy."""
        return {regime for regime in kept if not other.satisfies(regime)}

    def _missed(self, formula: Expression, told: Sequence[Regime], other: Variation) -> bool:
        """Return whether a formula fails in a scene although the scene satisfies all stated assumptions."""
        return all(other.satisfies(regime) for regime in told) and not self._agrees(formula, other)

    def _leaving(self, held: Regime, told: Sequence[Regime]) -> Variation | None:
        """Return a scene that violates one assumption, or nearly does, but satisfies the stated ones.

        None if a known variation is already outside the regime.
        """
        if held in told or (held, tuple(told)) in self._left:
            return None
        self._left.add((held, tuple(told)))
        among = [other for other in self._wide if not self._violated_regimes(other, told)]
        if not all(other.satisfies(held) for other in among):
            return None
        corner = find_corner(self._variations, _margin(held), told, self._wide)
        self._wide += [corner] if corner is not None else []
        return corner

    def _plainer(
        self, formula: ClosedForm, assumed: tuple[Regime, ...], rng: np.random.Generator, words: Words
    ) -> ClosedForm:
        """Return the formula with √(x²) replaced by x or −x where no further assumption is needed, else by |x|."""
        sized = formula.without_roots_of_squares()
        if sized == formula:
            return formula
        signed = formula.without_roots_of_squares(self._near[0].values)
        fits = all(self._agrees(signed.expression, other) for other in self._near)
        return signed if fits and self.assumed(signed, rng, words) == assumed else sized

    def _widely(self, formula: Expression, rng: np.random.Generator) -> Iterator[Variation]:
        """Yield scenes with numbers far from the problem's own, in which the formula may fail."""
        yield from self._wide
        self._more = self._more or chain(
            self._variations.across(rng, NEAR_WIDTHS[-1], ACROSS),
            self._variations.draw_turned(rng, (formula, *self._whole), WIDE_LOG_FACTOR, self._unanswered),
            self._variations.vary_one_by_one(WIDE_LOG_FACTOR, self._unanswered),
            self._variations.mirrored(rng, WIDE_LOG_FACTOR),
            self._variations.widely(rng, WIDE_LOG_FACTOR, self._unanswered),
        )
        for other in self._more:
            self._wide.append(other)
            yield other

    def _shared(self, words: Words) -> list[Regime]:
        """Return the assumptions that hold in the problem's own scene and in those with slightly different numbers."""
        own, *others = self._near
        own_regimes = regimes(own.study, words, own.until)
        if own.query.hides:  # the text does not tell the motion
            own_regimes = [regime for regime in own_regimes if regime.regardless_of(own.study, own.query.hides)]
        return [regime for regime in own_regimes if all(other.satisfies(regime) for other in others)]

    def _begun_otherwise(self, kept: Sequence[Regime]) -> Iterator[set[Regime]]:
        """Yield a set of assumptions for each scene without an answer: those whose violation may be the reason."""
        own = self._near[0].study
        first = [regime for regime in kept if regime.holds(own, 0.0)]
        violated = (
            {h for h in first if not h.holds(other, 0.0) or h.may_remove_answer(other)} for other in self._unanswered
        )
        yield from filter(None, violated)

    def _agrees(self, formula: Expression, other: Variation) -> bool:
        try:
            value = formula.value(other.values)
        except (ValueError, ZeroDivisionError, OverflowError):
            return False
        missed, size = abs(value - other.answer * self._factor), abs(other.answer * self._factor)
        if not ENGINE_RTOL * size < missed <= STEP_ERROR_RTOL * size:
            return missed <= ENGINE_RTOL * size
        finer = other.finer  # since what steps err by may grow on the way
        return finer is not None and self._agrees(formula, finer)


def _margin(regime: Regime) -> Margin:
    return lambda other: regime.margin(other.study, other.until)


def _some(assumptions: Sequence[Regime], few: int) -> Iterator[tuple[Regime, ...]]:
    """Yield single assumptions, then combinations of two and more, up to a few."""
    for count in range(1, few + 1):
        yield from combinations(assumptions, count)
