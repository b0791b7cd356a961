"""Paraphrases of clauses that name a moment: the head of a clause decides, and every other word must have its place."""

import re
from collections.abc import Iterator, Mapping
from functools import cache

from sim2reason.questions.ordinary.base_forms import based
from sim2reason.questions.ordinary.vocabulary import GROUNDS, QUANTITIES, either, pattern

_N, _S = r"#\d+#", r"@\d+@"
_MOST = "(?:most|maximum|maximal|maximally|greatest|largest|biggest|highest|fully|completely|strongest|longest|peak)"
_MOVE = "(?:move|slide|travel|go|cover|fly|recoil|advance|get|come|pull|drag|traverse|push|complete|pass|be|carry|shift|run)"
_FALL, _RISE = "(?:fall|drop|descend|sink|lower)", "(?:rise|climb|ascend|lift|raise)"
_ROLL, _TURN = "roll", "(?:turn|rotate|spin|swing|revolve)"
_DISTANCE = rf"(?:(?:by|through|over|(?:total |whole )?distance of|path of|total of) )?(?P<n>{_N})"
_HOME = (
    "(?:its )?(?:own )?(?:original |initial |first )?(?:origin|start(?:ing)?(?: point| position| place| location)?"
    "|(?:release|launch|throw|throwing|launching|starting|kick) point|(?:point|place|position|location) of (?:release|launch|departure)"
    "|(?:original|initial) (?:point|position|place|location)"
    "|(?:(?:place|point|position|location|spot) )?(?:on SURFACE )?"
    "(?:where|from (?:where|which)|at which) (?:it|@\\d+@) (?:first )?(?:start|release|launch|begin|set off|leave|throw))"
    "(?: from)?(?: position)?"
)
HOME = rf"(?:{_HOME})"
_START = (
    "(?:start|release|launch|blow|kick|beginning|lift-off|liftoff|takeoff|take-off|let go|ignition|throw|setting off"
    "|set off|outset|motion (?:begin|start)|engine (?:start|ignite|switch on)|set in motion|leave origin)"
)
_SAME = "(?:same|common|equal|one)(?: (?:speed|velocity))"

