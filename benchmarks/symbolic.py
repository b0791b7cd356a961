r"""Symbolic problems and their grader: ``python benchmarks/symbolic.py [ITEMS] [SEED] [RECIPE,RECIPE]``.

Of each: the prompt, read back with fresh numbers, must lead by simulation to what the formula says, to 1e-6; the
formula and rewritings of it must be paid; and so must none of 20 formulas that differ from it. What differs, a reader
of its own tells here, that shares nothing with the grader.
"""

import ast
import operator
import re
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from math import acos, asin, atan, cos, exp, isfinite, log, pi, sin, sqrt, tan
from typing import Any

import numpy as np
import sympy

from sim2reason.datasets.grade import grade
from sim2reason.errors import TextError
from sim2reason.generation.item import FormulaRecord, Item
from sim2reason.generation.make import make
from sim2reason.generation.recipes import RECIPES
from sim2reason.generation.request import Request
from sim2reason.questions.difficulty import DIFFICULTIES
from sim2reason.questions.prompt import parse_prompt
from sim2reason.text.prose.description import stated_value

MUTANTS, FRESH = 20, 2
WIDTH = 0.05  # of the numbers that are put in when a prompt is read back
CLOSE, SAME = 1e-6, 1e-9
LONGEST = 1000  # characters that the grader reads
FUNCTIONS = {
    "arcsin": asin,
    "arccos": acos,
    "arctan": atan,
    "sin": sin,
    "cos": cos,
    "tan": tan,
    "sqrt": sqrt,
    "ln": log,
    "exp": exp,
    "abs": abs,
}
TERMS: dict[str, Any] = {
    "arcsin": sympy.asin,
    "arccos": sympy.acos,
    "arctan": sympy.atan,
    "sin": sympy.sin,
    "cos": sympy.cos,
    "tan": sympy.tan,
    "sqrt": sympy.sqrt,
    "ln": sympy.log,
    "exp": sympy.exp,
    "abs": sympy.Abs,
}
ANGULAR = "arcsin|arccos|arctan|sin|cos|tan|ln"
RAISED = re.compile(rf"\b({ANGULAR}) *\^ *\{{ *(\d+) *\}} *\(")
TOKEN = re.compile(rf"\d+\.?\d*(?:e[-+]?\d+)?|s\d+_|{'|'.join(FUNCTIONS)}|pi|\*\*|[-+*/()]")
OPERATIONS: dict[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
}
BARE = r"(?<![A-Za-z\\])"  # before a symbol that is a letter
DEEPER = {"{": 1, r"\left": 1, "}": -1, r"\right": -1}  # bars, too, have a left and a right one
FRACTION = re.compile(r"\\[td]?frac\{")


def inside(text: str, at: int, pair: str = "{}") -> int:
    """The place after the brace that closes the one before `at`."""
    depth = 1
    while depth:
        depth += {pair[0]: 1, pair[1]: -1}.get(text[at], 0)
        at += 1
    return at


def program(latex: str, names: Mapping[str, str]) -> str:
    """A formula of ours as Python has it, with `names` for its symbols."""
    while found := FRACTION.search(latex):
        middle = inside(latex, found.end())
        end = inside(latex, middle + 1)
        above, below = latex[found.end() : middle - 1], latex[middle + 1 : end - 1]
        latex = f"{latex[: found.start()]}\\left(\\left({above}\\right)/\\left({below}\\right)\\right){latex[end:]}"
    while (at := latex.find(r"\sqrt{")) >= 0:
        end = inside(latex, at + 6)
        latex = f"{latex[:at]}\\ROOT\\left({latex[at + 6 : end - 1]}\\right){latex[end:]}"
    longest = sorted(names, key=len, reverse=True)
    each = (rf"{'' if s.startswith(chr(92)) else BARE}{re.escape(s)}(?![A-Za-z])" for s in longest)
    latex = re.sub(
        "|".join(each), lambda found: f" {names[found.group()]} ", latex
    )  # at once: a name may hold a symbol
    latex = latex.replace(r"\left|", r"\abs\left(").replace(r"\right|", r"\right)")
    latex = latex.replace(r"\left", " ").replace(r"\right", " ").replace(r"\,", " ").replace(r"\cdot", "*")
    latex = latex.replace(r"\ROOT", "sqrt").replace("\\", " ")
    latex = re.sub(rf"\b({ANGULAR}) *\^ *\{{ *(\d+) *\}} *(s\d+_)", r"(\1(\3)**\2)", latex)
    latex = re.sub(rf"\b({ANGULAR}) +(s\d+_)", r"\1(\2)", latex)
    while raised := RAISED.search(latex):
        end = inside(latex, raised.end(), "()")
        argument = latex[raised.end() : end - 1]
        latex = f"{latex[: raised.start()]}({raised[1]}({argument})**{raised[2]}){latex[end:]}"
    latex = re.sub(r"\^ *\{ *(\d+) *\}", r"**\1", latex)
    tokens = TOKEN.findall(latex)
    said = ""
    for before, token in zip(["+", *tokens], tokens, strict=False):
        ends = before in {")", "pi"} or before[0].isdigit() or before.endswith("_")
        begins = token == "(" or token[0].isdigit() or token[0].isalpha()
        said += ("*" if ends and begins else "") + token
    return said


