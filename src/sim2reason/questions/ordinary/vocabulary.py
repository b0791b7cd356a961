"""Vocabulary of the reader: tables of common words and phrases of ordinary English.

Patterns match whole questions in lower-case text without articles, with tokens for subjects (``@0@``) and for numbers
with their unit (``#0#``). A sentence with a word that no pattern has is not understood, so that no word that could
matter, above all a *not* or a *half*, is passed over.
"""

import re
from collections.abc import Iterable, Mapping
from functools import cache

NOUNS: tuple[frozenset[str], ...] = tuple(
    frozenset(group.split())
    for group in (
        "block box crate load parcel sled sledge weight",
        "ball bob sphere stone projectile marble shell rock",
        "cart trolley glider car truck wagon carriage slider",
        "board plank slab block",
        "probe rocket spacecraft spaceship craft capsule",
        "bead particle ion ball charge",
        "string rope cord cable thread",
        "puck disc disk",
        "planet moon comet asteroid satellite",
        "cylinder roller drum",
        "hoop ring",
        "pipe tube",
        "rod bar stick",
        "star sun",
    )
)
"""Nouns that may stand for one another where only one thing in a scene can be meant."""
GENERIC_NOUNS = frozenset({"body", "object"})

QUANTITIES: Mapping[str, str] = {
    "rotational kinetic energy": "rotational kinetic energy|kinetic energy of rotation|rotational energy|energy of"
    " rotation",
    "translational kinetic energy": "translational kinetic energy",
    "kinetic energy": "kinetic energy|total kinetic energy",
    "spring energy": "elastic energy|elastic potential energy|spring energy|energy stored|energy is stored",
    "angular velocity": "angular velocity|angular speed|rate of rotation",
    "angular acceleration": "angular acceleration",
    "friction force": "force of friction|friction force|frictional force|static friction|kinetic friction"
    "|static friction force|kinetic friction force|force of static friction|force of kinetic friction",
    "normal force": "normal force|normal reaction|normal reaction force|normal contact force|reaction force"
    "|supporting force|support force",
    "net force": "net force|resultant force|resultant|total force",
    "tension": "tension|tension force|string tension",
    "spring force": "spring force",
    "relative speed": "relative speed",
    "displacement": "displacement",
    "speed": "speed",
    "velocity": "velocity",
    "acceleration": "acceleration",
    "deceleration": "deceleration|retardation",
    "momentum": "momentum",
    "extension": "extension|elongation|stretch|deformation",
    "compression": "compression",
    "height": "height|altitude",
    "distance": "distance|separation",
    "force": "force|pull",
    "length": "length",
    "moment of inertia": "moment of inertia",
    "mass": "mass",
    "thrust": "thrust|thrust force|thrust of engine|thrust of its engine",
    "fuel left": "fuel left|remaining fuel|fuel remaining|mass of fuel left|mass of remaining fuel|mass of unburnt fuel"
    "|fuel is left|mass of fuel remaining",
    "fuel burnt": "fuel burnt|fuel burned|fuel used|fuel consumed|mass of fuel burnt|mass of burnt fuel|burnt fuel"
    "|mass of fuel burned|mass of fuel used|mass of fuel consumed|fuel used up|fuel is burnt|fuel is used",
    "radius of curvature": "radius of curvature|curvature radius|radius of curvature of path|radius of curvature of"
    " trajectory|radius of curvature of orbit",
    "radius of the path": "radius of circle|radius of circular path|radius of path|radius of orbit|radius of trajectory"
    "|radius of circular orbit|radius of circular motion|radius of motion|radius",
    "eccentricity": "eccentricity|orbital eccentricity",
    "semi-major axis": "semi-major axis|semimajor axis|semi major axis|length of semi-major axis|major semi-axis",
    "magnetic force": "magnetic force|lorentz force|magnetic lorentz force|force of magnetic field",
    "electric force": "electric force|electrostatic force|coulomb force|force of electric field|force of field",
    "resisting force": "resisting force|drag|drag force|resistive force|force of resistance|resistance of medium"
    "|force of medium|air resistance",
    "distance from the origin": "distance from origin|distance to origin",
    "x coordinate": "x coordinate|x-coordinate|x position|x-position|x value|x-value|value of x|abscissa",
    "y coordinate": "y coordinate|y-coordinate|y position|y-position|y value|y-value|value of y|ordinate",
    "gravitational force": "gravitational force|gravitational attraction|gravitational pull|force of gravitation",
}
"""Nouns of ordinary English for each quantity; `mains` says beside which words some of them mean it."""

