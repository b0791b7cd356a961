"""Patterns of questions for a number, such as *what mass must B have for A to slip*, and their parts."""

import re
from collections.abc import Iterator
from functools import cache
from typing import NamedTuple

from sim2reason.questions.ordinary.hearing import TokenizedSentence
from sim2reason.questions.ordinary.vocabulary import GROUNDS
from sim2reason.questions.ordinary.whatif.numbers import NUMBER, NamedNumber, named_number, number_pattern
from sim2reason.questions.posing import DIFFERENCE, GREATEST, LEAST, RATIO, VALUE

SIZES = {
    LEAST: "least|minimum|minimal|smallest|lowest|slowest|shortest|lightest",
    GREATEST: "greatest|maximum|maximal|largest|highest|biggest|longest|heaviest|steepest",
}
_SIZE = (
    rf"(?:(?:(?P<least>{SIZES[LEAST]})|(?P<greatest>{SIZES[GREATEST]})|new|other|required|necessary|possible"
    rf"|different) )*"
)
_BOUND = r"(?: ?,? (?:(?P<atleast>at least|at minimum)|(?P<atmost>at most|at maximum)) ?,?)?"
_AUX = "(?:would|must|should|does|do|will|can|could|may|is|are|has|have|did)"
_BE = "(?:have to be|need to be|needs to be|has to be|have been|have had to be|to be|be)"
_GETS = (
    "(?:allow|enable|let|make|give|cause|bring|keep|take|carry|get|leave|set|send|lift|prevent|ensure that"
    "|hold|cause|permit|haul|drag|draw|pull|raise|move|push|start|halve|double|treble|triple|put)"
)
_GETTING = (
    f"(?:{_GETS}|allows|enables|lets|makes|gives|causes|brings|keeps|takes|carries|gets|leaves|sets|sends|lifts"
    f"|prevents"
    "|ensures that|holds|permits|made|kept|carried|brought|given|taken|sent|let|caused|allowed|enabled|got|set|left"
    "|haul|drag|draw|pull|raise|move|push|start|halve|double|treble|triple|halves|doubles|hauls|drags|draws|pulls"
    "|raises|moves|starts)"
)
_CONN = (
    "(?:for|and still|and yet|so that|such that|if|to|in order that|in order to|in order for|that|so|before"
    "|in such way that)"
)
_NEED = "(?:(?:just |barely )?(?:needed|required|necessary|enough|sufficient|big enough|large enough|high enough))"
_FIND = (
    "(?:find|determine|calculate|compute|what is|which is|what are|work out|give|state|what was|what would be"
    "|what will be)"
)
_LAUNCHED = (
    "(?:thrown|launched|started|set moving|set in motion|set off|projected|fired|kicked|pushed off|struck"
    "|sent off|released|set going|pushed|set turning|set rolling|set rotating|shot|hit|sent|rolled|spun)"
)
_CONST = f"(?: (?:at start|initially|off|upwards|up {GROUNDS}|down {GROUNDS}))?"
NUMBER_FRAMES = (
    f"(?:for|with|at|from|by|on|under|in) (?:what|which) {_SIZE}{NUMBER} {_AUX} (?P<c>.+)",
    (
        f"(?:with )?(?:what|which) {_SIZE}{NUMBER} {_AUX} (?P<s>@\\d+@) (?:need|have|require)(?: to have| to be"
        f" given)?{_BOUND}(?: {_CONN})? (?P<c>.+)"
    ),
    (
        f"(?:with |at )?(?:what|which) {_SIZE}{NUMBER} {_AUX} (?P<s>@\\d+@) (?:have to |need to )?be {_LAUNCHED}(?:"
        f" with)?{_CONST}{_BOUND} {_CONN} (?P<c>.+)"
    ),
    f"(?:what|which) (?:would|must|should|does|will) {_SIZE}{NUMBER} {_BE}{_BOUND} {_CONN} (?P<c>.+)",
    f"how (?:large|great|big|strong|high|small|low|much) {_AUX} {_SIZE}{NUMBER} {_BE}{_BOUND} {_CONN} (?P<c>.+)",
    f"(?:what|which) {_SIZE}{NUMBER} (?:is|would(?: just)? be|are|was|will be) {_NEED}{_BOUND} {_CONN} (?P<c>.+)",
    (
        f"(?:what|which) {_SIZE}{NUMBER} (?:(?:would|must|will|does|could|can|should) )?(?:have )?"
        f"(?:(?:just|still|barely) )*(?P<c>{_GETTING} .+)"
    ),
    f"(?:{_FIND}) {_SIZE}{NUMBER} (?:for|with|at|by) which (?P<c>.+)",
    f"(?:{_FIND}) {_SIZE}{NUMBER} (?:so that|such that|if|for|to) (?P<c>.+)",
    f"(?:{_FIND}) {_SIZE}{NUMBER} (?:that is )?(?:{_NEED}){_BOUND} {_CONN} (?P<c>.+)",
    (
        f"(?:{_FIND}) {_SIZE}{NUMBER} that (?:would |will |must |should |can |could )?(?:have )?"
        f"(?:(?:just|still|barely) )*(?P<c>{_GETTING} .+)"
    ),
    (
        f"(?:{_FIND}) {_SIZE}{NUMBER}(?: that| which)? (?P<s>@\\d+@) (?:would |must |should |will |could |can |may"
        f" )?(?:have )?(?:need|needs|needed|have|has|require|requires|required)"
        f"(?: to have)?{_BOUND}(?: {_CONN})? (?P<c>.+)"
    ),
    (
        f"(?:{_FIND}) {_SIZE}{NUMBER} (?:with|at) which (?P<s>@\\d+@) (?:would|must|should) (?:have to )?be"
        f" {_LAUNCHED}{_CONST} {_CONN} (?P<c>.+)"
    ),
    f"(?:if|for) (?P<c>[^,]+) , (?:what|which) (?:would|must|should) {_SIZE}{NUMBER} (?:{_BE})",
    f"(?P<c>[^.]+)\\. (?:what|which) (?:would|must|should|does) {_SIZE}{NUMBER} (?:{_BE})(?: {_CONN} this)?",
    f"(?P<c>[^.]+)\\. (?:what|which) {_SIZE}{NUMBER} (?:is|would be) (?:{_NEED})(?: {_CONN} this)?",
    f"(?P<c>[^.]+)\\. (?:{_FIND}) {_SIZE}{NUMBER}(?: that is)?(?: {_NEED})?",
    f"(?P<c>[^.]+)\\. (?:what|how (?:large|great|big|high)) {_AUX} {_SIZE}{NUMBER} {_BE}{_BOUND}(?: {_CONN} this)?",
    (
        f"(?P<ratio>how many times) (?:as (?:large|great|high|big)|larger|greater|higher) (?:would|must|should)"
        f" {NUMBER} (?:{_BE}) {_CONN} (?P<c>.+)"
    ),
    f"(?P<ratio>by what factor|how many times) (?:would|must|should) {NUMBER} (?:{_BE}) {{more}} {_CONN} (?P<c>.+)",
    f"(?P<difference>by how much|how much) (?:would|must|should) {NUMBER} (?:{_BE}) {{more}} {_CONN} (?P<c>.+)",
    f"(?P<difference>how much) {{more}} (?:would|must|should) {NUMBER} (?:{_BE}) {_CONN} (?P<c>.+)",
)
_MORE = (
    "(?P<more>larger|greater|higher|increased|raised|bigger|multiplied|faster|stronger|changed)"
    "|(?P<less>smaller|reduced|lower|lowered|decreased|less)"
)
ADJECTIVES = {
    "(?:heavy|massive)": "mass",
    "(?:light)": "mass",
    "(?:stiff|strong|hard)": "stiffness",
    "long": "length",
}
SPEEDS = "(?:(?:with|at) what|how) SIZE(?:fast|(?:initial |launch |starting )?(?:speed|velocity))"
ADJECTIVE_FRAMES = (
    (f"how (?P<adj>{'|'.join(ADJECTIVES)}) {_AUX} (?P<s>@\\d+@) {_BE}{_BOUND} {_CONN} (?P<c>.+)", ""),
    (
        (
            f"(?:what|which) SIZE(?:initial )?(?:speed|velocity) {_AUX} (?:blow|kick|push|hammer) (?:have to |need to"
            f" )?(?:give|impart to) (?P<s>@\\d+@){_BOUND} {_CONN} (?P<c>.+)"
        ),
        "speed",
    ),
    (
        (
            f"(?:{SPEEDS}) {_AUX} (?:blow|kick|push|hammer) (?:have to |need to )?(?:send|start|launch|knock|drive|set"
            f"|push|throw) (?P<s>@\\d+@)(?: off| away| going| in motion| moving)?{_CONST}{_BOUND} {_CONN} (?P<c>.+)"
        ),
        "speed",
    ),
    (
        (
            f"(?:at|from|under|with) what SIZE(?:initial |starting |release )?angle(?: (?:to|from|with)"
            f" (?:downward )?vertical)? {_AUX} (?P<s>@\\d+@)"
            f" (?:have to |need to )?be (?:released|let go|started|held)(?: from rest)? {_CONN} (?P<c>.+)"
        ),
        "swing angle",
    ),
    (
        (
            f"how high {_AUX} point of (?:projection|launch|release|throw)(?: of (?P<s>@\\d+@))? {_BE}{_BOUND} {_CONN}"
            f" (?P<c>.+)"
        ),
        "height",
    ),
    (
        (
            f"how fast {_AUX} (?P<s>@\\d+@) (?:have to |need to )?be (?:turning|rotating|spinning)(?: at start|"
            f" initially)?"
            f"{_BOUND} {_CONN} (?P<c>.+)"
        ),
        "angular speed",
    ),
    (f"how long {_AUX} (?P<s>@\\d+@) {_BE} (?:at start|initially){_BOUND} {_CONN} (?P<c>.+)", "initial length"),
    (
        (
            f"how (?:hard|strongly) {_AUX} (?:hand )(?:have to |need to )?(?:pull|tug)(?: on @\\d+@)?{_BOUND} {_CONN}"
            f" (?P<c>.+)"
        ),
        "force",
    ),
    (
        (
            f"(?:with )?what SIZE(?:force|pull) {_AUX} (?:hand )(?:have to |need to )?(?:exert|apply|provide|pull"
            f" with|use)(?: on @\\d+@)?{_BOUND} {_CONN} (?P<c>.+)"
        ),
        "force",
    ),
    (
        (
            f"(?:with what SIZE(?:force|pull)) {_AUX} (?:hand )(?:have to |need to )?(?:pull|tug){_BOUND} {_CONN}"
            f" (?P<c>.+)"
        ),
        "force",
    ),
    (
        (
            f"(?:{SPEEDS}) {_AUX} (?P<s>@\\d+@) (?:have to |need to |has to )?(?:be {_LAUNCHED}|be moving|be"
            f" rolling|be sliding|be going|be"
            f" travelling|move|travel|go|be){_CONST}{_BOUND} {_CONN} (?P<c>.+)"
        ),
        "speed",
    ),
    (
        (
            f"(?:{SPEEDS}) {_AUX} (?P<s>@\\d+@) (?:have to |need to )?(?:start|set off|begin)(?:"
            f" out)?{_CONST}{_BOUND} {_CONN} (?P<c>.+)"
        ),
        "speed",
    ),
    (
        (
            f"(?:(?:with|at) what SIZE(?:initial )?angular (?:speed|velocity)) {_AUX} (?P<s>@\\d+@) (?:have to |need to"
            f" )?(?:be {_LAUNCHED}|start|begin|turn|rotate){_CONST}{_BOUND} {_CONN} (?P<c>.+)"
        ),
        "angular speed",
    ),
    (
        (
            f"(?:at|under|from) what SIZE(?:angle|elevation)(?: (?:above|to) horizontal)? {_AUX} (?P<s>@\\d+@)"
            f" (?:have to |need to )?be {_LAUNCHED} {_CONN} (?P<c>.+)"
        ),
        "launch angle",
    ),
    (f"from what SIZE(?:height) {_AUX} (?P<s>@\\d+@) (?:have to |need to )?be {_LAUNCHED} {_CONN} (?P<c>.+)", "height"),
    (f"how (?:high) {_AUX} (?P<s>@\\d+@) (?:have to |need to )?be when {_LAUNCHED} {_CONN} (?P<c>.+)", "height"),
    (
        (
            f"how far from (?:axle|axis|pivot) {_AUX} (?P<s>@\\d+@) (?:have to |need to )?be(?: (?:fixed|attached"
            f"|mounted|placed|put))? {_CONN} (?P<c>.+)"
        ),
        "distance",
    ),
    (f"how (?:steep) {_AUX} (?:{GROUNDS}) {_BE}{_BOUND} {_CONN} (?P<c>.+)", "slope"),
    (f"how (?:rough) {_AUX} (?:{GROUNDS}) {_BE}{_BOUND} {_CONN} (?P<c>.+)", "friction"),
    (
        (
            f"(?:by )?how (?:much|far) {_AUX} (?P<s>@\\d+@) (?:have to |need to )?be (?:compressed|stretched"
            f"|extended)(?: at start| initially) {_CONN} (?P<c>.+)"
        ),
        "strain",
    ),
)
"""Patterns of sentences in which a verb or an adjective names the number, such as *how heavy* a mass."""


