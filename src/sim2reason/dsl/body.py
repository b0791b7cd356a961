"""Bodies: frozen values with parameters, a noun, a series of letters and ways to be introduced."""

from collections.abc import Mapping
from typing import Any, ClassVar, Literal, TypeVar

from sim2reason.dsl.looks import BodyLook
from sim2reason.dsl.model import Model, field_types
from sim2reason.dsl.template import Word, slots
from sim2reason.registry import Registry

Matter = Literal["solid", "planet"]


class Body(Model):
    """The base of all bodies. A subclass declares its numbers as fields and its words as class data.

    `lone` introduces the only one of its series, `again` one more that has no letter either, by default as *another*,
    `named` one that has a letter, `listed` one inside a list that begins with the plural noun, `alike` all of such a
    list at once, after their letters, where their numbers agree. All ways to introduce a body say the same numbers;
    what they leave out, the entity's lines must say.
    """

    nouns: ClassVar[tuple[str, ...]] = ()
    letters: ClassVar[str] = "ABCDEFGHIJKLMN"  # "": never lettered, spoken of only beside its introduction
    lone: ClassVar[tuple[str, ...]] = ()
    again: ClassVar[tuple[str, ...]] = ()
    named: ClassVar[tuple[str, ...]] = ()
    listed: ClassVar[str] = ""
    alike: ClassVar[str] = ""
    words: ClassVar[dict[str, Word]] = {}
    matter: ClassVar[Matter] = "solid"  # of which it is, which says what densities are plausible
    symbols: ClassVar[dict[str, str]] = {}  # where a number's symbol is not that of its measure

    @property
    def look(self) -> BodyLook | None:
        """How a drawing shows it; None where its class declares nothing, and a drawing says so."""
        return None

    def suits(self, noun: str, bodies: Mapping[str, "Body"]) -> bool:
        """Return whether one of its nouns is apt for it among all `bodies` of a scene, by address; by default True."""
        del noun, bodies
        return True

    @property
    def density(self) -> float | None:
        """Its mean density, kg/m³; None where the text does not say how large it is."""
        return None

    @classmethod
    def __pydantic_init_subclass__(cls, **_: Any) -> None:
        """Refuse a body whose words and numbers do not fit; TypeError says what is amiss."""
        if not cls.nouns:
            return
        introductions = [*cls.lone, *cls.again, *cls.named, *filter(None, (cls.listed, cls.alike))]
        if len(cls.lone) < 2 or (cls.letters and len(cls.named) < 2):
            raise TypeError(f"{cls.__name__}: a body needs at least two ways to be introduced")
        said = {template: cls.says_in(template) for template in introductions}
        if len({frozenset(numbers) for numbers in said.values()}) > 1:
            raise TypeError(f"{cls.__name__}: its introductions say different numbers: {said}")

    @classmethod
    def says_in(cls, template: str) -> set[str]:
        """The parameters that a template of this body tells, by number or by word; TypeError for an unknown name."""
        told: set[str] = set()
        for slot in slots(template):
            if slot.kind == "text" or slot.path in ("letter", "noun"):
                continue
            if slot.path in cls.words:
                word = cls.words[slot.path]
                inner = [*word.special.values(), word.otherwise]
                told |= set[str]().union(*(cls.says_in(text) for text in inner))
                told |= {word.parameter} if word.otherwise and cls.says_in(word.otherwise) else set()
            elif slot.path in field_types(cls):
                told.add(slot.path)
            else:
                problem = f"names {slot.path!r}, which is neither a parameter nor a word"
                raise TypeError(f"{cls.__name__}: {template!r} {problem}")
        return told

    @classmethod
    def introduced_words(cls) -> tuple[Word, ...]:
        """The words that every introduction uses: what they can say specially need not be said again."""
        return tuple(
            word
            for name, word in cls.words.items()
            if all(f"{{{name}}}" in template for template in (*cls.lone, *cls.named))
        )

    def told_by_word(self, parameter: str) -> bool:
        """Whether this body's introduction tells a number by a special word, as smooth tells µ = 0."""
        value = getattr(self, parameter)
        return any(word.parameter == parameter and value in word.special for word in self.introduced_words())


B = TypeVar("B", bound=Body)
BODIES: Registry[type[Body]] = Registry("bodies")


def body(cls: type[B]) -> type[B]:
    """Enter a body class under its name."""
    return BODIES.add(cls.__name__, cls)