MOTIONS: Mapping[str, str] = {
    "move": "move moves moved moving slide slides slid sliding travel travels travelled traveled travelling go goes "
    "gone going cover covers covered pulled dragged drawn hauled fly flies flown flying "
    "recoil recoils recoiled recoiling advance advances advanced",
    "roll": "roll rolls rolled rolling",
    "fall": "fall falls fallen falling drop drops dropped dropping descend descends descended descending "
    "sink sinks sunk sank sinking",
    "rise": "rise rises risen rising climb climbs climbed climbing ascend ascends ascended",
    "turn": "turn turns turned turning rotate rotates rotated rotating spin spins spun spinning swing swings swung "
    "swinging",
}
"""By a verb of motion, the forms of all that mean it."""
DOWN, UP, ROLL = "fall", "rise", "roll"  # the verbs that tell a way

SLOWER, STRETCHED, COMPRESSED, ORIGIN, ON = "slower", "stretched", "compressed", "from origin", "on "
FIXED_FACE = "the fixed surface"  # on which a body lies
ONCE, ONLY, OVER, RELAXED = "once", "only", "over", "relaxed"
CARRIED_AT_REST = "carried by what is at rest"
ABOVE_GROUND = "aloft"  # the body is above the ground
SMALL_OSCILLATIONS = "small"  # the oscillations are small, so that the period does not depend on the amplitude
ONLY_FORCE_PREFIX = "sole "  # before a type of force: this is the only force on the body
RISING, ROLLING, RESTS, LASTS, STRAIGHT, ONE_WAY = "rising", "rolling", "rests", "lasts", "straight", "one way"
SETS_OFF, UNMOVED, ACROSS, GAINED = "sets off", "unmoved", "across", "gained"
LEVEL, SMOOTH, FIELDS_ALONE, ONE_LINE, FALLS = "level", "smooth", "fields alone", "one line", "only falls"
HEADING = "heads "  # before an axis with a sign: the body moves along the axis in that direction
DIES_AWAY, FREE_AXLE, MUTUAL = "dies away", "free axle", "mutual"
LOWEST, STANDS, CENTRAL, LIES = "lowest at first", "stands", "central", "lies on a face"
THEN_GOES = "then goes "  # before a direction: the body moves in it after the moment
PASSES_EQUILIBRIUM = "balanced"  # passes through the equilibrium
ASKS_FOR_POSITION = "placed"  # the question is for a position, whatever the motion
CARRIED_BY_PREFIX = "borne by "  # by what carries it, or by the pulley over which its string runs
CENTERED, HELD = "centered", "held by "  # by a spring the other end of which is fixed
LIGHT, SIDEWAYS, LIFTS, GOES_UP, GOES_DOWN = "light", "sideways", "lifts", "goes up then", "goes down then"
LINE_WITH_FIXED_END = "the fixed end"  # the only line of which one end is fixed
BESIDE, FARTHEST = "beside ", "farthest beside "  # before a sign and an axis of coordinates
BELOW_CARRIER_PREFIX = "under "  # before the name of the body that carries the subject along a level line
DRAWN, SPRUNG = "drawn by a hand", "sprung"  # the only spring joins the only two bodies
ROUND = "round "  # goes round a named body
"""What is taken for granted beside ways, by a name: see `presumed`."""

