#!/usr/bin/env bash
# AHRS: a roll turns about z in a DCM and about x in a Quaternion, and a DCM does not give its own
# angles back.
#
# Package: ahrs 0.4.0, Python 3.11. Date: 2026-11-30.
# Expected: DCM(rpy=a) and Quaternion(rpy=a) are the same rotation, and DCM(rpy=a).to_rpy() is a.
# Seen:
#   a roll of 30 degrees, DCM:        x goes to [0.866 0.5   0.   ] z to [0. 0. 1.]
#   a roll of 30 degrees, Quaternion: x goes to [1. 0. 0.] z to [ 0.    -0.5    0.866]
#   DCM of 10, 20, 30 degrees .to_rpy():           [-28.45 -22.24   1.12]
#   Quaternion of 10, 20, 30 degrees .to_angles(): [10. 20. 30.]
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'ahrs==0.4.0' 'numpy==2.4.6' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import sys

import numpy as np
from ahrs import DCM, Quaternion

roll = np.radians([30.0, 0.0, 0.0])
by_matrix, by_quaternion = np.asarray(DCM(rpy=roll)), Quaternion(rpy=roll).to_DCM()
x, z = np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0])
turned = by_quaternion @ z
print("a roll of 30 degrees, DCM:        x goes to", np.round(by_matrix @ x, 3), "z to", np.round(by_matrix @ z, 3))
print("a roll of 30 degrees, Quaternion: x goes to", np.round(by_quaternion @ x, 3), "z to", np.round(turned, 3))
angles = np.radians([10.0, 20.0, 30.0])
again = np.degrees(DCM(rpy=angles).to_rpy())
print("DCM of 10, 20, 30 degrees .to_rpy():          ", np.round(again, 2))
print("Quaternion of 10, 20, 30 degrees .to_angles():", np.round(np.degrees(Quaternion(rpy=angles).to_angles()), 2))
if not np.allclose(by_matrix @ z, z) or not np.allclose(by_quaternion @ x, x) or np.allclose(again, [10, 20, 30]):
    sys.exit("The behaviour has changed.")
PYTHON