_BOUNDED = re.compile(
    r"(?:(?P<early>at (?:least|most)) (?=(?:with |for |at |from )?(?:what|how)\b)"
    rf"|(?P<head>(?:with |for |at |from )?(?:how [a-z]+|what (?:[a-z]+ ){{1,4}}?)) ?(?P<bound>at (?:least|most))"
    rf" (?={_AUX} ))"
    r"(?P<rest>.+)"
)
"""A sentence such as *at least how fast must ...*, which asks for the least number before it names the number."""


class WantedFrame(NamedTuple):
    """The parts of a question for a number, such as *what is the least mass of B for A to slip*.

    The `end` is *least*, *greatest* or empty, and `compare` the form of the answer: see `posing`. The `condition` is
    what the number is to bring about, and `subject` the token of its subject. `grows` says whether the sentence
    presumes that the number is to be greater than it is, or less, if it presumes either.
    """

    number: NamedNumber
    end: str
    compare: str
    condition: str
    subject: str
    grows: bool | None = None


def split_number_question(text: str, sentence: TokenizedSentence) -> Iterator[WantedFrame]:
    """Yield each way to split a sentence into the number that it asks for and the condition on it."""
    subject = {f"@{index}@": phrase for index, phrase in enumerate(sentence.subjects)}
    bound = _BOUNDED.fullmatch(text)
    if bound is not None:
        end = LEAST if "least" in (bound["early"] or bound["bound"]) else GREATEST
        yield from (
            frame._replace(end=end)
            for frame in split_number_question(f"{bound['head'] or ''}{bound['rest']}", sentence)
            if frame.end in ("", end)
        )
        return
    for template in NUMBER_FRAMES:
        match = _frame(template).fullmatch(text)
        if match is not None:
            yield _wanted(match, named_number(match, subject))
    for template, kind in ADJECTIVE_FRAMES:
        match = _frame(template).fullmatch(text)
        if match is not None:
            groups = match.groupdict()
            owner = subject.get(groups.get("s") or "")
            yield _wanted(match, NamedNumber(kind or _adjective(groups["adj"], owner or ""), (owner,) if owner else ()))


def _adjective(adjective: str, owner: str) -> str:
    name = next(name for regex, name in ADJECTIVES.items() if re.fullmatch(regex, adjective))
    return "mass" if name == "stiffness" and "spring" not in owner else name


def _wanted(match: re.Match[str], number: NamedNumber) -> WantedFrame:
    groups = match.groupdict()
    smallest, greatest = (
        (groups.get("least") or groups.get("atleast")),
        (groups.get("greatest") or groups.get("atmost")),
    )
    end = LEAST if smallest else GREATEST if greatest else ""
    compare = RATIO if groups.get("ratio") else DIFFERENCE if groups.get("difference") else VALUE
    subject = groups.get("s") or (groups.get("own") or groups.get("of") or "" if compare != VALUE else "")
    grows = True if groups.get("more") else False if groups.get("less") else None
    return WantedFrame(number, end, compare, groups["c"].strip(" ,"), subject, grows)


@cache
def _frame(told: str) -> re.Pattern[str]:
    sized = told.replace("SIZE", _SIZE).replace("{more}", f"(?:{_MORE})")
    return re.compile(sized.replace(NUMBER, number_pattern()))
