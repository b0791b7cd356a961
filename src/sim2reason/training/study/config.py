"""Configuration of a study: a base run of reinforcement learning, the changes of each arm, and seeds."""

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, NamedTuple, Self, cast

from annotated_types import Ge, Le, MinLen
from pydantic import BaseModel, BeforeValidator, ConfigDict, TypeAdapter, model_validator

from sim2reason.base.records import cached_property
from sim2reason.base.settings import configuration, read_settings
from sim2reason.errors import Sim2ReasonError, TrainingError
from sim2reason.evaluation.policies import Name
from sim2reason.generation.request import MAX_SEED
from sim2reason.training.rl.config import ReinforcementLearning, build_reinforcement_learning

__all__ = ["Arm", "TrainingStudy", "build_study"]

SEED_STRIDE = 1_000_003
"""Between the seeds from which runs with neighbouring seeds draw their problems."""
MAX_RUNS = 1000
Settings = dict[str, Any]
Seeds = Annotated[tuple[Annotated[int, Ge(0), Le(2**31)], ...], MinLen(1)]
SEEDS = TypeAdapter[tuple[int, ...]](Seeds)


def _base(given: object) -> object:
    """Return the base settings, given directly or as a file."""
    return read_settings(Path(given)) if isinstance(given, str | Path) else given


class Arm(NamedTuple):
    """One run of a study: the name of an arm (a variation of the settings), and a seed."""

    name: str
    seed: int

    @property
    def run(self) -> str:
        """Return the name of the run's folder."""
        return f"{self.name}-{self.seed}"


class TrainingStudy(BaseModel):
    """The settings of a study."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    out: Path
    """The folder of the study."""
    base: Annotated[Settings, BeforeValidator(_base)]
    """A configuration of ``train rl``, without its folder, or the file of one."""
    arms: Annotated[dict[Name, Settings], MinLen(1)]
    """What each changes in the base: settings within settings take the place of those of the same name, a list as a
    whole. An empty one is the base itself. `seeds` in one stands for those of the study."""
    seeds: Seeds = (0,)
    """Of what is sampled in reinforcement learning; each draws problems of its own, too. What is held out and the warm
    start have seeds of their own and stay."""
    workers: Annotated[int, Ge(1), Le(1024)] = 1
    """Runs that go on at once."""

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        for name in self.arms:
            if len(set(self.seeds_of(name))) < len(self.seeds_of(name)):
                raise ValueError(f"arms.{name}: a seed stands twice")
        if len(self.runs) > MAX_RUNS:
            raise ValueError(f"arms: {len(self.runs)} runs, and at most {MAX_RUNS} are possible")
        held_out_by_arm = {name: self.first(name).decisive["held_out"] for name in self.arms}
        first = next(iter(held_out_by_arm))
        if differs := [name for name in held_out_by_arm if held_out_by_arm[name] != held_out_by_arm[first]]:
            raise ValueError(f"arms.{differs[0]}: other held-out problems than {first}; runs could not be compared")
        return self

    @property
    def runs(self) -> list[Arm]:
        """Return all runs in order."""
        seeds = dict.fromkeys(seed for name in self.arms for seed in self.seeds_of(name))
        return [Arm(name, seed) for seed in seeds for name in self.arms if seed in self.seeds_of(name)]

    def seeds_of(self, arm: str) -> tuple[int, ...]:
        """Return the seeds of an arm; ValueError if they are invalid."""
        return SEEDS.validate_python(self.arms[arm]["seeds"]) if "seeds" in self.arms[arm] else self.seeds

    def first(self, arm: str) -> ReinforcementLearning:
        """Return the configuration of the first run of an arm: the run with the arm's first seed."""
        return self.configs[Arm(arm, self.seeds_of(arm)[0])]

    @cached_property
    def settings(self) -> dict[Arm, Settings]:
        """Return, for each run of the study, its settings as for ``train rl``."""
        return {arm: self._settings(arm) for arm in self.runs}

    @cached_property
    def configs(self) -> dict[Arm, ReinforcementLearning]:
        """Return, for each run of the study, its configuration parsed from its settings."""
        by_arm: dict[Arm, ReinforcementLearning] = {}
        for arm, settings in self.settings.items():
            try:
                by_arm[arm] = build_reinforcement_learning(settings)
            except Sim2ReasonError as error:
                error.args = (f"arms.{arm.name}: {error}", *error.args[1:])
                raise
        return by_arm

    def _settings(self, arm: Arm) -> Settings:
        change = {name: value for name, value in self.arms[arm.name].items() if name != "seeds"}
        merged = _merged(self.base, change)
        merged["out"] = str(self.out / "runs" / arm.run)
        gspo = merged.get("gspo", {})
        if isinstance(gspo, Mapping):
            merged["gspo"] = {**cast("Settings", gspo), "seed": arm.seed}
        sources = merged.get("problems")
        if isinstance(sources, list):
            merged["problems"] = [_drawn_anew(source, arm.seed) for source in cast("list[object]", sources)]
        return merged


def _merged(base: Mapping[str, Any], change: Mapping[str, Any]) -> Settings:
    """Return settings with changes merged into them."""
    merged = dict(base)
    for name, value in change.items():
        current = merged.get(name)
        both = isinstance(current, Mapping) and isinstance(value, Mapping) and "kind" not in value
        merged[name] = _merged(cast("Settings", current), cast("Settings", value)) if both else value
    return merged


def _drawn_anew(given: object, seed: int) -> object:
    """Return a source of problems with a new seed derived from its own and the run's; a file has no seed."""
    if not isinstance(given, Mapping) or "seed" not in given:
        return cast("object", given)
    settings = cast("Settings", given)
    first = settings["seed"]
    return {**settings, "seed": (first + SEED_STRIDE * seed) % MAX_SEED if isinstance(first, int) else first}


def build_study(config: "Path | str | Mapping[str, object] | TrainingStudy", out: Path | None = None) -> TrainingStudy:
    """Return the study in a YAML file or settings; `out` overrides the output folder.

    Relative paths refer to the current working directory.

    Raises:
        TrainingError: what is missing, unknown or makes no sense; the line names its place.
        EvaluationError: a file that is no YAML.
        UnknownNameError: no such kind of model, source or reward.
    """
    if isinstance(config, TrainingStudy):
        return config if out is None else config.model_copy(update={"out": out})
    return configuration(config, out, TrainingStudy.model_validate, TrainingError, TrainingStudy)
