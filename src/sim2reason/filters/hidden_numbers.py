"""Drops a question whose answer hangs on a number that the text does not give."""

from typing import cast

from sim2reason.dsl.model import Model, field_types
from sim2reason.dsl.scene import Scene
from sim2reason.filters import FILTERS, Candidate, Filter
from sim2reason.questions import KINDS
from sim2reason.questions.study import BEYOND, ENOUGH

SAME = 1e-6  # relative


class HiddenNumbers(Filter):
    """The answer changes, or there is none, with every hidden length at the low end of its range."""

    order = 5

    def reason(self, candidate: Candidate) -> str:
        """Solve the scene with its strings as short as they may be drawn, and ask again."""
        answer, query, study = candidate.question.answer, candidate.question.query, candidate.study
        shorter = tightest(study.scene)
        if shorter is study.scene:
            return ""
        kind = KINDS[query.kind]
        moment = kind.time(query, study)
        tight = study.variant(shorter, None if moment is None else BEYOND * moment, ENOUGH)
        if tight is None:
            return "with shorter strings there is no motion"
        time = kind.time(query, tight)
        if time is None or time > tight.trace.stable_until:
            return "with shorter strings the moment does not come"
        again = candidate.response(tight)
        return "" if again is not None and abs(again - answer) <= SAME * abs(answer) else "a hidden length matters"


def tightest(scene: Scene) -> Scene:
    """The scene with every hidden number at the low end of what it may be drawn from."""
    for parameter in scene.parameters:
        if parameter.hidden and parameter.value is not None:
            owner, _, name = parameter.path.rpartition(".")
            held = field_types(cast("type[Model]", type(scene.value(owner))))[name]
            if held.drawn is not None and parameter.value != held.drawn.low:
                scene = scene.having(parameter.path, held.drawn.low)
    return scene


FILTERS.add("hidden numbers", HiddenNumbers())
