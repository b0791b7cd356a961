"""Readings of sentences that ask for a number of the scene, with the number's address."""

from collections.abc import Iterable, Iterator

from sim2reason.dsl.scene import Scene
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.paths import center_path
from sim2reason.questions.moments.parts.slip_change import rolls
from sim2reason.questions.ordinary.addresses import addresses
from sim2reason.questions.ordinary.hearing import Heard
from sim2reason.questions.ordinary.reading import Reading
from sim2reason.questions.ordinary.wanted import AT_REST, WantedNumber, wanted
from sim2reason.questions.structured import START, StructuredQuestion
from sim2reason.questions.targets import OWN_PATH
from sim2reason.questions.words import Words


def numbers_wanted(heard: Heard, scene: Scene, words: Words) -> Iterator[Reading]:
    """Yield the readings of a sentence that asks for a number of the scene, with the number's address."""
    for found in wanted(heard):
        path = _path(found, scene, words)
        if not path:
            continue
        if found.does:
            for rank, who in enumerate(dict.fromkeys((found.of, ""))):
                asked = StructuredQuestion(path, when=f"{who} {found.does}".strip())
                yield Reading(asked, least=found.least, happens=found.happens, rank=rank)
        elif found.given == AT_REST:
            yield from _balanced(path, found.of, words)
        else:
            asked = StructuredQuestion(path, found.of, found.when.told, given=found.given)
            yield Reading(asked, found.when.side, rank=found.when.rank)


def _balanced(path: str, of: str, words: Words) -> Iterator[Reading]:
    """Yield readings that ask for the number with which a body, or each, is not accelerated; none on rough faces."""
    if rubs(words):
        return  # within a whole range of numbers
    alone = addresses(words).get(of)
    yield from without_acceleration(path, words.called(Bodies()) if alone is None else (alone,), words)


def rubs(words: Words) -> bool:
    """Return whether a body lies on a rough face, unless it rolls there."""
    contacts = words.mechanism.contacts
    return any(contact.friction > 0.0 and not rolls(words, name) for name, contact in contacts.items())


def without_acceleration(path: str, names: Iterable[str], words: Words) -> Iterator[Reading]:
    """Yield the question for the number with which a body has no acceleration, for each body that moves on a line."""
    for name in names:
        senses = Bodies().senses(words.mechanism, name)
        if len(senses) == 1 or (not senses and center_path(words.mechanism, name).straight):
            along = senses[0].positive if senses else OWN_PATH
            given = f"acceleration along {along} = 0 m/s^2"
            yield Reading(StructuredQuestion(path, name, START, given=given))


def _path(found: WantedNumber, scene: Scene, words: Words) -> str:
    """Return the address of the number that a sentence asks for; empty unless exactly one number of the scene fits."""
    given = [p.path for p in scene.parameters if p.value is not None and not p.hidden]
    owners = [address for address, said in words.mentions.items() if said == found.owner]
    named = [path for path in given if path.rpartition(".")[2] == found.name]
    if found.owner:
        named = [path for path in named if path.rpartition(".")[0] in owners]
    return named[0] if len(named) == 1 else ""
