#!/usr/bin/env bash
# lm-eval: the task hendrycks_math gives 0 to solutions as its own data set has them, and to any
# answer in a box.
#
# Package: lm-eval 0.4.13, Python 3.11. Date: 2026-11-30.
# Expected: the reference solution, made up here in the form of the data set, is correct; and so is
# "$F=6$, so the answer is $3$".
# Seen:
#   0 The net force is $F = 6$ N, so the acceleration is $a = F/m = \boxed{3}$.
#   0 The answer is $\boxed{3}$.
#   0 \boxed{3}
#   0 $F=6$, so the answer is $3$.
#   0 The answer is 3.
#   1 The answer is $3$.
#   1 3
# Note: the answer is all that stands between the first and the last dollar sign; a box is looked
# for in the reference only.
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'lm-eval==0.4.13' 'datasets==5.2.0' || exit 2
HF_HOME="$folder/home" HF_HUB_OFFLINE=1 "$folder/venv/bin/python" - <<'PYTHON'
import sys

from lm_eval.tasks.hendrycks_math.utils import process_results

SOLUTION = r"The net force is $F = 6$ N, so the acceleration is $a = F/m = \boxed{3}$."
ANSWERS = (
    SOLUTION,
    r"The answer is $\boxed{3}$.",
    r"\boxed{3}",
    "$F=6$, so the answer is $3$.",
    "The answer is 3.",
    "The answer is $3$.",
    "3",
)
scores = [process_results({"solution": SOLUTION}, [answer])["exact_match"] for answer in ANSWERS]
for answer, score in zip(ANSWERS, scores):
    print(score, answer)
if scores != [0, 0, 0, 0, 0, 1, 1]:
    sys.exit("The behaviour has changed.")
PYTHON
