"""Tests of a prestrained and damped spring between two carriages: closed forms, texts, files, both engines."""

from itertools import product
from math import sqrt

import numpy as np
import pytest

from joined_entities import Followed, close, scene
from sim2reason.scenes.bodies.blocks import Carriage
from sim2reason.scenes.connections.two_ended import SpringConnection
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.template import Wordings
from sim2reason.scenes.entities.pendulums import SliderMass
from sim2reason.text.prose.description import describe
from told import certified, check_told, check_whole

ONE, OTHER, K = 0.8, 2.0, 90.0
MU = ONE * OTHER / (ONE + OTHER)
SEEDS = range(8)


def joined(**more: object) -> Scene:
    """Build two carriages on a rail, with a spring between them."""
    ends = (("one", SliderMass.right), ("other", SliderMass.left))
    spring = SpringConnection.between(*ends, stiffness=K, **more)  # type: ignore[arg-type]  # pydantic checks them
    masses = {"one": ONE, "other": OTHER}
    return scene({name: SliderMass(carriage=Carriage(mass=mass)) for name, mass in masses.items()}, spring)


def stretch(made: Scene, until: float, count: int) -> tuple[Followed, np.ndarray, np.ndarray]:
    """Return the motion, the growth of the spring since the start and the rate of that growth."""
    found = Followed(made, until, count)
    one, other = "one.carriage.slide", "other.carriage.slide"
    return found, found.q(other) - found.q(one), found.v(other) - found.v(one)


@pytest.mark.parametrize(("strained", "sign"), [("stretched", 1.0), ("compressed", -1.0)])
def test_two_carriages_swing_against_each_other(strained: str, sign: float) -> None:
    """The strain is s = ±d cos ωt, ω² = k/µ, from µ s″ = −k s, and m₁x₁ + m₂x₂ stays 0."""
    d, omega = 0.15, sqrt(K / MU)
    found, grown, rate = stretch(joined(strained=strained, by=d), 2.0, 101)
    strain = sign * d * np.cos(omega * found.times)
    close(sign * d + grown, strain)
    close(rate, -sign * d * omega * np.sin(omega * found.times))
    close(found.tension("spring_1"), K * strain)
    close(ONE * found.q("one.carriage.slide") + OTHER * found.q("other.carriage.slide"), 0.0, d)


def test_a_dashpot_damps_the_swing() -> None:
    """The solution of µ s″ + b s′ + k s = 0 is damped.

    s = d e^(−γt) (cos ωt + (γ/ω) sin ωt), γ = b/2µ, ω² = k/µ − γ².
    """
    d, b = 0.2, 1.6
    gamma = b / (2.0 * MU)
    omega = sqrt(K / MU - gamma**2)
    found, grown, rate = stretch(joined(by=d, damping=b), 2.0, 101)
    t = found.times
    strain = d * np.exp(-gamma * t) * (np.cos(omega * t) + gamma / omega * np.sin(omega * t))
    close(d + grown, strain)
    close(found.tension("spring_1"), K * strain + b * rate)


def test_the_dashpot_takes_the_energy_that_is_lost() -> None:
    """The loss is ½k d² − ½k s² − ½µ s′² = ∫ b s′² dt, the centre of mass being at rest.

    The integral is taken by Simpson's rule over 4,000 intervals.
    """
    d, b = 0.2, 1.6
    _, grown, rate = stretch(joined(by=d, damping=b), 1.0, 4001)
    weights = np.ones(4001)
    weights[1:-1:2], weights[2:-1:2] = 4.0, 2.0
    energy = 0.5 * K * (d + grown) ** 2 + 0.5 * MU * rate**2
    close(energy[0] - energy[-1], weights @ (b * rate**2) / 4000.0 / 3.0)


@pytest.mark.parametrize("seeds", [SEEDS[:2], pytest.param(SEEDS, marks=pytest.mark.slow)], ids=len)
@pytest.mark.parametrize(
    ("strain", "damping"), [*product([{}, {"by": 0.15}, {"strained": "compressed", "by": 0.15}], [0.0, 1.6])]
)
def test_texts_and_files_lead_back(strain: dict[str, object], damping: float, seeds: range) -> None:
    made = joined(**strain, damping=damping)
    wanted = f"{strain.get('strained', 'stretched')} by 0.15 m" if strain else "relaxed"
    for seed in seeds:
        check_told(made, seed)
        check_whole(made, seed)
        text = describe(made, seed).text.lower()
        assert wanted in text
        assert ("dashpot of damping constant 1.6" in text) == (damping > 0.0)


@pytest.mark.parametrize("damping", [0.0, 1.6])
def test_both_engines_agree(damping: float) -> None:
    assert certified(joined(by=0.15, damping=damping))


def test_a_relaxed_spring_is_neither_stretched_nor_compressed() -> None:
    with pytest.raises(ValueError, match="a spring strained by 0 is relaxed"):
        joined(strained="compressed")


def test_a_wording_whose_words_leave_a_number_out_is_refused() -> None:
    said = Wordings(("a spring of stiffness {stiffness}, {strain}, joins {a} to {b}.",))
    with pytest.raises(TypeError, match="leaves damping unsaid"):
        type("Bare", (SpringConnection,), {"says": said, "__module__": __name__})
