"""Define the hooks of the documentation site: links to files of the repository, formulas and names of headings.

Pages link to files outside docs/ by relative paths, which also work in a clone. Each linked file becomes a page of the
site under ``repository/``; a linked folder becomes a page that lists its files.
"""  # noqa: INP001

import posixpath
import re
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from latex2mathml.converter import convert
from mkdocs.structure.files import File, Files
from pymdownx.slugs import slugify

if TYPE_CHECKING:
    from mkdocs.config.defaults import MkDocsConfig
    from mkdocs.structure.pages import Page

ROOT = Path(__file__).parents[1]
PREFIX = "repository/"
ALWAYS = "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md"  # pages of the navigation
LARGEST = 100_000  # bytes of a file that is shown as a page
IMAGES = ".png", ".svg"
LINK = re.compile(r"(\]\()(?![a-z]+:|#|/)([^)#\s]+)((?:#[^)\s]*)?\))")
LISTS = re.compile(r"^((?![ \t]*(?:[-*]|\d+\.) |[ \t]|#|\|)[^\n]+)\n((?:[-*]|1\.) )", re.MULTILINE)  # after a paragraph
FENCE = re.compile(r"^(```.*?^```$)", re.DOTALL | re.MULTILINE)
LANGUAGES = {".py": "python", ".yaml": "yaml", ".json": "json", ".sh": "bash", ".cff": "yaml"}
MATH = re.compile(r'<(span|div) class="arithmatex">\\[(\[](.*?)\\[)\]]</\1>', re.DOTALL)
ENTITIES = (("&lt;", "<"), ("&gt;", ">"), ("&amp;", "&"))


def on_config(config: "MkDocsConfig") -> "MkDocsConfig":
    """Name headings as repositories do: lower case, a dash for each space."""
    config.mdx_configs["toc"]["slugify"] = slugify(case="lower")
    return config


def on_files(files: Files, config: "MkDocsConfig") -> Files:
    """Add a page or file for each file and folder of the repository that a page links to."""
    waiting = [ROOT / name for name in ALWAYS]
    waiting += [path for file in files.documentation_pages() for path in _targets(Path(file.abs_src_path or ""))]
    done: set[Path] = set()
    while waiting:
        path = waiting.pop()
        if path in done or path.is_relative_to(ROOT / "docs") or not path.exists():
            continue
        done.add(path)
        if path.suffix in IMAGES:
            files.append(File.generated(config, _uri(path), abs_src_path=str(path)))
            continue
        files.append(File.generated(config, _uri(path), content=_text(path)))
        waiting += _listed(path) if path.is_dir() else _targets(path)
    return files


def on_page_markdown(markdown: str, page: "Page", config: "MkDocsConfig", files: Files) -> str:
    """Point links at the pages of `on_files`, and adapt fences, details and lists to this dialect of Markdown."""
    del config, files
    uri = page.file.src_uri
    if (source := _source(uri)).is_file() and source.suffix != ".md":
        return markdown  # a page that `_text` wrote
    markdown = re.sub(r"^```(\w+) [\w.-]+$", r"```\1", markdown, flags=re.MULTILINE)
    markdown = markdown.replace("<details>", '<details markdown="1">')
    parts = FENCE.split(markdown)
    parts[::2] = (LISTS.sub(r"\1\n\n\2", LINK.sub(lambda link: _directed(link, uri), part)) for part in parts[::2])
    return "".join(parts)


def on_page_content(html: str, page: "Page", config: "MkDocsConfig", files: Files) -> str:
    """Write formulas as MathML, which browsers draw without scripts."""
    del page, config, files
    return MATH.sub(_formula, html)


def _formula(found: re.Match[str]) -> str:
    latex = found[2]
    for entity, character in ENTITIES:
        latex = latex.replace(entity, character)
    return convert(latex, display="block" if found[1] == "div" else "inline")


def _source(uri: str) -> Path:
    """Return the file of the repository that a page of the site shows."""
    if not uri.startswith(PREFIX):
        return ROOT / "docs" / uri
    path = ROOT / uri.removeprefix(PREFIX)
    return path if path.exists() else path.with_suffix("")


def _uri(path: Path) -> str:
    """Return the name of a file's page within the sources of the site."""
    if path.is_relative_to(ROOT / "docs"):
        return path.relative_to(ROOT / "docs").as_posix()
    name = PREFIX + path.relative_to(ROOT).as_posix()
    if path.is_dir():
        return f"{name}/files.md"
    return name if path.suffix in (".md", *IMAGES) else f"{name}.md"


def _targets(path: Path) -> Iterator[Path]:
    """Yield the files and folders to which a Markdown file links."""
    if path.suffix == ".md":
        for part in FENCE.split(path.read_text(encoding="utf-8"))[::2]:
            yield from ((path.parent / found[2]).resolve() for found in LINK.finditer(part))


def _directed(link: re.Match[str], uri: str) -> str:
    folder = uri.startswith(PREFIX) and uri.endswith("/files.md")
    start = (ROOT / uri.removeprefix(PREFIX)).parent if folder else _source(uri).parent
    target = (start / link[2]).resolve()
    if not target.exists() or not target.is_relative_to(ROOT):
        return link[0]
    return link[1] + posixpath.relpath(_uri(target), posixpath.dirname(uri)) + link[3]


def _listed(folder: Path) -> list[Path]:
    """Return the files of a folder, at any depth, that the site shows."""
    return sorted(
        path
        for path in folder.rglob("*")
        if path.is_file() and not {"__pycache__"} & set(path.parts) and path.stat().st_size <= LARGEST
    )


def _text(path: Path) -> str:
    """Return the Markdown of a file's page, or of a folder's."""
    name = path.relative_to(ROOT).as_posix()
    if path.suffix == ".md":
        return path.read_text(encoding="utf-8")
    if path.is_dir():
        inside = [held.relative_to(path).as_posix() for held in _listed(path)]
        return "\n".join([f"# {name}", "", *(f"- [{each}]({each})" for each in inside)])
    language = LANGUAGES.get(path.suffix, "text")
    text = path.read_text(encoding="utf-8", errors="replace")
    return f"---\nsearch: {{exclude: true}}\n---\n\n# {path.name}\n\n`{name}`\n\n````{language}\n{text}\n````\n"
