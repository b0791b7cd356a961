"""Questions about a motion during which something is cut or let go, so that a second motion begins."""

import re

_WHAT = r"(?:@\d+@|string|rope|cord|thread|rod|spring|hand|pull|force|engine|field)"
_ENDS = (
    r"(?:(?:is|were|was) (?:cut|released|removed|taken away|switched off|detached|let go)|breaks?|broke|snaps?|snapped"
    r"|lets? go(?: of @\d+@| of string)?|stops? (?:pulling|pushing|acting|burning)|stopped (?:pulling|acting))"
)
_LATER = r"(?:#\d+# (?:after|later)|after #\d+#|when @\d+@ has \w+ #\d+#|at t = #\d+#)"
_BOTH = re.compile(
    rf"^(?:(?:suppose|if|imagine|assume|when)(?: that)? )?{_WHAT} {_ENDS} {_LATER}(?: [a-z ]+)?(?:\.| ,) .+"
)


def goes_on_otherwise(text: str) -> bool:
    """Return whether a sentence begins like *suppose the string is cut after 2 s*."""
    return _BOTH.match(text) is not None
