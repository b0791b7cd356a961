"""Tests that the pages at the root and in docs agree with the code, and that their links resolve."""

import importlib
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml
from click.testing import CliRunner

import sim2reason
from sim2reason.cli import main
from sim2reason.errors import SceneError
from sim2reason.generation.recipes import RECIPES
from sim2reason.scenes.dsl.builder import Frame
from sim2reason.scenes.dsl.entity import ENTITIES, Entity, outer_ports
from sim2reason.scenes.dsl.ports import Base, End, Mount, Pass, Port
from sim2reason.scenes.files.sections import directions

ROOT = Path(__file__).parents[1]
PAGES = [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md"), ROOT / "experiments/README.md", ROOT / "llms.txt"]
SCENES = sorted((ROOT / "examples/scenes").glob("*.yaml"))
MOST_WORDS = 900  # of the README, without blocks of code
MOST_WORDS_OF_A_CHANGE = 25
LEAST_TERMS = 35  # of the glossary
LINK = re.compile(r"\]\((?![a-z]+:)([^)#\s]*)(?:#([^)\s]*))?\)")


def read(name: str) -> str:
    return (ROOT / name).read_text(encoding="utf-8")


def prose(text: str) -> str:
    """Return the text without fenced and indented blocks of code."""
    without_fences = re.sub(r"^```.*?^```$", "", text, flags=re.DOTALL | re.MULTILINE)
    return "\n".join(line for line in without_fences.splitlines() if not line.startswith("    "))


def anchors(path: Path) -> set[str]:
    """Return the link targets of the headings of a page."""
    headings = re.findall(r"^#+ (.*)$", path.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def rows(name: str) -> list[list[str]]:
    """Return the cells of all table rows whose first cell is code."""
    return [line.strip("| ").split(" | ") for line in read(name).splitlines() if line.startswith("| `")]


@pytest.mark.parametrize("path", PAGES, ids=lambda path: str(path.relative_to(ROOT)))
def test_links_resolve(path: Path) -> None:
    for target, anchor in LINK.findall(prose(path.read_text(encoding="utf-8"))):
        page = (path.parent / target).resolve() if target else path
        assert page.exists(), target
        assert not anchor or page.suffix != ".md" or anchor in anchors(page), f"{target}#{anchor}"


def test_the_readme_is_short_and_lists_every_recipe() -> None:
    assert len(prose(read("README.md")).split()) <= MOST_WORDS
    assert [cells[0].strip("`") for cells in rows("README.md")] == sorted(RECIPES)


def test_the_citation_names_the_version_and_the_paper() -> None:
    citation: dict[str, Any] = yaml.safe_load(read("CITATION.cff"))
    assert {"cff-version", "message", "title", "authors"} <= set(citation)
    assert citation["version"] == tomllib.loads(read("pyproject.toml"))["project"]["version"]
    (paper,) = citation["references"]
    assert paper["identifiers"][0]["value"] == "arXiv:2604.11805"


def test_the_changelog_has_dated_versions_and_short_entries() -> None:
    text = read("CHANGELOG.md")
    versions = re.findall(r"^## (.*)$", text, re.MULTILINE)
    assert versions[0] == "[Unreleased]"
    assert all(re.fullmatch(r"\[\d+\.\d+\.\d+\] - \d{4}-\d\d-\d\d", version) for version in versions[1:])
    entries = re.findall(r"^- (.*(?:\n  .*)*)", text, re.MULTILINE)
    assert [entry for entry in entries if len(entry.split()) > MOST_WORDS_OF_A_CHANGE] == []


def test_issue_forms_ask_for_what_has_a_name_of_its_own() -> None:
    for name in ("bug", "feature"):
        form: dict[str, Any] = yaml.safe_load(read(f".github/ISSUE_TEMPLATE/{name}.yml"))
        assert {"name", "description", "body"} <= set(form)
        names = [field["id"] for field in form["body"] if field["type"] != "markdown"]
        assert names
        assert len(names) == len(set(names))


def test_continuous_integration_runs_all_pages() -> None:
    script = read(".ci/run")
    assert all(pages in script for pages in ("README.md", "docs/*.md", "docs/integrations/*.md", "docs/howto/*.md"))


def navigated(entry: object) -> Iterator[str]:
    """Yield the pages of a part of the navigation of the documentation site."""
    if isinstance(entry, str):
        yield entry
    elif isinstance(entry, dict):
        yield from navigated(list(entry.values()))
    elif isinstance(entry, list):
        for child in entry:
            yield from navigated(child)


def test_the_site_has_every_page_of_the_docs_once() -> None:
    settings: dict[str, Any] = yaml.safe_load(read("mkdocs.yml"))
    pages = [page for page in navigated(settings["nav"]) if not page.startswith("repository/")]
    docs = {path.relative_to(ROOT / "docs").as_posix() for path in (ROOT / "docs").rglob("*.md")}
    assert sorted(pages) == sorted(docs - set(settings["exclude_docs"].split()))
    assert "make site" in read(".ci/run")


def test_the_glossary_has_distinct_terms_in_alphabetical_order_with_links() -> None:
    sections = re.split(r"^## ", read("docs/concepts.md"), flags=re.MULTILINE)[1:]
    terms = [section.splitlines()[0].lower() for section in sections]
    assert len(terms) >= LEAST_TERMS
    assert terms == sorted(set(terms))
    assert [term for term, section in zip(terms, sections, strict=True) if not LINK.search(section)] == []


def test_the_reference_has_every_public_name() -> None:
    assert sorted(re.findall(r"^::: sim2reason\.(\w+)$", read("docs/reference/api.md"), re.MULTILINE)) == sorted(
        sim2reason.__all__
    )


@pytest.mark.parametrize("name", ["rewards", "grading", "authoring", "testing"])
def test_the_reference_has_every_name_of_a_public_module(name: str) -> None:
    page = read(f"docs/reference/{name}.md")
    members = re.findall(r"^ +- (\w+)$", page, re.MULTILINE)
    own = re.findall(rf"^::: sim2reason\.{name}\.(\w+)\.\1$", page, re.MULTILINE)  # named as their modules
    assert sorted(members + own) == sorted(importlib.import_module(f"sim2reason.{name}").__all__)


def test_the_reference_of_the_commands_is_up_to_date() -> None:
    subprocess.run([sys.executable, ROOT / "docs/commands.py", "--check"], check=True)


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_the_documented_completion_scripts_exist(shell: str) -> None:
    assert f"_SIM2REASON_COMPLETE={shell}_source sim2reason" in read("docs/howto/shell-completion.md")
    run = CliRunner(env={"_SIM2REASON_COMPLETE": f"{shell}_source"}).invoke(main, [], prog_name="sim2reason")
    assert f"_SIM2REASON_COMPLETE={shell}_complete" in run.stdout


def kind(port: Port) -> str:
    """Return the letter for a kind of port on the page for language models."""
    letters: tuple[tuple[type[Port], str], ...] = ((Pass, "P"), (Mount, "M"), (Base, "B"), (End, "E"))
    return next((letter for cls, letter in letters if isinstance(port, cls)), "S") + "!" * port.required


def shown(cls: type[Entity]) -> str:
    """Return the directions of an entity as the page for language models writes them."""
    ports = outer_ports(cls)
    names = [(name, ports[port]) for (name, point), (port, _) in directions(cls).items() if not point]
    return ", ".join(f"`{name}` {kind(port)}" for name, port in names) or "–"


def test_the_page_for_language_models_has_every_entity_with_its_ports_and_valid_parameters() -> None:
    table = {cells[0].strip("`"): cells[2:] for cells in rows("docs/for-language-models.md") if len(cells) == 4}
    assert list(table) == list(ENTITIES)
    for name, (parameters, ports) in table.items():
        assert ports == shown(ENTITIES[name]), name
        text = f"scene: {{entities: [{{name: it, type: {name}, parameters: {parameters.strip('`')}}}]}}"
        if "!" in ports:
            with pytest.raises(SceneError, match="is open; connect it"):
                sim2reason.load(text)
        else:
            sim2reason.load(text)


def test_the_page_for_language_models_names_verbs_of_the_builder() -> None:
    page = read("docs/for-language-models.md")
    verbs = re.findall(r"^\| `(\w+)\(", page, re.MULTILINE)
    assert len(verbs) > 10
    assert all(hasattr(Frame, verb) for verb in verbs)


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_example_scenes_have_a_text_and_the_same_motion_in_both_engines(path: Path) -> None:
    scene = sim2reason.load(path)
    assert sim2reason.describe(scene).text
    _, certificate = sim2reason.certify(scene, duration=0.5)
    assert certificate.stable_until > 0.4, certificate.reason
