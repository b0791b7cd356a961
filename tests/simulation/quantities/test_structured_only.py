"""Tests of the quantities that only structured questions use, against closed forms."""

from functools import cache
from math import atan2, cos, degrees, pi, radians, sin, sqrt
from pathlib import Path

import pytest

from sim2reason.errors import TextError
from sim2reason.questions.following import simulate_scene
from sim2reason.questions.posing import pose_question
from sim2reason.questions.prompt import words_of
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.scenes.dsl.state import displace
from sim2reason.scenes.files import load
from sim2reason.text.prose.description import describe

SCENES = Path(__file__).parents[2] / "data" / "ordinary_scenes"
G, YEAR = 9.8, 4.0 * pi**2
ROLLED = (2.3 * 0.01 - 0.5 * 5.0 / 7.0 * G * sin(radians(42.0)) * 0.01**2) / (2.0 * pi * 0.12)
"""The turns that a sphere of radius 0.12 m, rolling up at 2.3 m/s, makes in 0.01 s."""


@cache
def found(name: str, find: str, of: str, when: str) -> float:
    """Return the answer to a structured question, in the units of the scene."""
    scene = load(SCENES / f"{name}.yaml")
    motion, words = simulate_scene(scene), words_of(describe(scene))
    answer = pose_question(StructuredQuestion(find, of, when), motion, words).simulate_answer(motion).answer
    assert answer is not None
    return answer


def landing() -> float:
    """Return the angle, in degrees, at which a ball comes down that is thrown from 3.5 m at 4.5 m/s, 69° upwards."""
    across, up = 4.5 * cos(radians(69.0)), 4.5 * sin(radians(69.0))
    return degrees(atan2(sqrt(up**2 + 2.0 * G * 3.5), across))


def eccentricity() -> float:
    """Return the eccentricity of planet A's orbit, from its energy and angular momentum."""
    x, y, vx, vy, strength = 0.34, -0.03, 0.51, 11.7, 1.2 * YEAR
    energy, turning = 0.5 * (vx**2 + vy**2) - strength / sqrt(x**2 + y**2), x * vy - y * vx
    return sqrt(1.0 + 2.0 * energy * turning**2 / strength**2)


PULLED = 0.96 * 1.2 * G * (1.0 + sin(radians(32.0))) / (0.96 + 1.2)
"""The tension between a block that hangs and one on a smooth plane."""
SWUNG = 2.0 * G * 0.24 / (0.4 * 0.18**2 + 0.24**2)
"""The square of the angular speed with which a sphere on an arm passes its lowest point, from level."""
SOLID, HOLE = 3.8 * 0.19**2 / (0.19**2 - 0.12**2), 3.8 * 0.12**2 / (0.19**2 - 0.12**2)
BORED = 0.5 * SOLID * 0.19**2 - HOLE * (0.5 * 0.12**2 + 0.041**2)

RADIUS = 4.4 * 2.9 / (2.3 * 0.55)
"""The radius of the circle of a bead in a magnetic field that leaves the origin, in m."""

FACE = radians(36.0)  # of a decagonal prism, as seen from its axis
CENTRAL = 0.1**2 * (2.0 + cos(FACE)) / 6.0
EDGE = CENTRAL + 0.1**2
"""The moment of inertia about an edge, per mass, of a decagonal prism with its edges 0.10 m from its axis, m²."""
TUMBLED = sqrt(5.3**2 + 2.0 * G * 0.2 * sin(FACE / 2.0) * sin(radians(12.0)) / EDGE)
"""The angular velocity with which its next edge lands on a slope of 12°, in rad/s, from 5.3 rad/s on a face."""


def second_time(height: float) -> float:
    """Return the time at which a ball thrown at 4.5 m/s, 69° upwards, passes a height on its way down.

    The height is above the start.
    """
    up = 4.5 * sin(radians(69.0))
    return (up + sqrt(up**2 - 2.0 * G * height)) / G


