"""What becomes of a dataset under faults, kills and a full disk: python benchmarks/chaos.py [items] [kills].

One item in a hundred goes wrong: it ends its process by a segmentation fault or an exit, hangs, raises an error that
can't be pickled or told, or asks for more memory than there is. Three in ten are empty or repeat others, so that later
positions take their place. Then the same run is killed (SIGKILL) at random times and gone on with until it ends; four
processes make a part each at once; and a run meets disks that are full at several sizes. Told are how many of the other
items are there, which are lost or there twice, files that are torn, and whether the bytes at the end are those of a run
that nobody disturbed. By default 2500 items and 50 kills. Exit code 1: something is lost, there twice, torn or of other
bytes, or there are fewer items than were asked for, or fewer kills.
"""

import argparse
import ctypes
import os
import random
import resource
import shutil
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Sequence
from hashlib import sha256
from pathlib import Path
from tempfile import TemporaryDirectory
from threading import Lock

HERE = Path(__file__).resolve().parent
SUPPORT = HERE.parent / "tests" / "support"
sys.path += [str(HERE), str(SUPPORT)]

from fake_makers import steady  # noqa: E402 - it lies where the path now leads
from sim2reason.datasets.dataset import Dataset  # noqa: E402 - the same
from sim2reason.datasets.store import count  # noqa: E402 - the same
from sim2reason.errors import Sim2ReasonError  # noqa: E402 - the same
from sim2reason.generation.request import Made, Request  # noqa: E402 - the same

SHARD = 50
PATIENCE = 2.0  # s: all but those that hang take milliseconds
SLOW = 0.003  # s an item, so that there is time to be killed
SEED = 7
SAME = 5  # texts that many items repeat
ROOM = 0.1, 0.3, 0.5, 0.7, 0.9  # of what the dataset needs, on disks that are too small
FULL = "full-disk"  # as an argument: this process has a mount namespace of its own


class UntellableError(Exception):
    """It holds what no pipe can carry, and can't even be told."""

    def __str__(self) -> str:
        """No words at all."""
        raise self


def segfault() -> None:
    ctypes.string_at(0)


def leave() -> None:
    os._exit(3)


def hang() -> None:
    while True:
        time.sleep(1.0)


def raise_untellable() -> None:
    raise UntellableError(Lock())


def eat() -> None:
    """Meet a limit of the address space."""
    before = resource.getrlimit(resource.RLIMIT_AS)
    resource.setrlimit(resource.RLIMIT_AS, (2**32, before[1]))
    try:
        _ = [bytearray(2**28) for _ in range(64)]
    finally:
        resource.setrlimit(resource.RLIMIT_AS, before)


FAULTS = segfault, leave, hang, raise_untellable, eat


def fault_of(request: Request) -> int:
    """Which fault a request has; beyond the last one for none. One in a hundred has some."""
    return int.from_bytes(sha256(f"fault {request.id}".encode()).digest()[:4], "big") % (100 * len(FAULTS))


def make(request: Request) -> Made:
    """Steady, but slow, and with faults."""
    time.sleep(SLOW)
    fault = fault_of(request)
    if fault < len(FAULTS):
        FAULTS[fault]()
    return made(request)


def made(request: Request) -> Made:
    """What is made where nothing goes wrong: no item, or one that repeats the words of another, for three in ten."""
    kind = int.from_bytes(sha256(f"kind {request.id}".encode()).digest()[:4], "big") % 10
    found = steady(request)
    if found.item is None or kind > 2:
        return found
    words = f"One of {SAME} texts: {request.index % SAME}."
    return Made(found.item.model_copy(update={"prompt": words}) if kind else None, found.rejected)


def start(out: Path, items: int, *options: str) -> "subprocess.Popen[bytes]":
    code = "from sim2reason.cli import main; main()"
    fixed = ["--items", str(items), "--recipe", "incline,pulley", "--shard-size", str(SHARD), "--maker", "chaos:make"]
    paths = os.pathsep.join([str(HERE), str(SUPPORT), os.environ.get("PYTHONPATH", "")])
    return subprocess.Popen(
        [sys.executable, "-c", code, "generate", str(out), *fixed, "--patience", str(PATIENCE), *options],
        env=os.environ | {"PYTHONPATH": paths},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
    )


def finish(out: Path, items: int, *options: str) -> tuple[int, str]:
    run = start(out, items, *options)
    _, told = run.communicate()
    return run.returncode, told.decode().strip()


