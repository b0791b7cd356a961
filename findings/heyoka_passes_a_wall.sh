#!/usr/bin/env bash
# heyoka integrates across relu and select without noticing them: a ball falls through a floor.
#
# Package: heyoka 7.13.2, Python 3.11. Date: 2026-11-30.
# Expected: an adaptive integrator with a tolerance of 2e-16 notices where a force sets in. Ball: it
# is thrown back and stays below 1 m. Block: friction stops it after 5 s at 25 m.
# Seen:
#   ball dropped from 1 m on a floor of 1 kN/m, after 2 s: time_limit, 1 step, x = -18.6 m, v = -19.6 m/s
#   ball of 1 m/s towards a wall at 1 m, after 10 s:       time_limit, 1 step, x = 10.0 m, v = 1.0 m/s
#   block of 10 m/s, friction of 2 m/s^2, after 20 s:      time_limit, 1 step, x = -200.0 m, v = -30.0 m/s
# Note: the Taylor series on one side is exact, so the step is as long as the time that is asked
# for.
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'heyoka==7.13.2' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import sys

import heyoka as hy

x, v = hy.make_vars("x", "v")


def end(acceleration, state, time):
    """Position and speed at `time`, and how many steps it took."""
    body = hy.taylor_adaptive([(x, v), (v, acceleration)], state)
    outcome, *_, steps, _, _ = body.propagate_until(time)
    return outcome.name, steps, *map(float, body.state)


floor = end(-9.8 + 1000.0 * hy.relu(-x), [1.0, 0.0], 2.0)
print("ball dropped from 1 m on a floor of 1 kN/m, after 2 s: %s, %d step, x = %.1f m, v = %.1f m/s" % floor)
wall = end(-1e4 * hy.relu(x - 1.0), [0.0, 1.0], 10.0)
print("ball of 1 m/s towards a wall at 1 m, after 10 s:       %s, %d step, x = %.1f m, v = %.1f m/s" % wall)
block = end(hy.select(hy.gt(v, 0.0), -2.0, 2.0), [0.0, 10.0], 20.0)
print("block of 10 m/s, friction of 2 m/s^2, after 20 s:      %s, %d step, x = %.1f m, v = %.1f m/s" % block)
if abs(floor[2] + 18.6) > 1e-6 or abs(wall[2] - 10) > 1e-6 or abs(block[3] + 30) > 1e-6:
    sys.exit("The behaviour has changed.")
PYTHON
