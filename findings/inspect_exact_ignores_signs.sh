#!/usr/bin/env bash
# Inspect: the scorer exact() takes -5 for 5, 1/2 for 12, x^2 for x2, v for V, and words in any
# order.
#
# Package: inspect-ai 0.3.285, Python 3.11. Date: 2026-11-30.
# Expected: exact(), which by its documentation "produces an exact match score", tells -5 from 5,
# 1/2 from 12 and v from V.
# Seen:
#   answer -5       target 5        C
#   answer -5 m     target 5 m      C
#   answer 1/2      target 12       C
#   answer x^2      target x2       C
#   answer 50%      target 50       C
#   answer v        target V        C
#   answer M, then m target m, then M C
#   answer 9.8      target 98       I
#   answer 6        target 5        I
# Note: the text is first freed of punctuation and case, and its words are compared as a set.
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'inspect-ai==0.3.285' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import asyncio
import sys

from inspect_ai.model import ModelName, ModelOutput
from inspect_ai.scorer import Target, exact
from inspect_ai.solver import TaskState

PAIRS = [("-5", "5"), ("-5 m", "5 m"), ("1/2", "12"), ("x^2", "x2"), ("50%", "50"), ("v", "V"),
         ("M, then m", "m, then M"), ("9.8", "98"), ("6", "5")]


def verdict(answer: str, target: str) -> str:
    """What exact() says of an answer: C for correct, I for incorrect."""
    output = ModelOutput.from_content("mockllm/model", answer)
    state = TaskState(ModelName("mockllm/model"), sample_id=1, epoch=1, input="", messages=[], output=output)
    return str(asyncio.run(exact()(state, Target(target))).value)


verdicts = [verdict(*pair) for pair in PAIRS]
for (answer, target), found in zip(PAIRS, verdicts):
    print(f"answer {answer:8} target {target:8} {found}")
if verdicts != ["C"] * 7 + ["I"] * 2:
    sys.exit("The behaviour has changed.")
PYTHON
