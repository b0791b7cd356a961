"""Optimization of weights: Muon with AdamW as one optimizer, and low-rank adapters.

Jordan et al., Muon: An optimizer for hidden layers in neural networks (2024); Loshchilov and Hutter, Decoupled weight
decay regularization (2019). Adapters are small matrices trained in place of a model's own (Hu et al., LoRA, 2021).
"""

# torch ships types, but is an extra:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false
# pyright: reportUntypedBaseClass=false

from collections.abc import Callable
from functools import cache
from typing import Annotated, Any, Literal

from annotated_types import Ge, Gt, Le, Lt, MinLen
from pydantic import BaseModel, ConfigDict

from sim2reason.training.extras import External, library

__all__ = ["Lora", "muon_with_adamw"]


class Lora(BaseModel):
    """Settings of low-rank adapters."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    rank: Annotated[int, Ge(1), Le(4096)] = 16
    alpha: Annotated[float, Gt(0.0)] = 32.0
    """What an adapter adds is scaled by alpha over the rank."""
    dropout: Annotated[float, Ge(0.0), Lt(1.0)] = 0.0
    targets: Literal["all-linear"] | Annotated[tuple[str, ...], MinLen(1)] = "all-linear"
    """The layers that have one, by the ends of their names; by default all linear ones but the last."""

    @property
    def config(self) -> External:
        """Return the settings as a peft configuration; MissingExtraError if it is not installed."""
        targets = self.targets if isinstance(self.targets, str) else list(self.targets)
        return library("peft").LoraConfig(
            r=self.rank,
            lora_alpha=self.alpha,
            lora_dropout=self.dropout,
            target_modules=targets,
            task_type="CAUSAL_LM",
        )


def muon_with_adamw(
    model: External,
    muon_learning_rate: float,
    learning_rate: float,
    weight_decay: float = 0.0,
) -> External:
    """Return an optimizer of all trainable parameters of a model.

    Muon updates the matrices of hidden layers, at `muon_learning_rate`. AdamW updates embeddings, the last layer, and
    all vectors, at `learning_rate`; vectors, such as those of normalisation, have no weight decay. A step of Muon has a
    fixed norm, so that its rate depends neither on the loss nor on gradient clipping.
    """
    outer = {
        id(parameter)
        for layer in (model.get_input_embeddings(), model.get_output_embeddings())
        if layer is not None
        for parameter in layer.parameters()
    }
    trained = [parameter for parameter in model.parameters() if parameter.requires_grad]
    vectors = [parameter for parameter in trained if parameter.ndim != 2 and id(parameter) not in outer]
    matrices = [parameter for parameter in trained if parameter.ndim == 2 and id(parameter) not in outer]
    ends = [parameter for parameter in trained if id(parameter) in outer]
    muon = library("torch").optim.Muon(matrices, lr=muon_learning_rate, weight_decay=weight_decay)
    adamw = library("torch").optim.AdamW(
        [{"params": ends, "weight_decay": weight_decay}, {"params": vectors, "weight_decay": 0.0}], lr=learning_rate
    )
    return _together()([muon, adamw])


@cache
def _together() -> External:
    """Return the optimizer class, defined once torch is imported."""
    torch = library("torch")

    class Together(torch.optim.Optimizer):
        """Several optimizers of different parameters, one after the other; a scheduler sees the groups of all."""

        def __init__(self, parts: list[Any]) -> None:
            self.parts = parts
            super().__init__([group for part in parts for group in part.param_groups], {})

        def step(self, closure: Callable[[], float] | None = None) -> float | None:
            loss = closure() if closure is not None else None
            for part in self.parts:
                part.step()
            return loss

        def state_dict(self) -> dict[str, Any]:
            return {"parts": [part.state_dict() for part in self.parts]}

        def load_state_dict(self, state_dict: dict[str, Any]) -> None:
            for part, part_state in zip(self.parts, state_dict["parts"], strict=True):
                part.load_state_dict(part_state)
            self.param_groups = [group for part in self.parts for group in part.param_groups]  # those that it replaced

    return Together
