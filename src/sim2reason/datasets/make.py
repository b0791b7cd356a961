"""The maker of items: a pure function of recipe, difficulty, mode, seed and index."""

import hashlib
import json
from collections import Counter

from pydantic import JsonValue

from sim2reason.datasets.distractors import distractors, idle_numbers, idle_parts
from sim2reason.datasets.item import Answer, Item, Provenance, QueryRecord
from sim2reason.datasets.plan import Made, Request, versions
from sim2reason.datasets.question_search import (
    QUESTIONS,
    SAMPLES,
    SHORTEST,
    CertifiedQuestion,
    QuestionSearch,
)
from sim2reason.datasets.random_scenes import generator
from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.questions import KINDS, MODES
from sim2reason.recipes import RECIPES, known
from sim2reason.scene_files import dump
from sim2reason.simulation.certify import Certificate

SCENES = 60  # scenes drawn for one item, at most
SETTINGS = hashlib.sha256(json.dumps([SCENES, QUESTIONS, SAMPLES, SHORTEST]).encode()).hexdigest()[:16]


def make(request: Request) -> Made:
    """Draw scenes and questions until one passes every filter; UnknownNameError for a name that is not known."""
    found, rejected = search(request)
    return Made(item_of(request, found) if found is not None else None, dict(rejected))


def search(request: Request) -> tuple[CertifiedQuestion | None, Counter[str]]:
    """The first question that passes every filter, with all that is known of it, and what was refused before."""
    recipe, mode = RECIPES[request.recipe], MODES[request.mode]
    difficulty = known(request.difficulty)
    rejected: Counter[str] = Counter()
    for attempt in range(SCENES):
        rng = generator(request.recipe, request.difficulty, request.mode, request.seed, request.index, attempt)
        try:
            scene = recipe(difficulty, rng)
            found = QuestionSearch(scene, int(rng.random() * 2**31), difficulty).ask(mode, rng, rejected)
        except (SceneError, SimulationError, UnsupportedError) as error:
            rejected[type(error).__name__.removesuffix("Error").lower()] += 1
            continue
        if found is not None:
            return found, rejected
    return None, rejected


def item_of(request: Request, found: CertifiedQuestion) -> Item:
    """The record of a question that passed."""
    scene = found.description.scene
    question = found.question
    return Item(
        id=request.id,
        prompt=found.prompt,
        shape=found.shape,
        answer=Answer(
            value=question.answer, unit=question.unit, sign=question.sign, tolerance=found.candidate.tolerance
        ),
        mode=request.mode,
        kind=question.query.kind,
        recipe=request.recipe,
        difficulty=request.difficulty,
        entities=tuple(type(named.entity).__name__ for named in scene.entities),
        asked=_query_of(found),
        distractors=distractors(found.candidate, found.description),
        idle=idle_parts(found.candidate, found.description),
        idle_numbers=idle_numbers(found.candidate),
        scene=dump(found.study.scene),
        certificate=summary(found.certificate),
        provenance=Provenance(
            recipe=request.recipe,
            difficulty=request.difficulty,
            mode=request.mode,
            seed=request.seed,
            index=request.index,
            versions=versions(),
            config=SETTINGS,
        ),
    )


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
