"""SIGINT ends a command with one line, whenever it comes."""

import os
import signal
import subprocess
import sys
import time
from contextlib import suppress

import pytest

from sim2reason.cli import interrupts
from sim2reason.datasets.interrupts import deaf_children


def interrupt() -> None:
    os.kill(os.getpid(), signal.SIGINT)


def test_what_was_swallowed_is_raised_again(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(interrupts, "PATIENCE", 0.05)
    reached = list[str]()

    def work() -> None:
        with suppress(KeyboardInterrupt):  # as a module in C does
            interrupt()
        reached.append("after it")
        time.sleep(10.0)

    with pytest.raises(KeyboardInterrupt), interrupts.heard():
        work()
    assert reached == ["after it"]


def test_afterwards_all_is_as_before(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(interrupts, "PATIENCE", 0.05)
    before = signal.getsignal(signal.SIGINT), signal.getsignal(signal.SIGALRM)
    with pytest.raises(KeyboardInterrupt), interrupts.heard():
        interrupt()
    assert (signal.getsignal(signal.SIGINT), signal.getsignal(signal.SIGALRM)) == before
    time.sleep(0.2)  # no alarm is left


def test_where_it_is_ignored_it_stays_so() -> None:
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        with interrupts.heard():
            interrupt()
            assert signal.getsignal(signal.SIGINT) is signal.SIG_IGN
    finally:
        signal.signal(signal.SIGINT, before)


def test_children_hear_nothing_and_their_parent_does() -> None:
    code = "import os, signal, time; time.sleep(0.3); print('whole')"
    with deaf_children():
        child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
    child.send_signal(signal.SIGINT)
    assert child.communicate()[0] == "whole\n"
    with pytest.raises(KeyboardInterrupt):
        interrupt()


def test_while_the_command_loads_it_is_one_line() -> None:
    code = (
        "import os, signal, sys\n"
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
        "class Interrupt:\n"
        "    def find_spec(self, name, *_):\n"
        "        if name == 'click': os.kill(os.getpid(), signal.SIGINT)\n"
        "sys.meta_path.insert(0, Interrupt())\n"
        "from sim2reason.__main__ import main; main()"
    )
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert (result.returncode, result.stdout, result.stderr) == (130, "", "sim2reason: interrupted\n")
