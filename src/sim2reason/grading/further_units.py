"""Units accepted in answers beside those of the library's table: imperial and outdated ones.

Problems, scenes and exports never contain them. A pound is a mass, and a pound of force is ``lbf``; ``in`` is read as
the preposition, so inches are spelled out.
"""

from typing import Final

from sim2reason.scenes.dsl.units import Unit, parse_unit

__all__ = ["FURTHER"]

_ENTRIES: Final = (  # symbol, further spellings, size, and the unit of our table that it is in
    ("ft", "foot feet", 0.3048, "m"),
    ("inch", "inches", 0.0254, "m"),
    ("yd", "yard yards", 0.9144, "m"),
    ("mi", "mile miles", 1609.344, "m"),
    ("mph", "MPH", 0.44704, "m/s"),
    ("fps", "", 0.3048, "m/s"),
    ("knot", "knots", 1852 / 3600, "m/s"),
    ("lb", "lbs lbm pound pounds", 0.45359237, "kg"),
    ("oz", "ounce ounces", 0.028349523125, "kg"),
    ("slug", "slugs", 14.59390293720636, "kg"),
    ("lbf", "", 4.4482216152605, "N"),
    ("psi", "", 6894.757293168361, "Pa"),
    ("bar", "bars", 1e5, "Pa"),
    ("atm", "atmosphere atmospheres", 101325.0, "Pa"),
    ("cal", "calorie calories", 4.184, "J"),
    ("kcal", "kilocalorie kilocalories", 4184.0, "J"),
    ("angstrom", "angstroms Angstrom", 1e-10, "m"),
    ("cycle", "cycles oscillation oscillations vibration vibrations", 1.0, "Hz*s"),
)
FURTHER: Final[dict[str, Unit]] = {
    word: Unit(symbol, size * parse_unit(unit).factor, parse_unit(unit).dimension)
    for symbol, names, size, unit in _ENTRIES
    for word in (symbol, *names.split())
}
"""Each by all words that spell it."""
