"""Tokenization of a sentence: tokens for the scene's subjects and for numbers, the rest in lower case."""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache

from sim2reason.questions.moments.occurrence import can_roll
from sim2reason.questions.ordinary.base_forms import verb_forms
from sim2reason.questions.ordinary.moment_phrases import EVERYTHING
from sim2reason.questions.ordinary.names import (
    between,
    group,
    named_lines,
    swinging_lines,
    with_letters,
    with_particles,
)
from sim2reason.questions.ordinary.rewording import reword_question
from sim2reason.questions.ordinary.turns_of_order import without_asides, without_leads
from sim2reason.questions.ordinary.vocabulary import GENERIC_NOUNS, NOUNS, QUANTITIES, WORDS, any_of_pattern
from sim2reason.questions.sentences import plainly
from sim2reason.questions.words import DIGITS_PATTERN, Words
from sim2reason.simulation.quantities import QUANTITIES as REGISTERED
from sim2reason.simulation.quantities.subjects.bodies import Bodies, ancestor_chain

MAX_QUESTION_LENGTH = 400  # characters of a question
ALL_WORD = "all"  # the word for several subjects together
_NUMBER = re.compile(
    rf"(?<![\w.#@])({DIGITS_PATTERN}(?:\.{DIGITS_PATTERN})?(?:[eE][+-]?\d{{1,2}})?)"
    r"(°|\s?(?:[a-zA-Zµμ%Ω][\w/·^²³⁻*]*))?(?![\w.]*\d)"
)
_UNITS = {
    "metres per second": "m/s", "meters per second": "m/s", "m/s2": "m/s²", "newtons": "N", "newton": "N",
    "joules": "J", "joule": "J", "kilograms": "kg", "kilogram": "kg", "degrees": "°", "deg": "°", "radians": "rad",
    "watts": "W", "hertz": "Hz",
}  # fmt: skip
_UNIT = re.compile(
    r"m|s|kg|Msun|g|N|J|W|Hz|°|rad|au|yr|km|cm|mm|T|C|au/yr|(?:[a-zA-Zµ]{1,4}[/·²³].*)|[kmMµu](?:N|J|C|T|g|s|m)"
)
_ADJECTIVES = re.compile(r"\b(?:connecting|joining|light) (?=(?:string|rope|cord|cable|thread)\b)")
_OWN_ADJECTIVES = re.compile(
    r"\b(?:(?:small|uniform|solid|thin|light|rigid|heavy|little|charged|hollow|straight|movable|fixed"
    r"|spherical|homogeneous|massive|massless|long|short|given|said) )+"
    rf"(?=(?:{'|'.join(sorted({'arm', 'hemisphere', 'pulley'}.union(*NOUNS)))})\b)"
)
_CENTER = re.compile(r"\b(?:centre|center) of (?:mass of )?(?=@)|(@\d+@) 's (?:centre|center)(?: of mass)?")
_CENTER_OF_ONE = re.compile(r"\b(?:centre|center) of @(\d+)@")
_INDIRECT = re.compile(r"^(?:[Dd]etermine|[Ff]ind|[Cc]alculate|[Cc]ompute|[Ww]ork out) (?=how )")
_RELEASED = re.compile(r"^(?:if|when|after) (?:system|everything|it|@0@) is (?:released|let go)(?: from rest)? , ")
_FROM_REST = re.compile(
    r" ?,? ?\b(?:(?:starting|released|beginning|after (?:starting|being released)) )?from rest\b ?,?"
)
_START = re.compile(r"\bt ?= ?0(?: s)?(?!\w|\.\d)")
_OWN = re.compile(
    rf"\bits (?=(?:{any_of_pattern('|'.join(QUANTITIES.values()).split('|'))}|[xy][- ]coordinate"
    r"|(?:final|initial)(?! (?:position|point|place|height|level)))\b)"
)
_HIT_IT = re.compile(
    r"(@\d+@ (?:has |have )?(?:hits?|struck|strikes?|meets?|met|touche[sd]|collide[sd]? with"
    r"|(?:is |lies |passes |swings |moves )?(?:directly |vertically |straight |exactly )*(?:below|beneath|under"
    r"|underneath)"
    r"|[^@,.]*(?:relative to|with respect to|along))) it\b"
)
_UNDER_AXLE = re.compile(
    r"(?P<before>\b(?:axle|pivot|hinge)\b.* (?:is|hangs|lies|passes|swings) (?:\w+ly |straight |exactly )*(?:below"
    r"|beneath|under|underneath) )it\b"
)
_VERBS = re.compile(rf"(?:{'|'.join(sorted(verb_forms() | {'first'}))})\b")  # *A stops*: A is no article
_CENTERS = re.compile(
    r"\b(?:centres|centers) (?:of mass )?of (?=@)|(?<=\d@)(?:'s?|’) (?:centres|centers)(?: of mass)?\b"
)
_RELATIVE_TO = re.compile(r"\bits (?=(?:speed|velocity|acceleration)(?: relative to| with respect to) @(\d)@)")
_PARTICIPLES = re.compile(
    r"\b(?:bored|hollow|swinging|hanging|falling|sliding|rolling|moving|oscillating|thrown|flying|compressed|stretched"
    r"|launched|orbiting|turning|stationary) (?=@\d+@)"
)
_HALF = re.compile(r"\b(first|a) half (second|metre|meter|minute|year)\b")
_WHOLES = {"one": 1, "a": 1, "two": 2, "three": 3, "four": 4, "five": 5}
_AND_HALF = re.compile(
    rf"\b(?P<n>{'|'.join(_WHOLES)})(?: (?P<u>second|metre|meter|year))? and a half(?: (?P<v>seconds|metres|meters"
    rf"|years))?\b"
)
_CENTER_ALONE = re.compile(r"\b(?:its )?(?:centre|center)(?: of mass| of gravity)?\b(?! of)")
_WHOLE = "(?:system|assembly|arrangement|set-?up|whole (?:thing|arm)|swinging (?:body|part|thing))"
_ARTICLES = re.compile(r"\b(?:the|an|a)\b ?")


