#!/usr/bin/env bash
# polars: sums of 8- and 16-bit numbers are widened, sums of 32-bit numbers wrap around without a
# word.
#
# Package: polars 2.1.0, pyarrow 26.0.1, Python 3.11. Date: 2026-11-30.
# Expected: a sum of tokens or steps beyond 2^31 is widened as smaller types are, and as pyarrow
# does for all; or an error.
# Seen:
#   100 + 100 as Int8: polars 200, sum_horizontal -56, pyarrow 200
#   30000 + 30000 as Int16: polars 60000, sum_horizontal -5536, pyarrow 60000
#   2000000000 + 2000000000 as Int32: polars -294967296, sum_horizontal -294967296, pyarrow 4000000000
# Note: group_by and cum_sum do the same; sum_horizontal widens nothing, not even 8 bits.
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'polars==2.1.0' 'pyarrow==26.0.1' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import sys

import polars
import pyarrow
import pyarrow.compute

sums = {}
for bits, value in ((8, 100), (16, 30_000), (32, 2_000_000_000)):
    column = polars.Series([value, value], dtype=getattr(polars, f"Int{bits}"))
    arrow = pyarrow.compute.sum(pyarrow.array([value, value], getattr(pyarrow, f"int{bits}")())).as_py()
    across = polars.DataFrame({"a": column[:1], "b": column[:1]}).select(polars.sum_horizontal("a", "b")).item()
    sums[bits] = column.sum()
    print(f"{value} + {value} as Int{bits}: polars {sums[bits]}, sum_horizontal {across}, pyarrow {arrow}")
if sums != {8: 200, 16: 60_000, 32: -294_967_296}:
    sys.exit("The behaviour has changed.")
PYTHON