def computed(node: ast.expr, at: Mapping[str, Any], functions: Mapping[str, Any], number: Callable[[Any], Any]) -> Any:  # noqa: ANN401
    """What an expression of Python comes to, in floats or in sympy's terms."""
    match node:
        case ast.Constant(value=int() | float() as told):
            return number(told)
        case ast.Name(id=name):
            return at[name]
        case ast.UnaryOp(op=ast.USub(), operand=inner):
            return -computed(inner, at, functions, number)
        case ast.UnaryOp(op=ast.UAdd(), operand=inner):
            return computed(inner, at, functions, number)
        case ast.BinOp(left=left, op=operation, right=right):
            sides = (computed(side, at, functions, number) for side in (left, right))
            return OPERATIONS[type(operation)](*sides)
        case ast.Call(func=ast.Name(id=name), args=[inner]):
            return functions[name](computed(inner, at, functions, number))
        case _:
            raise ValueError(ast.dump(node))


def value(latex: str, at: Mapping[str, float]) -> float | None:
    """The value of a formula of ours; None where it has none."""
    names = {symbol: f"s{number}_" for number, symbol in enumerate(at)}
    try:
        tree = ast.parse(program(latex, names), mode="eval").body
        found = computed(tree, {"pi": pi, **{names[s]: number for s, number in at.items()}}, FUNCTIONS, float)
    except (ValueError, ZeroDivisionError, OverflowError):
        return None
    return float(found) if isfinite(found) else None


def terms(latex: str) -> list[tuple[int, int]]:
    """Where the terms of sums are, at any depth, each with the sign before it."""
    signs = [at for at, letter in enumerate(latex) if letter in "+-"]
    found: list[tuple[int, int]] = []
    for at in signs:
        depth, end = 0, at + 1
        while end < len(latex) and depth >= 0 and (depth or latex[end] not in "+-"):
            depth += next((by for token, by in DEEPER.items() if latex.startswith(token, end)), 0)
            end += 1
        found.append((at, end - (depth < 0)))
    return found


def mutated(formula: FormulaRecord, rng: np.random.Generator) -> str:  # noqa: PLR0911 - one for each way
    """A formula with one thing changed."""
    latex, symbols = formula.latex, list(formula.symbols)
    one, other = (symbols[int(rng.integers(len(symbols)))] for _ in range(2))
    places = [m.span() for m in re.finditer(r"(?<![\d_{.])\d+(?![\d.])", latex)]
    alone = "" if one.startswith("\\") else r"(?<![A-Za-z\\_,])(?<!_\{)"  # no subscript of another
    heard = [m.span() for m in re.finditer(rf"{alone}{re.escape(one)}(?![A-Za-z_\d])", latex)]
    signs, ends = [at for at, letter in enumerate(latex) if letter in "+-"], terms(latex)
    shift = 1.0 + float(rng.choice([-1.0, 1.0])) * float(rng.uniform(0.02, 0.3))
    match int(rng.integers(8)):
        case 0 if places:
            begin, end = places[int(rng.integers(len(places)))]
            return f"{latex[:begin]}{int(latex[begin:end]) * shift:.6f}{latex[end:]}"
        case 1 if signs:
            at = signs[int(rng.integers(len(signs)))]
            return latex[:at] + ("-" if latex[at] == "+" else "+") + latex[at + 1 :]
        case 2 if heard:
            begin, end = heard[int(rng.integers(len(heard)))]
            return f"{latex[:begin]} {other}{latex[end:]}"
        case 3 if ends:
            begin, end = ends[int(rng.integers(len(ends)))]
            return f"{latex[:begin]} + 0 {latex[end:]}"
        case 4:
            return rf"{one} \left({latex}\right)"
        case 5:
            return rf"\left({latex}\right) + {shift - 1.0:.4f} \cdot {one}"
        case 6:
            return f"{formula.bindings[0].answer:.12g}" if rng.random() < 0.5 else str(int(rng.integers(10)))
        case _:
            return rf"{shift:.6f} \left({latex}\right)"