@dataclass(frozen=True, slots=True)
class TokenizedSentence:
    """A tokenized sentence, with the phrases and numbers that its tokens represent."""

    text: str
    subjects: tuple[str, ...]
    numbers: tuple[str, ...]

    def subject(self, token: str | None) -> str:
        """Return the text's phrase for the subject of a token; empty without a token."""
        return self.subjects[int(token.strip("@"))] if token else ""

    def number(self, token: str) -> str:
        """Return the number, with its unit, that a token represents."""
        return self.numbers[int(token.strip("#"))]


def tokenize(sentence: str, words: Words) -> TokenizedSentence:
    """Return a sentence with tokens for the scene's subjects and for numbers; pronouns become the first subject."""
    if len(sentence) > MAX_QUESTION_LENGTH:
        return TokenizedSentence("", (), ())
    sentence = _HALF.sub(r"\1 0.5 \2", _AND_HALF.sub(_and_half, sentence))
    text = plainly(sentence, words.units).replace("\N{NO-BREAK SPACE}", " ").strip().rstrip("?.!").replace("? ", ". ")
    subjects: list[str] = []

    def token(phrase: str) -> str:
        if phrase not in subjects:
            subjects.append(phrase)
        return f"@{subjects.index(phrase)}@"

    text = with_letters(_with_pulleys(with_particles(_ADJECTIVES.sub("", text), words), words), words)
    text = _OWN_ADJECTIVES.sub("", text)
    for phrase, called in _patterns(words):
        text = called.sub(lambda _, phrase=phrase: token(phrase), text)
    text = _CENTERS.sub("", text)
    text, numbers = _with_numbers(_START.sub("start", text))
    text = _ordered(text, subjects)
    text = _INDIRECT.sub("", text)
    text = _UNDER_AXLE.sub(r"\g<before>axle", text)
    if len(subjects) == 2:  # *after B has hit it*: the other
        text = _HIT_IT.sub(lambda match: f"{match[1]} @{1 - int(match[1][1])}@", text)
    text = _ARTICLES.sub("", re.sub(r"(@\d+@)'(?= )", r"\1's", text.lower()).replace("'s", " 's").replace(",", " , "))
    text = _PARTICIPLES.sub("", text)
    joint = {number for number, name in enumerate(subjects) if name == EVERYTHING or name.startswith(f"{ALL_WORD} ")}
    text = _CENTER_OF_ONE.sub(lambda center: center[0] if int(center[1]) in joint else f"@{center[1]}@", text)
    text = text if joint else _CENTER.sub(r"\1", text)
    if len(subjects) == 2:
        text = _RELATIVE_TO.sub(lambda match: f"@{1 - int(match[1])}@ 's ", text)
    if not subjects and len(alone := _movers(words)) == 1:
        text, subjects = _replace_pronouns_of_only_body(text, words), alone
    if words.released:
        text = _FROM_REST.sub(" ", _RELEASED.sub("", text))
    text = " ".join(re.sub(r"^which (?=[a-z]+ )", "what ", text).split())
    smooth = all(face.friction == 0.0 for face in words.mechanism.faces)
    text = without_leads(" ".join(_without_pronouns(text, subjects).split()), numbers, smooth=smooth)
    text = without_asides(text)
    return TokenizedSentence(reword_question(text), tuple(subjects), numbers)


