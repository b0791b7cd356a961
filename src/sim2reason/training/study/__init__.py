"""Studies: one configuration of reinforcement learning with variations (arms) and seeds.

OUT/runs/ARM-SEED   a run of reinforcement learning; ARM-SEED.yaml is its configuration, ARM-SEED.log what it said
OUT/report/         all of it on a page

A study may grow: with more arms or seeds the same folder keeps what is finished.
"""

from sim2reason.training.study.config import TrainingStudy, build_study
from sim2reason.training.study.run import train_study

__all__ = ["TrainingStudy", "build_study", "train_study"]
