"""Names of a scene's numbers in ordinary English, and their addresses in a scene."""

import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from math import isclose
from typing import NamedTuple

import numpy as np

from sim2reason.errors import TextError
from sim2reason.questions.following import FollowedMotion
from sim2reason.questions.inversion import is_one_of_a_range
from sim2reason.questions.ordinary.hearing import ALL_WORD
from sim2reason.questions.ordinary.vocabulary import GROUNDS
from sim2reason.questions.posing import PosedQuestion
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.unknown import Unknown, derived_numbers, with_number
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.model import Parameter
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.simulation.quantities.kinematics import Velocity
from sim2reason.simulation.quantities.subjects.bodies import Bodies

NUMBER = "NUMBER"  # in a pattern of other modules: a phrase for a number
EVERY_MASS = "every mass"  # of all bodies that the text has
NEVER_ZERO = "friction", "mass", "speed", "horizontal speed", "angular speed", "motion at start"
EFFECT_FACTOR = 1.01  # factor on a number, to find its effects
INITIAL_SPEED_RTOL = 1e-9  # relative: largest difference of an initial speed from the given one


class NumberKind(NamedTuple):
    """A kind of number: a pattern of its nouns, and the final parts of its addresses.

    If `units` are given, only a number with one of these units, nouns or places of an angle is of the kind.
    """

    nouns: str
    fields: tuple[str, ...]
    units: tuple[str, ...] = ()


