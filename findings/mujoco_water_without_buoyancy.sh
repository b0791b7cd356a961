#!/usr/bin/env bash
# MuJoCo: wood sinks in water. A fluid of given density drags and carries nothing.
#
# Package: mujoco 4.0.0, Python 3.11. Date: 2026-11-30.
# Expected: in a medium with density="1000" a ball of 600 kg/m^3 rises and one of 1000 kg/m^3
# floats.
# Seen:
#   600 kg/m^3, fluidshape none: -1.43 m/s
#   600 kg/m^3, fluidshape ellipsoid: -1.25 m/s
#   1000 kg/m^3, fluidshape none: -1.85 m/s
#   1000 kg/m^3, fluidshape ellipsoid: -1.62 m/s
# Note: both fluid models have drag, lift and added mass at most; buoyancy must be applied by hand
# (xfrc_applied).
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'mujoco==4.0.0' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import sys

import mujoco

SCENE = """<mujoco><option density="1000" viscosity="0.001" timestep="0.002"/><worldbody><body><freejoint/>
<geom type="sphere" size="0.1" density="%d" fluidshape="%s"/></body></worldbody></mujoco>"""


def speed(density: int, model: str) -> float:
    """The vertical velocity of a ball after 20 s in water, released at rest."""
    scene = mujoco.MjModel.from_xml_string(SCENE % (density, model))
    data = mujoco.MjData(scene)
    while data.time < 20:
        mujoco.mj_step(scene, data)
    return float(data.qvel[2])


speeds = {(density, model): speed(density, model) for density in (600, 1000) for model in ("none", "ellipsoid")}
for (density, model), value in speeds.items():
    print(f"{density} kg/m^3, fluidshape {model}: {value:.2f} m/s")
if max(speeds.values()) > -1:
    sys.exit("The behaviour has changed.")
PYTHON
