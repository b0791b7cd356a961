"""The work of a varying tension, from the change in kinetic energy of the body on which it acts."""

from collections.abc import Collection

from sim2reason.solutions.algebra.expressions import Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Power, sum_of_squares, summed
from sim2reason.solutions.algebra.polynomials import NIL
from sim2reason.solutions.laws.straight_way import StraightMotion
from sim2reason.solutions.writing.steps import UnsolvedError
from sim2reason.solutions.writing.unit_latex import JOULES

HALF = Number(0.5)


def write_tension_work(way: StraightMotion, springs: Collection[int], body: str) -> Symbol:
    """Write the work of a tension on a body and return its symbol; UnsolvedError if other forces vary.

    `springs` are the indices of all lines that are springs; their work and that of the weight are known.
    """
    (k, *others), target, goal = way.moving([body]), way.target, way.goal
    if others or target is None or goal is None:
        raise UnsolvedError("the body moves along no line of its own")
    row, asked = way.newton.newton(k), goal.force(target, way.setting)
    pulling = [n for n in springs if f"S{n}" in row.forces.names()]
    steady = row.forces.without([asked, *(f"S{n}" for n in pulling)])
    unknown = any(name[0] in "TNf" and name[1:].isdigit() for name in steady.names())
    if unknown or not all(_is_fixed(way, n) for n in pulling):
        raise UnsolvedError("other forces than the tension change, too")
    found, speed, before = way.book.fresh("W"), way.rate("v", k), way.first_speeds.get(k, NIL)
    gained = (row.inertia.coefficient(f"q{k}") * (speed * speed - before * before)).scaled(0.5).expression()
    rest = (steady * way.rate("s", k)).expression() + summed(_given_off(way, n) for n in pulling)
    step, who = way.book.begin_step("work"), way.setting.display_name(body)
    law = step.law(found + rest, gained)
    said = f"The work of all forces on {who} is its kinetic energy: {law}, so"
    step.add_text(f"{said} {step.result(found, gained - rest, JOULES)}.")
    step.close()
    return found


def _is_fixed(way: StraightMotion, number: int) -> bool:
    """Return whether a spring is fixed at one end."""
    return any(way.mechanism.site[site].body is None for site in way.mechanism.lines[number].through)


def _given_off(way: StraightMotion, number: int) -> Expression:
    """Return the energy that a spring has given off, J."""
    line = way.mechanism.lines[number].name
    strain, growth = way.spring("strain", line).expression(), way.growth("s", line).expression()
    return HALF * way.spring("stiffness", line).expression() * (sum_of_squares([strain]) - Power(strain + growth, 2))
