"""Clauses of questions in ordinary English that name a moment, each with its reader."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import replace

from sim2reason.questions.moments.reached import SECOND_TIME_PREFIX
from sim2reason.questions.ordinary import moment_readers as read
from sim2reason.questions.ordinary import place_readers as place
from sim2reason.questions.ordinary.base_forms import paraphrased
from sim2reason.questions.ordinary.hearing import TokenizedSentence
from sim2reason.questions.ordinary.moment_phrases import AFTER, PAST, THEN, When
from sim2reason.questions.ordinary.moment_readers import Reader, is_time
from sim2reason.questions.ordinary.vocabulary import GOES_DOWN, GOES_UP, pattern

_ON_THE_WAY = re.compile(r" (?:(?:while|when) )?(?:on (?:its )?way|going|moving) (?P<way>up|down)(?:wards?)?$")

_ON_ONE_SIDE = re.compile(r" (?:on|at) (?:its )?(?P<side>left|right)(?:(?: |-)hand)?(?: side)?$")
_LATER = re.compile(r"(?P<n>#\d+#) (?:after|past|following) (?P<event>.+)")


def read_moments(clause: str, sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield every moment that a clause may mean, for any subject of the sentence if the clause names no subject."""
    going = _ON_THE_WAY.search(clause)
    if going is not None and going.start() > 0:
        yield from _on_the_way(clause[: going.start()].strip(), going["way"], sentence, subject, side)
        return
    beside = _ON_ONE_SIDE.search(clause)
    if beside is not None and beside.start() > 0:
        yield from _on_one_side(clause[: beside.start()].strip(" ,"), beside["side"], sentence, subject, side)
        return
    moments = list(_of_tables(clause, sentence, subject, side))
    plain = dict.fromkeys(paraphrased(clause)) if not moments else ()
    moments = moments or [when for paraphrase in plain for when in _of_tables(paraphrase, sentence, subject, side)]
    yield from moments or _later(clause, sentence, subject)


def _later(clause: str, sentence: TokenizedSentence, subject: str) -> Iterator[When]:
    """Yield the moment that a clause such as *2 s after the collision* means."""
    match = _LATER.fullmatch(clause)
    if match is None or not is_time(sentence.number(match["n"])):
        return
    for when in read_moments(match["event"], sentence, subject, AFTER):
        if "collided" in when.told and not when.told.endswith(" before"):
            yield replace(when, told=f"{sentence.number(match['n'])}{PAST}{when.told}", side=THEN)


def _named_first(clause: str, sentence: TokenizedSentence, subject: str) -> str:
    """Return the first subject that a clause names, or else the given one."""
    token = re.search(r"@\d+@", clause)
    return sentence.subject(token[0]) if token is not None else subject


