"""Immutable values with declared parameters and bounds, and functions to traverse, change and draw them at random."""

import types
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cache
from math import inf, nextafter
from typing import Annotated, Any, Literal, Self, TypeGuard, TypeVar, Union, cast, get_args, get_origin

import numpy as np
from annotated_types import Ge, Gt, Le, Lt
from pydantic import BaseModel, ConfigDict, ValidationError, model_validator

from sim2reason.base.records import record
from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.measures import (
    Above,
    Chance,
    Count,
    Hidden,
    Measure,
    Member,
    Range,
    Sized,
    Usually,
    relations,
    violated_relation,
)


def bounds(metadata: Iterable[object]) -> tuple[float, float]:
    """Return the least and the greatest float that satisfy all bounds in an annotation's metadata."""
    lower, most = -inf, inf
    for bound in metadata:
        if isinstance(bound, Ge):
            lower = max(lower, cast("float", bound.ge))
        elif isinstance(bound, Gt):
            lower = max(lower, nextafter(cast("float", bound.gt), inf))
        elif isinstance(bound, Le):
            most = min(most, cast("float", bound.le))
        elif isinstance(bound, Lt):
            most = min(most, nextafter(cast("float", bound.lt), -inf))
    return float(lower), float(most)


class Model(BaseModel):
    """The base class of bodies, parts, entities and scenes: immutable, strict, without unknown fields or infinities."""

    model_config = ConfigDict(
        frozen=True,
        extra="forbid",
        strict=True,
        allow_inf_nan=False,
        validate_default=True,
        revalidate_instances="never",
    )

    @classmethod
    def variants(cls) -> "tuple[type[Model], ...]":
        """Return the classes that a field of this type may hold: this class, or those registered under an open base."""
        return (cls,)

    @classmethod
    def fitted(cls, drawn: Mapping[str, Any], rng: np.random.Generator) -> Mapping[str, object]:
        """Return replacements, by field name, of drawn values that do not fit together.

        None by default. Values chosen by a recipe are kept.
        """
        del drawn, rng
        return {}

    @model_validator(mode="after")
    def _relations_hold(self) -> Self:
        """Raise ValueError if a count or an index contradicts another field."""
        declared = relations(type(self), field_types)
        broken = violated_relation(self, declared) if any(declared) else ""
        if broken:
            raise ValueError(broken)
        return self


M = TypeVar("M", bound=Model)


@record(slots=True)
class Parameter:
    """One declared number of a value: address, value (None: absent), measure, and whether it may be negative."""

    path: str
    value: float | None
    measure: Measure
    hidden: bool
    signed: bool


@record(slots=True)
class FieldType:
    """The analysed annotation of a field: `models` are the classes that the field may hold."""

    measure: Measure | None
    drawn: Range | None
    count: Count | None
    hidden: bool
    optional: bool
    models: tuple[type[Model], ...]
    words: tuple[str, ...]  # of a Literal
    member: str = ""  # the field whose members an index counts
    size: Callable[[Mapping[str, Any]], int] | None = None  # number of members, if other fields determine it
    chance: float | None = None  # probability of an optional field
    above: str = ""  # the field whose number must be less than this one
    usual: bool | None = None  # whether it is drawn if no random number decides
    least: float = -inf  # least allowed value
    most: float = inf


def _flatten(annotation: Any) -> Iterator[Any]:  # annotations are untyped by nature
    """Yield the leaves and metadata of an annotation, including those of Annotated, unions and tuples."""
    origin = get_origin(annotation)
    if origin is Annotated:
        first, *metadata = get_args(annotation)
        yield from _flatten(first)
        yield from metadata
    elif origin in (Union, types.UnionType, tuple):
        for argument in get_args(annotation):
            if argument is not Ellipsis:
                yield from _flatten(argument)
    elif origin is Literal:
        yield from get_args(annotation)
    else:
        yield annotation


def _is_model(leaf: object) -> TypeGuard[type[Model]]:
    return isinstance(leaf, type) and issubclass(leaf, Model)


