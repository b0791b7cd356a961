#!/usr/bin/env bash
# polars and pyarrow differ on decimals: 0.1 * 0.1 is 0.0 or 0.01, 1 / 3 is 0 or 0.3333; and a mean
# of 1 and 2 is 2.
#
# Package: polars 2.1.0, pyarrow 26.0.1, Python 3.11. Date: 2026-11-30.
# Expected: products of decimals are exact, quotients have some more places, and the mean of 1 and 2
# is 1.5.
# Seen:
#   0.1 * 0.1     polars 0.0   pyarrow 0.01
#   1.5 * 1.25    polars 1.88  pyarrow 1.875
#   1 / 3         polars 0     pyarrow 0.3333
#   2 / 3         polars 1     pyarrow 0.6666
#   mean of 1, 2  polars 1.5   pyarrow 2
# Note: polars keeps the places of its operands; pyarrow adds places to products and quotients, but
# none to a mean.
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'polars==2.1.0' 'pyarrow==26.0.1' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import sys
from decimal import Decimal

import polars
import pyarrow
import pyarrow.compute as arrow

PAIRS = {"0.1 * 0.1": ("0.1", "0.1"), "1.5 * 1.25": ("1.5", "1.25"), "1 / 3": ("1", "3"), "2 / 3": ("2", "3")}
found = {}
for text, (a, b) in PAIRS.items():
    first, second = polars.Series([Decimal(a)]), polars.Series([Decimal(b)])
    left, right = pyarrow.array([Decimal(a)]), pyarrow.array([Decimal(b)])
    by_polars = first * second if "*" in text else first / second
    by_arrow = arrow.multiply(left, right) if "*" in text else arrow.divide(left, right)
    found[text] = str(by_polars[0]), str(by_arrow[0].as_py())
both = [Decimal(1), Decimal(2)]
found["mean of 1, 2"] = str(polars.Series(both).mean()), str(arrow.mean(pyarrow.array(both)).as_py())
for text, (by_polars, by_arrow) in found.items():
    print(f"{text:13} polars {by_polars:5} pyarrow {by_arrow}")
if found["0.1 * 0.1"] != ("0.0", "0.01") or found["1 / 3"][0] != "0" or found["mean of 1, 2"][1] != "2":
    sys.exit("The behaviour has changed.")
PYTHON