def _and_half(match: re.Match[str]) -> str:
    """Return *one and a half seconds* in digits; unchanged without a unit."""
    unit = match["v"] or match["u"]
    return f"{_WHOLES[match['n']]}.5 {unit}" if unit else match[0]


def _with_numbers(text: str) -> tuple[str, tuple[str, ...]]:
    for spelling, unit in _UNITS.items():
        text = re.sub(rf"(?<=[\d ]){spelling}\b", unit, text)
    numbers: list[str] = []

    def told(found: re.Match[str]) -> str:
        value, unit = found[1], (found[2] or "").strip()
        after = ""
        if unit and not _UNIT.fullmatch(unit):
            after, unit = found[2] or "", ""
        numbers.append(f"{value} {unit}".strip())
        return f"#{len(numbers) - 1}#{after}"

    return _NUMBER.sub(told, text), tuple(numbers)


def _ordered(text: str, subjects: list[str]) -> str:
    """Return the text with its subjects renumbered in order of appearance, and reorder `subjects` in place."""
    order = list(dict.fromkeys(re.findall(r"@(\d+)@", text)))
    text = re.sub(r"@(\d+)@", lambda match: f"@{order.index(match[1])}@", text)
    subjects[:] = [subjects[int(number)] for number in order]
    return text


def _without_pronouns(text: str, subjects: list[str]) -> str:
    """Return the text with the first subject's token for each pronoun, except in *it takes* or after two subjects."""
    before = re.split(r" its? ", text, maxsplit=1)[0]
    if len(subjects) != 1 and before.count("@") != len("@@"):
        return text
    head, named, tail = text.partition("@0@")
    tail = re.sub(r"\b(?:they|them)\b" if subjects[0].startswith(f"{ALL_WORD} ") else r"\bit\b(?! takes?)", "@0@", tail)
    tail = _OWN.sub("@0@ 's ", tail)
    return head + named + tail


def _patterns(words: Words) -> Iterable[tuple[str, re.Pattern[str]]]:
    """Return each phrase of the text with a pattern for its names in a question, the most specific pattern first."""
    phrases = _phrases(words)
    nouns = {phrase: phrase.removeprefix("the ").split() for phrase in phrases}
    ranked: list[tuple[int, str, str]] = [*named_lines(words), *swinging_lines(words)]
    kinds = [wording[0].lower() for wording in nouns.values() if len(wording) == 2]
    lone = frozenset(kind for kind in kinds if kinds.count(kind) == 1)
    for phrase, wording in nouns.items():
        noun, letter = wording[0].lower(), wording[1] if len(wording) == 2 and len(wording[1]) == 1 else ""
        ranked += between(phrase, lone)
        if not letter:
            others: set[str] = _others(noun, phrase, nouns) if len(wording) == 1 else set()
            names = {phrase.removeprefix("the ")} | others
            ranked += [
                (len(name), phrase, rf"\b(?:(?:[Tt]he) )?{_ignoring_case(name)}\b(?! [A-Z]\b)") for name in names
            ]
            continue
        alike = {noun} | group(noun) | GENERIC_NOUNS | {"mass"}
        names = "|".join(_ignoring_case(name) for name in sorted(alike))
        ranked.append((1000, phrase, rf"\b(?:[Tt]he )?(?:{names})(?:e?s)? {letter}\b(?!\.\d)"))
        ranked.append((1, phrase, rf"(?<=[a-z] ){letter}\b(?! [a-z]*direction|\.\d)"))
        ranked.append((1, phrase, rf"(?:(?<=^)|(?<=, )|(?<=\. )){letter}\b(?= {_VERBS.pattern}|['’]s )"))
        heads = {other: [named[0].lower()] for other, named in nouns.items() if other != phrase}
        unique = [noun] not in heads.values()
        alone = _others(noun, phrase, heads) - GENERIC_NOUNS if unique else set[str]()
        ranked += [(len(name), phrase, rf"\b(?:[Tt]he )?{_ignoring_case(name)}\b(?! [A-Z]\b)") for name in alone]
    ranked.append((2, EVERYTHING, rf"(?<=\bof )(?:the )?(?:(?:whole|entire|complete) )?{_WHOLE}\b"))
    ranked.append((2, EVERYTHING, rf"\b(?:[Tt]he )?(?:(?:whole|entire|complete) )?{_WHOLE}(?='s\b| have\b| possess\b)"))
    for wording, plural in _plurals(nouns, words):
        ranked.append(
            (
                2,
                wording,
                rf"\b(?:(?:[Bb]oth|[Aa]ll) of the |[Tt]he |[Bb]oth |[Aa]ll )*(?:two |three )?{plural}\b(?! [A-Z]\b)",
            )
        )
        each = rf"\b(?:[Ee]ach|[Ee]ither|[Ee]very|[Ee]ach one)(?: of the(?: two| three)?)? {plural}\b(?! [A-Z]\b)"
        ranked.append((3, wording, each.replace("e?s)", "(?:e?s)?)").replace("e?s|", "(?:e?s)?|")))
    return [(phrase, _compiled(pattern)) for _, phrase, pattern in sorted(ranked, reverse=True)]


