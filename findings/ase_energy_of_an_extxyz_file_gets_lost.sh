#!/usr/bin/env bash
# ASE: a label named energy or forces of an extended XYZ file is gone after a copy, a slice or a
# moved atom.
#
# Package: ase 3.29.0, Python 3.11. Date: 2026-11-30.
# Expected: what is written as atoms.info["energy"] is read as atoms.info["energy"] and copied with
# it, as other names are.
# Seen:
#   before writing info ['energy', 'label_energy'], arrays ['forces', 'label_forces'], calculator []
#   read           info ['label_energy'], arrays ['label_forces'], calculator ['energy', 'forces']
#   read, copied   info ['label_energy'], arrays ['label_forces'], calculator []
#   read, sliced   info ['label_energy'], arrays ['label_forces'], calculator []
#   read, moved    info ['label_energy'], arrays ['label_forces'], calculator []
# Note: names of calculator results go to a calculator when a file is read, and copies have no
# calculator.
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'ase==3.29.0' 'numpy==2.4.6' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import io
import sys

import numpy as np
from ase import Atoms
from ase.io import read, write

molecule = Atoms("H2", [[0.0, 0.0, 0.0], [0.0, 0.0, 0.74]])
forces = np.array([[0.0, 0.0, 0.1], [0.0, 0.0, -0.1]])
molecule.info.update(energy=-31.7, label_energy=-31.7)
molecule.arrays.update(forces=forces, label_forces=forces)
file = io.StringIO()
write(file, molecule, format="extxyz")


def again() -> Atoms:
    """The molecule as it is read."""
    file.seek(0)
    return read(file, format="extxyz")


moved = again()
moved.positions[1, 2] += 0.01
cases = {"before writing": molecule, "read": again(), "read, copied": again().copy(), "read, sliced": again()[:1]}
found = {}
for name, atoms in [*cases.items(), ("read, moved", moved)]:
    results = {} if atoms.calc is None or atoms.calc.check_state(atoms) else atoms.calc.results
    info, arrays = sorted(atoms.info), sorted(set(atoms.arrays) - {"numbers", "positions"})
    found[name] = "energy" in atoms.info, "energy" in results
    print(f"{name:14} info {info}, arrays {arrays}, calculator {sorted(results)}")
if list(found.values()) != [(True, False), (False, True)] + 3 * [(False, False)]:
    sys.exit("The behaviour has changed.")
PYTHON
