"""Six steps of GRPO by TRL on fresh problems, with a tiny model made here; a real run names a checkpoint instead.

pip install . trl   # in a clone of this repository
OMP_NUM_THREADS=1 python examples/train_with_trl.py

`datasets.load_dataset("problems-hf", split="train")` gives the problems of an export in their place.
"""

from itertools import islice

from tokenizers import Tokenizer, decoders, models, pre_tokenizers, trainers
from transformers import PreTrainedTokenizerFast, Qwen2Config, Qwen2ForCausalLM, set_seed
from trl import GRPOConfig, GRPOTrainer

import sim2reason
from sim2reason.rewards import accuracy

set_seed(0)
rows = sim2reason.iterable(recipe=("pulley", "incline"), difficulty="easy", mode="choice", seed=1)

pieces = Tokenizer(models.BPE())
pieces.pre_tokenizer, pieces.decoder = pre_tokenizers.ByteLevel(), decoders.ByteLevel()
letters = [rf"\boxed{{{letter}}}" for letter in "ABCDE"]
learner = trainers.BpeTrainer(vocab_size=512, initial_alphabet=pre_tokenizers.ByteLevel.alphabet())
pieces.train_from_iterator([row["prompt"][0]["content"] for row in islice(rows, 8)], learner)
tokenizer = PreTrainedTokenizerFast(tokenizer_object=pieces, pad_token="<pad>", eos_token="<end>")
tokenizer.add_tokens(letters)
tokenizer.chat_template = "{% for message in messages %}{{ message.content }}<end>{% endfor %}"
shape = {"hidden_size": 64, "intermediate_size": 128, "num_hidden_layers": 2, "num_attention_heads": 4}
model = Qwen2ForCausalLM(Qwen2Config(vocab_size=len(tokenizer), **shape, num_key_value_heads=4))

others = sorted(set(range(len(tokenizer))) - set(tokenizer.convert_tokens_to_ids(letters)))
batch = {"per_device_train_batch_size": 16, "num_generations": 4, "max_completion_length": 1, "max_steps": 6}
guess = {"generation_kwargs": {"suppress_tokens": others}}  # it knows no words yet: let it say nothing but a letter
plain = {"use_cpu": True, "bf16": False, "report_to": "none", "save_strategy": "no", "logging_steps": 1}
fresh = {"shuffle_dataset": False}  # else TRL draws a thousand problems before the first step
config = GRPOConfig(output_dir="run", **batch, **guess, **plain, **fresh)
trainer = GRPOTrainer(model, accuracy, args=config, train_dataset=rows.to_hugging_face(), processing_class=tokenizer)
trainer.train()
print("mean rewards:", [round(log["reward"], 2) for log in trainer.state.log_history if "reward" in log])