@lru_cache(maxsize=2048)  # several questions about each of many scenes; the cache of `re` holds 512
def _compiled(pattern: str) -> re.Pattern[str]:
    return re.compile(pattern)


def _with_pulleys(text: str, words: Words) -> str:
    """Return a text with the scene's phrase in place of *the pulley*, *movable pulley* or *fixed pulley*, if unique."""
    mechanism, kinds = words.mechanism, dict[str, list[str]]()
    for address, mention in words.mentions.items():
        sites = [site for site in mechanism.site.values() if site.name.rpartition(".")[0] == address]
        if "pulley" in mention and sites:
            bodies = [body for site in sites if site.body is not None for body in ancestor_chain(mechanism, site.body)]
            moves = any(coordinate.kind == "slide" for body in bodies for coordinate in body.coordinates)
            kinds.setdefault("mov(?:able|ing)" if moves else "fixed", []).append(mention)
    if len(only := [mention for mention in words.mentions.values() if "pulley" in mention]) == 1:
        text = re.sub(r"\b[Tt]he pulley\b(?! [A-Z]\b)", only[0], text)
    for kind, pulleys in kinds.items():
        if len(pulleys) == 1 and len(kinds) > 1:
            text = re.sub(rf"\b(?:the )?{kind} pulley\b(?! [A-Z]\b)", pulleys[0], text)
    return text


def _movers(words: Words) -> list[str]:
    return list(words.subject_phrases(Bodies()).values())


def _replace_pronouns_of_only_body(text: str, words: Words) -> str:
    """Return a text with the token of the only body in place of *it*, *its* and, if the body rolls, *the centre*."""
    if all(name in words.mechanism.contacts and can_roll(words, name) for name in words.subject_phrases(Bodies())):
        text = _CENTER_ALONE.sub("@0@", text)
    return re.sub(r"\bits (?=[a-z])", "@0@ 's ", re.sub(r"\bit (?!takes?\b)", "@0@ ", text))


def _phrases(words: Words) -> list[str]:
    """Return the text's phrases for the subjects of quantities and for all bodies except surfaces."""
    kinds = {quantity.of.name: quantity.of for quantity in REGISTERED.values()}
    kinds = {name: kind for name, kind in kinds.items() if name not in ("pair", "whole")}
    called = [phrase for kind in kinds.values() for phrase in words.subject_phrases(kind).values()]
    surfaces = set(WORDS["SURFACE"].split()) | {"start"}
    bodies = [mention for mention in words.mentions.values() if mention.split()[-1] not in surfaces]
    return list(dict.fromkeys([*called, *bodies]))


def _others(noun: str, phrase: str, nouns: Mapping[str, list[str]]) -> set[str]:
    """Return the nouns that can mean only a given phrase in a scene, the phrase's own noun included."""
    taken = {
        wording[-1].lower() if len(wording) == 1 else wording[0].lower()
        for other, wording in nouns.items()
        if other != phrase
    }
    groups = [nouns for nouns in NOUNS if noun in nouns]
    other = {name for nouns in groups for name in nouns if not any({name, t} <= g for t in taken for g in NOUNS)}
    return (other - taken) | {noun} | (set(GENERIC_NOUNS) if len(nouns) == 1 else set())


def _plurals(nouns: Mapping[str, list[str]], words: Words) -> Iterable[tuple[str, str]]:
    """Yield a joint phrase for all subjects that share a noun and differ by letter, with a pattern for the plural."""
    alike: dict[str, list[str]] = {}
    if len(movers := _movers(words)) > 1:
        yield f"{ALL_WORD} {' & '.join(movers)}", "(?:bodies|objects)"
    heavy = [
        wording for name, wording in words.subject_phrases(Bodies()).items() if words.mechanism.body[name].mass > 0.0
    ]
    if len(heavy) == 2:
        yield f"{ALL_WORD} {' & '.join(heavy)}", r"(?<=[Tt]he )two(?! (?:\w+ )?[a-z]+s\b)"
    for phrase, wording in nouns.items():
        if len(wording) == 2:
            alike.setdefault(wording[0].lower(), []).append(phrase)
    for noun, phrases in alike.items():
        if len(phrases) > 1:
            names = {noun} | group(noun)
            plural = "|".join(f"{name}e?s" for name in sorted(names))
            yield f"{ALL_WORD} {' & '.join(phrases)}", f"(?:{plural})"


def _ignoring_case(name: str) -> str:
    return f"[{name[0].upper()}{name[0].lower()}]{re.escape(name[1:])}"
