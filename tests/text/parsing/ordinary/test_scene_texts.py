"""Tests that a scene in ordinary English is parsed, or rejected with the most similar sentence of the grammar."""

import re

import pytest

import sim2reason
from sim2reason.errors import TextError
from sim2reason.text.parsing import parse_scene
from sim2reason.text.parsing.ordinary.content import forms
from sim2reason.text.parsing.ordinary.equivalents import find_nearest_form, recast_text
from sim2reason.text.prose.description import describe

G = "Take g = 9.8 m/s²."
ATWOOD = (
    "A light string is tied to block A of mass {} kg; it runs straight up, passes over a light fixed pulley and runs"
    " straight down to block B of mass {} kg. The motion starts from rest with the string taut. The pulley is"
    f" frictionless, and every string is long enough. {G}"
)
HALF = (
    "Block A of mass {} kg lies on a smooth, fixed horizontal plane. A light string tied to block A runs to the right"
    " along the plane, passes over a light fixed pulley and runs straight down to block B ({} kg). Everything"
    " is released from rest with the string taut. There is no friction at the pulley, and every string is long"
    f" enough. {G}"
)
RAMP = (
    "A block of mass {} kg lies on a smooth, fixed plane inclined at {}° to the horizontal."
    f" The motion starts from rest. {G}"
)
FLOOR = (
    "A block of mass {} kg lies on a rough, fixed horizontal plane. The coefficient of friction (static and kinetic)"
    f" on this plane is {{}}. At t = 0 the block moves to the right along the plane at speed {{}} m/s. {G}"
)
THROW = (
    "At t = 0 a small ball of mass {} kg is thrown from a point {} m above level ground at speed {} m/s {}."
    f" Let the x axis point forward and the y axis straight up. Air resistance is negligible. {G}"
)
FROM_GROUND = THROW.replace("{} m above", "on")
SWING = (
    "A small ball of mass {} kg hangs from a fixed point by a light inextensible string of length {} m. Initially the"
    f" string is taut and makes an angle of {{}}° with the downward vertical. The motion starts from rest. {G}"
)
ABOVE = "at an angle of {}° above the horizontal"

UNDERSTOOD = {
    "A block of mass 3.0 kg rests on a frictionless incline that makes an angle of 30° with the horizontal."
    " The block is released from rest.": RAMP.format(3.0, 30),
    "The block is released from rest. A block of mass 3.0 kg lies on a smooth incline of 30°.": RAMP.format(3.0, 30),
    "A 1.2-kg block lies on a frictionless 25° incline. It is released from rest.": RAMP.format(1.2, 25),
    "A block with a mass of 1.5 kg is released from rest on a smooth ramp inclined at 20° to the horizontal."
    " Take g = 9.81 m/s².": RAMP.format(1.5, 20).replace("9.8 ", "9.81 "),
    "Two blocks of masses 2.0 kg and 3.0 kg hang from the ends of a light string that passes over a frictionless,"
    " massless pulley. The system is released from rest.": ATWOOD.format(2.0, 3.0),
    "Two masses of 3.0 kg and 5.0 kg are connected by a light rope that passes over a frictionless pulley."
    " They are released from rest.": ATWOOD.format(3.0, 5.0),
    "A block of mass 4.0 kg lies on a smooth horizontal table. It is connected by a light string over a pulley at the"
    " edge of the table to a hanging block of mass 1.5 kg. The system is released from rest.": HALF.format(4.0, 1.5),
    "A block (2 kg) rests on a smooth horizontal table and is connected by a light string over a frictionless pulley"
    " at the edge to a hanging mass of 1 kg. The system is released from rest.": HALF.format(2, 1),
    "A 5.0 kg crate sits on a rough horizontal floor. The coefficient of friction between the crate and the floor is"
    " 0.30. The crate is given an initial speed of 4.0 m/s to the right.": FLOOR.format(5.0, "0.30", 4.0),
    "Block A (m = 2 kg) is on a horizontal surface, µ = 0.3. It is launched to the right at 4 m/s.": FLOOR.format(
        2, 0.3, 4
    ),
    "A ball of mass 0.50 kg is thrown from the top of a 20 m high cliff with a speed of 15 m/s at an angle of 40°"
    " above the horizontal. Air resistance is negligible.": THROW.format("0.50", 20, 15, ABOVE.format(40)),
    "A ball of mass 0.2 kg is thrown horizontally at 12 m/s from the top of a building 45 m high. Neglect air"
    " resistance.": THROW.format(0.2, 45, 12, "horizontally"),
    "A ball of mass 150 g is projected from level ground with an initial speed of 25 m/s at 35° above the horizontal."
    " Ignore air resistance.": FROM_GROUND.format(0.15, 25, ABOVE.format(35)),
    "Ignore air resistance. A 0.15 kg ball is thrown from ground level at an angle of 50° above the horizontal with a"
    " speed of 18 m/s.": FROM_GROUND.format(0.15, 18, ABOVE.format(50)),
    "A simple pendulum consists of a bob of mass 0.30 kg at the end of a light string of length 1.2 m. The bob is"
    " released from rest with the string at 25° to the vertical.": SWING.format("0.30", 1.2, 25),
    "A bob of mass 0.25 kg is suspended from a fixed point by a massless string of length 80 cm. The string initially"
    " makes an angle of 40° with the vertical. The bob is released from rest.": SWING.format(0.25, 0.8, 40),
    "A uniform solid sphere of radius 0.10 m and mass 2.0 kg is placed on an incline at 30° to the horizontal. It"
    " rolls without slipping and starts from rest.": "A uniform solid sphere of radius 0.10 m and mass 2.0 kg is put on"
    " a stationary plane inclined at 30° to the horizontal and can roll straight up or down the slope. It rolls"
    f" without slipping. The motion starts from rest. {G}",
    "There is a uniform electric field of 30 N/C in the positive x direction. A bead of mass 6.0 mg and charge 1.0 µC"
    " is released from rest at the origin. There is no gravity.": "A uniform electric field of strength 30 N/C points"
    " in the positive x direction. At t = 0 a small bead of mass 6.0 mg with a positive charge of 1.0 µC is released"
    " from rest at the origin of the x-y plane. There is no gravity.",
}

