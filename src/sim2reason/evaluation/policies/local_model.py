"""Policies in this process: models of the transformers library, and a constant text as a baseline.

Models need the packages of the extra ``train``.
"""

# transformers and torch are an extra, and are spoken to in this module alone:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from collections.abc import Sequence
from contextlib import AbstractContextManager
from typing import Annotated, Any, ClassVar, Literal, NamedTuple

from annotated_types import Ge, Le

from sim2reason.base.optional import optional
from sim2reason.base.records import cached_property
from sim2reason.errors import PolicyError
from sim2reason.evaluation.policies import POLICIES, Completion, Finish, Policy, SampleRequest
from sim2reason.evaluation.policies.decoding import Decoder
from sim2reason.evaluation.policies.network import explain_errors, loading_arguments, silence_library

__all__ = ["Constant", "LocalModel"]


@POLICIES.register("constant")
class Constant(Policy):
    """The same text for every prompt."""

    text: str

    def complete(self, requests: Sequence[SampleRequest]) -> Sequence[Completion]:
        """Return the text for each request, with zero tokens."""
        return [Completion(text=self.text, finish="stop", prompt_tokens=0, completion_tokens=0) for _ in requests]


MAX_RANDOM_NUMBERS = 2**24  # random numbers generated together
WISHES = {
    "bad_words_ids": None,
    "begin_suppress_tokens": None,
    "encoder_no_repeat_ngram_size": 0,
    "encoder_repetition_penalty": 1.0,
    "exponential_decay_length_penalty": None,
    "forced_bos_token_id": None,
    "forced_eos_token_id": None,
    "guidance_scale": 1.0,
    "min_length": 0,
    "min_new_tokens": 0,
    "no_repeat_ngram_size": 0,
    "repetition_penalty": 1.0,
    "sequence_bias": None,
    "suppress_tokens": None,
}  # by which a model's own configuration may change logits, with the values that do not
MIN_UNIFORM = 1e-20  # smallest uniform random number, whose logarithm is finite in single precision


class _Loaded(NamedTuple):
    torch: Any
    transformers: Any
    model: Any
    tokenizer: Any
    decoder: Decoder | None


