"""Maker of items: a pure function of recipe, difficulty, mode, seed and index."""

import hashlib
import json
from collections.abc import Callable, Sequence
from dataclasses import replace

from pydantic import JsonValue

from sim2reason.generation import item_search, part_search, question_search
from sim2reason.generation.certified import CertifiedQuestion, part_solutions, solution_record, worked_solution
from sim2reason.generation.filters import Candidate
from sim2reason.generation.item import (
    Answer,
    Binding,
    Distractor,
    FormulaRecord,
    Item,
    MeasuredDifficulty,
    Provenance,
    QueryRecord,
    QuestionPart,
)
from sim2reason.generation.item_search import ItemSearch
from sim2reason.generation.options import distractors, idle_numbers, idle_parts, values
from sim2reason.generation.request import Made, Request, versions
from sim2reason.questions import KINDS, Formula
from sim2reason.questions.difficulty import most_advanced
from sim2reason.questions.kinds.nested import WhichKind, WhichQuery
from sim2reason.questions.prompt import unit_in_words, without_form
from sim2reason.questions.prompt_formats import LETTERS, ChoicePrompt, PartPrompt, format_options
from sim2reason.questions.spoken_units import SpokenUnits, spoken_in, system_named
from sim2reason.scenes.files import Wording, dump
from sim2reason.simulation.certify import Certificate
from sim2reason.solutions.difficulty import SolutionDifficulty
from sim2reason.text.prose.description import Description, formula_unit


def in_units(system: SpokenUnits, item: Item) -> Item:
    """Return an item with all numbers in its text, answer and distractors converted to a system of units.

    Symbolic problems are unchanged, because their formulas hold in any units.
    """
    if item.answer.formula is not None:
        return item
    answers = item.answer.parts or (item.answer,)
    system = system.suited_to(item.prompt, *((answer.value, answer.unit) for answer in answers))
    if item.parts:
        return _parts_told_in(system, item)
    if item.answer.letter:
        return _options_told_in(system, item)
    unit = system.spelled(item.answer.unit)[0]
    begin, unit_phrase, end = item.prompt.rpartition(f" in {unit_in_words(item.answer.unit)}")
    if unit_phrase and item.answer.unit and ". " not in end:  # the last sentence
        unit_phrase = f" in {unit_in_words(unit)}"
    return item.model_copy(
        update={
            "prompt": spoken_in(system, f"{begin}{unit_phrase}{end}"),
            "answer": _answer(system, item.answer),
            "distractors": tuple(_distractor(system, wrong, item.answer.unit) for wrong in item.distractors),
            "idle": tuple(spoken_in(system, part) for part in item.idle),
            "asked": _asked(system, item.asked),
        }
    )


def _options_told_in(system: SpokenUnits, item: Item) -> Item:
    """Return a multiple-choice item converted to a system of units; its options have the unit of the answer."""
    answer, prompt = _answer(system, item.answer), ChoicePrompt.read(item.prompt)
    question = spoken_in(system, prompt.question)
    return item.model_copy(
        update={
            "prompt": ChoicePrompt(question, answer.texts or format_options(answer.options, answer.unit)).text,
            "answer": answer,
            "distractors": tuple(_distractor(system, wrong, item.answer.unit) for wrong in item.distractors),
            "idle": tuple(spoken_in(system, part) for part in item.idle),
            "asked": _asked(system, item.asked),
        }
    )


def _parts_told_in(system: SpokenUnits, item: Item) -> Item:
    """Return a multipart item converted to a system of units, with the units of all answers in its last line."""
    units = [system.spelled(answer.unit)[0] for answer in item.answer.parts]
    prompt = PartPrompt.read(item.prompt)
    unit_names = tuple(unit_in_words(unit) if unit else old for unit, old in zip(units, prompt.units, strict=True))
    questions = tuple(spoken_in(system, question) for question in prompt.questions)
    parts = zip(item.parts, questions, item.answer.parts, strict=True)
    return item.model_copy(
        update={
            "prompt": replace(
                prompt, scene=spoken_in(system, prompt.scene), questions=questions, units=unit_names
            ).text,
            "answer": _answer(system, item.answer),
            "parts": tuple(_part(system, part, question, answer.unit) for part, question, answer in parts),
            "idle": tuple(spoken_in(system, part) for part in item.idle),
            "asked": _asked(system, item.asked),
        }
    )


