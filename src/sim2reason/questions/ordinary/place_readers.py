"""Readers of clauses that name a moment by a position, by a state of a spring, by the start, or by a multiple."""

import re
from collections.abc import Iterator
from dataclasses import replace

from sim2reason.questions.moments.reached import SECOND_TIME_PREFIX
from sim2reason.questions.ordinary.hearing import TokenizedSentence
from sim2reason.questions.ordinary.moment_phrases import AT_BURNOUT, BEFORE, GREATEST, LONG, TIMES, When
from sim2reason.questions.ordinary.moment_readers import (
    LAST_RANK,
    LIFT_OFF,
    apsis_reader,
    is_time,
    read_return,
    subject_of,
)
from sim2reason.questions.ordinary.vocabulary import (
    ACROSS,
    ASKS_FOR_POSITION,
    BELOW_CARRIER_PREFIX,
    CENTRAL,
    COMPRESSED,
    DIES_AWAY,
    FARTHEST,
    HEADING,
    HELD,
    LIFTS,
    LINE_WITH_FIXED_END,
    ONE_LINE,
    ORIGIN,
    PASSES_EQUILIBRIUM,
    QUANTITIES,
    RELAXED,
    RESTS,
    SETS_OFF,
    SPRUNG,
    STANDS,
    STRETCHED,
    UNMOVED,
    matching_entry,
)

FACTORS = {"double": 2, "twice": 2, "treble": 3, "triple": 3, "three": 3, "quadruple": 4, "four": 4, "ten": 10}


