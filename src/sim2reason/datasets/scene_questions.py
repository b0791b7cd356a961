"""Questions about a given scene: items and worked solutions."""

from collections import Counter
from collections.abc import Hashable, Mapping
from dataclasses import dataclass, field
from itertools import islice
from typing import NamedTuple

from sim2reason.base.records import abridge
from sim2reason.datasets.plan import Names, find_modes
from sim2reason.errors import DrawError, SceneError, TextError
from sim2reason.generation.certified import CertifiedQuestion, worked_solution
from sim2reason.generation.item import Item
from sim2reason.generation.item_search import ItemSearch, form_problem, generator
from sim2reason.generation.make import build_item
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.generation.request import Request
from sim2reason.generation.splits import problem
from sim2reason.questions import MODES, Question, StatedResult, Target, Words
from sim2reason.questions.following import SimulatedAnswer, simulate_scene, simulate_until_answer, simulate_until_event
from sim2reason.questions.kinds.threshold import ThresholdQuery
from sim2reason.questions.moments.times import WholeMotion
from sim2reason.questions.ordinary.understanding import suggest_rewording, understand_sentence
from sim2reason.questions.posing import VALUE, PosedQuestion, pose_question
from sim2reason.questions.query import targets
from sim2reason.questions.sentences import parse_question
from sim2reason.questions.spoken_units import system_named
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.questions.unknown import with_number
from sim2reason.scenes.dsl.measures import join_unit
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import SceneLike, as_scene, given_scene, read_question
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.trace import ending
from sim2reason.solutions import ProblemContext, Solution
from sim2reason.solutions import solve as solved
from sim2reason.solutions.goals import GOALS

DEFAULT_QUESTIONS = 5
TRIES_PER_QUESTION = 10  # per requested question, and again for easy ones
SAME_ANSWER = "an answer that another question has"  # name of this rejection in counts
MAX_ITEM_FACTOR = 2  # times the requested questions, including variants, after which the search ends


@dataclass
class AskedScene:
    """The text of a scene, and the items of its questions that passed every filter."""

    text: str
    found: dict[str, tuple[CertifiedQuestion, Item]] = field(default_factory=dict[str, tuple[CertifiedQuestion, Item]])
    """The questions that passed, by their text, each with its item."""
    refused: Counter[str] = field(default_factory=Counter[str])
    """The number of questions refused by each filter."""
    reason: str = ""
    """The reason why no question can be asked about the scene, as a clause; empty where none is known."""


def ask(
    scene: SceneLike,
    *,
    mode: Names = "numeric",
    items: int = DEFAULT_QUESTIONS,
    seed: int = 0,
    all: bool = False,  # noqa: A002 - as the option is called
) -> list[Item]:
    """Ask questions about a scene.

    No two of the problems have the same answer. Easy problems, which take few laws to solve, are only asked if there
    are too few others.

    Args:
        scene: A scene, the path of its file, its YAML text, an item about it, or the result of `parse_scene`.
        mode: Modes of questions, which take turns: one name, several, or ``all``.
        items: Greatest number of problems.
        seed: Seed of the questions and of their wording.
        all: Whether to keep problems that a filter rejects, such as easy, odd or uncertain ones.

    Returns:
        Items as in a dataset, but without a recipe and a difficulty; possibly fewer than `items`.

    Raises:
        TypeError: `scene` is of another type.
        UnknownNameError: There is no such mode.
        SceneError, UnsupportedError, SimulationError: The scene cannot be built, modelled or solved.

    Examples:
        >>> import sim2reason
        >>> scene = sim2reason.sample("incline", "easy")
        >>> problems = sim2reason.ask(scene, items=2)
        >>> [problem.id for problem in problems]
        ['scene-numeric-0-...', 'scene-numeric-0-...']
    """
    return [item for _, item in ask_scene(as_scene(scene, "ask"), mode, items, seed, unfiltered=all).found.values()]


def ask_scene(scene: Scene, mode: Names, items: int, seed: int, *, unfiltered: bool = False) -> AskedScene:
    """Return the items and text of a scene with the counts of rejections; modes alternate.

    A problem that differs only in its numbers is repeated only if there are too few others.
    """
    modes = find_modes(mode)
    search = QuestionSearch(simulate_until_event(simulate_scene(scene)).study, seed, unfiltered=unfiltered)
    result = AskedScene(search.description.text)
    problems, variants = set[str](), dict[str, tuple[CertifiedQuestion, Item]]()
    answers = set[Hashable]()
    for attempt in range(2 * TRIES_PER_QUESTION * items):
        if len(result.found) >= items or len(result.found) + len(variants) >= MAX_ITEM_FACTOR * items:
            break
        search.easy = attempt >= TRIES_PER_QUESTION * items
        name = modes[attempt % len(modes)]
        rng, base = generator("ask", name, seed, attempt), f"{scene.name}-{name}-{seed}"
        certified = search.ask(MODES[name], rng, result.refused)
        if certified is not None:
            certified = form_problem(certified, search, MODES[name], "medium", rng, result.refused, f"{base}-{attempt}")
        if certified is not None and certified.question.text not in result.found:
            item = build_item(Request("", "", name, seed, attempt), certified)
            answer = _answer(certified.question, item)
            if answer in answers:
                result.refused[SAME_ANSWER] += 1
                continue
            answers.add(answer)
            named = item.model_copy(update={"id": f"{base}-{attempt}"})
            kept = variants if problem(named) in problems else result.found
            kept[certified.question.text] = certified, named
            problems.add(problem(named))
    if search.is_unstable:
        unit = scene.units.time
        result.reason = f"the motion ends at {search.study.trace.stable_until:.3g} {unit}: {ending(search.study.trace)}"
    result.found.update(islice(variants.items(), items - len(result.found)))
    return result


