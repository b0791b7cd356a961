#!/usr/bin/env bash
# transforms3d: a quaternion times its inverse is not one unless it has the length one.
#
# Package: transforms3d 0.4.2, Python 3.11. Date: 2026-11-30.
# Expected: qinverse, which its documentation calls the multiplicative inverse, gives q q^-1 = 1 for
# any q but 0.
# Seen:
#   q = [1.0, 0.0, 0.0, 0.0]  q * qinverse(q) = [1. 0. 0. 0.]
#   q = [2.0, 0.0, 0.0, 0.0]  q * qinverse(q) = [2. 0. 0. 0.]
#   q = [0.0, 0.5, 0.0, 0.0]  q * qinverse(q) = [0.5 0.  0.  0. ]
#   q = [1.0, 2.0, 3.0, 4.0]  q * qinverse(q) = [5.4772 0.     0.     0.    ]
# Note: it divides the conjugate by the length of q, not by its square.
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'transforms3d==0.4.2' 'numpy==2.4.6' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import sys

import numpy as np
from transforms3d.quaternions import qinverse, qmult

changed = False
for q in ([1.0, 0.0, 0.0, 0.0], [2.0, 0.0, 0.0, 0.0], [0.0, 0.5, 0.0, 0.0], [1.0, 2.0, 3.0, 4.0]):
    product = qmult(q, qinverse(q))
    print("q =", q, " q * qinverse(q) =", np.round(product, 4) + 0.0)
    changed |= not np.allclose(product, [np.linalg.norm(q), 0, 0, 0])
if changed:
    sys.exit("The behaviour has changed.")
PYTHON