WORDS: Mapping[str, str] = {
    "AUX": "is are was were be been being has have had having does do did will would to it still",
    "GREATEST": "greatest maximum maximal largest highest biggest peak",
    "LEAST": "least minimum minimal smallest lowest",
    "SURFACE": "plane slope incline ramp floor ground table track surface lane hill",
    "ORDINAL": "first second third fourth fifth sixth",
    "AGAIN": "again",
}
"""Words of which any one may stand."""

PHRASES: Mapping[str, str] = {
    "ASK": "which is|what is|what are|what was|what will be|find|determine|calculate|compute|work out|obtain|give"
    "|how large is|how big is|how great is|how strong is|how much is",
    "SIZE": "magnitude of|size of|value of",
    "TIME": "when|at what time|at what moment|at what instant|how long is it until|how long is it before"
    "|how long does it take|how long will it take|how long does it take until|how long does it take for"
    "|how long after start|how long after release|how long after launch|how much time passes until"
    "|after how many seconds|in how many seconds|how many seconds does it take|how many seconds pass until"
    "|how much time does it take|how long until|find how long it takes|determine how long it takes"
    "|ASK time|ASK time until|ASK time it takes|ASK time that it takes|ASK time needed|ASK time required"
    "|ASK time taken"
    "|how much time passes between START and|how much time elapses between START and"
    "|how much time elapses before|how much time elapses until|how much time passes before"
    "|how many seconds elapse before|how many seconds elapse until|how many seconds pass before"
    "|how soon|how long before|how much time goes by before|how much time goes by until|how many years pass before"
    "|how many years pass until|how many years does it take|after how many years|how much time will pass before"
    "|how much time will pass until|how much time does it take until|how much time does it take for"
    "|after what time|after how much time|after how long",
    "STOPS": "stop|stops|stopped|stopping|comes to rest|come to rest|coming to rest|comes to halt|come to halt"
    "|is at rest|at rest|momentarily at rest|stationary|standing still|stops moving|stop moving|halts"
    "|comes to stop|come to stop|turns round|turns back|turn back|turn round"
    "|turns around|reverses|reverses direction|changes direction|reverses its direction|reverses its motion"
    "|reverse direction|reverse its direction|turn around|momentarily stops|is momentarily at rest"
    "|is brought to rest",
    "LANDS": "lands|land|landing|hits SURFACE|hit SURFACE|strikes SURFACE|strike SURFACE|reaches SURFACE"
    "|reach SURFACE|hitting SURFACE|reaching SURFACE|striking SURFACE|touching SURFACE|touches SURFACE|impact with"
    " SURFACE"
    "|comes down|touches down|strikes it|falls to SURFACE|arrives at SURFACE|arrive at SURFACE"
    "|arriving at SURFACE|fall to SURFACE"
    "|drops to SURFACE|arrives at SURFACE|land on SURFACE|lands on SURFACE|come down|touch SURFACE",
    "BOUNCES": "bounce|bounces off wall|bounces|bounced|bouncing|rebounds|rebound",
    "BECOMES": "has fallen to|reaches|has dropped to|has risen to|becomes|falls to|drops to|rises to|has reached",
    "DONE": "do|does|did|done",
    "HITS": "hit|hits|strike|strikes|meets|runs into|collides with|collide with|catches up with|bumps into|reaches",
    "OSCILLATES": "oscillate|oscillates|vibrate|vibrates|swing|swings|move|repeat itself",
    "COMPLETES": "complete|need to complete|need to go|need for|make|take to go|take to complete|take for|take to make",
    "PASSES": "reach|reaches|reached|at|get to|gets to|passes through|passes|passing|pass through|pass|goes through"
    "|go through|MOTION to|MOTION down to|MOTION through|swings through|swing through|arrives at"
    "|moves through|passing through|is at",
    "ROUND": "revolution|turn|oscillation|swing|round|orbit|circle|cycle|vibration",
    "COLLIDE": "collide|touch|touch each other|come into contact|make contact|collides|collided|meet"
    "|hit each other|collision|impact"
    "|collision with each other|crash|crashes|bump into each other",
    "NEAREST": "closest point|nearest point|perihelion|periapsis|pericentre|perigee|closest approach"
    "|point of closest approach|least distance",
    "FARTHEST": "farthest point|furthest point|aphelion|apoapsis|apocentre|apogee|greatest distance",
    "TOP": "highest point|top|peak|apex|maximum height|greatest height|highest position",
    "BOTTOM": "lowest point|bottom|lowest position",
    "PATH": "path|flight|rise|climb|circle|swing|trajectory|motion|arc|orbit|circular path",
    "BURNOUT": "fuel is used up|all fuel is burnt|all fuel is burned|all fuel is used up|all fuel is consumed"
    "|all fuel is spent"
    "|fuel is consumed|all fuel has burnt|end of burn|burn ends|fuel burns out|fuel is burned|fuel runs out"
    "|fuel is spent|fuel is exhausted|its fuel is used up|burnout|burn-out"
    "|fuel is burnt|fuel is gone|fuel run out|engine stops|engine cut out|engine stop|engine shut off"
    "|engine burn out|engine is switched off|engine cuts out|engine shuts off|engine burns out",
    "RUNS_OUT": "runs out of fuel|burns out|has burnt all its fuel|has used up its fuel|has used up all its fuel",
    "ROLLS": "begins to roll without slipping|starts to roll without slipping|begins rolling without slipping"
    "|rolls without slipping|starts rolling without slipping|stops slipping|stops skidding|stops sliding"
    "|begin to roll without slipping|stop slipping|stop sliding|stop skidding"
    "|starts to roll purely|starts pure rolling|begins to roll purely",
    "SLIPS": "slipping|sliding|skidding|slips|slides|skids|is slipping|is sliding|is skidding|slide|slip|skid",
    "NATURAL": "has its natural length|is at its natural length|reaches its natural length|at its natural length"
    "|reach its natural length|is relaxed|is unstretched|has its unstretched length|returns to its natural length"
    "|return to its natural length|regains its natural length|regain its natural length",
    "FIRST_TIME": "for first time|first time",
    "START": "start|blow|kick|throw|outset|instant of release|moment of release|instant of launch|moment of launch"
    "|release"
    "|launch|beginning|lift-off|liftoff|takeoff|BODY is released|BODY is let go|BODY is thrown"
    "|BODY is launched|thrown|launched|struck|released|let go|kicked|BODY is struck|BODY is kicked|BODY starts"
    "|BODY begins to move"
    "|engine starts|engine started|engine has started|engine is started|engine ignites|engine is switched on|ignition"
    "|motion begins|motion starts|BODY is set down|BODY is put down|BODY is set free|BODY is set moving|BODY is set"
    " going|BODY is set in motion"
    "|BODY is laid down|BODY is pushed off|BODY is fired|engine is lit|engine is ignited|engine is turned on"
    "|system is released|everything is set free|everything is released|everything is let go|system is let go",
    "BODY": r"it|@\d+@",
    "ALONG_IT": "along SURFACE|along straight line",
    "PERIOD": "period|orbital period|period of revolution|period of rotation|period of oscillation"
    "|oscillation period|time of one revolution",
    "ITS_MOTION": "oscillation|oscillations|small oscillations|swing|swings|orbit|vibration|vibrations|motion"
    "|revolution"
    "|circular motion|circular orbit|periodic motion|oscillatory motion|pendulum|resulting oscillation"
    "|resulting motion|orbital motion|simple harmonic motion|rotation",
    "HAVE": "have|has|reach|reached|attain|attained|acquire|acquired|possess|get",
    "IN_ALL": "in all|in total|altogether|overall",
    "STRAINED": "stretched|compressed|extended",
    "ATTAINS": "reaches|reach|attains|attain|gets|get|has|have|achieves|acquires|achieve|acquire",
    "PRESSES": "press|presses|push|pushes|press down|pushes up|bear down",
    "BASE": "point directly below|point below|point vertically below|foot of|base of|bottom of",
    "HOME": "origin|its starting point|its starting position|start|its point of release|its initial position"
    "|its original position|where it started|where it starts|point where it started|point at which it started",
    "HEAT": "heat|energy|kinetic energy|mechanical energy|thermal energy",
    "LOST": "lost|dissipated|generated|produced|lost to friction|dissipated by friction|generated by friction"
    "|produced by friction|turned into heat|converted into heat|lost due to friction|lost through friction",
}
"""Phrases of which any one may stand; words in capitals are those of the other tables."""

