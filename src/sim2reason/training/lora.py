"""Low-rank adapters: small matrices trained in place of a model's own (Hu et al., LoRA, 2021)."""

from typing import Annotated, Literal

from annotated_types import Ge, Gt, Le, Lt, MinLen
from pydantic import BaseModel, ConfigDict

from sim2reason.training.extras import External, library

__all__ = ["Lora"]


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