@pytest.mark.parametrize(
    ("name", "find", "of", "when", "value"),
    [
        ("lob", "angle with the horizontal", "the ball", "landed before", landing()),
        ("field_circle", "radius of the path", "the bead", "at start", 3.8 * 2.8 / (1.9 * 0.5)),
        ("field_circle", "angle of deflection", "the bead", "3 s", degrees(0.25 * 3.0)),
        ("two_planets", "eccentricity", "system.planets.0 & system.star", "at start", eccentricity()),
        ("slow_launch", "thrust", "the probe", "10 s", 19.0 * 500.0),
        ("slow_launch", "fuel left", "the probe", "10 s", 971.0 - 172.0 - 190.0),
        ("rolled_up", "revolutions made", "the sphere", "0.01 s", ROLLED),
        ("slow_launch", "fuel burnt", "the probe", "10 s", 190.0),
        ("tumbling_prism", "angular velocity", "the prism", "edge landed before", TUMBLED),
        (
            "tumbling_prism",
            "angular velocity",
            "the prism",
            "edge landed",
            TUMBLED * (CENTRAL + 0.1**2 * cos(FACE)) / EDGE,
        ),
        ("arm_on_pulled_trolley", "least deflection", "the arm", "at 5 s", 23.6149679),
        ("trolley_rod", "rod pull", "the rod", "the ball lowest point", 34.1123634987),
        (
            "hemisphere_arm",
            "moment of inertia about the axle",
            "the hemisphere",
            "at start",
            7.9 * (83.0 / 320.0 * 0.16**2 + (0.25 - 0.375 * 0.16) ** 2),
        ),
        ("smooth_load", "force on a pulley", "the pulley", "at start", PULLED * sqrt(2.0 + 2.0 * sin(radians(32.0)))),
        ("swung_sphere", "force on the axle", "the arm", "the sphere lowest point", 6.8 * G + 6.8 * 0.24 * SWUNG),
        ("free_box", "acceleration relative to its carrier", "block A", "at start", 5.11123584506),
        ("smooth_box", "force of the guide", "block B", "at start", 2.0 * 1.29366565),
        ("gliders", "velocity of the centre of mass", "", "2 s", 1.0),
        ("bored_cylinder", "moment of inertia about the axis", "the cylinder", "at start", BORED),
        ("lob", "height above the start", "the ball", "0.2 s", 4.5 * sin(radians(69.0)) * 0.2 - 0.5 * G * 0.2**2),
        ("lob", "time", "", "second height above the start of the ball = 0.5 m", second_time(0.5)),
        (
            "compressed_trolley",
            "velocity",
            "",
            "extension along stretched = 0.05 m",
            sqrt(133.0 / 4.8 * (0.14**2 - 0.05**2)),
        ),
        ("wide_box", "speed relative to its carrier", "block A", "0.4 s", 0.4 * 6.0526071842),
        ("dull_carts", "x coordinate", "cart A", "collided before", -1.44 + 1.18 * 0.46 / (1.18 + 1.43)),
        ("dull_carts", "time", "", "x coordinate of cart A = -1.3 m", 0.14 / 1.18),
        ("dull_carts", "distance from the origin", "cart A", "0.1 s", 1.44 - 0.118),
        ("tilted_table", "y coordinate", "puck A", "0.1 s", 0.15 - 0.059 - 0.5 * G * sin(radians(9.0)) * 0.1**2),
        ("round_orbit", "distance from the origin", "the planet", "at start", sqrt(0.7**2 + 0.35**2)),
        ("origin_circle", "greatest distance from the origin", "the bead", "10.927 s", 2.0 * RADIUS),
        ("origin_circle", "greatest y coordinate", "the bead", "20 s", RADIUS * (1.0 - cos(radians(199.0)))),
        ("origin_circle", "least x coordinate", "the bead", "20 s", -RADIUS * (1.0 - sin(radians(199.0)))),
        ("wide_rod_swing", "distance from the axle", "the rod", "at start", 0.28),
        (
            "boards_and_hand",
            "energy dissipated by friction",
            "board A + board B",
            "0.4 s",
            4.54114031,
        ),
    ],
)
def test_quantities_have_their_closed_forms(name: str, find: str, of: str, when: str, value: float) -> None:
    """The values at one instant agree with closed forms."""
    assert found(name, find, of, when) == pytest.approx(value, rel=1e-6)


