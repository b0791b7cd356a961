#!/usr/bin/env bash
# polars writes Parquet files that pyarrow and datasets cannot read, when a UInt64 column follows an
# Int64 one.
#
# Package: polars 2.1.0, pyarrow 26.0.1, datasets 5.2.0, Python 3.11. Date: 2026-11-30.
# Expected: the concatenated column has a type that other readers of Parquet know, or write_parquet
# refuses to write it.
# Seen:
#   written by polars: Schema([('seed', Int128)]) [7, 8]
#   read by polars:    Schema([('seed', Int128)])
#   pyarrow: Integers with more than 64 bits not implemented
#   datasets: Integers with more than 64 bits not implemented
#   to_arrow: Invalid or unsupported format string: '_pli128'
# Note: the common type of UInt64 and Int64 is Int128, which only polars reads back; cast before
# writing.
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'polars==2.1.0' 'pyarrow==26.0.1' 'datasets==5.2.0' || exit 2
HF_HOME="$folder/home" HF_HUB_OFFLINE=1 "$folder/venv/bin/python" - <<'PYTHON'
import os
import sys

import polars
import pyarrow
import pyarrow.parquet
from datasets import Dataset

file = os.environ["HF_HOME"] + ".parquet"
signed = polars.DataFrame({"seed": [7]}, schema={"seed": polars.Int64})
unsigned = polars.DataFrame({"seed": [8]}, schema={"seed": polars.UInt64})
both = polars.concat([signed, unsigned], how="vertical_relaxed")
both.write_parquet(file)
print("written by polars:", both.schema, both["seed"].to_list())
print("read by polars:   ", polars.read_parquet(file).schema)
readers = {
    "pyarrow": lambda: pyarrow.parquet.read_table(file),
    "datasets": lambda: Dataset.from_parquet(file),
    "to_arrow": both.to_arrow,
}
refused = 0
for name, read in readers.items():
    try:
        print(f"{name}:", read())
    except Exception as error:
        refused += 1
        print(f"{name}: {str(error) if isinstance(error, pyarrow.ArrowException) else type(error).__name__}")
if refused != 3 or both.schema["seed"] != polars.Int128:
    sys.exit("The behaviour has changed.")
PYTHON
