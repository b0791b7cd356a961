#!/usr/bin/env bash
# SymPy integrates |cos t| over one period at most, and says nothing about the rest.
#
# Package: sympy 1.14.0, Python 3.11. Date: 2026-11-30.
# Expected: the distance that an oscillator of speed |cos t| covers grows by 4 with each period, so
# 2 n from 0 to n pi.
# Seen:
#   |cos t| to pi, 2 pi, 3 pi, 10 pi: 2 4 4 4 instead of 2 4 6 20
#   |sin t| to pi, 2 pi, 3 pi, 10 pi: 2 4 2 4 instead of 2 4 6 20
#   exp(-t/10) |cos t| to 20: 2.8050 instead of 5.5401
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'sympy==1.14.0' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import sys

from sympy import Abs, Integer, cos, exp, integrate, pi, sin, symbols

t = symbols("t", real=True)
found = [integrate(Abs(cos(t)), (t, 0, n * pi)) for n in (1, 2, 3, 10)]
print("|cos t| to pi, 2 pi, 3 pi, 10 pi:", *found, "instead of 2 4 6 20")
sine = [integrate(Abs(sin(t)), (t, 0, n * pi)) for n in (1, 2, 3, 10)]
print("|sin t| to pi, 2 pi, 3 pi, 10 pi:", *sine, "instead of 2 4 6 20")
damped = integrate(exp(-t / 10) * Abs(cos(t)), (t, 0, 20)).n(5)
pieces = sum(abs(integrate(exp(-t / 10) * cos(t), (t, a, b)).n()) for a, b in [
    (0, pi / 2), *(((2 * k - 1) * pi / 2, (2 * k + 1) * pi / 2) for k in range(1, 6)), (11 * pi / 2, 20)])
print("exp(-t/10) |cos t| to 20:", damped, "instead of", pieces.n(5))
if found != [2, 4, 4, Integer(4)] or sine != [2, 4, 2, 4] or abs(damped - pieces) < 1:
    sys.exit("The behaviour has changed.")
PYTHON
