"""Rows for main clauses about forces, in base forms."""

from sim2reason.questions.ordinary.vocabulary import GROUNDS
from sim2reason.questions.ordinary.wanted_row import WantedRow

FORCE = (
    "how (?:hard|strongly)|(?:what|how much|how large a|how large|how great a|how big a) (?:total |resultant |net"
    " )*force"
    "|(?:total |resultant |net |whole )*(?:force|pull|load|reaction)"
)
_ACT = "load|exert|act|pull|push|press|apply|carry|bear|hold|support|take|withstand|sustain|hang"
_HOLDER = "axle|bear(?:ing)?|bracket|mount|mounting|support|suspension|hinge|pivot|(?:fixed )?axis"
_HOOK = (
    "(?:fixed )?(?:hook|ceiling|beam)|(?:its )?(?:point of suspension|suspension point|fixed point|suspension"
    "|upper end|point of support)"
)
GREATEST = "greatest|maximum|maximal|largest|highest|biggest|peak|most|at most"
_ON = "?by|on|of|from|upon|against"

FORCE_ROWS = (
    WantedRow((FORCE, GREATEST, f"?{_ACT}", _ON, _ON, "?wall|stop"), "what is greatest force of {s}", 2),
    WantedRow((FORCE, GREATEST, _HOLDER, f"?{_ACT}", "?on|by|from|of|at", "?on|by|from|of"),
        "what greatest force bears axle {s}"),
    WantedRow((FORCE, "(?:vertical )?guide", f"?{_ACT}", "?sideways|horizontal|horizontally", _ON),
        "what force of guide on {s}"),
    WantedRow((FORCE, "horizontal|sideways|horizontally", "(?:vertical )?guide", f"?{_ACT}", _ON),
        "what force of guide on {s}"),
    WantedRow((FORCE, "?net|resultant|total|whole", f"?{_ACT}", _ON, _ON, "?in total|in all|altogether|together"),
        "what force of string on pulley {s} {t}", 2),
    WantedRow((FORCE, "string|rope|cord|cable|thread", f"?{_ACT}", _ON, "?by|from|of"),
        "what force of the one string on pulley {s}"),
    WantedRow((FORCE, _HOLDER, f"?{_ACT}", "?on|by|from|of", "?on|by|from|of", "?have|in total|in all|altogether"),
        "what force bears axle {s} {t}", 2),
    WantedRow((FORCE, _HOLDER, f"?{_ACT}", "?on|by|from|of", "?have"), "what force bears axle {s}"),
    WantedRow((FORCE, "?string|rope|cord|cable|thread", f"?{_ACT}", _HOOK, _ON, _ON), "what force on hook {s}"),
    WantedRow(("how much", "pull|tug", "?on|at"), "what force does {s} exert on {t}", 2),
    WantedRow((FORCE, "support|carry|hold|bear", f"(?P<face>{GROUNDS})"), "what normal force of ground on {s}"),
    WantedRow((FORCE, "<up>", "exert|push|press|act|apply", f"(?P<face>{GROUNDS})", "?on", "?total|whole"),
        "what upward force of ground on {s}"),
    WantedRow((FORCE, "?total|whole", "exert|act|push|press|apply", "?by|from|of", f"(?P<face>{GROUNDS})",
         "?by|from|of|on"),
        "what whole force of ground on {s}"),
    WantedRow((FORCE, "act|experience|feel|exert", "?on"), "what force acts on {s}"),
    WantedRow((FORCE, "on|upon"), "what force acts on {s}"),
    WantedRow((FORCE, "press|push|bear", "?against|on|upon|onto|down on", f"?(?:its |their )?(?:{GROUNDS})"),
        "how hard does {s} press on ground"),
    WantedRow((FORCE, "exert|act|pull|push", "?by|on|of|from", ("(?:fixed )?(?:wall|stop|support"
    "|peg)"), "?by|on|of|from"),
        "what is force of {s}"),
    WantedRow((FORCE, "(?:fixed )?(?:wall|stop|peg)", "?on|from"), "what is force of {s}"),
    WantedRow((FORCE, "?pull|tug|exert|act"), "what force does {s} exert on {t}", 2),
    WantedRow((FORCE, "pull|tug|stretch"), "what is force of {s}"),
    WantedRow(("friction|{friction}", "?force", "between"), "what friction force acts between {s} and {t}", 2),
    WantedRow(("thrust(?: force)?", "?engine|motor|rocket|its engine", "?produce|provide|deliver|develop"),
        "what is thrust of {s}"),
)  # fmt: skip
