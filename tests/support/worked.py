"""Problems for tests of worked solutions: stored ones, sampled ones, and questions about plain scenes."""

import json
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import cast

from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.generation.item_search import generator
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.generation.recipes import RECIPES, find_difficulty
from sim2reason.questions import MODES, Formula, Query
from sim2reason.questions.prompt import ParsedPrompt, parse_prompt
from sim2reason.questions.prompt_formats import parse_parts
from sim2reason.questions.sentences import parse_question
from sim2reason.questions.words import spoken_of
from sim2reason.scenes.dsl.entity import Entity, Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.solutions import ProblemContext, Solution, solve
from sim2reason.solutions.multipart import sequential_solutions
from sim2reason.solutions.solution import combine_parts
from sim2reason.solutions.solve import setting_of
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import faults

PROBLEMS = Path(__file__).parents[1] / "data" / "problems.jsonl"
TRIES = 40
ANSWERED = ("start", "state", "event", "time_to_event")  # kinds that strategies have a way to


def _setting(search: QuestionSearch, query: Query) -> ProblemContext:
    study = search.study
    return ProblemContext(study.scene, search.words, search.description.symbols, study, query)


def solution_text(problem: str) -> str:
    """Solve a stored problem of tests/data/problems.jsonl and return the text of its worked solution."""
    settings = settings_of(problem)
    alone = [solve(setting) for setting in settings]
    found = combine_parts(sequential_solutions(settings, alone, whole=True)) if len(alone) > 1 else alone[0]
    assert found.answer is not None, found.reason
    return found.text


@cache
def settings_of(problem: str) -> tuple[ProblemContext, ...]:
    """Return the problem of each part of a stored problem.

    Stored prompts keep the problems the same when recipes change; multiple-choice ones have no options.
    """
    held = _stored()[problem]
    prompt, given = str(held["prompt"]), cast("dict[str, str]", held.get("given", {}))
    if given:
        return (_in_symbols(parse_prompt(prompt, given=given), given, str(held["formula"])),)
    return tuple(map(setting_of, parse_parts(prompt) if "\n(b) " in prompt else [parse_prompt(prompt)]))


@cache
def _stored() -> dict[str, dict[str, object]]:
    """Return the stored problems by id."""
    rows = [cast("dict[str, object]", json.loads(line)) for line in PROBLEMS.read_text("utf-8").splitlines()]
    return {str(row["id"]): row for row in rows}


def _in_symbols(parsed: ParsedPrompt, given: Mapping[str, str], formula: str) -> ProblemContext:
    """Return a question in symbols with the numbers in `given`, including the question's own, such as a time."""
    plain = setting_of(parsed)
    symbols = {path: symbol for path, symbol in plain.symbols.items() if symbol in given}
    others = {symbol: said for symbol, said in given.items() if symbol not in symbols.values()}
    own = [spoken_of(symbol, said, plain.words.units) for symbol, said in others.items()]
    words = replace(plain.words, symbols=symbols).in_symbols(dict(filter(None, own)))
    found = Formula(formula, tuple(given), tuple("" for _ in given), (), ())
    return replace(plain, words=words, symbols=symbols, formula=found, assumed=parsed.asked.assumed)


def asked(scene: Scene, question: str | Query) -> ProblemContext:
    """Return a problem about a scene, from a question in the library's words or a query."""
    search = QuestionSearch(scene, 0)
    query = question if isinstance(question, Query) else parse_question(question, search.study, search.words)
    assert query is not None, question
    return _setting(search, query)


def derived(scene: Scene, query: Query) -> Solution:
    """Return the derivation of an answer after checking it, its data and its text."""
    setting = asked(scene, query)
    found = solve(setting)
    assert found.answer is not None, found.reason
    assert found.derived, found.strategy
    assert setting.answer is not None
    assert not faults(found, setting.answer), found.text
    reading = read(found.text)
    assert not reading.unread
    assert not reading.broken, reading.broken
    return found


def answer(name: str, entity: Entity, query: Query) -> float:
    """Return the derived answer about a lone entity."""
    found = derived(Scene(entities=(Named(name=name, entity=entity),)), query)
    assert found.answer is not None
    return found.answer


def problems(
    recipe: str, difficulty: str, count: int, seed: int = 3, kinds: Sequence[str] = ANSWERED
) -> Iterator[ProblemContext]:
    """Yield sampled problems that pass every filter, with the answerable kinds in turn."""
    for index in range(count):
        found = _problem(recipe, difficulty, seed, index, kinds)
        if found is not None:
            yield found


def _problem(recipe: str, difficulty: str, seed: int, index: int, kinds: Sequence[str]) -> ProblemContext | None:
    for attempt in range(TRIES):
        rng = generator("worked", recipe, difficulty, seed, index, attempt)
        try:
            search = QuestionSearch(RECIPES[recipe](find_difficulty(difficulty), rng), int(rng.random() * 2**31))
            kind = kinds[index % len(kinds)]
            found = search.ask(MODES["numeric"], rng, Counter[str](), kind)
        except (SceneError, SimulationError, UnsupportedError):
            continue
        if found is not None:
            return _setting(search, found.question.query)
    return None
