"""Fast and deterministic makers for tests, some of which crash, hang or raise at certain indices."""

import hashlib
import os
import time
from dataclasses import replace

from sim2reason.generation.item import Answer, Binding, Distractor, FormulaRecord, Item, Provenance, QueryRecord
from sim2reason.generation.request import Made, Request

BAD = 7  # the index of the item that goes wrong


def steady(request: Request) -> Made:
    """Return a problem whose numbers are a hash of the request; index 3 of inclines finds no item."""
    if request.index == 3 and request.recipe == "incline":
        return Made(None, {"shortcut": 12})
    number = int.from_bytes(hashlib.sha256(request.id.encode()).digest()[:4], "big")
    mass = 0.5 + number % 950 / 100
    item = Item(
        id=request.id,
        prompt=f"Item {request.id}: a block of mass {mass:.2f} kg rests. Find its weight.\nAnswer in \\boxed{{}}.",
        shape="scene_first",
        answer=Answer(value=9.81 * mass, unit="N"),
        mode=request.mode,
        kind="state",
        recipe=request.recipe,
        difficulty=request.difficulty,
        entities=("block",),
        asked=QueryRecord(subject="a.block", quantity="weight", time=number % 100 / 10),
        # of another kind each, since letters beside them make digits part of a word
        scene=f"scene:\n  name: {request.id}\n  kind: {request.id.replace('-', '_')}\n",
        certificate={"agreement": 1e-9, "channels": ["a.block"]},
        provenance=Provenance(
            recipe=request.recipe,
            difficulty=request.difficulty,
            mode=request.mode,
            seed=request.seed,
            index=request.index,
            versions={"sim2reason": "0.0.0"},
            settings="0",
        ),
    )
    return Made(item, {"degenerate": number % 3, "shortcut": number % 2})


def wanting(request: Request) -> Made:
    """Return the problem of `steady` with a period as the wanted kind."""
    return replace(steady(request), wanted="period")


def nothing(request: Request) -> Made:
    """Return no item, as if no question could be asked about any scene of the cell."""
    del request
    return Made(None, {"nothing to ask": 40})


def slow(request: Request) -> Made:
    """Return the problem of `steady` after 5 ms, so that a run can be killed meanwhile."""
    time.sleep(0.005)
    return steady(request)


def crashing(request: Request) -> Made:
    """End the process at the bad index of pulleys."""
    if request.index == BAD and request.recipe == "pulley":
        os._exit(3)
    return steady(request)


def hanging(request: Request) -> Made:
    """Never return at the bad index of pulleys."""
    while request.index == BAD and request.recipe == "pulley":
        time.sleep(0.01)
    return steady(request)


def raising(request: Request) -> Made:
    """Raise at the bad index of pulleys."""
    if request.index == BAD and request.recipe == "pulley":
        raise ValueError("a defect\nof two lines")
    return steady(request)


def twins(request: Request) -> Made:
    """Return items of which each odd index repeats the prompt of the index before."""
    made = steady(request)
    if made.item is None or request.index % 2 == 0:
        return made
    before = steady(replace(request, index=request.index - 1)).item
    prompt = before.prompt if before else made.item.prompt
    return Made(made.item.model_copy(update={"prompt": prompt}), made.rejected)


def impostor(request: Request) -> Made:
    """Return an item with the id of another one."""
    made = steady(request)
    return Made(made.item and made.item.model_copy(update={"id": "other"}), made.rejected)


def one_scene(request: Request) -> Made:
    """Return the problem of `steady` with one common scene, about which each item asks a different question."""
    made = steady(request)
    return Made(made.item and made.item.model_copy(update={"scene": "scene: {}\n"}), made.rejected)


def with_answers(request: Request) -> Made:
    """Return items with all kinds of answers (weight, signed component, count, formula) and wrong options."""
    made = steady(request)
    if made.item is None:
        return made
    value = made.item.answer.value
    answer, form = [
        (Answer(value=value, unit="N"), "Give your answer in N, to three significant figures, inside \\boxed{}."),
        (
            Answer(value=-value, unit="m/s", sign="up"),
            "State the answer in m/s to three significant figures, inside \\boxed{}.",
        ),
        (Answer(value=float(round(value)), unit=""), "Give your answer as a whole number, inside \\boxed{}."),
        (_weight(value), "Give your answer in terms of $m$ and $g$, inside \\boxed{}."),
    ][request.index % 4]
    wrong = [2.0, 1.02, -1.0, 0.5, 3.0, 0.01][: 1 + request.index % 6]
    changes = {
        "prompt": f"Item {request.id}: a block of mass {value:.4g} kg rests. What is asked? {form}",
        "answer": answer,
        "distractors": tuple(
            Distractor(
                value=factor * answer.value, simplification=f"times {factor}", reason=f"It is {factor} times that."
            )
            for factor in wrong
            if abs(factor - 1.0) > answer.tolerance
        ),
    }
    return replace(made, item=made.item.model_copy(update=changes))


def _weight(value: float) -> Answer:
    bindings = tuple(Binding(numbers=(m, 9.8), answer=9.8 * m) for m in (value / 9.8, *(0.5 + n for n in range(8))))
    formula = FormulaRecord(latex="m g", symbols=("m", "g"), units=("kg", "m/s^2"), unit="N", bindings=bindings)
    return Answer(value=value, unit="N", formula=formula)


def masses(request: Request) -> Made:
    """Return items of one problem whose only number is a mass of three digits; some have equal prompts."""
    made = steady(request)
    if made.item is None:
        return made
    mass = 1.0 + int.from_bytes(hashlib.sha256(f"mass of {request.id}".encode()).digest()[:4], "big") % 900 / 100
    changes = {
        "scene": f"scene:\n  mass: {mass:.2f}\n",
        "asked": made.item.asked.model_copy(update={"time": None}),
        "answer": made.item.answer.model_copy(update={"value": mass}),
    }
    if request.index % 5 == 0:
        changes["prompt"] = f"One of several equal texts, number {request.index // 20}."
    return Made(made.item.model_copy(update=changes), made.rejected)


def few(request: Request) -> Made:
    """Return items of one problem with only a dozen masses, successive ones a tenth apart, in random order."""
    made = steady(request)
    if made.item is None:
        return made
    number = int.from_bytes(hashlib.sha256(f"one of few {request.id}".encode()).digest()[:4], "big") % 12
    changes = {
        "scene": f"scene:\n  mass: {1.1**number:.3f}\n",
        "asked": made.item.asked.model_copy(update={"time": None}),
        "answer": made.item.answer.model_copy(update={"value": 1.1**number}),
    }
    return Made(made.item.model_copy(update=changes), made.rejected)
