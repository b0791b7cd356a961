"""Base forms of verbs, and paraphrases of the clauses that name a moment."""

import re
from collections.abc import Iterator, Mapping
from functools import cache

from sim2reason.questions.ordinary.clause_heads import CLAUSE_HEADS, FALL, START_WORDS, S
from sim2reason.questions.ordinary.vocabulary import GROUNDS, QUANTITIES, any_of_pattern, pattern

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
    bases = {form: verb for verb in REGULAR for form in _forms(verb)}
    return bases | {form: verb for verb, forms in IRREGULAR.items() for form in forms.split()}


def verb_forms() -> frozenset[str]:
    """Return all inflected forms of verbs, auxiliaries included."""
    return AUXILIARIES.union(_bases())


def with_base_forms(text: str) -> str:
    """Return a text with base forms of its verbs, without auxiliaries and empty words."""
    bases = _bases()
    words = (bases.get(word, word) for word in text.split())
    return " ".join(word for word in words if word not in AUXILIARIES and word not in EMPTY)


DIRECTION_PATTERN = re.compile(
    r"(?<![\w@])(?<!used )(?<!use )(?<!speed )(?<!speeds )(?<!speeding )(?<!burnt )(?<!burned )(?<!pick"
    r" )(?<!picks )(?<!picked )"
    r"(?<!set )(?<!put )(?<!laid )(?<!end )(?<!ends )(?<!ended )(?<!wind )(?<!winds )"
    r"(?<!shut )(?<!shuts )(?<!touch )(?<!touches )(?<!slow )(?<!slows )"
    r"(?:further |straight |vertically )?(?P<way>up|down|uphill|downhill|upwards?|downwards?|to right"
    r"|to left)"
    r"(?! vertical)(?: (?:along )?GROUNDS| its path)?(?![\w@])".replace("GROUNDS", GROUNDS)
)
PLACE_PATTERN = re.compile(
    rf"(?<![\w@])(?:(?:along|on|across|over|upon|in|through|off|of|inside|within|down|up|above) )?(?:(?:{GROUNDS})"
    r"|(?:(?:left|leave|right|sloping|incline|slant|its) )+face|(?:(?:uniform |electric |magnetic )*field|straight"
    r" line|air|vertical guide|guide|track|its path|path|its (?:plane|slope|side|track)|its"
    r" (?:flight|motion|swing|orbit|arc|trajectory"
    r"|journey|way|climb|rise|fall|descent|ascent)))"
    r"|(?<![\w@])'s (?:(?:circular|elliptical) )?(?:orbit|path|trajectory|motion|flight|swing)"
    r"|(?<![\w@])(?:in|of|during|on) (?:(?:whole|entire|circular) )*(?:path|arc|orbit|flight|motion|trajectory|swing)"
    r"(?![\w@])"
)
_LOOSE = frozenset(
    re.split(
        " ",
        "it its 's of at in to by for on with first time moment instant point reach pass get through has where "
        "maximum they their them position place a an the , one value go come become be finally eventually good "
        "permanently ever",
    )
)
_ON_ITS_WAY = re.compile(r" on (?:its |@\d+@ 's |their )?(?:way|journey|trip) (?:back|home|there|out)\b(?! from)")
_ON_OTHER_SIDE = re.compile(
    r" (?:on|at) (?:other|opposite|far) side(?: of (?:its path|axle|pivot|vertical|lowest point))?\b"
)
_FOR_GOOD = re.compile(r"\b(?:finally|eventually|for good|permanently|at last|for ever|everything)\b")
MOVE_TOGETHER_CLAUSE = "they move together"
_PASSED = "highest point", "lowest point", "vertical", "closest", "farthest", "relaxed", "equilibrium"
_PASSING = frozenset(
    re.split(
        " ",
        "swing move fly roll slide travel pass passage sweep fall rise arrive",
    )
)
"""Verbs of motion that a reader may ignore where a clause names the place that a body passes."""
_WITH = re.compile(rf"(?:with|into|against|by|of) (?:<> +)?(?:its +)?(?:first +)?{S}")  # *its collision with C*
_ORDINAL = pattern("ORDINAL")


@cache
def _quantities() -> str:
    return any_of_pattern(name for row in QUANTITIES.values() for name in row.split("|"))


@cache
def _head(told: str) -> re.Pattern[str]:
    told = told.replace("GROUNDS", GROUNDS).replace("SURFACE", GROUNDS)
    told = told.replace("START", START_WORDS).replace("QUANTITY", _quantities())
    return re.compile(rf"(?<![\w@#-])(?:{told})(?![\w@#-])")


