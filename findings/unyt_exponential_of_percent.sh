#!/usr/bin/env bash
# unyt: exp, log and the trigonometric functions take the bare number, even of percent, g/kg or
# metres.
#
# Package: unyt 3.2.0, Python 3.11. Date: 2026-11-30.
# Expected: exp(50 %) is exp(0.5), log10(1 km/m) is 3, and log(2 m) is an error; sums do convert: 2
# + 1 km/m is 1002.
# Seen:
#   exp(50 %)      5.18471e+21
#   exp(5 g/kg)    148.413
#   log10(1 km/m)  0
#   log(2 m)       0.693147
#   cos(1 m)       0.540302
#   sin(30 degree) 0.5
#   2 + 1 km/m     1002
# Note: only angles are converted: sin(30 degree) is 0.5.
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'unyt==3.2.0' 'numpy==2.4.6' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import sys

import numpy as np
from unyt import unyt_quantity as quantity

results = {
    "exp(50 %)": float(np.exp(quantity(50.0, "percent"))),
    "exp(5 g/kg)": float(np.exp(quantity(5.0, "g/kg"))),
    "log10(1 km/m)": float(np.log10(quantity(1.0, "km/m"))),
    "log(2 m)": float(np.log(quantity(2.0, "m"))),
    "cos(1 m)": float(np.cos(quantity(1.0, "m"))),
    "sin(30 degree)": float(np.sin(quantity(30.0, "degree"))),
    "2 + 1 km/m": float(2 + quantity(1.0, "km/m")),
}
for text, value in results.items():
    print(f"{text:14} {value:.6g}")
bare = [np.exp(50), np.exp(5), 0.0, np.log(2), np.cos(1), 0.5, 1002.0]
if not np.allclose(list(results.values()), bare):
    sys.exit("The behaviour has changed.")
PYTHON