HEADS: Mapping[str, str] = {
    # rest
    "(?:(?:come|bring|get|return|slow(?: down)?) (?:to )?)?(?:a )?(?:complete |full |dead |total |momentary |temporary "
    "|instantaneous )?(?:rest|halt|stop|standstill)": "{s} stops",
    "(?:cease|stop|finish|end) (?:its )?(?:move|slide|roll|rise|climb|fall|ascend|descend|motion|ascent|descent|go|fly)"
    "(?: up| down)?": "{s} stops",
    "(?:turn|swing|go|move|slide|roll|come|fall|start|head)(?: (?:move|slide|roll|go|fall|swing|come))? "
    "(?:back|round|around)(?: down)?": "{s} stops",
    "turning point|point of return|reverse(?: its)?(?: direction| motion| way| course| sense)*(?: of motion| of travel)?"
    "|change (?:its )?(?:direction|sense)(?: of motion| of travel)?|stationary|stand still|motionless"
    "|lose all (?:of )?(?:its )?(?:speed|velocity|motion)|(?:speed|velocity) (?:become |drop to |fall to |reach |vanish"
    "|equal to )?zero|have no (?:speed|velocity)": "{s} stops",
    "(?:motion|movement) (?:stop|cease|end|is over|over|come to end)": "{s} finally stops",
    # impacts
    "(?:hit|strike|reach|touch|meet|impact|contact|land|return|fall|come|drop|arrive|get|crash|encounter)"
    "(?: back)?(?: down)?(?: to| on| onto| with| at| into| against| upon)? GROUNDS(?: again)?"
    "|(?:land|touch down|touchdown|impact|come (?:back )?down)(?: GROUNDS)?": "{s} lands{count}",
    "(?:bounce|rebound|impact|hop|landing|hit|strike|touch|collision)"
    "(?: (?:off|from|against|on|with|at|into)?(?: GROUNDS| wall| fixed wall))?": "{s} bounces{count}",
    "(?:collide|meet|crash|touch|hit|strike|bump|impact|collision|contact|encounter)"
    "(?: (?:into|with|each other|one another|against|up))*(?: (?:take place|happen|occur))?"
    "|come (?:into|in) contact|make contact": "{s} and {t} collide{count}",
    "(?:all|every one of) (?:of )?(?:the )?(?:collision|impact)s?(?: (?:over|take place|happen))?|last collision": (
        "last collision"
    ),
    # places of a path
    "(?:top|highest point|highest position|maximum height|greatest height|peak|apex|summit|zenith|maximum altitude"
    "|greatest altitude|as high as (?:it|@\\d+@) (?:get|go|come)|highest|upper turning point|highest altitude|maximum elevation)": "{s} at its highest point",
    "(?:bottom|lowest point|lowest position|as low as (?:it|@\\d+@) (?:get|go|come)|lowest|minimum height|lower turning point)": "{s} at its lowest point",
    "(?:vertically |directly |straight |exactly )?(?:below|beneath|under|underneath) (?:axle|pivot|fixed point"
    "|point of suspension|suspension point|suspension|support|trolley|hinge)|vertical(?: position| line| line| "
    "orientation)?|hang (?:straight|vertically)(?: down| downward| downwards)?|point (?:straight|vertically) "
    "(?:down|downward|downwards)": "{s} passes through vertical",
    "(?:closest|nearest)(?: approach| point| distance| position)?|perihelion|periapsis|pericentre|perigee|periastron"
    "|minimum distance|least distance|smallest distance": "{s} closest to {t}",
    "(?:farthest|furthest|most distant)(?: point| distance| away| out| position)?|aphelion|apoapsis|apocentre|apogee"
    "|apastron|maximum distance|greatest distance|largest distance": "{s} farthest from {t}",
    # springs
    "(?:natural|unstretched|relaxed|unstrained|undeformed|rest|own) length|relaxed|relax|unstretched|unstrained"
    "|undeformed|neither stretch nor compress|no longer (?:stretch|compress|deform)": "{s} is relaxed",
    f"{_MOST} compress|{_MOST} compression|compress {_MOST}|compress (?:the )?most|compress as far as possible"
    "|shortest|minimum length|smallest length|shortest length": "{s} most compressed",
    f"{_MOST} (?:stretch|extend|extension|elongation)|(?:stretch|extend) (?:the )?most|longest|maximum length"
    "|greatest length|longest length|(?:stretch|extend) as far as possible": "{s} most stretched",
    rf"(?:stretch|extend|extension|elongation)(?: by| of)? (?P<n>{_N})|(?P<m>{_N}) (?:stretch|extend|extension)"
    rf"|(?P<k>{_N}) longer than (?:its )?natural length": "{s} stretched by {n}",
    rf"(?:compress|shorten|compression)(?: by| of)? (?P<n>{_N})|(?P<m>{_N}) (?:compress|compression)"
    rf"|(?P<k>{_N}) shorter than (?:its )?natural length": "{s} compressed by {n}",
    rf"(?:length)(?: (?:of|reach|become|pass|equal))? (?P<n>{_N})|(?P<m>{_N}) long|(?P<k>{_N}) in length": "{s} {n} long",
    "equilibrium(?: position| point)?|position of equilibrium|rest position": "{s} at its equilibrium position",
    # engines
    "(?:(?:all|last|whole|rest)(?: of)? )?(?:its )?fuel (?:supply )?(?:tank )?(?:use up|run out|go|burn(?: out| up| off)?"
    "|exhaust|consume|spend|gone|finish|end|empty|use|give out)|(?:engine|motor|burn|thrust) "
    "(?:itself )?(?:stop|cut out|cut off|shut down|shut off|burn out|end|finish|switch off|turn off|run out|quit|cease"
    "|go out|off)(?: (?:burn|fire|work|run))?|burnout|burn-out|(?:engine )?(?:cutoff|cut-off|shutdown|shut-down)"
    "|run out of fuel|out of fuel|(?:use|burn|consume|spend|exhaust)(?: up)? (?:all )?(?:of )?(?:its )?fuel|burn out"
    "|end of (?:the )?burn|(?:fuel )?tank (?:empty|run dry)|no fuel (?:left|leave|remain)": "burnout",
    # slipping
    "(?:(?:start|begin) (?:to )?)?(?:pure(?:ly)? )?(?:roll|rolling)(?: purely)?(?: without (?:slip|slide|skid)(?:ping)?)"
    "|(?:start|begin) (?:to )?(?:pure |purely )?roll|(?:stop|cease|end|finish|no longer) (?:slip|slide|skid)"
    "|(?:slip|slide|skid)(?:ping)? (?:stop|cease|end|over)|pure roll(?:ing)?(?: (?:start|begin|set in))?": (
        "{s} rolls without slipping"
    ),
    f"(?:reach |attain |acquire |get )?(?:{_SAME})|{_MOVE} (?:together|as one|with {_SAME}|at {_SAME})|"
    f"(?:at |with )?{_SAME}|(?:stop|cease|end|no longer) (?:slip|slide)(?:ping|ing)? (?:on|over|along|past|against) "
    f"(?:each other|one another|{_S})|move together": "they move together",
    # distances
    rf"{_MOVE}(?: {_MOVE})? {_DISTANCE}|{_DISTANCE.replace('<n>', '<m>')} of (?:its )?(?:path|travel|motion|way|slope)": (
        "{s} moves {n}{way}"
    ),
    rf"(?:{_MOVE}|{_FALL}|{_RISE}) {_DISTANCE} (?:relative to|with respect to|along|over|across|on) (?:top of )?(?P<t>{_S})"
    "(?: 's top)?": "{s} moves {n} relative to {t}",
    rf"(?:{_MOVE}|{_FALL}|{_RISE}) {_DISTANCE} (?:along|over|across|on) its top": "{s} moves {n} relative to carrier",
    rf"{_FALL} {_DISTANCE}": "{s} falls {n}{way}",
    rf"{_RISE} {_DISTANCE}": "{s} rises {n}{way}",
    rf"{_ROLL} {_DISTANCE}": "{s} rolls {n}{way}",
    rf"{_TURN} (?:through |by )?(?:(?:an )?angle of )?(?P<n>{_N})": "{s} turns through {n}",
    rf"(?P<n>{_N})(?: away)? from {HOME}": "{s} moves {n}{way}",
    rf"(?P<n>{_N})(?: away)? from {_S}|(?:distance|separation)(?: of| reach| become)? (?P<m>{_N})"
    rf"|(?P<k>{_N}) apart": "{s} {n} from {t}",
    rf"(?:make |at |reach )?(?:an )?(?:angle of )?(?P<n>{_N}) (?:with|from|to|off|against) (?:downward )?vertical": (
        "{s} makes {n} with vertical"
    ),
    # speeds and times
    rf"(?P<fall>{_FALL}|{_RISE}|move|go|travel)?(?: (?P<down><(?:up|down)>))? ?(?:with|at|have)? ?(?:downward |upward )?"
    rf"(?P<axis>vertical|horizontal) (?:component of )?(?:speed|velocity)(?: component)?(?: of| reach| become)? (?P<n>{_N})": (
        "{s} {sense} with {axis} speed of {n}"
    ),
    rf"(?P<axis>[xy])(?: ?= ?|(?:-| )(?:coordinate|position) (?:of |reach |become |equal )*)(?P<sign>[-−]?)(?P<n>{_N})": (
        "{s} at {axis} = {sign}{n}"
    ),
    rf"(?P<q>QUANTITY)(?: of {_S})?(?: (?:of|reach|become|equal|equal to|fall to|drop to|rise to|increase to"
    rf"|decrease to))* (?P<n>{_N})": "{q} of {s} equals {n}",
    rf"(?:speed|velocity)(?: (?:of|reach|become|equal|equal to|fall to|drop to|rise to|increase to|decrease to"
    rf"|be|go))? (?P<n>{_N})|(?:reach|attain|acquire|move at|move with|go at|travel at|have|achieve|gain|get to)"
    rf"(?: speed of| velocity of)? (?P<m>{_N})": "{s} reaches speed of {n}",
    rf"(?:{_MOVE}|{_FALL}|{_RISE}|{_ROLL}|accelerate|burn|in motion|under way) (?:for|during) (?P<n>{_N})": "t = {n}",
    rf"(?:t|time) ?= ?(?P<n>{_N})|time (?P<m>{_N})|(?P<k>{_N})(?: (?:later|elapse|pass|go by|into (?:its )?motion"
    r"|(?:from|after|of|since|following|past)(?: [a-z]+)? (?:START|motion)))?": "t = {n}",
    "START(?: of (?:its )?motion)?": "start",
    "(?:go|become|get|turn) slack|slack": "{s} goes slack",
    "(?:go|become|get|pull) (?:taut|tight)(?: again)?|taut|tight": "{s} becomes taut",
    "(?:leave|lose contact with|lift off|detach from|lose touch with|separate from|come off) (?:@\\d+@|GROUNDS)": (
        "{s} leaves surface"
    ),
    "(?:enter|come into|get into|reach) (?:electric |magnetic )?(?:field|region)(?: region)?": "{s} enters field",
    "(?:leave|exit|come out of|emerge from|get out of) (?:electric |magnetic )?(?:field|region)": "{s} leaves field",
    "(?:begin|start) (?:to )?(?:slip|slide|skid)": "{s} begins to slip",
    f"(?:return|come back|get back|go back|back|again|return again|arrive back|slide back|roll back|fall back|move back)"
    f"(?: (?:to|at|in|through|past))? {HOME}(?: again)?|(?:pass|reach|cross|regain) (?:through )?{HOME}(?: again)?"
    f"|return": "{s} returns",
}
"""By the base form of a clause's head, the plain clause that says the same."""

