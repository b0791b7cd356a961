#!/usr/bin/env bash
# pint-pandas: temperatures of 20 and 22 degrees Celsius have a standard deviation of 274.56 K.
#
# Package: pint-pandas 0.8.0, pint 0.25.3, pandas 3.1.1, Python 3.11. Date: 2026-11-30.
# Expected: 1.41 K: pint itself gives the standard deviation of an array as a difference of
# temperatures.
# Seen:
#   pint-pandas, column.std():     1.4142 degree_Celsius or 274.5642 kelvin
#   pint-pandas, column.diff()[1]: 2.0000 delta_degree_Celsius
#   pint, np.std(array, ddof=1):   1.4142 delta_degree_Celsius or 1.4142 kelvin
# Note: std keeps the unit of the column, so a conversion adds 273.15; diff gives differences of
# temperature.
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'pint-pandas==0.8.0' 'pint==0.25.3' 'pandas==3.1.1' 'numpy==2.4.6' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import sys
import warnings

warnings.simplefilter("ignore")
import numpy as np
import pandas as pd
import pint
import pint_pandas

column = pd.Series([20.0, 22.0], dtype="pint[degC]")
array = pint.UnitRegistry().Quantity([20.0, 22.0], "degC")
spread, differences = column.std(), column.diff()
print(f"pint-pandas, column.std():     {spread:.4f} or {spread.to('K'):.4f}")
print(f"pint-pandas, column.diff()[1]: {differences[1]:.4f}")
right = np.std(array, ddof=1)
print(f"pint, np.std(array, ddof=1):   {right:.4f} or {right.to('K'):.4f}")
if abs(spread.to("K").magnitude - 274.5642) > 1e-3 or abs(right.to("K").magnitude - 2**0.5) > 1e-9:
    sys.exit("The behaviour has changed.")
PYTHON
