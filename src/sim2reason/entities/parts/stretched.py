"""What entities with a spring share: how long it is at the start."""

from typing import Annotated

from sim2reason.authoring import Length, Range, placing

StartLength = Annotated[Length, Range(0.2, 1.0)]
AT_FIRST = placing(
    "initially {spring} has a length of {start}.",
    "the length of {spring} at the start is {start}.",
    "the initial length of {spring} is {start}.",
)
