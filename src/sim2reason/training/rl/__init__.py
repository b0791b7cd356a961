"""Reinforcement learning: a model, problems, a reward, and the files of a run.

OUT/rl.json         what decides the run, and the versions of the libraries with which it was begun
OUT/held-out/       the problems that are kept for evaluation, a file for each set of the configuration
OUT/warm-start/     the run of supervised fine-tuning that comes first, where there is one
OUT/train/          checkpoints with the place among the problems, and log.jsonl: a line for each step
OUT/model/          the trained model
OUT/result.json     what came of it; written last
"""

from sim2reason.training.rl.config import ReinforcementLearning
from sim2reason.training.rl.run import train_rl

__all__ = ["ReinforcementLearning", "train_rl"]
