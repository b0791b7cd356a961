"""The reward for verl: `reward.custom_reward_function.path=…/reward.py`; its name is the default, compute_score."""

from sim2reason import rewards


def compute_score(
    data_source: str,
    solution_str: str,
    ground_truth: str,
    extra_info: object = None,
    *,
    thinking_opened: bool = False,
    **settings: object,
) -> float:
    """1 or 0 for one response: to a problem of ours by our grader, to any other by verl's own rule for its source."""
    if data_source == "sim2reason":
        return rewards.compute_score(data_source, solution_str, ground_truth, thinking_opened=thinking_opened)
    from verl.utils.reward_score import default_compute_score  # noqa: PLC0415 - only a mixture needs it

    found = default_compute_score(data_source, solution_str, ground_truth, extra_info, **settings)
    return float(found.get("acc", found["score"] > 0)) if isinstance(found, dict) else float(found)
