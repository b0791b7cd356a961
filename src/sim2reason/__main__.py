"""``python -m sim2reason`` is the command line."""

from sim2reason.cli import main

main(prog_name="sim2reason")
