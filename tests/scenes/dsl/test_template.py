"""Tests of sentence templates, and of errors for classes whose sentences do not match their fields."""

import pytest

from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.simple_machines import Plane
from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.entity import Part
from sim2reason.scenes.dsl.measures import Friction, Mass
from sim2reason.scenes.dsl.ports import End
from sim2reason.scenes.dsl.template import Word, each, either, paths, slots


def test_a_template_is_taken_apart() -> None:
    found = slots("on {plane} {blocks:lies/lie, each on {plane.angle}} {blocks}; {pairs.*.first>blocks} {blocks:#}.")
    assert [slot.kind for slot in found if slot.kind != "text"] == ["path", "agree", "path", "member", "count"]
    assert paths("{a.b} and {c:x/y}") == ("a.b", "c")


@pytest.mark.parametrize(("count", "form"), [(1, "one"), (2, "two"), (3, "more"), (5, "more")])
def test_forms_agree_with_counts(count: int, form: str) -> None:
    (slot,) = slots("{blocks:one/two/more}")
    assert slot.form(count) == form


@pytest.mark.parametrize("template", ["{", "a } b", "{a b}", "{a:b}", "{A}", "{a:b/c/d/e}", "{a?b/c/d}"])
def test_what_is_no_template_is_refused(template: str) -> None:
    with pytest.raises(ValueError, match=r"slot|forms"):
        slots(template)


def test_a_word_tells_special_values() -> None:
    word = Word("friction", {0.0: "smooth"}, "rough")
    assert (word.text(0.0), word.text(0.3), word.text(None)) == ("smooth", "rough", "rough")
    assert Plane(angle=0.0, friction=0.0).is_stated_by_word("friction")
    assert not Plane(angle=0.0, friction=0.2).is_stated_by_word("friction")


TAIL = End(sites=("hook",), arrives="ends at {block}", tied="{block}", leaves="runs up")


def test_a_number_that_no_line_tells_is_a_type_error() -> None:
    with pytest.raises(TypeError, match=r"no line tells plane\.friction"):

        class _Unsaid(Part):
            block: Block
            plane: Plane
            says = ("{block} lies on {plane}.",)


def test_all_wordings_must_tell_the_same() -> None:
    with pytest.raises(TypeError, match=r"no line tells friction"):

        class _Sometimes(Part):
            block: Block
            friction: Friction
            says = (either("{block} slides with {friction}.", "{block} slides."),)


def test_a_clause_tells_only_if_its_port_must_be_used() -> None:
    with pytest.raises(TypeError, match=r"no line tells block\.mass"):

        class _Open(Part):
            block: Block
            tail = TAIL

    class _Closed(Part):
        block: Block
        tail = End(sites=("hook",), arrives="ends at {block}", tied="{block}", leaves="runs up", required=True)

    assert _Closed.tail.name == "tail"


@pytest.mark.parametrize("line", ["{stone} falls.", "{block.speed} is its speed.", "{block} and {stones:a/b}."])
def test_an_unknown_name_is_a_type_error(line: str) -> None:
    with pytest.raises(TypeError, match=r"not declared|does not have"):
        type("_Unknown", (Part,), {"__annotations__": {"block": Block}, "says": ("{block} rests.", line)})


def test_a_line_for_each_of_nothing_is_a_type_error() -> None:
    with pytest.raises(TypeError, match="not declared"):
        type(
            "_Each", (Part,), {"__annotations__": {"block": Block}, "says": ("{block}.", each("stones", "a {block}."))}
        )


def test_a_body_needs_two_introductions_that_tell_the_same() -> None:
    with pytest.raises(TypeError, match="at least two ways"):
        type("_Terse", (Body,), {"__annotations__": {"mass": Mass}, "nouns": ("stone",), "lone": ("a {mass} stone",)})
    with pytest.raises(TypeError, match="different numbers"):

        class _Uneven(Body):
            mass: Mass
            nouns = ("stone",)
            letters = ""
            lone = ("a {mass} stone", "a stone")
