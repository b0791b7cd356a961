"""Loss of GSPO from its formula, in a few lines of numpy, as the reference for TRL's."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Logps = Sequence[NDArray[np.float64]]


def gspo_loss(
    new: Logps, old: Logps, reference: Logps, advantages: Sequence[float], *, epsilon: tuple[float, float], beta: float
) -> float:
    r"""Return the loss of sequences whose tokens have these log-probabilities, one nonempty array for each.

    The ratio is :math:`s_i = \exp\Big(\frac1{|y_i|}\sum_t \log\frac{\pi(y_{i,t})}{\pi_{old}(y_{i,t})}\Big)`,
    and the loss :math:`L = -\frac1N\sum_i \min\big(s_i A_i, clip(s_i, 1-\epsilon_0, 1+\epsilon_1) A_i\big)
    + \beta\,\frac1N\sum_i k_i`.

    Group Sequence Policy Optimization (Zheng et al. 2025, arXiv:2507.18071), with the penalty of GRPO: :math:`k_i` is
    the mean over the tokens of :math:`e^d - d - 1`, where d is the reference's log-probability less the policy's
    (Schulman, Approximating KL divergence, 2020: k3). The Sim2Reason paper writes the ratio without the exponent
    1/|y|; the GSPO paper, TRL and verl have it, and clipping at 3e-4 only makes sense with it, so it is here.
    """
    terms: list[float] = []
    for now, before, start, advantage in zip(new, old, reference, advantages, strict=True):
        ratio = float(np.exp(np.mean(now - before)))
        clipped = min(max(ratio, 1.0 - epsilon[0]), 1.0 + epsilon[1])
        away = start - now
        penalty = float(np.mean(np.exp(away) - away - 1.0))
        terms.append(-min(ratio * advantage, clipped * advantage) + beta * penalty)
    return sum(terms) / len(terms)
