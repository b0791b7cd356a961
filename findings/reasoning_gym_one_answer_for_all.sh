#!/usr/bin/env bash
# Reasoning Gym: one fixed answer is paid 1.0 for every puzzle of puzzle24, and 0.96 on average for
# game_of_life.
#
# Package: reasoning-gym 0.1.25, Python 3.11. Date: 2026-11-30.
# Expected: puzzle24 asks to make 24 of four given numbers and pays little for other numbers; a dead
# board pays little.
# Seen:
#   Make 24 using 8, 5, 10, 6. You can only use each number once. You can use the operators +, -, *, /.
#   (1+2+3)*4 uses the given numbers in 0 of 200 puzzles; mean reward 1.000
#   a dead board is right for 25 of 200 boards; mean reward 0.961
# Note: puzzle24 does not compare with the numbers given; game_of_life pays the share of right
# cells, and most are dead.
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'reasoning-gym==0.1.25' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import json
import sys

import reasoning_gym

puzzles = reasoning_gym.create_dataset("puzzle24", size=200, seed=1)
print(puzzles[0]["question"].splitlines()[0])
paid = [puzzles.score_answer("(1+2+3)*4", item) for item in puzzles]
fitting = sum(sorted(item["metadata"]["numbers"]) == [1, 2, 3, 4] for item in puzzles)
print(f"(1+2+3)*4 uses the given numbers in {fitting} of 200 puzzles; mean reward {sum(paid) / 200:.3f}")
boards = reasoning_gym.create_dataset("game_of_life", size=200, seed=1)
dead = json.dumps([[0] * 10] * 10)
scores = [boards.score_answer(dead, item) for item in boards]
print(f"a dead board is right for {scores.count(1.0)} of 200 boards; mean reward {sum(scores) / 200:.3f}")
if min(paid) < 1 or fitting > 20 or scores.count(1.0) > 60 or sum(scores) / 200 < 0.9:
    sys.exit("The behaviour has changed.")
PYTHON
