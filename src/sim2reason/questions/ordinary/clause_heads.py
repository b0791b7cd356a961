"""Heads of clauses that name a moment, in base forms, each with an equivalent plain clause."""

from collections.abc import Mapping

N, S = r"#\d+#", r"@\d+@"
_MOST = "(?:most|maximum|maximal|maximally|greatest|largest|biggest|highest|fully|completely|strongest|longest|peak)"
_MOVE = (
    "(?:move|slide|travel|go|cover|fly|recoil|advance|get|come|pull|drag|traverse|push|complete|pass|be"
    "|carry|shift|run|progress|proceed|displace|haul|draw|drift)"
)
FALL, RISE = (
    "(?:fall|drop|descend|sink|lower|lose height(?: of)?)",
    "(?:rise|climb|ascend|lift|raise|gain height(?: of)?)",
)
_ROLL, _TURN = "roll", "(?:turn|rotate|spin|swing|revolve)"
_DISTANCE = rf"(?:(?:by|through|over|(?:total |whole )?distance of|path of|total of) )?(?P<n>{N})"
_DROP = "(?:(?:by|through|down|up|over) )*vertical (?:distance|height|drop|depth) (?:of )?"
_HOME = (
    "(?:its )?(?:own )?(?:original |initial |first )?(?:origin|start(?:ing)?(?: point| position| place| location)?"
    "|(?:release|launch|throw|throwing|launching|starting|kick|projection) (?:point|position)|(?:point|place|position"
    "|location) of"
    " (?:release|launch|departure|projection|throw|start)|point (?:directly |vertically )?below (?:throw|launch"
    "|thrower|launch point"
    "|release)|foot of (?:cliff|tower)"
    "|(?:original|initial) (?:point|position|place|location)"
    "|(?:place|point|position|spot) (?:it|@\\d+@) (?:first )?(?:start|begin|set off|leave|throw)(?: from)?"
    "|where (?:it|@\\d+@) (?:begin|at (?:very )?start|originally|initially)"
    "|(?:(?:place|point|position|location|spot) )?(?:on SURFACE )?"
    "(?:where|from (?:where|which)|at which) (?:it|@\\d+@) (?:first )?(?:start|release|launch|begin|set off"
    "|leave|throw|let go|drop|set free|set out|set down|put down|strike|kick|push off|project|free))"
    "(?: from)?(?: position)?"
)
HOME = rf"(?:{_HOME})"
START_WORDS = (
    "(?:start(?! point| position| place| location)|release(?! point)|launch(?! point)|blow|kick|beginning"
    "|lift-off|liftoff|takeoff|take-off|let go|ignition|throw|setting off"
    "|set off|outset|motion (?:begin|start)|engine (?:start|ignite|switch on)|set (?:in motion|move|going|go|free)"
    "|set (?:down|on its way|loose)|put down|lay down|push off|kick off|turn loose"
    "|engine (?:light|turn on|fire|fire up|come on|start up)|leave (?:origin|HOME)|throw off|project|projection"
    "|departure|leave (?:thrower 's )?hand|free)"
)
_GROWS = "(?:grow|shrink|climb|sink|go up|go down|come down|slow down|build up|diminish|mount|decline) to"
_SAME = "(?:same|common|equal|one)(?: (?:speed|velocity))"