_STARTING = "(?:initial|launch|launching|starting|start|release|throwing|firing|original|take-off)"
_FIELD = "(?:field|field strength|induction|flux density)"
NUMBERS: Mapping[str, NumberKind] = {
    "empty mass": NumberKind("mass without (?:its )?fuel|dry mass|empty mass|mass when empty", ("dry",)),
    "stellar mass": NumberKind("stellar mass", ("star.mass",)),
    "mass": NumberKind(f"(?:(?:total|{_STARTING}) )?mass", ("mass",), ("kg", "mg", "Msun")),
    "angular speed": NumberKind(
        f"(?:{_STARTING} )?(?:angular (?:speed|velocity)|rate of rotation|spin|rotation rate)",
        ("rate", "spin"),
        ("rad/s",),
    ),
    "exhaust speed": NumberKind(
        "(?:exhaust|ejection|gas|outflow|effective exhaust) (?:speed|velocity)|(?:speed|velocity) of (?:exhaust"
        "|exhaust gas(?:es)?"
        "|gas(?:es)?|ejected gas(?:es)?)|(?:speed|velocity) (?:with|at) which (?:exhaust )?gas(?:es)? (?:is|are)"
        " ejected",
        ("exhaust",),
    ),
    "drag": NumberKind(
        "(?:drag|resistance|damping) (?:coefficient|constant)|coefficient of (?:drag|resistance)",
        ("coefficient", "damping"),
    ),
    "burn rate": NumberKind(
        "burning rate|(?:fuel |propellant )?(?:consumption|burn|burning|combustion|mass flow|flow) rate|fuel rate"
        "|rate of (?:fuel consumption"
        "|burning(?: of fuel| (?:its )?fuel)?|combustion|fuel burn)"
        "|rate at which (?:(?:its )?fuel is (?:burnt|burned|consumed|used)"
        "|(?:it|@\\d+@|engine) burns (?:its )?fuel)|fuel consumption",
        ("rate",),
        ("kg/s",),
    ),
    "speed": NumberKind(f"(?:{_STARTING} )?(?:speed|velocity)(?: of (?:projection|launch|throw|release))?", ("speed",)),
    "horizontal speed": NumberKind("horizontal (?:launch |initial )?(?:speed|velocity)", ("speed",)),
    "friction": NumberKind(
        "coefficient of (?:(?:static|kinetic|sliding|static and kinetic|static or kinetic) )?friction"
        "|(?:(?:static|kinetic|sliding) )?(?:friction|frictional) coefficient",
        ("friction", "top_friction"),
    ),
    "restitution": NumberKind("coefficient of restitution|restitution(?: coefficient)?", ("restitution",)),
    "stiffness": NumberKind("(?:spring )?stiffness|(?:spring|force) constant|stiffness constant", ("stiffness",)),
    "natural length": NumberKind(
        "(?:natural|unstretched|relaxed|free|unstrained) length", ("length",), ("natural length",)
    ),
    "initial length": NumberKind(f"{_STARTING} length", ("start",), ("length",)),
    "strain": NumberKind(f"{_STARTING} (?:compression|extension|stretch|elongation)", ("by",)),
    "length": NumberKind("length", ("length",), ("length",)),
    "height": NumberKind(
        f"(?:{_STARTING} )?height(?: of (?:tower|cliff|launch|launch point|release|thrower|throw|starting point))?",
        ("height",),
    ),
    "slope": NumberKind(
        f"(?:inclination|slope angle|tilt|gradient|steepness|angle of inclination|angle of (?:{GROUNDS})"
        f"|(?:{GROUNDS})(?: 's)? (?:angle|inclination))"
        f"(?: of (?:{GROUNDS}))?",
        ("angle", "tilt"),
        ("plane",),
    ),
    "launch angle": NumberKind(
        "(?:launch|throwing|elevation|projection|launching|firing) angle|angle of (?:projection|launch|elevation|throw)"
        "|angle (?:above|to|with) horizontal|angle of elevation",
        ("angle",),
        ("launch",),
    ),
    "swing angle": NumberKind(f"(?:{_STARTING}|release) angle|amplitude", ("angle",), ("swing",)),
    "angle": NumberKind("angle", ("angle", "tilt"), ("plane", "launch", "swing")),
    "radius": NumberKind("radius", ("radius",)),
    "distance": NumberKind(
        "distance from (?:its )?(?:axle|axis|pivot)|distance of @\\d+@ from (?:axle|axis|pivot)", ("distance",)
    ),
    "magnetic field": NumberKind(f"(?:strength of )?magnetic {_FIELD}(?: strength)?", ("magnetic.strength",)),
    "electric field": NumberKind(f"(?:strength of )?electric {_FIELD}(?: strength)?", ("electric.strength",)),
    "field": NumberKind("(?:strength of )?field(?: strength)?", ("magnetic.strength", "electric.strength")),
    "charge": NumberKind("(?:magnitude of )?charge|amount of charge", ("charge",)),
    "gravity": NumberKind(
        "(?:acceleration due to gravity|g|(?:free-fall|free fall|gravitational|gravity) acceleration|acceleration"
        " of free fall"
        "|gravitational field strength|gravity)(?: there)?",
        ("gravity",),
    ),
    "force": NumberKind(
        "(?:(?:pulling|applied|constant|steady|horizontal|hand 's) )*(?:force|pull)(?: of hand)?", ("force",)
    ),
    "motion at start": NumberKind("(?!)", ("speed", "rate", "spin"), ("m/s", "km/s", "rad/s")),  # by no noun
}
"""All kinds of numbers that a question may vary or ask for, by name; the more specific ones first."""


class NamedNumber(NamedTuple):
    """A number as a sentence names it: its kind, and the text's phrases for its owners, such as *block A*.

    It is `grounded` if the sentence says that it is that of a fixed surface, such as *the floor*.
    """

    kind: str
    owners: tuple[str, ...] = ()
    grounded: bool = False


