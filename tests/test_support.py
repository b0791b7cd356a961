import fcntl
from pathlib import Path
from threading import Event, Thread

import pytest

import fake_makers
import readme
import shared_items
from sim2reason.generation.request import Made, Request

TEXT = """
# A project

```console
$ pip install project
$ echo one
one
$ echo one > here
$ test -f here
```

```text
$ not a command
```
"""


def test_commands_are_those_of_console_blocks_without_set_up() -> None:
    assert list(readme.commands(TEXT)) == ["echo one", "echo one > here", "test -f here"]


def test_commands_run_in_one_folder_until_one_fails(tmp_path: Path) -> None:
    (tmp_path / "good.md").write_text(TEXT)
    (tmp_path / "bad.md").write_text(TEXT.replace("test -f here", "exit 3"))
    assert readme.main(str(tmp_path / "good.md")) == 0
    assert readme.main(str(tmp_path / "bad.md")) == 3


@pytest.mark.parametrize(
    ("output", "printed", "fit"),
    [
        ((), "anything\n", True),
        (("one", "two"), "one\ntwo\n", True),
        (("one", "…", "three"), "one\ntwo\nand a half\nthree\n", True),
        (("t = … s",), "t = 1.25 s\n", True),
        (("one",), "two\n", False),
        (("one",), "one\ntwo\n", False),
    ],
)
def test_shown_output_is_compared(output: tuple[str, ...], printed: str, fit: bool) -> None:
    assert readme.fits(output, printed) is fit


def test_a_page_that_shows_something_else_fails_and_can_be_written_anew(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text("```console\n$ echo new\nold\n$ echo here > there\n$ cat there\nnot here\n```\n", encoding="utf-8")
    assert readme.main(str(page)) == 1
    assert readme.main(str(page), write=True) == 0
    assert page.read_text(encoding="utf-8").splitlines()[1:3] == ["$ echo new", "new"]
    assert readme.main(str(page)) == 0


@pytest.mark.parametrize(
    ("block", "code"),
    [
        ("x = 1\nassert x == 1", 0),
        ("assert 1 == 2", 1),
        (">>> 1 + 1\n2", 0),
        (">>> 1 + 1\n3", 1),
        ("import no_such_library\nassert 1 == 2", 0),
    ],
)
def test_python_blocks_run_where_their_libraries_are(tmp_path: Path, block: str, code: int) -> None:
    page = tmp_path / "page.md"
    page.write_text(f"```python\n{block}\n```\n", encoding="utf-8")
    assert readme.main(str(page)) == code


def test_a_doctest_is_written_anew_with_its_output(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text("```python\n>>> x = 1\n>>> x + 1\n3\n>>> print('a ' * 80)\nb\n>>> x\n1\n```\n", encoding="utf-8")
    assert readme.main(str(page)) == 1
    assert readme.main(str(page), write=True) == 0
    lines = page.read_text(encoding="utf-8").splitlines()
    assert lines[3] == "2"
    assert [len(line) for line in lines[5:7]] == [99, 59]
    assert lines[7:] == [">>> x", "1", "```"]
    assert readme.main(str(page)) == 0


def test_a_doctest_that_raises_or_lacks_a_library_is_not_written_anew(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    for block, code in ((">>> 1 / 0\n1", 1), (">>> import no_such_library\n1", 0)):
        text = f"```python\n{block}\n```\n"
        page.write_text(text, encoding="utf-8")
        assert readme.main(str(page), write=True) == code
        assert page.read_text(encoding="utf-8") == text


def test_commands_of_a_library_run_where_it_is(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    for library, code in (("json", 3), ("no_such_library", 0)):
        page.write_text(f"```console {library}\n$ exit 3\n```\n", encoding="utf-8")
        assert readme.main(str(page)) == code


def test_pages_run_one_after_the_other_in_one_folder_until_one_fails(tmp_path: Path) -> None:
    pages = [tmp_path / f"{name}.md" for name in "abc"]
    for page, command in zip(pages, ("echo one > here", "test -f here", "exit 3"), strict=True):
        page.write_text(f"```console\n$ {command}\n```\n", encoding="utf-8")
    assert readme.main(*map(str, pages[:2])) == 0
    assert readme.main(*map(str, pages)) == 3
    assert readme.main(str(pages[1])) == 1


def test_shared_items_are_made_once_and_a_cell_that_another_process_makes_comes_last(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made, past = list[str](), Event()

    def steady(request: Request) -> Made:
        made.append(request.id)
        if request.difficulty == "hard":
            past.set()
        return fake_makers.steady(request)

    monkeypatch.setattr(shared_items, "make", steady)
    easy, hard = ("incline", "easy"), ("incline", "hard")
    here, there = (shared_items.SharedItems(tmp_path / "items") for _ in range(2))
    assert len(here.of(easy, 5)) == 4, "the fourth finds no draw"
    with (tmp_path / "items/incline-easy").open() as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        other = Thread(target=there.of_all, args=({easy: 6, hard: 2},))
        other.start()
        assert past.wait(60.0), "it waits for the cell, although there is another"
    other.join()
    assert len(made) == len(set(made)) == 8
    assert [item.id for item in here.of_all({easy: 6})] == [f"incline-easy-numeric-77-{n}" for n in (0, 1, 2, 4, 5)]
    assert len(made) == 8