CLAUSE_HEADS: Mapping[str, str] = {
    # rest
    "(?:(?:come|bring|get|return|slow(?: down)?) (?:to )?)?(?:a )?(?:complete |full |dead |total |momentary |temporary "
    "|instantaneous )?(?:rest|halt|stop|standstill)": "{s} stops",
    "(?:cease|stop|finish|end) (?:its )?(?:move|slide|roll|rise|climb|fall|ascend|descend|motion|ascent|descent|go|fly)"
    "(?: up| down)?": "{s} stops",
    "(?:turn|swing|go|move|slide|roll|fall|start|head)(?: (?:move|slide|roll|go|fall|swing|come))? "
    "(?:back|round|around)(?: down)?": "{s} stops",
    "turn(?:ing)? point|point of return|reverse(?: its)?(?: direction| motion| way| course| sense)*(?: of motion| of"
    " travel)?"
    "|change (?:its )?(?:direction|sense)(?: of motion| of travel)?|stationary|stand still|motionless"
    "|lose all (?:of )?(?:its )?(?:speed|velocity|motion)|(?:speed|velocity) (?:become |drop to |fall to |reach |vanish"
    "|equal to )?zero|have no (?:speed|velocity)": "{s} stops",
    "(?:motion|movement) (?:stop|cease|end|is over|over|come to end)|(?:stay|remain) (?:at rest|still|where it)"
    "|(?:stay|remain) put|(?:end|wind) up": "{s} finally stops",
    # impacts
    "(?:hit|strike|reach|touch|meet|impact|contact|land|return|fall|come|drop|arrive|get|crash|encounter|smash"
    "|bump|run|slam)"
    "(?: back)?(?: down)?(?: to| on| onto| with| at| into| against| upon)? GROUNDS(?: again)?"
    "|(?:land|touch down|touchdown|impact|come (?:back )?down)(?: GROUNDS)?": "{s} lands{count}",
    "(?:bounce|rebound|impact|hop|landing|hit|strike|touch|collision)"
    "(?: (?:off|from|against|on|with|at|into)?(?: GROUNDS| (?:fixed )?wall))?"
    "|(?:run|bump|crash|smash|slam|collide|meet|reach|get to)(?: (?:into|with|against|to))? (?:fixed"
    " )?wall": "{s} bounces{count}",
    "(?:collide|meet|crash|touch|hit|strike|bump|run|smash|slam|catch up|impact|collision|contact|encounter"
    "|(?:bounce|rebound|spring back) (?:off|from)(?= @))"
    "(?: (?:into|with|each other|one another|against|up))*(?: (?:take place|happen|occur))?"
    "|come (?:into|in) contact|make contact": "{s} and {t} collide{count}",
    "(?:all|every one of) (?:of )?(?:the )?(?:collision|impact)s?(?: (?:over|take place|happen))?|last collision": (
        "last collision"
    ),
    # places of a path
    "(?:top|highest point|highest position|maximum height|greatest height|peak|apex|summit|zenith|maximum altitude"
    "|greatest altitude|as high as (?:it|@\\d+@) (?:get|go|come)|highest|upper turning point|highest altitude"
    "|maximum elevation)": "{s} at its highest point",
    "(?:bottom|lowest point|lowest position|as low as (?:it|@\\d+@) (?:get|go|come)|lowest|minimum height|lower"
    " turning point)": "{s} at its lowest point",
    "(?:vertically |directly |straight |exactly )?(?:below|beneath|under|underneath) (?:axle|pivot|fixed point"
    "|point of suspension|suspension point|suspension|support|trolley|hinge)|vertical(?: position| line| line| "
    "orientation)?|hang (?:straight|vertically|vertical)(?: down| downward| downwards)?|point (?:straight|vertically) "
    "(?:down|downward|downwards)": "{s} passes through vertical",
    "(?:closest|nearest)(?: approach| point| distance| position)?(?: to)?|perihelion|periapsis|pericentre|perigee"
    "|periastron"
    "|minimum distance|least distance|smallest distance": "{s} closest to {t}",
    "(?:farthest|furthest|most distant)(?: point| distance| away| out| position)?(?: from)?|aphelion|apoapsis"
    "|apocentre|apogee"
    "|apastron|maximum distance|greatest distance|largest distance": "{s} farthest from {t}",
    # springs
    "(?:(?:(?:get|go|come|return|fall|spring|swing) )?back (?:again )?(?:to|at) )?(?:its )?(?:natural|unstretched"
    "|relaxed"
    "|unstrained|undeformed|rest|own) length|relaxed|relax|unstretched|unstrained"
    "|undeformed|neither stretch nor compress|no longer (?:stretch|compress|deform)": "{s} is relaxed",
    f"{_MOST} compress|{_MOST} compression|compress {_MOST}|compress (?:the )?most|compress as far as possible"
    "|shortest|minimum length|smallest length|shortest length": "{s} most compressed",
    f"{_MOST} (?:stretch|extend|extension|elongation)|(?:stretch|extend) (?:the )?most|longest|maximum length"
    "|greatest length|longest length|(?:stretch|extend) as far as possible": "{s} most stretched",
    rf"(?:stretch|extend|extension|elongation)(?: by| of)? (?P<n>{N})|(?P<m>{N}) (?:stretch|extend|extension)"
    rf"|(?P<k>{N}) longer than (?:its )?natural length": "{s} stretched by {n}",
    rf"(?:compress|shorten|compression)(?: by| of)? (?P<n>{N})|(?P<m>{N}) (?:compress|compression)"
    rf"|(?P<k>{N}) shorter than (?:its )?natural length": "{s} compressed by {n}",
    rf"(?:length)(?: (?:of|reach|become|pass|equal))? (?P<n>{N})|(?P<m>{N}) long|(?P<k>{N}) in length": "{s} {n} long",
    "(?:(?:(?:go|become|get|fall|hang|turn) )?(?:slack|loose)|slacken)(?: again)?": "{s} goes slack",
    "(?:(?:(?:go|become|get|pull|draw) )?(?:taut|tight)|tauten|tighten)(?: again)?": "{s} becomes taut",
    "equilibrium(?: position| point)?|position of equilibrium|rest position": "{s} at its equilibrium position",
    # engines
    "(?:(?:all|last|whole|rest)(?: of)? )?(?:its )?fuel (?:supply )?(?:tank )?(?:use up|run out|go|burn(?: out|"
    " up| off)?"
    "|exhaust|consume|spend|gone|finish|end|empty|use|give out)|(?:(?:engine|motor) )?run out of fuel|(?:engine"
    "|motor|burn|thrust) "
    "(?:itself )?(?:stop|cut out|cut off|shut down|shut off|burn out|end|finish|switch off|turn off|run out|quit|cease"
    "|go out|off)(?: (?:burn|fire|work|run))?|burnout|burn-out|(?:engine )?(?:cutoff|cut-off|shutdown|shut-down)"
    "|out of fuel|(?:use|burn|consume|spend|exhaust)(?: up)? (?:all )?(?:of )?(?:its )?fuel|burn out"
    "|end of (?:the )?burn|(?:fuel )?tank (?:empty|run dry)|no fuel (?:left|leave|remain)": "burnout",
    # slipping
    "(?:(?:start|begin) (?:to )?)?(?:pure(?:ly)? )?(?:roll|rolling)(?: purely)?(?: without (?:slip|slide"
    "|skid)(?:ping)?)"
    "|(?:start|begin) (?:to )?(?:pure |purely )?roll|(?:stop|cease|end|finish|no longer) (?:slip|slide|skid)(?: and"
    " (?:start"
    "|begin|go over)(?: to)? (?:roll|rolling)(?: purely)?(?: without (?:slip|slide|skid)(?:ping)?)?)?"
    "|(?:slip|slide|skid)(?:ping)? (?:stop|cease|end|over)|pure roll(?:ing)?(?: (?:start|begin|set in))?": (
        "{s} rolls without slipping"
    ),
    f"(?:reach |attain |acquire |get )?(?:{_SAME})|{_MOVE} (?:together|as one|with {_SAME}|at {_SAME})|"
    f"(?:at |with )?{_SAME}|(?:stop|cease|end|no longer) (?:slip|slide)(?:ping|ing)? (?:on|over|along|past|against) "
    f"(?:each other|one another|{S})|move together": "they move together",
    # distances
    rf"{_MOVE}(?: {_MOVE})? {_DISTANCE}(?: (?:away )?from {HOME})?|"
    rf"{_DISTANCE.replace('<n>', '<m>')} of (?:its )?(?:path|travel|motion|way"
    rf"|slope)": ("{s} moves {n}{way}"),
    rf"(?:{_MOVE}|{FALL}|{RISE}) {_DISTANCE} (?:relative to|with respect to|along|over|across|on) (?:top of"
    rf" )?(?P<t>{S})"
    "(?: 's top)?": "{s} moves {n} relative to {t}",
    rf"(?:{_MOVE}|{FALL}|{RISE}) {_DISTANCE} (?:along|over|across|on) its top": "{s} moves {n} relative to carrier",
    rf"{FALL} {_DISTANCE}(?: from {HOME})?": "{s} falls {n}{way}",
    rf"{RISE} {_DISTANCE}(?: from {HOME})?": "{s} rises {n}{way}",
    rf"(?:{_MOVE}|{FALL}|{RISE}) {_DISTANCE}(?: <(?:down|up)>)?(?: along| on)? (?:(?:its|leave|right|sloping|incline)"
    rf" )*"
    r"(?:face|side)(?: of @\d+@)?": "{s} moves {n} relative to carrier",
    rf"{_ROLL} {_DISTANCE}": "{s} rolls {n}{way}",
    rf"{_TURN} (?:through |by )?(?:(?:an )?angle of )?(?P<n>{N})": "{s} turns through {n}",
    rf"(?P<n>{N})(?: away)? (?:from|of) {HOME}": "{s} moves {n}{way}",
    rf"(?:move |travel |go |fly )?(?P<n>{N}) horizontally": "{s} moves {n} horizontally",
    "(?:move|fly|travel|go|run|head|point)(?: (?:straight|exactly|directly|purely))?(?: (?:in|along|into))?"
    " (?P<heading>positive|negative|\\+|-|−) ?(?P<axis>[xy])[- ](?:direction|axis)": "{s} heads {heading} {axis}",
    "(?P<q>greatest|maximum|largest|maximal|highest|least|minimum|smallest|minimal|lowest) (?P<axis>[xy])(?:-| )"
    "coordinate": "{s} has {q} {axis}",
    "(?:stop|cease) (?:move|go|travel|fly|run|advance) (?:in|along) (?:positive |negative )?(?P<axis>[xy])[- ]"
    "(?:direction|axis)": "{s} turns in {axis}",
    "(?:move|fly|travel|go|run|head)(?: exactly)?(?: in direction)? parallel to (?P<axis>[xy])[- ]axis": (
        "{s} moves parallel to {axis} axis"
    ),
    "(?:pass(?: through)? |go through |swing through |in |at )(?:its )?horizontal(?: position)?": "{s} horizontal",
    "(?:velocity|direction of motion|path|flight)(?: of @\\d+@)?(?: be)? horizontal|(?:move|fly|travel|go)"
    " horizontally": ("{s} at its highest point"),
    "(?:(?:complete|make|finish|perform|do|turn|go|turn through|spin|roll)(?: through)? )?(?:its )?(?:(?:first|one"
    "|single"
    "|full|complete|whole|entire) )+(?:turn|revolution|rotation)": "{s} makes one revolution",
    rf"(?:burn|use|consume|spend)(?: up)? (?P<n>{N}) of (?:its )?fuel|(?P<m>{N}) of (?:its )?fuel (?:burn|use|consume"
    "|spend|go)(?: up)?": "{s} burns {n} of fuel",
    rf"(?P<n>{N})(?: away)? from {S}|(?:distance|separation)(?: (?:from|to|of|between) {S}(?: and {S})?)?"
    rf"(?: of| reach| become| equal| be| {_GROWS}| fall to| drop to| increase to| decrease to)? (?P<m>{N})(?: (?:from"
    rf"|to) {S})?"
    rf"|(?P<k>{N}) apart": "{s} {n} from {t}",
    rf"(?:(?:incline|inclination|tilt|slant|deflect|deflection|deviate|lean|swing out|out|displace)(?: of)? )?(?:make"
    rf" |at |reach |by |through |have |enclose |form )*(?:an )?(?:(?:angle|inclination|deflection) of )?(?P<n>{N})"
    rf" (?:with"
    rf"|from|to|off|against) (?:downward )?vertical(?: line| direction)?|(?:angle|deflection|inclination) (?:of"
    rf"|between)"
    rf" {S}(?: and vertical| (?:to|with|from) vertical)? (?:be |become |shrink to |fall to |drop to |decrease to |reach"
    rf" |grow to |increase to |equal |go down to |rise to )*(?P<m>{N})": ("{s} makes {n} with vertical"),
    # speeds and times
    rf"(?P<fall>{FALL}|{RISE}|move|go|travel)?(?: (?P<down><(?:up|down)>))? ?(?:with|at|have)? ?(?:downward |upward )?"
    rf"(?P<axis>vertical|horizontal) (?:component of )?(?:speed|velocity)(?: component)?(?: of| reach| become)?"
    rf" (?P<n>{N})": ("{s} {sense} with {axis} speed of {n}"),
    rf"(?P<axis>[xy])(?: ?= ?|(?:-| )(?:coordinate|position) (?:of |reach |become |equal"
    rf" )*)(?P<sign>[-−]?)(?P<n>{N})": ("{s} at {axis} = {sign}{n}"),
    rf"(?P<q>QUANTITY)(?: of {S})?(?: (?:of|reach|become|equal|equal to|fall to|drop to|rise to|increase to"
    rf"|decrease to|{_GROWS}))* (?P<n>{N})": "{q} of {s} equals {n}{way}",
    rf"(?:speed|velocity)(?: (?:of|reach|become|equal|equal to|fall to|drop to|rise to|increase to|decrease to"
    rf"|be|go|{_GROWS}))? (?P<n>{N})|(?:reach|attain|acquire|pick up|move at|move with|go at|travel at|have"
    rf"|achieve|gain|get"
    rf" to)"
    rf"(?: speed of| velocity of)? (?P<m>{N})": "{s} reaches speed of {n}",
    rf"(?:{_MOVE}|{FALL}|{RISE}|{_ROLL}|accelerate|burn|in motion|under way) (?:for|during) (?P<n>{N})": "t = {n}",
    rf"(?:t|time) ?= ?(?P<n>{N})|time (?P<m>{N})|(?P<k>{N})(?: (?:later|elapse|pass|go by|into (?:its )?motion"
    r"|(?:from|after|of|since|following|past)(?: (?:[a-z]+|@\d+@))?(?: both| all)? (?:START|motion)))?": "t = {n}",
    "START(?: of (?:its )?motion)?": "start",
    "(?:very )?end(?: of (?:its )?(?:motion|slide|run|movement))?": "{s} finally stops",
    "(?:stretch|extension|elongation)(?: of @\\d+@)? (?:be )?(?:greatest|maximum|largest|maximal|at its (?:maximum"
    "|greatest))": ("{s} most stretched"),
    "compression(?: of @\\d+@)? (?:be )?(?:greatest|maximum|largest|maximal|at its (?:maximum|greatest))": (
        "{s} most compressed"
    ),
    "(?:their )?(?:velocity|velocities) (?:be |become )?(?:equal|same)": "they move together",
    "(?P<q>speed|velocity|kinetic energy|acceleration) (?P<times>double|treble|triple|quadruple)|(?P<r>speed"
    "|velocity|kinetic"
    " energy|acceleration)(?: of @\\d+@)? (?:be |become "
    "|reach |rise to |grow to |increase to )*(?P<fold>twice|double|three times|four times|ten times) (?:as"
    " (?:great|large) as (?:at start|at lift-off"
    "|initially)|(?:its |that at )?(?:initial|original|start|starting)(?: value| one| speed| velocity)?|what it"
    " be (?:at start|initially))"
    "|(?P<tripled>double|treble|triple|quadruple) (?:its|@\\d+@ 's) (?P<o>speed|velocity|kinetic"
    " energy)": "{q} of {s} {times} times at first",
    f"(?:at )?level with {HOME}(?: again)?|(?:at )?same (?:height|level) (?:again )?(?:as|from which) (?:at"
    f" )?(?:START|HOME|throw)(?: again)?"
    "|(?:return|back|come back|get back|fall back|be back|again)(?: to| at| down| on)* (?:its )?(?:(?:initial"
    "|original|start|starting|launch"
    "|same|own|release) (?:height|level)|(?:height|level) (?:from|at|of) (?:which|where) (?:it|@\\d+@) (?:start"
    "|throw|release|launch"
    "|leave)|(?:height|level) of (?:throw|launch|release|projection)|launch height)(?: again)?": "{s} back at its"
    " height",
    f"(?:start(?! point| position| place)|begin|set out|set off|start off|start out)(?: to)?(?: {_MOVE})?(?: off|"
    f" out)?": "{s} sets off",
    rf"(?P<n>{N}) (?:above|over|off|from|clear of) GROUNDS|(?:at |reach )?(?:height|altitude) of (?P<m>{N})(?:"
    rf" (?:above|over)"
    rf" GROUNDS)?|(?P<k>{N}) high": "{s} at height of {n}",
    rf"{FALL} {_DROP}(?P<n>{N})(?: vertically)?|(?:vertical )?(?:drop|descent|fall) of (?P<m>{N})": (
        "{s} falls {n} vertically"
    ),
    rf"{_MOVE} {_DROP}(?P<n>{N})": "{s} moves {n} vertically{way}",
    rf"{RISE} {_DROP}(?P<n>{N})(?: vertically)?|vertical rise of (?P<m>{N})|(?P<k>{N}) higher(?: up)?(?: than(?:"
    rf" (?:at|in|from))?(?: very)? {HOME}| than (?:it|@\d+@) (?:at )?(?:start|first|beginning)| than (?:before|at"
    rf" (?:very )?(?:first|start|begin)))?": ("{s} rises {n} vertically"),
    rf"(?P<k>{N}) lower(?: down)?(?: than(?: (?:at|in|from))?(?: very)? {HOME}| than (?:at )?(?:very )?(?:first|start"
    rf"|begin))?": ("{s} falls {n} vertically"),
    "(?:cross|pass|intersect|meet|reach|hit|cut)(?: (?:through|over))? (?P<axis>[xy])(?:-| )axis": "{s} crosses"
    " {axis} axis",
    "(?:its )?(?:greatest|maximum|highest|top|peak|largest) (?:speed|velocity)|"
    "(?:move|go|travel|slide|run|swing|spin|turn|roll|rotate)(?: at)? (?:its )?(?:fast(?:est)?|(?:greatest"
    "|maximum|highest|top|peak"
    "|largest) (?:speed|velocity))|(?:fastest|(?:reach|attain|have|at|acquire|gain) (?:its )?(?:greatest|maximum"
    "|highest|top|peak"
    "|largest) (?:speed|velocity)|(?:speed|velocity)(?: of @\\d+@)? (?:greatest|maximum|highest|largest|at its"
    " (?:maximum|greatest"
    "|peak)))": "{s} fastest",
    "(?:go|become|get|turn) slack|slack": "{s} goes slack",
    "(?:go|become|get|pull) (?:taut|tight)(?: again)?|taut|tight": "{s} becomes taut",
    "(?:leave|lose contact with|lift off|detach from|lose touch with|separate from|come off|take off from|rise"
    " from|lift from)"
    " (?:@\\d+@|GROUNDS)|lift off|take off|lift-off|liftoff|takeoff|take-off": "{s} leaves surface",
    "(?:enter|come into|get into|reach) (?:electric |magnetic )?(?:field|region)(?: region)?": "{s} enters field",
    "(?:leave|exit|come out of|emerge from|get out of) (?:electric |magnetic )?(?:field|region)": "{s} leaves field",
    "(?:begin|start) (?:to )?(?:slip|slide|skid)": "{s} begins to slip",
    f"(?:return|come back|get back|go back|back|again|return again|arrive back|slide back|roll back|fall back"
    f"|move back)"
    f"(?: (?:to|at|in|through|past))? {HOME}(?: again)?|(?:pass|reach|cross|regain) (?:through )?{HOME}(?: again)?"
    f"|return|(?:come|be|get|arrive) back(?: again)?": "{s} returns",
}
"""By the base form of a clause's head, the plain clause that says the same."""