@cache
def number_pattern() -> str:
    """Return the pattern of a phrase such as *its mass* or *coefficient of friction between A and B*.

    It has a group for each kind of number, *n0*, *n1* and so on, and groups for the owners.
    """
    nouns = "|".join(f"(?P<n{index}>{kind.nouns})" for index, kind in enumerate(NUMBERS.values()))
    reference = r"(?: ?,? (?:relative to|with respect to) @\d+@ ?,?)?"
    owner = (
        rf"(?: (?:of|for|between|on|in) (?:both )?(?P<of>@\d+@)(?: and (?:(?P<and>@\d+@)"
        rf"|(?:{GROUNDS})|its (?:{GROUNDS})))?"
        rf"|(?: (?:of|on|for|between) (?:(?P<ground>{GROUNDS})|hand|wall|pulling hand|hand 's pull))(?: and"
        rf" (?P<too>@\d+@))?)?"
    )
    start = r"(?: (?:at start|at launch|at release|initially))?"
    return rf"(?:(?P<own>@\d+@) 's |its |their |his |hand 's )?(?:{nouns}){reference}{owner}{start}"


def named_number(match: re.Match[str], subject: Mapping[str, str]) -> NamedNumber:
    """Return the number that a match of `number_pattern` names; `subject` has the text's phrase for each token."""
    kind = next(name for index, name in enumerate(NUMBERS) if match[f"n{index}"] is not None)
    tokens = (match[key] for key in ("own", "of", "and", "too"))
    return NamedNumber(kind, tuple(subject[token] for token in tokens if token), match["ground"] is not None)


def paths_of(named: NamedNumber, study: SimulatedScene, words: Words) -> tuple[str, ...]:
    """Return the addresses of a named number, one for each owner; none if the name is ambiguous."""
    owners = tuple(each for phrase in named.owners for each in _each(phrase))
    if named.kind == EVERY_MASS:
        return tuple(path for path, _ in _numbers_of_kind("mass", study.scene))
    every = list(_numbers_of_kind(named.kind, study.scene))
    if named.kind == "horizontal speed" and not is_zero("launch angle", study.scene):
        return ()
    if named.grounded and named.kind == "friction" and any(_is_carried(study, *number) for number in every):
        return ()
    if not owners:
        return tuple(path for path, _ in every) if len(every) == 1 else ()
    if named.kind == "friction":
        return _rubbing(every, owners, study, words)
    owned_paths = [
        [path for path, number in every if _belongs(path, number, owner, study, words, len(every))] for owner in owners
    ]
    return tuple(paths[0] for paths in owned_paths) if all(len(paths) == 1 for paths in owned_paths) else ()


def is_zero(kind: str, scene: Scene) -> bool:
    """Return whether a scene has no nonzero number of a kind."""
    return not any(value for _, value in _numbers_of_kind(kind, scene))


def _each(phrase: str) -> Sequence[str]:
    return phrase.removeprefix(f"{ALL_WORD} ").split(" & ") if phrase.startswith(f"{ALL_WORD} ") else (phrase,)


def _numbers_of_kind(name: str, scene: Scene) -> Iterator[tuple[str, float]]:
    """Yield the addresses and values of a scene's numbers of a kind; of most kinds only nonzero ones."""
    kind = NUMBERS[name]
    parameters = [parameter for parameter in scene.parameters if not parameter.hidden and _is_of(parameter, kind)]
    for parameter in parameters:
        if parameter.value or (parameter.value is not None and name not in NEVER_ZERO):
            yield parameter.path, parameter.value
    if name == "speed":
        for path, number in derived_numbers(scene).items():
            yield path, number.value(scene)


def _is_of(parameter: Parameter, kind: NumberKind) -> bool:
    if not any(f".{parameter.path}".endswith(f".{field}") for field in kind.fields):
        return False
    measure = parameter.measure
    if measure.unit == "deg":
        return _place(parameter) in kind.units
    return not kind.units or measure.unit in kind.units or measure.noun in kind.units


def _place(parameter: Parameter) -> str:
    """Return the component to which an angle belongs: *plane*, *launch* or *swing*; empty for any other number."""
    part, name = parameter.path.split(".")[-2], parameter.measure.name
    if name == "elevation" or part == "start":
        return "launch"
    return "swing" if name == "deflection" else "plane" if part in ("plane", "track", "table") else ""


