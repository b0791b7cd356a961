"""The maker of items: a pure function of recipe, difficulty, mode, seed and index."""

import hashlib
import json

from pydantic import JsonValue

from sim2reason.datasets import item_search, question_search
from sim2reason.datasets.distractors import distractors, idle_numbers, idle_parts
from sim2reason.datasets.in_units import told_in
from sim2reason.datasets.item import Answer, Binding, FormulaRecord, Item, Provenance, QueryRecord
from sim2reason.datasets.item_search import ItemSearch
from sim2reason.datasets.plan import Made, versions
from sim2reason.datasets.question_search import CertifiedQuestion
from sim2reason.datasets.request import Request
from sim2reason.datasets.worked_solutions import recorded, worked
from sim2reason.prose.description import Description
from sim2reason.questions import KINDS, Formula
from sim2reason.questions.spoken_units import system_named
from sim2reason.scene_files import Wording, dump
from sim2reason.simulation.certify import Certificate

SETTINGS = hashlib.sha256(json.dumps([*item_search.SETTINGS, *question_search.SETTINGS]).encode()).hexdigest()[:16]


def make(request: Request) -> Made:
    """Draw scenes and questions until one passes every filter; UnknownNameError for a name that is not known."""
    search = ItemSearch(request)
    found = search.found()
    item = item_of(request, found) if found is not None else None
    return Made(item, dict(search.rejected), search.wanted)


def item_of(request: Request, found: CertifiedQuestion) -> Item:
    """The record of a question that passed."""
    scene = found.description.scene
    question = found.question
    solution, unsolved = recorded(worked(request, found)) if request.solutions else (None, "")
    item = Item(
        id=request.id,
        prompt=found.prompt,
        shape=found.shape,
        answer=answer_of(found),
        mode=request.mode,
        kind=question.query.kind,
        recipe=request.recipe,
        difficulty=request.difficulty,
        entities=tuple(type(named.entity).__name__ for named in scene.entities),
        asked=_query_of(found),
        distractors=distractors(found.candidate, found.description),
        idle=idle_parts(found.candidate, found.description),
        idle_numbers=idle_numbers(found.candidate, found.description),
        solution=solution,
        unsolved=unsolved,
        scene=dump(found.study.scene, _wording_of(found.description)),
        certificate=summary(found.certificate),
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
        ),
    )
    return told_in(system_named(request.units), item)


def _wording_of(description: Description) -> Wording:
    """How the text tells its scene, so that a figure from its file alone agrees with it."""
    symbols = tuple(path for path in description.told if path in description.symbols)
    return Wording(description.seed, symbols, tuple(sorted(description.without)))


def answer_of(found: CertifiedQuestion) -> Answer:
    """The record of its answer."""
    question, tolerance = found.question, found.candidate.tolerance
    formula = _formula_of(question.formula) if question.formula is not None else None
    return Answer(value=question.answer, unit=question.unit, sign=question.sign, tolerance=tolerance, formula=formula)


def _formula_of(formula: Formula) -> FormulaRecord:
    pairs = zip(formula.points, formula.values, strict=True)
    bindings = tuple(Binding(numbers=numbers, answer=answer) for numbers, answer in pairs)
    return FormulaRecord(latex=formula.latex, symbols=formula.symbols, units=formula.units, bindings=bindings)


def _query_of(found: CertifiedQuestion) -> QueryRecord:
    """The record of what is asked."""
    query, given = found.question.query, found.question.given
    kind = KINDS[query.kind]
    return QueryRecord(
        subject=query.subject,
        quantity=kind.measured(query).name,
        time=kind.time(query, found.study),
        event=query.moment.label if query.moment is not None else None,
        unknown=found.question.unknown or None,
        limit_of=query.hides or None,
        given=given.value if given is not None else None,
        given_unit=given.unit if given is not None else None,
    )


def summary(certificate: Certificate) -> dict[str, JsonValue]:
    """What an item says of its certificate: the worst difference, the tolerance, until when, by whom."""
    worst = max(certificate.agreement.values(), default=0.0)
    return {
        "engines": list(certificate.engines),
        "tolerance": certificate.tolerance,
        "worst": worst,
        "stable_until": certificate.stable_until,
        "events": len(certificate.matched),
    }
