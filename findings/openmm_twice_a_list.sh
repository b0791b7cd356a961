#!/usr/bin/env bash
# OpenMM: twice a list of lengths is the list repeated, and lengths times a length are repeated
# square lengths.
#
# Package: openmm 8.6.1, Python 3.11. Date: 2026-11-30.
# Expected: [1, 2] nm times 2 is [2, 4] nm, as it is with 2.0, and times 2 nm it is [2, 4] nm^2.
# Seen:
#   lengths * 2.0              [2.0, 4.0] nm
#   lengths * 2                [1.0, 2.0, 1.0, 2.0] nm
#   2 * lengths                [1.0, 2.0, 1.0, 2.0] nm
#   lengths * (2 * nanometer)  [1.0, 2.0, 1.0, 2.0] nm**2
#   lengths + lengths          [1.0, 2.0, 1.0, 2.0] nm
#   lengths / 2                [0.5, 1.0] nm
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'openmm==8.6.1' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import sys

from openmm.unit import Quantity, nanometer

lengths = Quantity([1.0, 2.0], nanometer)
results = {
    "lengths * 2.0": lengths * 2.0,
    "lengths * 2": lengths * 2,
    "2 * lengths": 2 * lengths,
    "lengths * (2 * nanometer)": lengths * (2 * nanometer),
    "lengths + lengths": lengths + lengths,
    "lengths / 2": lengths / 2,
}
for text, value in results.items():
    print(f"{text:26}", value)
repeated = [1.0, 2.0, 1.0, 2.0]
same = [list(results[text]._value) for text in list(results)[1:5]]
if any(value != repeated for value in same) or list((lengths * 2.0)._value) != [2.0, 4.0]:
    sys.exit("The behaviour has changed.")
PYTHON
