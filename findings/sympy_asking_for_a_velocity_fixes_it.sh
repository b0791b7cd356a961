#!/usr/bin/env bash
# sympy.physics.mechanics: a point whose velocity was once asked for keeps that velocity when it is
# placed anew.
#
# Package: sympy 1.14.0, Python 3.11. Date: 2026-11-30.
# Expected: the velocity of a point at x = q^2 is 2 q q', and so its kinetic energy is 2 m q^2 q'^2,
# whatever was looked at before.
# Seen:
#   velocity not asked for in between: at q(t)**2*N.x with energy 2*m*q(t)**2*Derivative(q(t), t)**2
#   velocity asked for in between:     at q(t)**2*N.x with energy m*Derivative(q(t), t)**2/2
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'sympy==1.14.0' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import sys

from sympy import Symbol
from sympy.physics.mechanics import Particle, Point, ReferenceFrame, dynamicsymbols

m, q = Symbol("m"), dynamicsymbols("q")


def energy(look: bool):
    """The kinetic energy of a particle that is placed at x = q, then at x = q^2."""
    frame, origin, point = ReferenceFrame("N"), Point("O"), Point("P")
    origin.set_vel(frame, 0)
    point.set_pos(origin, q * frame.x)
    if look:
        point.vel(frame)
    point.set_pos(origin, q**2 * frame.x)
    return point.pos_from(origin), Particle("p", point, m).kinetic_energy(frame)


unseen, seen = energy(look=False), energy(look=True)
print("velocity not asked for in between: at", unseen[0], "with energy", unseen[1])
print("velocity asked for in between:     at", seen[0], "with energy", seen[1])
speed = q.diff()
if (unseen[1] - 2 * m * q**2 * speed**2).simplify() != 0 or (seen[1] - m * speed**2 / 2).simplify() != 0:
    sys.exit("The behaviour has changed.")
PYTHON