def mutants(formula: FormulaRecord, rng: np.random.Generator) -> list[str]:
    """As many as are wanted that are not the formula, as its values at other numbers than the grader's tell."""
    found: dict[str, None] = {}
    points = [{s: x * float(rng.uniform(0.9, 1.1)) for s, x in point.items()} for point in formula.points[:3]]
    truth = [value(formula.latex, point) for point in points]
    for _ in range(50 * MUTANTS):
        text = mutated(formula, rng)
        pairs = [(a, value(text, point)) for a, point in zip(truth, points, strict=True) if a]
        if any(b is None or abs(b - a) > 1e-5 * abs(a) for a, b in pairs):
            found.setdefault(text)
        if len(found) == MUTANTS:
            break
    return list(found)


def rewritings(formula: FormulaRecord) -> Iterator[str]:
    """The same formula as others would write it."""
    latex = formula.latex
    yield latex.replace(r"\frac", r"\dfrac").replace(r"\left(", "(").replace(r"\right)", ")")
    yield f"x = {latex}"
    values = {name: [point[name] for point in formula.points] for name in formula.symbols}
    symbols = {name: sympy.Symbol(name, real=True, positive=min(values[name]) > 0.0 or None) for name in values}
    names = {name: f"s{number}_" for number, name in enumerate(formula.symbols)}
    tree = ast.parse(program(latex, names), mode="eval").body
    held = computed(tree, {"pi": sympy.pi, **{names[s]: symbols[s] for s in symbols}}, TERMS, sympy.nsimplify)
    for form in (sympy.expand, sympy.together):
        text = sympy.latex(form(held)).replace(r"\left|{", r"\left|").replace(r"}\right|", r"\right|")
        if len(text) < LONGEST:
            yield text


def read_back(item: Item, rng: np.random.Generator) -> str:
    """What is wrong with the prompt, read with fresh numbers; empty if nothing is."""
    formula = item.answer.formula
    assert formula is not None
    done = 0
    for _ in range(6 * FRESH):
        point = {s: x * float(np.exp(rng.uniform(-WIDTH, WIDTH))) for s, x in formula.points[0].items()}
        given = {s: stated_value(x, unit) for (s, x), unit in zip(point.items(), formula.units, strict=True)}
        try:
            found = parse_prompt(item.prompt, given=given)
        except TextError as error:
            if "can not be" in str(error):
                continue
            return f"not read: {error}"
        answer, expected = found.answer, value(formula.latex, point)
        factor = np.pi / 180.0 if item.answer.unit == "deg" else 1.0
        if answer is None or expected is None:
            continue  # other numbers, another course of things, in which what is asked about does not come
        if abs(answer * factor - expected) > CLOSE * abs(expected):
            return f"{answer * factor} by simulation, {expected} by the formula, with {given}"
        done += 1
        if done == FRESH:
            return ""
    return "" if done else "no fresh numbers have an answer"


def main(items: int = 500, seed: int = 1, recipes: str = "") -> int:
    """Print the figures; exit code 1 if anything is wrong."""
    names = recipes.split(",") if recipes else list(RECIPES)
    rng, count, spent = np.random.default_rng(seed), Counter[str](), Counter[str]()
    made, position, faults = Counter[str](), 0, 0
    idle = set[str]()
    while made.total() < items and len(idle) < len(names) and position < 20 * items:
        recipe = names[position % len(names)]
        turn = position // len(names)
        position += 1
        if recipe in idle:
            continue
        begin = time.process_time()
        item = make(Request(recipe, DIFFICULTIES[turn % 3], "symbolic", seed, turn)).item
        spent[recipe] += time.process_time() - begin
        if item is None:
            idle |= {recipe} if turn >= 2 and not made[recipe] else set()
            continue
        made[recipe] += 1
        formula = item.answer.formula
        assert formula is not None
        for name, text, wanted in (
            *(("reference", text, "correct") for text in [formula.latex]),
            *(("rewriting", text, "correct") for text in rewritings(formula)),
            *(("mutant", text, "not") for text in mutants(formula, rng)),
        ):
            score = grade(item, rf"\boxed{{{text}}}")
            count[name] += 1
            if (score.outcome == "correct") != (wanted == "correct"):
                faults += 1
                print(f"{item.id}: {name} {text!r} for {formula.latex!r}: {score}")
        if wrong := read_back(item, rng):
            faults += 1
            print(f"{item.id}: {wrong}\n    {item.prompt}\n    {formula.latex}")
    for recipe in names:
        print(f"{recipe:16} {made[recipe]:4} items, {made[recipe] / max(spent[recipe], SAME):.2f} a CPU-second")
    print(f"{made.total()} items; {dict(count)}; {faults} faults")
    with_forms = [recipe for recipe in names if made[recipe]]
    total = sum(spent[recipe] for recipe in with_forms)
    print(
        f"{sum(made[r] for r in with_forms) / max(total, SAME):.2f} items a CPU-second over {len(with_forms)} recipes"
    )
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:3]), *sys.argv[3:]))
