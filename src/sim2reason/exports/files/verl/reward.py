"""The reward for verl: `reward.custom_reward_function.path=…/reward.py`; its name is the default, compute_score."""

from sim2reason.rewards import compute_score

__all__ = ["compute_score"]