def _on_one_side(clause: str, beside: str, sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the turning point that a clause such as *stops on the left* means, presuming the stated side."""
    who = _named_first(clause, sentence, subject)
    for when in read_moments(f"{clause} on other side", sentence, subject, side):
        yield replace(when, ways=(*when.ways, (who, beside)))


def _on_the_way(clause: str, direction: str, sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield every moment that a clause may mean, presuming that a body goes up, or down, at that moment."""
    who = _named_first(clause, sentence, subject)
    for when in read_moments(clause, sentence, subject, side):
        ways = (*when.ways, (who, GOES_UP if direction == "up" else GOES_DOWN))
        yield replace(when, ways=ways)
        if " = " in when.told:
            yield replace(when, told=f"{SECOND_TIME_PREFIX}{when.told}", ways=ways)


def _of_tables(clause: str, sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    for template, reader in CLAUSES.items():
        match = pattern(template).fullmatch(clause)
        if match is None:
            continue
        named = match.groupdict().get("s") is not None
        subjects = dict.fromkeys((subject, *(() if named else (*sentence.subjects, ""))))
        for rank, who in enumerate(subjects):
            yield from (replace(when, rank=when.rank + rank) for when in reader(match, sentence, who, side))


CLAUSES: Mapping[str, Reader] = {
    "{s} moves {n} relative to (?:{t}|carrier)": read.read_relative_displacement,
    "meets {t}": read.read_collision_with,
    "[{s} ]sets off": place.sets_off,
    "{s} (?:~|to )(?:gone|go|travelled|moved|been|swept) (?P<turns>half|quarter)(?:way| way| of way) (?:round"
    "|around)(?: {t})?": (place.read_orbit_fraction),
    "{s} stays below {n}": place.stays_below,
    "{s} is under {t}": place.read_point_below_carrier,
    " ?[{number=ORDINAL} ]edge lands": read.velocity_jump_reader("edge landed"),
    "[{s} ]at height of {n}": place.read_height,
    "[{s} ]moves {n} vertically {way=WAY}": place.vertically,
    "[(?:{s}|they) ]~nearest together[ FIRST_TIME]": place.read_closest_approach,
    "[(?:{s}|they) ]~farthest apart[ FIRST_TIME]": place.most_apart,
    "[{s} ]crosses (?P<axis>x|y) axis": place.read_axis_crossing,
    "[{s} ]fastest": place.read_greatest_speed,
    "[{s} ]back at its height": place.back_at_height,
    "(?P<q>speed|velocity|kinetic energy|acceleration|spring force|tension|momentum) of(?: {s})?"
    " (?P<times>\\w+)(?: times)+ at first": place.read_quantity_multiple,
    "{s} leaves surface": place.lifts_off,
    "[{s} ]~{n}[ away] from origin": place.from_origin,
    "{s} returns to origin": place.back_at_origin,
    "[{s} ]stops on other side": place.read_far_side_stop,
    "[{s} ]~[PASSES ][its |@0@ 's ]TOP on other side": place.read_far_side_stop,
    "[{s} ]~(?:lose|loses|lost) (?P<times>half|third|quarter|tenth) (?:of )?(?:its |@\\d+@ 's )(?:initial |original )?"
    "(?P<q>speed|velocity)": place.lost_share,
    "[{s} ]~[only ](?P<times>half|third|quarter|tenth) of (?:its |@\\d+@ 's )(?:initial |original |first ){q=QUANTITY}"
    " left": place.read_quantity_fraction,
    "(?:{s} 's {q=QUANTITY}|QUANTITY of {t}) ~(?P<times>halved)": place.read_quantity_fraction,
    "[{s} ]returns": read.read_return,
    "[{s} ]~(?:closest|nearest) to far end[ of {t}]": place.near_end,
    "[{s} ]turns in (?P<axis>x|y)": place.read_axis_stop,
    "[{s} ]~has (?:(?P<most>greatest|maximum|largest|maximal|highest)|least|minimum|smallest|minimal|lowest)"
    " (?P<axis>x|y)": (place.extreme_coordinate),
    "[{s} ]heads (?P<heading>\\S+) (?P<axis>x|y)": place.read_heading,
    "[very |extremely ]long time[ after START| (?:later|afterwards|has passed)]|in long run": place.after_long,
    "[{s} ]moves parallel to (?P<axis>x|y) axis": place.read_axis_parallel,
    "[{s} ]makes (?P<turns>one|half|two|three|ten) revolutions?": place.revolved,
    "[{s} ]~(?:made|turned through|turned|completed|done|rotated through|performed) (?P<turns>half|quarter) (?:of )?"
    "(?:turn|revolution|rotation)": place.revolved,
    "[{s} ]burns {n} of fuel": place.read_burnt_fuel,
    "[{s} ]~(?:burn(?:s|ed|t|ing)?|use(?:s|d)|use|consume(?:s|d)|consume|spend|spent)(?: up)? (?P<times>half|third"
    "|quarter) (?:of )?(?:all |its )?fuel": (place.share_burnt),
    "(?:has |is )?(?P<times>half|third|quarter) (?:of )?(?:all |its )?fuel ~(?:burnt|burned|used up|used|consumed"
    "|spent|gone)["
    " up]": place.share_burnt,
    "{s} 's {q=QUANTITY} ~(?:fallen to |dropped to |decreased to |risen to |reached |reaches |falls to )?(?P<times>half"
    r"|third|quarter|tenth) (?:of )?(?P<ref>[its |@\d+@ 's ](?:maximum|greatest|initial|starting|original|first"
    r"|largest|highest)"
    "[ value| one| speed| velocity])": place.read_quantity_fraction,
    "[{s} ]stops going {way=WAY}": read.stops_going,
    "[{s} ~at |at ]distance of {n}[ from {t}]": place.read_separation,
    "{q=QUANTITY} of {s} ~(?:dropped|fallen|decreased|sunk|shrunk|risen|diminished) to"
    " (?P<times>half|third|quarter|tenth) (?:of )?(?P<ref>(?:its |@\\d+@ 's )?(?:original|initial|starting|first)"
    "(?: value| one| speed)?)": place.read_quantity_fraction,
    "[{s} ]finally stops": place.for_good,
    "[{s} ](?P<sense>falls|rises) with (?P<axis>vertical|horizontal) speed of {n}": read.has_component,
    "[{s} ]at (?P<axis>x|y) = (?P<sign>-?){n}": read.read_coordinate,
    "{q=QUANTITY} of {s} equals {n}": read.quantity_is,
    "(?P<q>acceleration|velocity) of {s} equals {n} (?P<up>up|down)": read.read_component_sign,
    "{q=QUANTITY} equals {n}": read.quantity_is,
    "[t = |time t = |time ]{n}[ START]": read.read_time,
    "{n} after START": read.read_time,
    "{n}[ have passed| has passed| have elapsed]": read.read_time,
    "first {n}[ after START| of motion]": read.read_time,
    "{n}[ of travel| of path| of its path]": read.read_path_length,
    "first second[ after START| of motion]": read.second,
    "[very ]START[ of motion]": place.read_start,
    "[{s} ]~{motion=MOTION} [first |distance of ]{n}[ {way=WAY}| ALONG_IT]": read.read_displacement,
    "[{s} ]~{motion=MOTION}[ {way=WAY}| ALONG_IT] [by |through |distance of ]{n}": read.read_displacement,
    "[{s} ]first {n}[ {way=WAY}| ALONG_IT| of its path]": read.read_displacement,
    "{s} has first {motion=MOTION} {n}": read.read_displacement,
    "[{s} ]~[first ][momentarily ]STOPS[ AGAIN][ FIRST_TIME][ for instant]": read.subject_moment_reader("stopped"),
    "[{s} ]~[first ]LANDS[ FIRST_TIME]": read.landed,
    "[{s} ]~LANDS for {number=ORDINAL} time": read.landed,
    "[its |@0@ 's |{s} 's ]{number=ORDINAL} (?:bounce|impact|landing|rebound)": read.velocity_jump_reader(
        "bounced", "edge landed"
    ),
    "[{s} ]~[first ]BOUNCES[ FIRST_TIME]": read.velocity_jump_reader("bounced"),
    "[{s} ]~BOUNCES for {number=ORDINAL} time": read.velocity_jump_reader("bounced"),
    "[(?:{s}|they) ]~[first ]COLLIDE[ FIRST_TIME]": read.velocity_jump_reader("collided"),
    "{number=ORDINAL} collision": read.velocity_jump_reader("collided"),
    "[their ]{number=ORDINAL} collision (?:of|between) {s} (?:and|with) {t}": read.meet_again,
    "{s} 's {number=ORDINAL} collision": read.velocity_jump_reader("collided"),
    "{s} ~(?:hit|struck) by {t}[ FIRST_TIME]": read.read_pair_collision,
    "[pure ]rolling (?:sets in|begins|starts)": read.subject_moment_reader("stopped slipping"),
    "{number=ORDINAL} collision (?:take|takes|took) place": read.velocity_jump_reader("collided"),
    "{number=ORDINAL} collision (?:happen|happens|occur|occurs)": read.velocity_jump_reader("collided"),
    "(?:their|its) {number=ORDINAL} collision": read.velocity_jump_reader("collided"),
    "{s} ~HITS wall[ FIRST_TIME]": read.velocity_jump_reader("bounced"),
    "[{s} ]~[PASSES ][its |@0@ 's ]FARTHEST[ from {t}| of its PATH][ FIRST_TIME]": read.apsis_reader("farthest"),
    "[{s} ]~[PASSES ][its |@0@ 's ]NEAREST[ to {t}| of its PATH][ FIRST_TIME]": read.apsis_reader("closest"),
    "[{s} ]~(?:most strongly|most|fully) compressed": read.subject_moment_reader("most compressed"),
    "[{s} ]~(?:most strongly|most|fully) (?:stretched|extended)": read.subject_moment_reader("most stretched"),
    "{s} ~PASSES [its ]GREATEST compression": read.subject_moment_reader("most compressed"),
    "{s} ~PASSES [its ]GREATEST extension": read.subject_moment_reader("most stretched"),
    "all collisions[ ~over]": read.unique_moment_reader("last collision"),
    "[its ]impact": read.with_last_rank(read.landed),
    "last collision": read.unique_moment_reader("last collision"),
    "{s} ~HITS {t}[ FIRST_TIME]": read.read_pair_collision,
    "{s} and {t} ~COLLIDE[ FIRST_TIME]": read.read_pair_collision,
    "(?:collision|impact) (?:of|between) {s} and {t}": read.read_pair_collision,
    "[{s} ]~[PASSES ][its |{t} 's ]TOP[ of [its ]PATH][ FIRST_TIME]": read.turned_back("highest point", "up"),
    "[{s} ]~[PASSES ][its |{t} 's ]BOTTOM[ of [its ]PATH][ FIRST_TIME]": read.turned_back("lowest point", "down"),
    "[{s} ]~(?:passes through|passing through|pass through|MOTION to|MOTION down to) vertical": (
        read.subject_moment_reader("lowest point")
    ),
    "{s} ~(?:vertical|hangs vertically|hangs straight down|hanging vertically)": read.subject_moment_reader(
        "lowest point"
    ),
    "[in |at ][its ]vertical position": read.subject_moment_reader("lowest point"),
    "[{s} ]~(?:starts|begins|start|begin) [to ]MOTION (?:again|back)[ WAY]": read.subject_moment_reader("stopped"),
    "{s} ~(?:makes|make|at) [angle of ]{n}(?: with| to| from) [downward ]vertical": read.angle,
    "{s} ~horizontal": place.read_horizontal_line,
    "[{s} ]~{motion=MOTION} (?:through|by) [angle of ]{n}[ from START| from its starting position]": read.read_turn,
    "[{s} ]~(?:reach|reaches|reached|has|attains) (?:speed|velocity) of {n}": read.has_speed,
    "[{s} ]~(?:reach|reaches|reached) {n}": read.has_speed,
    "{s} ~MOTION (?:at|with) [speed of ]{n}": read.has_speed,
    "{s} 's (?:speed|velocity) (?:~|BECOMES ){n}": read.has_speed,
    "(?:speed|velocity) of {s} (?:~|BECOMES ){n}": read.has_speed,
    "[{s} 's |its ]BURNOUT": read.unique_moment_reader("burned out"),
    "{s} RUNS_OUT": read.unique_moment_reader("burned out"),
    "[{s} ][first ]ROLLS[ on {t}]": read.subject_moment_reader("stopped slipping"),
    "(?:slipping|sliding|skidding) (?:stops|ends|ceases|is over)": read.subject_moment_reader("stopped slipping"),
    "(?:{s}|they) ~(?:move|moves|moving) together": read.read_joint_motion,
    "[{s} ]NATURAL[ AGAIN][ FIRST_TIME]": place.read_natural_length,
    "[{s} ]~(?:reach |reaches )?[point |at point ](?:farthest|furthest)[ away][ from {t}]": read.apsis_reader(
        "farthest"
    ),
    "[{s} ]~(?:reach |reaches )?[point |at point ](?:closest|nearest)[ to {t}]": read.apsis_reader("closest"),
    "[its |{s} 's ](?:farthest|furthest)[ from {t}]": read.apsis_reader("farthest"),
    "[its |{s} 's ](?:closest|nearest)[ to {t}]": read.apsis_reader("closest"),
    "{s} closest to {t}": read.apsis_reader("closest"),
    "{s} farthest from {t}": read.apsis_reader("farthest"),
    "{s} ~{n}[ away] from {t}": place.read_separation,
    "{s} ~{strain=STRAINED} by {n}": place.read_spring_strain,
    "{s} ~{n} long": place.read_spring_length,
    "[{s} ]~[PASSES ][its ]equilibrium position[ FIRST_TIME]": place.read_equilibrium,
    "{s} ~{n} from [its ]equilibrium position": place.read_equilibrium,
    "{s} (?:goes|go) slack": read.subject_moment_reader("went slack"),
    "{s} (?:becomes|become|goes|gets) taut[ AGAIN]": read.subject_moment_reader("went taut"),
    "{s} (?:leaves|leave|loses contact with|lifts off) (?:{t}|SURFACE)": place.lifts_off,
    "{s} (?:enters|enter) (?:field|region)": read.subject_moment_reader("entered region"),
    "{s} (?:leaves|leave|exits) (?:field|region)": read.subject_moment_reader("left region"),
    "{s} (?:begins|starts|begin|start) to (?:slip|slide)": read.subject_moment_reader("began to slip"),
}
"""By what a clause is like: what reads its moments."""
