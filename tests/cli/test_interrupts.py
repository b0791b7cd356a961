"""Tests that SIGINT and SIGTERM end a command with one line, at any time."""

import os
import signal
import subprocess
import sys
import time
import warnings
from contextlib import suppress

import pytest

from sim2reason.cli import process
from sim2reason.datasets.processes import SIGNALS, children_ignoring_signals

pytestmark = pytest.mark.usefixtures("heed_interrupts")


def interrupt(number: signal.Signals = signal.SIGINT) -> None:
    os.kill(os.getpid(), number)


@pytest.mark.parametrize("number", SIGNALS)
def test_what_was_swallowed_is_raised_again(monkeypatch: pytest.MonkeyPatch, number: signal.Signals) -> None:
    monkeypatch.setattr(process, "PATIENCE", 0.05)
    reached = list[str]()

    def work() -> None:
        with suppress(KeyboardInterrupt):  # as a module in C does
            interrupt(number)
        reached.append("after it")
        time.sleep(10.0)

    with pytest.raises(KeyboardInterrupt), process.handled_interrupts():
        work()
    assert reached == ["after it"]


def test_afterwards_all_is_as_before(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(process, "PATIENCE", 0.05)
    heeded = *SIGNALS, signal.SIGALRM
    before = [signal.getsignal(number) for number in heeded]
    with pytest.raises(KeyboardInterrupt), process.handled_interrupts():
        interrupt()
    assert [signal.getsignal(number) for number in heeded] == before
    time.sleep(0.2)  # no alarm is left


def test_what_a_library_says_of_being_interrupted_is_not_shown() -> None:
    before = list(warnings.filters)
    with process.handled_interrupts():
        with suppress(KeyboardInterrupt):
            interrupt()
        warnings.warn("a value of another type", stacklevel=1)
    assert warnings.filters == before


@pytest.mark.parametrize("number", SIGNALS)
def test_where_it_is_ignored_it_stays_so(number: signal.Signals) -> None:
    before = signal.signal(number, signal.SIG_IGN)
    try:
        with process.handled_interrupts():
            interrupt(number)
            assert signal.getsignal(number) is signal.SIG_IGN
    finally:
        signal.signal(number, before)


@pytest.mark.parametrize("number", SIGNALS)
def test_children_hear_nothing_and_their_parent_does(number: signal.Signals) -> None:
    code = "import os, signal, time; time.sleep(0.3); print('whole')"
    with children_ignoring_signals():
        child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
    child.send_signal(number)
    assert child.communicate()[0] == "whole\n"
    with pytest.raises(KeyboardInterrupt), process.handled_interrupts():
        interrupt(number)


@pytest.mark.parametrize("number", SIGNALS)
def test_while_the_command_loads_it_is_one_line(number: signal.Signals) -> None:
    code = (
        "import os, signal, sys\n"
        "class Interrupt:\n"
        "    def find_spec(self, name, *_):\n"
        "        if name == 'click': os.kill(os.getpid(), NUMBER)\n"
        "sys.meta_path.insert(0, Interrupt())\n"
        "from sim2reason.__main__ import main; main()"
    )
    code = code.replace("NUMBER", str(int(number)))
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert (result.returncode, result.stdout, result.stderr) == (130, "", "sim2reason: interrupted\n")
