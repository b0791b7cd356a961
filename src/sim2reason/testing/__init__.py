"""The conformance kit: checks of entity classes on random scenes, with findings in words.

    from sim2reason.testing import check_entity

    def test_my_entity_conforms():
        check_entity(MyEntity)

`check_entity` raises, with everything that it found; `conformance` gives the same as a report.
"""

from sim2reason.errors import ConformanceError
from sim2reason.testing.checks import CHECKS, Check, check
from sim2reason.testing.conformance import check_entity, conformance
from sim2reason.testing.report import Finding, Report
from sim2reason.testing.specimens import Specimen, Specimens, specimen

__all__ = [
    "CHECKS",
    "Check",
    "ConformanceError",
    "Finding",
    "Report",
    "Specimen",
    "Specimens",
    "check",
    "check_entity",
    "conformance",
    "specimen",
]