def _part(system: SpokenUnits, part: QuestionPart, question: str, unit: str) -> QuestionPart:
    wrong = tuple(_distractor(system, each, unit) for each in part.distractors)
    return part.model_copy(update={"text": question, "distractors": wrong, "asked": _asked(system, part.asked)})


def _answer(system: SpokenUnits, answer: Answer) -> Answer:
    unit, factor = system.spelled(answer.unit)
    parts = tuple(_answer(system, part) for part in answer.parts)
    options = tuple(value * float(factor) for value in answer.options)
    texts = tuple(spoken_in(system, text) for text in answer.texts)
    changes = {"unit": unit, "value": answer.value * float(factor), "parts": parts, "options": options, "texts": texts}
    return answer.model_copy(update=changes)


def _distractor(system: SpokenUnits, wrong: Distractor, unit: str) -> Distractor:
    value = wrong.value * float(system.spelled(unit)[1])
    return wrong.model_copy(update={"value": value, "reason": spoken_in(system, wrong.reason)})


def _asked(system: SpokenUnits, query: QueryRecord) -> QueryRecord:
    if query.given is None or query.given_unit is None:
        return query
    unit, factor = system.spelled(query.given_unit)
    return query.model_copy(update={"given": query.given * float(factor), "given_unit": unit})


SETTINGS = hashlib.sha256(
    json.dumps([*item_search.SETTINGS, *question_search.SETTINGS, *part_search.SETTINGS]).encode()
).hexdigest()[:16]


def make(request: Request) -> Made:
    """Draw scenes and questions until one passes every filter; UnknownNameError for an unknown name."""
    search = ItemSearch(request)
    certified = search.find()
    item = build_item(request, certified) if certified is not None else None
    search.release()
    return Made(item, dict(search.rejected), search.first_kind)


def build_item(request: Request, certified: CertifiedQuestion) -> Item:
    """Return the item for a certified question."""
    scene = certified.description.scene
    question = certified.question
    solution, unsolved = solution_record(worked_solution(request, certified)) if request.solutions else (None, "")
    item = Item(
        id=request.id,
        prompt=certified.prompt,
        shape=certified.shape,
        answer=answer_record(certified),
        mode=request.mode,
        kind=question.query.kind,
        recipe=request.recipe,
        difficulty=request.difficulty,
        entities=tuple(type(named.entity).__name__ for named in scene.entities),
        asked=_query_record(certified),
        needs=_needs_of(certified),
        measured=_difficulty_of(certified.measured) if certified.measured is not None else None,
        parts=_parts_of(request, certified),
        distractors=_wrong_answers(certified),
        idle=_idle_in_all(certified, idle_parts),
        idle_numbers=_idle_in_all(certified, idle_numbers),
        solution=solution,
        unsolved=unsolved,
        scene=dump(certified.study.scene, _wording_of(certified.description)),
        certificate=summary(certified.certificate),
        provenance=Provenance(
            recipe=request.recipe,
            difficulty=request.difficulty,
            mode=request.mode,
            seed=request.seed,
            index=request.index,
            versions=versions(),
            settings=SETTINGS,
            weights=dict(request.weights),
            units=request.units,
            needs=request.needs,
        ),
    )
    return in_units(system_named(request.units), with_options(item, certified) if certified.options else item)


def with_options(item: Item, certified: CertifiedQuestion) -> Item:
    """Return a numeric item as a multiple-choice item, with the options of its certified question."""
    answer, body, chosen = item.answer, without_form(item.prompt)[0], certified.options
    numbers, letter = tuple(values(answer, chosen)), LETTERS[chosen.index(None)]
    texts = _names_and(numbers, answer.unit, certified)
    lettered_answer = answer.model_copy(update={"letter": letter, "options": numbers, "texts": texts})
    prompt = ChoicePrompt(body, texts or format_options(numbers, answer.unit)).text
    return item.model_copy(update={"prompt": prompt, "answer": lettered_answer})


def _names_and(numbers: Sequence[float], unit: str, certified: CertifiedQuestion) -> tuple[str, ...]:
    """Return the texts of options that each state a name and a number; empty if options are only numbers."""
    kind, query, words = certified.candidate.kind, certified.question.query, certified.candidate.words
    if not isinstance(kind, WhichKind) or not isinstance(query, WhichQuery) or words is None:
        return ()
    pairs = zip(format_options([abs(number) for number in numbers], unit), numbers, strict=True)
    return tuple(kind.option(query, words, size, first=number > 0.0) for size, number in pairs)