def read_horizontal_line(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a line is horizontal."""
    yield When(f"{subject_of(match, sentence, subject)} deflected 90 deg", side)


def sets_off(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the start, presuming that a body moves at once or, for *before*, that only positions affect the value."""
    presumption = UNMOVED if side == BEFORE else SETS_OFF
    yield When("at start", ways=((subject_of(match, sentence, subject), presumption),))


def stays_below(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the bounce after which a body no longer rises to a given height above the ground."""
    del subject
    yield When(f"{sentence.subject(match['s'])} stayed below {sentence.number(match['n'])}", side)


def read_orbit_fraction(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a body has completed half or a quarter of its orbit."""
    del subject
    pair = " & ".join(sentence.subject(match[key]) for key in "st" if match[key])
    yield When(f"{pair} orbited {180 if match['turns'] == 'half' else 90} deg", side)


def read_point_below_carrier(
    match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str
) -> Iterator[When]:
    """Yield the moment when a swinging body is vertically below the body that carries it along a level line."""
    del subject
    who = sentence.subject(match["s"])
    yield When(f"{who} lowest point", side, ((who, f"{BELOW_CARRIER_PREFIX}{sentence.subject(match['t'])}"),))


def read_height(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a body is at a height above the ground."""
    yield When(
        f"height above the ground of {subject_of(match, sentence, subject)} = {sentence.number(match['n'])}", side
    )


def vertically(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a body is a given height above, or below, its starting point."""
    who, down = subject_of(match, sentence, subject), (match["way"] or "").startswith("down")
    moment = f"displacement of {who} along vertical = {'-' if down else ''}{sentence.number(match['n'])}"
    yield When(moment, side)


def read_axis_crossing(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the first moment after the start when a body is on an axis."""
    who, other = subject_of(match, sentence, subject), "y" if match["axis"] == "x" else "x"
    yield When(f"{other} coordinate of {who} = 0", side)


def read_greatest_speed(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment at which a body is fastest."""
    yield When(f"{subject_of(match, sentence, subject)} fastest", side)


def lifts_off(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a body leaves the face on which it moves, or a rocket the ground."""
    who = subject_of(match, sentence, subject)
    yield from (When(f"{who} {event}", side) for event in ("left face", "lifted off"))
    yield When("at start", ways=((who, LIFTS),))


def back_at_height(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a body is as high again as it was at the start."""
    yield When(f"displacement of {subject_of(match, sentence, subject)} along vertical = 0 m", side)


def back_at_origin(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a body that starts at the origin is back there."""
    who = subject_of(match, sentence, subject)
    for when in read_return(match, sentence, subject, side):
        yield replace(when, ways=((who, f"{ORIGIN} x"),))
    yield When(f"x coordinate of {who} = 0", side, ((who, ONE_LINE),), rank=1)


def from_origin(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a body is a given distance from the origin."""
    who = subject_of(match, sentence, subject)
    yield When(f"distance from the origin of {who} = {sentence.number(match['n'])}", side)


def read_quantity_multiple(
    match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str
) -> Iterator[When]:
    """Yield the moment when a quantity is a multiple of its initial value."""
    who, find = subject_of(match, sentence, subject), matching_entry(QUANTITIES, match["q"])
    yield When(f"{find} of {who} = {FACTORS[match['times'].split()[0]]}{TIMES}", side)


def read_far_side_stop(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a body rests beyond the lowest point of its path, at its own stop or at any other stop."""
    who = subject_of(match, sentence, subject)
    yield When(f"{who} stopped", side, ((who, ACROSS),))
    yield When("stopped", side, ((who, ACROSS), (who, STANDS)))


def read_start(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the start; for a lift-off only if the body lifts off at once."""
    if LIFT_OFF.search(match[0]) is not None or LIFT_OFF.search(sentence.text) is not None:
        yield When("at start", ways=((subject, SETS_OFF),))
    else:
        yield When("at start", ways=(("", UNMOVED),) if side == BEFORE else ())


def read_separation(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when two bodies are a given distance apart."""
    del subject
    if not is_time(sentence.number(match["n"])):
        yield When(f"distance = {sentence.number(match['n'])}", side)


def read_equilibrium(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a body on one spring is at equilibrium, or at a given distance from equilibrium."""
    number = match.groupdict().get("n")
    moment = f"extension = {sentence.number(number)}" if number else "natural length"
    yield When(moment, side, (("", RELAXED),))
    if not number:
        yield When("equilibrium", side, (("", ASKS_FOR_POSITION),))
        yield When(f"{subject_of(match, sentence, subject)} fastest", side, (("", PASSES_EQUILIBRIUM),))


def read_spring_strain(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a spring is stretched or compressed by a given length."""
    who = subject_of(match, sentence, subject)
    squeezed = match["strain"] == "compressed"
    presumption, sign = (COMPRESSED, "-") if squeezed else (STRETCHED, "")
    moment = f"extension of {who} along {STRETCHED} = {sign}{sentence.number(match['n'])}"
    yield When(moment, side, ((who, presumption),))


def read_spring_length(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a spring has a given length."""
    yield When(f"spring length of {subject_of(match, sentence, subject)} = {sentence.number(match['n'])}", side)


def read_natural_length(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a spring has its natural length."""
    yield When(f"{subject_of(match, sentence, subject)} natural length", side)


def read_axis_parallel(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the first moment after the start when a body moves parallel to an axis, in either direction."""
    other = "y" if match["axis"] == "x" else "x"
    yield When(f"velocity of {subject_of(match, sentence, subject)} along {other} = 0 m/s", side)


REVOLUTIONS = {"half": "0.5", "quarter": "0.25", "one": "1", "two": "2", "three": "3", "ten": "10"}
FRACTIONS = {"half": "0.5", "halved": "0.5", "third": "0.333333333333", "quarter": "0.25", "tenth": "0.1"}


def revolved(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a body has made a number of revolutions."""
    yield When(f"revolutions made of {subject_of(match, sentence, subject)} = {REVOLUTIONS[match['turns']]}", side)


def read_burnt_fuel(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a given mass of fuel has been burnt."""
    yield When(f"fuel burnt of {subject_of(match, sentence, subject)} = {sentence.number(match['n'])}", side)


def share_burnt(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a fraction of the fuel has been burnt."""
    del sentence, subject
    yield When(f"fuel burnt = {FRACTIONS[match['times']]}{AT_BURNOUT}", side)


def read_quantity_fraction(
    match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str
) -> Iterator[When]:
    """Yield the moment when a quantity is a fraction of its greatest or its initial value."""
    who, find = subject_of(match, sentence, subject), matching_entry(QUANTITIES, match["q"])
    greatest = re.search(r"maximum|greatest|largest|highest", match.groupdict().get("ref") or "") is not None
    yield When(f"{find} of {who} = {FRACTIONS[match['times']]}{GREATEST if greatest else TIMES}", side)


def lost_share(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a quantity has lost a fraction of its initial value."""
    who, find = subject_of(match, sentence, subject), matching_entry(QUANTITIES, match["q"])
    yield When(f"{find} of {who} = {1.0 - float(FRACTIONS[match['times']]):.12g}{TIMES}", side)


def read_heading(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the first and the second moment when a body moves parallel to an axis, presuming the named direction."""
    who, other = subject_of(match, sentence, subject), "y" if match["axis"] == "x" else "x"
    sign = "+" if match["heading"] in ("positive", "+") else "-"
    for again in ("", SECOND_TIME_PREFIX):
        moment = f"{again}velocity of {who} along {other} = 0 m/s"
        yield When(moment, side, ((who, f"{HEADING}{sign}{match['axis']}"),))


def for_good(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment from which a body stays at rest: its last stop, or a late time if a medium resists."""
    who = subject_of(match, sentence, subject)
    yield When(f"{who} halted", side)
    yield When(LONG, side, ((who, DIES_AWAY),))
    yield When(f"{who} stopped", side, ((who, RESTS),), rank=1)


def after_long(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield a moment so late that the quantity asked for no longer changes."""
    del match, sentence, subject
    yield When(LONG, side)


def read_axis_stop(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the first moment at which a body stops moving along an axis."""
    yield When(f"velocity of {subject_of(match, sentence, subject)} along {match['axis']} = 0 m/s", side)


def read_closest_approach(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when two bodies are closest: if a spring joins them, that of greatest compression."""
    yield from apsis_reader("closest")(match, sentence, subject, side)
    yield When("most compressed", side, (("", SPRUNG),), rank=LAST_RANK)


def most_apart(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when two bodies are farthest apart: if a spring joins them, that of greatest extension."""
    yield from apsis_reader("farthest")(match, sentence, subject, side)
    yield When("most stretched", side, (("", SPRUNG),), rank=LAST_RANK)


def extreme_coordinate(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment at which a coordinate of a body is greatest or least, presuming that it turns back there."""
    who, axis = subject_of(match, sentence, subject), match["axis"]
    presumption = f"{FARTHEST}{'+' if match['most'] else '-'}{axis}"
    yield When(f"velocity of {who} along {axis} = 0 m/s", side, ((who, presumption),))
    yield When(f"{SECOND_TIME_PREFIX}velocity of {who} along {axis} = 0 m/s", side, ((who, presumption),))


def near_end(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment at which a body is nearest to the fixed end of its spring, if only the spring acts on it."""
    who = subject_of(match, sentence, subject)
    spring = sentence.subject(match["t"])
    ways = ((who, f"{HELD}{spring or LINE_WITH_FIXED_END}"), ("", CENTRAL))
    yield When(f"{spring} most compressed".strip(), side, ways)
