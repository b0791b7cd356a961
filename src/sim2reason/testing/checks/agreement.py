"""Check that both engines agree."""

from collections.abc import Iterator

from sim2reason.errors import SimulationError, UnsupportedError
from sim2reason.testing.checks import Check, check
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import Specimen, Specimens

REFUSED = 0.1  # fraction of scenes that may be refused with a reason; at least one scene


@check
class AgreementCheck(Check):
    """Check that both engines compute the same motion for nine of ten scenes, and refuse others with a reason."""

    name = "agreement"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Yield every refused scene if there are too many."""
        reasons = [(found, reason(found)) for found in specimens.members]
        refused = [(found, why) for found, why in reasons if why]
        if len(refused) > max(1.0, REFUSED * len(reasons)):
            for found, why in refused:
                yield found.finding(
                    self.name,
                    f"both engines agree on at least {1.0 - REFUSED:.0%} of the scenes",
                    f"they do not on {len(refused)} of {len(reasons)}; here: {why}",
                    "see what is singular or too stiff there, and bound the ranges that lead to it",
                )


def reason(found: Specimen) -> str:
    """Return why a motion is not certified to its end; empty if it is."""
    try:
        trace, certificate = found.certified
    except (SimulationError, UnsupportedError) as error:
        return str(error)
    return certificate.reason if trace.cut == "certificate" or certificate.stable_until < found.end else ""
