"""Tests of orbits about a central mass with a given least distance: no eccentricity is needed."""

from sim2reason.solutions import solve_prompt
from sim2reason.testing.solution_text import read

COMET = """A star of mass $M$ is fixed at the origin of the x-y plane; the units are the astronomical unit (au), the \
year (yr) and the solar mass (Msun), in which G = 4π² au³/(Msun yr²). The position of a comet at t = 0 \
is (−0.17 au, 0.35 au), and its velocity is (−10.5 au/yr, −7.50 au/yr). The only force on the comet is \
the attraction of the star. Determine the mass $M$ so that the distance between the comet and the star at \
the moment when the comet first reaches its least distance from the star is 0.332 au. Give your answer \
in Msun, to three significant figures, inside \\boxed{}."""
PLANET = """A star of mass $M$ is fixed at the origin of the x-y plane; with lengths in au, times in years (yr) and \
masses in solar masses (Msun), G = 4π² au³/(Msun yr²). At t = 0 a planet of negligible mass is at the \
point ($x$, $y$) and has the velocity ($v_x$, $v_y$). No force but the attraction of the star acts on the \
planet. Calculate the magnitude of the acceleration of the planet when the line from the star to the \
planet has turned through 180°. Take $M$ = 0.84 Msun, $x$ = −0.95 au, $y$ = 2.67 au, $v_x$ = −1.67 au/yr \
and $v_y$ = −1.23 au/yr. Give your answer in au/yr², to three significant figures, inside \\boxed{}."""


def text_of(prompt: str) -> str:
    """Return the worked solution of a problem after checking all of its numbers."""
    found = solve_prompt(prompt)[0]
    assert found.answer is not None, found.reason
    assert not read(found.text).broken
    return found.text


def test_the_mass_follows_from_a_linear_equation() -> None:
    text = text_of(COMET)
    assert r"conservation of angular momentum its magnitude is $\frac{h}{r}$. By conservation of energy" in text
    assert "eccentricity" not in text
    assert "Inserting" not in text


def test_an_orbit_is_called_a_conic_where_its_energy_is_not_shown() -> None:
    text = text_of(PLANET)
    assert "The orbit is a conic section, whose semi-latus rectum is" in text
    assert "ellipse" not in text