GROUNDS = (
    "(?:(?:inclined|sloping|smooth|rough|level|horizontal|fixed|straight|tilted|stationary|flat) )*"
    "(?:plane|slope|incline|ramp|floor|ground|table|tabletop|track|surface|lane|hill|rail)"
)
"""A pattern for the surface on which bodies move, with the adjectives that a text has for it."""

DIRECTION_WORDS: Mapping[str, str] = {
    "up": "up|uphill|upwards|upward|up SURFACE|vertically upwards",
    "down": "down|downhill|downwards|downward|down SURFACE|vertically downwards",
    "right": "to right",
    "left": "to left",
    "horizontal": "horizontal|horizontally|in horizontal direction",
    "vertical": "vertically|in vertical direction",
    "x": "in x direction|in positive x direction|along x axis|in x-direction|along x direction|along x-direction"
    "|parallel to x axis|in direction of x axis",
    "y": "in y direction|in positive y direction|along y axis|in y-direction|along y direction|along y-direction"
    "|parallel to y axis|in direction of y axis",
}
"""By a way, or an axis, how people tell it."""


def any_of_pattern(phrases: Iterable[str]) -> str:
    """Return a regular expression group that matches any of the phrases, longest first, with table names expanded."""
    longest = sorted(dict.fromkeys(phrases), key=len, reverse=True)
    return f"(?:{'|'.join(re.sub('[A-Z]{2,}', lambda match: _macro(match[0]), phrase) for phrase in longest)})"


