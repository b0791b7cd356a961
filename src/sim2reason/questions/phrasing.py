"""The sentences that ask for a noun phrase at a moment; the verbs are drawn by quota, not by chance alone."""

from sim2reason.questions.targets import Target

FAST = "the speed of "
FAR = "the distance of "
FROM_START = " from its starting point"


def asking(target: Target, noun: str, when: str) -> tuple[str, ...]:
    """All ways to ask for a quantity, a magnitude or a component, at a moment."""
    sense = target.sense
    if sense is None or (sense.axis and len(sense.axis) == 1):  # the axes of the text have their own signs
        return (*_special(noun, when), *_plain(noun, when))
    positive = sense.positive
    return (
        f"taking {positive} as positive, find {noun} {when}.",
        f"taking {positive} as positive, what is {noun} {when}?",
        f"what is {noun} {when}, {positive} being positive?",
        f"with {positive} as positive, determine {noun} {when}.",
        f"find {noun} {when}, counting {positive} as positive.",
        *((f"{when}, what is {noun}, if {positive} counts as positive?",) if when[0].isalpha() else ()),
    )


def _plain(noun: str, when: str) -> tuple[str, ...]:
    return (
        f"what is {noun} {when}?",
        f"find {noun} {when}.",
        f"determine {noun} {when}.",
        f"calculate {noun} {when}.",
        *((f"{when}, what is {noun}?",) if when[0].isalpha() else ()),  # no sentence begins with a number
    )


def _special(noun: str, when: str) -> tuple[str, ...]:
    """Where everyday English has a question word of its own."""
    if noun.startswith(FAST):
        body, _, ground = noun.removeprefix(FAST).partition(" relative to")
        return (f"how fast is {body} moving{' relative to' + ground if ground else ''} {when}?",)
    if noun.startswith(FAR) and FROM_START in noun:
        body, _, ground = noun.removeprefix(FAR).partition(FROM_START)
        return (f"how far is {body}{FROM_START}{ground} {when}?",)
    return ()
