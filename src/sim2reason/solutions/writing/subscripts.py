"""Names in LaTeX with something below them."""


def subscript(name: str) -> str:
    """What stands below a name, without its braces; empty for nothing."""
    inner = name.partition("_")[2]
    return inner[1:-1] if inner.startswith("{") else inner


def marked(base: str, mark: str) -> str:
    """A name with a subscript, added to the one that it may have."""
    if not mark:
        return base
    inner = subscript(base)
    joined = f"{inner},{mark}" if inner else mark
    stem = base.partition("_")[0]
    return f"{stem}_{joined}" if len(joined) == 1 else f"{stem}_{{{joined}}}"


def split(name: str) -> tuple[str, str]:
    """Return the base of a name and its subscript without braces."""
    base, _, mark = name.partition("_")
    return base, mark[1:-1] if mark.startswith("{") and mark.endswith("}") else mark