WAY = re.compile(
    r"(?<![\w@])(?:further |straight |vertically )?(?P<way>up|down|uphill|downhill|upwards?|downwards?|to right|to left)"
    r"(?: (?:along )?GROUNDS| its path)?(?![\w@])".replace("GROUNDS", GROUNDS)
)
PLACES = re.compile(
    rf"(?<![\w@])(?:(?:along|on|across|over|upon|in|through|off|of|inside|within|down|up|above) )?(?:(?:{GROUNDS})"
    r"|(?:(?:uniform |electric |magnetic )*field|straight line|air|vertical guide|guide|track|its path|path|its (?:flight|motion|swing|orbit|arc|trajectory"
    r"|journey|way|climb|rise|fall|descent|ascent)))"
    r"|(?<![\w@])'s (?:(?:circular|elliptical) )?(?:orbit|path|trajectory|motion|flight|swing)"
    r"|(?<![\w@])(?:in|of|during|on) (?:(?:whole|entire|circular) )*(?:path|arc|orbit|flight|motion|trajectory|swing)"
    r"(?![\w@])"
)
_LOOSE = frozenset(
    "it its 's of at in to by for on with first time moment instant point reach pass get through has "
    "where maximum they their them position place a an the , one value go come become be finally eventually good permanently ever".split()
)
_FOR_GOOD = re.compile(r"\b(?:finally|eventually|for good|permanently|at last|for ever)\b")
_PASSED = "highest point", "lowest point", "vertical", "closest", "farthest", "relaxed", "equilibrium"
_PASSING = frozenset("swing move fly roll slide travel pass sweep fall rise arrive".split())
"""Verbs that say nothing beside a place that a body passes."""
_ORDINAL = pattern("ORDINAL")


