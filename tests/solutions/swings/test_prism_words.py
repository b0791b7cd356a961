"""Why a prism that tips over its edges has its moment of inertia, gets over each edge, and turns its velocity."""

from worked import solution_text


def test_the_geometry_of_a_tipping_prism_is_told() -> None:
    text = solution_text("rolling-hard-multipart-301917-2")
    assert "into 10 equal triangles" in text
    assert r"is turned uphill by $\frac{\pi}{10}$ from the perpendicular to the plane" in text
    assert "The axis passes over each edge, since the least kinetic energy" in text
    assert "The initial and the final velocity therefore make the angle $\\phi_1$." in text
    assert r"at the angle $\frac{\pi}{5}$ to its direction just after." in text
