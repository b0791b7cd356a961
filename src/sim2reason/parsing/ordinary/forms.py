"""The library's own sentences on scenes, gathered from random scenes of every entity, with symbols for numbers."""

from collections.abc import Container, Iterator
from dataclasses import dataclass
from functools import cache

import numpy as np
from pydantic import ValidationError

from sim2reason.dsl.choices import chances, choices, closed, reachable, specials
from sim2reason.dsl.entity import ENTITIES, Entity, Named
from sim2reason.dsl.model import Choice, Count, draw, field_types
from sim2reason.dsl.scene import Scene
from sim2reason.errors import SceneError, UnsupportedError
from sim2reason.parsing.ordinary.content import Content, content_of_form
from sim2reason.prose.naming import Names, letters
from sim2reason.prose.voices import symbolic_but_zero
from sim2reason.prose.writer import Writer

ALONE = 4  # numbers with a word of their own, such as *smooth*, that are shown one by one
KINDS = 4  # of parts that may stand in the same place, such as bodies that roll
RANDOM = 1  # scenes of each entity drawn as they come
WORDINGS = 2  # of each scene
IT = "it"
GRAVITY, _GRAVITY_OF_SYMBOL = "Take g = $g$.", "The acceleration of free fall is $g$."  # as with a number, and without


@dataclass(frozen=True, slots=True)
class Form:
    """A sentence with symbols in dollars for its numbers, each with its unit; `place` is how far on in a text it is."""

    text: str
    units: tuple[str, ...]
    place: float
    content: Content


class _Teller(Writer):
    """A writer that takes the wording of one number throughout, and of nouns always the first."""

    wording = 0

    def choose(self, options: tuple[str, ...]) -> str:
        """Return the wording of that number, counted round."""
        return options[self.wording % len(options)]


@cache
def forms() -> tuple[Form, ...]:
    """Return all forms that are known, each once."""
    found: dict[str, Form] = {}
    for cls in ENTITIES.values():
        for number, chosen in enumerate(_choices(cls)):
            for form in _forms_of(cls, number, chosen, found):
                found[form.text] = form
    return tuple(found.values())


def _choices(cls: type[Entity]) -> Iterator[dict[str, Choice]]:
    """Yield settings for drawing scenes of an entity, enough to need each special word, such as *smooth*, once."""
    fields = [(model, name, held) for model in reachable(cls) for name, held in field_types(model).items()]
    told = {f"{model.__name__}.{name}": specials(model, name) for model, name, _ in fields if specials(model, name)}
    few = {
        f"{model.__name__}.{name}": Count(held.count.low, held.count.low) for model, name, held in fields if held.count
    }
    words: list[dict[str, float]] = [{}, *({path: values[end] for path, values in told.items()} for end in (0, -1))]
    for present in (0.0, 1.0):
        plain: dict[str, Choice] = {**few, **dict.fromkeys(chances(cls), present)}
        yield from ({**plain, **special} for special in words)
        yield from ({**plain, path: told[path][0]} for path in list(told)[:ALONE] if len(told) > 1)
    for model, name, held in fields:
        kinds = [kind.__name__ for kind in held.models if len(held.models) > 1]
        yield from ({**chances(cls), f"{model.__name__}.{name}": (kind,)} for kind in kinds[:KINDS])
    yield from (choices(cls, np.random.default_rng(seed)) for seed in range(RANDOM))


def _forms_of(cls: type[Entity], number: int, chosen: dict[str, Choice], known: Container[str]) -> Iterator[Form]:
    """Yield the sentences about a random scene of an entity that are not yet known; none if the scene is not valid."""
    rng = np.random.default_rng([number])
    try:
        scene = closed(Named(name=IT, entity=draw(cls, rng, chosen)), rng)
        first = _Teller(scene, Names(), rng, symbolic_but_zero)
        first.sentences()
        for wording in range(WORDINGS):
            yield from _told(scene, first, number * WORDINGS + wording, known)
    except (SceneError, UnsupportedError, ValidationError):
        return


def _told(scene: Scene, first: Writer, wording: int, known: Container[str]) -> Iterator[Form]:
    names = Names(letters(first.introduced, scene.bodies))
    teller = _Teller(scene, names, np.random.default_rng(0), symbolic_but_zero, tuple(first.told))
    teller.wording = wording
    said = [GRAVITY if sentence == _GRAVITY_OF_SYMBOL else sentence for sentence in teller.sentences()]
    units = {teller.symbols[p.path]: p.measure.unit for p in scene.parameters if p.path in teller.symbols}
    for index, sentence in enumerate(said):
        if "|" in sentence or sentence in known:
            continue
        told = content_of_form(sentence)
        symbols = [number.digits for number in told.numbers]
        if all(symbol in units for symbol in symbols):
            yield Form(sentence, tuple(units[symbol] for symbol in symbols), index / len(said), told)
