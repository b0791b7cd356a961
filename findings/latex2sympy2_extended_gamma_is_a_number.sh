#!/usr/bin/env bash
# latex2sympy2_extended: gamma is Euler's constant 0.577, 1/2 m v^2 is 1/(2 m v^2), and v cos theta
# t is v cos(theta t).
#
# Package: latex2sympy2_extended 1.11.0, sympy 1.14.0, Python 3.11. Date: 2026-11-30.
# Expected: gamma is a symbol, as beta is; 1/2 m is half of m; v cos theta t is the product that
# textbooks mean.
# Seen:
#   \beta m c^2        beta*c**2*m
#   \gamma m c^2       EulerGamma*c**2*m
#   \frac{1}{2} m v^2  m*v**2/2
#   1/2 m v^2          1/(2*m*v**2)
#   v\cos\theta\,t     v*cos(t*theta)
#   v t\cos\theta      t*v*cos(theta)
#   \gamma m c^2 for m = c = 1: 0.577216
#   1/2 m v^2 for m = 2, v = 3: 1/36
#   v\cos\theta\,t for v = 10, t = 3, theta = 0.5: 0.707372
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'latex2sympy2_extended[antlr4_13_2]==1.11.0' 'sympy==1.14.0' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import sys

from latex2sympy2_extended import latex2sympy

TEXTS = (r"\beta m c^2", r"\gamma m c^2", r"\frac{1}{2} m v^2", "1/2 m v^2", r"v\cos\theta\,t", r"v t\cos\theta")
for text in TEXTS:
    print(f"{text:18} {latex2sympy(text)}")
rest = float(latex2sympy(r"\gamma m c^2").subs({"m": 1, "c": 1}))
print(r"\gamma m c^2 for m = c = 1:", f"{rest:.6f}")
energy = latex2sympy("1/2 m v^2").subs({"m": 2, "v": 3}).doit()
print("1/2 m v^2 for m = 2, v = 3:", energy)
way = latex2sympy(r"v\cos\theta\,t").subs({"v": 10, "t": 3, "theta": 0.5}).evalf(6)
print(r"v\cos\theta\,t for v = 10, t = 3, theta = 0.5:", way)
if abs(rest - 0.577216) > 1e-6 or abs(energy - 1 / 36) > 1e-9 or abs(way - 0.7073720) > 1e-5:
    sys.exit("The behaviour has changed.")
PYTHON
