#!/usr/bin/env bash
# The unit "J/kg K": kelvin is below the line for astropy and above it for pint and scipp.
#
# Package: astropy 8.0.2, pint 0.25.3, scipp 26.8.0, Python 3.11. Date: 2026-11-30.
# Expected: the three read the same unit, or one refuses it. In tables "J/kg K" stands for J/(kg K).
# Seen:
#   astropy: 'J/kg K' is J / (K kg), 'W/m K' is W / (K m), 'm/s kg' is m / (kg s)
#   pint: 'J/kg K' is J * K / kg, 'W/m K' is K * W / m, 'm/s kg' is kg * m / s
#   scipp: 'J/kg K' is Gy*K, 'W/m K' is W*K/m, 'm/s kg' is N*s
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'astropy==8.0.2' 'pint==0.25.3' 'scipp==26.8.0' 'numpy==2.4.6' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import sys

import astropy.units
import pint
import scipp

registry = pint.UnitRegistry()
texts = ("J/kg K", "W/m K", "m/s kg")
read = {
    "astropy": [str(astropy.units.Unit(text)) for text in texts],
    "pint": [f"{registry.Unit(text):~}" for text in texts],
    "scipp": [str(scipp.Unit(text)) for text in texts],
}
for name, units in read.items():
    print(f"{name}:", ", ".join(f"'{text}' is {unit}" for text, unit in zip(texts, units)))
by_astropy = astropy.units.Unit("J/kg K").is_equivalent("J/(kg K)")
by_pint = registry.Unit("J/kg K").is_compatible_with("J*K/kg")
by_scipp = scipp.Unit("J/kg K") == scipp.Unit("J*K/kg")
if not (by_astropy and by_pint and by_scipp):
    sys.exit("The behaviour has changed.")
PYTHON