REFUSED = {
    "A 2-kg block slides on a rough horizontal floor. The coefficient of kinetic friction between the block and the"
    " floor is 0.25.": (2, r"0\.25"),
    "A 0.40-kg block on a frictionless horizontal surface is attached to a wall by a spring of force constant"
    " 80 N/m.": (1, r"0\.40 kg.*80 N/m"),
    "A mass of 200 g hangs from a vertical spring whose spring constant is 25 N/m.": (1, r"ceiling.*0\.2 kg.*25 N/m"),
    "A green ball is thrown straight up from the ground at 20 m/s.": (1, "20 m/s straight up"),
    "Two blocks of masses 2.0 kg and 5.0 kg lie on the two sides of a double incline with angles of 30° and 45°.": (
        1,
        "30°",
    ),
    "A rocket with an initial mass of 1000 kg, of which 800 kg is fuel, starts from rest in deep space.": (
        1,
        r"1000 kg \(\$.*\$ without its fuel\)",
    ),
    "There is no gravity. A proton enters a uniform magnetic field of 0.50 T with a velocity of 2.0e6 m/s"
    " perpendicular to the field.": (2, r"field of strength 0\.50 T"),
}


@pytest.mark.parametrize("text", UNDERSTOOD)
def test_an_ordinary_wording_is_the_same_scene(text: str) -> None:
    """The text is read as the same scene as the library's own wording."""
    found, wanted = parse_scene(text).scene, parse_scene(UNDERSTOOD[text]).scene
    assert describe(found).text == describe(wanted).text


@pytest.mark.parametrize("text", REFUSED)
def test_others_are_refused_with_the_nearest_sentence(text: str) -> None:
    """The error names the sentence and shows the nearest one of the library with the numbers of the text."""
    index, near = REFUSED[text]
    with pytest.raises(TextError, match=rf"^sentence {index}: .* is not understood; the nearest that is: .*{near}"):
        parse_scene(text)


@pytest.mark.parametrize(
    "text",
    [
        "A block of mass 3.0 kg does not rest on a frictionless incline of 30°. The block is released from rest.",
        "A block of mass 3.0 kg rests on half a frictionless incline of 30°. The block is released from rest.",
        "A block of mass 3.0 kg rests on a frictionless incline of 30°.",
        "A block of mass 3.0 kg rests on a frictionless incline of 30°. It is released from rest. It is blue.",
        "A 3.0 kg block lies on a frictionless 25° incline. It is released from rest. It moves up the slope at 2 m/s.",
        (
            "A small ball of mass 0.2 kg hangs from a fixed point by a light string of length 1.2 m. The ball is not"
            " released from rest with the string at 25° to the vertical."
        ),
        "A 1.2-kg block lies on a frictionless 25° incline. It starts not from rest.",
        "A ball of mass 0.2 kg is thrown down at 12 m/s from the top of a building 45 m high. Neglect wind.",
    ],
)
def test_what_says_more_or_less_is_refused(text: str) -> None:
    """A word that no sentence of the library has, or a missing fact, leads to an error."""
    with pytest.raises(TextError):
        parse_scene(text)


def test_the_order_of_bodies_and_ways_matters() -> None:
    """Left isn't taken for right, nor the block above for the one below."""
    text = "A 2 kg block lies on a smooth horizontal floor. It moves to the {} at 4 m/s."
    assert "to the right along the plane" in describe(parse_scene(text.format("right")).scene).text
    with pytest.raises(TextError, match="is not understood"):  # the library has positive speeds to the right only
        parse_scene(text.format("left"))
    near = find_nearest_form("Slab A (2 kg) lies on top of slab B (3 kg), which lies on a smooth horizontal floor.")
    assert near is None or "A (3 kg)" not in near


def test_forms_say_what_the_library_says() -> None:
    """All forms differ, and a text is rephrased in the library's words."""
    assert len(forms()) == len({form.text for form in forms()})
    told = next(
        recast_text(["The block is released from rest.", "A 3.0 kg block lies on a frictionless incline of 30°."])
    )
    assert told.from_rest
    assert re.fullmatch(r"A block .*3\.0 kg.* smooth.* plane inclined at 30° to the horizontal\.", told.sentences[0])


def test_the_public_function_reads_them() -> None:
    """`sim2reason.parse_scene` reads ordinary English, too."""
    found = sim2reason.parse_scene("A 1.2-kg block lies on a frictionless 25° incline. It is released from rest.")
    assert found.names == {"the block": "e1.blocks.0", "the plane": "e1.plane"}


def test_a_prompt_may_be_in_ordinary_english_throughout() -> None:
    """Scene and question are both understood, and the answer is that of the closed form."""
    story = "A 1.2-kg block lies on a frictionless 30° incline. It is released from rest."
    asked = "What is the speed of the block after 2.0 s?"
    read = sim2reason.parse_prompt(
        f"{story} {asked} Give your answer in m/s, to three significant figures, inside \\boxed{{}}."
    )
    assert read.answer == pytest.approx(9.8)
