#!/usr/bin/env bash
# scipp: 1500 m are 2 km, and 2 m fit 0 times into 7 m when they are written as 200 cm.
#
# Package: scipp 26.8.0, Python 3.11. Date: 2026-11-30.
# Expected: 1.5 km or an error; and 7 m // 200 cm is 3, as 7 m // 2 m is, since units are checked
# and converted.
# Seen:
#   1499 m in km: 1
#   1500 m in km: 2
#   2400 m in km: 2
#   1500.0 m in km: 1.5
#   7 m // 2 m:    3 of unit dimensionless
#   7 m // 200 cm: 0 of unit 1/%
# Note: whole numbers stay whole when converted, and // divides the bare numbers and leaves the
# units for the result.
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'scipp==26.8.0' 'numpy==2.4.6' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import sys

import scipp

for metres in (1499, 1500, 2400):
    print(f"{metres} m in km:", scipp.scalar(metres, unit="m").to(unit="km").value)
print("1500.0 m in km:", scipp.scalar(1500.0, unit="m").to(unit="km").value)
whole = scipp.scalar(7, unit="m") // scipp.scalar(2, unit="m")
mixed = scipp.scalar(7, unit="m") // scipp.scalar(200, unit="cm")
print("7 m // 2 m:   ", whole.value, "of unit", whole.unit)
print("7 m // 200 cm:", mixed.value, "of unit", mixed.unit)
if scipp.scalar(1500, unit="m").to(unit="km").value != 2 or whole.value != 3 or mixed.value != 0:
    sys.exit("The behaviour has changed.")
PYTHON
