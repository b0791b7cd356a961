"""Base forms of verbs, and the words of a question that say nothing of their own."""

import re
from collections.abc import Iterator
from functools import cache

REGULAR = re.split(
    " ",
    "move slide travel cover recoil advance roll drop descend climb ascend turn rotate stop halt rest reach "
    "land touch bounce rebound collide impact crash bump pass arrive return enter exit slip skid release launch "
    "kick need require last elapse attain achieve gain acquire dissipate generate produce convert transfer "
    "exert act experience press push pull support stretch compress extend shorten lengthen oscillate vibrate "
    "complete perform execute revolve orbit burn exhaust consume use separate approach recede accelerate "
    "decelerate slow remain stay store contain deliver impart receive exchange happen occur deflect ignite "
    "start finish end deform reverse change detach cross touch relax contract expand start brake pull drag lift "
    "lower raise join tie attach connect carry hang cease possess reduce increase decrease transform stay "
    "pick remove drain withdraw rob deviate stray shift settle smash bump slam project depart haul progress"
    " proceed displace double triple halve switch emerge escape impinge jump hop skip tension loosen traverse"
    " experience circle encounter contact intersect incline tilt slant equal shrink clear bear withstand sustain"
    " fire reel hoist develop arise appear disappear vanish transmit slacken tighten tauten",
)
IRREGULAR = {
    "go": "goes went gone going", "slide": "slid", "come": "comes came coming", "fall": "falls fell fallen falling",
    "rise": "rises rose risen rising", "fly": "flies flew flown flying", "sink": "sinks sank sunk sinking",
    "spin": "spins spun spinning", "swing": "swings swung swinging", "hit": "hits hitting",
    "strike": "strikes struck striking", "meet": "meets met meeting", "leave": "leaves left leaving",
    "begin": "begins began begun beginning", "take": "takes took taken taking", "get": "gets got getting gotten",
    "make": "makes made making", "lose": "loses lost losing", "throw": "throws threw thrown throwing",
    "let": "lets letting", "feel": "feels felt feeling", "give": "gives gave given giving", "run": "runs ran running",
    "cut": "cuts cutting", "shut": "shuts shutting", "spend": "spends spent spending", "set": "sets setting",
    "keep": "keeps kept keeping", "hold": "holds held holding", "catch": "catches caught catching",
    "become": "becomes became becoming", "break": "breaks broke broken breaking", "lie": "lies lay lain lying",
    "hang": "hung", "stand": "stands stood standing", "draw": "draws drew drawn drawing", "burn": "burnt",
    "swap": "swaps swapped swapping", "ride": "rides rode riding", "grow": "grows grew grown growing",
    "shrink": "shrank shrunk",
    "bear": "bore borne", "light": "lights lit lighting", "wind": "winds wound winding",
    "sweep": "sweeps swept sweeping", "bring": "brings brought bringing",
    "lift": "lifts lifted lifting",
}  # fmt: skip
AUXILIARIES = frozenset(
    re.split(
        " ",
        "is are was were be been being am has have had having does do did will shall",
    )
)
EMPTY = frozenset(
    re.split(
        " ",
        "uselessly vainly exactly precisely just momentarily instantaneously briefly actually then now freely"
        " already been being "
        "still ever currently simply indeed itself themselves itself there",
    )
)
"""Adverbs that change neither the moment nor the value that a question asks for, beside the first time."""


def _forms(verb: str) -> Iterator[str]:
    """Yield the regular forms of a verb."""
    if verb.endswith("e"):
        stems = (f"{verb}s", f"{verb}d", f"{verb[:-1]}ing")
    elif verb.endswith("y") and verb[-2] not in "aeou":
        stems = (f"{verb[:-1]}ies", f"{verb[:-1]}ied", f"{verb}ing")
    elif re.search(r"(?:s|sh|ch|x|z)$", verb):
        stems = (f"{verb}es", f"{verb}ed", f"{verb}ing")
    else:
        stems = (f"{verb}s", f"{verb}ed", f"{verb}ing", f"{verb}{verb[-1]}ed", f"{verb}{verb[-1]}ing")
    yield from stems


@cache
def _bases() -> dict[str, str]:
    found = {form: verb for verb in REGULAR for form in _forms(verb)}
    return found | {form: verb for verb, forms in IRREGULAR.items() for form in forms.split()}


def verb_forms() -> frozenset[str]:
    """Return all inflected forms of verbs, auxiliaries included."""
    return AUXILIARIES.union(_bases())


def based(text: str) -> str:
    """Return a text with the base forms of its verbs, without auxiliaries and without words that say nothing."""
    bases = _bases()
    words = (bases.get(word, word) for word in text.split())
    return " ".join(word for word in words if word not in AUXILIARIES and word not in EMPTY)
