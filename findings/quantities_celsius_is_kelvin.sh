#!/usr/bin/env bash
# quantities: 20 degrees Celsius are 20 K, and 68 degrees Fahrenheit are 37.8 degrees Celsius.
#
# Package: quantities 0.16.4, Python 3.11. Date: 2026-11-30.
# Expected: 293.15 K and 20 degrees Celsius, or an error, as a temperature and a difference of two
# are not the same.
# Seen:
#   20 degC in K:    20.0 K
#   68 degF in degC: 37.77777777777778 degC
#   1 mol of an ideal gas of 20 degC in 24 litres: 6.929 kPa instead of 101.6 kPa
# Note: degC and degF are differences of temperature in this library, whatever they are used for.
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'quantities==0.16.4' 'numpy==2.4.6' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import sys

import quantities as pq

kelvin = pq.Quantity(20.0, "degC").rescale("K")
celsius = pq.Quantity(68.0, "degF").rescale("degC")
pressure = (1.0 * pq.mol * pq.constants.R * pq.Quantity(20.0, "degC") / (24.0 * pq.litre)).rescale("kPa")
print("20 degC in K:   ", kelvin)
print("68 degF in degC:", celsius)
print("1 mol of an ideal gas of 20 degC in 24 litres:", pressure.round(3), "instead of 101.6 kPa")
if abs(float(kelvin) - 20) > 1e-9 or abs(float(celsius) - 68 / 1.8) > 1e-9:
    sys.exit("The behaviour has changed.")
PYTHON
