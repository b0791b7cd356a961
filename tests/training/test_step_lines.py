from pathlib import Path

from sim2reason.training.run_files import StepLines


def test_lines_go_back_to_a_step_and_lose_a_cut_one(tmp_path: Path) -> None:
    log = StepLines(tmp_path / "run/log.jsonl")
    assert log.read() == []
    log.rewind(0)
    lines = [f'{{"step": {step}, "said": "\u2028é"}}' for step in (1, 2, 3)]
    for line in lines:
        log.add(line)
    with log.path.open("a") as file:
        file.write('{"step": 4, "rou')
    assert log.read() == lines
    log.rewind(2)
    log.add(lines[2])
    assert log.read() == lines
    log.rewind(0)
    assert log.path.read_bytes() == b""
