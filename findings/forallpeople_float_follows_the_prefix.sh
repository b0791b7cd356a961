#!/usr/bin/env bash
# forallpeople: the float of 5000 m is 5.0, and that of 0.005 m is 5.0 too.
#
# Package: forallpeople 3.0.0, Python 3.11. Date: 2026-11-30.
# Expected: float(length) is in metres, as length.value is, or an error; an array of lengths turns
# into one scale.
# Seen:
#   5.000 mm   float: 5.0  value: 0.005
#   5.000 m    float: 5.0  value: 5.0
#   5.000 km   float: 5.0  value: 5000.0
#   999 N and 1001 N as an array of floats: [999.      1.001]
#   math.sqrt(4000 m): 2.0
# Note: it is the number that would be printed, so it jumps wherever the printed prefix changes.
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'forallpeople==3.0.0' 'numpy==2.4.6' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import math
import sys

import forallpeople as si
import numpy as np

si.environment("default")
lengths = [0.005 * si.m, 5 * si.m, 5000 * si.m]
for length in lengths:
    print(f"{str(length):10} float: {float(length)}  value: {length.value}")
forces = np.array([999 * si.N, 1001 * si.N])
print("999 N and 1001 N as an array of floats:", forces.astype(float))
root = math.sqrt(4000 * si.m)
print("math.sqrt(4000 m):", root)
if [float(length) for length in lengths] != [5.0, 5.0, 5.0] or root != 2.0 or forces.astype(float)[1] > 2:
    sys.exit("The behaviour has changed.")
PYTHON