def _answer(question: Question, item: Item) -> Hashable:
    """Return a key, usually the answer, that no two questions about a scene may share.

    For an unknown number the key includes its address. If the scene's own value is the answer, as for the mass that
    gives a stated speed, the key is the query.
    """
    if not question.unknown:
        return item.answer.shown
    threshold = isinstance(question.query, ThresholdQuery)
    return question.unknown, item.answer.shown if threshold else question.query


SOLVE_TRIES = 20


class SolvedProblem(NamedTuple):
    """A problem with its worked solution, and its answer from the simulated motion.

    Attributes:
        problem: Text of the problem.
        solution: The worked solution; its `answer` is None if there is none.
        answer: Answer from the motion, in `unit`; None if the motion has no answer.
        unit: Unit of the answer; empty for a pure number.
        reason: Why there is no worked solution, or no answer at all; empty if there is one.
        read_as: Question of the library that a question in ordinary English was read as; empty for any other.
        over: Duration over which a greatest or least value is taken, if the question names no moment.
    """

    problem: str
    solution: Solution
    answer: float | None
    unit: str
    reason: str = ""
    read_as: str = ""
    over: str = ""

    def __repr__(self) -> str:
        """Return the answer and the strategy of the solution, or the reason why one of them is missing."""
        answer = "none" if self.answer is None else join_unit(f"{self.answer:.6g}", self.unit)
        how = f"by {self.solution.strategy}" if self.solution.answer is not None else abridge(self.reason, 100)
        return f"<SolvedProblem: answer {answer}, {how}>"

    def __str__(self) -> str:
        """Return the problem and its solution; without a solution, the reason and the answer from the motion."""
        parts = [self.problem, str(self.solution)]
        if self.answer is not None and self.solution.answer is None:
            parts.append(f"Answer from the motion: {join_unit(f'{self.answer:.6g}', self.unit)}")
        return "\n\n".join(parts)


def solve(  # noqa: PLR0913 - the parts of a question, by name
    scene: SceneLike | None = None,
    *,
    id: str | None = None,  # noqa: A002 - the column's name
    question: str | Mapping[str, object] | None = None,
    find: str = "",
    of: str = "",
    when: str = "",
    along: str = "",
    given: str = "",
    change: str = "",
    compare: str = "",
    seed: int = 0,
) -> SolvedProblem:
    r"""Solve a question about a scene, or a problem, in steps.

    Give either a `scene`, with a question in words or in parts, or an `id`. Without a question, that in the scene's
    file is taken, or one is drawn.

    Args:
        scene: A scene, the path of its file, its YAML text, the result of `parse_scene`, or an item, which is made
            again and solved.
        id: The id of a problem, which is made again from it.
        question: A question in the words of the library or in ordinary English, or a mapping with the parts below.
        find: What to find: a quantity, ``time``, or the address of a number.
        of: The subject, by its name in the text or its address.
        when: A time, a moment, or ``QUANTITY = VALUE``.
        along: The component: an axis, or the direction that counts as positive.
        given: ``QUANTITY = VALUE``, which the number to find must bring about.
        change: A change to the scene whose effect is to be found, such as ``ADDRESS = VALUE`` or ``ADDRESS × 2``.
        compare: How to give a changed answer: ``ratio``, ``difference`` or ``value``.
        seed: Seed of the wording, and of a question that is drawn.

    Returns:
        The problem with its solution and its answer from the motion.

    Raises:
        TypeError: `scene` is of another type.
        SceneError: Both a scene and an id are given, or neither, or there is nothing to ask about the scene.
        TextError: The question is not understood.
        DrawError: The id is invalid, or there is no such problem.

    Examples:
        >>> import sim2reason
        >>> scene = sim2reason.parse_scene("A 2 kg block is released from rest on a frictionless 30-degree incline.")
        >>> solved = sim2reason.solve(scene, question="How fast is the block after 2 s?")
        >>> solved
        <SolvedProblem: answer 9.8 m/s, by constant acceleration>
        >>> print(solved.solution)
        Given: ...
        <BLANKLINE>
        ...
        Answer: $v \approx \boxed{9.80}\ \text{m/s}$.
    """
    if (scene is None) == (id is None):
        raise SceneError("solve", "it takes a scene or an id", "give one of the two")
    parts = {"find": find, "of": of, "when": when, "along": along, "given": given, "change": change}
    given_parts = {name: part for name, part in parts.items() if part}
    if given_parts and question is not None:
        raise SceneError("question", "it is there twice, as a whole and in parts", "give one of the two")
    asked = {**given_parts, "compare": compare} if given_parts else question
    if scene is not None and not isinstance(scene, Item):
        loaded, text = given_scene(scene, "solve")
        asked = read_question(text) if asked is None and text else asked
        return _of_structured(loaded, asked, seed) if isinstance(asked, Mapping) else _of_scene(loaded, asked, seed)
    if asked is not None:
        raise SceneError("question", "the problem of an item or id has its own", "give a scene instead")
    return _of_request(Request.of(scene) if scene is not None else Request.named(str(id)))