def _belongs(path: str, value: float, owner: str, study: SimulatedScene, words: Words, count: int) -> bool:
    """Return whether a number belongs to an owner: by its address, or as an initial speed that the body has."""
    head = path.rpartition(".")[0]
    mention = words.mentions.get(head, words.mentions.get(f"{head}.body"))
    if mention is not None and mention.split()[-1] != "start":
        return mention == owner
    bodies = {phrase: name for name, phrase in words.subject_phrases(Bodies()).items()}
    if path.endswith((".speed", ".spin")) and owner in bodies:
        speed = float(np.linalg.norm(Velocity.evaluate(study.trace.at(0.0), bodies[owner])[0]))
        return path.endswith(".spin") or isclose(speed, value, rel_tol=INITIAL_SPEED_RTOL)
    return count == 1


def _rubbing(
    every: list[tuple[str, float]], owners: tuple[str, ...], study: SimulatedScene, words: Words
) -> tuple[str, ...]:
    """Return the address of the coefficient of friction between the owners, or of an owner and the fixed surface."""
    if len(every) != 1:
        if len(owners) == 2:
            return _between(every, owners, study, words)
        alone = [path for path, _ in every if words.mentions.get(path.rpartition(".")[0]) in owners]
        return tuple(alone) if len(alone) == 1 else ()
    mechanism = study.mechanism
    bodies = {phrase: name for name, phrase in words.subject_phrases(Bodies()).items()}
    names = [bodies[phrase] for phrase in owners if phrase in bodies]
    rubs = {name for name, contact in mechanism.contacts.items() if contact.friction > 0.0}
    faces = {mechanism.body[name].parent or "" for name in rubs}
    if len(names) == 2:
        one, other = names
        pairs = ((one, other), (other, one))
        fits = any(a in rubs and mechanism.body[a].parent == b for a, b in pairs)
    else:
        fits = all(name in rubs or name in faces for name in names)
    return (every[0][0],) if fits else ()


def _between(
    every: list[tuple[str, float]], owners: tuple[str, ...], study: SimulatedScene, words: Words
) -> tuple[str, ...]:
    """Return the address of the coefficient of friction between a body and its carrier; none if there is none."""
    bodies = {phrase: name for name, phrase in words.subject_phrases(Bodies()).items()}
    one, other = (bodies.get(phrase, "") for phrase in owners)
    mechanism = study.mechanism
    riders = [a for a, b in ((one, other), (other, one)) if a in mechanism.body and mechanism.body[a].parent == b]
    matching_paths = [path for path, value in every if _roughens(study, path, value) == set(riders)]
    return tuple(matching_paths) if len(riders) == len(matching_paths) == 1 else ()


def _is_carried(study: SimulatedScene, path: str, value: float) -> bool:
    """Return whether a number belongs to a face of a body rather than of a fixed surface."""
    return any(study.mechanism.body[name].parent is not None for name in _roughens(study, path, value))


def _roughens(study: SimulatedScene, path: str, value: float) -> set[str]:
    """Return the names of the bodies whose friction changes with a number."""
    faces = with_number(study.scene, path, value * EFFECT_FACTOR).mechanism.contacts
    return {name for name, face in study.mechanism.contacts.items() if face.friction != faces[name].friction}


def check_single(values: Sequence[float], asked: PosedQuestion, unknown: Unknown, motion: FollowedMotion) -> None:
    """Raise TextError if several values, or all those of a range, have the stated answer."""
    if len(values) > 1:
        several = ", ".join(f"{value:.6g} {unknown.unit}" for value in values)
        raise TextError("question", f"several values do: {several}", "ask for the least, or for the greatest")
    if values and is_one_of_a_range(values[0], asked.query, asked.given, unknown, motion.study):
        raise TextError("question", "a whole range of values does", "ask what something needs, such as to stay at rest")