def paraphrased(clause: str) -> Iterator[str]:
    """Yield plain equivalents of a clause, if they account for every word of the clause."""
    if re.search(r"\b(?:not|half|without|unless|never|except|last|another|more|less|next|than)\b", clause) and not (
        re.search(r"without (?:slip|slid|skid)|(?:shorter|longer|higher|lower) than", clause)
    ):
        return
    clause, across = _ON_OTHER_SIDE.subn("", _ON_ITS_WAY.sub("", clause))
    text = " ".join(DIRECTION_PATTERN.sub(lambda match: f" <{way_of(match['way'])}> ", clause).split())
    text = with_base_forms(text)
    ways = " ".join(re.findall("<.+?>", text))
    bare = " ".join(re.sub("<.+?>", " ", text).split())
    for template, plain in CLAUSE_HEADS.items():
        searched, more = (text, "") if "<" in template.replace("(?P<", "") else (bare, ways)
        for match in _head(template).finditer(searched):
            for plainly in _filled(plain, match, f"{searched[: match.start()]} {searched[match.end() :]} {more}"):
                yield f"{plainly} on other side" if across else plainly


def way_of(word: str) -> str:
    """Return the plain word for a direction: up, down, right or left."""
    return {"uphill": "up", "upwards": "up", "upward": "up", "downhill": "down"}.get(word, word).removesuffix("wards")


def _filled(plain: str, match: re.Match[str], rest: str) -> Iterator[str]:
    """Yield a plain clause with the subject, number and direction filled in; nothing if a word is left over."""
    ways = re.findall(r"<(.+?)>", rest)
    rest = PLACE_PATTERN.sub(" ", re.sub(r"<.+?>", " ", rest))
    subjects = list(dict.fromkeys(re.findall(S, rest) + re.findall(S, match[0])))
    plain = _for_these(plain, subjects, ways, f"{match[0]} <> {rest}")
    count = [word for word in _ORDINAL.findall(rest) if word != "first" and "collision" not in plain]
    rest = re.sub(r"\beverything\b", " ", rest) if "stops" in plain else rest
    left = set(re.sub(S, " ", _ORDINAL.sub(" ", rest)).split()) - _LOOSE
    if any(phrase in plain for phrase in _PASSED):
        left -= _PASSING
    ways = [] if plain == MOVE_TOGETHER_CLAUSE else ways
    fits = (
        len(subjects) <= 1 + ("{t}" in plain) and len(count) <= ("{count}" in plain) and len(ways) <= ("{way}" in plain)
    )
    if left or not plain or not fits:
        return
    groups = {key: value or "" for key, value in match.groupdict().items()}
    one, other = (*subjects, "", "")[:2]
    clause = plain.format(
        s=one,
        t=other,
        n=next((groups[key] for key in "nmk" if groups.get(key)), ""),
        way=f" {ways[0]}" if ways else "",
        count=f" for {count[0]} time" if count else "",
        axis=groups.get("axis", ""),
        sign="-" if groups.get("sign") else "",
        heading=groups.get("heading", ""),
        q=next((groups[key] for key in "qro" if groups.get(key)), ""),
        times=next((groups[key] for key in ("times", "fold", "tripled") if groups.get(key)), ""),
        sense=_sense(groups),
    )
    yield re.sub(r" of equals", " equals", " ".join(clause.split()))


def _for_these(plain: str, subjects: list[str], ways: list[str], text: str) -> str:
    """Return a plain clause adapted to the number of its subjects and to a direction; empty if it has no meaning.

    `text` is the head of the clause, then ``<>``, then the rest of the clause.
    """
    rest = text.partition("<>")[2]
    if plain == "{s} stops":
        return "{s} finally stops" if _FOR_GOOD.search(rest) is not None else "{s} stops going{way}" if ways else plain
    if plain == "{s} returns" and re.search(r"\borigin\b", text) is not None:
        return "{s} returns to origin"
    if "{t}" not in plain or len(subjects) > 1:
        return plain
    numbers = _ORDINAL.findall(rest)
    if "collide" in plain and subjects and _WITH.search(text):
        return "" if numbers not in ([], ["first"]) else "meets {s}"
    if "collide" in plain:
        whose = "{s} 's" if subjects else "its" if re.search(r"\bits\b", rest) else ""
        return f"{whose} {numbers[0]} collision" if len(numbers) == 1 else "" if numbers else "{s} collides"
    return "" if "{n}" in plain else re.sub(r" (?:to|from) \{t\}", "", plain)


def _sense(groups: Mapping[str, str]) -> str:
    """Return the verb for vertical motion of a body; *rises* if a sentence does not give the direction."""
    falls = re.fullmatch(FALL, groups.get("fall", "")) is not None or groups.get("down") == "<down>"
    return "falls" if falls else "rises"