def content(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def torn(out: Path) -> int:
    """Files of items that are not whole."""
    bad = 0
    for path in out.glob("data/*.parquet"):
        try:
            count(path)
        except (OSError, ValueError):
            bad += 1
    return bad


def report(name: str, out: Path, whole: dict[str, bytes], broken: int) -> bool:
    """Tell what became of a dataset; whether it is as it should be."""
    data = Dataset(out)
    config, tried = data.manifest.config, data.manifest.positions
    sound = [request for request in map(config.request, range(tried)) if fault_of(request) >= len(FAULTS)]
    first = dict[str, str]()  # of those that say the same, the one at the lowest position
    for item in (made(request).item for request in sound):
        if item is not None:
            first.setdefault(item.prompt, item.id)
    wanted = set(first.values())
    ids = Counter(item.id for item in data)
    quarantined = data.manifest.refused["quarantined"].total
    same, twice = content(out) == whole, sum(n - 1 for n in ids.values())
    print(
        f"{name}: {len(wanted & ids.keys()) / len(wanted):.2%} of {len(wanted)} others finished, "
        f"{len(wanted - ids.keys())} lost, {twice} twice, {broken} torn, "
        f"{len(data)} of {config.items} asked for, {quarantined} of {tried - len(sound)} faults quarantined; "
        f"{'the same bytes' if same else 'OTHER BYTES'}",
        flush=True,
    )
    return same and len(data) == config.items and not (wanted - ids.keys() or twice or broken)


def killed(out: Path, items: int, kills: int) -> tuple[int, int]:
    """Kill runs at random times, so many times, then let one end; give the kills, and files that were torn."""
    rng, broken, done = random.Random(SEED), 0, 0
    while done < kills:
        before = len(list(out.glob("data/*.parquet")))
        run = start(out, items, "--workers", str(rng.choice((1, 2, 4))))
        more, end = rng.choice((0, 0, 1)), time.monotonic() + 60.0
        while len(list(out.glob("data/*.parquet"))) < before + more and run.poll() is None and time.monotonic() < end:
            time.sleep(0.005)
        time.sleep(rng.uniform(0.0, 0.3) if more else rng.uniform(0.0, 2.0))
        run.kill()
        run.communicate()
        broken += torn(out)
        if run.returncode == 0:
            print("it has finished before all kills: ask for more items")
            return done, broken
        done += 1
    code, told = finish(out, items, "--workers", "2")
    assert code == 0, told
    return done, broken + torn(out)


def parts(out: Path, items: int) -> None:
    """Four processes at once make a part each, a fifth ends their work."""
    runs = [start(out, items, "--workers", "1", "--shard", f"{number}/4") for number in (1, 2, 3, 4)]
    for run in runs:
        _, told = run.communicate()
        assert run.returncode == 0, told.decode()
    code, told = finish(out, items, "--workers", "1")
    assert code == 0, told


def full_disk(folder: Path, whole: Path, items: int) -> bool:
    """Runs on disks of several sizes: whether each ends in one line, and in the same bytes once there is room."""
    wanted, good = content(whole), True
    for size in [int(share * sum(map(len, wanted.values())) / 1000) for share in ROOM]:
        place = folder / f"disk-{size}"
        place.mkdir()
        subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}k", "none", str(place)], check=True)
        code, told = finish(place / "out", items, "--workers", "2")
        line = told.splitlines()[-1] if told else ""
        broken = torn(place / "out")
        subprocess.run(["mount", "-o", "remount,size=1g", str(place)], check=True)
        again, _ = finish(place / "out", items, "--workers", "2")
        same = again == 0 and content(place / "out") == wanted
        print(
            f"disk of {size} kB: exit code {code}, {broken} torn, {'the same bytes' if same else 'OTHER BYTES'} after"
        )
        print(f"  {line}", flush=True)
        good = good and same and not broken and (code == 0 or line.startswith("sim2reason: "))
        subprocess.run(["umount", str(place)], check=True)
    return good


def main(items: int = 2500, kills: int = 50) -> bool:
    """Whether all is as it should be."""
    with TemporaryDirectory() as scratch:
        folder = Path(scratch)
        begin = time.monotonic()
        code, told = finish(folder / "whole", items, "--workers", "2")
        assert code == 0, told
        whole = content(folder / "whole")
        good = [report("undisturbed", folder / "whole", whole, torn(folder / "whole"))]
        done, broken = killed(folder / "killed", items, kills)
        good += [report(f"{done} kills", folder / "killed", whole, broken), done >= kills]
        parts(folder / "parts", items)
        good.append(report("4 parts at once", folder / "parts", whole, torn(folder / "parts")))
        if shutil.which("unshare") is None:
            print("full disk: needs unshare (Linux)")
        else:
            arguments = [sys.executable, __file__, FULL, str(folder), str(folder / "whole"), str(items)]
            run = subprocess.run(["unshare", "--map-root-user", "--mount", *arguments], check=False)
            good.append(run.returncode == 0)
        print(f"{time.monotonic() - begin:.0f} s in all")
    return all(good)


def started(arguments: Sequence[str]) -> bool:
    if arguments[:1] == [FULL]:
        return full_disk(Path(arguments[1]), Path(arguments[2]), int(arguments[3]))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("items", type=int, nargs="?", default=2500, help="how many (default: 2500)")
    parser.add_argument("kills", type=int, nargs="?", default=50, help="how many (default: 50)")
    return main(**vars(parser.parse_args(arguments)))


if __name__ == "__main__":
    try:
        sys.exit(0 if started(sys.argv[1:]) else 1)
    except Sim2ReasonError as error:
        sys.exit(str(error))
