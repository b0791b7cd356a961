"""Supervised fine-tuning: a model learns to write the completions of prompts.

corpora ── rows ── tokens ── TRL's SFTTrainer ↦ a folder that loads like any checkpoint
"""

from sim2reason.training.sft.config import FineTuned, FineTuning
from sim2reason.training.sft.run import train_sft

__all__ = ["FineTuned", "FineTuning", "train_sft"]