@cache
def field_types(model: type[Model]) -> dict[str, FieldType]:
    """Return the fields of a model class by name; a later `Range` of one field replaces an earlier one."""
    fields: dict[str, FieldType] = {}
    for name, info in model.model_fields.items():
        leaves = [*_flatten(info.annotation), *info.metadata]
        lower, most = bounds(leaves)
        fields[name] = FieldType(
            measure=next((leaf for leaf in leaves if isinstance(leaf, Measure)), None),
            drawn=next((leaf for leaf in reversed(leaves) if isinstance(leaf, Range)), None),
            count=next((leaf for leaf in leaves if isinstance(leaf, Count)), None),
            hidden=any(isinstance(leaf, Hidden) for leaf in leaves),
            optional=any(leaf is type(None) for leaf in leaves),
            models=tuple(kind for leaf in leaves if _is_model(leaf) for kind in leaf.variants()),
            words=tuple(leaf for leaf in leaves if isinstance(leaf, str)),
            member=next((leaf.field for leaf in leaves if isinstance(leaf, Member)), ""),
            size=next((leaf.by for leaf in leaves if isinstance(leaf, Sized)), None),
            chance=next((leaf.likelihood for leaf in leaves if isinstance(leaf, Chance)), None),
            above=next((leaf.field for leaf in leaves if isinstance(leaf, Above)), ""),
            usual=next((leaf.present for leaf in leaves if isinstance(leaf, Usually)), None),
            least=lower,
            most=most,
        )
    return fields


@cache
def field_names(model: type[Model]) -> tuple[str, ...]:
    """Return the names of the fields of a model class; reading them from the class takes pydantic longer."""
    return tuple(model.model_fields)


def round_as_stated(model: type[Model], name: str, value: float) -> float:
    """Return a value rounded as the text states that field, so that the stated value is simulated."""
    measure = field_types(model)[name].measure
    return measure.round(value) if measure is not None else value


def parameters(value: Model, prefix: str = "") -> Iterator[Parameter]:
    """Yield every declared number under a value, with its address, in the order of declaration."""
    for name, kind in field_types(type(value)).items():
        address, field_value = f"{prefix}.{name}" if prefix else name, getattr(value, name)
        if kind.measure is not None:
            yield Parameter(address, field_value, kind.measure.of(value), kind.hidden, kind.least < 0.0)
        elif isinstance(field_value, Model):
            yield from parameters(field_value, address)
        elif isinstance(field_value, tuple):
            for index, member in enumerate(field_value):  # type: ignore[reportUnknownArgumentType]
                if isinstance(member, Model):
                    yield from parameters(member, f"{address}.{index}")


MAX_REDRAWS = 20
Choice = Range | Count | tuple[str, ...] | float | int | bool | None
Choices = Mapping[str, Choice]
"""Restrictions of a draw by a recipe, by field or measure name: a `Range` or `Count` to draw from, a tuple of class
names or words to select from (duplicates double the probability), a fixed value, or the probability of an optional
field.
"""


def draw(model: type[M], rng: np.random.Generator, choices: Choices, given: Mapping[str, object] | None = None) -> M:
    """Return a random value of a model class with the fields `given`; numbers are rounded as texts state them.

    `choices` overrides the declarations of the class, by ``Class.field``, field or measure name, most specific first.
    Values that validators reject are drawn again.

    Raises:
        SceneError: a number has no range, or no valid value was drawn within the budget.
    """
    return _accepted(model, rng, choices, given or {}, {})


def _accepted(
    model: type[M], rng: np.random.Generator, choices: Choices, given: Mapping[str, object], around: Mapping[str, Any]
) -> M:
    """Draw values until the validators of the class accept one; `around` has the earlier values of its container."""
    refused = ""
    for _ in range(MAX_REDRAWS):
        try:
            return _drawn(model, rng, choices, given, around)
        except ValidationError as error:
            refused = error.errors()[0]["msg"]
    raise SceneError(model.__name__, f"nothing valid in {MAX_REDRAWS} draws: {refused}", "widen a range")


