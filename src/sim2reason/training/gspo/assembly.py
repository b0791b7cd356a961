"""Construction of a GSPO trainer from settings."""

# torch, trl, peft and transformers are an extra and ship no types to an environment without them:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sim2reason.training.extras import library
from sim2reason.training.gspo.settings import GSPOSettings, PromptStream, VllmSettings
from sim2reason.training.models import Checkpoint

if TYPE_CHECKING:
    from sim2reason.training.gspo.trainer import GSPOTrainer

__all__ = ["make_trainer"]

Reward = Callable[..., list[float | None]]


def make_trainer(
    model: Any,  # noqa: ANN401 - a checkpoint, its path or name, or a model of transformers
    tokenizer: Any,  # noqa: ANN401 - of transformers
    stream: PromptStream,
    rewards: Sequence[Reward],
    settings: GSPOSettings,
    out: str | Path,
    *,
    weights: Sequence[float] | None = None,
) -> "GSPOTrainer":
    """Return a trainer of a checkpoint (object, folder or name) or of a causal language model.

    It writes into the folder `out`. Rewards are functions in TRL's form, ``reward(prompts, completions, **columns)``,
    which return a number or None for each completion; the training signal is their sum, with optional `weights`.
    ``trainer.train()`` trains, and ``trainer.train(resume_from_checkpoint=True)`` resumes after a kill; `model` must
    then be the original one, the reference of the KL divergence. All processes of ``accelerate launch`` or ``torchrun``
    make the same call, and only the first one reads the stream.

    Raises:
        MissingExtraError: the libraries of the extra [train] are not installed.
        TrainingError: another version of TRL is installed, or the settings don't fit the number of processes.
    """
    trainer = library("sim2reason.training.gspo.trainer")
    args = _arguments(settings, Path(out), weights)
    tuned = None if settings.lora is None else settings.lora.config
    if isinstance(model, str | Path):
        model = Checkpoint(str(model))
    if isinstance(model, Checkpoint):  # its reference is loaded alike
        args.model_init_kwargs = {**_weights(settings), **model.settings}
        model = model.path
    elif tuned is None:
        _prepare(model, Path(out) / "reference", args)
    given = {"model": model, "reward_funcs": list(rewards), "processing_class": tokenizer}
    return trainer.GSPOTrainer(stream, settings, args=args, peft_config=tuned, **given)


def _arguments(settings: GSPOSettings, out: Path, weights: Sequence[float] | None) -> Any:  # noqa: ANN401 - TRL's own
    """Return TRL's configuration."""
    cpu = not library("torch").accelerator.is_available()  # or accelerate would leave two processes unconnected
    processes = int(library("accelerate").PartialState(cpu=cpu).num_processes)
    micro, accumulation = settings.shares(processes)
    return library("trl").GRPOConfig(
        output_dir=str(out),
        reward_weights=None if weights is None else list(weights),
        use_cpu=cpu,
        ddp_find_unused_parameters=False,
        seed=settings.seed,
        shuffle_dataset=False,
        ignore_data_skip=True,
        report_to=list(settings.report_to),
        disable_tqdm=True,
        **_objective(settings),
        **_rollouts(settings),
        **_updates(settings, micro, accumulation),
    )


def _weights(settings: GSPOSettings) -> dict[str, Any]:
    """Return the data type of the model's weights for loading: bfloat16 for frozen ones, else float32."""
    frozen = settings.precision == "bfloat16" and settings.lora  # below adapters they need no float32
    return {"dtype": "bfloat16" if frozen else "float32"}


def _objective(settings: GSPOSettings) -> dict[str, Any]:
    return {
        "loss_type": "grpo",
        "importance_sampling_level": "sequence",
        "scale_rewards": "group",
        "epsilon": settings.epsilon_low,
        "epsilon_high": settings.epsilon_high,
        "beta": settings.beta,
        "use_bias_correction_kl": False,
    }


def _updates(settings: GSPOSettings, micro: int, accumulation: int) -> dict[str, Any]:
    """Return TRL's options for batches and intervals, with steps converted to optimizer updates."""
    every = settings.minibatches
    new_name = "activation_checkpointing"  # since transformers 5.2x, which warns of the old one
    known = library("trl").GRPOConfig.__dataclass_fields__
    return {
        "per_device_train_batch_size": micro,
        "gradient_accumulation_steps": accumulation,
        "steps_per_generation": accumulation * every,
        "max_steps": settings.steps * every,
        "learning_rate": settings.learning_rate,
        "lr_scheduler_type": "constant_with_warmup",
        "warmup_steps": settings.warmup_steps * every,
        "weight_decay": settings.weight_decay,
        "max_grad_norm": settings.max_grad_norm,
        "bf16": settings.precision == "bfloat16",
        new_name if new_name in known else "gradient_checkpointing": settings.gradient_checkpointing,
        "logging_steps": every,
        "save_steps": settings.save_every * every,
        "save_total_limit": settings.keep,
    }


def _rollouts(settings: GSPOSettings) -> dict[str, Any]:
    """Return TRL's options for the generation of completions."""
    options: dict[str, Any] = {
        "num_generations": settings.generations,
        "max_completion_length": settings.max_completion_tokens,
        "temperature": settings.temperature,
    }
    vllm: VllmSettings | None = settings.vllm
    if vllm is None:
        return options
    return options | {
        "use_vllm": True,
        "vllm_mode": vllm.mode,
        "vllm_gpu_memory_utilization": vllm.memory,
        "vllm_tensor_parallel_size": vllm.tensor_parallel,
        "vllm_enable_sleep_mode": vllm.sleep,
        "vllm_server_base_url": vllm.address,
        "vllm_max_model_length": settings.max_prompt_tokens + settings.max_completion_tokens,
        "vllm_importance_sampling_correction": vllm.correction,
        "vllm_importance_sampling_mode": "sequence_mask",  # one ratio for each completion, as GSPO's own
    }


def _prepare(model: Any, folder: Path, args: Any) -> None:  # noqa: ANN401 - transformers' own
    """Convert a model in memory to float32; save it if a reference model is needed, which TRL loads by path."""
    model.float()
    if not args.beta:
        return
    with args.main_process_first(desc="reference"):
        if args.process_index == 0:
            model.save_pretrained(folder)
    model.config._name_or_path = str(folder)  # noqa: SLF001 - where TRL looks