@POLICIES.register("transformers")
class LocalModel(Policy):
    """A model of the transformers library, by its name or folder, in this process."""

    model: str
    revision: str | None = None
    device: str = "auto"
    """``cpu``, ``cuda``, ``cuda:1`` and so on; by default a GPU if there is one."""
    precision: Literal["auto", "float32", "bfloat16", "float16"] = "auto"
    batch_size: Annotated[int, Ge(1), Le(4096)] = 8
    cuda_graphs: bool = False
    """Whether a batch has a cache of fixed size, and each token on a GPU is the replay of one recorded pass: faster for
    small models, for the memory of a whole batch's longest answers."""
    system: str = ""
    """A message before the prompt."""
    chat: bool = True
    """Whether prompts are put into the tokenizer's chat template, if it has one."""

    operational: ClassVar[frozenset[str]] = Policy.operational | {"batch_size", "cuda_graphs", "device"}

    @property
    def batch(self) -> int:
        """Return `batch_size`."""
        return self.batch_size

    @cached_property
    def _load(self) -> _Loaded:
        torch, transformers = optional("torch", "train"), optional("transformers", "train")
        device = self._device(torch)
        with self._explained(), silence_library():
            source = self._source
            tokenizer = transformers.AutoTokenizer.from_pretrained(self.model, padding_side="left", **source)
            model = transformers.AutoModelForCausalLM.from_pretrained(self.model, dtype=self.precision, **source)
        if tokenizer.pad_token_id is None:
            tokenizer.pad_token = tokenizer.eos_token
        try:
            model = model.to(device).eval()
        except RuntimeError as error:  # it has not the memory, say
            why = " ".join(str(error).split())[:200]
            raise PolicyError(f"policy {self.name!r}: the model can't be moved to {device}: {why}") from None
        return _Loaded(torch, transformers, model, tokenizer, self._decoder(model))

    def _decoder(self, model: Any) -> Decoder | None:  # noqa: ANN401 - of transformers
        """Return the decoder with CUDA graphs, or None if unwanted; PolicyError if the model's settings rule it out."""
        if not self.cuda_graphs:
            return None
        settings = {name: getattr(model.generation_config, name, None) for name in WISHES}
        if unsupported := [name for name, value in settings.items() if value not in (None, WISHES[name])]:
            raise PolicyError(
                f"policy {self.name!r}: cuda_graphs: the model asks for {unsupported[0]}; leave cuda_graphs out"
            )
        return Decoder(model)

    def check(self) -> None:
        """Check the libraries, the device and the model's configuration."""
        torch, transformers = optional("torch", "train"), optional("transformers", "train")
        self._device(torch)
        with self._explained(), silence_library():
            transformers.AutoConfig.from_pretrained(self.model, **self._source)

    @property
    def _source(self) -> dict[str, Any]:
        return loading_arguments(self.model, self.revision)

    def _explained(self) -> AbstractContextManager[None]:
        return explain_errors(self.model, lambda why: PolicyError(f"policy {self.name!r}: {why}"))

    def _device(self, torch: Any) -> str:  # noqa: ANN401 - a module of an extra
        """Return the device of the model; PolicyError, with the available ones, if it does not exist."""
        kind = str(torch.accelerator.current_accelerator().type) if torch.accelerator.is_available() else ""
        count = torch.accelerator.device_count() if kind else 0
        there = ["cpu", *([kind] if kind else []), *(f"{kind}:{number}" for number in range(count))]
        if self.device == "auto":
            return "cuda" if "cuda" in there else "cpu"
        if self.device not in there:
            known = ", ".join(there)
            raise PolicyError(f"policy {self.name!r}: there is no device {self.device!r}; there are: {known}")
        return self.device

    def complete(self, requests: Sequence[SampleRequest]) -> Sequence[Completion]:
        """Return completions generated together; each uses its own random generator, so it depends only on its seed."""
        tokenizer, device = self._load.tokenizer, self._load.model.device
        given = tokenizer([self._spoken(request.prompt) for request in requests], return_tensors="pt", padding=True)
        ids, mask = given["input_ids"].to(device), given["attention_mask"].to(device)
        processors = self._processors([request.seed for request in requests])
        decoder = self._load.decoder
        rows = (
            self._generated(ids, mask, processors) if decoder is None else self._decoded(decoder, ids, mask, processors)
        )
        ends, lengths = self._ends(), mask.sum(dim=1).tolist()
        return [self._completion(row, length, ends) for row, length in zip(rows.tolist(), lengths, strict=True)]

    def _generated(self, ids: Any, mask: Any, processors: list[Any]) -> Any:  # noqa: ANN401 - tensors
        """Return the tokens after the prompts from transformers' own loop."""
        torch, _, model, tokenizer, _ = self._load
        with torch.inference_mode():
            rows = model.generate(
                input_ids=ids,
                attention_mask=mask,
                do_sample=False,
                temperature=None,
                top_p=None,
                top_k=None,
                max_new_tokens=self.sampling.max_tokens,
                logits_processor=processors,
                pad_token_id=tokenizer.pad_token_id,
            )
        return rows[:, ids.shape[1] :]

    def _decoded(self, decoder: Decoder, ids: Any, mask: Any, processors: list[Any]) -> Any:  # noqa: ANN401 - tensors
        """Return the tokens after the prompts from the decoder with a fixed-size cache."""

        def choose(logits: Any) -> Any:  # noqa: ANN401 - tensors
            for processor in processors:
                logits = processor(ids, logits)
            return logits.argmax(dim=1)

        return decoder(ids, mask, self.sampling.max_tokens, choose, self._ends())

    def _spoken(self, prompt: str) -> str:
        """Return the text that the model reads for a prompt."""
        tokenizer = self._load.tokenizer
        if not (self.chat and tokenizer.chat_template):
            return f"{self.system}\n\n{prompt}" if self.system else prompt
        system = [{"role": "system", "content": self.system}] if self.system else []
        messages = [*system, {"role": "user", "content": prompt}]
        return tokenizer.apply_chat_template(messages, tokenize=False, add_generation_prompt=True)

    def _processors(self, seeds: Sequence[int]) -> list[Any]:
        """Return logits processors: temperature, nucleus sampling, and Gumbel noise from each row's seed.

        The largest logit with Gumbel noise is a sample of the softmax (Gumbel, Statistical theory of extreme values,
        1954), so greedy search samples each row with its own seed.
        """
        temperature = 1.0 if self.sampling.temperature is None else self.sampling.temperature
        if temperature == 0.0:
            return []
        torch, transformers, model, _, _ = self._load
        processors: list[Any] = [transformers.TemperatureLogitsWarper(temperature)] if temperature != 1.0 else []
        if self.sampling.top_p is not None:
            processors.append(transformers.TopPLogitsWarper(self.sampling.top_p))
        generators = [torch.Generator(device=model.device).manual_seed(seed) for seed in seeds]
        ahead: list[Any] = []  # noise of the next tokens: one call for each row draws that of several

        def noise(_: Any, scores: Any) -> Any:  # noqa: ANN401 - tensors
            if not ahead:
                shape = max(1, min(MAX_RANDOM_NUMBERS // scores.numel(), self.sampling.max_tokens)), scores.shape[1]
                drawn = [torch.rand(shape, generator=each, device=scores.device) for each in generators]
                ahead.extend(reversed(torch.stack(drawn, dim=1)))
            return scores.float() - torch.log(-torch.log(ahead.pop().clamp(MIN_UNIFORM, 1.0 - 1e-7)))

        return [*processors, noise]

    def _ends(self) -> set[int]:
        """Return the tokens at which the model ends a text."""
        end_tokens = self._load.model.generation_config.eos_token_id
        own = self._load.tokenizer.eos_token_id
        return {*(end_tokens if isinstance(end_tokens, list) else [end_tokens]), own} - {None}

    def _completion(self, tokens: list[int], prompt_tokens: int, ends: set[int]) -> Completion:
        """Return the completion of a row of tokens up to its end token."""
        end = next((position for position, token in enumerate(tokens) if token in ends), None)
        finish: Finish = "length" if end is None else "stop"
        kept = tokens if end is None else tokens[:end]
        text = self._load.tokenizer.decode(kept, skip_special_tokens=True)
        count = len(kept) + (end is not None)
        return Completion(text=text, finish=finish, prompt_tokens=int(prompt_tokens), completion_tokens=count)
