"""Whether strings on which bodies hang stay taut while these oscillate."""

from collections.abc import Iterator

from sim2reason.solutions.algebra.expressions import Expression, Number
from sim2reason.solutions.algebra.functions import Power
from sim2reason.solutions.oscillations.harmonic import Harmonic
from sim2reason.solutions.oscillations.linear_motion import LinearMotion
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.writing.comparing import exceeds
from sim2reason.solutions.writing.steps import Book
from sim2reason.solutions.writing.unit_latex import ACCELERATION


def verify_taut(setting: Setting, book: Book, held: Harmonic) -> None:
    """Write, in the end, that no body that hangs on a string ever falls freely; nothing where numbers do not tell."""
    held = max(_with_earlier(held), key=lambda swing: swing.size)
    motion = held.motion
    if book.in_symbols or not isinstance(motion, LinearMotion):
        return
    gravity = setting.lexicon.of(lambda m: -m.gravity[2]).expression()
    for k, line in _hanging(motion):
        ratio = abs(motion.ratio(k, motion.free[0]))
        if 0.0 < ratio * held.numbers[0] ** 2 * held.size < book.value(gravity):
            book.afterwards.append(lambda k=k, line=line, r=ratio: _write(setting, book, held, gravity, k, line, r))


def _with_earlier(held: Harmonic) -> Iterator[Harmonic]:
    """Yield a half-oscillation and all earlier half-oscillations, which are wider if there is friction."""
    earlier: Harmonic | None = held
    while earlier is not None:
        yield earlier
        earlier = earlier.like


def _hanging(motion: LinearMotion) -> Iterator[tuple[int, int]]:
    """Yield the coordinates of bodies on which their weight and one string act alone, each with that string."""
    for k in motion.ratios:
        names = [n for n in motion.laws.newton(k).forces.names() if n[0] in "TNSf" and n[1:].isdigit()]
        if len(names) == 1 and names[0][0] == "T" and abs(motion.mechanism.coordinates[k].axis[2]) > 1.0 - 1e-9:
            yield k, int(names[0][1:])


def _write(setting: Setting, book: Book, held: Harmonic, gravity: Expression, k: int, line: int, ratio: float) -> None:
    greatest = Power(held.rate, 2) * held.amplitude
    formula = greatest if ratio == 1.0 else Number(ratio) * greatest
    step, name = book.open("verify"), book.fresh("a", r"\text{max}")
    exceeds(book, step, gravity, formula)
    who = setting.called(setting.mechanism.coordinates[k].body)
    string = setting.lines[held.motion.laws.lines[line].name]
    step.say(f"The acceleration of {who} is at most {step.verified(name, formula, ACCELERATION)},")
    step.say(f"less than ${gravity.latex()}$, so {string} stays taut.")
    step.close()
