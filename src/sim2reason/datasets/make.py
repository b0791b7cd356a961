"""The maker of items: a pure function of recipe, difficulty, mode, seed and index."""

import hashlib
import json
from collections import Counter
from dataclasses import dataclass, replace

import numpy as np
from pydantic import JsonValue

from sim2reason.datasets.draws import generator, known
from sim2reason.datasets.item import Answer, Asked, Item, Provenance
from sim2reason.datasets.plan import Made, Request, versions
from sim2reason.dsl.files import dump
from sim2reason.dsl.scene import Scene
from sim2reason.dsl.speaker import Telling, tell
from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.filters import Candidate, sift
from sim2reason.questions import MODES, Mode, Question
from sim2reason.questions.prompt import prompt, words_of
from sim2reason.recipes import RECIPES
from sim2reason.simulation.certify import RECORDED, Certificate, witnessed
from sim2reason.simulation.trace import ENGINES, Trace

SCENES = 60  # scenes drawn for one item, at most
QUESTIONS = 4  # questions tried on one scene
DURATION = 2.0  # s
SAMPLES = 41
SHORTEST = 0.1  # s of usable motion
SETTINGS = hashlib.sha256(json.dumps([SCENES, QUESTIONS, DURATION, SAMPLES, SHORTEST]).encode()).hexdigest()[:16]


@dataclass(frozen=True)
class Asking:
    """A question with everything that it rests on."""

    scene: Scene
    telling: Telling
    trace: Trace
    question: Question
    prompt: str
    certificate: Certificate


def make(request: Request) -> Made:
    """Draw scenes and questions until one passes every filter; UnknownNameError for a name that is not known."""
    recipe, mode = RECIPES[request.recipe], MODES[request.mode]
    difficulty = known(request.difficulty)
    rejected: Counter[str] = Counter()
    for attempt in range(SCENES):
        rng = generator(request.recipe, request.difficulty, request.mode, request.seed, request.index, attempt)
        try:
            scene = recipe(difficulty, rng)
            found = ask(scene, mode, rng, rejected)
        except (SceneError, SimulationError, UnsupportedError) as error:
            rejected[type(error).__name__.removesuffix("Error").lower()] += 1
            continue
        if found is not None:
            return Made(item_of(request, found), dict(rejected))
    return Made(None, dict(rejected))


def ask(scene: Scene, mode: Mode, rng: np.random.Generator, rejected: Counter[str], kind: str = "") -> Asking | None:
    """One question about a scene that passes every filter, or None; what was refused is counted by filter."""
    trace = ENGINES[RECORDED](scene.mechanism, np.linspace(0.0, DURATION, SAMPLES))
    if trace.stable_until < SHORTEST:
        rejected[f"unstable: {trace.cut}"] += 1
        return None
    telling = tell(scene, int(rng.integers(2**31)))
    words = words_of(telling)
    heard: tuple[Trace, Certificate] | None = None
    for _ in range(QUESTIONS):
        question = mode(trace, words, kind, rng)
        if question is None:
            rejected["nothing to ask"] += 1
            continue
        candidate = Candidate(scene, trace, question, prompt(telling, question, rng))
        verdict = sift(candidate, witnessed=False)
        if verdict.keep:
            heard = heard or witnessed(trace)
            verdict = sift(replace(candidate, certificate=heard[1]), witnessed=True)
        if verdict.keep and heard is not None:
            return Asking(scene, telling, heard[0], question, candidate.prompt, heard[1])
        rejected[verdict.filter] += 1
    return None


def item_of(request: Request, found: Asking) -> Item:
    """The record of a question that passed."""
    question, ask_ = found.question, found.question.ask
    target = ask_.target
    time = ask_.time(found.trace)
    return Item(
        id=request.id,
        prompt=found.prompt,
        answer=Answer(value=question.answer, unit=question.unit, sign=question.sign),
        mode=request.mode,
        kind=ask_.kind,
        recipe=request.recipe,
        difficulty=request.difficulty,
        entities=tuple(type(named.entity).__name__ for named in found.scene.entities),
        asked=Asked(
            subject=target.subject if target else ask_.moment.subjects[0],
            quantity=target.quantity if target else "time",
            time=time,
            event=type(ask_.moment).__name__.lower(),
        ),
        scene=dump(found.scene),
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
