"""Questions that the library cannot pose, each with the reason and what to ask instead."""

import re
from collections.abc import Mapping

BEYOND: Mapping[str, str] = {
    r"semi-?minor": "of the shape of an orbit only the semi-major axis and the eccentricity are quantities here",
    r"radius of (?:the |its )?(?:circle|circular|orbit|path|curvature|motion|trajectory)|amplitude": "the size of a "
    "path is a quantity here only in a magnetic field: ask for the greatest displacement, or for a distance",
    r"magnetic force|electric force|gravitational force|weight of|centripetal force|drag force": "of the forces "
    "that lie in no string, rod, spring or contact only the net one, and those of fields and of a medium, are here",
    r"on (?:the |its )?(?:fixed |light )*pulley": "the force of strings on a pulley is a quantity here only where the "
    "text tells the directions of their parts, which it does not of parts along separate planes",
    r"average|mean (?:speed|velocity|force|power)": "averages are no quantities here: ask for what the motion adds up "
    "to, and for the time",
    r"\bpower\b|at what rate does .*(?:work|energy)": "of powers only those of a hand "
    "and of gravity are asked in sentences: ask for others in parts, such as --find 'power of gravity'",
    r"(?:what|which|find the|the) direction|angle (?:above|below|to|with) the horizontal": "of directions only the "
    "angle of a projectile's velocity with the horizontal is a quantity here: ask for the components",
    r"\d\s?(?:s|seconds?|yr|years?) (?:after|before) (?!t\b|the start|release|launch)|\d\s?s later|next \d|last "
    r"(?:\d|second)": "a time is counted from the start: ask when that happens first, then at a time",
    r"altogether|combined|total (?:momentum|mass) of the \w+s\b|centre of mass of the|of the system": (
        "of sums over several bodies only those of energies of one kind are quantities here: ask for each"
    ),
    r"work (?:is |has |was |does )?(?:the )?(?:done )?(?:by )?(?:the )?(?:friction|gravity|weight|normal)": "of works "
    "those of a hand, a tension and a field are quantities here, and what friction dissipates",
    r"\bratio\b|what (?:fraction|percentage|share)|how many times (?:as|greater|larger|faster)": "a ratio of two "
    "answers is asked for only where a number is changed (--change): ask for both",
    r"\bif (?!the system is|it is released)|\bwere\b|\bwould .* (?:be )?(?:on the moon|on mars)": "what would be "
    "otherwise is asked by a change of a number (--change)",
    r"\b(?:second|third|fourth|next) time\b|\bagain\b": (
        "what happens again has no moment here, but bounces and collisions"
    ),
}
"""By what a sentence has that is not understood: the reason, with what to ask instead."""


def reason(sentence: str) -> str:
    """Return a clause that explains why the library cannot answer a sentence; empty if the reason is unknown."""
    plain = " ".join(sentence.lower().split())
    return next((told for like, told in BEYOND.items() if re.search(like, plain)), "")
