#!/usr/bin/env bash
# MJX: the clock of a simulation is 9 s slow after a million steps of 1 ms.
#
# Package: mujoco-mjx 3.17.0, mujoco 4.0.0, jax 0.10.2 (CPU), Python 3.11. Date: 2026-11-30.
# Expected: after 1,000,000 steps of 1 ms data.time is 1000 s to within 0.01 s.
# Seen:
#   single precision: 100.0 200.5 301.2 401.9 502.6 600.5 698.2 795.8 893.5 991.1
#   double precision: 100.0 200.0 300.0 400.0 500.0 600.0 700.0 800.0 900.0 1000.0
# Note: the time is a sum in single precision; whatever is driven by data.time runs slow with it.
# JAX_ENABLE_X64=1 mends it.
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'mujoco-mjx==3.17.0' 'mujoco==4.0.0' 'jax==0.10.2' 'jaxlib==0.10.2' || exit 2
clock() { # clock X64: the time after each 100,000 steps of 1 ms
    JAX_ENABLE_X64=$1 JAX_PLATFORMS=cpu "$folder/venv/bin/python" - <<'PYTHON'
import jax
import mujoco
from mujoco import mjx

SCENE = """<mujoco><option timestep="0.001"/><worldbody><body><joint type="hinge" axis="0 1 0"/>
<geom size="0.02" pos="0 0 -1" mass="1" contype="0" conaffinity="0"/></body></worldbody></mujoco>"""
model = mjx.put_model(mujoco.MjModel.from_xml_string(SCENE))
run = jax.jit(lambda data: jax.lax.fori_loop(0, 100_000, lambda _, data: mjx.step(model, data), data))
data, times = mjx.make_data(model), []
for _ in range(10):
    data = run(data)
    times.append(float(data.time))
print(*(f"{time:.1f}" for time in times))
PYTHON
}
single=$(clock 0 | tail -n 1) # before it MJX says that Warp is not installed
double=$(clock 1 | tail -n 1)
echo "single precision: $single"
echo "double precision: $double"
awk -v single="${single##* }" -v double="${double##* }" 'BEGIN { exit !(single < 995 && double > 999.9) }' ||
    { echo "The behaviour has changed." >&2; exit 1; }