@cache
def _quantities() -> str:
    return either(name for row in QUANTITIES.values() for name in row.split("|"))


@cache
def _head(told: str) -> re.Pattern[str]:
    told = told.replace("GROUNDS", GROUNDS).replace("SURFACE", GROUNDS)
    told = told.replace("START", _START).replace("QUANTITY", _quantities())
    return re.compile(rf"(?<![\w@#-])(?:{told})(?![\w@#-])")


def paraphrased(clause: str) -> Iterator[str]:
    """Yield plain clauses that say what a clause says, if every word of the clause has its place."""
    if re.search(r"\b(?:not|half|without|unless|never|except|last|another|more|less|next|than)\b", clause) and not (
        re.search(r"without (?:slip|slid|skid)|(?:shorter|longer) than", clause)
    ):
        return
    text = " ".join(WAY.sub(lambda found: f" <{way_of(found['way'])}> ", clause).split())
    text = based(text)
    ways = " ".join(re.findall("<.+?>", text))
    bare = " ".join(re.sub("<.+?>", " ", text).split())
    for told, plain in HEADS.items():
        said, more = (text, "") if "<" in told.replace("(?P<", "") else (bare, ways)
        for found in _head(told).finditer(said):
            yield from _filled(plain, found, f"{said[: found.start()]} {said[found.end() :]} {more}")