def test_bodies_that_do_not_attract_have_a_distance_where_both_move_freely_in_a_plane() -> None:
    """Two planets without mutual attraction have a distance."""
    at_start = found("two_planets", "distance", "system.planets.0 & system.planets.1", "at start")
    assert at_start == pytest.approx(sqrt(0.37**2 + 0.58**2), rel=1e-9)


def test_an_energy_has_no_direction() -> None:
    """The force and extension of a spring have a sign, *along stretched*; its energy has none."""
    scene = load(SCENES / "compressed_trolley.yaml")
    motion, words = simulate_scene(scene), words_of(describe(scene))
    with pytest.raises(TextError, match="no components"):
        pose_question(StructuredQuestion("spring energy", "", "at 0.1 s", "stretched"), motion, words)
    pushes = pose_question(
        StructuredQuestion("spring force", "", "at start", "stretched"), motion, words
    ).simulate_answer(motion)
    assert pushes.answer == pytest.approx(-133.0 * 0.14)


def test_a_subject_stands_after_of() -> None:
    """Without *of* the subject would be read as a part of the quantity's name."""
    scene = load(SCENES / "lob.yaml")
    motion, words = simulate_scene(scene), words_of(describe(scene))
    with pytest.raises(TextError, match="height above the start the ball"):
        pose_question(StructuredQuestion("time", "", "height above the start the ball = 0.5 m"), motion, words)


def test_the_force_on_a_pulley_needs_the_directions_of_the_strings_parts() -> None:
    """The text does not state on which sides two separate planes rise."""
    scene = load(SCENES / "two_facing_planes.yaml")
    motion, words = simulate_scene(scene), words_of(describe(scene))
    with pytest.raises(TextError, match="directions of the string's parts"):
        pose_question(StructuredQuestion("force on a pulley", "the pulley", "at start"), motion, words)


def test_only_stated_axes_have_coordinates() -> None:
    """A thrown ball has no coordinates, as the text states no origin; a cart on a track has no y coordinate."""
    for name, of, find in (("lob", "the ball", "x coordinate"), ("dull_carts", "cart A", "y coordinate")):
        scene = load(SCENES / f"{name}.yaml")
        motion, words = simulate_scene(scene), words_of(describe(scene))
        with pytest.raises(TextError):
            pose_question(StructuredQuestion(find, of, "at start"), motion, words)


def test_coordinates_go_on_where_a_motion_is_begun_again() -> None:
    """Coordinates of displaced bodies still refer to the origin of the text."""
    mechanism = load(SCENES / "dull_carts.yaml").mechanism
    later = displace(mechanism, [0.1, -0.2], [0.0, 0.0])
    assert [place[1] for each in later.coordinates if (place := each.stated)] == pytest.approx([-1.34, -1.18])


@pytest.mark.parametrize(
    ("time", "force"),
    [(0.0, 1.602e-19 * 2000.0), (1e-9, 1.602e-19 * 2000.0), (2.4e-9, 1.602e-19 * 2000.0), (2.6e-9, 0.0)],
)
def test_a_field_in_a_region_acts_there_and_on_its_border_alone(time: float, force: float) -> None:
    """An electron that starts at the edge of plates of 5 cm crosses their field in 2.5 ns."""
    scene = load(SCENES / "crt.yaml")
    motion, words = simulate_scene(scene), words_of(describe(scene))
    asked = pose_question(StructuredQuestion("electric force", when=f"at {time} s"), motion, words)
    assert asked.simulate_answer(motion).answer == pytest.approx(force * 1e6, rel=1e-9)  # in the text's µN
