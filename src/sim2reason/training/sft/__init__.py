"""Supervised fine-tuning: a model learns to write the completions of prompts.

corpora ── rows ── tokens ── TRL's SFTTrainer ↦ a folder that loads like any checkpoint
"""

from sim2reason.training.sft.config import FineTuning, FineTuningResult
from sim2reason.training.sft.run import train_sft

__all__ = ["FineTuning", "FineTuningResult", "train_sft"]