def _wrong_answers(certified: CertifiedQuestion) -> tuple[Distractor, ...]:
    """Return the distractors of a question: the wrong options if it has options, none for parts."""
    if certified.parts:
        return ()
    if certified.options:
        return tuple(wrong for wrong in certified.options if wrong is not None)
    return distractors(certified.candidate, certified.description)


def _parts_of(request: Request, certified: CertifiedQuestion) -> tuple[QuestionPart, ...]:
    """Return the records of the parts of a multi-part problem."""
    solutions = part_solutions(request, certified) if request.solutions else []
    records = [solution_record(solution) for solution in solutions] or [(None, "")] * len(certified.parts)
    return tuple(
        QuestionPart(
            text=part.text,
            kind=part.certified.question.query.kind,
            asked=_query_record(part.certified),
            uses=part.uses,
            distractors=distractors(part.certified.candidate, certified.description),
            solution=solution,
            unsolved=unsolved,
            certificate=summary(part.certified.certificate),
        )
        for part, (solution, unsolved) in zip(certified.parts, records, strict=True)
    )


def _idle_in_all(
    certified: CertifiedQuestion, idle: Callable[[Candidate, Description], tuple[str, ...]]
) -> tuple[str, ...]:
    """Return the names of parts or numbers of the scene that `idle` finds irrelevant for every part of the problem."""
    candidates = [part.certified.candidate for part in certified.parts] or [certified.candidate]
    each = [idle(candidate, certified.description) for candidate in candidates]
    return tuple(name for name in each[0] if all(name in others for others in each[1:]))


def _wording_of(description: Description) -> Wording:
    """Return the wording of the scene in the prompt, so that a figure from the scene file uses the same names."""
    return Wording(description.seed, description.symbolic, tuple(sorted(description.without)))


def answer_record(certified: CertifiedQuestion) -> Answer:
    """Return the record of the answer, or of the answers to all parts."""
    question, tolerance = certified.question, certified.candidate.tolerance
    formula = _formula_of(question.formula, question.unit) if question.formula is not None else None
    return Answer(
        value=question.answer,
        unit=question.unit,
        sign=question.sign,
        tolerance=tolerance,
        formula=formula,
        parts=tuple(answer_record(part.certified) for part in certified.parts),
    )


def _formula_of(formula: Formula, unit: str) -> FormulaRecord:
    """Return the record of a formula for an answer in `unit`."""
    pairs = zip(formula.points, formula.values, strict=True)
    return FormulaRecord(
        latex=formula.latex,
        symbols=formula.symbols,
        units=tuple(map(formula_unit, formula.units)),
        unit=formula_unit(unit),
        bindings=tuple(Binding(numbers=numbers, answer=answer) for numbers, answer in pairs),
    )


def _needs_of(certified: CertifiedQuestion) -> str:
    """Return the most advanced mathematics in the solution, over all parts."""
    parts = [part.certified for part in certified.parts] or [certified]
    return most_advanced(part.shortest.needs for part in parts).label


def _difficulty_of(taken: SolutionDifficulty) -> MeasuredDifficulty:
    return MeasuredDifficulty(laws=taken.laws, phases=taken.phases, unknowns=taken.unknowns, score=taken.score)


def _query_record(certified: CertifiedQuestion) -> QueryRecord:
    """Return the record of the query."""
    query, given = certified.question.query, certified.question.given
    kind = KINDS[query.kind]
    return QueryRecord(
        subject=query.subject,
        quantity=kind.measured(query).name,
        time=kind.time(query, certified.study),
        event=query.moment.label if query.moment is not None else None,
        unknown=certified.question.unknown or None,
        limit_of=query.hides or None,
        given=given.value if given is not None else None,
        given_unit=given.unit if given is not None else None,
    )


def summary(certificate: Certificate) -> dict[str, JsonValue]:
    """Return the certificate's data for an item: largest difference, tolerance, end time and engines."""
    worst = max(certificate.agreement.values(), default=0.0)
    return {
        "engines": list(certificate.engines),
        "tolerance": certificate.tolerance,
        "worst": worst,
        "stable_until": certificate.stable_until,
        "events": len(certificate.matched),
    }
