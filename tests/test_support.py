from pathlib import Path

import readme

TEXT = """
# A project

```console
$ pip install project
$ echo one > here
out of the command
$ test -f here
```

```python
$ not a command
```
"""


def test_commands_are_those_of_console_blocks_without_set_up() -> None:
    assert list(readme.commands(TEXT)) == ["echo one > here", "test -f here"]


def test_commands_run_in_one_folder_until_one_fails(tmp_path: Path) -> None:
    (tmp_path / "good.md").write_text(TEXT)
    (tmp_path / "bad.md").write_text(TEXT.replace("test -f here", "exit 3"))
    assert readme.main(str(tmp_path / "good.md")) == 0
    assert readme.main(str(tmp_path / "bad.md")) == 3
