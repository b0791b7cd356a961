"""Serve a tiny model of random weights, made here, by llama.cpp: ``python llama_server.py FOLDER [KEY]``.

Prints the address, and serves until killed. Needs xllamacpp and gguf, in a separate environment.
"""

import sys
import time
from pathlib import Path

import numpy as np
from gguf import GGUFWriter, TokenType
from tiny import CONTEXT, TEMPLATE
from xllamacpp import CommonParams, Server

WIDE, HEADS, LAYERS, INNER = 64, 4, 2, 128


def byte_letters() -> list[str]:
    """Return the printable character for each byte in vocabularies such as GPT-2's."""
    printable = [*range(33, 127), *range(161, 173), *range(174, 256)]
    others = iter(range(256, 512))
    return [chr(byte) if byte in printable else chr(next(others)) for byte in range(256)]


def write_model(path: Path) -> None:
    """Write a model of the Llama architecture with one token per byte, of about 400 kB."""
    draws = np.random.default_rng(0)
    letters = byte_letters()
    pair = letters[ord("t")] + letters[ord("h")]
    tokens = [*letters, pair, "<|end|>"]
    writer = GGUFWriter(path, "llama")
    writer.add_name("tiny")
    writer.add_context_length(CONTEXT)
    writer.add_embedding_length(WIDE)
    writer.add_block_count(LAYERS)
    writer.add_feed_forward_length(INNER)
    writer.add_head_count(HEADS)
    writer.add_head_count_kv(HEADS)
    writer.add_layer_norm_rms_eps(1e-5)
    writer.add_rope_dimension_count(WIDE // HEADS)
    writer.add_vocab_size(len(tokens))
    writer.add_tokenizer_model("gpt2")
    writer.add_tokenizer_pre("gpt-2")
    writer.add_token_list(tokens)
    writer.add_token_types([TokenType.NORMAL] * (len(tokens) - 1) + [TokenType.CONTROL])
    writer.add_token_merges([f"{pair[0]} {pair[1]}"])
    writer.add_eos_token_id(len(tokens) - 1)
    writer.add_bos_token_id(len(tokens) - 1)
    writer.add_add_bos_token(False)
    writer.add_chat_template(TEMPLATE)

    def matrix(name: str, *shape: int) -> None:
        values = np.ones(shape) if len(shape) == 1 else draws.normal(0.0, 2.0 / shape[-1] ** 0.5, shape)
        writer.add_tensor(name, values.astype(np.float32))

    matrix("token_embd.weight", len(tokens), WIDE)
    matrix("output_norm.weight", WIDE)
    matrix("output.weight", len(tokens), WIDE)
    for layer in range(LAYERS):
        for name in ("attn_q", "attn_k", "attn_v", "attn_output"):
            matrix(f"blk.{layer}.{name}.weight", WIDE, WIDE)
        matrix(f"blk.{layer}.attn_norm.weight", WIDE)
        matrix(f"blk.{layer}.ffn_norm.weight", WIDE)
        matrix(f"blk.{layer}.ffn_gate.weight", INNER, WIDE)
        matrix(f"blk.{layer}.ffn_up.weight", INNER, WIDE)
        matrix(f"blk.{layer}.ffn_down.weight", WIDE, INNER)
    writer.write_header_to_file()
    writer.write_kv_data_to_file()
    writer.write_tensors_to_file()
    writer.close()


def main(folder: Path, key: str) -> None:
    """Make the model, serve it on a free port, and wait."""
    model = folder / "tiny.gguf"
    write_model(model)
    params = CommonParams()
    params.model.path = str(model)
    params.model_alias = {"tiny"}
    params.n_ctx = CONTEXT * 2
    params.n_parallel = 2
    params.port = 0
    params.cpuparams.n_threads = 1
    params.cpuparams_batch.n_threads = 1
    if key:
        params.api_keys = [key]
    server = Server(params)
    sys.stdout.write(f"{server.listening_address}/v1\n")
    sys.stdout.flush()
    while True:
        time.sleep(60.0)


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else "")
