#!/usr/bin/env bash
# pyquaternion: reading the angle of a quaternion, or turning a vector by it, changes the
# quaternion.
#
# Package: pyquaternion 0.9.9, Python 3.11. Date: 2026-11-30.
# Expected: q.angle, q.axis, q.rotation_matrix and q.rotate(v) only look at q.
# Seen:
#   2 + 2k after q.norm               is +2.000 +0.000i +0.000j +2.000k, its inverse +0.250 -0.000i -0.000j -0.250k
#   2 + 2k after q.inverse            is +2.000 +0.000i +0.000j +2.000k, its inverse +0.250 -0.000i -0.000j -0.250k
#   2 + 2k after q.angle              is +0.707 +0.000i +0.000j +0.707k, its inverse +0.707 -0.000i -0.000j -0.707k
#   2 + 2k after q.rotation_matrix    is +0.707 +0.000i +0.000j +0.707k, its inverse +0.707 -0.000i -0.000j -0.707k
#   2 + 2k after q.rotate([1, 0, 0])  is +0.707 +0.000i +0.000j +0.707k, its inverse +0.707 -0.000i -0.000j -0.707k
# Note: each makes q a unit quaternion in place, so that a later q.norm, q.inverse or q * p is
# another one.
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'pyquaternion==0.9.9' 'numpy==2.4.6' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import sys

from pyquaternion import Quaternion

LOOKS = {
    "q.norm": lambda q: q.norm,
    "q.inverse": lambda q: q.inverse,
    "q.angle": lambda q: q.angle,
    "q.rotation_matrix": lambda q: q.rotation_matrix,
    "q.rotate([1, 0, 0])": lambda q: q.rotate([1, 0, 0]),
}
norms = []
for text, look in LOOKS.items():
    q = Quaternion(2, 0, 0, 2)
    look(q)
    norms.append(float(q.norm))
    print(f"2 + 2k after {text:20} is {q}, its inverse {q.inverse}")
if max(abs(norm - 8**0.5) for norm in norms[:2]) > 1e-9 or max(abs(norm - 1) for norm in norms[2:]) > 1e-9:
    sys.exit("The behaviour has changed.")
PYTHON
