"""CPU seconds that `import sim2reason` and `sim2reason --help` take: ``python benchmarks/import_time.py``."""

import resource
import subprocess
import sys
from statistics import median

TASKS = {
    "python -c pass": "pass",
    "import sim2reason": "import sim2reason",
    "sim2reason --help": "import sys; from sim2reason.cli import main; main(['--help'])",
}


def cpu(code: str) -> float:
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([sys.executable, "-c", code], check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


if __name__ == "__main__":
    for name, code in TASKS.items():
        print(f"{name:20} {median(cpu(code) for _ in range(9)):.3f} CPU s")
