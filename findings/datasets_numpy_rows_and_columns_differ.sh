#!/usr/bin/env bash
# datasets: with_format("numpy") gives a number of a row in double precision, and the same number of
# a slice in single.
#
# Package: datasets 5.2.0, pyarrow 26.0.1, numpy 2.4.6, Python 3.11. Date: 2026-11-30.
# Expected: a column of float64 stays float64, as with_format("pandas"), ("arrow") and ("polars")
# leave it.
# Seen:
#   feature:   float64
#   row 0:     float64 123456789.123
#   slice:     float32 123456792.0 0.0 inf
#   list in row 0: float32 1.2345679e+08
#   pandas:    float64 123456789.123 1e-50 1e+300
# Note: beyond 3.4e38 it is inf and below 1e-45 it is 0. Lists within a row are in single precision
# too.
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'datasets==5.2.0' 'pyarrow==26.0.1' 'numpy==2.4.6' 'pandas==3.1.1' || exit 2
HF_HOME="$folder/home" HF_HUB_OFFLINE=1 "$folder/venv/bin/python" - <<'PYTHON'
import sys
import warnings

warnings.simplefilter("ignore")
from datasets import Dataset

data = Dataset.from_dict({"t": [123456789.123, 1e-50, 1e300], "xs": [[123456789.123]] * 3})
print("feature:  ", data.features["t"].dtype)
arrays = data.with_format("numpy")
row, columns = arrays[0], arrays[:]
print("row 0:    ", row["t"].dtype, row["t"])
print("slice:    ", columns["t"].dtype, *columns["t"].tolist())
print("list in row 0:", row["xs"].dtype, row["xs"][0])
frame = data.with_format("pandas")[:]["t"]
print("pandas:   ", frame.dtype, *frame.tolist())
if not (row["t"].dtype == "float64" and columns["t"].dtype == "float32" and columns["t"][2] == float("inf")):
    sys.exit("The behaviour has changed.")
PYTHON
