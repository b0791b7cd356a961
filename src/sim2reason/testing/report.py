"""Report of the conformance kit."""

from collections.abc import Iterator
from dataclasses import dataclass

from sim2reason.errors import ConformanceError

MAX_FULL_FINDINGS = 3  # findings of one check that are reported in full


@dataclass(frozen=True, slots=True)
class Finding:
    """One violation: expected and actual behaviour, the scene, and a remedy."""

    check: str
    expected: str
    found: str
    remedy: str
    seed: int | None = None  # of the scene; None where it is a matter of the class
    scene: str = ""  # its file

    @property
    def text(self) -> str:
        """Return the finding in words, followed by the scene file."""
        where = "" if self.seed is None else f" (seed {self.seed})"
        lines = f"{self.check}{where}: {self.found}\n  expected: {self.expected}\n  remedy: {self.remedy}"
        return lines + ("\n  scene:\n" + _indented(self.scene) if self.scene else "")


@dataclass(frozen=True)
class Report:
    """The findings about one entity class, check by check; no findings mean conformance."""

    entity: str
    checks: tuple[str, ...]  # those that were made
    seeds: tuple[int, ...]
    findings: tuple[Finding, ...] = ()

    def __iter__(self) -> Iterator[Finding]:
        """Return an iterator over the findings."""
        return iter(self.findings)

    def __len__(self) -> int:
        """Return the number of findings."""
        return len(self.findings)

    def __repr__(self) -> str:
        """Return the entity and the numbers of checks, scenes and findings."""
        made = f"{len(self.checks)} checks on {len(self.seeds)} scenes"
        return f"<Report on {self.entity}: {len(self.findings)} findings by {made}>"

    def __str__(self) -> str:
        """Return the findings in words, check by check."""
        return self.text

    @property
    def text(self) -> str:
        """Return the findings in words, check by check."""
        made = f"{len(self.checks)} checks on {len(self.seeds)} scenes"
        if not self.findings:
            return f"{self.entity}: {made}, nothing found"
        details = "\n\n".join(
            self._check_text(check) for check in dict.fromkeys(finding.check for finding in self.findings)
        )
        return f"{self.entity}: {len(self.findings)} finding{'s' * (len(self.findings) != 1)}, by {made}\n\n{details}"

    def _check_text(self, check: str) -> str:
        """Return the first findings of a check in full, and the number of the others."""
        findings = [finding for finding in self.findings if finding.check == check]
        more = [f"{check}: and {len(findings) - MAX_FULL_FINDINGS} more"] if len(findings) > MAX_FULL_FINDINGS else []
        return "\n\n".join([*(finding.text for finding in findings[:MAX_FULL_FINDINGS]), *more])

    def raise_for_findings(self) -> None:
        """Raise ConformanceError with all findings, if there are any."""
        if self.findings:
            raise ConformanceError(self.text)


def _indented(text: str) -> str:
    return "\n".join(f"    {line}" for line in text.rstrip().splitlines())
