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

POINTS = 8  # beside the scene's own numbers
NEAR_WIDTHS = (0.25, 0.08)  # relative distances of test scenes with the same regime
WIDE = 1.1  # logarithm of the factor (about 3) within which the formula must hold unless a regime is assumed
TRIES, ACROSS = 16, 4
ENGINE_RTOL = 1e-6  # relative deviation between formula and engine
COUNTEREXAMPLES = 4  # after which the search for assumptions gives up
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
            found = simplified_form(whole)
        except ClosedFormError:
            return None
        assumed = self.assumed(found, rng, words)
        if assumed is None and self._wide and not signed:
            found, assumed = self._sized(found, rng, words)
        if assumed is None:
            return None
        found = self._plainer(found, assumed, rng, words)
        found = found.with_positive_factors([other.values for other in self._near])
        fits = all(self._agrees(found.expression, other) for other in self._near)
        return (found, assumed) if fits and len(found.latex) <= MAX_LATEX_LENGTH else None

    def _sized(
        self, formula: ClosedForm, rng: np.random.Generator, words: Words
    ) -> tuple[ClosedForm, tuple[Regime, ...] | None]:
        """Return a formula for the magnitude, with bars only where the sign varies, and the assumptions it needs."""
        found = formula.of_sizes([other.values for other in (*self._near, *self._wide)])
        assumed = self.assumed(found, rng, words)
        if not assumed:
            return found, assumed
        among = [other.values for other in (*self._near, *self._wide) if not self._leaving_out(other, assumed)]
        plainer = formula.of_sizes(among)
        return (plainer if self.assumed(plainer, rng, words) == assumed else found), assumed

    def near(self, formula: Expression, rng: np.random.Generator) -> bool:
        """Return whether a formula agrees with the exact engine in several scenes with slightly different numbers."""
        own = self._near[0]
        for width in NEAR_WIDTHS:
            found = [own]
            for other in self._variations.drawn(rng, width, TRIES):
                if other.story == own.story and self._agrees(formula, other):
                    found.append(other)
                if len(found) > POINTS:
                    self._near = found
                    return True
        return False

    def formula(self, found: ClosedForm, symbols: Sequence[ProblemSymbol]) -> Formula:
        """Return the formula with its symbols, units and tested values, as a question stores it."""
        own = [held.symbol for held in symbols if not held.of_world]
        return Formula(
            found.latex,
            tuple(held.symbol for held in symbols),
            tuple(held.unit for held in symbols),
            tuple(tuple(each.values[held.symbol] for held in symbols) for each in self._near),
            tuple(each.answer * self._factor for each in self._near),
            tuple(symbol for symbol in own if symbol in found.symbols),
            tuple(symbol for symbol in own if symbol not in found.symbols),
        )

    def assumed(self, formula: ClosedForm, rng: np.random.Generator, words: Words) -> tuple[Regime, ...] | None:
        """Return the fewest assumptions, such as taut strings, that exclude all scenes in which the formula fails.

        Regimes that are always stated come first. After each choice a counterexample is sought.
        """
        for _ in range(COUNTEREXAMPLES):
            found = self._chosen(formula, rng, words)
            if found is None:
                return None
            missed = partial(self._missed, formula.expression, found)
            other = counterexample(self._variations, formula.expression, missed, WIDE, signed=self._signed)
            if other is None:
                return found
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
                excluding.append(self._leaving_out(other, kept))
                if not excluding[-1]:
                    return None
        chosen = self._fewest(kept, excluding)
        for held in kept:  # that may be what matters
            matters = chosen is not None and (held.unseen or any(held in left for left in excluding))
            other = self._leaving(held, chosen) if chosen is not None and matters else None
            if other is not None and not self._agrees(formula.expression, other):
                excluding.append(self._leaving_out(other, kept))
                chosen = self._fewest(kept, excluding)
        return chosen

    def _fewest(self, kept: Sequence[Regime], excluding: Sequence[set[Regime]]) -> tuple[Regime, ...] | None:
        """Return the fewest assumptions with at least one of each given set, and with all that texts must state.

        Among equally few regimes, those are preferred that also exclude scenes without an answer that begin differently
        or leave a regime, because the text would otherwise seem to include them.
        """
        told = {held for held in kept if held.must_be_stated(self._near[0].study)}
        begun = [*excluding, *self._begun_otherwise(kept)]
        fitting = [some for some in _some(kept, max(MAX_ASSUMPTIONS, len(told) + 1)) if told.issubset(some)]
        for left in (begun, excluding):
            if not left and not told:
                return ()
            chosen = next((some for some in fitting if all(not held.isdisjoint(some) for held in left)), None)
            if chosen is not None:
                return chosen
        return None

    @staticmethod
    def _leaving_out(other: Variation, kept: Sequence[Regime]) -> set[Regime]:
        """Return the assumptions that a scene does not satisfy."""
        return {held for held in kept if not held.holds(other.study, other.until)}

    def _missed(self, formula: Expression, told: Sequence[Regime], other: Variation) -> bool:
        """Return whether a formula fails in a scene although the scene satisfies all stated assumptions."""
        return not self._leaving_out(other, told) and not self._agrees(formula, other)

    def _leaving(self, held: Regime, told: Sequence[Regime]) -> Variation | None:
        """Return a scene that violates one assumption, or nearly does, but satisfies the stated ones.

        None if a known variation is already outside the regime.
        """
        if held in told or (held, tuple(told)) in self._left:
            return None
        self._left.add((held, tuple(told)))
        among = [other for other in self._wide if not self._leaving_out(other, told)]
        if not all(held.holds(other.study, other.until) for other in among):
            return None
        found = find_corner(self._variations, _margin(held), [_kept(each) for each in told], self._wide)
        self._wide += [found] if found is not None else []
        return found

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
            self._variations.turned(rng, (formula, *self._whole), WIDE, self._unanswered),
            self._variations.one_by_one(WIDE, self._unanswered),
            self._variations.mirrored(rng, WIDE),
            self._variations.widely(rng, WIDE, self._unanswered),
        )
        for other in self._more:
            self._wide.append(other)
            yield other

    def _shared(self, words: Words) -> list[Regime]:
        """Return the assumptions that hold in the problem's own scene and in those with slightly different numbers."""
        own, *others = self._near
        found = regimes(own.study, words, own.until)
        if own.query.hides:  # the text does not tell the motion
            found = [held for held in found if held.regardless_of(own.study, own.query.hides)]
        return [held for held in found if all(held.holds(other.study, other.until) for other in others)]

    def _begun_otherwise(self, kept: Sequence[Regime]) -> Iterator[set[Regime]]:
        """Yield a set of assumptions for each scene without an answer: those whose violation may be the reason."""
        own = self._near[0].study
        first = [held for held in kept if held.holds(own, 0.0)]
        found = (
            {h for h in first if not h.holds(other, 0.0) or h.may_remove_answer(other)} for other in self._unanswered
        )
        yield from filter(None, found)

    def _agrees(self, formula: Expression, other: Variation) -> bool:
        try:
            found = formula.value(other.values)
        except (ValueError, ZeroDivisionError, OverflowError):
            return False
        missed, size = abs(found - other.answer * self._factor), abs(other.answer * self._factor)
        if not ENGINE_RTOL * size < missed <= STEP_ERROR_RTOL * size:
            return missed <= ENGINE_RTOL * size
        finer = other.finer  # since what steps err by may grow on the way
        return finer is not None and self._agrees(formula, finer)


def _margin(held: Regime) -> Margin:
    return lambda other: held.margin(other.study, other.until)


def _kept(held: Regime) -> Margin:
    """Return a function of a scene: its distance from violating an assumption, negative if it violates it."""

    def margin(other: Variation) -> float:
        found = held.margin(other.study, other.until) if held.holds(other.study, other.until) else -1.0
        return 1.0 if found is None else found

    return margin


def _some(found: Sequence[Regime], few: int) -> Iterator[tuple[Regime, ...]]:
    """Yield single assumptions, then combinations of two and more, up to a few."""
    for count in range(1, few + 1):
        yield from combinations(found, count)