def matching_entry(tables: Mapping[str, str], phrase: str, parted: str = "|") -> str:
    """Return the name of the table entry that a phrase matches; empty if no entry matches."""
    return next((name for name, row in tables.items() if re.fullmatch(any_of_pattern(row.split(parted)), phrase)), "")


@cache
def _macro(name: str) -> str:
    if name == "MOTION":
        return any_of_pattern(" ".join(MOTIONS.values()).split())
    if name == "QUANTITY":
        return any_of_pattern("|".join(QUANTITIES.values()).split("|"))
    if name == "HORIZONTAL":
        return "horizontal"
    if name == "WAY":
        return any_of_pattern("|".join(DIRECTION_WORDS.values()).split("|"))
    return any_of_pattern(WORDS[name].split()) if name in WORDS else any_of_pattern(PHRASES[name].split("|"))


@cache
def pattern(told: str) -> re.Pattern[str]:
    """Return the compiled regular expression of a template in which names in capitals stand for a table's words.

    ``{s}`` and ``{t}`` are subjects, ``{n}`` is a number with its unit; ``{way=WAY}`` is a named group of a table.
    Text in square brackets is optional, and ``~`` stands for any auxiliaries.
    """
    told = told.replace("{s}", r"(?P<s>@\d+@)").replace("{t}", r"(?P<t>@\d+@)").replace("{n}", r"(?P<n>#\d+#)")
    told = re.sub(r"\{([a-z]+)=([A-Z_]+)\}", lambda match: f"(?P<{match[1]}>{_macro(match[2])})", told)
    told = re.sub(r"(?<![<\\])\b[A-Z_]{2,}\b", lambda match: _macro(match[0]), told)
    told = told.replace("[", "(?:").replace("]", ")?").replace("~", f"(?:{_macro('AUX')} )*")
    return re.compile(told)


@cache
def compiled(told: str) -> re.Pattern[str]:
    """Return a compiled regular expression, cached without the size limit of `re`."""
    return re.compile(told)
