"""Three steps of GRPO by TRL, on a tiny model made here. A real run gives the path or name of a checkpoint instead.

pip install . trl
sim2reason generate problems --items 16
sim2reason export problems --to hf --out problems-hf
OMP_NUM_THREADS=1 python examples/train_with_trl.py problems-hf
"""

import sys

from datasets import load_dataset
from tokenizers import Tokenizer, decoders, models, pre_tokenizers, trainers
from transformers import PreTrainedTokenizerFast, Qwen2Config, Qwen2ForCausalLM
from trl import GRPOConfig, GRPOTrainer

from sim2reason.rewards import accuracy

problems = load_dataset(sys.argv[1], split="train")

pieces = Tokenizer(models.BPE())
pieces.pre_tokenizer, pieces.decoder = pre_tokenizers.ByteLevel(), decoders.ByteLevel()
alphabet = pre_tokenizers.ByteLevel.alphabet()
learner = trainers.BpeTrainer(vocab_size=512, special_tokens=["<pad>", "<end>"], initial_alphabet=alphabet)
pieces.train_from_iterator([row["prompt"][0]["content"] for row in problems], learner)
tokenizer = PreTrainedTokenizerFast(tokenizer_object=pieces, pad_token="<pad>", eos_token="<end>")
tokenizer.chat_template = "{% for message in messages %}{{ message.content }}<end>{% endfor %}"
shape = {"hidden_size": 64, "intermediate_size": 128, "num_hidden_layers": 2, "num_attention_heads": 4}
heads = {"num_key_value_heads": 4, "pad_token_id": 0, "eos_token_id": 1, "bos_token_id": 1}
model = Qwen2ForCausalLM(Qwen2Config(vocab_size=len(tokenizer), **shape, **heads))

batch = {"per_device_train_batch_size": 4, "num_generations": 4, "max_completion_length": 16, "max_steps": 3}
plain = {"use_cpu": True, "bf16": False, "report_to": "none", "save_strategy": "no", "logging_steps": 1}
config = GRPOConfig(output_dir="run", **batch, **plain)
trainer = GRPOTrainer(model, accuracy, args=config, train_dataset=problems, processing_class=tokenizer)
result = trainer.train()
mean = [log["rewards/accuracy/mean"] for log in trainer.state.log_history if "rewards/accuracy/mean" in log]
print(f"{result.global_step} steps; mean rewards: {mean}")
