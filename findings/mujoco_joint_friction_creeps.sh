#!/usr/bin/env bash
# MuJoCo: a joint with dry friction creeps under any force, no slower when its friction is larger.
#
# Package: mujoco 4.0.0, Python 3.11. Date: 2026-11-30.
# Expected: a slider with frictionloss 50 N holds against 5 N, or at least creeps less than one with
# 6 N.
# Seen:
#   5 N against a friction of 6, 50, 1000 N for 100 s: 0.528 m, 0.528 m, 0.528 m
#   the same against 50 N with noslip_iterations 5: 0.000 m
# Note: frictionloss is a soft constraint; its creep is set by solreffriction and the force alone.
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'mujoco==4.0.0' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import sys

import mujoco

SCENE = """<mujoco><option timestep="0.001" gravity="5 0 0" noslip_iterations="%d"/><worldbody><body>
<joint type="slide" axis="1 0 0" frictionloss="%d"/><geom size="0.1" mass="1"/></body></worldbody></mujoco>"""


def way(friction: int, noslip: int) -> float:
    """How far a slider of 1 kg has moved after 100 s under 5 N."""
    scene = mujoco.MjModel.from_xml_string(SCENE % (noslip, friction))
    data = mujoco.MjData(scene)
    while data.time < 100:
        mujoco.mj_step(scene, data)
    return float(data.qpos[0])


ways = [way(friction, 0) for friction in (6, 50, 1000)]
print("5 N against a friction of 6, 50, 1000 N for 100 s: %.3f m, %.3f m, %.3f m" % tuple(ways))
held = way(50, 5)
print("the same against 50 N with noslip_iterations 5: %.3f m" % held)
if min(ways) < 0.5 or max(ways) - min(ways) > 1e-3 or abs(held) > 1e-6:
    sys.exit("The behaviour has changed.")
PYTHON
