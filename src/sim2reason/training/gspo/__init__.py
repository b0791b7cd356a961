"""Group Sequence Policy Optimization with dynamic sampling, on TRL's trainer.

PromptStream ── rounds of completions and rewards ↦ groups of unequal rewards ── updates ↦ log.jsonl, checkpoints
"""

from sim2reason.training.gspo.assembly import make_trainer
from sim2reason.training.gspo.settings import GSPOSettings, PromptStream, VllmSettings
from sim2reason.training.run_files import StepLog, StepRecord, StepSeconds, last_checkpoint

__all__ = [
    "GSPOSettings",
    "PromptStream",
    "StepLog",
    "StepRecord",
    "StepSeconds",
    "VllmSettings",
    "last_checkpoint",
    "make_trainer",
]
