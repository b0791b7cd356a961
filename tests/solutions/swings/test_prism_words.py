"""Tests of prisms that tip over their edges: moment of inertia, passing each edge, and turned velocities."""

from sim2reason.solutions.solve import solve_prompt
from worked import solution_text


def test_the_geometry_of_a_tipping_prism_is_told() -> None:
    text = solution_text("rolling-hard-multipart-301917-2")
    assert "into 10 equal triangles" in text
    assert r"is turned uphill by $\frac{\pi}{10}$ from the perpendicular to the plane" in text
    assert "The axis passes over each edge, since the least kinetic energy" in text
    assert "Just after each landing it has its first direction again; since the last it has turned by $\\phi_1$" in text
    assert r"at the angle $\frac{\pi}{5}$ to its direction just after." in text


def test_the_axis_passes_over_the_edge_of_the_last_landing_too() -> None:
    """The edge of the last landing is checked too, after which the kinetic energy is least."""
    prompt = (
        "On a stationary plane inclined at 9° to the horizontal, on one face and with its axis horizontal, lies a long "
        "uniform regular decagonal prism of mass 5.4 kg whose edges are 0.14 m from its axis. No edge slips on the "
        "plane, and none rebounds when it lands there. It starts with an angular velocity of 5.5 rad/s about its lower "
        "edge, over which it tips. Calculate the magnitude of the acceleration of the prism at the instant at which it "
        "has first turned through 160° from its starting position. (The acceleration due to gravity is g = 9.8 m/s².) "
        "Give your answer in m/s², to three significant figures, inside \\boxed{}."
    )
    found, _ = solve_prompt(prompt)
    assert r"$K_{\text{min}} = \tfrac{1}{2} I \omega_7^{2} = 2.2684\ \text{J}$" in found.text


def test_no_landing_is_told_of_what_only_reaches_its_highest_point() -> None:
    text = solution_text("rolling-hard-multipart-301927-0")
    assert "At the highest point the axis is straight above the edge. By conservation of energy" in text
    assert r"At the start it makes the angle $\frac{\pi}{8} - \theta$ with the vertical, and in the end it is" in text
    assert "landing" not in text
