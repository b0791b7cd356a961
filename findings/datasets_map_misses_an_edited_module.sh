#!/usr/bin/env bash
# datasets: map() returns old results after the function, in a module of one's own, was edited.
#
# Package: datasets 5.2.0, Python 3.11. Date: 2026-11-30.
# Expected: map() computes anew when what it calls has changed, as it does for functions and
# constants of the script itself.
# Seen:
#   weight = 10 m: by the module's function: 20, by a lambda that calls it: 20, by a lambda with its g: 20
#   weight = 20 m: by the module's function: 20, by a lambda that calls it: 20, by a lambda with its g: 40
# Note: functions of an imported module count by their names; load_from_cache_file=False computes
# anew.
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'datasets==5.2.0' 'pyarrow==26.0.1' || exit 2
export HF_HOME="$folder/home" HF_HUB_OFFLINE=1 HF_DATASETS_DISABLE_PROGRESS_BARS=1 PYTHONDONTWRITEBYTECODE=1
cd "$folder"
echo '{"mass": 2}' >rows.jsonl
cat >label.py <<'PYTHON'
from datasets import load_dataset
from physics import g, weight

rows = load_dataset("json", data_files="rows.jsonl", split="train")
print("by the module's function:", rows.map(weight)["weight"][0], end=", ")
print("by a lambda that calls it:", rows.map(lambda row: weight(row))["weight"][0], end=", ")
print("by a lambda with its g:", rows.map(lambda row: {"weight": g * row["mass"]})["weight"][0])
PYTHON
physics() { # physics G: a module in which the weight is G times the mass
    printf 'g = %s\n\n\ndef weight(row):\n    return {"weight": %s * row["mass"]}\n' "$1" "$1" >physics.py
}
physics 10
echo "weight = 10 m: $(venv/bin/python label.py)"
physics 20
second=$(venv/bin/python label.py)
echo "weight = 20 m: $second"
case $second in
*"function: 20, by a lambda that calls it: 20, by a lambda with its g: 40"*) ;;
*) echo "The behaviour has changed." >&2; exit 1 ;;
esac
