"""Serve a tiny model of random weights, made here, by vLLM on CPUs: ``python vllm_server.py FOLDER [KEY]``.

Prints the address at once, answers after a while, and serves until killed. Needs vLLM, in a separate environment.
"""

import os
import socket
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "support"))
from tiny import CONTEXT, TEMPLATE

from gspo_run import tiny_model


def free_port() -> int:
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


def main(folder: Path, key: str) -> None:
    """Make the model, and serve it on a free port."""
    model, port = tiny_model(folder / "tiny", heads=1), free_port()
    (model / "chat_template.jinja").write_text(TEMPLATE)
    sys.stdout.write(f"http://127.0.0.1:{port}/v1\n")
    sys.stdout.flush()
    named = {
        "served-model-name": "tiny",
        "host": "127.0.0.1",
        "port": port,
        "max-model-len": CONTEXT,
        "dtype": "float32",
        **({"api-key": key} if key else {}),
    }
    given = (part for name, value in named.items() for part in (f"--{name}", str(value)))
    os.environ["VLLM_CPU_KVCACHE_SPACE"] = "1"  # GiB
    server = [sys.executable, "-m", "vllm.entrypoints.openai.api_server", "--model", str(model)]
    os.execv(sys.executable, [*server, *given, "--enforce-eager"])


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else "")
