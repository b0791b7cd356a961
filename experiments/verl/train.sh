#!/usr/bin/env bash
# train.sh SIZE PROBLEMS [KEY=VALUE…]: train on one node of eight GPUs.
# SIZE is one of size/*.yaml, PROBLEMS what `sim2reason export --to verl` wrote, with a test split; what follows goes to
# verl. STORED=FILE.parquet mixes the rows of a file in, as mixture.yaml says.
set -euo pipefail
(($# >= 2)) || { echo "usage: $0 SIZE PROBLEMS [KEY=VALUE…]" >&2; exit 2; }
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
size=$1 problems=$(cd "$2" && pwd)
shift 2
train=$here/problems.yaml
[[ -z ${STORED:-} ]] || train="[$here/mixture.yaml,$(realpath "$STORED")]"
exec python -m verl.trainer.main_ppo --config-dir "$here" --config-name gspo "size=$size" \
    "data.train_files=$train" "data.val_files=$problems/test.parquet" \
    "reward.custom_reward_function.path=$problems/reward.py" "$@"
