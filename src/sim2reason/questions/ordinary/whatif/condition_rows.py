"""Patterns of conditions in ordinary English, such as *not slip*, each with the outcome that it means."""

from collections.abc import Mapping

from sim2reason.questions.ordinary.vocabulary import GROUNDS

RESTS, HOLDS, STAYS, SLIPS, RISES, SINKS, ROUND = "rests", "holds", "stays", "slips", "rises", "does not rise", "round"
TAUT, SLACK, ESCAPES, BOUND, CIRCULAR, LIFTS = "taut", "slack", "escapes", "bound", "circular", "lifts off"
CLIMBS, DESCENDS, SLIDES = "climbs steadily", "descends steadily", "does not slide down"
GRIPS, HALTED, TILTED, TIPS, SPINS = "grips", "halted", "keeps its angle", "tips over", "stays while it slips"
"""Outcomes: *holds* means that nothing slips, *stays* that a body stays at rest where it first stops.

*grips* means that a rolling body that slips at first stops slipping, *halted* that a collision leaves a body at rest.
"""
_S = r"@\d+@"
_ROUND = "(?:turn|circle|revolution|loop|round|rotation)"
_ON = rf"(?: (?:on|along|over) (?:(?:this |its )?(?:{GROUNDS})|{_S}|top of {_S}))?"
_AT_REST = "(?:at rest|in equilibrium|in balance|motionless|stationary|balance[d]?|put|still|where (?:it|they|{S}))"
_SLIPPING = "(?:slip|skid)(?:ping)?"
PHRASES: Mapping[str, str] = {
    r"(?:be )?halt by collision": HALTED,
    rf"(?:be )?(?:at some time |ever |at last |finally |in end |eventually )*(?:stop|cease|end) {_SLIPPING}"
    rf"(?: (?:ever|at some time|some time|sooner or later|in end|eventually))?"
    rf"|(?:begin|start|come) to roll (?:purely|without {_SLIPPING})(?: (?:ever|at some time|in end|eventually))?"
    rf"|(?:in end|finally|eventually|at last|at some time|sooner or later) roll without {_SLIPPING}": GRIPS,
    r"keep (?:its|same|constant|initial) ?(?:initial )?(?:inclination|angle|direction|tilt|slope|slant)"
    r"(?: of #\d+#)?(?: (?:to|with) (?:downward )?vertical)?(?: (?:all time|throughout|always|constantly))?": TILTED,
    rf"(?:tip|topple|fall|tumble|turn|roll|get|go|rock) over (?:its )?(?:lower |next |front )?(?:edge)?"
    rf"|(?:tip|topple|tumble)(?: over)?"
    rf"|not (?:fall|tip|rock|drop|tumble|sink) back(?: (?:on|onto|to) (?:its |same |original |first )?face"
    rf"(?: (?:it|{_S}) (?:lie|lay|lay on|lie on|stand on|start on)(?: on)?)?)?": TIPS,
    rf"(?:stay|remain|be|keep) (?:at rest|where (?:it|{_S})(?: be)?|in place|still)"
    rf" (?:as long as|while|until|so long as) (?:it|{_S}) (?:be )?(?:still )?(?:stop )?{_SLIPPING}": SPINS,
    rf"not (?:slide|slip|move|go|be pulled|sink|creep) down(?: (?:{GROUNDS}))?": SLIDES,
    rf"(?:move|go|rise|climb|slide) (?:up|upwards|uphill)(?: (?:{GROUNDS}))? (?:at|with) constant (?:speed"
    rf"|velocity)": CLIMBS,
    rf"(?:move|go|sink|descend|slide) (?:down|downwards|downhill)(?: (?:{GROUNDS}))? (?:at|with) constant"
    r" (?:speed|velocity)": DESCENDS,
    r"(?:stay|remain|keep|rest|lie|hold|stop)(?: at rest)? (?:for good )?(?:at|on|in) (?:its )?(?:highest point"
    r"|top|turning point|upper turning point|highest position)"
    r"|(?:stay|remain)(?: at rest)? (?:there|where it stop|after it stop)(?: for good)?|not (?:slide|slip|move"
    r"|come) (?:back|down)(?: again)?(?: (?:down|after it stop))?": STAYS,
    rf"(?:not|without) (?:begin |start )?(?:to )?(?:pull|move|slide|go|climb|rise|lift|haul|drag|draw)(?: {_S})?"
    rf" (?:up|upwards|uphill)(?: (?:{GROUNDS}))?": SINKS,
    rf"(?:not (?:begin |start )?(?:to )?(?:slip|slide|skid)|without (?:slip|slide|skid)(?:ping)?|(?:no|never)"
    rf" (?:slip|slide|skid)(?:ping)?)"
    rf"{_ON}|roll(?: purely| without (?:slip|slide|skid)(?:ping)?){_ON}|roll rather than slide|move together"
    rf"|stick together": HOLDS,
    rf"(?:(?:remain|stay|keep|hold|leave|be|lie|sit|hang) )?{_AT_REST}{_ON}|(?:not (?:begin |start )?(?:to )?"
    rf"|nothing (?:will |would )?)(?:move|accelerate|happen){_ON}|remain where"
    rf"|(?:hold|keep|stay|remain|leave)(?: {_S})? (?:where|in place)(?: (?:it|they|{_S}))?"
    rf"|balance(?: {_S})?|(?:move|go|rise|fall|descend|climb|slide)(?: (?:up|down)(?: (?:{GROUNDS}))?)? (?:at"
    rf"|with) constant (?:speed|velocity)"
    r"|not accelerate|no acceleration|without acceleration": RESTS,
    rf"(?:(?:begin|start|be able) (?:to )?)?(?:move|slide|go|climb|rise|lift|haul|drag|pull) (?:up|upwards"
    rf"|uphill)(?: (?:{GROUNDS}))?"
    r"|(?:begin|start) (?:to )?(?:rise|climb|ascend|lift)": RISES,
    rf"(?:begin|start) (?:to )?(?:slip|slide|move|skid){_ON}|set in motion|(?:slip|move|slide|budge){_ON}": SLIPS,
    rf"(?:(?:go|swing|turn|move|get|carry|travel|come|take|make|complete|perform|describe|execute|rotate|loop) )*"
    rf"(?:(?:over|past|through|reach|beyond|to|at least) (?:top|highest point|vertical)(?: of (?:circle|path|its"
    rf" path))?"
    rf"|(?:all way |right )?(?:round |around )?(?:in |through )?(?:(?:full|complete|whole|one|vertical) )+{_ROUND}"
    r"|(?:all way|right) (?:round|around)(?: (?:in |along )?"
    r"(?:(?:full|complete|vertical|whole) )*circle)?|loop (?:loop|round)|full circle)": ROUND,
    r"(?:stay|remain|keep|be) (?:always )?taut|not (?:go|become|get) slack|never (?:go|become|get) slack": TAUT,
    r"(?:go|become|get) slack": SLACK,
    rf"(?:escape|break free|get away|leave|fly away|break away|depart)(?: from(?: (?:{_S}|its gravity|gravity))?|"
    rf" {_S})?(?: for ever| forever| for good| altogether| to infinity| completely| entirely| and never (?:come"
    rf" back|return))?"
    r"|never (?:return|come back)|get infinitely far(?: away)?|reach infinity|unbound|not (?:return|come back)"
    r"|not bound|move (?:along|on|in) parabola"
    r"|(?:parabolic|open) (?:orbit|path)": ESCAPES,
    rf"(?:remain|stay|be|keep)? ?bound(?: to {_S})?|not escape(?: from {_S})?": BOUND,
    rf"(?:move|go|travel|orbit|revolve|be)?(?: {_S})? ?(?:round|around|about)? ?(?:{_S})? ?(?:in|on|along)?"
    rf" ?(?:its )?circular (?:orbit|path)"
    rf"|orbit be circular|describe circle(?: (?:about|around|round) {_S})?"
    rf"|(?:move|go|orbit|travel)(?: (?:round|around|about))?(?: {_S})? (?:in|on|along)"
    rf" circle(?: (?:about|around|round) {_S})?": CIRCULAR,
    rf"(?:lift off|take off|rise|leave (?:{GROUNDS})|lift|start (?:to )?rise|leave)(?: (?:from )?(?:{GROUNDS}"
    rf"|pad))?(?: (?:straight away|at once|immediately|right away"
    r"|as soon as engine (?:start|ignite)|when engine (?:start|ignite)|without delay|on ignition|at ignition))?": LIFTS,
}
"""Outcomes, by the pattern of a condition in base forms."""