def way_of(said: str) -> str:
    return {"uphill": "up", "upwards": "up", "upward": "up", "downhill": "down"}.get(said, said).removesuffix("wards")


def _filled(plain: str, found: re.Match[str], rest: str) -> Iterator[str]:
    """Yield a plain clause with the subject, number and way of a clause; nothing if a word is left without a place."""
    groups = found.groupdict()
    ways = re.findall(r"<(.+?)>", rest)
    rest = PLACES.sub(" ", re.sub(r"<.+?>", " ", rest))
    subjects = list(dict.fromkeys(re.findall(_S, rest) + re.findall(_S, found[0])))
    count = [word for word in _ORDINAL.findall(rest) if word != "first"]
    left = set(re.sub(_S, " ", _ORDINAL.sub(" ", rest)).split()) - _LOOSE
    if any(place in plain for place in _PASSED):
        left -= _PASSING
    two = "{t}" in plain
    if plain == "{s} stops" and _FOR_GOOD.search(rest) is not None:
        plain = "{s} finally stops"
    if left or len(count) > 1 or len(ways) > 1 or len(subjects) > 1 + two:
        return
    if plain == "{s} stops" and ways:
        plain = "{s} stops going{way}"
    elif plain == "they move together":
        ways = []
    if (count and "{count}" not in plain) or (ways and "{way}" not in plain):
        return
    if (
        "collide" in plain
        and len(subjects) == 1
        and re.search(rf"(?:with|into|against|by|of) +{_S}", f"{found[0]} {rest}")
    ):
        plain = "meets {s}" if not _ORDINAL.findall(rest) else ""
    elif "collide" in plain and len(subjects) < 2:
        number = next(iter(_ORDINAL.findall(rest)), "")
        own = re.search(r"\bits\b", rest) is not None or subjects
        whose = "{s} 's" if subjects else "its" if own else ""
        plain = f"{whose} {number} collision" if number else "{s} collides"
    elif two and len(subjects) < 2:
        if "{n}" in plain:
            return
        plain = re.sub(r" (?:to|from) \{t\}", "", plain)
    if not plain:
        return
    number = next((groups[key] for key in "nmk" if groups.get(key)), "")
    one, other = (*subjects, "", "")[:2]
    told = plain.format(
        s=one,
        t=other,
        n=number,
        way=f" {ways[0]}" if ways else "",
        count=f" for {count[0]} time" if count else "",
        axis=groups.get("axis") or "",
        sign="-" if groups.get("sign") else "",
        q=groups.get("q") or "",
        sense=_sense(groups),
    )
    yield re.sub(r" of equals", " equals", " ".join(told.split()))


def _sense(groups: Mapping[str, str | None]) -> str:
    """Return the verb for the way in which a body moves up or down; *rises* where a sentence does not tell."""
    falls = re.fullmatch(_FALL, groups.get("fall") or "") is not None or groups.get("down") == "<down>"
    return "falls" if falls else "rises"
