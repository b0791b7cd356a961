"""Tests of paraphrases of clauses and main clauses, which require a meaning for every word."""

import pytest

from sim2reason.questions.ordinary.base_forms import paraphrased as plain_clauses
from sim2reason.questions.ordinary.base_forms import with_base_forms
from sim2reason.questions.ordinary.paraphrases import paraphrased as plain_mains


def test_words_are_in_base_forms_and_auxiliaries_left_out() -> None:
    """Adverbs that change neither the moment nor the value are left out as well."""
    assert with_base_forms("@0@ has just been sliding and exactly then hits wall") == "@0@ slide and hit wall"


@pytest.mark.parametrize(
    ("clause", "plain"),
    [
        ("@0@ has come to complete standstill", "@0@ stops"),
        ("@0@ finally comes to rest", "@0@ finally stops"),
        ("motion is over", "finally stops"),
        ("@0@ stops moving upwards", "@0@ stops going up"),
        ("@0@ is back at place from which it was launched", "@0@ returns"),
        ("@1@ swings through vertical", "@1@ passes through vertical"),
        ("it turns back for first time", "stops"),
        ("its second collision", "its second collision"),
        ("collision with @1@", "meets @1@"),
        ("@0@ has descended by #0#", "@0@ falls #0#"),
        ("@1@ has slid #0# along @0@", "@1@ moves #0# relative to @0@"),
        ("@0@ is falling with vertical speed of #0#", "@0@ falls with vertical speed of #0#"),
        ("@0@ passes x = −#0#", "@0@ at x = -#0#"),
        ("all fuel has been used up", "burnout"),
        ("#0# into motion", "t = #0#"),
        ("#0# after @1@ are let go", "t = #0#"),
        ("#0# after @0@ leaves origin", "t = #0#"),
        ("@0@ starts to move", "@0@ sets off"),
        ("@0@ is #0# above ground", "@0@ at height of #0#"),
        ("@0@ has descended vertical distance of #0#", "@0@ falls #0# vertically"),
        ("@0@ crosses y axis", "@0@ crosses y axis"),
        ("@0@ is moving fastest", "@0@ fastest"),
        ("@0@ 's speed has doubled", "speed of @0@ double times at first"),
        ("@0@ comes to rest on other side", "@0@ stops on other side"),
        ("@0@ lifts off", "@0@ leaves surface"),
        ("everything has come to rest", "finally stops"),
        ("@0@ is back at height from which @0@ was thrown", "@0@ back at its height"),
        ("@0@ runs into wall", "@0@ bounces"),
        ("@0@ is inclined at #0# to vertical", "@0@ makes #0# with vertical"),
        ("@0@ is moving parallel to y axis", "@0@ moves parallel to y axis"),
        ("@0@ has completed its first full turn", "@0@ makes one revolution"),
        ("@0@ reaches its turning point", "@0@ stops"),
        ("@0@ is back where @0@ was at start", "@0@ returns"),
        ("@0@ stays at rest", "@0@ finally stops"),
        ("@0@ has burnt #0# of fuel", "@0@ burns #0# of fuel"),
        ("@0@ 's extension is greatest", "@0@ most stretched"),
        ("@1@ has slid #0# down left face", "@1@ moves #0# relative to carrier"),
    ],
)
def test_clauses_are_said_plainly(clause: str, plain: str) -> None:
    """A clause is reworded as a plain clause in the tables."""
    assert plain in plain_clauses(clause)


@pytest.mark.parametrize(
    "clause",
    [
        "@0@ is not moving",
        "half of fuel is used up",
        "@0@ falls from its highest point to ground",
        "@0@ stops and sings",
        "@0@ is #0# above its highest point",
        "@0@ passes its starting point with glee",
        "@0@ 's mass has doubled",
        "@0@ is inclined at #0# to its rope",
        "@0@ is moving parallel to its friend",
        "@0@ has completed its second turn",
    ],
)
def test_a_clause_with_a_word_that_matters_is_left_alone(clause: str) -> None:
    """A clause with an unknown word is not reworded, whatever its main words are."""
    assert list(plain_clauses(clause)) == []


@pytest.mark.parametrize(
    ("question", "plain"),
    [
        ("how fast does @0@ move at most", "what is greatest speed of @0@"),
        ("with what acceleration does @0@ slide across floor", "what is acceleration of @0@"),
        ("what friction force does inclined plane exert on @0@", "what friction of ground on @0@"),
        ("what distance from origin has @0@ reached", "how far is @0@ from its starting point"),
        ("how far to right of its starting point does @0@ get", "how far does @0@ move to right"),
        ("by how much has @0@ risen", "how far does @0@ rise"),
        ("find shortest length of @0@", "what is shortest length of @0@"),
        ("how much energy is lost to friction altogether", "how much energy is lost to friction"),
        ("at what angle below horizontal is @0@ moving", "what angle @0@ makes below horizontal"),
        ("how fast is @0@ moving relative to @1@", "how fast does @0@ move relative to @1@"),
        ("how long does @0@ take to complete one circle", "what is period of @0@"),
        ("how long does @0@ take to go round @1@ once", "what is period of @0@ about @1@"),
        ("with what force plane supports @0@", "what normal force of ground on @0@"),
        ("with what force does floor push up on @0@", "what upward force of ground on @0@"),
        ("how many revolutions does @0@ make", "how many turns does @0@ make"),
        ("by how much does kinetic energy of @0@ increase", "how much kinetic energy does @0@ gain"),
        ("how far altogether has @0@ slid", "how far altogether does @0@ move"),
        ("with what acceleration does @0@ start off", "what is initial acceleration of @0@"),
        ("how eccentric is @0@ 's orbit", "what is eccentricity of @0@"),
        ("what resultant force does @0@ exert on @1@", "what force of string on pulley @0@ @1@"),
        ("with what force does axle hold @0@", "what force bears axle @0@"),
        ("what pull acts on fixed hook", "what force on hook"),
        ("how large is horizontal force that vertical guide exerts on @0@", "what force of guide on @0@"),
        ("what is amplitude of its oscillation", "what is amplitude"),
        ("to what maximum height above ground does @0@ climb", "how high does @0@ rise above ground"),
        ("determine time for one complete swing", "what is period"),
        ("how long is @0@ in motion", "how long is @0@ moving"),
        ("how short does @0@ get", "what is shortest length of @0@"),
        ("how much energy has friction taken from @0@", "how much energy is lost to friction"),
        ("how far below its starting point , measured along slope , is @0@", "how far down is @0@"),
    ],
)
def test_main_clauses_are_said_plainly(question: str, plain: str) -> None:
    """A main clause is reworded as a plain one in the tables."""
    assert plain in plain_mains(question)


@pytest.mark.parametrize(
    "question",
    ["what would speed of @0@ be", "what is average speed of @0@", "how much more energy is lost to friction",
     "what is least speed with which @0@ goes", "what force does @0@ exert on floor of @1@",
     "what is greatest distance between @0@ and @0@", "how far does @0@ stretch"],
)  # fmt: skip
def test_a_main_clause_with_a_word_that_matters_is_left_alone(question: str) -> None:
    """A main clause with an unknown word is not reworded, whatever it asks for."""
    assert list(plain_mains(question)) == []
