"""Whether strings that hold bodies against their weight stay taut while these oscillate."""

from collections.abc import Iterator
from dataclasses import dataclass

from sim2reason.solutions.algebra.expressions import Expression, Number
from sim2reason.solutions.algebra.fractions import over
from sim2reason.solutions.algebra.functions import Power
from sim2reason.solutions.oscillations.harmonic import Harmonic
from sim2reason.solutions.oscillations.linear_motion import LinearMotion
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.writing.comparing import exceeds
from sim2reason.solutions.writing.steps import Book
from sim2reason.solutions.writing.unit_latex import ACCELERATION, NEWTONS


@dataclass(frozen=True)
class _Held:
    """A body that a string pulls against its weight: its coordinate, the line, its mass, and how it would fall."""

    k: int
    line: int
    mass: Expression
    falling: Expression  # its acceleration without the string, m/s²


def verify_taut(setting: Setting, book: Book, held: Harmonic) -> None:
    """Write, in the end, that no body that hangs on a string ever falls freely; nothing where numbers do not tell."""
    held = max(_with_earlier(held), key=lambda swing: swing.size)
    motion = held.motion
    if book.in_symbols or not isinstance(motion, LinearMotion):
        return
    for body in _hanging(motion):
        ratio = abs(motion.ratio(body.k, motion.free[0]))
        if 0.0 < ratio * held.numbers[0] ** 2 * held.size < body.falling.value(motion.givens).real:
            book.afterwards.append(lambda body=body, r=ratio: _write(setting, book, held, body, r))


def _with_earlier(held: Harmonic) -> Iterator[Harmonic]:
    """Yield a half-oscillation and all earlier half-oscillations, which are wider if there is friction."""
    earlier: Harmonic | None = held
    while earlier is not None:
        yield earlier
        earlier = earlier.like


def _hanging(motion: LinearMotion) -> Iterator[_Held]:
    """Yield the bodies on which one string and, against it, their weight act alone."""
    for k in motion.ratios:
        row = motion.laws.newton(k)
        names = [n for n in row.zero.names() if n[0] in "TNSf" and n[1:].isdigit()]
        if len(names) != 1 or names[0][0] != "T":
            continue
        pull, mass = row.forces.without(names), row.inertia.coefficient(f"q{k}")
        along, weight = row.forces.coefficient(names[0]).number or 0.0, pull.value(motion.givens)
        if mass and not row.inertia.without((f"q{k}",)) and along * weight < 0.0:
            falling = over(pull if weight > 0.0 else pull.scaled(-1.0), mass)
            yield _Held(k, int(names[0][1:]), mass.factored(), falling)


def _write(setting: Setting, book: Book, held: Harmonic, body: _Held, ratio: float) -> None:
    greatest = Power(held.rate, 2) * held.amplitude
    formula = greatest if ratio == 1.0 else Number(ratio) * greatest
    step, name, least = book.open("verify"), book.fresh("a", r"\text{max}"), book.fresh("T", r"\text{min}")
    exceeds(book, step, body.falling, formula)
    who = setting.called(setting.mechanism.coordinates[body.k].body)
    string = setting.lines[held.motion.laws.lines[body.line].name]
    step.say(f"The acceleration of {who} is at most {step.verified(name, formula, ACCELERATION)},")
    step.say(f"less than ${body.falling.latex()}$, so {string} stays taut. Its tension is at least")
    step.say(f"{step.verified(least, body.mass * (body.falling - name), NEWTONS)}.")
    step.close()
