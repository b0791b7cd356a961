#!/usr/bin/env bash
# Gymnasium: Acrobot-v1, which has no friction, loses energy within one episode without any torque.
#
# Package: gymnasium 1.4.0, Python 3.11. Date: 2026-11-30.
# Expected: with action 1, a torque of 0, the energy of the double pendulum stays as it is, to a
# percent or so.
# Seen:
#   energy after 0, 20, 50, 100 s (100 s are an episode): 10.04, 8.20, 5.92, 2.45 J
#   the same with env.dt = 0.05: 10.04, 10.04, 10.03, 10.02 J
#   greatest speed of a joint: 9.9 rad/s; the limits are 12.6 and 28.3
# Note: it is the Runge-Kutta step of 0.2 s; the limits of the speeds are not reached. With dt =
# 0.05 the energy stays.
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'gymnasium==1.4.0' 'numpy==2.4.6' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import sys
import warnings

import numpy as np

warnings.simplefilter("ignore")
import gymnasium


def energy(state) -> float:
    """Kinetic and potential energy: links of 1 m, 1 kg and 1 kg m^2 with their centres in their middles."""
    a, b, u, w = state
    turning = (u**2 + (u + w) ** 2) / 2
    moving = u**2 / 8 + (u**2 + (u + w) ** 2 / 4 + u * (u + w) * np.cos(b)) / 2
    return float(turning + moving - 9.8 * (1.5 * np.cos(a) + 0.5 * np.cos(a + b)))


def episode(dt: float) -> tuple[list[float], float]:
    """The energies after 0, 20, 50 and 100 s without torque, and the greatest speed of a joint."""
    env = gymnasium.make("Acrobot-v1").unwrapped
    env.reset(seed=0)
    env.dt, env.state = dt, np.array([2.0, 0.5, 0.0, 0.0])
    found, fastest = [energy(env.state)], 0.0
    for step in range(1, round(100 / dt) + 1):
        env.step(1)
        fastest = max(fastest, *np.abs(env.state[2:]))
        if step in (round(20 / dt), round(50 / dt), round(100 / dt)):
            found.append(energy(env.state))
    return found, fastest


usual, fastest = episode(0.2)
fine, _ = episode(0.05)
print("energy after 0, 20, 50, 100 s (100 s are an episode): %.2f, %.2f, %.2f, %.2f J" % tuple(usual))
print("the same with env.dt = 0.05: %.2f, %.2f, %.2f, %.2f J" % tuple(fine))
print("greatest speed of a joint: %.1f rad/s; the limits are 12.6 and 28.3" % fastest)
if not usual[0] - usual[-1] > 5 or abs(fine[-1] - fine[0]) > 0.1:
    sys.exit("The behaviour has changed.")
PYTHON