def _of_request(request: Request) -> SolvedProblem:
    name = request.id
    system_named(request.units)
    certified = ItemSearch(request).find()
    if certified is None:
        raise DrawError(f"{name}: no draw passed the filters, so that there is no such problem; take another index")
    item, solution = build_item(request, certified), worked_solution(request, certified)
    return SolvedProblem(item.prompt, solution, item.answer.value, item.answer.unit, solution.reason)


def _of_scene(scene: Scene, question: str | None, seed: int) -> SolvedProblem:
    """Return the solved problem of a question about a scene, in words; a random question if none is given."""
    motion = simulate_scene(scene)
    search = QuestionSearch(simulate_until_event(motion).study, seed)
    if question is None:
        draws = (search.ask(MODES["numeric"], generator("solve", seed, n), Counter[str]()) for n in range(SOLVE_TRIES))
        drawn = next((draw for draw in draws if draw is not None), None)
        if drawn is None:
            raise SceneError(scene.name, "no question about it passes the filters", "give one, by --question")
        query, question = drawn.question.query, drawn.question.text
    else:
        query = parse_question(question, search.study, search.words)
    problem = f"{search.description.text} {question}"
    if query is not None:
        return _answered(problem, search, PosedQuestion(query), simulate_until_answer(query, motion))
    interpretation = understand_sentence(question, motion, search.words)
    if interpretation is None:
        raise TextError(
            "question", f"{question!r} is not understood", suggest_rewording(question, motion, search.words)
        )
    read_as = interpretation.posed_question.sentence(search.words) or interpretation.asked.options
    return _answered(problem, search, interpretation.posed_question, interpretation.simulated_answer)._replace(
        read_as=read_as
    )


def _of_structured(scene: Scene, parts: Mapping[str, object], seed: int) -> SolvedProblem:
    """Return the solved problem of a structured question, rendered as a sentence if possible."""
    motion = simulate_scene(scene)
    search = QuestionSearch(motion.study, seed)
    asked = StructuredQuestion.read(parts)
    question = pose_question(asked, motion, search.words)
    problem = f"{search.description.text} {question.sentence(search.words) or asked.text}"
    return _answered(problem, search, question, question.simulate_answer(motion))


def _answered(
    problem: str, search: QuestionSearch, question: PosedQuestion, simulated: SimulatedAnswer
) -> SolvedProblem:
    """Return a question's answer from the motion, with a worked solution if there is one."""
    unit = question.unit(search.words)
    if simulated.answer is None:
        return SolvedProblem(problem, Solution("", reason=simulated.reason), None, unit, simulated.reason)
    target, moment = question.query.target, question.query.moment
    over = moment.told(simulated.study.trace) if isinstance(moment, WholeMotion) else ""
    compared = question.compare != VALUE or question.varied is not None
    if compared or (target is not None and target not in targets(search.words) and not _only_in_parts(target)):
        unsaid = Solution("", reason="no sentence of the library asks this")
        return SolvedProblem(problem, unsaid, simulated.answer, unit, unsaid.reason, over=over)
    symbols, study, unknown = search.description.symbols, simulated.study, question.unknown
    if unknown is None:
        setting = ProblemContext(study.scene, search.words, symbols, study, question.query)
    else:
        study = simulate_until_answer(
            question.query, simulate_scene(with_number(study.scene, unknown.path, simulated.answer))
        ).study
        stated = StatedResult(f"{question.given:.15g}", question.given_unit(search.words))
        words = Words.of(study.scene, search.words.mentions, {unknown.path: unknown.symbol}, search.words.symbols)
        setting = ProblemContext(study.scene, words, symbols, study, question.query, unknown.path, stated)
    solution = solved(setting)
    return SolvedProblem(problem, solution, simulated.answer, unit, solution.reason, over=over)


def _only_in_parts(target: Target) -> bool:
    """Return whether a quantity can be solved for, but has no name in sentences, such as a height above ground.

    The magnitude and the components of other quantities have words, unless these would not tell them apart.
    """
    asked = QUANTITIES[target.quantity]
    return target.quantity in GOALS and not (asked.magnitude or asked.signed)
