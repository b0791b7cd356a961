"""Tests of TRL's loss against the formula, on the policy that wrote the completions and off it."""

import gc
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("trl")

import torch

from gspo_loss import gspo_loss
from gspo_run import Numbers, Thing, trainer

pytestmark = pytest.mark.filterwarnings("ignore::FutureWarning")

EPSILON = (3e-4, 4e-4)
BETA = 0.05


@pytest.fixture(scope="module")
def batch(model: Path, tmp_path_factory: pytest.TempPathFactory) -> Thing:
    """Return a trainer and its batch with completions of several lengths."""
    out = tmp_path_factory.mktemp("loss")
    found = trainer(model, out, Numbers(), ["parity"], epsilon_low=EPSILON[0], epsilon_high=EPSILON[1], beta=BETA)
    found.current_gradient_accumulation_steps = 1
    found.model.train()
    held = found._generate_and_score_completions([])
    assert len(set(held["completion_mask"].sum(dim=1).tolist())) > 2
    yield found, held
    gc.collect()


def own_logps(model: Thing, held: Thing) -> list[np.ndarray]:
    """Return the log-probabilities of the tokens of each completion, from the logits of a plain forward pass."""
    ids = torch.cat([held["prompt_ids"], held["completion_ids"]], dim=1)
    mask = torch.cat([held["prompt_mask"], held["completion_mask"]], dim=1)
    width = held["completion_ids"].shape[1]
    with torch.no_grad():
        logits = model(input_ids=ids, attention_mask=mask).logits.double()[:, -width - 1 : -1]
    every = logits.log_softmax(-1).gather(-1, held["completion_ids"].unsqueeze(-1)).squeeze(-1)
    return masked(every, held)


def masked(logps: Thing, held: Thing) -> list[np.ndarray]:
    kept = zip(logps.detach().double(), held["completion_mask"].bool(), strict=True)
    return [row[mask].numpy() for row, mask in kept]


@pytest.mark.parametrize("noise", [0.0, 2e-4, 3e-2])
def test_trl_has_the_loss_of_the_formula(batch: Thing, noise: float, monkeypatch: pytest.MonkeyPatch) -> None:
    found, held = batch
    before = {name: value.clone() for name, value in found.model.state_dict().items()}
    generator = torch.Generator().manual_seed(1)
    with torch.no_grad():
        for weights in found.model.parameters():
            weights.add_(noise * torch.randn(weights.shape, generator=generator))
    now = found._get_per_token_logps_and_entropies
    seen: list[Thing] = []

    def precise(*given: Thing, **named: Thing) -> Thing:
        logps, entropies, other = now(*given, **named)
        seen.append(logps)
        return logps.double(), entropies, other

    monkeypatch.setattr(found, "_get_per_token_logps_and_entropies", precise)
    doubled = {name: value.double() if value.is_floating_point() else value for name, value in held.items()}
    try:
        loss = found._compute_loss(found.model, doubled).item()
        own = own_logps(found.model, held)
    finally:
        found.model.load_state_dict(before)
    new, old, reference = (
        masked(each, held) for each in (seen[0], held["old_per_token_logps"], held["ref_per_token_logps"])
    )
    advantages = held["advantages"].double().tolist()
    expected = gspo_loss(new, old, reference, advantages, epsilon=EPSILON, beta=BETA)
    assert loss == pytest.approx(expected, rel=1e-6)
    np.testing.assert_allclose(np.concatenate(new), np.concatenate(own), atol=2e-5)
    check_ratios(new, old, advantages, noise)


def check_ratios(new: Thing, old: Thing, advantages: list[float], noise: float) -> None:
    """Assert that no completion is clipped on the policy, and that some are on either side off it, but not all."""
    ratios = np.array([np.exp(np.mean(a - b)) for a, b in zip(new, old, strict=True)])
    low = (ratios < 1 - EPSILON[0]) & (np.array(advantages) < 0)
    high = (ratios > 1 + EPSILON[1]) & (np.array(advantages) > 0)
    if noise == 0.0:
        np.testing.assert_allclose(ratios, 1.0, atol=1e-5)
        assert not (low | high).any()
    else:
        assert low.any()
        assert high.any()
        assert not (low | high).all()


def test_the_formula_clips_and_penalises() -> None:
    one = np.log(np.array([0.5, 0.5]))
    up = one + np.log(1.1)
    assert gspo_loss([up], [one], [up], [2.0], epsilon=(0.01, 0.02), beta=1.0) == pytest.approx(-1.02 * 2)
    assert gspo_loss([up], [one], [up], [-2.0], epsilon=(0.01, 0.02), beta=1.0) == pytest.approx(1.1 * 2)
    assert gspo_loss([one], [one], [up], [0.0], epsilon=(0.01, 0.02), beta=3.0) == pytest.approx(
        3.0 * (1.1 - np.log(1.1) - 1.0)
    )