def _drawn(
    model: type[M], rng: np.random.Generator, choices: Choices, given: Mapping[str, object], around: Mapping[str, Any]
) -> M:
    values, absent, fields = dict(given), dict[str, object](), model.model_fields
    for name, kind in field_types(model).items():
        if name in values:
            continue
        info = fields[name]
        if (kind.optional or not info.is_required()) and not _is_there(model, name, rng, choices):
            absent[name] = info.get_default(call_default_factory=True)
            continue
        values[name] = _draw_field(model, name, rng, choices, {**around, **absent, **values})
    return model(**values | _kept(model, model.fitted(values, rng), choices, given))


def _is_there(model: type[Model], name: str, rng: np.random.Generator, choices: Choices) -> bool:
    """Return whether to draw an optional field, by the recipe's choice, the field's mark or probability."""
    kind = field_types(model)[name]
    chance = _choice(choices, f"{model.__name__}.{name}?", f"{name}?")
    if chance is None and kind.usual is not None:
        return kind.usual
    chance = kind.chance if chance is None else chance
    if chance is None and not kind.optional:
        chosen = _chosen(model, name, kind, choices) is not None
        chance = 1.0 if kind.drawn or kind.models or chosen else 0.0
    return rng.random() < float(chance or 0.0)  # type: ignore[arg-type]


def _kept(
    model: type[Model], fitted: Mapping[str, object], choices: Choices, given: Mapping[str, object]
) -> dict[str, object]:
    """Return the fitted values except those that were given or chosen by the recipe."""
    types, free = field_types(model), fitted.keys() - given.keys()
    chosen = {name: _chosen(model, name, types[name], choices) for name in free}
    return {name: fitted[name] for name in fitted if name in free and isinstance(chosen[name], Count | None)}


def _chosen(model: type[Model], name: str, kind: FieldType, choices: Choices) -> Choice:
    """Return the recipe's choice for a field."""
    return _choice(choices, f"{model.__name__}.{name}", name, *((kind.measure.name,) if kind.measure else ()))


def _choice(choices: Choices, *names: str) -> Choice:
    return next((choices[name] for name in names if name in choices), None)


def _draw_field(
    model: type[Model], name: str, rng: np.random.Generator, choices: Choices, known: Mapping[str, Any]
) -> object:
    """Return a random value for a field, given the `known` values of earlier fields."""
    kind = field_types(model)[name]
    picks = _chosen(model, name, kind, choices)
    if kind.measure is not None:
        choice = kind.drawn if picks is None else picks  # a choice of 0.0 is a choice
        if isinstance(choice, Range):
            return kind.measure.draw(rng, choice.low, choice.high)
        if isinstance(choice, float | int):
            return float(choice)
        remedy = "declare a Range or let the recipe choose"
        raise SceneError(f"{model.__name__}.{name}", "has no range to be drawn from", remedy)
    if kind.words:
        words = picks if isinstance(picks, tuple) else kind.words
        return words[int(rng.integers(len(words)))]
    if kind.member:
        return int(rng.integers(max(len(known[kind.member]), 1)))  # one that nothing has is refused, and drawn again
    names = picks if isinstance(picks, tuple) else tuple(variant.__name__ for variant in kind.models)
    allowed = [variant for name in names for variant in kind.models if variant.__name__ == name]

    def one() -> Model:
        return _accepted(allowed[int(rng.integers(len(allowed)))], rng, choices, {}, known)

    count = picks if isinstance(picks, Count) else kind.count
    if kind.count is None or count is None:
        return one()
    size = kind.size(known) if kind.size is not None else int(rng.integers(count.low, count.high + 1))
    if kind.count.alike:
        allowed = [allowed[int(rng.integers(len(allowed)))]]
    return tuple(one() for _ in range(size))


def replace_valid(value: M, **fields: object) -> M:
    """Return a copy with some fields replaced by values with which it is known to be valid."""
    known = value.__dict__
    return type(value).model_construct(None, **{name: known[name] for name in field_names(type(value))} | fields)


def replace_validated(value: M, **fields: object) -> M:
    """Return a copy with some fields replaced, validated again."""
    known = value.__dict__
    current = {name: known[name] for name in field_names(type(value))}
    return type(value)(**{**current, **fields})
