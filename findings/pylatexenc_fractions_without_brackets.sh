#!/usr/bin/env bash
# pylatexenc: \frac{6-2}{1+1} becomes the text 6-2/1+1, \dfrac{1}{2} becomes 12, and \sqrt[3]{8} a
# square root.
#
# Package: pylatexenc 2.11, Python 3.11. Date: 2026-11-30.
# Expected: a text of the same meaning, (6-2)/(1+1), 1/2 and the cube root, since answers are often
# compared after this step.
# Seen:
#   \frac{6-2}{1+1}        6-2/1+1
#   \frac{m g - T}{M + m}  m g - T/M + m
#   3\frac{1}{2}           31/2
#   \dfrac{1}{2}           12
#   2^{n+1}                2^n+1
#   \sqrt[3]{8}            √(8)
#   \frac{6-2}{1+1} evaluated: 5.0 instead of 2
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'pylatexenc==2.11' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import sys

from pylatexenc.latex2text import LatexNodes2Text

read = LatexNodes2Text().latex_to_text
texts = (
    r"\frac{6-2}{1+1}",
    r"\frac{m g - T}{M + m}",
    r"3\frac{1}{2}",
    r"\dfrac{1}{2}",
    r"2^{n+1}",
    r"\sqrt[3]{8}",
)
for text in texts:
    print(f"{text:22} {read(text)}")
value = eval(read(texts[0]))
print(f"{texts[0]} evaluated: {value} instead of 2")
if value != 5 or read(r"\dfrac{1}{2}") != "12" or read("2^{n+1}") != "2^n+1" or "3" in read(r"\sqrt[3]{8}"):
    sys.exit("The behaviour has changed.")
PYTHON
